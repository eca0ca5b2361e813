"""How a chain is put together where its crank `main` lies along x: sides of swivels and trammels, modes of triads."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from cranktrain.linkage import Pose, triad_modes, turned_link
from cranktrain.linkage.nearest import nearest_pose
from cranktrain.linkage.triad import Triad, TriadEnds
from cranktrain.mechanisms.chain.groups import SHAFT, Made, pin_of
from cranktrain.mechanisms.chain.kinematics import chain_made
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    StartSize,
    StepSize,
    Structure,
    SwivelSize,
    SwivelStep,
    TrammelSize,
    TrammelStep,
    TriadSize,
    TriadStep,
)
from cranktrain.mechanisms.chain.triads import triad_ends, triad_legs
from cranktrain.mechanisms.chain.walks import sign_of
from cranktrain.motion import Array, single
from cranktrain.numerics.nested import each_changed
from cranktrain.numerics.ties import smallest_of

_TRIED = 12
"""Directions of a link from which one that cannot close is brought as near as it comes."""


class Mode(NamedTuple):
    """A way of putting a triad's link in place: its pose, and where its three joints then lie, shape (3, 2). [m]"""

    pose: Pose
    joints: Array


def assembled(structure: Structure, size: ChainSize, near: Mapping[str, Array]) -> ChainSize:
    """Give each group the side or the start that it has where the crank `main` lies along x.

    Parameters
    ----------
    structure : Structure
    size : ChainSize of numbers
    near : mapping of link to array, shape (3, 2)
        Where about the joints of each triad's link lie; NaN where nothing is said. [m]

    Returns
    -------
    ChainSize
        Complete; sides and starts that it had are found anew.
    """
    for place in range(len(structure.steps)):
        own = _put_together(structure, place, size, near)
        size = size._replace(steps=(*size.steps[:place], own, *size.steps[place + 1 :]))
    return size


def _put_together(structure: Structure, place: int, size: ChainSize, near: Mapping[str, Array]) -> StepSize:
    """One group's size with what it takes from those above it."""
    step, own = structure.steps[place], size.steps[place]
    match step, own:
        case SwivelStep(), SwivelSize():
            return own._replace(outside=single(_outside(structure, step, made_above(structure, place, size))))
        case TrammelStep(), TrammelSize():
            link = turned_link(made_above(structure, place, size)[step.link], own.direction)
            side = float(np.sign(link.sin))
            return own._replace(side=single(side if side != 0.0 else 1.0))
        case TriadStep(), TriadSize():
            return own._replace(start=_start(step, own, made_above(structure, place, size), near[step.link]))
        case _:
            return own


def made_above(structure: Structure, place: int, size: ChainSize) -> Made:
    """All that stands above a group, where the crank `main` lies along x."""
    with np.errstate(all="ignore"):
        made = chain_made(structure._replace(steps=structure.steps[:place]), single(0.0), size)
    return {name: each_changed(lambda array: single(np.asarray(array).item()), part) for name, part in made.items()}


def _outside(structure: Structure, step: SwivelStep, made: Made) -> float:
    """Whether a fixed pivot lies outside (+1) or inside (−1) the circle of the crank pin; 0 where neither is so."""
    if step.pin not in map(pin_of, structure.cranks) or step.pivot not in (SHAFT, *structure.fixed):
        return 0.0
    pivot, pin = (np.hypot(made[name].x.value, made[name].y.value) for name in (step.pivot, step.pin))
    return 1.0 if pivot > pin else -1.0


def modes_of(step: TriadStep, own: TriadSize, made: Made) -> list[Mode]:
    """All ways in which a triad can be put together on what stands above it."""
    ends, legs = triad_ends(step, own, made), triad_legs(own)
    if np.isnan(sum(end.origin.x.value + end.origin.y.value for end in ends)):
        return []
    poses = zip(*triad_modes(ends, legs), strict=True)
    return [_mode(legs, Pose(*map(single, map(float, pose)))) for pose in poses]


def _mode(legs: Triad, pose: Pose) -> Mode:
    return Mode(pose, joints_of(legs, pose))


def joints_of(legs: Triad, pose: Pose) -> Array:
    """Where the three joints of a triad's link lie in a pose, shape (3, 2). [m]"""
    joints = [pose.x + 1j * pose.y + leg.point.radius * np.exp(1j * (pose.angle + leg.point.angle)) for leg in legs]
    return np.array([[joint.real, joint.imag] for joint in joints])


def _start(step: TriadStep, own: TriadSize, made: Made, near: Array) -> StartSize:
    """Pose of the mode nearest to where the joints are said to be; without a mode, the one least open."""
    ends, legs = triad_ends(step, own, made), triad_legs(own)
    modes = modes_of(step, own, made)
    if not modes:
        return _least_open(ends, legs)
    best = smallest_of(modes, lambda mode: float(np.nansum((mode.joints - near) ** 2)))
    sign = sign_of(ends, legs, best.pose)
    return StartSize(*(single(float(part)) for part in (*best.pose, sign, 1.0)))


def _least_open(ends: TriadEnds, legs: Triad) -> StartSize:
    """Pose in which a link that cannot close is least open."""
    with np.errstate(all="ignore"):
        x = float(np.mean([end.origin.x.value for end in ends]))
        y = float(np.mean([end.origin.y.value for end in ends]))
        starts = (Pose(single(x), single(y), single(2 * np.pi * i / _TRIED)) for i in range(_TRIED))
        tries = [nearest_pose(ends, legs, start) for start in starts]
    best = smallest_of(tries, lambda one: float(np.nan_to_num(one.opening, nan=np.inf)))
    return StartSize(*(single(float(part)) for part in (*best.pose, 1.0, 1.0)))
