"""Flywheel for a wanted coefficient of fluctuation, exact and as the textbooks have it, and the rim that it takes."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.evenness.flywheel_inertia import METHODS, Flywheel, flywheels_by_method
from cranktrain.questions.evenness.rim import rim, rim_speed
from cranktrain.questions.evenness.running_speed import RunningSpeed
from cranktrain.questions.evenness.shaft_torque import LoadTorque
from cranktrain.questions.evenness.shaft_work import ShaftWork
from cranktrain.questions.evenness.spec import Balancing, DeclaredRim, DrivenByMotor, GivenFlywheel, WantedCoefficient
from cranktrain.record import record
from cranktrain.references import THEORY_OF_EVENNESS as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Flagged
from cranktrain.saying.wording import number

_METHOD = "flywheel_method"


@record
class FlywheelSize(Flagged):
    """Flywheels that give the coefficient of fluctuation wanted, against a load that does not depend on the speed.

    Attributes
    ----------
    exact : Flywheel
        With all that the diagrams need.
    wanted : Array, shape (design,)
        The coefficient of fluctuation.
    """

    exact: Flywheel
    wanted: Array
    flywheel_inertia: Array = quantity(
        "J_f",
        "kg*m^2",
        (_METHOD,),
        N_("Flywheel for the coefficient of fluctuation wanted"),
        _THEORY,
        "17.7, 17.9, 17.10",
    )
    wanted_flywheel_moment: Array = quantity(
        "GD²_f",
        "kg*m^2",
        (_METHOD,),
        N_("Flywheel moment of that flywheel, GD² = 4 J"),
        _THEORY,
        "17.14",
        line="4 · {flywheel_inertia}",
    )
    flywheel_inertia_error: Array = quantity(
        "ΔJ_f/J_f",
        "1",
        (_METHOD,),
        N_("Error of the textbook's flywheel, relative to the exact one"),
        _THEORY,
        "17.7, 17.9, 17.10",
    )
    flywheel_fluctuation: Array = quantity(
        "δ_f", "1", (_METHOD,), N_("Coefficient of fluctuation that each flywheel really gives"), _THEORY, "17.5"
    )


def flywheel_size(
    balancing: Balancing,
    coefficient: WantedCoefficient,
    given: LoadTorque | None,
    driven: DrivenByMotor | None,
    work: ShaftWork,
    speed: Speed,
) -> FlywheelSize:
    """Flywheel by each method.

    Notes
    -----
    docs/theory/evenness, eqs. (17.7) to (17.10).
    """
    found = flywheels_by_method(work.excess, work.inertia, speed.value[:, 0, 0], coefficient.value, balancing.mean)
    return FlywheelSize(
        exact=found.exact,
        wanted=coefficient.value,
        flywheel_inertia=found.inertia,
        wanted_flywheel_moment=4 * found.inertia,
        flywheel_inertia_error=found.error,
        flywheel_fluctuation=found.fluctuation,
        labels={_METHOD: METHODS},
        flags=tuple(_size_flags(driven, given)),
    )


def _size_flags(driven: DrivenByMotor | None, given: LoadTorque | None) -> Iterator[Words]:
    """Flag a load for which another flywheel would do."""
    depends = given is not None and (given.powers or given.shape is not None)
    if driven is not None or depends:
        yield _(
            "The flywheel wanted is for a load that does not depend on the speed;"
            " one that rises with it evens it out more."
        )


@record
class RimSize(Flagged):
    """Rim of the flywheel that is wanted, or where none is, of the one that there is."""

    rim_height: Array = quantity("h", "m", (), N_("Height of the rim's section"), _THEORY, "17.15")
    rim_width: Array = quantity("b", "m", (), N_("Width of the rim along the shaft"), _THEORY, "17.15")
    rim_outer_diameter: Array = quantity("D_o", "m", (), N_("Outer diameter of the rim"), _THEORY, "17.21")
    rim_mass: Array = quantity("m", "kg", (), N_("Mass of the rim"), _THEORY, "17.14")
    rim_mass_by_mean_diameter: Array = quantity(
        "m_D",
        "kg",
        (),
        N_("Mass of the rim by the textbooks' GD² = mD², with its mean diameter"),
        _THEORY,
        "17.14",
    )
    rim_speed: Array = quantity("v", "m/s", (), N_("Speed of the rim's outside at the largest speed"), _THEORY, "17.21")


def rim_size(
    wanted: DeclaredRim,
    _work: ShaftWork,
    flywheel: GivenFlywheel | None,
    running: RunningSpeed | None,
    size: FlywheelSize | None,
) -> RimSize:
    """Section, mass and speed of the rim.

    Notes
    -----
    Where there is work there is one of both flywheels, as the file is refused otherwise.
    docs/theory/evenness, eqs. (17.14) and (17.15).
    """
    inertia = largest = np.full(wanted.largest_speed.shape, np.nan)
    if size is not None:
        inertia, largest = size.flywheel_inertia[:, 0], size.exact.largest_speed
    elif flywheel is not None and running is not None:
        inertia, largest = flywheel.inertia, running.largest_crank_speed.value
    found = rim(inertia, wanted.demand)
    speed = rim_speed(found.outer_diameter, largest)
    return RimSize(
        rim_height=found.height,
        rim_width=found.width,
        rim_outer_diameter=found.outer_diameter,
        rim_mass=found.mass,
        rim_mass_by_mean_diameter=found.textbook_mass,
        rim_speed=speed,
        flags=tuple(_rim_flags(inertia, speed, wanted, found.height)),
    )


def _rim_flags(inertia: Array, speed: Array, wanted: DeclaredRim, height: Array) -> Iterator[Words]:
    """Flag a rim that runs too fast, or that has no room on its diameter."""
    too_fast = speed > wanted.largest_speed
    if np.any(too_fast):
        worst = first_largest(np.where(too_fast, speed / wanted.largest_speed, 0.0))
        yield _(
            "The rim's outside runs too fast: at {speed}, and it bears {largest}"
            " ([evenness.rim] largest_speed; of cast iron unless given).",
            speed=number(float(speed[worst]), "m/s"),
            largest=number(float(wanted.largest_speed[worst]), "m/s"),
        )
    if np.any((inertia > 0) & np.isnan(height)):
        yield _("The rim's section would reach the shaft's axis: its mean diameter is too small.")
