"""A machine made ready to start, as far as its file says: what it moves, its motor, its brake, where its loads jump."""

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.drive.declared import DeclaredBrake, DeclaredDrive
from cranktrain.motors import DeclaredMotor
from cranktrain.questions.drive.steady_drive import SteadyCycles
from cranktrain.questions.gas.chambers import GasInChambers
from cranktrain.questions.reduction.at_angles import has_inertia, reduced_of_each, structure_of
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.questions.start.asked import MovingParts
from cranktrain.questions.start.case import Braking, StartCase, StartCases
from cranktrain.questions.start.gentle_rows import corners_and_rows
from cranktrain.saying.wording import number
from cranktrain.transient.equation import AT_MOTOR, BrakePlace
from cranktrain.transient.gearing import Gearing, turning_inertia
from cranktrain.transient.reduced import DISCHARGE, SUCTION, ReducedMachine

_SAME = 1e-9
"""In parts: pressures that differ by less are one, in whichever unit."""


def start_cases(
    drive: DeclaredDrive,
    parts: MovingParts,
    machines: ReducedMachines,
    steady: SteadyCycles | None,
    gas: GasInChambers | None,
    crank_angle: CrankAngle,
) -> StartCases:
    """Make every design ready to start; what is wrong with one stands at its place."""
    chambers = () if gas is None else _remembering(gas)
    each, are_known = list[StartCase | InputError](), _are_loads_known(machines, crank_angle)
    motors = (None,) * len(drive.gearings) if parts.motor is None else parts.motor.of_each()
    for design, (gearing, motor, is_known) in enumerate(zip(drive.gearings, motors, are_known, strict=True)):
        try:
            _refuse_immovable(machines.each[design], gearing, is_load_known=is_known)
            each.append(_start_case(gearing, motor, parts, machines, steady, chambers, crank_angle, design))
        except InputError as error:
            each.append(error)
    return StartCases(tuple(each))


def _refuse_immovable(machine: ReducedMachine, gearing: Gearing, *, is_load_known: bool) -> None:
    """Refuse a design that has no inertia, or whose load is no number: gas can be beyond computing."""
    if not has_inertia(machine, turning_inertia(gearing)):
        allowed = _(
            "moves nothing that has inertia, and a start needs some: of the motor, [drive.part.NAME] or [masses]"
        )
        raise InputError([Problem("drive", None, allowed)])
    if not is_load_known:
        allowed = _("needs the load on the crank, which is no number here: see what `run` says of gas and loads")
        raise InputError([Problem("drive", None, allowed)])


def _start_case(
    gearing: Gearing,
    motor: DeclaredMotor | None,
    parts: MovingParts,
    machines: ReducedMachines,
    steady: SteadyCycles | None,
    chambers: tuple[str, ...],
    crank_angle: CrankAngle,
    design: int,
) -> StartCase:
    """Make a design ready to start."""
    machine = machines.each[design]
    brake, place = _brake(parts.brake, design)
    start = parts.start.of(design)
    _refuse_pressure(machine, start.gas_pressure, parts.start.texts.get("gas_pressure", ""))
    corners, rows = corners_and_rows(machines.corners[design], machines.misses[design], machines.cycle, start.tolerance)
    found = steady.found[design] if steady is not None and start.are_to_settle else None
    cycle_time = np.nan if found is None else found.period
    return StartCase(
        machine=machine,
        corners=corners,
        rows=rows,
        cycle=machines.cycle,
        gearing=gearing,
        motor=motor,
        start=start,
        interval_text=parts.start.texts.get("interval", ""),
        brake=brake,
        place=place,
        chambers=chambers,
        zero=float(crank_angle.zero[min(design, len(crank_angle.zero) - 1), 0, 0]),
        steady_speed=machines.cycle / cycle_time,
        cycle_time=cycle_time,
    )


def _brake(found: DeclaredBrake | None, design: int) -> tuple[Braking, BrakePlace]:
    """The brake of a design, whose torque begins its delay after the command, and where it sits."""
    if found is None:
        return Braking(0.0, 0.0, 0.0), AT_MOTOR
    grip = found.of(design)
    place = BrakePlace(float(found.on == "crank"), grip.static_torque / grip.torque)
    return Braking(grip.torque, grip.delay, grip.rise_time), place


def _remembering(gas: GasInChambers) -> tuple[str, ...]:
    """Names of the chambers that remember their gas, in the order of the reduced machine."""
    each = [filling.places for filling in gas.filled_with("compressor")]
    places: list[int] = [int(place) for own in each for place in own.tolist()]
    return tuple(gas.chambers.names[place] for place in places)


def _refuse_pressure(machine: ReducedMachine, pressure: float, text: str) -> None:
    """Refuse a pressure at the beginning without a chamber that has one, and one that no valve would leave there."""
    if np.isnan(pressure):
        return
    chambers = np.asarray(machine.chambers)
    if not len(chambers):
        allowed = _('is for chambers of a compressor, [gas] kind = "compressor"; other gas goes by the crank angle')
        raise InputError([Problem("drive.start.gas_pressure", text, allowed)])
    least, most = float(np.min(chambers[:, SUCTION])), float(np.max(chambers[:, DISCHARGE]))
    if not least * (1 - _SAME) <= pressure <= most * (1 + _SAME):
        allowed = _("must be from the suction's {least} to the discharge's {most}: beyond them valves open at once")
        said = allowed.format(least=number(least, "kPa"), most=number(most, "kPa"))
        raise InputError([Problem("drive.start.gas_pressure", text, said)])


def _are_loads_known(machines: ReducedMachines, crank_angle: CrankAngle) -> list[bool]:
    """Whether the load of each design is a number at all crank angles at which the links close."""
    grid = np.broadcast_to(crank_angle.angle[:, 0], (len(machines.each), crank_angle.shown.size))
    found = [False] * len(machines.each)
    for designs in grouped((structure_of(one), place) for place, one in enumerate(machines.each)).values():
        there = reduced_of_each([machines.each[design] for design in designs], grid[designs])
        is_known = ~np.any(np.isfinite(there.inertia) & ~np.isfinite(there.load), axis=-1)
        for design, own in zip(designs, is_known.tolist(), strict=True):
            found[design] = own
    return found
