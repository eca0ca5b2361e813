"""Opposed pistons: lead, volumetric dead centres and the travel of both pistons of a cylinder together."""

import numpy as np

from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Pistons
from cranktrain.layout.speed import Speed, rates
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import DERIVATIVES_LIMIT, around_zero, derivatives_residual
from cranktrain.questions.cylinders.travel import CylinderPistons, CylinderTravel, reach
from cranktrain.questions.motion.dead_centres import DeadCentres
from cranktrain.record import record
from cranktrain.references import THEORY_OF_OPPOSED_PISTONS as _THEORY
from cranktrain.saying.catalogue import coefficients, quantity
from cranktrain.saying.checks import Check, Checked

_CYLINDER = ("cylinder",)
_CURVE = ("cylinder", "crank_angle")


@record
class VolumetricDeadCentres:
    """Where the room between two pistons is least and greatest, and by how much they part."""

    lead: Array = quantity(
        "Δ", "deg", _CYLINDER, N_("By how much the exhaust crank is ahead of the scavenge crank"), _THEORY, "18.8"
    )
    combined_stroke: Array = quantity(
        "S_Σ",
        "m",
        _CYLINDER,
        N_("By how much both pistons together part, between the volumetric dead centres"),
        _THEORY,
        "18.2",
    )
    nominal_stroke: Array = quantity(
        "S_e + S_s", "m", _CYLINDER, N_("Sum of both pistons' own strokes, as makers publish it"), _THEORY, "18.10"
    )
    inner_volumetric_dead_centre: Array = quantity(
        "φ_i", "deg", _CYLINDER, N_("Crank angle of the least volume"), _THEORY, "18.1", is_place=True
    )
    outer_volumetric_dead_centre: Array = quantity(
        "φ_o", "deg", _CYLINDER, N_("Crank angle of the greatest volume"), _THEORY, "18.1", is_place=True
    )
    inner_volumetric_shift: Array = quantity(
        "α_i",
        "deg",
        _CYLINDER,
        N_("Least volume after the exhaust crank's inner dead centre; the texts say Δ/2"),
        _THEORY,
        "18.1",
    )
    outer_volumetric_shift: Array = quantity(
        "α_o − π",
        "deg",
        _CYLINDER,
        N_("Greatest volume after the exhaust crank's outer dead centre; the texts say Δ/2"),
        _THEORY,
        "18.1",
    )
    least_combined_travel: Array = quantity(
        "σ_i",
        "m",
        _CYLINDER,
        N_("How far both pistons together stand from their own inner dead centres at φ_i"),
        _THEORY,
        "18.1",
    )


def are_opposed(cylinders: CylinderPistons) -> bool:
    """Whether some cylinder at least has two pistons."""
    return bool(np.any(cylinders.is_opposed))


def volumetric_dead_centres(
    cylinders: CylinderPistons,
    pistons: Pistons,
    dead_centres: DeadCentres,
    travel: CylinderTravel,
    crank_angle: CrankAngle,
) -> VolumetricDeadCentres:
    """Volumetric dead centres of every cylinder; docs/theory/opposed-pistons, eqs. (18.1) and (18.2)."""
    # A piston with side rods stands innermost where it is nearest to its shaft.
    innermost = pistons.nominal_top[:, cylinders.index, 0] + np.where(cylinders.signs < 0, np.pi, 0.0)
    strokes = dead_centres.stroke[:, cylinders.index] * np.abs(cylinders.signs)
    own = np.where(cylinders.signs < 0, -dead_centres.bottom_position[:, cylinders.index], 0.0) + np.where(
        cylinders.signs > 0, dead_centres.top_position[:, cylinders.index], 0.0
    )
    lead = around_zero(innermost[..., 1] - innermost[..., 0])
    return VolumetricDeadCentres(
        lead=np.where(cylinders.is_opposed, lead, np.nan),
        combined_stroke=travel.stroke,
        nominal_stroke=np.sum(strokes, axis=-1),
        inner_volumetric_dead_centre=crank_angle.counted(travel.inner[..., np.newaxis])[..., 0],
        outer_volumetric_dead_centre=crank_angle.counted(travel.outer[..., np.newaxis])[..., 0],
        inner_volumetric_shift=around_zero(travel.inner - innermost[..., 0]),
        outer_volumetric_shift=around_zero(travel.outer - innermost[..., 0] - np.pi),
        least_combined_travel=np.sum(own, axis=-1) - travel.reach,
    )


@record
class CombinedMotion(Checked):
    """How the pistons of a cylinder part, both together: as one piston would that sweeps the same volume."""

    combined_displacement: Coefficient = coefficients(
        "x_Σ",
        "m",
        _CURVE,
        N_("By how much both pistons have parted since the inner volumetric dead centre"),
        N_("Velocity at which they part for each rad/s of the crank"),
        N_("Acceleration at which they part for each (rad/s)² of the crank"),
        _THEORY,
        "18.1",
    )


def combined_motion(
    cylinders: CylinderPistons, pistons: Pistons, travel: CylinderTravel, crank_angle: CrankAngle
) -> CombinedMotion:
    """Travel of both pistons together and its derivatives by the crank angle."""
    reached = reach(cylinders, pistons, crank_angle.angle)
    residual = derivatives_residual(lambda phi: reach(cylinders, pistons, phi))
    return CombinedMotion(
        Coefficient(travel.reach[..., np.newaxis] - reached.value, -reached.first, -reached.second),
        checks=(
            Check(
                "combined_derivatives",
                _("x_Σ′ and x_Σ″ against the derivatives of the Fourier series, relative to their peaks"),
                np.max(residual, axis=(1, 2)),
                DERIVATIVES_LIMIT,
            ),
        ),
    )


@record
class CombinedSpeeds:
    """Velocity and acceleration at which opposed pistons part."""

    combined_velocity: Array = quantity(
        "v_Σ", "m/s", _CURVE, N_("Velocity at which both pistons part"), _THEORY, "18.10"
    )
    combined_acceleration: Array = quantity(
        "j_Σ", "m/s^2", _CURVE, N_("Acceleration at which both pistons part"), _THEORY, "18.10"
    )


def combined_speeds(motion: CombinedMotion, speed: Speed, crank_angle: CrankAngle) -> CombinedSpeeds:
    """Velocities q′ω and accelerations q″ω² + q′ε."""
    return CombinedSpeeds(*rates(motion.combined_displacement, speed.drive(crank_angle.angle)))
