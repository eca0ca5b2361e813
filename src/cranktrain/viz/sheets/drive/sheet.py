"""The sheet of a drive: curves over the crank angle, the motor's curve with the way through it, facts."""

from collections.abc import Callable, Iterator

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import said as _
from cranktrain.motors import DeclaredMotor, motor_of
from cranktrain.questions.servo.demand import ServoDemand
from cranktrain.saying.scales import scale_for
from cranktrain.viz.figures import figure, with_unit
from cranktrain.viz.panel import OneDesign, closed
from cranktrain.viz.paper.head import result_page
from cranktrain.viz.paper.page import Figure, drawing_settings
from cranktrain.viz.paper.panels import FORCES, draw_panels
from cranktrain.viz.paper.tables import write_table
from cranktrain.viz.sheets.drive.half_periods import draw_half_periods
from cranktrain.viz.sheets.drive.panels import (
    demand_facts,
    demand_of,
    demand_panels,
    drive_panels,
    runs,
    steady_panels,
    way_of,
)
from cranktrain.viz.sheets.drive.torque_speed import draw_torque_speed

_LEFT = 0.55
"""Share of the curves over the crank angle in the width."""
_LOOP = 0.5
"""Share of the motor's curve in the height."""
_NOTHING = 1e-9
"""Of what stands beside it: less is rounding."""
_LOOK = FORCES._replace(has_zero=False)
"""Inertia and speed change by little."""


@drawing_settings()
def sheet_drive(result: Result, *, size: str = "A4", design: int = 0) -> Figure:
    """Draw the sheet of a drive.

    Parameters
    ----------
    result : Result
        Of a machine with [drive].
    size : "A4" or "A3"
        Lying.
    design : int
        Which of the result's machines.

    Returns
    -------
    Figure
    """
    shown, demand = OneDesign(result, design), demand_of(result, design)
    page, box = result_page(result, design, size, _("Drive"))
    left, right = box.columns(_LEFT, 14.0)
    running = steady_panels(shown) if demand is None else demand_panels(shown, demand)
    at_motor, *_others = draw_panels(page, [*drive_panels(shown), *running], left, _LOOK)
    draw_half_periods(page, at_motor, shown)
    below = right.bottom + right.height
    motor = _motor(result, design)
    room = right._replace(bottom=below - _LOOP * right.height, height=_LOOP * right.height)
    if demand is not None:
        below = draw_torque_speed(page, motor, 0, way_of(demand), room, _("wanted motion")) - 2.0
    elif motor is not None and runs(shown):
        way = (closed(shown("motor_speed")), closed(shown("motor_torque")))
        below = draw_torque_speed(page, motor, 0, way, room, _("steady running")) - 2.0
    write_table(page, list(_facts(shown, demand)), (right.left, below, right.width), (1.0,))
    return page.figure


def _motor(result: Result, design: int) -> DeclaredMotor | None:
    """The motor of the machine's file."""
    drive = result.machines[design].drive
    return None if drive is None or drive.motor is None else motor_of(drive.motor)


def _facts(shown: OneDesign, demand: ServoDemand | None) -> Iterator[tuple[str, str]]:
    """Rows of the table."""

    def of(words: str, name: str, unit: str, at: int | None = None, beside: float = 0.0) -> tuple[str, str]:
        value = float(shown(name) if at is None else shown(name)[at])
        value = 0.0 if abs(value) <= _NOTHING * abs(beside) else value
        return words, with_unit(value, scale_for(unit, abs(value))) if np.isfinite(value) else "–"

    yield _("At the motor's shaft"), ""
    yield of(_("largest static torque"), "largest_static_torque", "N*m", 0)
    yield of(_("smallest static torque"), "smallest_static_torque", "N*m", 0, float(shown("largest_static_torque")[0]))
    yield of(_("the same, η alike both ways"), "smallest_static_motor_torque", "N*m", 1)
    yield of(_("effective static torque"), "rms_static_torque", "N*m", 0)
    own = float(shown("gear_flywheel_moment")[0])
    yield _("inertia J of the drive alone"), with_unit(own / 4, scale_for("kg*m^2", own / 4))
    yield of(_("its flywheel moment GD²"), "gear_flywheel_moment", "kg*m^2", 0)
    if demand is not None:
        for words, value, unit in demand_facts(demand):
            yield words, with_unit(value, scale_for(unit, abs(value)))
    elif runs(shown):
        yield from _of_steady_running(shown, of)


def _of_steady_running(shown: OneDesign, of: Callable[[str, str, str], tuple[str, str]]) -> Iterator[tuple[str, str]]:
    """Rows of a motor in its steady cycle."""
    yield of(_("mean speed"), "mean_motor_speed", "rpm")
    yield _("coefficient of fluctuation"), figure(float(shown("drive_fluctuation")))
    yield of(_("largest torque of the motor"), "largest_motor_torque", "N*m")
    yield of(_("smallest torque of the motor"), "smallest_motor_torque", "N*m")
    yield of(_("effective torque of the motor"), "rms_motor_torque", "N*m")
    yield of(_("power of the motor"), "motor_power", "W")
    yield of(_("power that the loads take"), "driven_power", "W")
    yield of(_("power that the drive loses"), "lost_power", "W")
    yield of(_("heat in the motor"), "motor_heat", "W")
