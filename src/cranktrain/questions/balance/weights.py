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
from cranktrain.questions.balance.counterweights import counterweights, middle_of, share_of, two_plane_counterweights
from cranktrain.questions.balance.frame_forces import FrameForces
from cranktrain.questions.balance.rotating_weights import RotatingWeights, joined
from cranktrain.questions.balance.shafts import ShaftPlaces, couple_of, lanchester_shafts, two_plane_shafts
from cranktrain.questions.balance.spec import BalanceShaftsSpec, BalanceSpec, WeightSpec
from cranktrain.questions.balance.unit_shaking import Shaking, gross, shaking, with_weights
from cranktrain.record import record

_WEIGHT = ("weight",)
_THEORY = "docs/theory/balance"
_NOISE = 1e-12
"""Of what all parts could do together: less is rounding."""


@record
class DeclaredBalance:
    """The table [balance] of each design, and the throws of `main`, to which its weights are put.

    Attributes
    ----------
    specs : tuple of BalanceSpec, one for each design
    throw_angle : Array, shape (design, throw)
        Of all throws of `main`, ahead of throw 1 in the normal sense. [rad]
    throw_position : Array, shape (design, throw)
        z of all throws of `main`; NaN where the file does not say. [m]
    """

    needs: ClassVar[str] = N_("[balance]")

    specs: tuple[BalanceSpec, ...]
    throw_angle: Array
    throw_position: Array


def declared_balance(
    given: tuple[BalanceSpec, ...], shafts: Sequence[Mapping[str, ShaftSpec]]
) -> DeclaredBalance | None:
    """Put the tables to the throws; None where there is no table."""
    if not given:
        return None
    mains = [design[MAIN] for design in shafts]
    return DeclaredBalance(
        given,
        np.array([[throw.si - main.throws[0].si for throw in main.throws] for main in mains]),
        np.array([np.full(len(main.throws), np.nan) if (z := throw_positions(main)) is None else z for main in mains]),
    )


def balance_problems(spec: BalanceSpec, main: ShaftSpec) -> tuple[Problem, ...]:
    """Find weights on throws that there are not, and couples where nothing says how far throws are apart."""
    n_throws = len(main.throws)
    allowed = _("must be one of the throws of the shaft `main`, 1 to {n}").format(n=n_throws)
    found = [
        Problem(f"balance.weight[{i}].throw", str(weight.throw), allowed)
        for i, weight in enumerate(spec.weight)
        if weight.throw is not None and weight.throw > n_throws
    ]
    found += _cancelled(spec, main)
    if throw_positions(main) is None:
        unknown = _("needs [shaft.main] spacing, or couples along the shaft are not known")
        found += [
            Problem(f"balance.shafts[{i}].against", f'"{pair.against}"', unknown)
            for i, pair in enumerate(spec.shafts)
            if pair.against != "force"
        ]
        if spec.planes is not None:
            found.append(Problem("balance.planes", None, unknown))
    return tuple(found)


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
    """Where a weight on a throw stands ahead of throw 1: opposite the throw unless given. [rad]"""
    if weight.angle is not None:
        return weight.angle.si
    return main.throws[(weight.throw or 1) - 1].si - main.throws[0].si + np.pi


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
    lots = [*_given(declared, frames)]
    if declared.specs[0].counterweights is not None:
        place = np.zeros((n_designs, n_mechanisms), dtype=complex) if centres is None else centres.value
        centre = running_axes(place, clockwise=frames.clockwise)
        lots += _counterweights(declared, frame, frames, throws, _Along(position, middle, centre))
    for pair in range(len(declared.specs[0].shafts)):
        left = reduce(lambda one, lot: with_weights(one, lot.weights, middle), lots, before)
        lots.append(_shafts([spec.shafts[pair] for spec in declared.specs], left, middle, frames))
    names = tuple(name for lot in lots for name in lot.names)
    nothing = RotatingWeights(*np.zeros((6, n_designs, 0)))
    weights = _without_noise(joined(nothing, *(lot.weights for lot in lots)), frame)
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


def _given(declared: DeclaredBalance, frames: Frames) -> Iterator[_Named]:
    """Weights of the file, each a lot of its own."""
    for i in range(len(declared.specs[0].weight)):
        of = [spec.weight[i] for spec in declared.specs]
        throw, ratio = of[0].throw, of[0].ratio
        if throw is not None:
            position = declared.throw_position[:, throw - 1]
            ahead = [_ahead(one, float(at)) for one, at in zip(of, declared.throw_angle[:, throw - 1], strict=True)]
        else:
            position = np.array([0.0 if one.z is None else one.z.si for one in of])
            ahead = [_ahead(one, 0.0) for one in of]
        place = running_axes(_complex_places([one.place for one in of]), clockwise=frames.clockwise)
        weights = RotatingWeights(
            ratio=np.full(len(of), float(ratio)),
            moment=np.array([one.mass.si * one.radius.si for one in of]),
            angle=frames.first + frames.running * np.array(ahead),
            position=position,
            x=place.real,
            y=place.imag,
        )
        yield _Named((_("given {n}").format(n=i + 1),), RotatingWeights(*(part[:, np.newaxis] for part in weights)))


def _ahead(weight: WeightSpec, throw_angle: float) -> float:
    """Where a weight stands at φ = 0, ahead of throw 1 in the normal sense: opposite its throw unless given. [rad]"""
    return throw_angle + np.pi if weight.angle is None else weight.angle.si


def _complex_places(places: Sequence[Sequence[Given]]) -> ComplexArray:
    """X + iY of where something lies, shape (design,)."""
    across = _si(places)
    return np.asarray(across[:, 0] + 1j * across[:, 1])


class _Along(NamedTuple):
    """Where the mechanisms stand: z and mid-plane [m], and the centres of their shafts in the common axes [m]."""

    position: Array
    middle: Array
    centre: ComplexArray


def _counterweights(
    declared: DeclaredBalance, frame: FrameForces, frames: Frames, throws: Throws, along: _Along
) -> Iterator[_Named]:
    """Counterweights of every shaft, each seen as its own crank turns."""
    spec = declared.specs[0]
    share = np.array([0.0 if one.share is None else one.share.si for one in declared.specs])
    z = along.position[:, throws.first]
    for shaft in dict.fromkeys(throws.shafts):
        own = [i for i, name in enumerate(throws.shafts) if name == shaft]
        sense = float(frames.sense[throws.first[own[0]]])
        all_of = PlaneVectors(frame.vectors.order, *(throws.gathered(part)[:, own] for part in frame.vectors[1:]))
        shaking_own = all_of if sense > 0 else reversed_vectors(all_of)
        rotating, swinging = (throws.gathered(part)[:, own, 0] for part in _divided(frame, frames))
        if spec.planes is None:
            part = _part(spec, rotating, swinging, shaking_own, share[:, np.newaxis])
            lot = counterweights(part, z[:, own])
            names = [_("throw {throw}").format(throw=throws.names[i]) for i in own]
        else:
            arm = z[:, own] - along.middle[:, np.newaxis]
            total = shaking(shaking_own, z[:, own], along.middle)
            force = _part(spec, np.sum(rotating, axis=-1), np.sum(swinging, axis=-1), total.force, share)
            couple = _part(spec, np.sum(arm * rotating, axis=-1), np.sum(arm * swinging, axis=-1), total.couple, share)
            planes = _si([one.planes for one in declared.specs if one.planes is not None])
            lot = two_plane_counterweights(force, couple, planes, along.middle)
            named = _("plane {n}") if shaft == MAIN else _("{shaft}, plane {n}")
            names = [named.format(n=n, shaft=shaft) for n in (1, 2)]
        centre = along.centre[:, throws.first[own[0]], np.newaxis]
        shape = np.shape(lot.moment)
        yield _Named(
            tuple(names),
            lot._replace(
                ratio=np.full(shape, sense),
                angle=sense * lot.angle,
                x=np.broadcast_to(centre.real, shape),
                y=np.broadcast_to(centre.imag, shape),
            ),
        )


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
    one = swinging[..., np.newaxis]
    return share_of(rotating, PlaneVectors(np.ones(1), one, np.zeros_like(one)), share)


def _shafts(pairs: Sequence[BalanceShaftsSpec], left: Shaking, middle: Array, frames: Frames) -> _Named:
    """One pair of balance shafts, against what is left of its order."""
    pair, order = pairs[0], pairs[0].order
    places = ShaftPlaces(
        running_axes(_complex_places([one.forward for one in pairs]), clockwise=frames.clockwise),
        running_axes(_complex_places([one.backward for one in pairs]), clockwise=frames.clockwise),
    )
    given = [one.planes for one in pairs if one.planes is not None]
    planes = _si(given) if given else middle[:, np.newaxis]
    if pair.against == "force":
        return _Named((f"+{order}", f"−{order}"), lanchester_shafts(left.force, order, planes[:, 0], places))
    against = couple_of(left) if pair.against == "couple" else left
    names = tuple(
        _("{turns}, plane {n}").format(turns=turns, n=n) for turns in (f"+{order}", f"−{order}") for n in (1, 2)
    )
    return _Named(names, two_plane_shafts(against, order, planes, places, middle))
