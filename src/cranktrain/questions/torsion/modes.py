"""Torsional vibration of the crankshaft: its train of discs, natural frequencies, modes and Holzer's table."""

from collections.abc import Iterator
from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.masses import Masses
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.shafts import Shafts
from cranktrain.linkage.forces import reduced_inertia
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.crankshaft.shaft_layout import with_rods
from cranktrain.questions.cylinders.travel import CylinderPistons
from cranktrain.questions.forces.carriers import Carriers
from cranktrain.questions.torsion.parts import DeclaredTrain
from cranktrain.questions.torsion.throw_stiffness import ThrowStiffness
from cranktrain.questions.torsion.train import (
    Train,
    cross_inertia,
    holzer_remainder,
    holzer_table,
    natural_modes,
    nodes,
    scaled,
)
from cranktrain.record import record
from cranktrain.references import THEORY_OF_TORSION as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Check, Checked, Flagged, StageResult

_DISC = ("disc",)
_MODE = ("mode", "disc")
_LIMIT = 1e-12


@record
class TorsionalTrain(StageResult):
    """Discs and shafts, referred to the crank, by the rows of Holzer's table."""

    disc_inertia: Array = quantity(
        "J_i",
        "kg*m^2",
        _DISC,
        N_("Inertia of the disc, referred to the crank; of a throw the mean of a turn"),
        _THEORY,
        "23.1",
    )
    disc_ratio: Array = quantity("i", "1", _DISC, N_("Turns of the disc for one of the crank"), _THEORY, "definition")
    disc_stiffness: Array = quantity(
        "k_i",
        "N*m/rad",
        _DISC,
        N_("Stiffness of the shaft that leads on from the disc, referred to the crank"),
        _THEORY,
        "23.13 to 23.21",
    )
    train: Train = field(kw_only=True)


def of_known_stiffness(
    shafts: Shafts,
    sharing: CylinderPistons | None,
    train: DeclaredTrain,
    crankshafts: DeclaredCrankshafts | None,
    mechanisms: Mechanisms,
    carriers: Carriers,
) -> bool | str:
    """Whether, besides, the stiffness of the crankshaft is given, or its sizes can give it."""
    if not of_one_crankshaft(shafts, sharing):
        return False
    return train.method is None or with_rods(crankshafts, shafts, mechanisms, carriers)


def of_one_crankshaft(shafts: Shafts, sharing: CylinderPistons | None) -> bool:
    """Whether a machine has one crankshaft, and one piston in a cylinder."""
    return len(shafts.names) == 1 and not (sharing is not None and np.any(sharing.is_opposed))


def torsional_train(
    declared: DeclaredTrain,
    mechanisms: Mechanisms,
    shafts: Shafts,
    masses: Masses | None,
    crank_angle: CrankAngle,
    throws: ThrowStiffness | None,
) -> TorsionalTrain:
    """Add to what is declared the mean inertia of what moves on each throw, and the stiffness that sizes give.

    Notes
    -----
    docs/theory/torsion, eq. (23.1).
    """
    inertia = declared.inertia.copy()
    if masses is not None:
        moving = mean_inertias(mechanisms, masses, crank_angle)
        for mechanism, throw in enumerate(shafts.throw.tolist()):
            inertia[:, declared.throws[throw]] += moving[:, mechanism]
    stiffness = declared.stiffness.copy()
    if throws is not None:
        stiffness[:, declared.gaps] = throws.chosen_stiffness
    last = np.full((len(inertia), 1), np.nan)
    return TorsionalTrain(
        disc_inertia=inertia,
        disc_ratio=declared.ratio,
        disc_stiffness=np.concatenate([stiffness, last], axis=-1),
        train=Train(inertia, stiffness, declared.following),
        labels={"disc": declared.names},
    )


def mean_inertias(mechanisms: Mechanisms, masses: Masses, crank_angle: CrankAngle) -> Array:
    """Mean over a turn of every mechanism's inertia reduced to the crank, shape (design, mechanism). [kg·m²]"""
    found = np.zeros((len(crank_angle.zero), len(mechanisms.names)))
    for batch, made in zip(mechanisms.batches, masses.batches, strict=True):
        motion = batch.kind.motion(crank_angle.first_turn + batch.members.phase, batch.members.geometry)
        links = batch.kind.dynamics.links(motion, batch.members.geometry)
        for link, body in zip(links, tuple(made.bodies), strict=True):
            found[:, batch.index] += np.mean(reduced_inertia(link, body).value, axis=-1)
    return found


@record
class TorsionalModes(Checked, Flagged):
    """Free torsional vibration, and Holzer's table of every mode: for 1 rad where the amplitude is 1.

    unit: array of int, shape (design, mode), the disc where it is.
    """

    natural_frequency: Array = quantity(
        "ω_n", "rad/s", ("mode",), N_("Natural frequency of the torsional vibration"), _THEORY, "23.4", shown="Hz"
    )
    mode_shape: Array = quantity(
        "a", "1", _MODE, N_("Amplitude of the disc, referred to the crank; 1 at the free end"), _THEORY, "23.3, 23.4"
    )
    mode_node: Array = quantity(
        "s",
        "1",
        _MODE,
        N_("Where on the shaft that leads on the node is: share of the shaft from the disc"),
        _THEORY,
        "23.8",
    )
    holzer_torque: Array = quantity(
        "Jω²a", "N*m/rad", _MODE, N_("Holzer's table: torque of the disc's inertia"), _THEORY, "23.6"
    )
    holzer_sum: Array = quantity(
        "ΣJω²a",
        "N*m/rad",
        _MODE,
        N_("Holzer's table: torque in the shaft that leads on from the disc"),
        _THEORY,
        "23.6",
    )
    holzer_twist: Array = quantity(
        "Δa",
        "1",
        _MODE,
        N_("Holzer's table: twist of the shaft that leads on, taken off the amplitude"),
        _THEORY,
        "23.7",
    )
    unit: NDArray[np.intp] = field(kw_only=True)


def torsional_modes(declared: DeclaredTrain, discs: TorsionalTrain) -> TorsionalModes:
    """Natural frequencies and modes, and how well they are some; docs/theory/torsion, eqs. (23.4) to (23.8)."""
    train = discs.train
    modes = natural_modes(train)
    shape, unit = scaled(modes.shape, declared.free_end)
    table = holzer_table(train, modes.speed, shape)
    is_known = np.all(np.isfinite(modes.speed), axis=-1)
    closes = np.all(np.isfinite(train.inertia), axis=-1)
    is_stiff = np.all(np.isfinite(train.stiffness), axis=-1)
    unknown = np.where(closes & is_stiff, np.inf, np.nan)
    reasons = tuple(_("needs an inertia of every disc") if stiff else _("needs every stiffness") for stiff in is_stiff)
    return TorsionalModes(
        natural_frequency=modes.speed,
        mode_shape=shape,
        mode_node=nodes(train, shape),
        holzer_torque=table.torque,
        holzer_sum=table.total,
        holzer_twist=table.twist,
        unit=unit,
        labels={"mode": tuple(str(n + 1) for n in range(modes.speed.shape[-1]))},
        checks=(
            Check(
                "holzer",
                _("Torques left over by Holzer's table at the natural frequencies, relative to the sum of |Jω²a|"),
                np.where(is_known, holzer_remainder(train, table, shape), unknown),
                _LIMIT,
                reasons,
            ),
            Check(
                "torsional_modes",
                _("Kinetic energy that two modes of torsional vibration share, relative to their own"),
                np.where(is_known, cross_inertia(train, shape), unknown),
                _LIMIT,
                reasons,
            ),
        ),
        flags=tuple(_flags(declared, discs, unit)),
    )


def _flags(declared: DeclaredTrain, discs: TorsionalTrain, unit: NDArray[np.intp]) -> Iterator[Words]:
    """Mind discs of no inertia, and modes in which the free end is a node."""
    without = np.flatnonzero(np.any(discs.disc_inertia <= 0, axis=0)).tolist()
    if without:
        yield _(
            "Nothing vibrates, as these throws have no inertia: {throws}; give it in [masses] or [torsion].",
            throws=", ".join(declared.names[disc] for disc in without),
        )
    design, mode = (found.tolist() for found in np.nonzero(unit != declared.free_end))
    for n in dict.fromkeys(mode):
        disc = int(unit[design[mode.index(n)], n])
        yield _(
            "In mode {mode} the free end {end} is a node: its amplitudes are 1 at {disc}.",
            mode=n + 1,
            end=declared.names[declared.free_end],
            disc=declared.names[disc],
        )
