"""What loads say in the answer: work and power, and how large they are at most."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import _
from cranktrain.numerics import Peak
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.questions.loads.load_work import LoadWork
from cranktrain.saying.rows import Amount, AnswerLine, valued, worded
from cranktrain.saying.wording import Names

_LITTLE = 0.01
"""Of the inertia's torque on the crank: loads of less are told, as they may stand in N for kN."""


def load_rows(labels: Names, design: int, work: LoadWork, torques: MechanismTorques | None) -> Iterator[AnswerLine]:
    """Work and power of every load: less than 0 where the machine works against it; largest force or torque."""
    names = labels["load"]
    yield valued(_("work in a cycle"), work.load_work[design], "J", names)
    yield valued(_("mean power"), work.mean_load_power[design], "W", names)
    yield valued(_("largest power"), work.largest_load_power.value[design], "W", names)
    yield _largest(_("largest force"), work.largest_load_force, "N", names, design)
    yield _largest(_("largest torque"), work.largest_load_moment, "N*m", names, design)
    if torques is not None:
        yield from _beside_inertia(design, work, torques)


def _beside_inertia(design: int, work: LoadWork, torques: MechanismTorques) -> Iterator[AnswerLine]:
    """How small the torque of all loads on the crank is beside that of the inertia, where it is next to nothing."""
    inertia = float(np.max(np.abs(torques.reduced_inertia_slope[design]))) * work.speed[design] ** 2 / 2
    most = float(np.max(np.abs(np.sum(work.load_torque_on_crank[design], axis=0))))
    if 0 < most < _LITTLE * inertia:
        words = _("at most {part} of its torque on the crank")
        yield worded(_("beside inertia"), words, part=Amount(most / inertia, "%"))


def _largest(name: str, peak: Peak, unit: str, names: Sequence[str], design: int) -> AnswerLine:
    """Largest size of every load of a sort, of one alone also where."""
    value, angle = peak.value[design], peak.angle[design]
    if len(names) > 1 or not np.isfinite(angle[0]):
        return valued(name, value, unit, names)
    return valued(name, value, unit, names, _("at {angle}"), angle=Amount(float(angle[0]), "position"))
