"""Bodies and joints of a chain by name: what moves and what slides, which body carries a point, who acts on whom."""

from collections.abc import Iterator, Mapping

from cranktrain.mechanisms.chain.made import SHAFT, made_by, pin_of, slot_of
from cranktrain.mechanisms.chain.steps import (
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
    TriadStep,
    YokeStep,
)
from cranktrain.mechanisms.dynamics import FRAME, Across, Contact, Group, Reaction

GUIDE = "guide"
"""Where a slider meets its fixed guide, in a joint's name."""


def chain_moving(structure: Structure) -> tuple[str, ...]:
    """Names of what has mass: cranks, then links and sliders in the order of the file."""
    return (*structure.cranks, *(name for step in structure.steps for name in moving_of(step)))


def moving_of(step: Step) -> tuple[str, ...]:
    """Names of what a part adds that has mass."""
    return tuple(name for name, sort in made_by(step).items() if sort in ("link", "slider"))


def chain_sliding(structure: Structure) -> tuple[str, ...]:
    """Names of what may have friction: sliders in their guides, and blocks in slots, by the slider of the slot."""
    return tuple(name for step in structure.steps for name in _contacts_of(step))


def chain_contacts(structure: Structure) -> tuple[Contact, ...]:
    """Where these slide."""
    return tuple(contact for step in structure.steps for contact in _contacts_of(step).values())


def _contacts_of(step: Step) -> dict[str, Contact]:
    """What slides in a part, and where."""
    match step:
        case SlideStep():
            return _in_guide(step.slider)
        case SwivelStep():
            return {step.slider: Contact(joint_name(step.slider, step.guide), step.pin)}
        case YokeStep():
            slot = Contact(joint_name(step.pin, step.slider), step.pin, bears_moment=False)
            return {**_in_guide(step.slider), slot_of(step.slider): slot}
        case TrammelStep():
            slot = Contact(joint_name(pin_of(step.slider), step.slider), pin_of(step.slider), bears_moment=False)
            return {**_in_guide(step.slider), slot_of(step.slider): slot}
        case TriadStep():
            sliders = [leg.slider for leg in step.legs if isinstance(leg, GuideLegStep)]
            return {name: contact for slider in sliders for name, contact in _in_guide(slider).items()}
        case PinStep() | PointStep() | MountStep():
            return {}


def _in_guide(slider: str) -> dict[str, Contact]:
    return {slider: Contact(joint_name(GUIDE, slider), pin_of(slider))}


def chain_reactions(structure: Structure) -> tuple[Reaction, ...]:
    """Joints of a chain: the bearing of its cranks, then each part's, named `point/link` by where and on what."""
    carriers = carriers_of(structure)
    parts = (joint for step in structure.steps for joint in _joints(step, carriers))
    return (Reaction("main_bearing", structure.cranks[0], FRAME, "main_bearing"), *parts)


def chain_groups(structure: Structure) -> tuple[Group, ...]:
    """Assur groups of a chain, in the order of the file."""
    return tuple(group for step in structure.steps for group in _group(step))


def _group(step: Step) -> Iterator[Group]:
    """What a part is as a group; a point is none."""
    links = moving_of(step)
    match step:
        case PinStep():
            hung = ((step.rod_from, step.rod), (step.rocker_from, step.rocker))
            yield Group("RRR", links, tuple(Across(joint_name(*one), one[1], step.joint) for one in hung))
        case SlideStep():
            across = Across(joint_name(step.rod_from, step.rod), step.rod, pin_of(step.slider))
            yield Group("RRP", links, (across,))
        case SwivelStep():
            yield Group("RPR", links, (Across(joint_name(step.pin, step.slider), step.guide, step.pivot),))
        case YokeStep():
            yield Group("RPP", links)
        case TrammelStep():
            yield Group("PRP", links)
        case TriadStep():
            rods = [leg for leg in step.legs if isinstance(leg, RodLegStep)]
            across = tuple(Across(joint_name(leg.rod_from, leg.rod), leg.rod, leg.joint) for leg in rods)
            # The legs first: the link between them bears only what they pass on.
            yield Group("triad", (*links[1:], step.link), across)
        case PointStep() | MountStep():
            pass


def carriers_of(structure: Structure) -> dict[str, str]:
    """Which body carries each point; a joint's pin belongs to the rod."""
    carriers = dict.fromkeys((SHAFT, *structure.fixed), FRAME) | {pin_of(name): name for name in structure.cranks}
    for step in structure.steps:
        match step:
            case PinStep():
                carriers[step.joint] = step.rod
            case SlideStep() | YokeStep() | TrammelStep():
                carriers[pin_of(step.slider)] = step.slider
            case PointStep():
                carriers[step.point] = step.link
            case MountStep():
                carriers[step.point] = carriers[step.pin]
            case TriadStep():
                for leg in step.legs:
                    match leg:
                        case RodLegStep():
                            carriers[leg.joint] = step.link
                        case GuideLegStep():
                            carriers[pin_of(leg.slider)] = leg.slider
            case SwivelStep():
                pass
    return carriers


def joint_name(at: str, on: str) -> str:
    """Name of the joint at a place, or of a slider's guide, by the link on which it acts."""
    return f"{at}/{on}"


def _joints(step: Step, carriers: Mapping[str, str]) -> Iterator[Reaction]:
    """Joints that a part adds."""
    match step:
        case PinStep():
            yield Reaction(joint_name(step.rod_from, step.rod), step.rod, carriers[step.rod_from], "pin")
            yield Reaction(joint_name(step.rocker_from, step.rocker), step.rocker, carriers[step.rocker_from], "pin")
            yield Reaction(joint_name(step.joint, step.rocker), step.rocker, step.rod, "pin")
        case SlideStep():
            yield Reaction(joint_name(step.rod_from, step.rod), step.rod, carriers[step.rod_from], "pin")
            yield Reaction(joint_name(pin_of(step.slider), step.slider), step.slider, step.rod, "pin")
            yield Reaction(joint_name(GUIDE, step.slider), step.slider, FRAME, "guide")
        case SwivelStep():
            yield Reaction(joint_name(step.pin, step.slider), step.slider, carriers[step.pin], "pin")
            yield Reaction(joint_name(step.slider, step.guide), step.guide, step.slider, "slot")
            yield Reaction(joint_name(step.pivot, step.guide), step.guide, carriers[step.pivot], "pin")
        case YokeStep():
            yield Reaction(joint_name(step.pin, step.slider), step.slider, carriers[step.pin], "pin")
            yield Reaction(joint_name(GUIDE, step.slider), step.slider, FRAME, "guide")
        case TrammelStep():
            yield Reaction(joint_name(pin_of(step.slider), step.slider), step.slider, step.link, "slot")
            yield Reaction(joint_name(GUIDE, step.slider), step.slider, FRAME, "guide")
        case TriadStep():
            for leg in step.legs:
                match leg:
                    case RodLegStep():
                        yield Reaction(joint_name(leg.rod_from, leg.rod), leg.rod, carriers[leg.rod_from], "pin")
                        yield Reaction(joint_name(leg.joint, step.link), step.link, leg.rod, "pin")
                    case GuideLegStep():
                        yield Reaction(joint_name(pin_of(leg.slider), step.link), step.link, leg.slider, "pin")
                        yield Reaction(joint_name(GUIDE, leg.slider), leg.slider, FRAME, "guide")
        case PointStep() | MountStep():
            pass
