"""The sources' forms beside the exact motion: the same curves by each method, their largest errors, their ranges."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.engine.layout import CrankAngle, Group, Pistons, distinct
from cranktrain.engine.motion import PistonMotion
from cranktrain.language import N_, _
from cranktrain.mechanisms.articulated_rod import ArticulatedRod
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extreme, largest, smallest, turn_grid
from cranktrain.textbook.articulated_rod import derived, own_top_distance, reconstructed, slave_displacement
from cranktrain.textbook.ranges import RANGES
from cranktrain.textbook.steam_engine import brix, infinite_rod, two_harmonics
from cranktrain.wording import Names, number, ranged

_CURVE = ("method", "piston", "crank_angle")
_FACT = ("method", "piston")
_THEORY = "docs/theory/textbook-forms"

Form = Callable[[Array, Any], Coefficient]
"""A source's form: from the kernel's crank angle and geometry to the displacement from its own top."""


def _by_ratio(form: Callable[[Array, Array, Array], Coefficient]) -> Form:
    """Take λ = R/L from the geometry; the sources' forms know no offset."""

    def from_geometry(angle: Array, geometry: SliderCrank) -> Coefficient:
        return form(angle, geometry.crank_radius, geometry.crank_radius / geometry.rod_length)

    return from_geometry


def _infinite(angle: Array, geometry: SliderCrank) -> Coefficient:
    """Infinitely long rod, (334)."""
    return infinite_rod(angle, geometry.crank_radius)


def _slave(constants: Callable[[ArticulatedRod], Any]) -> Form:
    """Displacement by (I.13) from the curve's own top."""

    def from_geometry(angle: Array, geometry: ArticulatedRod) -> Coefficient:
        harmonics = constants(geometry)
        return slave_displacement(angle, geometry, harmonics, own_top_distance(geometry, harmonics))

    return from_geometry


FORMS: Mapping[str, Mapping[str, Form]] = {
    "infinite_rod": {"slider_crank": _infinite},
    "two_harmonics": {"slider_crank": _by_ratio(two_harmonics)},
    "brix": {"slider_crank": _by_ratio(brix)},
    "derived": {"articulated_rod": _slave(derived)},
    "reconstructed": {"articulated_rod": _slave(reconstructed)},
}
"""The sources' forms by method, and for each the kinds of mechanism that it speaks of."""


@dataclass(frozen=True)
class TextbookMotion:
    """Motion of every piston by each method, `exact` first; NaN where a source has no form for the mechanism."""

    displacement_by_method: Array = quantity(
        "x", "m", _CURVE, N_("Piston displacement by each method, from the method's own top"), _THEORY
    )
    velocity_coefficient_by_method: Array = quantity(
        "x′", "m/rad", _CURVE, N_("Piston velocity for each rad/s of the crank, by each method"), _THEORY
    )
    acceleration_coefficient_by_method: Array = quantity(
        "x″", "m/rad^2", _CURVE, N_("Piston acceleration for each (rad/s)² of the crank, by each method"), _THEORY
    )
    displacement_error: Array = quantity(
        "Δx", "1", _FACT, N_("Largest error of the method's displacement, in parts of the stroke"), _THEORY
    )
    displacement_error_at: Array = quantity(
        "φ(Δx)", "deg", _FACT, N_("Crank angle of the largest error of displacement"), _THEORY
    )
    velocity_error: Array = quantity(
        "Δv", "1", _FACT, N_("Largest error of the method's velocity, in parts of the exact peak"), _THEORY
    )
    velocity_error_at: Array = quantity(
        "φ(Δv)", "deg", _FACT, N_("Crank angle of the largest error of velocity"), _THEORY
    )
    acceleration_error: Array = quantity(
        "Δj", "1", _FACT, N_("Largest error of the method's acceleration, in parts of the exact peak"), _THEORY
    )
    acceleration_error_at: Array = quantity(
        "φ(Δj)", "deg", _FACT, N_("Crank angle of the largest error of acceleration"), _THEORY
    )
    flags: tuple[str, ...] = ()
    labels: Mapping[str, tuple[str, ...]] = field(default_factory=lambda: {"method": ("exact", *FORMS)})

    def answer(self, names: Names, design: int) -> str | None:
        """Say how far the forms that textbooks use most are off."""
        said = [
            _("{form} is off by up to {x} of the stroke, {v} in velocity, {j} in acceleration").format(
                form=form,
                x=number(float(np.nanmax(self.displacement_error[design, index])), "%"),
                v=number(float(np.nanmax(self.velocity_error[design, index])), "%"),
                j=number(float(np.nanmax(self.acceleration_error[design, index])), "%"),
            )
            for method, form in (
                ("two_harmonics", _("two harmonics (333)–(337)")),
                ("reconstructed", _("(I.13), reconstructed,")),
            )
            if not np.all(np.isnan(self.displacement_error[design, (index := names["method"].index(method))]))
        ]
        return _("Textbook: {forms}.").format(forms="; ".join(said)) if said else None


def textbook_motion(pistons: Pistons, crank_angle: CrankAngle, motion: PistonMotion) -> TextbookMotion:
    """Motion of every piston by every method, and each method's largest errors, refined on the kernels."""
    exact = (
        motion.piston_displacement,
        motion.piston_velocity_coefficient,
        motion.piston_acceleration_coefficient,
    )
    n_designs, n_pistons, n_angles = exact[0].shape
    n_methods = 1 + len(FORMS)
    curves = np.full((3, n_designs, n_methods, n_pistons, n_angles), np.nan)
    errors, angles = np.full((2, 3, n_designs, n_methods, n_pistons), np.nan)
    curves[:, :, 0] = exact
    errors[:, :, 0] = 0.0
    different = distinct(pistons)
    for method, forms in enumerate(FORMS.values(), start=1):
        for group, alike in zip(pistons.groups, different.mechanisms.groups, strict=True):
            if group.kind.name not in forms:
                continue
            form, members = forms[group.kind.name], group.members
            for curve, values in zip(curves, form(crank_angle.angle + members.phase, members.geometry), strict=True):
                curve[:, method, group.index] = values
            origin = different.origin[:, group.index] - alike.index[0]
            worst = _largest_errors(form, alike)
            errors[:, :, method, group.index] = worst.value[:, origin, 0]
            phi = worst.angle[:, origin] + pistons.nominal_top[:, group.index]
            angles[:, :, method, group.index] = crank_angle.counted(phi)[..., 0]
    return TextbookMotion(
        displacement_by_method=curves[0],
        velocity_coefficient_by_method=curves[1],
        acceleration_coefficient_by_method=curves[2],
        displacement_error=errors[0],
        displacement_error_at=angles[0],
        velocity_error=errors[1],
        velocity_error_at=angles[1],
        acceleration_error=errors[2],
        acceleration_error_at=angles[2],
        flags=_flags(pistons),
    )


def _largest_errors(form: Form, group: Group) -> Extreme:
    """Largest error of displacement, velocity and acceleration, and own crank angle there, shape (3, member, 1).

    Displacement in parts of the exact stroke, the others of their exact peak.
    """
    members = group.members

    def slider(alpha: Array) -> Coefficient:
        return group.kind.motion(alpha + members.phase, members.geometry).slider

    def error(alpha: Array) -> Array:
        own, exact = form(alpha + members.phase, members.geometry), slider(alpha)
        return np.abs(
            _each_order(
                Coefficient(own.value - (top - exact.value), own.first + exact.first, own.second + exact.second)
            )
        )

    sampled = slider(turn_grid())
    most = largest(lambda alpha: _each_order(slider(alpha)), samples=np.concatenate(sampled))
    least = smallest(lambda alpha: _each_order(slider(alpha)), samples=np.concatenate(sampled))
    top = most.value[:1]
    peak = np.concatenate([top - least.value[:1], np.maximum(most.value, -least.value)[1:]])
    worst = largest(error)
    return Extreme(worst.angle, worst.value / peak)


def _each_order(motion: Coefficient) -> Array:
    """Value, first and second derivative of each member, shape (3, member, n), each at its own row of angles."""
    return np.stack([part[min(order, len(part) - 1)] for order, part in enumerate(motion)])


def _flags(pistons: Pistons) -> tuple[str, ...]:
    """Say which methods are outside their source's range, for which pistons, and what the source says."""
    flags: list[str] = []
    for one in RANGES:
        for group in pistons.groups:
            if group.kind.name not in FORMS[one.method]:
                continue
            geometry = group.members.geometry
            plain = getattr(geometry, "master", geometry)
            outside = one.outside(plain.crank_radius / plain.rod_length, plain.offset)[..., 0]
            members = np.flatnonzero(np.any(outside, axis=0)).tolist()
            if members:
                flags.append(
                    _(
                        "{method} {equations} is outside its source's range ({condition}) for {pistons} [{source}]"
                    ).format(
                        method=_(one.name),
                        equations=", ".join(one.equations),
                        condition=_(one.condition),
                        pistons=ranged(group.members.names, members),
                        source=one.source,
                    )
                )
    return tuple(flags)
