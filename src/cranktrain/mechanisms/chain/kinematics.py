"""Kinematics of a chain: the groups of its structure, one after the other, each on what those above it made."""

from functools import lru_cache
from typing import NamedTuple, TypeAlias

import numpy as np

from cranktrain.linkage import TriadDriver, TriadEnds, TriadMotion, triad
from cranktrain.mechanisms.chain.groups import Made, Part
from cranktrain.mechanisms.chain.placing import driven, placed
from cranktrain.mechanisms.chain.steps import ChainSize, Structure, TriadSize, TriadStep
from cranktrain.mechanisms.chain.triads import place_triad, triad_at, triad_ends, triad_legs
from cranktrain.mechanisms.chain.walks import Branch, branch_from, start_at
from cranktrain.motion import Array, Coefficient, Link
from cranktrain.numerics.nested import leaves


class SliderChainMotion(NamedTuple):
    """All that a chain makes, in the order of `made_names`; the slider that is its output."""

    parts: tuple[Part, ...]
    slider: Coefficient


class LinkChainMotion(NamedTuple):
    """All that a chain makes, in the order of `made_names`; the link that is its output."""

    parts: tuple[Part, ...]
    rocker: Link


ChainMotion: TypeAlias = SliderChainMotion | LinkChainMotion


def chain_made(structure: Structure, angle: Array, size: ChainSize) -> Made:
    """All points, links and sliders of a chain by name; parameters as of `chain_motion`."""
    made = driven(structure, angle, size)
    for place, step in enumerate(structure.steps):
        own = size.steps[place]
        if isinstance(step, TriadStep) and isinstance(own, TriadSize):
            place_triad(step, own, triad_motion(structure, place, angle, size, made).link, made)
        else:
            made |= placed(step, own, made)
    return made


def chain_motion(structure: Structure, angle: Array, size: ChainSize) -> ChainMotion:
    """All of a chain, and its derivatives by the crank angle.

    Parameters
    ----------
    structure : Structure
    angle : Array, shape (..., n)
        Angle of the crank `main` from x. [rad]
    size : ChainSize, fields broadcastable to (..., 1)

    Returns
    -------
    ChainMotion, shape (..., n)
        NaN from the first group that cannot close on.

    Notes
    -----
    docs/theory/chain.
    """
    made = chain_made(structure, angle, size)
    parts, output = tuple(made.values()), made[structure.output]
    return LinkChainMotion(parts, output) if isinstance(output, Link) else SliderChainMotion(parts, output)


def triad_motion(structure: Structure, place: int, angle: Array, size: ChainSize, made: Made) -> TriadMotion:
    """Link of a chain's triad on its branch; the start at these angles comes first."""
    step, own = triad_at(structure, place, size)
    start = start_at(triad_branch(structure, place, size), angle)
    return triad(TriadDriver(triad_ends(step, own, made), start), triad_legs(own))


_KEPT = 32
"""Walks that are remembered: root finding asks for the same mechanisms at other angles again and again."""


class _ChainTo:
    """A chain down to one of its triads: alike where its structure and all its numbers are."""

    def __init__(self, structure: Structure, place: int, size: ChainSize) -> None:
        self.structure = structure._replace(steps=structure.steps[: place + 1])
        self.size = size._replace(steps=size.steps[: place + 1])
        self._key = (self.structure, *((np.shape(leaf), np.asarray(leaf).tobytes()) for leaf in leaves(self.size)))

    def __hash__(self) -> int:
        return hash(self._key)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _ChainTo) and self._key == other._key


def triad_branch(structure: Structure, place: int, size: ChainSize) -> Branch:
    """Branch of a chain's triad round the turn.

    Parameters
    ----------
    structure : Structure
    place : int
        Of the triad among the chain's groups.
    size : ChainSize, fields broadcastable to (..., 1)

    Returns
    -------
    Branch
        For `start_at`.
    """
    return _branch(_ChainTo(structure, place, size))


@lru_cache(maxsize=_KEPT)
def _branch(chain: _ChainTo) -> Branch:
    structure, size = chain.structure, chain.size
    step, own = triad_at(structure, -1, size)
    above, upper = structure._replace(steps=structure.steps[:-1]), size._replace(steps=size.steps[:-1])
    shape = np.broadcast_shapes((1,), *(np.shape(leaf) for leaf in leaves(size)))

    def ends(angle: Array) -> TriadEnds:
        return triad_ends(step, own, chain_made(above, angle + np.zeros(shape), upper))

    return branch_from(ends, triad_legs(own), own.start)
