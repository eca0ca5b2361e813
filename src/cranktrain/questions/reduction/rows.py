"""What is said of the reduced machine: static torque and inertia at the motor."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.questions.reduction.static_torques import StaticTorques
from cranktrain.saying.rows import Amount, AnswerLine, Extent, worded
from cranktrain.saying.wording import Names

_WORTH_A_ROW = 0.01
"""Of the largest torque: where another law of losses gives less of a difference, the results alone have it."""


def static_rows(labels: Names, design: int, found: StaticTorques) -> Iterator[AnswerLine]:
    """Range of the static torque at the first shaft, of the inertia there, and what it is of the drive alone."""
    most, least = found.largest_static_torque, found.smallest_static_torque
    yield worded(
        _("static torque at {shaft}", shaft=labels["drive_shaft"][0]),
        _("{range}; effective {rms}"),
        range=Extent(float(least.value[design, 0]), float(most.value[design, 0]), "N*m"),
        rms=Amount(float(found.rms_static_torque[design, 0]), "N*m"),
    )
    ends = np.stack([found.smallest_static_motor_torque[design], found.largest_static_motor_torque[design]])
    own, same_back = ends[:, 0], ends[:, 1]
    if np.any(np.abs(same_back - own) > _WORTH_A_ROW * np.max(np.abs(own))):
        alike = Extent(float(same_back[0]), float(same_back[1]), "N*m")
        yield worded(_("with η alike both ways"), "{range}", range=alike)
    inertia = found.driven_inertia[design, 0]
    yield worded(
        _("J at {shaft}, GD² = 4 J", shaft=labels["drive_shaft"][0]),
        _("{range}, alone {own}"),
        range=Extent(float(np.min(inertia)), float(np.max(inertia)), "kg*m^2"),
        own=Amount(float(found.gear_flywheel_moment[design, 0]) / 4, "kg*m^2"),
    )
