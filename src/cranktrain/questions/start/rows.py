"""What a start says in the answer: why it ended, what the motor gave, where the energy went, how close it is."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.questions.start.record import StrokeRun
from cranktrain.questions.start.starting import EVENTS, StartRun
from cranktrain.saying.amounts import Amount, Extent
from cranktrain.saying.rows import AnswerLine, worded
from cranktrain.transient.clutched.equation import ANGLE
from cranktrain.transient.endings import REVERSAL

_ROUNDING = 1e-9
_SAME = 8
"""Times that so many of the least differences of floats part are one."""
_LIKE_ITS_NEIGHBOURS = 10.0
"""A step longer than so many of those beside it, such as a pause, has other slopes than these tell."""


def start_rows(run: StartRun) -> Iterator[AnswerLine]:
    """Rows of a run, in the order in which people ask."""
    curves, time = run.whole, run.whole_time
    turned = curves.crank_angle_turned
    yield worded(_("it ends after"), _("{time}: {reason}", time=Amount(float(time[-1]), "s"), reason=run.reason))
    yield worded(
        _("turns of the crank"),
        _(
            "{turns}, reversals: {n}; at the end it turns at {speed}",
            turns=f"{float(turned[-1] - turned[0]) / (2 * np.pi):.4g}".replace("-", "−"),
            n=str(_reversals(run)),
            speed=Amount(_last(curves.crank_speed), "rpm"),
        ),
    )
    torque = curves.motor_torque
    yield worded(
        _("torque of the motor"),
        _(
            "{range}; effective {rms}",
            range=Extent(float(np.min(torque)), float(np.max(torque)), "N*m"),
            rms=Amount(effective_torque(torque, time), "N*m"),
        ),
    )
    yield worded(
        _("power of the motor"),
        Extent(float(np.min(curves.motor_power)), float(np.max(curves.motor_power)), "W"),
    )
    words = (
        _(
            "motor gives {motor}, loads take {load}, gearing, clutch and brake lose {lost}; {kinetic} in motion at the"
            " end, {first} at the beginning"
        )
        if curves.kinetic_energy[0] > 0
        else _(
            "motor gives {motor}, loads take {load}, gearing, clutch and brake lose {lost}; {kinetic} in motion at the"
            " end"
        )
    )
    yield worded(
        _("energy"),
        words.format(
            first=Amount(float(curves.kinetic_energy[0]), "J"),
            motor=Amount(_last(curves.motor_work), "J"),
            load=Amount(_last(curves.load_work), "J"),
            lost=Amount(_last(curves.lost_work), "J"),
            kinetic=Amount(_last(curves.kinetic_energy), "J"),
        ),
    )
    if run.stroke is not None:
        yield from _stroke_rows(run.stroke)
    if np.any(curves.motor_heat > 0):
        yield worded(_("heat in the rotor"), Amount(_last(curves.motor_heat), "J"))
    yield from (worded(_("mind"), note) for note in run.notes)
    yield worded(
        _("computed"),
        _(
            "by {method} in {n} steps at {tolerance}; energy left over: {residual} of what was given",
            method=run.method,
            n=str(run.n_steps),
            tolerance=f"{run.tolerance:.0e}",
            residual=f"{abs(run.residual) / run.supplied if run.supplied else 0.0:.1e}",
        ),
    )


def _stroke_rows(found: StrokeRun) -> Iterator[AnswerLine]:
    """What clutch and brake did, and the longest stop that a command on the way could lead to."""
    stroke, worst = found.settled.stroke, found.longest_stop
    yield worded(
        _("clutch"),
        _("slips for {time}, takes {heat}", time=Amount(stroke.slip_time, "s"), heat=Amount(stroke.clutch_heat, "J")),
    )
    stopping = worded(
        _("brake"),
        _(
            "stops in {angle}, {time}, takes {heat}",
            angle=Amount(stroke.brake_angle, "rad"),
            time=Amount(stroke.brake_time, "s"),
            heat=Amount(stroke.brake_heat, "J"),
        ),
    )
    yield stopping if stopping.says else worded(_("brake"), _("is not commanded"))
    if worst is not None and np.isfinite(worst.time):
        yield worded(
            _("longest stop"),
            _(
                "{time}, commanded at {at_time}; {angle}, commanded at {at_angle} from the start",
                time=Amount(worst.time, "s"),
                at_time=Amount(worst.time_command - float(stroke.run.start.state[ANGLE]), "rad"),
                angle=Amount(worst.angle, "rad"),
                at_angle=Amount(worst.angle_command - float(stroke.run.start.state[ANGLE]), "rad"),
            ),
        )


def _reversals(run: StartRun) -> int:
    """How often it turned round and went on the other way."""
    return sum(event.sort == EVENTS[REVERSAL] for event in run.events)


def _last(curve: Array) -> float:
    """Value at the end; 0 where only rounding is left of it."""
    return float(curve[-1]) if abs(curve[-1]) > _ROUNDING * np.max(np.abs(curve)) else 0.0


def effective_torque(torque: Array, time: Array) -> float:
    """Root mean square of a torque over the time; of a run that ends as it begins, its only value.

    Parameters
    ----------
    torque, time : Array, shape (n,)
        Samples, in steps of any length. [N·m, s]

    Returns
    -------
    float
        [N·m]
    """
    if time[-1] <= time[0]:
        return abs(float(torque[-1]))
    last = np.append(
        np.diff(time) > _SAME * np.spacing(time[1:]), True
    )  # of those at one time, where a part of the run follows another
    torque, time = torque[last], time[last]
    squares, steps = torque**2, np.diff(time)
    beside = np.minimum(np.append(np.inf, steps[:-1]), np.append(steps[1:], np.inf))
    left_out = steps**2 * np.diff(np.gradient(squares, time)) / 12  # by chords
    bent = np.sum(left_out[steps <= _LIKE_ITS_NEIGHBOURS * beside])
    return float(np.sqrt(max(0.0, np.trapezoid(squares, time) - bent) / (time[-1] - time[0])))
