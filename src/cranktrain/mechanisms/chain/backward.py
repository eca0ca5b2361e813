"""A chain's groups solved one by one from the last: each to its joints' wrenches and the loads of what carries it."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from cranktrain.linkage import OnLine, Pin, PinMotion, Slide, Swivel, Yoke, turned, turned_link
from cranktrain.linkage.forces import (
    Friction,
    PinLoads,
    SlideLoads,
    SwivelLoads,
    TrammelLoads,
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
    turned_wrench,
    yoke_reactions,
)
from cranktrain.mechanisms.chain.joints import GUIDE, joint_name
from cranktrain.mechanisms.chain.made import pin_of
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    MountStep,
    PinSize,
    PinStep,
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
from cranktrain.mechanisms.kind import FRAME
from cranktrain.motion import Array, Link, Point, single

_NOTHING = Wrench(single(0.0), single(0.0), single(0.0))


class BackwardWalk(NamedTuple):
    """What the walk goes by, and what it fills: each link's load, each joint's wrench, each slider's friction."""

    made: dict[str, Any]
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
    walk.drags[step.slider] = -(held.line.cos * found.slider.x + held.line.sin * found.slider.y)


def _solve_yoke(step: YokeStep, own: YokeSize, walk: BackwardWalk) -> None:
    block = _block_of_yoke(walk, step, own)
    loads = YokeLoads(_NOTHING, turned_wrench(walk.loads[step.slider], own.direction))
    found = yoke_reactions(block, Yoke(own.offset, own.slot_angle), loads, walk.friction[step.slider])
    _hang(walk, step.pin, step.slider, turned_wrench(found.pin, -own.direction))
    _note_guide(walk, step.slider, found.guide, own.direction)


def _block_of_yoke(walk: BackwardWalk, step: YokeStep, own: YokeSize) -> Array:
    """Position of a yoke's block along its slot; the walk forward keeps the slider only."""
    pin, slider = (turned(walk.made[name], own.direction) for name in (step.pin, pin_of(step.slider)))
    return (pin.y.value - slider.y.value) / np.sin(own.slot_angle)


def _solve_trammel(step: TrammelStep, own: TrammelSize, walk: BackwardWalk) -> None:
    loads = TrammelLoads(_NOTHING, turned_wrench(walk.loads[step.slider], own.direction))
    link = turned_link(walk.made[step.link], own.direction)
    found = trammel_reactions(link, loads, walk.friction[step.slider])
    slot = turned_wrench(found.slot, -own.direction)
    place = pin_of(step.slider)
    walk.joints[joint_name(place, step.slider)] = slot
    _load(walk, step.link, walk.made[place], slot)
    _note_guide(walk, step.slider, found.guide, own.direction)


def _note_guide(walk: BackwardWalk, slider: str, guide: Wrench, direction: Array) -> None:
    """Note a fixed guide's reaction, and apart from it what the friction along it takes."""
    walk.joints[joint_name(GUIDE, slider)] = turned_wrench(guide, -direction)
    walk.drags[slider] = guide.x


def _solve_triad(step: TriadStep, own: TriadSize, walk: BackwardWalk) -> None:
    moving = [leg.rod if isinstance(leg, RodLegStep) else leg.slider for leg in step.legs]
    first, second, third = (walk.loads[name] for name in moving)
    ends = triad_ends(step, own, walk.made)
    loads = TriadLoads(walk.loads[step.link], first, second, third)
    found = triad_reactions(walk.made[step.link], ends, triad_legs(own), loads)
    for leg, reactions in zip(step.legs, found, strict=True):
        if isinstance(leg, RodLegStep):
            walk.joints[joint_name(leg.joint, step.link)] = reactions.joint
            _hang(walk, leg.rod_from, leg.rod, reactions.end)
        else:
            walk.joints[joint_name(pin_of(leg.slider), step.link)] = reactions.joint
            walk.joints[joint_name(GUIDE, leg.slider)] = reactions.end


def _solve_point(step: PointStep | MountStep, own: Any, walk: BackwardWalk) -> None:
    """Nothing hangs on a point but by the link that carries it."""
    del step, own, walk


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
