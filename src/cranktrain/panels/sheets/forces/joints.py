"""Forces of a mechanism without a piston's: reactions in its joints as curves, as polar diagrams and as a table."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.language import Listed, _
from cranktrain.mechanisms.dynamics import FRAME, AnyDynamics
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest, largest_first
from cranktrain.panels.design import OneDesign, closed
from cranktrain.panels.parts import Table, TableColumn
from cranktrain.panels.shapes import Curve, Panel, PolarCurve, PolarDiagram, Role, polar_diagram
from cranktrain.questions.forces.joint_forces import joint_label
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.saying.amounts import UnitLabel
from cranktrain.saying.names import spelled

_ROLES: tuple[Role, ...] = ("main", "side", "radial", "resultant")
_LETTERS = ("T", "N", "K", "F")
_POLAR = 2
MOST_CURVES = 3 * len(_ROLES)
"""Joints whose reactions are drawn as curves."""
_NOTHING = 1e-9
"""Of the largest force: less is rounding."""
_ALIKE = 1e-3
"""Of the largest force: reactions whose sizes differ by less are drawn as one curve."""


class JointForce(NamedTuple):
    """Joints whose reactions are alike in size: their number on the sheet, their names, the reaction of the first.

    It is over the cycle, closed, shape (2, n). [N]
    """

    number: int
    names: tuple[str, ...]
    force: Array

    @property
    def size(self) -> Array:
        """Of the reaction. [N]"""
        return np.hypot(*self.force)

    @property
    def largest_at(self) -> int:
        """Where it is largest."""
        return first_largest(self.size)


def mechanism_of(shown: OneDesign, piston: str | None) -> str:
    """Mechanism whose joints are shown: that of a piston without forces of its own, or the first."""
    return piston or shown.result.machines[shown.design].places[0].name


def joint_forces(shown: OneDesign, mechanism: str) -> list[JointForce]:
    """Joints of a mechanism by their largest reactions, the most loaded first; those that bear nothing are left out."""
    dynamics = _dynamics_of(shown, mechanism)
    places = {
        reaction.name: shown.member("joint", joint_label(mechanism, reaction))
        for reaction in dynamics.reactions
        if reaction.on in dynamics.moving
    }
    forces = {
        name: np.stack([closed(shown(f"joint_force_{x}")[place]) for x in "xy"]) for name, place in places.items()
    }
    peaks = {name: float(np.max(np.hypot(*force))) for name, force in forces.items()}
    most = max((peak for peak in peaks.values() if np.isfinite(peak)), default=0.0)
    found: list[JointForce] = []
    for name in largest_first([name for name, peak in peaks.items() if peak > _NOTHING * most], peaks.__getitem__):
        size = np.hypot(*forces[name])
        alike = next((at for at, one in enumerate(found) if np.max(np.abs(one.size - size)) < _ALIKE * most), None)
        if alike is None:
            found.append(JointForce(len(found) + 1, (name,), forces[name]))
        else:
            found[alike] = found[alike]._replace(names=(*found[alike].names, name))
    return found


def _dynamics_of(shown: OneDesign, mechanism: str) -> AnyDynamics:
    """What moves of a mechanism, and its joints."""
    loaded = shown.result[LoadedMachine]
    at = loaded.mechanisms.names.index(mechanism)
    return next(batch.kind.dynamics for batch in loaded.mechanisms.batches if at in batch.index)


class SharedPin(NamedTuple):
    """A joint of more than two links: its name, the link that its pin is part of, and the others."""

    joint: str
    owner: str
    others: tuple[str, ...]


def pins_shared(shown: OneDesign, mechanism: str) -> Iterator[SharedPin]:
    """Joints of a mechanism in which more than two of its links meet; a crank has its pin, and the frame its pivots."""
    dynamics = _dynamics_of(shown, mechanism)
    others: dict[tuple[str, str], list[str]] = {}
    for one in dynamics.reactions:
        others.setdefault((one.name.partition("/")[0], one.by), []).append(one.on)
    for (joint, owner), links in others.items():
        if len(links) > 1 and owner != FRAME and not joint.endswith(f"{owner}.pin"):
            yield SharedPin(joint, owner, tuple(links))


def joint_panels(shown: OneDesign, joints: Sequence[JointForce]) -> Iterator[Panel]:
    """Collect the curves over the crank angle: reactions in the joints that bear most, four to a panel."""
    for first in range(0, min(len(joints), MOST_CURVES), len(_ROLES)):
        chosen = joints[first : first + len(_ROLES)]
        curves = tuple(
            Curve(joint.size, role, letter, f"R_{{{joint.number}}}")
            for joint, role, letter in zip(chosen, _ROLES, _LETTERS, strict=False)
        )
        title = _("Reactions in other joints") if first else _("Reactions in the joints")
        yield Panel(title, "N", shown.cycle, curves)


def joint_diagrams(shown: OneDesign, joints: Sequence[JointForce]) -> tuple[PolarDiagram, ...]:
    """Polar diagrams of the most loaded joints, in the mechanism's axes."""
    angle = shown.cycle
    return tuple(
        polar_diagram(
            _("R{number} in {name}", number=joint.number, name=_(spelled(joint.names[0]))),
            (PolarCurve(joint.force),),
            angle,
            joint.force[:, joint.largest_at],
            float(angle[joint.largest_at]),
        )
        for joint in joints[:_POLAR]
    )


def joint_table(shown: OneDesign, joints: Sequence[JointForce]) -> Table:
    """Which joint has which number, its largest reaction and where, its smallest."""
    named = [(joint, name) for joint in joints for name in joint.names]
    largest = np.array([np.max(joint.size) for joint, _name in named])
    smallest = np.array([np.min(joint.size) for joint, _name in named])
    most = float(np.max(largest))
    angles = shown.cycle[[joint.largest_at for joint, _name in named]]
    return Table(
        (
            TableColumn(
                _("Joint, {unit}", unit=UnitLabel("N", most)),
                [Listed((f"R{joint.number}", _(spelled(name))), "  ") for joint, name in named],
            ),
            TableColumn(_("largest"), largest, "N", most),
            TableColumn(_("at"), [f"{angle:.0f}°" for angle in angles.tolist()]),
            TableColumn(_("smallest"), smallest, "N", most),
        ),
        (0.66, 0.8, 1.0),
        left_out=_("and {n} that bear less"),
    )
