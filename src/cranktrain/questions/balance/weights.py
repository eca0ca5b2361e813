"""Counterweights and balance shafts of a machine: those of its file, and those solved for."""

from collections.abc import Iterator, Sequence
from dataclasses import field
from functools import reduce
from itertools import combinations
from typing import ClassVar, NamedTuple

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.design import Designs
from cranktrain.layout.frames import Frames
from cranktrain.layout.shafts import AxialPlaces, ShaftCentres, Throws, throw_positions
from cranktrain.layout.specs import MAIN, ShaftSpec
from cranktrain.motion import Array, single
from cranktrain.numerics.harmonics import ComplexArray, phasor
from cranktrain.numerics.plane_vectors import PlaneVectors, reversed_vectors, running_axes
from cranktrain.quantities import Given
from cranktrain.questions.balance.counterweights import middle_of, share_of, two_plane_counterweights
from cranktrain.questions.balance.frame_forces import FrameForces
from cranktrain.questions.balance.rotating_weights import RotatingWeights, joined, on_crank
from cranktrain.questions.balance.shafts import couple_of, lanchester_shafts, two_plane_shafts
from cranktrain.questions.balance.spec import Against, BalanceSpec, Counterweights, Spot, WeightSpec
from cranktrain.questions.balance.unit_shaking import Shaking, gross, shaking, with_weights
from cranktrain.record import record
from cranktrain.references import THEORY_OF_BALANCE as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_WEIGHT = ("weight",)
_UNKNOWN = Given(np.nan, "")
_NOISE = 1e-12
"""Of what all parts could do together: less is rounding."""


class GivenWeights(NamedTuple):
    """Weights of the file, shape (design, weight).

    ratio [1]; moment [kg·m]; angle ahead of throw 1 in the normal sense [rad]; position z along the shaft, NaN where
    the file does not say [m]; place of their shafts, to the right and i up [m].
    """

    ratio: Array
    moment: Array
    angle: Array
    position: Array
    place: ComplexArray


class ShaftsWanted(NamedTuple):
    """A pair of balance shafts: its order, against what it is, its planes and places, shape (design, 1 or 2). [m]"""

    order: int
    against: Against
    planes: Array | None
    places: ComplexArray


class Wheels(NamedTuple):
    """Wheels of a driving axle: names; z, and what each carries at rest, NaN if unknown, shape (design, 2). [m, N]"""

    names: tuple[str, ...]
    place: Array
    load: Array


@record
class DeclaredBalance:
    """The table [balance].

    Attributes
    ----------
    given : GivenWeights
    counterweights : "rotating", "least_force" or None
        Which are solved for.
    share : Array, shape (design,)
        Of what reciprocates that they take. [1]
    planes : Array, shape (design, 2), or None
        z of their planes; None where every throw has its own. [m]
    shafts : tuple of ShaftsWanted
    wheels : Wheels or None
    """

    needs: ClassVar[str] = N_("[balance]")
    reads: ClassVar[tuple[str, ...]] = ("[shaft.main]",)

    given: GivenWeights
    counterweights: Counterweights | None
    share: Array
    planes: Array | None
    shafts: tuple[ShaftsWanted, ...]
    wheels: Wheels | None


def declared_balance(designs: Designs) -> DeclaredBalance | None:
    """Put the table to the throws; None where there is none."""
    spec, main = designs.together.table(BalanceSpec), designs.together.shafts[MAIN]
    if spec is None:
        return None

    def each(given: Sequence[Given]) -> Array:
        return designs.by_design([one.array for one in given])

    def places(spots: Sequence[Spot]) -> ComplexArray:
        return each([x for x, _y in spots]) + 1j * each([y for _x, y in spots])

    weights, wheels = spec.weight, spec.wheel
    return DeclaredBalance(
        given=GivenWeights(
            ratio=designs.by_design([float(one.ratio) for one in weights]),
            moment=designs.by_design([one.moment for one in weights]),
            angle=designs.by_design([_angle_on(one, main) for one in weights]),
            position=designs.by_design([_position_on(one, main) for one in weights]),
            place=places([one.place for one in weights]),
        ),
        counterweights=spec.counterweights,
        share=np.zeros(designs.n_designs) if spec.share is None else each([spec.share])[:, 0],
        planes=None if spec.planes is None else each(spec.planes),
        shafts=tuple(
            ShaftsWanted(
                pair.order,
                pair.against,
                None if pair.planes is None else each(pair.planes),
                places([pair.forward, pair.backward]),
            )
            for pair in spec.shafts
        ),
        wheels=Wheels(
            tuple(wheels),
            each([one.z for one in wheels.values()]),
            each([one.load or _UNKNOWN for one in wheels.values()]),
        )
        if wheels
        else None,
    )


def balance_problems(spec: BalanceSpec, main: ShaftSpec) -> Iterator[Problem]:
    """Find weights on throws that there are not, and couples where nothing says how far throws are apart."""
    n_throws = len(main.throws)
    allowed = _("must be one of the throws of the shaft `main`, 1 to {n}", n=n_throws)
    yield from (
        Problem(f"balance.weight[{i}].throw", str(weight.throw), allowed)
        for i, weight in enumerate(spec.weight)
        if weight.throw is not None and weight.throw > n_throws
    )
    yield from _cancelled(spec, main)
    if throw_positions(main) is None:
        unknown = _("needs [shaft.main] spacing, or couples along the shaft are not known")
        yield from (
            Problem(f"balance.shafts[{i}].against", f'"{pair.against}"', unknown)
            for i, pair in enumerate(spec.shafts)
            if pair.against != "force"
        )
        if spec.planes is not None:
            yield Problem("balance.planes", None, unknown)
        if spec.wheel:
            yield Problem("balance.wheel", None, unknown)


def _cancelled(spec: BalanceSpec, main: ShaftSpec) -> Iterator[Problem]:
    """Find weights on one throw that do nothing together, as one of them stands on the wrong side."""
    on_throws = [
        (i, weight, weight.moment * np.exp(1j * _angle_on(weight, main)))
        for i, weight in enumerate(spec.weight)
        if weight.throw is not None and weight.throw <= len(main.throws)
    ]
    for (i, one, moment), (j, other, against) in combinations(on_throws, 2):
        if one.throw == other.throw and abs(moment + against) <= _NOISE * abs(moment):
            allowed = _("stands opposite balance.weight[{i}] on throw {throw}: together they balance nothing")
            repair = _("leave one of them out, or put it where it is to be")
            yield Problem(f"balance.weight[{j}]", None, allowed.format(i=i, throw=one.throw), repair)


def _angle_on(weight: WeightSpec, main: ShaftSpec) -> Array:
    """Where a weight stands ahead of throw 1: opposite its throw unless given. [rad]"""
    if weight.angle is not None:
        return weight.angle.array
    return main.throws[(weight.throw or 1) - 1].array - main.throws[0].array + np.pi


def _position_on(weight: WeightSpec, main: ShaftSpec) -> Array:
    """Where a weight stands along the shaft: at its throw unless given; NaN where nothing says where that is. [m]"""
    if weight.z is not None:
        return weight.z.array
    positions = throw_positions(main)
    return single(np.nan) if positions is None else positions[(weight.throw or 1) - 1]


TITLES = {
    "given_{n}": N_("given {n}"),
    "throw_{throw}": N_("throw {throw}"),
    "{on}.plane_{n}": N_("{on}, plane {n}"),
    "plane_{n}": N_("plane {n}"),
    "-{order}": N_("−{order}"),
}
"""What people call balance weights: by their place, or by how many times as fast as the crank they turn."""


@record
class BalanceWeights(StageResult):
    """Weights that balance the machine, given and solved for."""

    balance_weight_moment: Array = quantity(
        "u", "kg*m", _WEIGHT, N_("Mass times radius of the balance weight"), _THEORY, "16.9 to 16.12"
    )
    balance_weight_angle: Array = quantity(
        "ψ",
        "rad",
        _WEIGHT,
        N_("Where the balance weight stands at crank angle 0 of throw 1, ahead of throw 1 in the normal sense"),
        _THEORY,
        "16.9 to 16.12",
    )
    balance_weight_position: Array = quantity(
        "z_u", "m", _WEIGHT, N_("Along the shaft, from throw 1 toward the flywheel"), _THEORY, "definition"
    )
    balance_weight_ratio: Array = quantity(
        "κ",
        "1",
        _WEIGHT,
        N_("Turns of the balance weight for one of the crank; less than 0 against it"),
        _THEORY,
        "definition",
    )
    weights: RotatingWeights = field(kw_only=True)


class _Named(NamedTuple):
    """Weights, shape (design, weight), and what they are called."""

    names: tuple[str, ...]
    weights: RotatingWeights


def balance_weights(
    frame: FrameForces,
    frames: Frames,
    throws: Throws,
    declared: DeclaredBalance,
    axial: AxialPlaces | None,
    centres: ShaftCentres | None,
) -> BalanceWeights:
    """Place the weights that are given, then counterweights, then shafts against what all these leave.

    Notes
    -----
    docs/theory/balance, eqs. (16.7), (16.11), (16.12) and (16.17).
    """
    n_designs, n_mechanisms = frame.force.shape[:2]
    position = np.full((n_designs, n_mechanisms), np.nan) if axial is None else axial.value
    middle = np.zeros(n_designs) if axial is None else axial.mid_plane
    before = shaking(frame.vectors, position, middle)
    lots = [_given(declared.given, frames)]
    if declared.counterweights is not None:
        place = np.zeros((n_designs, n_mechanisms), dtype=complex) if centres is None else centres.value
        centre = running_axes(place, clockwise=frames.clockwise)
        at = position if axial is None else axial.throw
        lots += _counterweights(declared, frame, frames, throws, position=at, middle=middle, centre=centre)
    for pair in declared.shafts:
        left = reduce(lambda one, lot: with_weights(one, lot.weights, middle), lots, before)
        lots.append(_shafts(pair, left, middle, frames))
    names = tuple(name for lot in lots for name in lot.names)
    weights = _without_noise(joined(*(lot.weights for lot in lots)), frame)
    ahead = frames.running * (weights.angle - frames.first[:, np.newaxis])
    return BalanceWeights(
        balance_weight_moment=weights.moment,
        balance_weight_angle=np.where(weights.moment > 0, np.mod(ahead + np.pi, 2 * np.pi) - np.pi, np.nan),
        balance_weight_position=weights.position,
        balance_weight_ratio=weights.ratio,
        weights=weights,
        labels={"weight": names},
    )


def _without_noise(weights: RotatingWeights, frame: FrameForces) -> RotatingWeights:
    """Weights, of which those are exactly 0 that balance nothing but rounding."""
    scale = gross(frame.vectors, np.ones(frame.force.shape[:2]))[:, np.newaxis]
    is_noise = weights.moment * weights.ratio**2 < _NOISE * scale
    return weights._replace(
        moment=np.where(is_noise, 0.0, weights.moment), angle=np.where(is_noise, 0.0, weights.angle)
    )


def _given(weights: GivenWeights, frames: Frames) -> _Named:
    """Weights of the file."""
    return _Named(
        tuple(f"given_{i + 1}" for i in range(weights.ratio.shape[1])),
        RotatingWeights(
            ratio=weights.ratio,
            moment=weights.moment,
            angle=frames.first[:, np.newaxis] + frames.running * weights.angle,
            position=weights.position,
            place=running_axes(weights.place, clockwise=frames.clockwise),
        ),
    )


def _counterweights(
    declared: DeclaredBalance,
    frame: FrameForces,
    frames: Frames,
    throws: Throws,
    *,
    position: Array,
    middle: Array,
    centre: ComplexArray,
) -> Iterator[_Named]:
    """Counterweights of every shaft, each seen as its own crank turns.

    position, middle: z of the mechanisms' throws, and the mid-plane [m]; centre: of their shafts, common axes [m].
    """
    share, planes = declared.share, declared.planes
    z = position[:, throws.first]
    for shaft in dict.fromkeys(throws.shafts):
        own = [i for i, name in enumerate(throws.shafts) if name == shaft]
        sense = float(frames.sense[throws.first[own[0]]])
        all_of = PlaneVectors(frame.vectors.order, *(throws.gathered(part)[:, own] for part in frame.vectors[1:]))
        shaking_own = all_of if sense > 0 else reversed_vectors(all_of)
        rotating, swinging = (throws.gathered(part)[:, own, 0] for part in divided(frame, frames))
        if planes is None:
            part = _part(declared, rotating, swinging, shaking_own, share[:, np.newaxis])
            lot = on_crank(-part, z[:, own])
            names = [f"throw_{throws.names[i]}" for i in own]
        else:
            arm = z[:, own] - middle[:, np.newaxis]
            total = shaking(shaking_own, z[:, own], middle)
            force = _part(declared, np.sum(rotating, axis=-1), np.sum(swinging, axis=-1), total.force, share)
            couple = _part(
                declared, np.sum(arm * rotating, axis=-1), np.sum(arm * swinging, axis=-1), total.couple, share
            )
            lot = two_plane_counterweights(force, couple, planes, middle)
            names = [f"{'' if shaft == MAIN else f'{shaft}.'}plane_{n}" for n in (1, 2)]
        shape = np.shape(lot.moment)
        place = np.broadcast_to(centre[:, throws.first[own[0]], np.newaxis], shape)
        yield _Named(tuple(names), lot._replace(ratio=np.full(shape, sense), angle=sense * lot.angle, place=place))


def divided(frame: FrameForces, frames: Frames) -> tuple[ComplexArray, ComplexArray]:
    """What of each mechanism's first order rotates, and the half of what swings along its axis that turns with it.

    As its own crank turns, shape (design, mechanism, 1): what swings along x has b = f̄ in the mechanism's own axes, and
    what rotates has no b. docs/theory/balance, eq. (16.17).
    """
    of = frame.own
    against = frames.sense[:, np.newaxis] < 0
    forward = np.where(against, np.conj(of.backward[..., 1:2]), of.forward[..., 1:2])
    backward = np.where(against, np.conj(of.forward[..., 1:2]), of.backward[..., 1:2])
    swinging = phasor(2 * frames.sense * frames.direction)[..., np.newaxis] * np.conj(backward)
    return forward - swinging, swinging


def _part(
    declared: DeclaredBalance, rotating: ComplexArray, swinging: ComplexArray, all_of: PlaneVectors, share: Array
) -> ComplexArray:
    """What counterweights take away, of force or couple."""
    if declared.counterweights == "least_force":
        return middle_of(all_of)
    return share_of(rotating, swinging, share)


def _shafts(pair: ShaftsWanted, left: Shaking, middle: Array, frames: Frames) -> _Named:
    """One pair of balance shafts, against what is left of its order."""
    order, places = pair.order, running_axes(pair.places, clockwise=frames.clockwise)
    planes = middle[:, np.newaxis] if pair.planes is None else pair.planes
    if pair.against == "force":
        return _Named((f"+{order}", f"-{order}"), lanchester_shafts(left.force, order, planes[:, 0], places))
    against = couple_of(left) if pair.against == "couple" else left
    names = tuple(f"{turns}.plane_{n}" for turns in (f"+{order}", f"-{order}") for n in (1, 2))
    return _Named(names, two_plane_shafts(against, order, planes, places, middle))
