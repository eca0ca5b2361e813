"""What loads say in the answer: work and power, and how large they are at most."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import Words, _
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.questions.loads.load_work import LoadWork
from cranktrain.saying.amounts import Amount
from cranktrain.saying.rows import AnswerLine, Telling, worded

_LITTLE = 0.01
"""Of the inertia's torque on the crank: loads of less are told, as they may stand in N for kN."""


def load_rows(of: Telling, work: LoadWork, torques: MechanismTorques | None) -> Iterator[AnswerLine]:
    """Work and power of every load: less than 0 where the machine works against it; largest force or torque."""
    yield of.row(_("work in a cycle"), work, "load_work")
    yield of.row(_("mean power"), work, "mean_load_power")
    yield of.row(_("largest power"), work, "largest_load_power")
    yield _largest(of, _("largest force"), work, "largest_load_force")
    yield _largest(of, _("largest torque"), work, "largest_load_moment")
    if torques is not None:
        yield from _beside_inertia(of, work, torques)


def _beside_inertia(of: Telling, work: LoadWork, torques: MechanismTorques) -> Iterator[AnswerLine]:
    """How small the torque of all loads on the crank is beside that of the inertia, where it is next to nothing."""
    slope = of.values(torques, "reduced_inertia_slope")
    inertia = float(np.max(np.abs(slope))) * work.speed[of.design] ** 2 / 2
    most = float(np.max(np.abs(np.sum(of.values(work, "load_torque_on_crank"), axis=0))))
    if 0 < most < _LITTLE * inertia:
        part = Amount(most / inertia, "%", "load_torque_on_crank")
        yield worded(_("beside inertia"), _("at most {part} of its torque on the crank", part=part))


def _largest(of: Telling, name: Words, work: LoadWork, quantity: str) -> AnswerLine:
    """Largest size of every load of a sort, of one alone also where."""
    at = of.amount(work, f"{quantity}_at", 0)
    is_placed = len(of.labels["load"]) == 1 and np.isfinite(at.value)
    return of.row(name, work, quantity, _("{values} at {angle}", angle=at) if is_placed else None)
