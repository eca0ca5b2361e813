"""Motion of the rods that pistons hang on: angles, with the pressure angle that is permitted; velocities."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.design import Designs
from cranktrain.layout.mechanisms import Pistons
from cranktrain.layout.speed import Speed, rates
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extreme, turning_points
from cranktrain.numerics.ties import first_largest
from cranktrain.numerics.tops import chosen
from cranktrain.questions.motion.dead_centres import PistonGrid, PistonTurn, slider_and_rod
from cranktrain.record import record
from cranktrain.references import THEORY_OF_GROUPS as _GROUPS
from cranktrain.references import THEORY_OF_SLIDER_CRANKS as _THEORY
from cranktrain.saying.catalogue import coefficients, extreme, quantity
from cranktrain.saying.checks import Flagged
from cranktrain.saying.wording import around_turn, number

_ROUNDING = 1e-9
"""A rod that was made for its limit may miss it by this part."""

_PISTON = ("piston",)
_CURVE = ("piston", "crank_angle")


@record
class PermissibleAngles:
    """Permissible pressure angle of every piston's rod, shape (design, piston); NaN for one without a limit. [rad]"""

    reads: ClassVar[tuple[str, ...]] = ("[mechanism]",)

    value: Array


def permissible_angles_of(designs: Designs) -> PermissibleAngles | None:
    """Collect the limits; None where there is none at all."""
    limits = [place.spec.pressure_angle_limit for place in designs.together.pistons]
    value = designs.by_design([np.nan if limit is None else limit.array for limit in limits])
    return None if np.all(np.isnan(value)) else PermissibleAngles(value)


def _exceeding(permissible: PermissibleAngles, largest: Extreme) -> Iterator[Words]:
    """Flag the rod whose pressure angle exceeds its limit the most, and where it does; of all designs the worst."""
    angle = np.abs(largest.value)
    excess = np.where(angle > permissible.value * (1 + _ROUNDING), angle - permissible.value, 0.0)
    if not np.any(excess > 0.0):
        return
    worst = np.unravel_index(first_largest(excess), excess.shape)
    said = _("The rod's pressure angle comes to {angle} (crank at {crank}), {excess} over the permissible {limit}.")
    yield said.format(
        angle=number(float(angle[worst]), "deg"),
        crank=number(float(around_turn(largest.angle[worst])), "deg"),
        excess=number(float(excess[worst]), "deg"),
        limit=number(float(permissible.value[worst]), "deg"),
    )


@record
class RodMotion(Flagged):
    """Motion of every piston's rod by the crank angle alone; NaN for a piston that hangs on none."""

    rod_angle: Coefficient = coefficients(
        "θ",
        "rad",
        _CURVE,
        N_("Direction of the rod, from its crank-side pin to the piston pin, from the cylinder's axis"),
        N_("Rod's angular velocity for each rad/s of the crank"),
        N_("Rod's angular acceleration for each (rad/s)² of the crank"),
        _GROUPS,
        "1.4 to 1.6",
    )
    largest_pressure_angle: Extreme = extreme(
        "β_max",
        "rad",
        _PISTON,
        N_("Largest angle between rod and cylinder axis; positive where the crank-side pin stands toward +y"),
        N_("Crank angle of the largest pressure angle"),
        _THEORY,
        "2.12",
        worst="largest",
    )
    opposite_pressure_angle: Extreme = extreme(
        "β_opp",
        "rad",
        _PISTON,
        N_("Largest angle between rod and cylinder axis to the other side"),
        N_("Crank angle of the largest pressure angle to the other side"),
        _THEORY,
        "2.12",
    )


def on_rods(pistons: Pistons) -> bool:
    """Whether any piston hangs on a rod."""
    return bool(np.any(pistons.has_rod))


def rod_motion(
    grid: PistonGrid, crank_angle: CrankAngle, turn: PistonTurn, permissible: PermissibleAngles | None
) -> RodMotion:
    """Rod angles, their derivatives and extremes; what exceeds the permissible pressure angle is flagged."""
    different = turn.distinct
    opposite, usual = turning_points(
        lambda alpha: Coefficient(*(-part for part in slider_and_rod(different.mechanisms, alpha).rod)),
        -turn.samples.rod.value,
    )
    usual, opposite = (
        Extreme(crank_angle.counted(different.angle(one.angle))[..., 0], different.spread(one.value)[..., 0])
        for one in (usual, opposite)
    )
    # Without an offset both are alike but for rounding, which must not choose.
    is_usual = usual.value >= -opposite.value * (1 - 1e-12)
    largest = chosen(is_usual, usual, opposite)
    return RodMotion(
        grid.value.rod,
        largest_pressure_angle=largest,
        opposite_pressure_angle=chosen(is_usual, opposite, usual),
        flags=() if permissible is None else tuple(_exceeding(permissible, largest)),
    )


@record
class RodSpeeds:
    """Angular velocities and accelerations of the rods."""

    rod_angular_velocity: Array = quantity("ω_r", "rad/s", _CURVE, N_("Angular velocity of the rod"), _GROUPS, "1.17")
    rod_angular_acceleration: Array = quantity(
        "ε_r", "rad/s^2", _CURVE, N_("Angular acceleration of the rod"), _GROUPS, "1.17"
    )


def rod_speeds(motion: RodMotion, speed: Speed, crank_angle: CrankAngle) -> RodSpeeds:
    """Velocities θ′ω and accelerations θ″ω² + θ′ε."""
    return RodSpeeds(*rates(motion.rod_angle, speed.drive(crank_angle.angle)))
