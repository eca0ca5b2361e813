"""One design of a machine with its motor, ready to start."""

import numpy as np

from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.questions.start.parts import StartOrders
from cranktrain.questions.start.switching import Braking
from cranktrain.record import record
from cranktrain.transient.equation import BrakePlace
from cranktrain.transient.gearing import Gearing
from cranktrain.transient.reduced import ReducedMachine


@record
class StartCase:
    """One design, ready to start.

    Attributes
    ----------
    machine : ReducedMachine
    corners : Array
        φ of its loads' corners. [rad]
    rows : Array
        φ of rows of long load curves that are next to no corners. [rad]
    cycle : float
        After which these come again. [rad]
    gearing : Gearing
    motor : DeclaredMotor or None
    design : int
    start : StartOrders
    interval_text : str
        As the file has it, nothing without one.
    brake : Braking
        From its command on: `begins` is its delay.
    place : BrakePlace
    zero : float
        φ where the shown crank angle is 0. [rad]
    steady_speed, cycle_time : float
        Mean speed of the crank in steady running, and the time of a cycle; NaN without it. [rad/s, s]
    """

    machine: ReducedMachine
    corners: Array
    rows: Array
    cycle: float
    gearing: Gearing
    motor: DeclaredMotor | None
    design: int
    start: StartOrders
    interval_text: str
    brake: Braking
    place: BrakePlace
    zero: float
    steady_speed: float
    cycle_time: float

    @property
    def is_to_settle(self) -> bool:
        """Whether it ends where it runs as it will, as nothing else is asked for."""
        start = self.start
        others = (start.duration, start.until_speed, start.motor_off, start.brake_on)
        return bool(np.isfinite(self.steady_speed)) and bool(np.all(np.isinf(others)))
