"""The sources' forms beside the exact motion: the same curves by each method, their largest errors, their ranges."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from cranktrain.grouping import grouped
from cranktrain.language import N_, Listed, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Batch, Pistons
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extreme, Extremes, largest, turn_grid
from cranktrain.questions.cylinders.opposed import VolumetricDeadCentres
from cranktrain.questions.cylinders.travel import CylinderPistons
from cranktrain.questions.motion.dead_centres import PistonTurn
from cranktrain.questions.motion.pistons import PistonMotion
from cranktrain.record import record
from cranktrain.saying.catalogue import coefficients, extreme
from cranktrain.saying.checks import Flagged
from cranktrain.saying.wording import all_of, ranged
from cranktrain.texts.leads import lead_flags
from cranktrain.texts.plain_cranks import PLAIN, own_angle, plain_crank
from cranktrain.texts.ranges import RANGES, Range
from cranktrain.texts.steam_engine import brix, infinite_rod, two_harmonics

if TYPE_CHECKING:
    from cranktrain.mechanisms.articulated_rod import ArticulatedRod
    from cranktrain.mechanisms.eccentric import Eccentric
    from cranktrain.mechanisms.slider_crank import SliderCrank

_FACT = ("motion_method", "piston")
_THEORY = "docs/theory/textbook-forms"

Curve = Callable[[Array], Coefficient]
Form = Callable[[Any], Curve]
"""A source's form: from a kernel's geometry to the displacement from the form's own top by the kernel's angle."""


def _by_ratio(form: Callable[[Array, Array, Array], Coefficient]) -> Mapping[str, Form]:
    """Take λ = R/L from the geometry, of an eccentric e/l; the sources' forms know no offset."""

    def of(geometry: "SliderCrank | Eccentric") -> Curve:
        radius, rod, _offset = plain_crank(geometry)
        return lambda angle: form(own_angle(angle, geometry), radius, radius / rod)

    return dict.fromkeys(PLAIN, of)


def _infinite(angle: Array, crank_radius: Array, _ratio: Array) -> Coefficient:
    """Infinitely long rod, (334)."""
    return infinite_rod(angle, crank_radius)


def _slave(constants: str) -> Form:
    """Displacement by (I.13) from the curve's own top, with constants by one of the ways of its text."""

    def of(geometry: "ArticulatedRod") -> Curve:
        from cranktrain.texts import articulated_rod as text  # for engines that have slaves

        harmonics = {"derived": text.derived, "reconstructed": text.reconstructed}[constants](geometry)
        top = text.own_top_distance(geometry, harmonics)
        return lambda angle: text.slave_displacement(angle, geometry, harmonics, top)

    return of


FORMS: Mapping[str, Mapping[str, Form]] = {
    "infinite_rod": _by_ratio(_infinite),
    "two_harmonics": _by_ratio(two_harmonics),
    "brix": _by_ratio(brix),
    "derived": {"articulated_rod": _slave("derived")},
    "reconstructed": {"articulated_rod": _slave("reconstructed")},
}
"""The sources' forms by method, and for each the kinds of mechanism that it speaks of."""


@record
class TextbookMotion(Flagged):
    """Motion of every piston by each method, `exact` first; NaN where a source has no form for the mechanism."""

    displacement_by_method: Coefficient = coefficients(
        "x",
        "m",
        ("motion_method", "piston", "crank_angle"),
        N_("Piston displacement by each method, from the method's own top"),
        N_("Piston velocity for each rad/s of the crank, by each method"),
        N_("Piston acceleration for each (rad/s)² of the crank, by each method"),
        _THEORY,
        "6.1 to 6.25",
    )
    displacement_error: Extreme = extreme(
        "Δx",
        "1",
        _FACT,
        N_("Largest error of the method's displacement, in parts of the stroke"),
        N_("Crank angle of the largest error of displacement"),
        _THEORY,
        "6.1 to 6.25",
    )
    velocity_error: Extreme = extreme(
        "Δv",
        "1",
        _FACT,
        N_("Largest error of the method's velocity, in parts of the exact peak"),
        N_("Crank angle of the largest error of velocity"),
        _THEORY,
        "6.1 to 6.25",
    )
    acceleration_error: Extreme = extreme(
        "Δj",
        "1",
        _FACT,
        N_("Largest error of the method's acceleration, in parts of the exact peak"),
        N_("Crank angle of the largest error of acceleration"),
        _THEORY,
        "6.1 to 6.25",
    )


def textbook_motion(
    pistons: Pistons,
    crank_angle: CrankAngle,
    turn: PistonTurn,
    motion: PistonMotion,
    cylinders: CylinderPistons | None,
    opposed: VolumetricDeadCentres | None,
) -> TextbookMotion:
    """Motion of every piston by every method, and each method's largest errors, refined on the kernels."""
    exact = motion.piston_displacement
    n_designs, n_pistons, n_angles = exact.value.shape
    n_methods, n_turn = 1 + len(FORMS), crank_angle.first_turn.shape[-1]
    curves = np.full((3, n_designs, n_methods, n_pistons, n_angles // n_turn, n_turn), np.nan)
    errors, angles = np.full((2, 3, n_designs, n_methods, n_pistons), np.nan)
    curves[:, :, 0] = np.reshape(exact, (3, n_designs, n_pistons, -1, n_turn))
    errors[:, :, 0] = 0.0
    for batch, alike in zip(pistons.batches, turn.distinct.mechanisms.batches, strict=True):
        forms = {i: form[batch.kind.name] for i, form in enumerate(FORMS.values(), 1) if batch.kind.name in form}
        if not forms:
            continue
        members = batch.members
        for method, form in forms.items():
            own = form(members.geometry)(crank_angle.first_turn + members.phase)
            for curve, values in zip(curves, own, strict=True):
                curve[:, method, batch.index] = values[..., np.newaxis, :]
        samples = Coefficient(*(part[:, alike.index] for part in turn.samples.slider))
        peaks = Extremes(*(Extreme(*(part[:, :, alike.index] for part in one)) for one in turn.peaks))
        worst = _largest_errors(tuple(forms.values()), alike, samples, peaks)
        origin = turn.distinct.origin[:, batch.index] - alike.index[0]
        for row, method in enumerate(forms):
            errors[:, :, method, batch.index] = worst.value[row][:, 0, origin, 0]
            phi = worst.angle[row][:, 0, origin] + pistons.nominal_top[:, batch.index]
            angles[:, :, method, batch.index] = crank_angle.counted(phi)[..., 0]
    return TextbookMotion(
        Coefficient(*curves.reshape(3, n_designs, n_methods, n_pistons, n_angles)),
        *(Extreme(*one) for one in zip(angles, errors, strict=True)),
        labels={"motion_method": ("exact", *FORMS)},
        flags=(*_flags(pistons), *(lead_flags(cylinders.names, opposed.lead) if cylinders and opposed else ())),
    )


def _largest_errors(forms: Sequence[Form], batch: Batch, samples: Coefficient, peaks: Extremes) -> Extreme:
    """Largest errors of displacement, velocity and acceleration and own crank angles there, (form, 3, 1, member, 1).

    Displacement in parts of the exact stroke, the others of their exact peak. `samples` is the exact slider on
    `turn_grid()`, with its peaks.
    """
    members = batch.members
    curves = [form(members.geometry) for form in forms]

    def slider(alpha: Array) -> Coefficient:
        return batch.kind.motion(alpha + members.phase, members.geometry).slider

    low, high = peaks
    top = high.value[0]
    peak = np.concatenate([top[np.newaxis] - low.value[:1], np.maximum(high.value, -low.value)[1:]])

    def errors(alpha: Array, exact: Coefficient) -> Array:
        """Errors at angles that are the same for all, or at those that each form and order has of its own."""
        rows: list[Array] = []
        for form, curve in enumerate(curves):
            angle, true = (alpha, exact) if alpha.ndim == 1 else (alpha[form], Coefficient(*(x[form] for x in exact)))
            own = curve(angle + members.phase)
            off = Coefficient(own.value - (top - true.value), own.first + true.first, own.second + true.second)
            rows.append(np.abs(_own_rows(off)))
        return np.stack(rows)

    worst = largest(lambda alpha: errors(alpha, slider(alpha)), samples=errors(turn_grid(), samples))
    return Extreme(worst.angle, worst.value / np.where(peak > 0.0, peak, np.nan))


def _own_rows(motion: Coefficient) -> Array:
    """Value, first and second derivative, (3, 1, member, n), each at its own row of angles where they have rows."""
    return np.stack([part[order] if part.ndim == 4 else part for order, part in enumerate(motion)])


def _flags(pistons: Pistons) -> Iterator[Words]:
    """Say which methods are outside their source's range, for which pistons and why, and what the source says."""
    for one, batch in product(RANGES, pistons.batches):
        if batch.kind.name in FORMS[one.method]:
            reasons = _reasons(one, batch)
            if reasons:
                outside = [
                    _("{pistons}, as {reason}", pistons=ranged(batch.members.names, alike), reason=reason)
                    for reason, alike in reasons.items()
                ]
                yield _(
                    "{method} {equations} is outside its source's range ({condition}) for {pistons} [{source}]",
                    method=_(one.name),
                    equations=", ".join(one.equations),
                    condition=_(one.condition),
                    pistons=Listed(outside, "; "),
                    source=one.source,
                )


def _reasons(one: Range, batch: Batch) -> dict[Words, list[int]]:
    """Members of a batch that are outside a range, by the reason: that of the first design that is."""
    plain = getattr(batch.members.geometry, "master", batch.members.geometry)
    ratio, offset = (part[..., 0] for part in np.broadcast_arrays(plain.crank_radius / plain.rod_length, plain.offset))
    is_outside = one.outside(ratio, offset)
    first = np.argmax(is_outside, axis=0)
    return grouped(
        (all_of(list(one.reasons(float(ratio[design, member]), float(offset[design, member])))), member)
        for member, design in enumerate(first.tolist())
        if is_outside[design, member]
    )
