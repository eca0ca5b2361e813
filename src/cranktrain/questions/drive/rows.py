"""What the drive says in the answer: static torque and flywheel moment at the motor, and how it runs with the motor."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.questions.drive.flywheel_sizing import DriveFlywheel
from cranktrain.questions.drive.motor_checks import is_with_load
from cranktrain.questions.drive.motor_sizing import MotorSizing
from cranktrain.questions.drive.press_strokes import PressStrokes
from cranktrain.questions.drive.servo.rocking import RockingCrank, RockingDrive
from cranktrain.questions.drive.servo.stages import ServoDrive, WantedCrank
from cranktrain.questions.drive.static_torques import StaticTorques
from cranktrain.questions.drive.steady_drive import SteadyDrive
from cranktrain.rows import Amount, AnswerLine, Extent, worded
from cranktrain.wording import Names

_NOTHING = 1e-9
"""Of what it is beside: less is rounding, as of loads that give back in a turn what they took."""

_WORTH_A_ROW = 0.01
"""Of the largest torque: where another law of losses gives less of a difference, the results alone have it."""


def static_rows(labels: Names, design: int, found: StaticTorques) -> Iterator[AnswerLine]:
    """Range of the static torque at the first shaft, of the inertia there, and what it is of the drive alone."""
    most, least = found.largest_static_torque, found.smallest_static_torque
    yield worded(
        _("static torque at {shaft}").format(shaft=labels["drive_shaft"][0]),
        _("{range}; effective {rms}"),
        range=Extent(float(least.value[design, 0]), float(most.value[design, 0]), "N*m"),
        rms=Amount(float(found.rms_static_torque[design, 0]), "N*m"),
    )
    ends = np.stack([found.smallest_static_motor_torque[design], found.largest_static_motor_torque[design]])
    own, same_back = ends[:, 0], ends[:, 1]
    if np.any(np.abs(same_back - own) > _WORTH_A_ROW * np.max(np.abs(own))):
        alike = Extent(float(same_back[0]), float(same_back[1]), "N*m")
        yield worded(_("with η alike both ways"), "{range}", range=alike)
    inertia = found.driven_inertia[design, 0]
    yield worded(
        _("J at {shaft}, GD² = 4 J").format(shaft=labels["drive_shaft"][0]),
        _("{range}, alone {own}"),
        range=Extent(float(np.min(inertia)), float(np.max(inertia)), "kg*m^2"),
        own=Amount(float(found.gear_flywheel_moment[design, 0]) / 4, "kg*m^2"),
    )


def running_rows(labels: Names, design: int, found: SteadyDrive) -> Iterator[AnswerLine]:
    """How the motor runs in the steady state."""
    yield worded(
        _("motor runs at"),
        _("{speed}, fluctuation {delta}; cycle {time}"),
        speed=Amount(float(found.mean_motor_speed[design]), "rpm"),
        delta=Amount(float(found.drive_fluctuation[design]), "1"),
        time=Amount(float(found.cycle_time[design]), "s"),
    )
    yield worded(
        _("torque of the motor"),
        _("{range}; effective {rms}"),
        range=Extent(float(found.smallest_motor_torque[design]), float(found.largest_motor_torque[design]), "N*m"),
        rms=Amount(float(found.rms_motor_torque[design]), "N*m"),
    )
    power, taken, lost = (float(each[design]) for each in (found.motor_power, found.driven_power, found.lost_power))
    swung = float(found.rms_motor_torque[design] * found.mean_motor_speed[design])
    yield worded(
        _("power of the motor"),
        _("{power}; to loads {taken}, lost {lost}"),
        power=Amount(_unless_rounding(power, swung), "W"),
        taken=Amount(_unless_rounding(taken, max(swung, abs(power))), "W"),
        lost=Amount(_unless_rounding(lost, swung), "W"),
    )


def _unless_rounding(power: float, swung: float) -> float:
    """A mean power, or nothing beside what swings to and fro. [W]"""
    return power if abs(power) > _NOTHING * swung else 0.0


def sizing_rows(labels: Names, design: int, found: MotorSizing) -> Iterator[AnswerLine]:
    """What governs the declared motor, and the smallest typical one that passes."""
    _declared, chosen, smaller = found.largest_share[design].tolist()
    yield from _used(found, design)
    if np.isfinite(chosen):
        words = _("typical {power}, used to {share}")
        if is_with_load(found.governing(design, 1)):
            words += _(" if it starts loaded")
        if np.isfinite(smaller):
            words += _("; {less} misses by {by}: {missed}")
        yield worded(
            _("motor that is enough"),
            words,
            power=Amount(float(found.sized_power[design, 1]), "W"),
            share=Amount(chosen, "%"),
            **_smaller(found, design, smaller),
        )


def _used(found: MotorSizing, design: int) -> Iterator[AnswerLine]:
    """Every share of the declared motor that is asked for; of a start with its load at the worst angle, if it must."""
    shares: dict[str, Amount | str] = {}
    words: list[str] = []
    for name, share in zip(found.labels["sizing_check"], found.sizing_share[design, 0].tolist(), strict=True):
        if np.isfinite(share):
            piece = f"share_{len(shares)}"
            shares[piece] = Amount(share, "%")
            said = _("{share} if it must start with load at the worst angle") if is_with_load(name) else ""
            words.append((said or _("{check} {share}")).format(check=name, share=f"{{{piece}}}"))
    if shares:
        yield worded(_("motor is used to"), ", ".join(words), **shares)
    if found.unknown:
        yield worded(_("not checked of it"), found.unknown)


def _smaller(found: MotorSizing, design: int, share: float) -> dict[str, Amount | str]:
    """Pieces that tell of the next smaller motor, where there is one that runs."""
    if not np.isfinite(share):
        return {}
    power = Amount(float(found.sized_power[design, 2]), "W")
    return {"less": power, "by": Amount(share - 1, "%"), "missed": found.governing(design, 2)}


def flywheel_rows(labels: Names, design: int, found: DriveFlywheel) -> Iterator[AnswerLine]:
    """Flywheel for the wanted torque or evenness, and what it does to the effective torque."""
    words, numbers = found.words_and_numbers(design)
    yield worded(_("flywheel of the drive"), words, **numbers)


def wanted_rows(labels: Names, design: int, found: WantedCrank) -> Iterator[AnswerLine]:
    """Period, rests and speed, and by how much a constant speed misses."""
    yield worded(
        _("wanted motion"),
        _("takes {period}, {rest} of it at rest; crank up to {speed}"),
        period=Amount(float(found.wanted_period[design]), "s"),
        rest=Amount(float(found.resting_time[design]), "s"),
        speed=Amount(float(found.largest_wanted_speed[design]), "rpm"),
    )
    yield worded(
        _("at constant speed"),
        _("off by up to {miss} of the stroke"),
        miss=Amount(float(found.constant_speed_miss[design]), "1"),
    )


def servo_rows(labels: Names, design: int, found: ServoDrive) -> Iterator[AnswerLine]:
    """What the motor of a turning crank needs."""
    yield worded(
        _("motor needs"),
        _("{peak} at once, {rms} for long; up to {speed} and {power}"),
        peak=Amount(float(found.servo_peak_torque[design]), "N*m"),
        rms=Amount(float(found.servo_rms_torque[design]), "N*m"),
        speed=Amount(float(found.servo_peak_speed[design]), "rpm"),
        power=Amount(float(found.servo_peak_power[design]), "W"),
    )


def rocking_rows(labels: Names, design: int, found: RockingCrank) -> Iterator[AnswerLine]:
    """Between which angles a crank swings, and how fast."""
    ends = (float(found.least_rocking_angle[design]), float(found.greatest_rocking_angle[design]))
    yield worded(
        _("crank swings"),
        _("{range} in {period}, at up to {speed}"),
        range=Extent(*ends, "rad"),
        period=Amount(float(found.rocking_period[design]), "s"),
        speed=Amount(float(found.largest_rocking_speed[design]), "rpm"),
    )


def rocking_drive_rows(labels: Names, design: int, found: RockingDrive) -> Iterator[AnswerLine]:
    """What the motor of a rocking crank needs."""
    yield worded(
        _("motor needs"),
        _("{peak} at once, {rms} for long; up to {power}"),
        peak=Amount(float(found.rocking_peak_torque[design]), "N*m"),
        rms=Amount(float(found.rocking_rms_torque[design]), "N*m"),
        power=Amount(float(found.rocking_peak_power[design]), "W"),
    )


def stroke_rows(labels: Names, design: int, found: PressStrokes) -> Iterator[AnswerLine]:
    """How a single stroke goes: clutch, flywheel, brake, and how many are possible."""
    if np.isnan(found.stroke_time[design]):
        return
    yield worded(
        _("stroke"),
        _("{time}, command at {command}; up to {most} a minute"),
        time=Amount(float(found.stroke_time[design]), "s"),
        command=Amount(float(found.command_angle[design]), "rad"),
        most=f"{float(found.most_strokes_per_minute[design]):.4g}",
    )
    yield worded(
        _("clutch"),
        _("slips for {time} to {angle}, takes {heat}"),
        time=Amount(float(found.clutch_slip_time[design]), "s"),
        angle=Amount(float(found.clutch_lock_angle[design]), "rad"),
        heat=Amount(float(found.clutch_heat[design]), "J"),
    )
    yield worded(
        _("flywheel"),
        _("slows by {drop}, {pressing} pressing; back in {time}"),
        drop=Amount(float(found.stroke_speed_drop[design]), "%"),
        pressing=Amount(float(found.pressing_speed_drop[design]), "%"),
        time=Amount(float(found.recovery_time[design]), "s"),
    )
    yield worded(
        _("brake"),
        _("{angle} in {time}, {heat}; rests {off} past its start"),
        angle=Amount(float(found.braking_angle[design]), "rad"),
        time=Amount(float(found.braking_time[design]), "s"),
        heat=Amount(float(found.brake_heat[design]), "J"),
        off=Amount(float(found.stop_angle[design]), "rad"),
    )
