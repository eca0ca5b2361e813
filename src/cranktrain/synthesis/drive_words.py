"""What is said of a proposed drive: its numbers, the sizes that were tried, what governs and what is to be minded."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import Words, _
from cranktrain.layout.drive.table import DriveSpec
from cranktrain.questions.sizing.flywheel_sizing import formula_inertia
from cranktrain.questions.sizing.motor_checks import CHECK_TITLES
from cranktrain.saying.labels import titled
from cranktrain.saying.wording import number
from cranktrain.synthesis.drive_trials import AskedDrive, Bench, Trial
from cranktrain.synthesis.proposal import Alternative, Number
from cranktrain.synthesis.sized_motor import KeptSlip, declared_slip, typical_slip

_SYMBOLS = ("u_M", "u_max", "u_A", "u_t", "u_z", "u_J", "u_n")
_NAMES = ("effective", "peak", "worst_start", "start_time", "starts", "inertia", "speed_share")
_NOT_BESIDE = frozenset({"overall_ratio", "off"})
"""Numbers of the chosen one that tables of others leave out: they follow from those that stand there."""


def numbers(asked: AskedDrive, one: Trial, chosen: Trial) -> Iterator[Number]:
    """Motor, ratio and flywheel, and the shares of the checks that are asked for of the chosen one."""
    yield Number("power", "P_n", one.power, "kW", _("Rated power of a typical four-pole motor"))
    yield Number("slip", "s_n", one.slip, "%", _("Its slip at the rated torque"))
    yield Number("ratio", "i", one.ratio, "1", _("Ratio of stage {n}", n=asked.stage + 1))
    yield Number("overall_ratio", "i_Σ", one.overall, "1", _("Ratio of all stages"))
    yield Number("speed", "n", one.speed, "rpm", _("Mean speed of the crank in steady running"))
    yield Number("off", "Δn", one.speed / asked.speed - 1, "%", _("Off the speed that it shall have"))
    if asked.flywheel is not None:
        said = _("Inertia of {part}", part=asked.flywheel.name)
        yield Number("flywheel", "J_F", one.flywheel, "kg·m²", said)
        yield Number("fluctuation", "δ", one.fluctuation, "%", _("Coefficient of fluctuation of the crank's speed"))
        if np.isfinite(chosen.checked.start_time):
            said = _("Time of a start at the lowest voltage")
            yield Number("time_of_start", "t_st", one.checked.start_time, "s", said)
    for name, symbol, check, share, own in zip(_NAMES, _SYMBOLS, one.checks, one.shares, chosen.shares, strict=True):
        if not np.isnan(own):
            yield Number(name, symbol, share, "%", _("Used: {check}", check=titled(CHECK_TITLES, check)))


def alternatives(
    asked: AskedDrive, chosen: Trial, sizes: Sequence[Trial], ratios: Sequence[Trial]
) -> Iterator[Alternative]:
    """The sizes that carry the machine, each with what it misses by, and the ratios beside."""
    for one in sizes:
        if one is not chosen and np.isfinite(one.speed):
            yield Alternative(_missed(one), tuple(_beside(asked, one, chosen)))
    for one in ratios:
        if np.isfinite(one.speed):
            yield Alternative(_("ratio beside"), tuple(_beside(asked, one, chosen)))


def _missed(one: Trial) -> Words:
    """By how much a size misses, and what."""
    if one.largest <= 1:
        return _("enough")
    if not np.isfinite(one.largest):
        return _("gets stuck")
    return _("misses by {by}", by=number(one.largest - 1, "%"))


def _beside(asked: AskedDrive, one: Trial, chosen: Trial) -> Iterator[Number]:
    """Numbers that stand in a table of several."""
    for each in numbers(asked, one, chosen):
        if each.name not in _NOT_BESIDE and np.isfinite(each.value):
            yield each


def remarks(bench: Bench, chosen: Trial, sizes: Sequence[Trial]) -> Iterator[Words]:
    """Say what governs, how far the next smaller motor misses, how it was chosen, and what typical values are."""
    asked = bench.asked
    words = {"power": number(chosen.power, "kW"), "share": number(chosen.largest, "%")}
    yield _("What governs {power} is: {check}, {share}.", check=chosen.governing, **words)
    smaller = next((one for one in reversed(sizes) if one.place < chosen.place), None)
    if smaller is not None and np.isfinite(smaller.largest):
        by = number(smaller.largest - 1, "%")
        said = _("{power} misses by {by}: {check}.")
        yield said.format(power=number(smaller.power, "kW"), by=by, check=smaller.governing)
    elif smaller is not None and np.isfinite(smaller.speed):
        yield _("{power} cannot: {check}.", power=number(smaller.power, "kW"), check=smaller.governing)
    elif smaller is not None:
        yield _("{power} does not carry the machine through its cycle.", power=number(smaller.power, "kW"))
    elif chosen.place > 0:
        yield _("Smaller motors do not bear the mean torque of the load for long.")
    yield from _of_flywheel(bench, chosen)
    yield from _of_slip(asked, chosen)
    spec: DriveSpec | None = asked.machine.drive
    duty = None if spec is None else spec.duty
    if spec is not None and spec.clutch is not None:
        yield _("It starts with its clutch let go: what turns before it, without load.")
        if spec.stroke is not None:
            yield _("[drive.stroke] is not counted: it runs through, stroke after stroke.")
    elif duty is not None and duty.start == "unloaded":
        yield _("It is started unloaded: against weights and drags, before loads act.")
    yield _("Values of typical motors are nobody's: a maker's replace them before a motor is bought.")
    if duty is None or duty.model_fields_set <= {"start"}:
        yield _(
            "[drive.duty] says nothing of time: it runs on and on; how long a start takes, and how many an hour it"
            " makes, are not checked."
        )


def _of_flywheel(bench: Bench, chosen: Trial) -> Iterator[Words]:
    """Say how the flywheel was chosen, and what the formula for one peak would give."""
    sought = bench.asked.flywheel
    if sought is None:
        return
    said = _("Aim: the smallest motor that is enough with a flywheel of any size; of it the least flywheel.")
    if np.isfinite(sought.most):
        said = _("Aim: the smallest motor that is enough with at most {most}; of it the least flywheel.")
    yield said.format(most=number(sought.most, "kg·m²"))
    cycle, behind = chosen.checked.cycle, bench.behind(chosen.ratio)
    if cycle is None or not chosen.flywheel > 0:
        return
    formula = formula_inertia(
        behind.static, cycle.period, bench.motor(chosen.place), design=0, allowed=chosen.checked.peak
    )
    turned = float(np.prod(behind.gearing.ratio[: sought.shaft]))
    own = float(behind.static.driven_inertia[0, 0].mean())
    added = (formula - own) * turned**2
    if np.isfinite(added):
        said = _("For the same largest torque the formula for one peak after a full recovery gives {formula}: {error}.")
        yield said.format(
            formula=number(max(added, 0.0), "kg·m²"),
            error=f"{100 * (added / chosen.flywheel - 1):+.0f} %".replace("-", "−"),
        )


def _of_slip(asked: AskedDrive, chosen: Trial) -> Iterator[Words]:
    """Say where the motor is another kind than the declared one, or has another slip."""
    spec: DriveSpec | None = asked.machine.drive
    motor = None if spec is None else spec.motor
    own, ordinary = declared_slip(asked.machine), number(typical_slip(chosen.place), "%")
    if motor is not None and motor.slip_at_rating is None:
        yield _('The declared motor, kind = "{kind}", is replaced by an ordinary cage motor.', kind=motor.kind)
    elif own.slip is not None and asked.kept != own:
        said = _("The slip at the rated torque is {slip}; the declared motor has {own}.")
        yield said.format(slip=number(chosen.slip, "%"), own=number(own.slip or 0.0, "%"))
    elif asked.kept != KeptSlip():
        said = _("The slip of the declared motor is kept, {slip}; an ordinary cage motor of this size has {ordinary}.")
        if own.slip is None:
            said = _("The slip is {slip}; an ordinary cage motor of this size has {ordinary}.")
        yield said.format(slip=number(chosen.slip, "%"), ordinary=ordinary)
