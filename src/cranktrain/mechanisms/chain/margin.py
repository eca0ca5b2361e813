"""Closing margin of a chain with triads: its lengths are changed in steps at each crank angle, its poses followed."""

from collections.abc import Callable, Sequence
from typing import Generic, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.linkage import Pose
from cranktrain.mechanisms.chain.gaps import followed
from cranktrain.mechanisms.chain.kinematics import triad_branch
from cranktrain.mechanisms.chain.steps import ChainSize, Structure, TriadStep
from cranktrain.mechanisms.chain.triads import link_size, triad_at, triad_legs
from cranktrain.mechanisms.chain.walks import start_at
from cranktrain.mechanisms.closing import Openings, Way, changed
from cranktrain.mechanisms.kind import Geometry, rows
from cranktrain.motion import Array, chosen
from cranktrain.numerics import turn_grid
from cranktrain.numerics.nested import leaves

_GRID = turn_grid(72)
_FIRST_STEP, _SMALLEST_STEP, _MOST_CHANGE = 1e-2, 1e-13, 1e3
_MOST_STEPS = 200
_SHARE = 0.6  # of what seems to be left until a group opens, for the next step
_MOST_MISSED = 0.05  # by a step's prediction, in parts of the link's size: modes lie farther apart
_NEAR = 0.15
"""Part of the change that may be left when the steps end; all that then seems to open within the double is refined."""
_WHOLE = 1 - 1e-9
_CLOSER = 0.9  # of what is left, on the way to a root: the links still close there
_FINER = np.sqrt(1 - _CLOSER)
"""By how much the angles looked at draw together meanwhile: the gap's rise beside its least keeps to what is left."""
_MOST_REFINEMENTS = 30
_SETTLED = 1e-7
"""Part of the change that is left when its root is told, which the secant does to about the square of that."""


class _Chains(NamedTuple, Generic[Geometry]):
    """Chains of one structure of which one length each is changed."""

    structure: Structure
    lengths: Sequence[str]
    size_of: Callable[[Geometry], ChainSize]
    geometry: Geometry
    way: Way


class _State(NamedTuple):
    """Change so far, (..., 1); gaps (group, ..., n), poses (triad, 3, ..., n)."""

    change: Array
    gaps: Array
    poses: Array


def chain_openings(
    structure: Structure, lengths: Sequence[str], size_of: Callable[[Geometry], ChainSize], geometry: Geometry
) -> Openings:
    """Find the least changes of one length at which a chain with triads opens.

    Parameters
    ----------
    structure : Structure
    lengths : sequence of str
        Dotted names of the lengths among the geometry's parts.
    size_of : callable (geometry) → ChainSize
    geometry : NamedTuple of arrays, shape (row, 1)
        Of chains whose crank turns.

    Returns
    -------
    Openings
        The least of each row, and others; none of a row that no change opens.

    Notes
    -----
    As long as no group opens at any crank angle, the chain goes at each of them continuously from its pose before the
    change to that after it. So nothing is walked round the turn but the chain as it is, and the first change at which
    a gap becomes zero at one angle is the margin; docs/theory/closing-margin, eq. (5.5).
    """
    row = np.arange(len(leaves(geometry)[0]))
    ways = Way(np.repeat(np.arange(len(lengths)), 2)[:, np.newaxis], np.tile([[-1.0], [1.0]], (len(lengths), 1)))
    chains = _Chains(structure, lengths, size_of, rows(geometry, row[:, np.newaxis]), ways)
    before, last = _nearly_open(chains, _poses(structure, size_of(geometry), len(ways.sign)))
    group, row, way, place = np.nonzero(_is_rival(chains, before, last))
    one_way = Way(ways.length[way], ways.sign[way])
    rivals = chains._replace(geometry=rows(geometry, row), way=one_way)
    gap = before.gaps[group, row, way, place][:, np.newaxis]
    poses = last.poses[:, :, row, way, place][..., np.newaxis]
    change, angle = _refined(
        rivals, group, _GRID[place][:, np.newaxis], (before.change[row, 0], gap), last.change[row, 0], poses
    )
    opens = _leaves_something(one_way.sign, change)[:, 0]
    return Openings(row[opens], one_way.length[opens, 0], change[opens, 0], angle[opens, 0])


def _triads(structure: Structure) -> list[int]:
    """Places of the triads."""
    return [place for place, step in enumerate(structure.steps) if isinstance(step, TriadStep)]


def _poses(structure: Structure, size: ChainSize, n_ways: int) -> Array:
    """Poses of the triads' links before any change, on the grid: (triad, 3, row, way, n)."""
    starts = [start_at(triad_branch(structure, place, size), _GRID) for place in _triads(structure)]
    return np.repeat(np.array([list(start) for start in starts])[:, :, :, np.newaxis], n_ways, axis=3)


def _at(chains: _Chains[Geometry], angle: Array, change: Array, starts: Array) -> _State:
    """Change the lengths, and find gaps, and poses near those given."""
    size = chains.size_of(changed(chains.lengths, chains.geometry, chains.way, change))
    triads, shape = _triads(chains.structure), starts.shape[2:]
    near = {place: Pose(*start) for place, start in zip(triads, starts, strict=True)}
    gaps, poses = followed(chains.structure, angle, size, near)
    x, y, direction = np.array([list(poses[place]) for place in triads]).swapaxes(0, 1)
    direction = starts[:, 2] + np.remainder(direction - starts[:, 2] + np.pi, 2 * np.pi) - np.pi
    return _State(change, np.array([np.broadcast_to(gap, shape) for gap in gaps]), np.stack([x, y, direction], axis=1))


def _nearly_open(chains: _Chains[Geometry], poses: Array) -> tuple[_State, _State]:
    """Change all lengths, each way, alike until one is about to open a group: the last two states of each row."""
    n_rows = poses.shape[2]
    before = last = _at(chains, _GRID, np.zeros((n_rows, 1, 1)), poses)
    step, is_done = np.full((n_rows, 1, 1), _FIRST_STEP), np.zeros((n_rows, 1, 1), dtype=bool)
    scale = _scale(chains)
    for _ in range(_MOST_STEPS):
        reached = last.change - before.change
        expected = last.poses + chosen(reached > 0, step / reached, 0.0) * (last.poses - before.poses)
        tried = _at(chains, _GRID, last.change + step, expected)
        misses = np.max(np.abs(tried.poses - expected) / scale, axis=(0, 1))
        misses = chosen(np.all(tried.gaps > 0, axis=0), misses / _MOST_MISSED, np.inf)
        is_nothing = ~_leaves_something(chains.way.sign, tried.change)
        missed = np.max(chosen(is_nothing, 0.0, misses), axis=(1, 2), keepdims=True)
        is_taken = (missed <= 1) & ~is_done
        before = _State(*(chosen(is_taken, *pair) for pair in zip(last, before, strict=True)))
        last = _State(*(chosen(is_taken, *pair) for pair in zip(tried, last, strict=True)))
        left = np.min(_left(chains, before, last), axis=(0, 2, 3), keepdims=True)[0]
        # What a prediction along the secant misses goes as the square of the step.
        step = np.minimum(step * np.clip(0.8 / np.sqrt(missed), 0.2, 2.0), chosen(is_taken, _SHARE * left, np.inf))
        is_done |= np.isfinite(left) & (left <= _NEAR * (last.change + left))
        is_done |= (last.change > _MOST_CHANGE) | (step < _SMALLEST_STEP)
        if np.all(is_done):
            break
    return before, last


def _scale(chains: _Chains[Geometry]) -> Array:
    """What x, y and direction of each triad's link count by; (triad, 3, row, 1, 1)."""
    size = chains.size_of(chains.geometry)
    radii = [link_size(triad_legs(triad_at(chains.structure, i, size)[1])) for i in _triads(chains.structure)]
    return np.array([[radius, radius, np.ones_like(radius)] for radius in radii])


def _leaves_something(sign: Array, change: Array) -> NDArray[np.bool_]:
    """Whether of a length that is made shorter anything is left."""
    return (sign > 0) & np.isfinite(change) | (change < _WHOLE)


def _left(chains: _Chains[Geometry], before: _State, last: _State) -> Array:
    """How much more change opens each group at each angle, by the gap's last fall; infinite where it does not fall."""
    fall = before.gaps - last.gaps
    left = chosen(fall > 0, last.gaps * (last.change - before.change) / fall, np.inf)
    return chosen(_leaves_something(chains.way.sign, last.change + left), left, np.inf)


def _is_rival(chains: _Chains[Geometry], before: _State, last: _State) -> NDArray[np.bool_]:
    """Whether a group at a crank angle opens sooner than beside, and not much later than the first of its row."""
    left = _left(chains, before, last)
    first = np.min(left, axis=(0, 2, 3), keepdims=True)
    is_low = (left <= np.roll(left, 1, axis=-1)) & (left <= np.roll(left, -1, axis=-1))
    return is_low & (left <= first / (1 - 2 * _NEAR)) & np.isfinite(left) & (last.change <= _MOST_CHANGE)


def _refined(
    chains: _Chains[Geometry],
    group: NDArray[np.intp],
    angle: Array,
    known: tuple[Array, Array],
    change: Array,
    poses: Array,
) -> tuple[Array, Array]:
    """Change, and crank angle, at which the least gap of a group beside a given angle becomes zero; (rival, 1) each.

    known is a smaller change and the gap there. The least gap is that of a parabola through three points.
    """
    rival = np.arange(len(group))
    half: Array = np.full(change.shape, _GRID[1])
    root, is_settled = np.full(change.shape, np.nan), np.zeros(change.shape, dtype=bool)
    for _ in range(_MOST_REFINEMENTS):
        beside = angle + half * np.array([-1.0, 0.0, 1.0])
        state = _at(chains, beside, change, np.repeat(poses, 3, axis=-1))
        gap = state.gaps[group, rival]
        bend: Array = gap[:, :1] - 2.0 * gap[:, 1:2] + gap[:, 2:]
        fall: Array = 0.5 * (gap[:, :1] - gap[:, 2:])
        shift: Array = chosen(bend > 0, np.clip(fall / bend, -1.0, 1.0), np.sign(fall))
        least = _between(gap, shift)
        closes: NDArray[np.bool_] = np.all(gap > 0, axis=-1, keepdims=True)
        is_new = closes & ~is_settled
        root = chosen(is_new, change + least * (change - known[0]) / (known[1] - least), root)
        angle = chosen(is_new, angle + shift * half, angle)
        poses = chosen(is_new, _between(state.poses, shift), poses)
        nearer = chosen(closes, change + _CLOSER * (root - change), 0.5 * (known[0] + change))
        known = (chosen(is_new, change, known[0]), chosen(is_new, least, known[1]))
        is_inside = closes & (np.abs(shift) < 1)
        is_settled |= is_inside & (np.abs(root - known[0]) <= _SETTLED * root)
        change = nearer
        half = chosen(is_inside, _FINER, chosen(closes, 1.0, 0.5)) * half
        if np.all(is_settled):
            break
    return root, np.mod(angle, 2 * np.pi)


def _between(values: Array, shift: Array) -> Array:
    """Value of the parabola through three points, `shift` from the middle in parts of their distance."""
    left, middle, right = np.split(values, 3, axis=-1)
    return middle + 0.5 * shift * ((right - left) + shift * (left - 2 * middle + right))
