"""What is said of a motor that is enough, and of a flywheel that is to be found."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from cranktrain.language import N_, Listed, Words, _
from cranktrain.questions.sizing.flywheel_sizing import DriveFlywheel
from cranktrain.questions.sizing.motor_checks import CHECK_TITLES, is_with_load
from cranktrain.questions.sizing.motor_sizing import MotorSizing
from cranktrain.saying.labels import titled
from cranktrain.saying.rows import AnswerLine, Telling, worded


def sizing_rows(of: Telling, found: MotorSizing) -> Iterator[AnswerLine]:
    """What governs the declared motor, and the smallest typical one that passes."""
    _declared, chosen, smaller = (of.amount(found, "largest_share", motor, unit="%") for motor in range(3))
    yield from _used(of, found)
    if np.isfinite(chosen.value):
        said = _("typical {power}, used to {share}")
        if is_with_load(found.governing(of.design, 1)):
            said = _("typical {power}, used to {share} if it starts loaded")
        enough = said.format(power=of.amount(found, "sized_power", 1), share=chosen)
        if np.isfinite(smaller.value):
            enough = _(
                "{enough}; {less} misses by {by}: {missed}",
                enough=enough,
                less=of.amount(found, "sized_power", 2),
                by=replace(smaller, value=smaller.value - 1),
                missed=titled(CHECK_TITLES, found.governing(of.design, 2)),
            )
        yield worded(_("motor that is enough"), enough)


def _used(of: Telling, found: MotorSizing) -> Iterator[AnswerLine]:
    """Every share of the declared motor that is asked for; of a start with its load at the worst angle, if it must."""
    shares: list[Words] = []
    for place, check in enumerate(found.labels["sizing_check"]):
        share = of.amount(found, "sizing_share", 0, place, unit="%")
        if np.isfinite(share.value):
            with_load = _("{share} if it must start with load at the worst angle")
            said = with_load if is_with_load(check) else _("{check} {share}")
            shares.append(said.format(check=titled(CHECK_TITLES, check), share=share))
    if shares:
        yield worded(_("motor is used to"), Listed(shares))
    if found.unknown:
        yield worded(_("not checked of it"), Listed(found.unknown, "; "))


def flywheel_rows(of: Telling, found: DriveFlywheel) -> Iterator[AnswerLine]:
    """Flywheel for the wanted torque or evenness, and what it does to the effective torque."""
    stalls = N_("{needed_inertia}; effective torque {rms_with_flywheel}; without it the motor stalls")
    runs = N_("{needed_inertia}; effective torque {rms_with_flywheel} in place of {rms_without_flywheel}")
    is_stalled = np.isnan(of.values(found, "rms_without_flywheel"))
    yield of.line(_("flywheel of the drive"), stalls if is_stalled else runs, found)
