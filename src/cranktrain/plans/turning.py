"""How the crank of a plan turns: evenly, or at the speed over the cycle."""

import numpy as np

from cranktrain.layout.speed import Speed, SpeedCurve
from cranktrain.linkage.forces import Drive
from cranktrain.machine import Machine
from cranktrain.motion import Array, single


def turning(machine: Machine, curve: SpeedCurve | None, angle: Array, design: int = 0) -> Drive:
    """Speed and acceleration of the crank.

    Parameters
    ----------
    machine : Machine
        Without a speed its crank turns by 1 rad/s.
    curve : SpeedCurve or None
        None for a crank that turns evenly.
    angle : Array, shape (n,)
        φ. [rad]
    design : int
        Which of the curve's machines.

    Returns
    -------
    Drive, arrays of shape (n,)
    """
    declared = machine.main_shaft.speed
    speed = Speed(single(1.0 if declared is None else declared.si), curve)
    shape = (1 if curve is None else len(curve.zero), 1, angle.size)
    return Drive(*(np.broadcast_to(part, shape)[design if curve else 0, 0] for part in speed.drive(angle)))
