"""A chain's groups, each solved by itself: from what its links bear to the wrenches in its joints."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from cranktrain.linkage import OnLine, Pin, PinMotion, Slide, Swivel, Yoke, turned_link
from cranktrain.linkage.forces import (
    NO_FRICTION,
    NOTHING,
    CrossingFriction,
    CrossingLoads,
    Friction,
    PinLoads,
    SlideLoads,
    SwivelLoads,
    TriadFriction,
    TriadLoads,
    Wrench,
    pin_reactions,
    slide_reactions,
    swivel_reactions,
    trammel_reactions,
    triad_reactions,
    triad_reactions_with_friction,
    turned_wrench,
    yoke_reactions,
)
from cranktrain.mechanisms.chain.groups import Made, slot_of
from cranktrain.mechanisms.chain.steps import (
    PinStep,
    RodLegStep,
    SlideSize,
    SlideStep,
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
from cranktrain.motion import ZERO, Array


class Acting(NamedTuple):
    """What groups are solved with: all that the chain makes, what each link bears, friction of what slides."""

    made: Made
    loads: Mapping[str, Wrench]
    friction: Mapping[str, Friction]


class Solved(NamedTuple):
    """Wrenches in a group's joints, in the file's axes; friction along what slides; both in the order of `Anatomy`."""

    joints: tuple[Wrench, ...]
    drags: tuple[Array, ...] = ()


def _solve_pin(step: PinStep, own: Pin, acting: Acting) -> Solved:
    motion = PinMotion(acting.made[step.joint], acting.made[step.rod], acting.made[step.rocker])
    found = pin_reactions(motion, own, PinLoads(acting.loads[step.rod], acting.loads[step.rocker]))
    return Solved((found.rod, found.rocker, found.joint))


def _solve_slide(step: SlideStep, own: SlideSize, acting: Acting) -> Solved:
    loads = SlideLoads(*(turned_wrench(acting.loads[name], own.direction) for name in (step.rod, step.slider)))
    rod = turned_link(acting.made[step.rod], own.direction)
    found = slide_reactions(rod, Slide(own.rod_length, own.offset, own.way), loads, acting.friction[step.slider])
    return _in_file(found, own.direction, found.guide.x)


def _solve_swivel(step: SwivelStep, own: SwivelSize, acting: Acting) -> Solved:
    held = OnLine(acting.made[step.guide], acting.made[step.pin])
    loads = SwivelLoads(acting.loads[step.slider], acting.loads[step.guide])
    found = swivel_reactions(held, Swivel(own.offset, own.way), loads, acting.friction[step.slider])
    return Solved(found, (-_along(found.slider, held.line.cos, held.line.sin),))


def _solve_yoke(step: YokeStep, own: YokeSize, acting: Acting) -> Solved:
    block = acting.made[slot_of(step.slider)].value
    loads = CrossingLoads(NOTHING, turned_wrench(acting.loads[step.slider], own.direction))
    found = yoke_reactions(block, Yoke(own.offset, own.slot_angle), loads, _crossing(acting, step.slider))
    rubbing = -_along(found.slider, np.cos(own.slot_angle), np.sin(own.slot_angle))
    return _in_file((found.block, found.guide), own.direction, found.guide.x, rubbing)


def _solve_trammel(step: TrammelStep, own: TrammelSize, acting: Acting) -> Solved:
    loads = CrossingLoads(NOTHING, turned_wrench(acting.loads[step.slider], own.direction))
    link = turned_link(acting.made[step.link], own.direction)
    found = trammel_reactions(link, loads, _crossing(acting, step.slider))
    return _in_file((found.block, found.guide), own.direction, found.guide.x, _along(found.block, link.cos, link.sin))


def _crossing(acting: Acting, slider: str) -> CrossingFriction:
    return CrossingFriction(acting.friction[slider], acting.friction[slot_of(slider)])


def _along(wrench: Wrench, cos: Array, sin: Array) -> Array:
    return cos * wrench.x + sin * wrench.y


def _in_file(joints: tuple[Wrench, ...], direction: Array, *drags: Array) -> Solved:
    """Solved in the axes of a guide of that direction."""
    return Solved(tuple(turned_wrench(joint, -direction) for joint in joints), drags)


def _solve_triad(step: TriadStep, own: TriadSize, acting: Acting) -> Solved:
    moving = [leg.rod if isinstance(leg, RodLegStep) else leg.slider for leg in step.legs]
    first, second, third = (acting.loads[name] for name in moving)
    ends = triad_ends(step, own, acting.made)
    loads = TriadLoads(acting.loads[step.link], first, second, third)
    friction = TriadFriction(*(acting.friction.get(name, NO_FRICTION) for name in moving))
    given = acting.made[step.link], ends, triad_legs(own), loads
    has_friction = any(np.any(part.coefficient) for part in friction)
    found = triad_reactions_with_friction(*given, friction) if has_friction else triad_reactions(*given)
    joints: list[Wrench] = []
    drags: list[Array] = []
    for leg, end, reactions in zip(step.legs, ends, found, strict=True):
        if isinstance(leg, RodLegStep):
            joints += [reactions.end, reactions.joint]
        else:
            joints += [reactions.joint, reactions.end]
            drags.append(_along(reactions.end, end.cos, end.sin) if has_friction else ZERO)
    return Solved(tuple(joints), tuple(drags))


SOLVED: Mapping[type, Callable[[Any, Any, Acting], Solved]] = {
    PinStep: _solve_pin,
    SlideStep: _solve_slide,
    SwivelStep: _solve_swivel,
    YokeStep: _solve_yoke,
    TrammelStep: _solve_trammel,
    TriadStep: _solve_triad,
}
"""How each group is solved; nothing hangs on a point but by the link that carries it."""
