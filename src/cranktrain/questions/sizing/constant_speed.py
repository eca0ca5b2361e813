"""What of a declared motor it takes to hold the declared speed all over the turn."""

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.numerics.designs import by_design
from cranktrain.questions.reduction.constant_speed import ConstantSpeedDrive
from cranktrain.questions.sizing.motor_limits import motor_limits, peak_share
from cranktrain.questions.sizing.parts import DeclaredDuty
from cranktrain.record import record
from cranktrain.saying.catalogue import quantity

_THEORY = "docs/theory/drive"


@record
class ConstantSpeedUse:
    """Shares of a motor that holds the declared speed; NaN where its plate does not say what it can."""

    constant_speed_rms_share: Array = quantity(
        "u_rms", "1", (), N_("Effective torque at constant speed, of what the motor bears for long"), _THEORY, "25.32"
    )
    constant_speed_peak_share: Array = quantity(
        "u_max",
        "1",
        (),
        N_("Largest torque at constant speed, of the motor's breakdown or peak torque at the lowest voltage"),
        _THEORY,
        "25.32",
    )


def constant_speed_use(held: ConstantSpeedDrive, motor: DeclaredMotor, duty: DeclaredDuty) -> ConstantSpeedUse:
    """Compare torque at constant speed with the rated and the largest one of the motor.

    Notes
    -----
    docs/theory/drive, eq. (25.32), as of its own running: with the factor of its duty and what the voltage leaves.
    """
    ends = (held.largest_constant_speed_torque.value, held.smallest_constant_speed_torque.value)
    largest = np.max(np.abs(np.stack([end[:, 0] for end in ends])), axis=0)
    n_designs = len(largest)
    factor, reserve = by_design([duty.factor, duty.reserve], n_designs).T
    own, rms = motor.over_designs(n_designs), held.rms_constant_speed_torque[:, 0]
    limits = [motor_limits(own, design, float(reserve[design])) for design in range(n_designs)]
    peaks = [
        peak_share(own, design, limit, largest[design : design + 1], held.constant_motor_speed[design : design + 1])
        for design, limit in enumerate(limits)
    ]
    return ConstantSpeedUse(
        constant_speed_rms_share=rms / (factor * np.array([limit.rated for limit in limits])),
        constant_speed_peak_share=np.concatenate(peaks),
    )
