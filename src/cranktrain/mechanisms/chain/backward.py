"""A chain's groups solved one by one from the last: each to its joints' wrenches and the loads of what carries it."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from cranktrain.linkage import OnLine, Pin, PinMotion, Slide, Swivel, Yoke, turned_link
from cranktrain.linkage.forces import (
    NO_FRICTION,
    NOTHING,
    CrossingFriction,
    Friction,
    PinLoads,
    SlideLoads,
    SwivelLoads,
    TrammelLoads,
    TriadFriction,
    TriadLoads,
    Wrench,
    YokeLoads,
    added,
    handed_back,
    pin_reactions,
    slide_reactions,
    swivel_reactions,
    trammel_reactions,
    triad_reactions,
    triad_reactions_with_friction,
    turned_wrench,
    yoke_reactions,
)
from cranktrain.mechanisms.chain.joints import GUIDE, joint_name
from cranktrain.mechanisms.chain.made import Made, pin_of, slot_of
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    MountStep,
    PinSize,
    PinStep,
    PointSize,
    PointStep,
    RodLegStep,
    SlideSize,
    SlideStep,
    Structure,
    SwivelSize,
    SwivelStep,
    TrammelSize,
    TrammelStep,
    TriadSize,
    TriadStep,
    YokeSize,
    YokeStep,
)
from cranktrain.mechanisms.chain.triads import triad_ends, triad_legs
from cranktrain.mechanisms.dynamics import FRAME
from cranktrain.motion import Array, Link, Point


class BackwardWalk(NamedTuple):
    """What the walk goes by, and what it fills: links' loads, joints' wrenches, friction of sliders and blocks."""

    made: Made
    links: Mapping[str, Link]
    carriers: Mapping[str, str]
    friction: Mapping[str, Friction]
    loads: dict[str, Wrench]
    joints: dict[str, Wrench]
    drags: dict[str, Array]


def walk_backward(structure: Structure, size: ChainSize, walk: BackwardWalk) -> None:
    """Fill the walk's joints and drags, and load its cranks with all that hangs on them."""
    for step, own in reversed(tuple(zip(structure.steps, size.steps, strict=True))):
        _SOLVED[type(step)](step, own, walk)


def _hang(walk: BackwardWalk, at: str, on: str, reaction: Wrench) -> None:
    """Note the reaction of what carries a point on a link there, and load what carries it."""
    walk.joints[joint_name(at, on)] = reaction
    _load(walk, walk.carriers[at], walk.made[at], reaction)


def _load(walk: BackwardWalk, carrier: str, place: Point, reaction: Wrench) -> None:
    if carrier != FRAME:
        back = handed_back(walk.links[carrier], place, reaction)
        walk.loads[carrier] = added(walk.loads[carrier], back)


def _solve_pin(step: PinStep, own: PinSize, walk: BackwardWalk) -> None:
    motion = PinMotion(walk.made[step.joint], walk.made[step.rod], walk.made[step.rocker])
    found = pin_reactions(motion, Pin(*own), PinLoads(walk.loads[step.rod], walk.loads[step.rocker]))
    _hang(walk, step.rod_from, step.rod, found.rod)
    _hang(walk, step.rocker_from, step.rocker, found.rocker)
    walk.joints[joint_name(step.joint, step.rocker)] = found.joint


def _solve_slide(step: SlideStep, own: SlideSize, walk: BackwardWalk) -> None:
    loads = SlideLoads(*(turned_wrench(walk.loads[name], own.direction) for name in (step.rod, step.slider)))
    rod = turned_link(walk.made[step.rod], own.direction)
    found = slide_reactions(rod, Slide(own.rod_length, own.offset, own.way), loads, walk.friction[step.slider])
    _hang(walk, step.rod_from, step.rod, turned_wrench(found.pin, -own.direction))
    walk.joints[joint_name(pin_of(step.slider), step.slider)] = turned_wrench(found.joint, -own.direction)
    _note_guide(walk, step.slider, found.guide, own.direction)


def _solve_swivel(step: SwivelStep, own: SwivelSize, walk: BackwardWalk) -> None:
    held = OnLine(walk.made[step.guide], walk.made[step.pin])
    loads = SwivelLoads(walk.loads[step.slider], walk.loads[step.guide])
    found = swivel_reactions(held, Swivel(own.offset, own.way), loads, walk.friction[step.slider])
    _hang(walk, step.pin, step.slider, found.pin)
    _hang(walk, step.pivot, step.guide, found.pivot)
    walk.joints[joint_name(step.slider, step.guide)] = found.slider
    walk.drags[step.slider] = -_along(found.slider, held.line.cos, held.line.sin)


def _solve_yoke(step: YokeStep, own: YokeSize, walk: BackwardWalk) -> None:
    block = walk.made[slot_of(step.slider)].value
    loads = YokeLoads(NOTHING, turned_wrench(walk.loads[step.slider], own.direction))
    found = yoke_reactions(block, Yoke(own.offset, own.slot_angle), loads, _crossing(walk, step.slider))
    _hang(walk, step.pin, step.slider, turned_wrench(found.pin, -own.direction))
    _note_guide(walk, step.slider, found.guide, own.direction)
    walk.drags[slot_of(step.slider)] = -_along(found.slot, np.cos(own.slot_angle), np.sin(own.slot_angle))


def _crossing(walk: BackwardWalk, slider: str) -> CrossingFriction:
    return CrossingFriction(walk.friction[slider], walk.friction[slot_of(slider)])


def _along(wrench: Wrench, cos: Array, sin: Array) -> Array:
    return cos * wrench.x + sin * wrench.y


def _solve_trammel(step: TrammelStep, own: TrammelSize, walk: BackwardWalk) -> None:
    loads = TrammelLoads(NOTHING, turned_wrench(walk.loads[step.slider], own.direction))
    link = turned_link(walk.made[step.link], own.direction)
    found = trammel_reactions(link, loads, _crossing(walk, step.slider))
    slot = turned_wrench(found.slot, -own.direction)
    place = pin_of(step.slider)
    walk.joints[joint_name(place, step.slider)] = slot
    _load(walk, step.link, walk.made[place], slot)
    _note_guide(walk, step.slider, found.guide, own.direction)
    walk.drags[slot_of(step.slider)] = _along(found.slot, link.cos, link.sin)


def _note_guide(walk: BackwardWalk, slider: str, guide: Wrench, direction: Array) -> None:
    """Note a fixed guide's reaction, and apart from it what the friction along it takes."""
    walk.joints[joint_name(GUIDE, slider)] = turned_wrench(guide, -direction)
    walk.drags[slider] = guide.x


def _solve_triad(step: TriadStep, own: TriadSize, walk: BackwardWalk) -> None:
    moving = [leg.rod if isinstance(leg, RodLegStep) else leg.slider for leg in step.legs]
    first, second, third = (walk.loads[name] for name in moving)
    ends = triad_ends(step, own, walk.made)
    loads = TriadLoads(walk.loads[step.link], first, second, third)
    friction = TriadFriction(*(walk.friction.get(name, NO_FRICTION) for name in moving))
    acting = walk.made[step.link], ends, triad_legs(own), loads
    has_friction = any(np.any(part.coefficient) for part in friction)
    found = triad_reactions_with_friction(*acting, friction) if has_friction else triad_reactions(*acting)
    for leg, end, reactions in zip(step.legs, ends, found, strict=True):
        if isinstance(leg, RodLegStep):
            walk.joints[joint_name(leg.joint, step.link)] = reactions.joint
            _hang(walk, leg.rod_from, leg.rod, reactions.end)
        else:
            walk.joints[joint_name(pin_of(leg.slider), step.link)] = reactions.joint
            walk.joints[joint_name(GUIDE, leg.slider)] = reactions.end
            if has_friction:
                walk.drags[leg.slider] = _along(reactions.end, end.cos, end.sin)


def _solve_point(_step: PointStep | MountStep, _own: PointSize, _walk: BackwardWalk) -> None:
    """Nothing hangs on a point but by the link that carries it."""


_SOLVED: Mapping[type, Callable[[Any, Any, BackwardWalk], None]] = {
    PinStep: _solve_pin,
    SlideStep: _solve_slide,
    SwivelStep: _solve_swivel,
    YokeStep: _solve_yoke,
    TrammelStep: _solve_trammel,
    TriadStep: _solve_triad,
    PointStep: _solve_point,
    MountStep: _solve_point,
}
"""How each group is solved: from its links' loads to its joints and the loads of what carries it."""
