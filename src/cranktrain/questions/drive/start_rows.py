"""What a start says in the answer: why it ended, what the motor gave, where the energy went, how close it is."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.questions.drive.running.endings import REVERSAL
from cranktrain.questions.drive.starting import EVENTS, StartRun
from cranktrain.rows import Amount, AnswerLine, Extent, worded


def start_rows(run: StartRun) -> Iterator[AnswerLine]:
    """Rows of a run, in the order in which people ask."""
    curves, time = run.curves, run.time
    turned = curves.crank_angle_turned
    yield worded(_("it ends after"), _("{time}: {reason}"), time=Amount(float(time[-1]), "s"), reason=run.reason)
    reversals = sum(event.name == _(EVENTS[REVERSAL]) for event in run.events)
    yield worded(
        _("crank turned"),
        _("{turns} turns, {n} reversals; at the end it turns at {speed}"),
        turns=f"{float(turned[-1] - turned[0]) / (2 * np.pi):.4g}",
        n=str(reversals),
        speed=Amount(float(curves.crank_speed[-1]), "rpm"),
    )
    torque = curves.motor_torque
    yield worded(
        _("torque of the motor"),
        _("{range}; effective {rms}"),
        range=Extent(float(np.min(torque)), float(np.max(torque)), "N*m"),
        rms=Amount(_effective(torque, time), "N*m"),
    )
    yield worded(
        _("power of the motor"),
        _("{range}"),
        range=Extent(float(np.min(curves.motor_power)), float(np.max(curves.motor_power)), "W"),
    )
    yield worded(
        _("energy"),
        _("motor gives {motor}, loads take {load}, gearing and brake lose {lost}; {kinetic} in motion at the end"),
        motor=Amount(float(curves.motor_work[-1]), "J"),
        load=Amount(float(curves.load_work[-1]), "J"),
        lost=Amount(float(curves.lost_work[-1]), "J"),
        kinetic=Amount(float(curves.kinetic_energy[-1]), "J"),
    )
    if np.any(curves.motor_heat > 0):
        yield worded(_("heat in the rotor"), "{heat}", heat=Amount(float(curves.motor_heat[-1]), "J"))
    yield worded(
        _("computed"),
        _("by {method} in {n} steps at {tolerance}; energy left over: {residual} of what was given"),
        method=run.method,
        n=str(run.n_steps),
        tolerance=f"{run.tolerance:.0e}",
        residual=f"{abs(run.residual) / run.supplied if run.supplied else 0.0:.1e}",
    )


def _effective(torque: Array, time: Array) -> float:
    """Root mean square over the time."""
    if time.size < 2:
        return float("nan")
    return float(np.sqrt(np.trapezoid(torque**2, time) / (time[-1] - time[0])))
