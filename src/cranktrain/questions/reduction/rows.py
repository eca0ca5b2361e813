"""What is said of the reduced machine: static torque and inertia at the motor."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from cranktrain.language import _
from cranktrain.questions.reduction.static_torques import StaticTorques
from cranktrain.saying.amounts import Extent
from cranktrain.saying.rows import AnswerLine, Telling, worded

_WORTH_A_ROW = 0.01
"""Of the largest torque: where another law of losses gives less of a difference, the results alone have it."""


def static_rows(of: Telling, found: StaticTorques) -> Iterator[AnswerLine]:
    """Range of the static torque at the first shaft, of the inertia there, and what it is of the drive alone."""
    shaft = of.titles["drive_shaft"][0]
    yield worded(
        _("static torque at {shaft}", shaft=shaft),
        _(
            "{range}; effective {rms}",
            range=of.extent(found, "smallest_static_torque", "largest_static_torque", 0),
            rms=of.amount(found, "rms_static_torque", 0),
        ),
    )
    least, most = "smallest_static_motor_torque", "largest_static_motor_torque"
    ends = np.stack([of.values(found, least), of.values(found, most)])
    own, same_back = ends[:, 0], ends[:, 1]
    if np.any(np.abs(same_back - own) > _WORTH_A_ROW * np.max(np.abs(own))):
        yield worded(_("with η alike both ways"), of.extent(found, least, most, 1))
    inertia = of.values(found, "driven_inertia")[0]
    alone = of.amount(found, "gear_flywheel_moment", 0)
    yield worded(
        _("J at {shaft}, GD² = 4 J", shaft=shaft),
        _(
            "{range}, alone {own}",
            range=Extent(float(np.min(inertia)), float(np.max(inertia)), "kg*m^2", quantity="driven_inertia"),
            own=replace(alone, value=alone.value / 4),
        ),
    )
