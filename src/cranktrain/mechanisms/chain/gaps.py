"""By how much the groups of a chain can close, at any crank angle."""

from collections.abc import Callable, Mapping
from functools import reduce

import numpy as np

from cranktrain.linkage import (
    Ends,
    Pin,
    Pose,
    Slide,
    Swivel,
    Triad,
    TriadDriver,
    TriadEnds,
    TriadMotion,
    pin_gap,
    slide_gap,
    swivel_gap,
    triad,
    turned,
    turned_link,
)
from cranktrain.linkage.vectors import between
from cranktrain.mechanisms.chain.groups import Made, pin_of
from cranktrain.mechanisms.chain.kinematics import triad_branch, triad_motion
from cranktrain.mechanisms.chain.placing import driven, guide_offset, placed
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    MountStep,
    PinStep,
    PointStep,
    SlideSize,
    SlideStep,
    Step,
    StepSize,
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
from cranktrain.mechanisms.chain.triads import link_size, place_triad, triad_at, triad_ends, triad_legs
from cranktrain.mechanisms.chain.walks import Branch, kept_side, lacking
from cranktrain.motion import Array, Link, Point, single

_TriadOf = Callable[[int, Made], tuple[Link, Array]]
"""Gives link and gap of the triad at a place of the chain, on what stands above it."""


def chain_gaps(structure: Structure, angle: Array, size: ChainSize) -> list[Array]:
    """By how much each group can close; negative where it cannot, NaN where one above it cannot. [m]"""

    def on_its_branch(place: int, made: Made) -> tuple[Link, Array]:
        step, own = triad_at(structure, place, size)
        motion = triad_motion(structure, place, angle, size, made)
        gap = _gap_of_triad(triad_branch(structure, place, size), triad_ends(step, own, made), own, motion)
        return motion.link, gap

    return _gaps(structure, angle, size, size.cranks[0].radius, on_its_branch)


def chain_gap(structure: Structure, angle: Array, size: ChainSize) -> Array:
    """By how much the group that closes least does; negative where it cannot. [m]"""
    none = np.full_like(angle + size.cranks[0].radius, np.inf)
    return reduce(np.fmin, chain_gaps(structure, angle, size), none)


def followed(
    structure: Structure, angle: Array, size: ChainSize, starts: Mapping[int, Pose]
) -> tuple[list[Array], dict[int, Pose]]:
    """By how much each group can close, for triads in poses near given ones, at any crank angle by itself.

    Parameters
    ----------
    structure : Structure
    angle : Array, shape (..., n)
        [rad]
    size : ChainSize, fields broadcastable to (..., 1)
    starts : mapping of int to Pose
        By the place of each triad among the groups. [m, rad]

    Returns
    -------
    list of Array, shape (..., n)
        Gap of each group, as of `chain_gaps`, but where they do not depend on the angle 1; of a triad the square of the
        transmission with its sign, positive on the side that is kept. NaN where a group cannot close. [m]
    dict of int to Pose, shape (..., n)
        Of each triad by its place. [m, rad]
    """
    poses: dict[int, Pose] = {}

    def near_start(place: int, made: Made) -> tuple[Link, Array]:
        step, own = triad_at(structure, place, size)
        legs = triad_legs(own)
        motion = triad(TriadDriver(triad_ends(step, own, made), starts[place]), legs)
        origin = motion.link.origin
        poses[place] = Pose(origin.x.value, origin.y.value, motion.link.angle.value)
        return motion.link, _firmness(motion, legs) * np.sign(motion.transmission) * kept_side(own.start, legs)

    return _gaps(structure, angle, size, single(1.0), near_start), poses


def _gaps(structure: Structure, angle: Array, size: ChainSize, radius: Array, triad_of: _TriadOf) -> list[Array]:
    """Gaps of all groups; radius stands for that of the crank where a gap is no length by itself."""
    made = driven(structure, angle, size)
    gaps: list[Array] = []
    for place, (step, own) in enumerate(zip(structure.steps, size.steps, strict=True)):
        if isinstance(step, TriadStep) and isinstance(own, TriadSize):
            link, gap = triad_of(place, made)
            place_triad(step, own, link, made)
        else:
            gap = _gap_of(step, own, made, radius)
            made |= placed(step, own, made)
        gaps.append(gap)
    return gaps


def _firmness(motion: TriadMotion, legs: Triad) -> Array:
    """Square of the transmission by the link's size; what is left of a length goes as this near a branch's end. [m]"""
    return motion.transmission**2 / link_size(legs)


def _gap_of_triad(branch: Branch, ends: TriadEnds, own: TriadSize, motion: TriadMotion) -> Array:
    """Square of the transmission, which must keep its sign; where the link cannot be, what one leg lacks. [m]"""
    legs = triad_legs(own)
    firmness = _firmness(motion, legs)
    is_open = np.isnan(firmness)
    if not np.any(is_open):
        return firmness
    # What is lost within a walk's last step may still close by a hair.
    return np.where(is_open, -np.maximum(lacking(branch, ends, legs, is_open), _HAIR), firmness)


_HAIR = float(np.finfo(float).tiny)


def _gap_of(step: Step, own: StepSize, made: Made, radius: Array) -> Array:
    """Gap of a group that is no triad."""
    match step, own:
        case PinStep(form="parallelogram"), _:
            return radius + 0.0 * made[step.rod_from].x.value
        case PinStep(), Pin() if step.form:
            # Crossed, or a kite, rod and rocker need no more than that their ends are apart.
            ends = between(made[step.rod_from], made[step.rocker_from])
            return np.hypot(ends.x, ends.y)
        case PinStep(), Pin():
            return pin_gap(Ends(made[step.rod_from], made[step.rocker_from]), own)
        case SlideStep(), SlideSize():
            height = guide_offset(made, step.through, own.direction, own.offset)
            return slide_gap(turned(made[step.rod_from], own.direction), Slide(own.rod_length, height, own.way))
        case SwivelStep(), SwivelSize():
            ends = Ends(made[step.pin], made[step.pivot])
            return swivel_gap(ends, Swivel(own.offset, own.way)) - _crossed(ends, own.outside)
        case YokeStep(), YokeSize():
            return radius * np.abs(np.sin(own.slot_angle)) + 0.0 * made[step.pin].x.value
        case TrammelStep(), TrammelSize():
            # Two straight lines cross wherever they are not parallel.
            return radius * own.side * turned_link(made[step.link], own.direction).sin
        case PointStep(), _:
            return radius + 0.0 * made[step.link].cos
        case MountStep(), _:
            return radius + 0.0 * made[pin_of(step.slider)].x.value
        case _:
            raise TypeError(step)


def _crossed(ends: Ends, outside: Array) -> Array:
    """How far the pivot is on the wrong side of a crank pin's circle, through which it has come. [m]"""
    nearest = _distance(ends.pivot) - _distance(ends.driver)
    return outside * (outside * np.abs(nearest) - nearest)


def _distance(moving: Point) -> Array:
    return np.hypot(moving.x.value, moving.y.value)
