"""What forces say in the answer: the largest ones."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.forces.crank_pins import CrankPinLoads
from cranktrain.questions.forces.guides import GuideEdges
from cranktrain.questions.forces.joint_forces import JointForces
from cranktrain.questions.forces.largest_forces import LargestForces
from cranktrain.saying.rows import Amount, AnswerLine, valued
from cranktrain.saying.wording import Names


def force_rows(
    labels: Names,
    design: int,
    joints: JointForces,
    largest: LargestForces | None,
    pins: CrankPinLoads | None,
    edges: GuideEdges | None,
) -> Iterator[AnswerLine]:
    """Of rods, against guides, on crank pins and edges; of a machine without such rods in its joints."""
    if largest is not None:
        pistons = labels["piston"]
        yield valued(_("in the rod"), largest.largest_rod_force.value[design], "N", pistons)
        yield valued(_("side force"), largest.largest_side_force.value[design], "N", pistons)
    if pins is not None:
        load = pins.largest_crankpin_load
        yield from _largest(
            _("on a crank pin"), load.value[design], load.angle[design], labels["mechanism"], _("rod of {member}")
        )
    if edges is not None:
        edge = edges.largest_guide_edge_force
        yield from _largest(_("on an edge of a guide"), edge.value[design], edge.angle[design], labels["guide"])
    if largest is None and pins is None:
        joint = joints.largest_joint_force
        yield from _largest(_("in a joint"), joint.value[design], joint.angle[design], labels["joint"])


def _largest(
    name: str, values: Array, angles: Array, members: Sequence[str], whose: str = "{member}"
) -> Iterator[AnswerLine]:
    """Say the largest of some values, and where and of whom it is."""
    if not np.any(np.isfinite(values)):
        return
    worst = first_largest(values)
    if np.isnan(angles[worst]):  # of nothing, which is largest nowhere
        yield valued(name, values[worst], "N")
        return
    yield valued(
        name,
        values[worst],
        "N",
        (),
        _("at {angle}, {whose}", angle="{angle}", whose=whose) if len(members) > 1 else _("at {angle}"),
        angle=Amount(float(angles[worst]), "position"),
        member=members[worst],
    )
