"""What evenness says in the answer: excess work, the speed over the cycle, the flywheel and its rim, the load."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.questions.evenness.flywheel import FlywheelSize, RimSize
from cranktrain.questions.evenness.running_speed import RunningSpeed
from cranktrain.questions.evenness.shaft_balance import ShaftBalance
from cranktrain.questions.evenness.shaft_torque import LoadTorque
from cranktrain.questions.evenness.shaft_work import ShaftWork
from cranktrain.saying.rows import Amount, AnswerLine, Extent, valued, worded
from cranktrain.saying.wording import Names


def running_rows(labels: Names, design: int, work: ShaftWork, running: RunningSpeed | None) -> Iterator[AnswerLine]:
    """Work that the flywheel takes up and gives back, and the speed that comes of it."""
    yield valued(_("excess work"), work.largest_excess_work[design], "J", (), _("within a cycle"))
    if running is not None:
        least, most = running.smallest_crank_speed.value[design], running.largest_crank_speed.value[design]
        fluctuation = Amount(float(running.coefficient_of_fluctuation[design]), "1")
        yield worded(
            _("speed"),
            _("{speed}, δ = {fluctuation}"),
            speed=Extent(float(least), float(most), "rpm"),
            fluctuation=fluctuation,
        )


def load_rows(labels: Names, design: int, load: LoadTorque) -> Iterator[AnswerLine]:
    """The loads on the shaft, with their factor where they were fitted to the machine."""
    factor, most = float(load.load_factor[design]), float(load.largest_load_torque[design])
    if not np.isfinite(factor * most):
        return
    pieces = {"most": Amount(most, "N*m")}
    if load.is_scaled:
        said = _(", at most {most}: the given one times {factor}")
        pieces["factor"] = Amount(factor, "1")
    else:
        said = _(", at most {most}")
    yield valued(_("load, on the mean"), load.mean_torque[design], "N*m", words=said, **pieces)


def balance_rows(labels: Names, design: int, balance: ShaftBalance) -> Iterator[AnswerLine]:
    """What drives or loads the shaft besides all that the file gives, where it is much."""
    rest = balance.undeclared(design)
    if rest != 0:
        balances = (
            _("a further {rest} drives the shaft, which stands nowhere in the file")
            if rest < 0
            else _("a further {rest} loads the shaft, which stands nowhere in the file")
        )
        yield worded(_("balanced by"), balances, rest=Amount(abs(rest), "N*m"))


def flywheel_rows(labels: Names, design: int, found: FlywheelSize, rim: RimSize | None) -> Iterator[AnswerLine]:
    """The flywheel for the evenness that is wanted, exact and as others reckon it, and its rim."""
    size = float(found.flywheel_inertia[design, 0])
    name = _("flywheel for δ {wanted}", wanted=f"{float(found.wanted[design]):.4g}")
    if size <= 0:
        yield worded(name, _("none: the moving parts alone suffice"))
    else:
        _exact, mertsalov, textbook = (Amount(float(one), "off") for one in found.flywheel_inertia_error[design])
        yield valued(
            name,
            size,
            "kg*m^2",
            (),
            _(", Mertsalov {mertsalov}, textbooks {textbook}"),
            mertsalov=mertsalov,
            textbook=textbook,
        )
    if rim is not None:
        yield worded(
            _("its rim"),
            _("{height} high, {width} wide, {diameter} outside, {mass}, {speed}"),
            height=Amount(float(rim.rim_height[design]), "m"),
            width=Amount(float(rim.rim_width[design]), "m"),
            diameter=Amount(float(rim.rim_outer_diameter[design]), "m"),
            mass=Amount(float(rim.rim_mass[design]), "kg"),
            speed=Amount(float(rim.rim_speed[design]), "m/s"),
        )
