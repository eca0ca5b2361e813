"""What a start leaves out of a machine file, or does not come to."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.motors import DeclaredMotor
from cranktrain.motors.declared import LONG_SINCE, beyond_measured
from cranktrain.questions.start.asked import MovingParts
from cranktrain.questions.start.parts import DeclaredStart
from cranktrain.questions.start.record import StartRun

_TIMES = ("motor_off", "motor_reversed", "brake_on", "unloaded_until")
"""Keys of [drive.start] that are commands at a time."""
_AS_LATER = 1e-9
"""By how much a motor may differ from itself long since, in parts, whose starter is through."""

NO_MOTOR = N_("[drive.motor] is missing: what acts is loads and weights alone.")
WISH_LEFT = N_("[shaft.main.motion] is not followed: the motor and the loads alone move the crank here.")
CLUTCH_LOCKED = N_("[drive.clutch] stays locked: only [drive.stroke] lets it slip.")
BRAKE_OFF = N_("[drive.brake] stays off: brake_on in [drive.start] says when it comes.")
NOT_REACHED = N_("{key} = {given} is not reached.")
BEHIND_STARTER = N_("Its starter is left out: in strokes the motor is on the line.")
IN_STARTER = N_("Its starter is not through yet; steady running is that of the motor behind it: see duration.")


def start_notes(parts: MovingParts, run: StartRun) -> Iterator[Words]:
    """Sentences on what a start does not use, and on commands that come after its end."""
    motor, start = parts.motor, parts.start.of(0)
    if motor is None:
        yield _(NO_MOTOR)
    if parts.wanted is not None or parts.rocking is not None:
        yield _(WISH_LEFT)
    if motor is not None:
        yield from beyond_measured(motor, 0, run.whole.motor_speed)
    if parts.stroke is not None:
        if motor is not None and motor.law.is_timed:
            yield _(BEHIND_STARTER)
        return
    if parts.clutch is not None:
        yield _(CLUTCH_LOCKED)
    if parts.brake is not None and np.isinf(start.brake_on):
        yield _(BRAKE_OFF)
    yield from _not_reached(parts.start, run)
    if motor is not None and np.isinf(min(start.motor_off, start.motor_reversed)) and _is_starting(motor, run):
        yield _(IN_STARTER)


def _not_reached(declared: DeclaredStart, run: StartRun) -> Iterator[Words]:
    """Commands and a speed that the run does not come to."""
    end = float(run.whole_time[-1])
    start, texts = declared.of(0), declared.texts
    late = [key for key in _TIMES if key in texts and getattr(start, key) >= end]
    if "until_speed" in texts and float(np.max(np.abs(run.whole.crank_speed))) < start.until_speed:
        late.append("until_speed")
    yield from (_(NOT_REACHED, key=key, given=texts[key]) for key in late)


def _is_starting(motor: DeclaredMotor, run: StartRun) -> bool:
    """Whether the motor gives at the end another torque than it will long since."""
    speed = run.whole.motor_speed[-1:]
    now, later = (motor.torque(speed, time)[0, 0] for time in (run.whole_time[-1], LONG_SINCE))
    return bool(abs(now - later) > _AS_LATER * max(abs(now), abs(later)))
