"""A triad of a chain as its kernel takes it, and what it makes."""

import numpy as np

from cranktrain.linkage import (
    GUIDE,
    ROD,
    Leg,
    Triad,
    TriadEnds,
    fixed_guide,
    point,
    rod_between,
    rod_end,
    turned,
)
from cranktrain.mechanisms.chain.groups import Made, pin_of
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    GuideLegSize,
    GuideLegStep,
    RodLegSize,
    RodLegStep,
    Structure,
    TriadSize,
    TriadStep,
)
from cranktrain.motion import Array, Link


def triad_at(structure: Structure, place: int, size: ChainSize) -> tuple[TriadStep, TriadSize]:
    """Give the triad at a place of the chain, and its numbers."""
    step, own = structure.steps[place], size.steps[place]
    assert isinstance(step, TriadStep)
    assert isinstance(own, TriadSize)
    return step, own


def triad_ends(step: TriadStep, own: TriadSize, made: Made) -> TriadEnds:
    """Outer ends of a triad's legs."""
    return TriadEnds(*(_leg_end(leg, size, made) for leg, size in zip(step.legs, own.legs, strict=True)))


def _leg_end(leg: RodLegStep | GuideLegStep, size: RodLegSize | GuideLegSize, made: Made) -> Link:
    """Outer end of a leg: the point that its rod is on, or its guide."""
    if isinstance(leg, RodLegStep):
        return rod_end(made[leg.rod_from])
    assert isinstance(size, GuideLegSize)
    through = made[leg.through]
    return fixed_guide(through.x.value, through.y.value, size.direction)


def triad_legs(own: TriadSize) -> Triad:
    """Legs as the kernel takes them."""
    return Triad(
        *(
            Leg(leg.joint, leg.length, ROD) if isinstance(leg, RodLegSize) else Leg(leg.joint, leg.offset, GUIDE)
            for leg in own.legs
        )
    )


def place_triad(step: TriadStep, own: TriadSize, link: Link, made: Made) -> None:
    """Add what a triad makes, its link being known."""
    made[step.link] = link
    for leg, size in zip(step.legs, own.legs, strict=True):
        joint = point(link, size.joint)
        if isinstance(leg, RodLegStep):
            made[leg.joint] = joint
            made[leg.rod] = rod_between(made[leg.rod_from], joint)
        elif isinstance(size, GuideLegSize):
            made[leg.slider] = turned(joint, size.direction).x
            made[pin_of(leg.slider)] = joint


def link_size(legs: Triad) -> Array:
    """Largest radius of a joint on the link, about its origin. [m]"""
    return np.maximum.reduce([leg.point.radius for leg in legs])
