"""Reactions in every joint, as results, with their largest values; what to mind about masses and friction."""

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.part_tables import part_name
from cranktrain.mechanisms.dynamics import Reaction
from cranktrain.motion import Array
from cranktrain.numerics import Peak
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.forces.peaks import ForcePeaks, MachineCurves, one_sided
from cranktrain.questions.forces.solved_cycle import Member, SolvedCycle, force_size, mechanisms_of, parts_of
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import Flagged
from cranktrain.saying.wording import ranged

_JOINT = ("joint", "crank_angle")
_FEW = 3
"""So many rods are named one by one."""
_NO_ARM = 1e-9
"""Moment over force of which a guide is said to bear none. [m]"""


@record
class JointForces(Flagged):
    """Reaction in every joint, in the axes of its mechanism."""

    joint_force_x: Array = quantity(
        "F_x", "N", _JOINT, N_("Force in the joint along its mechanism's x"), _THEORY, "13.5, 13.8 to 13.24"
    )
    joint_force_y: Array = quantity(
        "F_y", "N", _JOINT, N_("Force in the joint along its mechanism's y"), _THEORY, "13.5, 13.8 to 13.24"
    )
    joint_moment: Array = quantity(
        "M_J",
        "N*m",
        _JOINT,
        N_("Moment in the joint: of a guide on what slides in it, about its pin"),
        _THEORY,
        "13.11, 13.15, 13.20, 13.21, 13.24",
    )
    largest_joint_force: Peak = extreme(
        "F_max",
        "N",
        ("joint",),
        N_("Largest force in the joint"),
        N_("Crank angle of the largest force in the joint"),
        _THEORY,
        "13.5, 13.8 to 13.24",
        worst="largest",
    )


@record
class JointCurves(MachineCurves):
    """Sizes of the forces in all joints; names, and the reactions on the grid, (3, design, joint, n)."""

    names: tuple[str, ...]
    reactions: Array


def joint_curves(loaded: LoadedMachine, solved: SolvedCycle) -> JointCurves:
    """Reactions of all joints on the grid."""
    joints = joints_of(loaded)
    reactions = _reactions(joints, solved.batches)
    return JointCurves(
        mechanisms_of(joints),
        force_size(*reactions[:2]),
        partial(_sizes, joints),
        names=tuple(joint.name for joint in joints),
        reactions=reactions,
    )


def _sizes(joints: Sequence[Member], found: Sequence[SolvedBatch]) -> Array:
    """Sizes of the forces in joints, of mechanisms that are solved at any angles."""
    return force_size(*parts_of(joints, found, lambda batch, place: found[batch].forces.joints[place][:2]))


def joint_forces(loaded: LoadedMachine, solved: SolvedCycle, curves: JointCurves, peaks: ForcePeaks) -> JointForces:
    """Reactions of all joints; a master's hold what its slaves do to it, docs/theory/forces, eq. (13.3)."""
    x, y, moment = curves.reactions
    largest, names = peaks.of(curves), curves.names
    return JointForces(
        joint_force_x=x,
        joint_force_y=y,
        joint_moment=moment,
        largest_joint_force=largest,
        labels={"joint": names},
        flags=(
            *_flags(loaded),
            *_moments_without_length(loaded, solved),
            *_wedged(loaded, solved),
            *one_sided([(_("largest force in"), largest)], names),
        ),
    )


def joint_label(mechanism: str, reaction: Reaction) -> str:
    """Give a joint of a mechanism its name among all."""
    return f"{mechanism}.{reaction.name}"


def joints_of(loaded: LoadedMachine) -> list[Member]:
    """All joints, mechanism by mechanism; a slave's share of its master's is left out, as that has it already."""
    found = [
        Member(joint_label(loaded.mechanisms.names[mechanism], reaction), mechanism, place, member, number)
        for place, batch in enumerate(loaded.mechanisms.batches)
        for number, reaction in enumerate(batch.kind.dynamics.reactions)
        if reaction.on in batch.kind.dynamics.moving
        for member, mechanism in enumerate(map(int, batch.index))
    ]
    return sorted(found, key=lambda joint: joint.mechanism)


def _reactions(joints: Sequence[Member], solved: Sequence[SolvedBatch]) -> Array:
    """Force along x, along y and moment in every joint, shape (3, design, joint, n)."""
    return parts_of(joints, solved, lambda batch, place: solved[batch].forces.joints[place])


def _flags(loaded: LoadedMachine) -> Iterator[Words]:
    """Flag what has no mass, and rods whose inertia is assumed."""
    masses = loaded.masses
    if (said := loaded.without_mass()) is not None:
        yield said
    if masses.unused:
        yield _(
            "{tables} is used by none: every bank that has one gives its own.",
            tables=", ".join(f"[{path}]" for path in masses.unused),
        )
    if masses.doubtful:
        yield _(
            "The inertia of {parts} is hardly that of a link of such mass and length:"
            " is it in kg·m², about the centroid?",
            parts=", ".join(masses.doubtful),
        )
    if masses.assumed:
        rods = masses.assumed
        said = (
            _("{rods} has the inertia of two masses at its ends")
            if len(rods) == 1
            else _("{rods} have the inertia of two masses at their ends")
        ).format(rods=", ".join(rods) if len(rods) <= _FEW else _("{n} rods", n=len(rods)))
        yield _("{said}: of measured rods that is from 3 % too little to 22 % too much.", said=said)


def _moments_without_length(loaded: LoadedMachine, solved: SolvedCycle) -> Iterator[Words]:
    """Flag what rubs in a guide that carries a moment, where no length says on which edges."""
    parts: list[str] = []
    for batch, one, made in zip(loaded.mechanisms.batches, solved.batches, loaded.masses.batches, strict=True):
        dynamics = batch.kind.dynamics
        joints = dynamics.by_joint(one.forces.joints)
        for place, (name, contact) in enumerate(zip(dynamics.sliding, dynamics.contacts, strict=True)):
            wrench, rubs = joints[contact.joint], (made.friction[place] > 0) & (made.edges[place].per_length == 0)
            if not np.any(rubs):
                continue
            turned = np.abs(wrench.moment) > _NO_ARM * np.max(force_size(wrench.x, wrench.y), axis=-1, keepdims=True)
            found = np.any(turned & rubs, axis=(0, 2))
            parts += [f"{loaded.mechanisms.names[i]}.{part_name(name)}" for i in batch.index[found].tolist()]
    if parts:
        yield _(
            "A moment acts where {parts} slides, and the guide's length is not given:"
            " friction is counted on the normal force alone.",
            parts=", ".join(parts),
        )


def _wedged(loaded: LoadedMachine, solved: SolvedCycle) -> Iterator[Words]:
    """Flag mechanisms that move freely without friction and have no forces with it."""
    stuck: list[int] = []
    for batch, one, made in zip(loaded.mechanisms.batches, solved.batches, loaded.masses.batches, strict=True):
        for name, coefficient in zip(batch.kind.dynamics.sliding, made.friction, strict=True):
            if not np.any(coefficient > 0):
                continue
            moves = ~np.isnan(batch.kind.named(one.motion, name).first)
            found = (coefficient > 0) & moves & np.isnan(one.forces.driving_torque)
            stuck += batch.index[np.any(found, axis=(0, 2))].tolist()
    if stuck:
        yield _(
            "Friction wedges {mechanisms}: at some crank angles nothing can turn the shaft, and there are no forces.",
            mechanisms=ranged(loaded.mechanisms.names, sorted(set(stuck))),
        )
