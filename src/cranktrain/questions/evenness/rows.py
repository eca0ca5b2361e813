"""What evenness says in the answer: excess work, the speed over the cycle, the flywheel and its rim, the load."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import N_, _
from cranktrain.questions.evenness.flywheel import FlywheelSize, RimSize
from cranktrain.questions.evenness.running_speed import RunningSpeed
from cranktrain.questions.evenness.shaft_balance import ShaftBalance
from cranktrain.questions.evenness.shaft_torque import LoadTorque
from cranktrain.questions.evenness.shaft_work import ShaftWork
from cranktrain.saying.amounts import Amount
from cranktrain.saying.rows import AnswerLine, Telling, valued, worded


def running_rows(of: Telling, work: ShaftWork, running: RunningSpeed | None) -> Iterator[AnswerLine]:
    """Work that the flywheel takes up and gives back, and the speed that comes of it."""
    yield of.row(_("excess work"), work, "largest_excess_work", _("{values} within a cycle"))
    if running is not None:
        speed = of.extent(running, "smallest_crank_speed", "largest_crank_speed")
        yield of.line(_("speed"), N_("{speed}, δ = {coefficient_of_fluctuation}"), running, speed=speed)


def load_rows(of: Telling, load: LoadTorque) -> Iterator[AnswerLine]:
    """The loads on the shaft, with their factor where they were fitted to the machine."""
    factor, most = of.amount(load, "load_factor"), of.amount(load, "largest_load_torque")
    if not np.isfinite(factor.value * most.value):
        return
    scaled, given = _("{values}, at most {most}: the given one times {factor}"), _("{values}, at most {most}")
    words = (scaled if load.is_scaled else given).format(most=most, factor=factor)
    yield valued(_("load, on the mean"), load.mean_torque[of.design], "N*m", words=words, quantity="load_torque")


def balance_rows(of: Telling, balance: ShaftBalance) -> Iterator[AnswerLine]:
    """What drives or loads the shaft besides all that the file gives, where it is much."""
    rest = balance.undeclared(of.design)
    if rest != 0:
        balances = (
            _("a further {rest} drives the shaft, which stands nowhere in the file")
            if rest < 0
            else _("a further {rest} loads the shaft, which stands nowhere in the file")
        )
        yield worded(_("balanced by"), balances.format(rest=Amount(abs(rest), "N*m", "remaining_torque")))


def flywheel_rows(of: Telling, found: FlywheelSize, rim: RimSize | None) -> Iterator[AnswerLine]:
    """The flywheel for the evenness that is wanted, exact and as others reckon it, and its rim."""
    name = _("flywheel for δ {wanted}", wanted=f"{float(found.wanted[of.design]):.4g}")
    if of.values(found, "flywheel_inertia")[0] <= 0:
        yield worded(name, _("none: the moving parts alone suffice"), quantity="flywheel_inertia")
    else:
        mertsalov, textbook = (of.amount(found, "flywheel_inertia_error", form, unit="off") for form in (1, 2))
        words = _("{values}, Mertsalov {mertsalov}, textbooks {textbook}", mertsalov=mertsalov, textbook=textbook)
        yield of.row(name, found, "flywheel_inertia", words, own=[0])
    if rim is not None:
        message = N_("{rim_height} high, {rim_width} wide, {rim_outer_diameter} outside, {rim_mass}, {rim_speed}")
        yield of.line(_("its rim"), message, rim)
