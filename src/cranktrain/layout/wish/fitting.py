"""Whether an output can make a wanted motion, and what that asks of the crank; of others the nearest that goes."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import Words, _
from cranktrain.layout.wish.following import Following, following
from cranktrain.layout.wish.laws import FROM_DEAD_CENTRE, NEAREST
from cranktrain.layout.wish.stroke import Output
from cranktrain.layout.wish.turning import of_series
from cranktrain.layout.wish.wanted import Piece, WantedMotion
from cranktrain.saying.wording import number

_NEAR = 1e-3
"""Of the stroke: so much a motion may miss the stroke's ends, and is put to them."""
_SMOOTH = 1e-6
"""Of the largest speed: velocities that differ by less are one."""
_SLOW = 2
"""Power with which a motion turns round that the crank passes without a rest."""


class WishWay(NamedTuple):
    """How positions are written in the file: p in q = zero + sense·p, their unit, and where they stand."""

    zero: float
    sense: float
    unit: str
    path: str
    is_table: bool

    def said(self, position: float) -> Words:
        """Write a position as the file counts it."""
        return number((position - self.zero) * self.sense, self.unit)

    def of(self, piece: Piece, key: str) -> str:
        """Path of a key of a piece."""
        return f"{self.path}.{'positions' if self.is_table else f'piece[{piece.number}].{key}'}"


def fitted(output: Output, wanted: WantedMotion, way: WishWay) -> Following:
    """Put a wanted motion to an output whose crank turns all round.

    Raises
    ------
    InputError
        Where it does not turn round at the stroke's ends, with the nearest that does; or asks for an infinite
        acceleration of the crank, with the nearest law that does not.
    """
    _refuse([*_turn_problems(wanted, way)] or [*_joint_problems(wanted, way)])
    highest, lowest = _extremes(wanted)
    stroke = output.stroke
    misses = max(abs(highest - output.high.position), abs(lowest - output.low.position))
    if misses > _NEAR * stroke:
        raise InputError([_nearest(output, highest, lowest, way)])
    factor = stroke / (highest - lowest)
    put = wanted.scaled(factor, output.high.position - factor * highest)
    high, low = (_around(put, sense) for sense in (1.0, -1.0))
    _refuse(
        [*_dead_problems(output, put, way, high, is_high=True), *_dead_problems(output, put, way, low, is_high=False)]
    )
    return following(output, put, high, low)


def refuse_outside(output: Output, wanted: WantedMotion, way: WishWay) -> None:
    """Refuse a motion for a rocking crank that is not within the stroke, or jumps, or is none."""
    highest, lowest = _extremes(wanted)
    if highest == lowest:
        raise InputError([Problem(way.path, way.said(lowest), _("must go to and fro, and this stands all the time"))])
    inner = _NEAR * output.stroke
    found = [*_joint_problems(wanted, way)]
    if highest > output.high.position - inner or lowest < output.low.position + inner:
        allowed = _(
            "must stay within the stroke, {low} to {high}, where no dead centre is: the crank swings between two"
        )
        said = _("{low} to {high}", low=way.said(lowest), high=way.said(highest))
        found.append(Problem(way.path, said, allowed.format(**_ends(output, way))))
    _refuse(found)


def _refuse(problems: Sequence[Problem]) -> None:
    if problems:
        raise InputError(problems)


def _ends(output: Output, way: WishWay) -> dict[str, Words]:
    """Ends of the stroke as the file counts, the least first."""
    low, high = sorted((output.low.position, output.high.position), key=lambda end: (end - way.zero) * way.sense)
    return {"low": way.said(low), "high": way.said(high)}


def _extremes(wanted: WantedMotion) -> tuple[float, float]:
    """Highest and lowest position: pieces have none between their ends."""
    begins = [piece.begin for piece in wanted.pieces]
    return max(begins), min(begins)


def _moving(wanted: WantedMotion) -> list[int]:
    return [n for n, piece in enumerate(wanted.pieces) if piece.law is not None]


def _turn_problems(wanted: WantedMotion, way: WishWay) -> Iterator[Problem]:
    """Find a motion that turns round more than twice a period."""
    moving = [wanted.pieces[n] for n in _moving(wanted)]
    senses = np.sign([piece.rise for piece in moving])
    n_turns = int(np.sum(senses != np.roll(senses, 1)))
    if n_turns != 2:
        allowed = _("must go from one end of the stroke to the other and back once a period; it turns round {n} times")
        repair = _('for a crank that swings within the stroke write mode = "rocking"')
        repair = _("give its rests, each with `begin` and `until`") if way.is_table and n_turns > 2 else repair
        yield Problem(way.path, None, allowed.format(n=n_turns), repair)


def _joint_problems(wanted: WantedMotion, way: WishWay) -> Iterator[Problem]:
    """Find jumps of the velocity from piece to piece."""
    pieces = wanted.pieces
    largest = max((abs(piece.rise) / piece.span for piece in pieces if piece.law is not None), default=0.0)
    for before, piece in zip(pieces[-1:] + pieces[:-1], pieces, strict=True):
        jump = piece.speeds[0] - before.speeds[1]
        if abs(jump) > _SMOOTH * largest:
            allowed = _(
                "must begin with the velocity with which the piece before ends, {end}: this law begins with {own}"
            )
            unit = "m/s" if way.unit == "mm" else "rad/s"
            end, own = (number(speed * way.sense, unit) for speed in (before.speeds[1], piece.speeds[0]))
            faulty = piece if piece.law is not None and piece.speeds[0] != 0 else before
            yield Problem(way.of(faulty, "law"), None, allowed.format(end=end, own=own))


def _nearest(output: Output, highest: float, lowest: float, way: WishWay) -> Problem:
    """Say which motion is the nearest that has the stroke's ends."""
    low, high = sorted((lowest, highest), key=lambda end: (end - way.zero) * way.sense)
    allowed = _(
        "must turn round at both ends of the stroke, {low} and {high}, or a crank that turns cannot make it; it does so"
        " at {own_low} and {own_high}"
    )
    factor = output.stroke / (highest - lowest)
    ends = (output.low.position, output.high.position)
    at_least = min((end - way.zero) * way.sense for end in ends)
    shift = at_least - factor * (low - way.zero) * way.sense
    repair = _('the nearest: its positions times {factor} plus {shift}; or write mode = "rocking"')
    return Problem(
        way.path,
        None,
        allowed.format(**_ends(output, way), own_low=way.said(low), own_high=way.said(high)),
        repair.format(factor=f"{factor:.6g}", shift=number(shift, way.unit)),
    )


def _around(wanted: WantedMotion, sense: float) -> tuple[int, int]:
    """Pieces by which a motion comes to its highest (sense 1) or lowest position, and by which it leaves it."""
    moving = _moving(wanted)
    for before, after in zip(moving[-1:] + moving[:-1], moving, strict=True):
        if wanted.pieces[before].rise * sense > 0 > wanted.pieces[after].rise * sense:
            return before, after
    raise AssertionError


def _dead_problems(
    output: Output, wanted: WantedMotion, way: WishWay, around: tuple[int, int], *, is_high: bool
) -> Iterator[Problem]:
    """Find an infinite acceleration of the crank at a dead centre."""
    coming, leaving = (wanted.pieces[n] for n in around)
    if coming.law is None or leaving.law is None:
        return
    orders = coming.law.orders[1], leaving.law.orders[0]
    rests = any(piece.law is None for piece in _between(wanted, around))
    centre = output.high if is_high else output.low
    allowed = _(
        "asks for an infinite acceleration of the crank in the dead centre at {place}: there the way must begin and end"
        " like t⁴ or slower, and this one goes like {way}"
    )
    repair = _('the nearest law: "{law}"', law=NEAREST)
    for piece, order in zip((coming, leaving), orders, strict=True):
        # A way like t² keeps the crank turning, if nothing stands before or after.
        if order < FROM_DEAD_CENTRE and (order != _SLOW or rests or orders[0] != orders[1]):
            said = allowed.format(place=way.said(centre.position), way=f"t{'⁰¹²³'[order]}")
            yield Problem(way.of(piece, "law"), None, said, repair)
    if orders == (_SLOW, _SLOW) and not rests:
        speeds = [
            float(np.sqrt(of_series(series, piece.rise, piece.span, 1.0).series[0] / centre.turning.series[0]))
            for piece, series in ((coming, coming.law.end), (leaving, leaving.law.start))
        ]
        if abs(speeds[1] - speeds[0]) > _SMOOTH * speeds[0]:
            jumps = _(
                "makes the speed of the crank jump in the dead centre at {place}, from {before} to {after}: an infinite"
                " acceleration"
            )
            before, after = (number(speed, "rpm") for speed in speeds)
            said = jumps.format(place=way.said(centre.position), before=before, after=after)
            yield Problem(way.of(leaving, "law"), None, said, repair)


def _between(wanted: WantedMotion, around: tuple[int, int]) -> Sequence[Piece]:
    """Pieces after the first of two and before the second."""
    n = len(wanted.pieces)
    return [wanted.pieces[(around[0] + k) % n] for k in range(1, (around[1] - around[0]) % n)]
