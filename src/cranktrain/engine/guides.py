"""Edges of guides: what each of them presses, of what slides in a guide whose length is given."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from typing import ClassVar, NamedTuple

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.engine.forces import LoadedMachine, SolvedCycle, SolvedGroup
from cranktrain.engine.guide_tables import bearing_moments
from cranktrain.engine.layout import Group
from cranktrain.engine.masses import Masses
from cranktrain.engine.part_tables import part_name
from cranktrain.engine.places import Place
from cranktrain.language import N_
from cranktrain.linkage.forces import EdgeForces, edge_forces
from cranktrain.motion import Array
from cranktrain.record import record

_GUIDE = ("guide", "crank_angle")
_THEORY = "docs/theory/forces"


@record
class MomentGuides:
    """That something slides in a guide that can bear a moment: only then a length is worth asking for."""

    needs: ClassVar[str] = ""


def moment_guides_of(places: Sequence[Place]) -> MomentGuides | None:
    """Say whether anything does."""
    return MomentGuides() if any(bearing_moments(place.kind.dynamics) for place in places) else None


@record
class GuidesWithLength:
    """That a guide of the machine has a length."""

    needs: ClassVar[str] = N_("[guide]")


def guides_with_length(masses: Masses) -> GuidesWithLength | None:
    """Ask for the edges' forces where a guide has a length."""
    has_some = any(np.any(edges.per_length) for group in masses.groups for edges in group.edges)
    return GuidesWithLength() if has_some else None


@record
class GuideEdges:
    """Normal forces of both edges of each guide that has a length, to the left as its slider's position counts.

    They act on what the joint's reaction acts on: a slider in a fixed guide, or the guide that turns with its slider.
    """

    guide_edge_force_ahead: Array = quantity(
        "N₊",
        "N",
        _GUIDE,
        N_("Normal force of the guide's edge ahead, as the slider's position counts"),
        _THEORY,
    )
    guide_edge_force_behind: Array = quantity(
        "N₋",
        "N",
        _GUIDE,
        N_("Normal force of the guide's edge behind, as the slider's position counts"),
        _THEORY,
    )
    guide_pressing: Array = quantity(
        "N_Σ", "N", _GUIDE, N_("Sum of what both edges of the guide press, of which friction is the share μ"), _THEORY
    )
    largest_guide_edge_force: Array = quantity(
        "N_max",
        "N",
        ("guide",),
        N_("Largest normal force of an edge of the guide on the grid of crank angles"),
        _THEORY,
    )
    labels: Mapping[str, tuple[str, ...]] = field(default_factory=lambda: {"guide": ()})


class _Guide(NamedTuple):
    """One mechanism's guide: its name, and what its edges press, shape (design, n)."""

    mechanism: int
    name: str
    edges: EdgeForces


def guide_edges(
    _guides: MomentGuides, _given: GuidesWithLength, loaded: LoadedMachine, solved: SolvedCycle
) -> GuideEdges:
    """Forces of the edges, from the reaction in each guide. docs/theory/forces, eq. (13.43)."""
    groups = zip(loaded.mechanisms.groups, solved.groups, loaded.masses.groups, strict=True)
    guides = sorted(
        (
            guide._replace(name=f"{loaded.mechanisms.names[guide.mechanism]}.{guide.name}")
            for group, one, made in groups
            for guide in _of_group(group, one, [np.asarray(edges.per_length) for edges in made.edges])
        ),
        key=lambda guide: guide.mechanism,
    )
    ahead, behind = (np.stack([guide.edges[edge] for guide in guides], axis=1) for edge in range(2))
    sizes = np.abs(ahead), np.abs(behind)
    return GuideEdges(
        guide_edge_force_ahead=ahead,
        guide_edge_force_behind=behind,
        guide_pressing=sizes[0] + sizes[1],
        largest_guide_edge_force=np.max(np.maximum(*sizes), axis=-1),
        labels={"guide": tuple(guide.name for guide in guides)},
    )


def _of_group(group: Group, one: SolvedGroup, per_length: list[Array]) -> Iterator[_Guide]:
    """Guides with a length of the mechanisms of one kind."""
    dynamics = group.kind.dynamics
    links = dict(zip(dynamics.moving, dynamics.links(one.motion, group.members.geometry), strict=True))
    names = [reaction.name for reaction in dynamics.reactions]
    shape = one.forces.driving_torque.shape
    for place, (name, contact) in enumerate(zip(dynamics.sliding, dynamics.contacts, strict=True)):
        if not np.any(per_length[place]):
            continue
        link, wrench = links[name], one.forces.joints[names.index(contact.joint)]
        friction = one.conditions.friction[place]
        normal = contact.way * (link.cos * wrench.y - link.sin * wrench.x)
        found = edge_forces(normal, wrench.moment, friction.per_length, friction.middle)
        ahead, behind = (np.broadcast_to(edge, shape) for edge in found)
        for member, mechanism in enumerate(group.index.tolist()):
            if per_length[place][0, member, 0]:
                yield _Guide(mechanism, part_name(name), EdgeForces(ahead[:, member], behind[:, member]))
