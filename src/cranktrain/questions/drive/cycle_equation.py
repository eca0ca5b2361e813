"""The equation of motion over a cycle at Gauss's points: Newton's method for the cycle that repeats itself."""

from collections.abc import Callable

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.drive.steady_cycle import SpeedOverTurn
from cranktrain.questions.reduction.cycle_pieces import INTEGRALS, N_NODES, CyclePieces, to_places

_MOST_STEPS = 60
_FIRST_STEPS, _LAST_STEPS = 16, 10
"""Where after so many steps the last of them are no less than half the least before, they lead nowhere: where they lead
to a cycle, be it one that is just about to vanish, each step at least is half the one before."""
_SETTLED = 1e-11
"""Of ω²: after such a step of Newton's method the next one is less than rounding."""
_STANDS = 1e-14
"""In parts of the largest ω²: a shaft that is so slow on the way stops within the cycle."""
_NEAR = 1e-7
"""In parts of ω²: of the difference by which slopes are taken."""
_TO_ENDS = to_places(np.array([0.0, 1.0]))


def speed_over_turn(
    acceleration: Callable[[Array], Array], mesh: CyclePieces, first_speed: float | Array
) -> SpeedOverTurn | None:
    """Find the cycle that repeats itself, near a constant speed or another cycle.

    Parameters
    ----------
    acceleration : callable
        Of the crank at the nodes of the mesh, by the speeds there, shape (n,). [rad/s → rad/s²]
    mesh : CyclePieces
        Where its limits of ω²/2 change from one piece to the next, the law jumps.
    first_speed : float, or Array of shape (n,)
        At the nodes. [rad/s]

    Returns
    -------
    SpeedOverTurn or None
        None where none was found: the shaft would stop within the cycle, or the steps do not end.

    Notes
    -----
    docs/theory/reduced-machine, eqs. (31.6) to (31.8): ω²/2 has the slope ε by the angle. Newton's method on Gauss's
    points of all pieces, so that a motor may be as stiff as it likes.
    """
    half = np.full(len(mesh.start) * N_NODES, 0.5 * np.square(first_speed))
    moves: list[float] = []
    for _ in range(_MOST_STEPS):
        base = float(mesh.mean(half))
        there = mesh.within(half)
        aside = np.where(mesh.within(there * (1 + _NEAR)) > there * (1 + 0.5 * _NEAR), _NEAR, -_NEAR)
        with np.errstate(all="ignore"):
            now = acceleration(np.sqrt(2 * there))
            near = acceleration(np.sqrt(2 * there * (1 + aside)))
        slope = (near - now) / (there * aside)
        if not np.all(np.isfinite(slope)):
            return None
        rest = now - slope * (there - base)
        departure, at_start, slopes, multiplier = _linear_cycle(slope, rest, now, mesh, base)
        if not np.all(np.isfinite(departure)):
            return None
        # A step that would stop the shaft goes part of the way.
        better = np.clip(base + departure, half / 4, half * 4)
        moves.append(float(np.max(np.abs(better - half) / half)))
        half = better
        if np.min(half) < _STANDS * np.max(half):
            return None
        if moves[-1] < _SETTLED:
            return SpeedOverTurn(mesh, base, departure, at_start, slopes, multiplier)
        if _leads_nowhere(moves):
            return None
    return None


def _leads_nowhere(moves: list[float]) -> bool:
    """Whether the last steps are no shorter than those before them."""
    return len(moves) >= _FIRST_STEPS and min(moves[-_LAST_STEPS:]) > 0.5 * min(moves[:-_LAST_STEPS])


def _linear_cycle(
    slope: Array, rest: Array, now: Array, mesh: CyclePieces, base: float
) -> tuple[Array, Array, Array, float]:
    """Periodic solution of y′ = a y + b from the base on: at the nodes, where pieces begin, its slope; multiplier."""
    # Solved for the slopes, each row by its own size: where a is large, as behind a stiff motor, y would lose digits.
    width = mesh.width[:, np.newaxis]
    a, b = (part.reshape(-1, N_NODES) for part in (slope, rest))
    size = 1 / (1 + width * np.abs(a))
    system = size[..., np.newaxis] * (np.eye(N_NODES) - (width * a)[..., np.newaxis] * INTEGRALS[:-1])
    solved = np.asarray(np.linalg.solve(system, np.stack([size * a, size * b], axis=-1)), dtype=np.float64)
    of_start, of_rest = solved[..., 0], solved[..., 1]
    grows, gains = mesh.width * (of_start @ INTEGRALS[-1]), mesh.width * (of_rest @ INTEGRALS[-1])
    over, past = (np.roll(each, -1).tolist() for each in _over_jumps(now, mesh, base))
    growth, total = 0.0, 0.0  # of the cycle so far: its factor less 1, which of a heavy machine is next to nothing
    steps = [
        pair
        for piece, jump in zip(
            zip(grows.tolist(), gains.tolist(), strict=True), zip(over, past, strict=True), strict=True
        )
        for pair in (piece, jump)
    ]
    for grow, gain in steps:
        growth, total = growth + (grow + growth * grow), total + (total * grow + gain)
    ends = [-total / growth if growth else np.nan]
    for grow, gain in steps[:-2]:
        ends.append(ends[-1] + (ends[-1] * grow + gain))
    at_start = np.array(ends[::2])
    slopes = of_start * at_start[:, np.newaxis] + of_rest
    found = at_start[:, np.newaxis] + width * (slopes @ INTEGRALS[:-1].T)
    return np.ravel(found), at_start, np.ravel(slopes), 1 + growth


def _over_jumps(now: Array, mesh: CyclePieces, base: float) -> tuple[Array, Array]:
    """What a jump of the law before each piece makes of y: y + (y · over + past); nothing where there is none.

    The pieces meet at an angle that is near the one at which the jump is passed: each is prolonged to there.
    """
    ends = now.reshape(-1, N_NODES) @ _TO_ENDS.T
    before, low, high = (np.roll(each, 1) for each in (ends[:, 1], mesh.low, mesh.high))
    level = np.where(mesh.low >= high, mesh.low, np.where(mesh.high <= low, mesh.high, np.nan))
    with np.errstate(divide="ignore", invalid="ignore"):
        factor = ends[:, 0] / before
    is_passed = np.isfinite(level) & np.isfinite(factor) & (factor > 0)
    over = np.where(is_passed, factor - 1, 0.0)
    return over, np.where(is_passed, -over * (level - base), 0.0)
