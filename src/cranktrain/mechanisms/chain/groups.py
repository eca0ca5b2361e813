"""What each group of a chain is, by names: what it makes, where it is held and where it slides, its Assur group."""

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any, NamedTuple, TypeAlias

from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    GuideLegStep,
    MountStep,
    PinStep,
    PointStep,
    RodLegStep,
    SlideStep,
    Step,
    Structure,
    SwivelStep,
    TrammelStep,
    TriadSize,
    TriadStep,
    YokeStep,
)
from cranktrain.mechanisms.dynamics import FRAME, Across, Contact, Group, Reaction, Role
from cranktrain.motion import Array, Coefficient, Link, Point

SHAFT = "O"
"""Name of the shaft's centre."""

Part: TypeAlias = Point | Link | Coefficient
"""A point, a link or a slider."""

Made: TypeAlias = dict[str, Any]
"""Each `Part` by its name, which says what it is."""

GUIDE = "guide"
"""Where a slider meets its fixed guide, in a joint's name."""


def pin_of(name: str) -> str:
    """Name of the point that a crank or a slider gives."""
    return f"{name}.pin"


def slot_of(slider: str) -> str:
    """Name of what slides in the slot that drives a slider, or that it drives."""
    return f"{slider}.slot"


def end_of(name: str) -> str:
    """Name of the point that shows how far a link or a slider's slot reaches."""
    return f"{name}.end"


def guide_of(slider: str) -> str:
    """Name of the end of a slider's fixed guide."""
    return f"{slider}.{GUIDE}"


class Product(NamedTuple):
    """What a group makes: a point, link, slider or block; of a point, the body that carries it."""

    sort: str
    carrier: str = ""


class Joint(NamedTuple):
    """Where a link is held: at a point or in its guide, by which body: unless said, by what carries the point."""

    at: str
    on: str
    by: str = ""
    role: Role = "pin"

    @property
    def name(self) -> str:
        """Name of the joint, by where it is and the link on which it acts."""
        return f"{self.at}/{self.on}"


class Anatomy(NamedTuple):
    """What a group is: what it makes, its joints, what slides in it and where; the Assur group, unless it is a point.

    A joint's pin belongs to the rod.
    """

    made: Mapping[str, Product]
    joints: tuple[Joint, ...] = ()
    contacts: Mapping[str, Contact] = {}
    sort: str = ""
    across: tuple[Across, ...] = ()

    @property
    def moving(self) -> tuple[str, ...]:
        """Names of what has mass."""
        return tuple(name for name, own in self.made.items() if own.sort in ("link", "slider"))

    @property
    def group(self) -> Group:
        """The Assur group; of a triad the legs first: the link between them bears only what they pass on."""
        links = self.moving
        return Group(self.sort, (*links[1:], links[0]) if self.sort == "triad" else links, self.across)


_LINK = Product("link")


@cache
def anatomy(step: Step | RodLegStep | GuideLegStep, link: str = "") -> Anatomy:
    """What a group is, or a leg on the link of a triad."""
    match step:
        case PinStep():
            outer = Joint(step.rod_from, step.rod), Joint(step.rocker_from, step.rocker)
            return Anatomy(
                {step.joint: Product("point", step.rod), step.rod: _LINK, step.rocker: _LINK},
                (*outer, Joint(step.joint, step.rocker, step.rod)),
                sort="RRR",
                across=tuple(Across(joint.name, joint.on, step.joint) for joint in outer),
            )
        case SlideStep():
            outer, pin = Joint(step.rod_from, step.rod), pin_of(step.slider)
            guided = _guided(step.slider)
            return Anatomy(
                {step.rod: _LINK, **guided.made},
                (outer, Joint(pin, step.slider, step.rod), *guided.joints),
                guided.contacts,
                "RRP",
                (Across(outer.name, step.rod, pin),),
            )
        case SwivelStep():
            outer = Joint(step.pin, step.slider)
            slot = Joint(step.slider, step.guide, step.slider, "slot")
            return Anatomy(
                {step.slider: Product("slider"), step.guide: _LINK},
                (outer, slot, Joint(step.pivot, step.guide)),
                {step.slider: Contact(slot.name, step.pin)},
                "RPR",
                (Across(outer.name, step.guide, step.pivot),),
            )
        case YokeStep():
            return _slotted(step.slider, Joint(step.pin, step.slider), "RPP")
        case TrammelStep():
            return _slotted(step.slider, Joint(pin_of(step.slider), step.slider, step.link, "slot"), "PRP")
        case PointStep():
            return Anatomy({step.point: Product("point", step.link)})
        case MountStep():
            return Anatomy({step.point: Product("point", step.slider)})
        case RodLegStep():
            outer = Joint(step.rod_from, step.rod)
            return Anatomy(
                {step.joint: Product("point", link), step.rod: _LINK},
                (outer, Joint(step.joint, link, step.rod)),
                across=(Across(outer.name, step.rod, step.joint),),
            )
        case GuideLegStep():
            guided = _guided(step.slider)
            return guided._replace(joints=(Joint(pin_of(step.slider), link, step.slider), *guided.joints))
        case TriadStep():
            legs = [anatomy(leg, step.link) for leg in step.legs]
            return Anatomy(
                {step.link: _LINK} | {name: own for leg in legs for name, own in leg.made.items()},
                tuple(joint for leg in legs for joint in leg.joints),
                {name: contact for leg in legs for name, contact in leg.contacts.items()},
                "triad",
                tuple(across for leg in legs for across in leg.across),
            )


def _guided(slider: str) -> Anatomy:
    """Slider in a fixed guide."""
    joint, pin = Joint(GUIDE, slider, FRAME, "guide"), pin_of(slider)
    return Anatomy(
        {slider: Product("slider"), pin: Product("point", slider)}, (joint,), {slider: Contact(joint.name, pin)}
    )


def _slotted(slider: str, held: Joint, sort: str) -> Anatomy:
    """Slider in a fixed guide, and where a block in a slot holds it."""
    guided, block = _guided(slider), slot_of(slider)
    return Anatomy(
        {**guided.made, block: Product("block")},
        (held, *guided.joints),
        {**guided.contacts, block: Contact(held.name, held.at, bears_moment=False)},
        sort,
    )


def each_part(structure: Structure, size: ChainSize) -> Iterator[tuple[Step | RodLegStep | GuideLegStep, Any]]:
    """All groups with their numbers, and before a triad its legs."""
    for step, own in zip(structure.steps, size.steps, strict=True):
        if isinstance(step, TriadStep) and isinstance(own, TriadSize):
            yield from zip(step.legs, own.legs, strict=True)
        yield step, own


def guide_directions(structure: Structure, size: ChainSize) -> dict[str, Array]:
    """Direction of each fixed guide from x, by what slides in it. [rad]"""
    return {
        part.slider: own.direction
        for part, own in each_part(structure, size)
        if isinstance(part, SlideStep | YokeStep | TrammelStep | GuideLegStep)
    }


def made_names(structure: Structure) -> tuple[str, ...]:
    """Names of all that a chain makes, in order."""
    pins = [pin_of(name) for name in structure.cranks]
    return (SHAFT, *structure.fixed, *pins, *(name for step in structure.steps for name in anatomy(step).made))


def chain_moving(structure: Structure) -> tuple[str, ...]:
    """Names of what has mass: cranks, then links and sliders in the order of the file."""
    return (*structure.cranks, *(name for step in structure.steps for name in anatomy(step).moving))


def chain_contacts(structure: Structure) -> dict[str, Contact]:
    """Where what may have friction slides: sliders in their guides, and blocks in slots, by the slider of the slot."""
    return {name: contact for step in structure.steps for name, contact in anatomy(step).contacts.items()}


def chain_reactions(structure: Structure) -> tuple[Reaction, ...]:
    """Joints of a chain: the bearing of its cranks, then each part's, named `point/link` by where and on what."""
    carriers = carriers_of(structure)
    joints = (joint for step in structure.steps for joint in anatomy(step).joints)
    parts = (Reaction(joint.name, joint.on, joint.by or carriers[joint.at], joint.role) for joint in joints)
    return (Reaction("main_bearing", structure.cranks[0], FRAME, "main_bearing"), *parts)


def carriers_of(structure: Structure) -> dict[str, str]:
    """Which body carries each point."""
    still = dict.fromkeys((SHAFT, *structure.fixed), FRAME) | {pin_of(name): name for name in structure.cranks}
    made = (item for step in structure.steps for item in anatomy(step).made.items())
    return still | {name: own.carrier for name, own in made if own.carrier}
