"""Forces of a chain: its groups solved from the last backward, each loading what it hangs on."""

from collections.abc import Callable, Iterator, Mapping
from functools import partial, reduce
from typing import Any, NamedTuple

import numpy as np

from cranktrain.linkage import Crank, OnLine, Pin, PinMotion, Slide, Swivel, Yoke, turned, turned_link
from cranktrain.linkage.forces import (
    Body,
    Conditions,
    Friction,
    Gravity,
    PinLoads,
    Reduced,
    SlideLoads,
    SwivelLoads,
    TrammelLoads,
    Wrench,
    YokeLoads,
    added,
    added_reduced,
    block_link,
    borne,
    crank_link,
    crank_reactions,
    handed_back,
    pin_reactions,
    reduced,
    slide_reactions,
    swivel_reactions,
    swivel_slider_link,
    torque_by_work,
    trammel_reactions,
    turned_wrench,
    yoke_reactions,
)
from cranktrain.mechanisms.chain.kinematics import SHAFT, ChainMotion, made_names, pin_of
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    PinSize,
    PinStep,
    PointStep,
    SlideSize,
    SlideStep,
    Step,
    Structure,
    SwivelSize,
    SwivelStep,
    TrammelSize,
    TrammelStep,
    YokeSize,
    YokeStep,
)
from cranktrain.mechanisms.kind import FRAME, Dynamics, Reaction
from cranktrain.mechanisms.solved import Forces
from cranktrain.motion import Array, Link, Point, single

_GUIDE = "guide"
_NOTHING = Wrench(single(0.0), single(0.0), single(0.0))


class _Walk(NamedTuple):
    """What the walk goes by, and what it fills: each link's load, each joint's wrench, each slider's friction."""

    made: Mapping[str, Any]
    links: Mapping[str, Link]
    carriers: Mapping[str, str]
    friction: Mapping[str, Friction]
    loads: dict[str, Wrench]
    joints: dict[str, Wrench]
    drags: dict[str, Array]


def chain_moving(structure: Structure) -> tuple[str, ...]:
    """Names of what has mass: cranks, then links and sliders in the order of the file."""
    return (*structure.cranks, *(name for step in structure.steps for name in _moving(step)))


def _moving(step: Step) -> tuple[str, ...]:
    match step:
        case PinStep():
            return step.rod, step.rocker
        case SlideStep():
            return step.rod, step.slider
        case SwivelStep():
            return step.slider, step.guide
        case YokeStep() | TrammelStep():
            return (step.slider,)
        case PointStep():
            return ()


def chain_sliding(structure: Structure) -> tuple[str, ...]:
    """Names of the sliders."""
    return tuple(step.slider for step in structure.steps if not isinstance(step, PinStep | PointStep))


def chain_reactions(structure: Structure) -> tuple[Reaction, ...]:
    """Joints of a chain: the bearing of its cranks, then each part's, named `point/link` by where and on what."""
    carriers = _carriers(structure)
    parts = (joint for step in structure.steps for joint in _joints(step, carriers))
    return (Reaction("main_bearing", structure.cranks[0], FRAME), *parts)


def _carriers(structure: Structure) -> dict[str, str]:
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
            case SwivelStep():
                pass
    return carriers


def _joint(at: str, on: str) -> str:
    return f"{at}/{on}"


def _joints(step: Step, carriers: Mapping[str, str]) -> Iterator[Reaction]:
    """Joints that a part adds."""
    match step:
        case PinStep():
            yield Reaction(_joint(step.rod_from, step.rod), step.rod, carriers[step.rod_from])
            yield Reaction(_joint(step.rocker_from, step.rocker), step.rocker, carriers[step.rocker_from])
            yield Reaction(_joint(step.joint, step.rocker), step.rocker, step.rod)
        case SlideStep():
            yield Reaction(_joint(step.rod_from, step.rod), step.rod, carriers[step.rod_from])
            yield Reaction(_joint(pin_of(step.slider), step.slider), step.slider, step.rod)
            yield Reaction(_joint(_GUIDE, step.slider), step.slider, FRAME)
        case SwivelStep():
            yield Reaction(_joint(step.pin, step.slider), step.slider, carriers[step.pin])
            yield Reaction(_joint(step.slider, step.guide), step.guide, step.slider)
            yield Reaction(_joint(step.pivot, step.guide), step.guide, carriers[step.pivot])
        case YokeStep():
            yield Reaction(_joint(step.pin, step.slider), step.slider, carriers[step.pin])
            yield Reaction(_joint(_GUIDE, step.slider), step.slider, FRAME)
        case TrammelStep():
            yield Reaction(_joint(pin_of(step.slider), step.slider), step.slider, step.link)
            yield Reaction(_joint(_GUIDE, step.slider), step.slider, FRAME)
        case PointStep():
            pass


def chain_links(structure: Structure, motion: ChainMotion, size: ChainSize) -> dict[str, Link]:
    """All that has mass as links in the file's axes, in the order of `chain_moving`."""
    made = _made(structure, motion)
    links = {
        name: crank_link(made[pin_of(name)], Crank(own.radius))
        for name, own in zip(structure.cranks, size.cranks, strict=True)
    }
    for step, own in zip(structure.steps, size.steps, strict=True):
        for name in _moving(step):
            links[name] = _link(step, own, name, made)
    return links


def _in_order(structure: Structure, motion: ChainMotion, size: ChainSize) -> tuple[Link, ...]:
    """What moves, as links, without their names."""
    return tuple(chain_links(structure, motion, size).values())


def _made(structure: Structure, motion: ChainMotion) -> dict[str, Any]:
    return dict(zip(made_names(structure), motion.parts, strict=True))


def _link(step: Step, own: Any, name: str, made: Mapping[str, Any]) -> Link:
    if isinstance(made[name], Link):
        return made[name]
    if isinstance(step, SwivelStep):
        return swivel_slider_link(made[step.pin], made[step.guide])
    return block_link(made[pin_of(name)], own.direction)


def chain_load(structure: Structure, motion: ChainMotion, size: ChainSize, value: Array) -> tuple[Wrench, ...]:
    """Loads for a force along the output slider's coordinate or a torque on the output link. [N or N·m]

    A slider in a guide that swings counts along it: the guide gets the opposite force.
    """
    made = _made(structure, motion)
    links = chain_links(structure, motion, size)
    output = links[structure.output]
    zero = 0.0 * (value + output.cos)
    loads = dict.fromkeys(links, Wrench(zero, zero, zero))
    if isinstance(made[structure.output], Link):
        loads[structure.output] = Wrench(zero, zero, zero + value)
        return tuple(loads.values())
    force = Wrench(value * output.cos, value * output.sin, zero)
    loads[structure.output] = force
    for step, own in zip(structure.steps, size.steps, strict=True):
        if isinstance(step, SwivelStep) and isinstance(own, SwivelSize) and step.slider == structure.output:
            loads[step.guide] = Wrench(-force.x, -force.y, own.offset * value + zero)
    return tuple(loads.values())


def chain_forces(
    structure: Structure,
    motion: ChainMotion,
    size: ChainSize,
    bodies: tuple[Body, ...],
    loads: tuple[Wrench, ...],
    conditions: Conditions,
) -> Forces[tuple[Wrench, ...]]:
    """All forces of a chain.

    Parameters
    ----------
    structure : Structure
    motion : ChainMotion, shape (..., n)
    size : ChainSize, fields broadcastable to (..., 1)
    bodies : tuple of Body
        In the order of `chain_moving`. A yoke's block and a trammel's have no mass.
    loads : tuple of Wrench, shape (..., n)
        In that order, each about the link's first pin: a crank's the shaft's centre, a slider's its pin.
    conditions : Conditions
        Gravity in the file's axes; friction in the order of `chain_sliding`.

    Returns
    -------
    Forces, shape (..., n)
        Joints in the order of `chain_reactions`, in the file's axes; a guide's are along it and to its left.

    Notes
    -----
    Assur's order: the last group bears only its own loads; solved, it hands its reactions to the links that carry it,
    and so on to the cranks. docs/theory/forces, eq. (13.3).
    """
    made = _made(structure, motion)
    links = chain_links(structure, motion, size)
    carried = zip(links.items(), bodies, loads, strict=True)
    walk = _Walk(
        made,
        links,
        _carriers(structure),
        dict(zip(chain_sliding(structure), conditions.friction, strict=True)),
        {name: borne(link, body, load, conditions) for (name, link), body, load in carried},
        {},
        {},
    )
    for step, own in reversed(tuple(zip(structure.steps, size.steps, strict=True))):
        _SOLVED[type(step)](step, own, walk)
    shaft = crank_reactions(reduce(added, (walk.loads[name] for name in structure.cranks)))
    walk.joints["main_bearing"] = shaft.bearing
    by_work = torque_by_work(
        chain_reduced(structure, motion, size, bodies, loads, conditions.gravity), conditions.drive
    )
    for slider, drag in walk.drags.items():
        by_work = by_work - drag * made[slider].first
    joints = tuple(walk.joints[reaction.name] for reaction in chain_reactions(structure))
    return Forces(joints, shaft.driving_torque, by_work)


def _together(*bodies: Body) -> tuple[Body, ...]:
    """Bodies as `chain_forces` takes them."""
    return bodies


def chain_reduced(
    structure: Structure,
    motion: ChainMotion,
    size: ChainSize,
    bodies: tuple[Body, ...],
    loads: tuple[Wrench, ...],
    gravity: Gravity,
) -> Reduced:
    """Reduced inertia, its derivative, and the torque of loads and weights on the crank; parameters as of the forces.

    Without friction, which depends on how the crank turns. docs/theory/forces, eqs. (13.4) and (13.6).
    """
    links = _in_order(structure, motion, size)
    shares = (reduced(*each, gravity) for each in zip(links, bodies, loads, strict=True))
    return reduce(added_reduced, shares)


def _hang(walk: _Walk, at: str, on: str, reaction: Wrench) -> None:
    """Note the reaction of what carries a point on a link there, and load what carries it."""
    walk.joints[_joint(at, on)] = reaction
    _load(walk, walk.carriers[at], walk.made[at], reaction)


def _load(walk: _Walk, carrier: str, place: Point, reaction: Wrench) -> None:
    if carrier != FRAME:
        back = handed_back(walk.links[carrier], place, reaction)
        walk.loads[carrier] = added(walk.loads[carrier], back)


def _solve_pin(step: PinStep, own: PinSize, walk: _Walk) -> None:
    motion = PinMotion(walk.made[step.joint], walk.made[step.rod], walk.made[step.rocker])
    found = pin_reactions(motion, Pin(*own), PinLoads(walk.loads[step.rod], walk.loads[step.rocker]))
    _hang(walk, step.rod_from, step.rod, found.rod)
    _hang(walk, step.rocker_from, step.rocker, found.rocker)
    walk.joints[_joint(step.joint, step.rocker)] = found.joint


def _solve_slide(step: SlideStep, own: SlideSize, walk: _Walk) -> None:
    loads = SlideLoads(*(turned_wrench(walk.loads[name], own.direction) for name in (step.rod, step.slider)))
    rod = turned_link(walk.made[step.rod], own.direction)
    found = slide_reactions(rod, Slide(own.rod_length, own.offset, own.way), loads, walk.friction[step.slider])
    _hang(walk, step.rod_from, step.rod, turned_wrench(found.pin, -own.direction))
    walk.joints[_joint(pin_of(step.slider), step.slider)] = turned_wrench(found.joint, -own.direction)
    _note_guide(walk, step.slider, found.guide, own.direction)


def _solve_swivel(step: SwivelStep, own: SwivelSize, walk: _Walk) -> None:
    held = OnLine(walk.made[step.guide], walk.made[step.pin])
    loads = SwivelLoads(walk.loads[step.slider], walk.loads[step.guide])
    found = swivel_reactions(held, Swivel(*own), loads, walk.friction[step.slider])
    _hang(walk, step.pin, step.slider, found.pin)
    _hang(walk, step.pivot, step.guide, found.pivot)
    walk.joints[_joint(step.slider, step.guide)] = found.slider
    walk.drags[step.slider] = -(held.line.cos * found.slider.x + held.line.sin * found.slider.y)


def _solve_yoke(step: YokeStep, own: YokeSize, walk: _Walk) -> None:
    block = _block_of_yoke(walk, step, own)
    loads = YokeLoads(_NOTHING, turned_wrench(walk.loads[step.slider], own.direction))
    found = yoke_reactions(block, Yoke(own.offset, own.slot_angle), loads, walk.friction[step.slider])
    _hang(walk, step.pin, step.slider, turned_wrench(found.pin, -own.direction))
    _note_guide(walk, step.slider, found.guide, own.direction)


def _block_of_yoke(walk: _Walk, step: YokeStep, own: YokeSize) -> Array:
    """Position of a yoke's block along its slot; the walk forward keeps the slider only."""
    pin, slider = (turned(walk.made[name], own.direction) for name in (step.pin, pin_of(step.slider)))
    return (pin.y.value - slider.y.value) / np.sin(own.slot_angle)


def _solve_trammel(step: TrammelStep, own: TrammelSize, walk: _Walk) -> None:
    loads = TrammelLoads(_NOTHING, turned_wrench(walk.loads[step.slider], own.direction))
    link = turned_link(walk.made[step.link], own.direction)
    found = trammel_reactions(link, loads, walk.friction[step.slider])
    slot = turned_wrench(found.slot, -own.direction)
    place = pin_of(step.slider)
    walk.joints[_joint(place, step.slider)] = slot
    _load(walk, step.link, walk.made[place], slot)
    _note_guide(walk, step.slider, found.guide, own.direction)


def _note_guide(walk: _Walk, slider: str, guide: Wrench, direction: Array) -> None:
    """Note a fixed guide's reaction, and apart from it what the friction along it takes."""
    walk.joints[_joint(_GUIDE, slider)] = turned_wrench(guide, -direction)
    walk.drags[slider] = guide.x


def _solve_point(step: PointStep, own: Any, walk: _Walk) -> None:
    """Nothing hangs on a point but by the link that carries it."""
    del step, own, walk


_SOLVED: Mapping[type, Callable[[Any, Any, _Walk], None]] = {
    PinStep: _solve_pin,
    SlideStep: _solve_slide,
    SwivelStep: _solve_swivel,
    YokeStep: _solve_yoke,
    TrammelStep: _solve_trammel,
    PointStep: _solve_point,
}
"""How each group is solved: from its links' loads to its joints and the loads of what carries it."""


def chain_dynamics(structure: Structure) -> Dynamics:
    """What forces a chain gives."""
    return Dynamics(
        _together,
        chain_moving(structure),
        chain_reactions(structure),
        chain_sliding(structure),
        partial(_in_order, structure),
        partial(chain_load, structure),
        partial(chain_forces, structure),
        partial(chain_reduced, structure),
    )
