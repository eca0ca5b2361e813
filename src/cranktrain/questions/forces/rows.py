"""What forces say in the answer: the largest ones."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import Message, Words, _
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.forces.crank_pins import CrankPinLoads
from cranktrain.questions.forces.guides import GuideEdges
from cranktrain.questions.forces.joint_forces import JointForces
from cranktrain.questions.forces.largest_forces import LargestForces
from cranktrain.saying.rows import AnswerLine, Telling


def force_rows(
    of: Telling,
    joints: JointForces,
    largest: LargestForces | None,
    pins: CrankPinLoads | None,
    edges: GuideEdges | None,
) -> Iterator[AnswerLine]:
    """Of rods, against guides, on crank pins and edges; of a machine without such rods in its joints.

    Of double-acting pistons with gas rod loads say more than the largest force in the rod.
    """
    if largest is not None:
        if not largest.has_rod_loads:
            yield of.row(_("in the rod"), largest, "largest_rod_force")
        yield of.row(_("side force"), largest, "largest_side_force")
    if pins is not None:
        yield from _largest(of, _("on a crank pin"), pins, "largest_crankpin_load", _("rod of {member}"))
    if edges is not None:
        yield from _largest(of, _("on an edge of a guide"), edges, "largest_guide_edge_force")
    if largest is None and pins is None:
        yield from _largest(of, _("in a joint"), joints, "largest_joint_force")


def _largest(
    of: Telling, name: Words, found: object, quantity: str, whose: Message | None = None
) -> Iterator[AnswerLine]:
    """Say the largest of some values, and where and of whom it is."""
    values = of.values(found, quantity)
    if not np.any(np.isfinite(values)):
        return
    worst = first_largest(values)
    at = of.amount(found, f"{quantity}_at", worst)
    (member,) = of.amount(found, quantity, worst).member
    of_whom = member if whose is None else whose.format(member=member)
    one, many = _("{values} at {angle}", angle=at), _("{values} at {angle}, {whose}", angle=at, whose=of_whom)
    # What is nothing is largest nowhere.
    words = None if np.isnan(at.value) else many if values.size > 1 else one
    yield of.row(name, found, quantity, words, own=[worst])
