"""Counterweights and balance shafts of a machine: those of its file, and those solved for."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from functools import reduce
from itertools import combinations
from typing import ClassVar, NamedTuple

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.checks import StageResult
from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.axial import AxialPlaces, throw_positions
from cranktrain.layout.frames import Frames
from cranktrain.layout.specs import MAIN, ShaftSpec
from cranktrain.layout.throws import ShaftCentres, Throws
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import ComplexArray, phasor
from cranktrain.numerics.plane_vectors import PlaneVectors, reversed_vectors, running_axes
from cranktrain.quantities import Given
from cranktrain.questions.balance.counterweights import middle_of, share_of, two_plane_counterweights
from cranktrain.questions.balance.frame_forces import FrameForces
from cranktrain.questions.balance.rotating_weights import RotatingWeights, joined, on_crank
from cranktrain.questions.balance.shafts import couple_of, lanchester_shafts, two_plane_shafts
from cranktrain.questions.balance.spec import BalanceShaftsSpec, BalanceSpec, Spot, WeightSpec
from cranktrain.questions.balance.unit_shaking import Shaking, gross, shaking, with_weights
from cranktrain.record import record
from cranktrain.references import THEORY_OF_BALANCE as _THEORY

_WEIGHT = ("weight",)
_NOISE = 1e-12
"""Of what all parts could do together: less is rounding."""


@record
class DeclaredBalance:
    """The table [balance] of each design, and where its weights stand.

    Attributes
    ----------
    specs : tuple of BalanceSpec, one for each design
    angle : Array, shape (design, weight)
        Of the given weights, ahead of throw 1 in the normal sense. [rad]
    position : Array, shape (design, weight)
        z along the shaft; NaN where the file does not say. [m]
    """

    needs: ClassVar[str] = N_("[balance]")

    specs: tuple[BalanceSpec, ...]
    angle: Array
    position: Array


def declared_balance(
    given: tuple[BalanceSpec, ...], shafts: Sequence[Mapping[str, ShaftSpec]]
) -> DeclaredBalance | None:
    """Put the tables to the throws; None where there is no table."""
    if not given:
        return None
    each = [(spec.weight, design[MAIN]) for spec, design in zip(given, shafts, strict=True)]
    return DeclaredBalance(
        given,
        np.array([[_angle_on(weight, main) for weight in weights] for weights, main in each]),
        np.array([[_position_on(weight, main) for weight in weights] for weights, main in each]),
    )


def balance_problems(spec: BalanceSpec, main: ShaftSpec) -> Iterator[Problem]:
    """Find weights on throws that there are not, and couples where nothing says how far throws are apart."""
    n_throws = len(main.throws)
    allowed = _("must be one of the throws of the shaft `main`, 1 to {n}").format(n=n_throws)
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


def _cancelled(spec: BalanceSpec, main: ShaftSpec) -> Iterator[Problem]:
    """Find weights on one throw that do nothing together, as one of them stands on the wrong side."""
    on_throws = [
        (i, weight, weight.mass.si * weight.radius.si * np.exp(1j * _angle_on(weight, main)))
        for i, weight in enumerate(spec.weight)
        if weight.throw is not None and weight.throw <= len(main.throws)
    ]
    for (i, one, moment), (j, other, against) in combinations(on_throws, 2):
        if one.throw == other.throw and abs(moment + against) <= _NOISE * abs(moment):
            allowed = _("stands opposite balance.weight[{i}] on throw {throw}: together they balance nothing")
            repair = _("leave one of them out, or put it where it is to be")
            yield Problem(f"balance.weight[{j}]", None, allowed.format(i=i, throw=one.throw), repair)


def _angle_on(weight: WeightSpec, main: ShaftSpec) -> float:
    """Where a weight stands ahead of throw 1: opposite its throw unless given. [rad]"""
    if weight.angle is not None:
        return weight.angle.si
    return main.throws[(weight.throw or 1) - 1].si - main.throws[0].si + np.pi


def _position_on(weight: WeightSpec, main: ShaftSpec) -> float:
    """Where a weight stands along the shaft: at its throw unless given; NaN where nothing says where that is. [m]"""
    if weight.z is not None:
        return weight.z.si
    positions = throw_positions(main)
    return np.nan if positions is None else float(positions[(weight.throw or 1) - 1])


@record
class BalanceWeights(StageResult):
    """Weights that balance the machine, given and solved for."""

    balance_weight_moment: Array = quantity(
        "u", "kg*m", _WEIGHT, N_("Mass times radius of the balance weight"), _THEORY
    )
    balance_weight_angle: Array = quantity(
        "ψ",
        "rad",
        _WEIGHT,
        N_("Where the balance weight stands at crank angle 0 of throw 1, ahead of throw 1 in the normal sense"),
        _THEORY,
    )
    balance_weight_position: Array = quantity(
        "z_u", "m", _WEIGHT, N_("Along the shaft, from throw 1 toward the flywheel"), _THEORY
    )
    balance_weight_ratio: Array = quantity(
        "κ", "1", _WEIGHT, N_("Turns of the balance weight for one of the crank; less than 0 against it"), _THEORY
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
    """Place the weights that are given, then counterweights, then shafts against what all these leave."""
    n_designs, n_mechanisms = frame.force.shape[:2]
    position = np.full((n_designs, n_mechanisms), np.nan) if axial is None else axial.value
    middle = np.zeros(n_designs) if axial is None else axial.mid_plane
    before = shaking(frame.vectors, position, middle)
    lots = [_given(declared, frames)]
    if declared.specs[0].counterweights is not None:
        place = np.zeros((n_designs, n_mechanisms), dtype=complex) if centres is None else centres.value
        centre = running_axes(place, clockwise=frames.clockwise)
        lots += _counterweights(declared, frame, frames, throws, position=position, middle=middle, centre=centre)
    for pair in range(len(declared.specs[0].shafts)):
        left = reduce(lambda one, lot: with_weights(one, lot.weights, middle), lots, before)
        lots.append(_shafts([spec.shafts[pair] for spec in declared.specs], left, middle, frames))
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


def _si(values: Sequence[Sequence[Given]]) -> Array:
    """SI values of designs, shape (design, n)."""
    return np.array([[value.si for value in design] for design in values])


def _given(declared: DeclaredBalance, frames: Frames) -> _Named:
    """Weights of the file."""
    each = [spec.weight for spec in declared.specs]
    return _Named(
        tuple(_("given {n}").format(n=i + 1) for i in range(len(each[0]))),
        RotatingWeights(
            ratio=np.array([[float(one.ratio) for one in weights] for weights in each]),
            moment=np.array([[one.mass.si * one.radius.si for one in weights] for weights in each]),
            angle=frames.first[:, np.newaxis] + frames.running * declared.angle,
            position=declared.position,
            place=_places([[one.place for one in weights] for weights in each], frames),
        ),
    )


def _places(spots: Sequence[Sequence[Spot]], frames: Frames) -> ComplexArray:
    """Where something lies, in the common axes, shape (design, n). [m]"""
    across = np.array([[complex(x.si, y.si) for x, y in design] for design in spots], dtype=np.complex128)
    return running_axes(across, clockwise=frames.clockwise)


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

    position, middle: z of the mechanisms, and the mid-plane [m]; centre: of their shafts, in the common axes [m].
    """
    spec = declared.specs[0]
    share = np.array([0.0 if one.share is None else one.share.si for one in declared.specs])
    z = position[:, throws.first]
    for shaft in dict.fromkeys(throws.shafts):
        own = [i for i, name in enumerate(throws.shafts) if name == shaft]
        sense = float(frames.sense[throws.first[own[0]]])
        all_of = PlaneVectors(frame.vectors.order, *(throws.gathered(part)[:, own] for part in frame.vectors[1:]))
        shaking_own = all_of if sense > 0 else reversed_vectors(all_of)
        rotating, swinging = (throws.gathered(part)[:, own, 0] for part in _divided(frame, frames))
        if spec.planes is None:
            part = _part(spec, rotating, swinging, shaking_own, share[:, np.newaxis])
            lot = on_crank(-part, z[:, own])
            names = [_("throw {throw}").format(throw=throws.names[i]) for i in own]
        else:
            arm = z[:, own] - middle[:, np.newaxis]
            total = shaking(shaking_own, z[:, own], middle)
            force = _part(spec, np.sum(rotating, axis=-1), np.sum(swinging, axis=-1), total.force, share)
            couple = _part(spec, np.sum(arm * rotating, axis=-1), np.sum(arm * swinging, axis=-1), total.couple, share)
            planes = _si([one.planes for one in declared.specs if one.planes is not None])
            lot = two_plane_counterweights(force, couple, planes, middle)
            named = _("plane {n}") if shaft == MAIN else _("{shaft}, plane {n}")
            names = [named.format(n=n, shaft=shaft) for n in (1, 2)]
        shape = np.shape(lot.moment)
        place = np.broadcast_to(centre[:, throws.first[own[0]], np.newaxis], shape)
        yield _Named(tuple(names), lot._replace(ratio=np.full(shape, sense), angle=sense * lot.angle, place=place))


def _divided(frame: FrameForces, frames: Frames) -> tuple[ComplexArray, ComplexArray]:
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
    spec: BalanceSpec, rotating: ComplexArray, swinging: ComplexArray, all_of: PlaneVectors, share: Array
) -> ComplexArray:
    """What counterweights take away, of force or couple."""
    if spec.counterweights == "least_force":
        return middle_of(all_of)
    return share_of(rotating, swinging, share)


def _shafts(pairs: Sequence[BalanceShaftsSpec], left: Shaking, middle: Array, frames: Frames) -> _Named:
    """One pair of balance shafts, against what is left of its order."""
    pair, order = pairs[0], pairs[0].order
    places = _places([(one.forward, one.backward) for one in pairs], frames)
    given = [one.planes for one in pairs if one.planes is not None]
    planes = _si(given) if given else middle[:, np.newaxis]
    if pair.against == "force":
        return _Named((f"+{order}", f"−{order}"), lanchester_shafts(left.force, order, planes[:, 0], places))
    against = couple_of(left) if pair.against == "couple" else left
    names = tuple(
        _("{turns}, plane {n}").format(turns=turns, n=n) for turns in (f"+{order}", f"−{order}") for n in (1, 2)
    )
    return _Named(names, two_plane_shafts(against, order, planes, places, middle))
