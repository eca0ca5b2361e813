"""The sheet of a drive: curves over the crank angle, the motor's curve with the way through it, facts."""

from collections.abc import Iterator

from cranktrain.analysis import Result
from cranktrain.language import Message, Words, _
from cranktrain.motors import motor_of
from cranktrain.panels.design import OneDesign, closed
from cranktrain.panels.parts import CurveCard, Sheet, SheetColumn, Stack, facts_table, sheet_of
from cranktrain.panels.shapes import Panel
from cranktrain.panels.sheets.drive.panels import (
    demand_facts,
    demand_of,
    demand_panels,
    drive_panels,
    runs,
    steady_panels,
    way_of,
)
from cranktrain.panels.sheets.drive.torque_speed import torque_speed_panel
from cranktrain.questions.servo.demand import ServoDemand
from cranktrain.saying.amounts import Amount


def sheet_drive(result: Result, *, design: int = 0) -> Sheet:
    """Collect what a drive does.

    Parameters
    ----------
    result : Result
        Of a machine with [drive].
    design : int
        Which of the result's machines.

    Returns
    -------
    Sheet
    """
    shown, demand = OneDesign(result, design), demand_of(result, design)
    running = steady_panels(shown) if demand is None else demand_panels(shown, demand)
    return sheet_of(
        result,
        design,
        _("Drive"),
        SheetColumn(0.55, (Stack((*drive_panels(shown), *running)),)),
        SheetColumn(
            0.45,
            (
                *(CurveCard((panel,), height=0.5) for panel in _torque_over_speed(shown, demand)),
                facts_table(_("At the motor's shaft"), list(_facts(shown, demand))),
            ),
        ),
    )


def _torque_over_speed(shown: OneDesign, demand: ServoDemand | None) -> Iterator[Panel]:
    """The way through the motor's curve, if the machine takes one."""
    drive = shown.result.machines[shown.design].drive
    motor = None if drive is None or drive.motor is None else motor_of(drive.motor)
    if demand is not None:
        yield torque_speed_panel(motor, 0, way_of(demand), _("wanted motion"))
    elif motor is not None and runs(shown):
        way = (closed(shown("motor_speed")), closed(shown("motor_torque")))
        yield torque_speed_panel(motor, 0, way, _("steady running"))


def _facts(shown: OneDesign, demand: ServoDemand | None) -> Iterator[tuple[Message, Words]]:
    """What stands in the table."""
    largest = float(shown("largest_static_torque")[0])
    yield _("largest static torque"), shown.amount("largest_static_torque", 0)
    yield _("smallest static torque"), shown.amount("smallest_static_torque", 0, beside=largest)
    yield _("the same, η alike both ways"), shown.amount("smallest_static_motor_torque", 1)
    yield _("effective static torque"), shown.amount("rms_static_torque", 0)
    yield _("inertia J of the drive alone"), Amount(float(shown("gear_flywheel_moment")[0]) / 4, "kg*m^2")
    yield _("its flywheel moment GD²"), shown.amount("gear_flywheel_moment", 0)
    if demand is not None:
        yield from demand_facts(demand)
    elif runs(shown):
        yield _("mean speed"), shown.amount("mean_motor_speed")
        yield _("coefficient of fluctuation"), shown.amount("drive_fluctuation")
        yield _("largest torque of the motor"), shown.amount("largest_motor_torque")
        yield _("smallest torque of the motor"), shown.amount("smallest_motor_torque")
        yield _("effective torque of the motor"), shown.amount("rms_motor_torque")
        yield _("power of the motor"), shown.amount("motor_power")
        yield _("power that the loads take"), shown.amount("driven_power")
        yield _("power that the drive loses"), shown.amount("lost_power")
        yield _("heat in the motor"), shown.amount("motor_heat")
    elif shown.has("constant_speed_torque"):
        yield _("largest torque at constant speed"), shown.amount("largest_constant_speed_torque", 0)
        yield _("effective torque at constant speed"), shown.amount("rms_constant_speed_torque", 0)
