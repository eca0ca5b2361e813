"""Where loads change sides, of pins along their links and of guides across them, and play is taken up with a knock."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle, within
from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots
from cranktrain.questions.forces.joint_forces import joints_of
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.forces.solved_cycle import Member, force_size, mechanisms_of, parts_of
from cranktrain.questions.wear.cycle_points import CyclePoints
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_NOTHING = 1e-12
"""Of the largest; what is smaller may be of either sign."""
_MOST = 12
"""So many angles of a cycle are told: a guide's load changes sides at dead centres, and where gas and inertia part."""
_ACROSS = ("guide", "slot")
"""Roles of joints whose load counts across their link."""

Pick = Callable[[Sequence[SolvedBatch]], Array]
"""Gives some curves, shape (design, curve, …), of a machine that is solved at any angles."""


class SignChanges(NamedTuple):
    """Of a curve of a design: where it changes its sign, φ, rising, and whether it is positive after each.

    Of one that nowhere does, no angle and its own sign.
    """

    design: int
    curve: int
    angle: Array
    is_positive: NDArray[np.bool_]


def sign_changes(
    rows: NDArray[np.intp], pick: Pick, points: CyclePoints, loaded: LoadedMachine, gross: Array | None = None
) -> list[SignChanges]:
    """Find where curves of forces change their signs in a cycle.

    Parameters
    ----------
    rows : array of int, shape (curve,)
        Of which mechanism each is.
    pick : callable
    points : CyclePoints
    loaded : LoadedMachine
    gross : Array, shape (design, curve), optional
        What is rounding beside it is nothing; the curve's own peak unless given.

    Returns
    -------
    list of SignChanges
        None of a curve that is nothing all round.
    """
    values = pick(points.solved)
    found: list[SignChanges] = []
    beyond: list[Array] = []
    for design, cut in enumerate(points.cuts):
        angle = points.angle[design, 0, : cut.angle.size]
        for place, curve in enumerate(values[design, :, : cut.angle.size]):
            whole = np.max(np.abs(curve)) if gross is None else gross[design, place]
            is_clear = np.abs(curve) > _NOTHING * whole
            if np.any(is_clear):
                at, is_positive = angle[is_clear], curve[is_clear] > 0
                changes = is_positive != np.roll(is_positive, -1)
                after = ~is_positive[changes] if np.any(changes) else is_positive[:1]
                found.append(SignChanges(design, place, at[changes], after))
                beyond.append(np.append(at[1:], at[0] + points.cycle)[changes])
    sizes = [one.angle.size for one in found]
    if not sum(sizes):
        return found
    which = np.repeat(np.array([one.design * rows.size + one.curve for one in found]), sizes)
    low, high = (np.concatenate(ends)[:, np.newaxis] for ends in ([one.angle for one in found], beyond))
    roots = bracketed_roots(
        lambda angle: loaded.of_each(rows, which, angle, lambda own: pick(loaded.solved(own))), low, high
    )[:, 0]
    each = np.split(roots, np.cumsum(sizes)[:-1])
    return [one._replace(angle=own) for one, own in zip(found, each, strict=True)]


@record
class SideChanges(StageResult):
    """At which crank angles the loads of pins and guides change sides."""

    side_changes: Array = quantity(
        "n_k",
        "1",
        ("joint",),
        N_("How often in a cycle the joint's load changes sides, along its link or across its guide"),
        _THEORY,
        "13.58",
    )
    side_change_at: Array = quantity(
        "φ_k",
        "deg",
        ("joint", "side_change"),
        N_("Crank angle at which the joint's load changes sides, the first twelve in a cycle"),
        _THEORY,
        "13.58",
        is_place=True,
    )


def side_changes(loaded: LoadedMachine, points: CyclePoints, crank_angle: CrankAngle) -> SideChanges:
    """Roots of the loads along links and across guides, between the points of a cycle; docs/theory/forces, (13.58)."""
    joints = joints_of(loaded)
    parts = parts_of(joints, points.solved, lambda batch, place: points.solved[batch].forces.joints[place][:2])
    gross = np.max(force_size(*parts), axis=-1)
    found = sign_changes(mechanisms_of(joints), partial(_sides, loaded, joints), points, loaded, gross)
    n_designs = len(points.angle)
    often = np.full((n_designs, len(joints)), np.nan)
    angles = np.full((n_designs, len(joints), _MOST), np.nan)
    for one in found:
        zero = float(crank_angle.zero[one.design, 0, 0])
        often[one.design, one.curve] = one.angle.size
        shown = np.sort(within(one.angle - zero, points.cycle))[:_MOST]
        angles[one.design, one.curve, : shown.size] = shown
    names = tuple(joint.name for joint in joints)
    return SideChanges(often, angles, labels={"joint": names, "side_change": tuple(str(i + 1) for i in range(_MOST))})


def _sides(loaded: LoadedMachine, joints: Sequence[Member], solved: Sequence[SolvedBatch]) -> Array:
    """Load of each joint along the link on which it acts, of guides and slots across it."""

    def side(place: int, number: int) -> tuple[Array]:
        batch, one = loaded.mechanisms.batches[place], solved[place]
        dynamics = batch.kind.dynamics
        reaction, wrench = dynamics.reactions[number], one.forces.joints[number]
        link = dynamics.by_link(dynamics.links(one.motion, batch.members.geometry))[reaction.on]
        if reaction.role in _ACROSS:
            return (link.cos * wrench.y - link.sin * wrench.x,)
        return (link.cos * wrench.x + link.sin * wrench.y,)

    return parts_of(joints, solved, side)[0]
