"""The equation of motion over a cycle at Gauss's points: Newton's method for the cycle that repeats itself."""

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.drive.steady_cycle import SpeedOverTurn
from cranktrain.questions.reduction.cycle_pieces import INTEGRALS, N_NODES, CyclePieces, pieces_together, to_places

_MOST_STEPS = 60
_FIRST_STEPS, _LAST_STEPS = 16, 10
"""Where after so many steps the last of them are no less than half the least before, they lead nowhere: where they lead
to a cycle, be it one that is just about to vanish, each step at least is half the one before."""
_SETTLED = 1e-11
"""Of ω²: after such a step of Newton's method the next one is less than rounding."""
_NEARLY, _ROUNDING = 1e-7, 1e-15
"""The same where steps shrink so that the next one would be less than rounding; and slopes by differences allow it."""
_STANDS = 1e-14
"""In parts of the largest ω²: a shaft that is so slow on the way stops within the cycle."""
_NEAR = 1e-7
"""In parts of ω²: of the difference by which slopes are taken."""
_GENTLE, _N_TERMS = 0.09, 10
"""Of slopes by widths: below, so many terms of a series leave less than rounding, as the n-th is aⁿ/n!."""
_TO_ENDS = to_places(np.array([0.0, 1.0]))


def speed_over_turn(
    acceleration: Callable[[Array], Array], mesh: CyclePieces, first_speed: float | Array
) -> SpeedOverTurn | None:
    """Find the cycle that repeats itself of one design: as `speeds_over_turn`, of arrays without the designs' axis."""
    of_one = pieces_together([mesh])
    first = np.full(of_one.nodes.shape, first_speed)
    return speeds_over_turn(lambda speed: acceleration(speed[0])[np.newaxis], of_one, first)[0].cycle


class Sought(NamedTuple):
    """What became of a cycle that was sought: None where there is none, or none yet."""

    cycle: SpeedOverTurn | None
    is_over: bool


def speeds_over_turn(
    acceleration: Callable[[Array], Array], mesh: CyclePieces, first_speed: Array, most_steps: int = _MOST_STEPS
) -> list[Sought]:
    """Find the cycles that repeat themselves, near constant speeds or other cycles; each as if it were alone.

    Parameters
    ----------
    acceleration : callable
        Of the crank at the nodes of the mesh, by the speeds there, shape (design, n). [rad/s → rad/s²]
    mesh : CyclePieces
        Of the designs. Where its limits of ω²/2 change from one piece to the next, the law jumps.
    first_speed : Array, shape (design, n)
        At the nodes. [rad/s]
    most_steps : int, optional
        After which what is not over is left.

    Returns
    -------
    list of Sought
        Without a cycle where none was found: the shaft would stop within the cycle, or the steps do not end.

    Notes
    -----
    docs/theory/reduced-machine, eqs. (31.6) to (31.8): ω²/2 has the slope ε by the angle. Newton's method on Gauss's
    points of all pieces, so that a motor may be as stiff as it likes.
    """
    half, n_designs = 0.5 * np.square(first_speed), len(first_speed)
    found: list[Sought | None] = [None] * n_designs
    moves: list[list[float]] = [[] for _design in range(n_designs)]
    for _ in range(most_steps):
        if None not in found:
            break
        with np.errstate(all="ignore"):
            base = mesh.mean(half)[:, np.newaxis]
            there = mesh.within(half)
            aside = np.where(mesh.within(there * (1 + _NEAR)) > there * (1 + 0.5 * _NEAR), _NEAR, -_NEAR)
            now = acceleration(np.sqrt(2 * there))
            near = acceleration(np.sqrt(2 * there * (1 + aside)))
            slope = (near - now) / (there * aside)
            is_known = np.all(np.isfinite(slope), axis=-1)
            slope = np.where(is_known[:, np.newaxis], slope, 0.0)  # of a design that is over, what can be solved
            rest = now - slope * (there - base)
            line = _linear_cycle(slope, rest, now, mesh, base)
            # A step that would stop the shaft goes part of the way.
            better = np.clip(base + line.departure, half / 4, half * 4)
            moved = np.max(np.abs(better - half) / half, axis=-1).tolist()
        is_known &= np.all(np.isfinite(line.departure), axis=-1)
        stands = np.min(better, axis=-1) < _STANDS * np.max(better, axis=-1)
        half = better
        for design in (place for place, known in enumerate(found) if known is None):
            moves[design].append(moved[design])
            if not is_known[design] or stands[design]:
                found[design] = Sought(None, is_over=True)
            elif _is_settled(moves[design]):
                own = CyclePieces(*(part[design] for part in mesh))
                cycle = SpeedOverTurn(
                    own,
                    float(base[design, 0]),
                    line.departure[design],
                    line.at_start[design],
                    line.slopes[design],
                    float(line.multiplier[design]),
                )
                found[design] = Sought(cycle, is_over=True)
            elif _leads_nowhere(moves[design]):
                found[design] = Sought(None, is_over=True)
    is_over = most_steps >= _MOST_STEPS
    return [Sought(None, is_over) if own is None else own for own in found]


def _is_settled(moves: list[float]) -> bool:
    """Whether the next step would be less than rounding: each is as the square of the one before."""
    last = moves[-1]
    if last >= _NEARLY or len(moves) == 1:
        return last < _SETTLED
    return last < _SETTLED or last * (last / moves[-2]) ** 2 < _ROUNDING


def _leads_nowhere(moves: list[float]) -> bool:
    """Whether the last steps are no shorter than those before them."""
    return len(moves) >= _FIRST_STEPS and min(moves[-_LAST_STEPS:]) > 0.5 * min(moves[:-_LAST_STEPS])


class _LinearCycle(NamedTuple):
    """Periodic solution of y′ = a y + b from the base on: at the nodes, where pieces begin, its slope; multiplier."""

    departure: Array
    at_start: Array
    slopes: Array
    multiplier: Array


def _linear_cycle(slope: Array, rest: Array, now: Array, mesh: CyclePieces, base: Array) -> _LinearCycle:
    """Solve the equation of a step of Newton's method, of every design."""
    width = mesh.width[..., np.newaxis]
    a, b = (part.reshape(*width.shape[:-1], N_NODES) for part in (slope, rest))
    solved = _slopes_by_start_and_rest(width * a, a, b)
    of_start, of_rest = solved[..., 0], solved[..., 1]
    grows, gains = mesh.width * (of_start @ INTEGRALS[-1]), mesh.width * (of_rest @ INTEGRALS[-1])
    steps = [grows, gains]
    if np.any(mesh.low > -np.inf) or np.any(mesh.high < np.inf):
        jumps = (np.roll(each, -1, axis=-1) for each in _over_jumps(now, mesh, base))
        # piece and jump in turn
        steps = [np.stack(pair, axis=-1).reshape(len(base), -1) for pair in zip(steps, jumps, strict=True)]
    columns = (each.T if len(base) > 1 else each[0].tolist() for each in steps)
    starts, growth = _repeated(*columns)
    at_start = np.stack(starts, axis=-1).reshape(len(base), -1)[:, :: steps[0].size // grows.size]
    slopes = of_start * at_start[..., np.newaxis] + of_rest
    found = at_start[..., np.newaxis] + width * (slopes @ INTEGRALS[:-1].T)
    return _LinearCycle(found.reshape(slope.shape), at_start, slopes.reshape(slope.shape), 1 + np.atleast_1d(growth))


def _slopes_by_start_and_rest(steepness: Array, a: Array, b: Array) -> Array:
    """Slopes y′ at the nodes of y′ = a y + b: for y = 1 where a piece begins and b = 0; and for y = 0 there.

    `steepness` is a by the width of the piece; all of shape (design, piece, node), what is found (…, 2), in one and
    the same order in memory whichever way: sums of products hang on it.
    """
    is_gentle = np.max(np.abs(steepness), axis=(1, 2)) < _GENTLE
    if np.all(is_gentle):
        return _by_series(steepness, a, b)
    if not np.any(is_gentle):
        return _solved(steepness, a, b)
    found = np.empty((*a.shape, 2))
    for some, way in ((is_gentle, _by_series), (~is_gentle, _solved)):
        found[some] = way(steepness[some], a[some], b[some])
    return found


def _by_series(steepness: Array, a: Array, b: Array) -> Array:
    """Put what is found into the right side again and again: of gentle slopes some times are enough."""
    given = np.stack([a, b], axis=2)
    found, steep = given, steepness[:, :, np.newaxis]
    for _again in range(_N_TERMS):
        # designs one by one, as BLAS rounds by how many rows there are
        found = (found.reshape(len(a), -1, N_NODES) @ INTEGRALS[:-1].T).reshape(given.shape)
        found *= steep
        found += given
    return np.moveaxis(found, 2, -1).copy()


def _solved(steepness: Array, a: Array, b: Array) -> Array:
    """Solve for the slopes, each row by its own size: where a is large, as of a stiff motor, y would lose digits."""
    size = 1 / (1 + np.abs(steepness))
    # in one and the same room: of many designs it is too large to be kept near
    system = steepness[..., np.newaxis] * INTEGRALS[:-1]
    np.subtract(np.eye(N_NODES), system, out=system)
    system *= size[..., np.newaxis]
    return np.asarray(np.linalg.solve(system, np.stack([size * a, size * b], axis=-1)), dtype=np.float64)


def _repeated(grow: Iterable[Any], gain: Iterable[Any]) -> tuple[list[Any], Any]:
    """Where y is before each step of a cycle that repeats itself, and the cycle's growth; numbers, or those of designs.

    Of one design plain numbers are quicker.
    """
    growth, total = 0.0, 0.0  # of the cycle so far: its factor less 1, which of a heavy machine is next to nothing
    for own, more in zip(grow, gain, strict=True):
        growth, total = growth + (own + growth * own), total + (total * own + more)
    begins = np.where(growth == 0, np.nan, np.divide(-total, growth))
    begins = begins if begins.ndim else float(begins)
    found: list[Any] = []
    for own, more in zip(grow, gain, strict=True):
        found.append(begins)
        begins = begins + (begins * own + more)
    return found, growth


def _over_jumps(now: Array, mesh: CyclePieces, base: Array) -> tuple[Array, Array]:
    """What a jump of the law before each piece makes of y: y + (y · over + past); nothing where there is none.

    The pieces meet at an angle that is near the one at which the jump is passed: each is prolonged to there.
    """
    ends = now.reshape(*mesh.width.shape, N_NODES) @ _TO_ENDS.T
    before, low, high = (np.roll(each, 1, axis=-1) for each in (ends[..., 1], mesh.low, mesh.high))
    level = np.where(mesh.low >= high, mesh.low, np.where(mesh.high <= low, mesh.high, np.nan))
    with np.errstate(divide="ignore", invalid="ignore"):
        factor = ends[..., 0] / before
    is_passed = np.isfinite(level) & np.isfinite(factor) & (factor > 0)
    over = np.where(is_passed, factor - 1, 0.0)
    return over, np.where(is_passed, -over * (level - base), 0.0)
