"""What is wrong in the text on a crank-rocker's drive, and in what it refutes, with numbers of its example."""

from typing import Any

import numpy as np

from cranktrain.language import N_
from cranktrain.numerics import Extreme, extremes
from cranktrain.texts.crank_rocker_drive import efficiency
from cranktrain.texts.drive_curves import CurveFacts, Verdict, carried, curve_facts, drive_curves
from cranktrain.texts.drive_table import CrankRockerDrive, read_drive
from cranktrain.texts.drive_verdicts import absurdities
from cranktrain.texts.example_tables import example_table
from cranktrain.texts.wrong_step import WrongStep


def drive_example() -> CrankRockerDrive:
    """Read the drive of `cranktrain textbook --drive example`."""
    import tomllib

    data: dict[str, Any] = tomllib.loads(example_table("drive"))
    return read_drive(data)


def drive_errata() -> tuple[WrongStep, ...]:
    """Name the errors in the text's order.

    Returns
    -------
    tuple of WrongStep
        Numbers are those of the drive of `cranktrain textbook --drive example`.
    """
    drive = drive_example()
    found = absurdities(drive)

    def facts(number: str, verdict: Verdict, place: int = 0) -> CurveFacts:
        curves = [one for one in drive_curves(drive) if (one.number, one.verdict) == (number, verdict)]
        return curve_facts(drive, curves[place])

    load = float(drive.load)
    return (
        WrongStep(
            N_("static torque on the crank's shaft, (13)"),
            "Q r₁ sin(α − β)/(η_ш sin(α₁ − β))",
            facts("(13)", "source").advancing.value,
            facts("(12)", "source").advancing.value,
            "N*m",
            N_("by (12) and (4) it has r, the crank's radius: r₁/r times too much. Here its peak, as it advances"),
        ),
        WrongStep(
            N_("losses in (12), (13), (14)"),
            "1/η",
            facts("(14)", "source").returning.value,
            facts("(14)", "right").returning.value,
            "N*m",
            N_(
                "η divides while the motor drives alone; where the load drives, losses help to hold it, and 2 − 1/η "
                "multiplies: a friction torque that is the same both ways. By the sign of the torque that is passed "
                "on, inertia's part with it. Here the peak as the rocker goes back"
            ),
        ),
        WrongStep(
            N_("the same with one efficiency for both ways"),
            "1/η",
            facts("(14)", "source").returning.value,
            facts("(14)", "right", 1).returning.value,
            "N*m",
            N_("where the load drives, η multiplies, if gear and linkage are as efficient that way"),
        ),
        WrongStep(
            N_("flywheel moment on the crank's shaft, (19)"),
            "4 r² G_A sin²(α − β)/(η_ш sin²(α₁ − β))",
            facts("(19)", "source").returning.value,
            facts("(18)", "right").returning.value,
            "kg*m^2",
            N_("an efficiency is no property of an inertia: losses follow the torque. (18) with (17) is right"),
        ),
        WrongStep(
            N_("flywheel moment at the motor, (20)"),
            "4 r² G_A sin²(α − β)/(η_p η_ш i sin²(α₁ − β))",
            facts("(20)", "source").returning.value,
            facts("(20)", "right").returning.value,
            "kg*m^2",
            N_("equal kinetic energies need i², and no η: the formula that it criticises has i²"),
        ),
        WrongStep(
            N_("the rod in (15) to (20)"),
            "(GD²)пр.о₁",
            facts("(20)", "right").returning.value,
            facts("(20)", "right", 1).returning.value,
            "kg*m^2",
            N_("left out are the rod's mass and the crank's; with them GD² stays above (GD²)₀ at the dead positions"),
        ),
        WrongStep(
            N_("torque that is constant in idle running, before (21)"),
            "Mст.о = const",
            None,
            float(drive.idle_torque),
            "N*m",
            N_("its next line shows what is meant, Mст.о₁, on the rocker's shaft"),
        ),
        WrongStep(
            N_("sign of the idle torque, (21) and fig. 2"),
            "M_xx sin(α − β)/sin(α₁ − β)",
            facts("(21)", "source").returning.value,
            facts("(21)", "right").returning.value,
            "N*m",
            N_(
                "friction, of which idle running consists, reverses with the rocker, and its torque is |(21)|; "
                "a weight's or a spring's alone changes its sign. Here the peak as the rocker goes back"
            ),
        ),
        WrongStep(
            N_("GD² alone for transients"),
            "Mст, GD² = f(α)",
            0.0,
            float(min(extremes(lambda angle: carried(drive, "inertia", angle)[1]), key=_value).value[0]),
            "kg*m^2",
            N_(
                "where the inertia varies the motor also gives ½ω² dJ/dφ: M − M_st = J dω/dt + ½ω² dJ/dφ. Here the "
                "least dJ/dφ of the crank, for a radian"
            ),
        ),
        WrongStep(
            N_("AC/BC of Kunitsky and Popov, which the text refutes"),
            "sin(α₁ − β) sin(α − β)",
            facts("(10)", "refuted").returning.value,
            facts("(10)", "right").returning.value,
            "1",
            N_("against the sine rule in ABC. Here its peak as the rocker goes back"),
        ),
        WrongStep(
            N_("their torque at the motor"),
            "G r/(η i) · sin(α₁ − β) sin(α − β)",
            found.refuted_work,
            0.0,
            "J",
            N_("G stands for Q. It takes work from nothing: that of a turn with an active load and η = 1"),
        ),
        WrongStep(
            N_("their flywheel moment at the motor"),
            "(GD²)₀ + 4 r² G_A/i² · sin(α₁ − β) sin(α − β)",
            found.least_moment,
            facts("(20)", "right").returning.value,
            "kg*m^2",
            N_("while the rocker goes back it is below (GD²)₀: parts that move would make the whole lighter"),
        ),
        WrongStep(
            N_("their force in the rod"),
            "Q′ = Q sin(α₁ − β)",
            load * float(np.sqrt(found.least_square)),
            load / float(np.sqrt(found.least_square)),
            "N",
            N_("put into (1) it gives sin²(α₁ − β) = 1, absurd. Here where sin(α₁ − β) is least"),
        ),
        WrongStep(
            N_("their idle torque"),
            "M_xx = const",
            float(drive.idle_torque * drive.geometry.crank_radius / drive.geometry.rocker_length)
            / float(efficiency(drive.train) * drive.train.ratio),
            0.0,
            "N*m",
            N_("at a dead position nothing moves the rocker, and without friction in the pins the torque is 0"),
        ),
    )


def _value(one: Extreme) -> float:
    """Value of an extreme."""
    return float(one.value[0])
