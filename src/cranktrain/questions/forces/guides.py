"""Edges of guides: what each of them presses, of what slides in a guide whose length is given."""

from collections.abc import Sequence

import numpy as np

from cranktrain.language import N_, _
from cranktrain.layout.masses import Masses
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.part_tables import bearing_moments, part_name
from cranktrain.linkage.forces import EdgeForces
from cranktrain.motion import Array
from cranktrain.numerics import Peak
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.forces.peaks import ForcePeaks, MachineCurves, one_sided
from cranktrain.questions.forces.solved_cycle import Member, SolvedCycle, edges_of, mechanisms_of, parts_of
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import Flagged

_GUIDE = ("guide", "crank_angle")


@record
class GuideEdges(Flagged):
    """Normal forces of both edges of each guide that has a length, to the left as its slider's position counts.

    They act on what the joint's reaction acts on: a slider in a fixed guide, or the guide that turns with its slider.
    """

    guide_edge_force_ahead: Array = quantity(
        "N₊",
        "N",
        _GUIDE,
        N_("Normal force of the guide's edge ahead, as the slider's position counts"),
        _THEORY,
        "13.43",
    )
    guide_edge_force_behind: Array = quantity(
        "N₋",
        "N",
        _GUIDE,
        N_("Normal force of the guide's edge behind, as the slider's position counts"),
        _THEORY,
        "13.43",
    )
    guide_pressing: Array = quantity(
        "N_Σ",
        "N",
        _GUIDE,
        N_("Sum of what both edges of the guide press, of which friction is the share μ"),
        _THEORY,
        "13.43",
    )
    largest_guide_edge_force: Peak = extreme(
        "N_max",
        "N",
        ("guide",),
        N_("Largest normal force of an edge of the guide"),
        N_("Crank angle of the largest normal force of an edge of the guide"),
        _THEORY,
        "13.43",
        worst="largest",
    )


def have_length(mechanisms: Mechanisms, masses: Masses | None) -> bool | str:
    """Whether a guide has a length; it is worth asking for where something slides in a guide that bears moments."""
    if not any(bearing_moments(batch.kind.dynamics) for batch in mechanisms.batches):
        return False
    batches = () if masses is None else masses.batches
    return any(np.any(edges.per_length) for batch in batches for edges in batch.edges) or N_("[guide]")


@record
class GuideCurves(MachineCurves):
    """What the edge presses that presses more, of every guide; names, and what both press on the grid."""

    names: tuple[str, ...]
    edges: EdgeForces


def guide_curves(loaded: LoadedMachine, solved: SolvedCycle) -> GuideCurves:
    """Forces of the edges, from the reaction in each guide. docs/theory/forces, eq. (13.43)."""
    guides = _with_length(loaded)
    edges = _pressing(loaded, guides, solved.batches)
    return GuideCurves(
        mechanisms_of(guides),
        _larger(edges),
        lambda batches: _larger(_pressing(loaded, guides, batches)),
        names=tuple(guide.name for guide in guides),
        edges=edges,
    )


def guide_edges(curves: GuideCurves, peaks: ForcePeaks) -> GuideEdges:
    """Forces of the edges, and the largest; docs/theory/forces, eq. (13.43)."""
    ahead, behind = curves.edges
    largest, names = peaks.of(curves), curves.names
    return GuideEdges(
        guide_edge_force_ahead=ahead,
        guide_edge_force_behind=behind,
        guide_pressing=np.abs(ahead) + np.abs(behind),
        largest_guide_edge_force=largest,
        labels={"guide": names},
        flags=tuple(one_sided([(_("largest force of an edge of"), largest)], names)),
    )


def _with_length(loaded: LoadedMachine) -> list[Member]:
    """Guides with a length, mechanism by mechanism."""
    batches = enumerate(zip(loaded.mechanisms.batches, loaded.masses.batches, strict=True))
    found = [
        Member(f"{loaded.mechanisms.names[mechanism]}.{part_name(name)}", mechanism, number, member, place)
        for number, (batch, made) in batches
        for place, (name, edges) in enumerate(zip(batch.kind.dynamics.sliding, made.edges, strict=True))
        if np.any(edges.per_length)
        for member, mechanism in enumerate(batch.index.tolist())
        if np.asarray(edges.per_length)[0, member, 0]
    ]
    return sorted(found, key=lambda guide: guide.mechanism)


def _pressing(loaded: LoadedMachine, guides: Sequence[Member], solved: Sequence[SolvedBatch]) -> EdgeForces:
    """What both edges of every guide press, shape (design, guide, n)."""
    batches = loaded.mechanisms.batches
    return EdgeForces(*parts_of(guides, solved, lambda batch, place: edges_of(batches[batch], solved[batch], place)))


def _larger(edges: EdgeForces) -> Array:
    """What the edge presses that presses more."""
    return np.maximum(np.abs(edges.ahead), np.abs(edges.behind))
