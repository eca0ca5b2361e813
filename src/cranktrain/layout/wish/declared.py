"""The wanted motions that machines declare: of all designs, and what is wrong with one."""

import math
from collections.abc import Iterator
from functools import partial
from typing import ClassVar

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import N_, _
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.mechanisms import Mechanisms, mechanisms_of
from cranktrain.layout.part_tables import part_name
from cranktrain.layout.specs import MAIN
from cranktrain.layout.speed import SpeedCurve
from cranktrain.layout.wish.constant_crank import constant_crank
from cranktrain.layout.wish.fitting import WishWay, fitted, refuse_outside
from cranktrain.layout.wish.following import Following, Rocking, corners, crank_by_angle
from cranktrain.layout.wish.laws import LAWS, NEAREST
from cranktrain.layout.wish.polynomials import polynomial_pieces, through_rests
from cranktrain.layout.wish.stroke import Output, output_of
from cranktrain.layout.wish.tables import MotionPieceSpec, WantedMotionSpec
from cranktrain.layout.wish.wanted import Piece, WantedMotion, from_pieces, through_positions
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.periodic import PeriodicCurve, curves_by_design, cycle_grid
from cranktrain.record import record

PATH = f"shaft.{MAIN}.motion"
_CLOSE = 1e-6
"""Of the stroke: as near as this to an end of it is at the end."""


@record
class WantedMotions:
    """Wanted motions whose crank turns all round, of every design.

    Attributes
    ----------
    each : tuple of Following
    unit : str
        Of positions: m, or rad of a rocker.
    """

    needs: ClassVar[str] = N_("[shaft.main.motion]")

    each: tuple[Following, ...]
    unit: str


@record
class RockingMotions:
    """Wanted motions whose crank swings between two angles, of every design; unit as of `WantedMotions`."""

    reads: ClassVar[tuple[str, ...]] = ("[shaft.main.motion]",)

    each: tuple[Rocking, ...]
    unit: str


def wish_problems(design: Design) -> Iterator[Problem]:
    """Find a motion of what is not the output, and one that the output cannot make."""
    spec = design.shafts[MAIN].motion
    if spec is None or not design.places:
        return
    place = design.places[0]
    output = part_name(place.kind.output.part)
    names = dict.fromkeys(filter(None, (getattr(place.spec, "output", None), output)))
    if spec.of is not None and spec.of not in names:
        allowed = _("must be what the first mechanism drives: {names}; or leave it out")
        yield Problem(f"{PATH}.of", spec.of, allowed.format(names=", ".join(names)))
        return
    found = [*_unit_problems(spec, is_slider=place.kind.output.is_slider)]
    yield from found
    if not found:
        try:
            _made(spec, mechanisms_of(Mechanisms, design.places[:1], 1), 0)
        except InputError as error:
            yield from error.problems


def wish_parts(designs: Designs) -> WantedMotions | RockingMotions | None:
    """Give the wanted motions that [shaft.main.motion] declares; None where there is none."""
    specs = [design.shafts[MAIN].motion for design in designs.each]
    made = [_made(spec, designs.mechanisms, n) for n, spec in enumerate(specs) if spec is not None]
    unit = "m" if designs.places[0].kind.output.is_slider else "rad"
    rocking = tuple(one for one in made if isinstance(one, Rocking))
    turning = tuple(one for one in made if isinstance(one, Following))
    if rocking:
        return RockingMotions(rocking, unit)
    return WantedMotions(turning, unit) if turning else None


def wanted_speed(wanted: WantedMotions, n_points: int, cycle: float, *, zero: Array) -> SpeedCurve:
    """Speed of the crank that makes the wanted motions, over its angle.

    Parameters
    ----------
    wanted : WantedMotions
    n_points : int
        Of the grid.
    cycle : float
        [rad]
    zero : Array, shape (design, 1, 1)
        φ of the grid's first point. [rad]
    """
    zeros = np.broadcast_to(zero, (len(wanted.each), 1, 1))
    squares = [
        _square(made, n_points, cycle, float(start[0, 0])) for made, start in zip(wanted.each, zeros, strict=True)
    ]
    together = curves_by_design(squares)
    square = together._replace(samples=np.stack([one.samples for one in squares]))
    mean = np.array([TURN / made.wanted.period for made in wanted.each])
    own = [corners(made) for made in wanted.each]
    most = max(one.size for one in own)
    kinks = np.stack([np.pad(one, (0, most - one.size), constant_values=np.nan) for one in own])
    turns = TURN * np.arange(round(cycle / TURN))
    return SpeedCurve(
        square,
        zero,
        mean[:, np.newaxis, np.newaxis],
        is_steady_running=False,
        corners=np.concatenate([kinks + turn for turn in turns], axis=-1),
    )


def _square(made: Following, n_points: int, cycle: float, zero: float) -> PeriodicCurve:
    """ω² over the crank angle as it is shown, with its slope 2ε; found anew at every angle. [rad²/s²]"""
    motion = partial(_square_at, made, zero)
    return PeriodicCurve(cycle, motion(cycle_grid(n_points, cycle)).value, motion)


def _square_at(made: Following, zero: float, shown: Array) -> Coefficient:
    """ω² and its slope at crank angles as they are shown; zero is φ of their first. [rad²/s², rad²/s² per rad]"""
    flat = crank_by_angle(made, np.ravel(shown) + zero)
    rows = (flat.speed**2, 2 * flat.acceleration, np.full_like(flat.speed, np.nan))
    return Coefficient(*(row.reshape(np.shape(shown)) for row in rows))


def _unit_problems(spec: WantedMotionSpec, *, is_slider: bool) -> Iterator[Problem]:
    """Find lengths for a rocker, and angles for a slider."""
    wrong, right = ("swing", "to") if is_slider else ("to", "swing")
    allowed = (
        _("is for a rocker; a slider has lengths") if is_slider else _("is for a slider; a rocker has angles, swing")
    )
    for place, piece in enumerate(spec.piece):
        if getattr(piece, wrong) is not None:
            yield Problem(f"{PATH}.piece[{place}].{wrong}", getattr(piece, wrong).text, allowed, f"`{right}`")
    listed = "swing" if is_slider else "positions"
    if getattr(spec, listed) is not None:
        yield Problem(f"{PATH}.{listed}", None, allowed)


def _made(spec: WantedMotionSpec, mechanisms: Mechanisms, design: int) -> Following | Rocking | None:
    """Put the motion of one design to its output; None where that does not close."""
    output = output_of(mechanisms, design, 0)
    if output is None:
        first = mechanisms.alone(design, 0, np.linspace(0, TURN, 73))
        coordinate = first.slider if hasattr(first, "slider") else first.rocker.angle
        if not np.all(np.isfinite(coordinate.value)):
            return None  # told as links that do not close
        allowed = _("is for an output that goes out and back once a turn of the crank; this one does not")
        raise InputError([Problem(PATH, None, allowed)])
    way = _way(spec, output, is_slider=hasattr(mechanisms.alone(design, 0, np.zeros(1)), "slider"))
    wanted = _wanted(spec, output, way)
    if spec.mode == "turning":
        return fitted(output, wanted, way)
    refuse_outside(output, wanted, way)
    return Rocking(output, wanted)


def _way(spec: WantedMotionSpec, output: Output, *, is_slider: bool) -> WishWay:
    """How the positions of a table count: from the shaft's far side; of a rocker, from its least angle."""
    falls = (spec.counts_from == "far") == is_slider
    end = output.high if falls else output.low
    unit = "mm" if is_slider else "deg"
    return WishWay(end.position, -1.0 if falls else 1.0, unit, PATH, is_table=not spec.piece)


def _wanted(spec: WantedMotionSpec, output: Output, way: WishWay) -> WantedMotion:
    """The motion that a table says, in the output's own coordinate."""
    if spec.times is not None and spec.listed is not None and spec.period is not None:
        times, places = (np.array([one.si for one in own]) for own in (spec.times, spec.listed))
        at = way.zero + way.sense * places
        if spec.rest:
            return through_rests(times, at, spec.period.si, spec.rests)
        return through_positions(times, at, spec.period.si)
    ends = [piece.target.si for piece in spec.piece if piece.target is not None]
    at, start = way.zero + way.sense * ends[-1], 0.0
    pieces: list[Piece] = []
    for number, piece in enumerate(spec.piece):
        to = at if piece.target is None else way.zero + way.sense * piece.target.si
        pieces += _pieces(piece, start, at, to, output, way, number)
        at, start = to, start + piece.duration.si
    return from_pieces(tuple(pieces))


def _pieces(
    spec: MotionPieceSpec, start: float, at: float, to: float, output: Output, way: WishWay, number: int
) -> tuple[Piece, ...]:
    """A piece of the motion, cut where its polynomial turns round; a way to where it is already is a rest."""
    if spec.coefficients is not None:
        return _by_coefficients(spec, start, at, to, way, number)
    if to == at:
        return (Piece(start, spec.duration.si, at, 0.0, None, number),)
    return (_by_law(spec, start, at, to, output, way, number),)


def _by_coefficients(
    spec: MotionPieceSpec, start: float, at: float, to: float, way: WishWay, number: int
) -> tuple[Piece, ...]:
    """Pieces of a polynomial that its coefficients say."""
    if to == at:
        allowed = _("are shares of a way, and this piece goes nowhere: let it stand, or go somewhere else and back")
        raise InputError([Problem(f"{way.path}.piece[{number}].coefficients", None, allowed)])
    shares = np.array([one.si for one in spec.coefficients or ()])
    return polynomial_pieces(start, spec.duration.si, at, (to - at) * shares / math.fsum(shares.tolist()), number)


def _by_law(
    spec: MotionPieceSpec, start: float, at: float, to: float, output: Output, way: WishWay, number: int
) -> Piece:
    """A piece by a law that has a name."""
    if spec.law != "constant crank":
        return Piece(start, spec.duration.si, at, to - at, LAWS[spec.law or NEAREST], number)
    ends = (output.high.position, output.low.position)
    near = _CLOSE * output.stroke
    if not all(min(abs(end - one) for end in ends) < near for one in (at, to)):
        allowed = _("goes from one end of the stroke to the other; this way does not")
        raise InputError([Problem(f"{way.path}.piece[{number}].law", spec.law, allowed)])
    return Piece(start, spec.duration.si, at, to - at, constant_crank(output, is_falling=to < at), number)
