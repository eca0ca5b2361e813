"""Forces of pistons as engine dynamics takes them apart, P, N, S, K, T: by reactions, and by the textbook's formula."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Batch, Pistons
from cranktrain.motion import Array
from cranktrain.numerics.nested import put
from cranktrain.questions.forces.crank_pins import CrankPinLoads
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.piston_formulas import (
    PistonForces,
    piston_forces,
    piston_identities,
    two_harmonic_inertia_force,
)
from cranktrain.questions.forces.rods_in_pistons import (
    ForcesOfRods,
    RodsInPistons,
    RodsOnGrid,
    end_residual,
    pin_residual,
)
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Check, Checked

_CURVE = ("force_method", "piston", "crank_angle")
_LIMIT = 1e-12
FORCE_METHODS = ("exact", "textbook", "two_harmonics")
"""By the reactions; by P·f(β); by that with two harmonics of the inertia."""


def have_direct_rods(pistons: Pistons) -> bool:
    """Whether any piston's rod sits on the crank pin itself."""
    return any(batch.kind.is_direct for batch in pistons.batches)


def direct_batches(loaded: LoadedMachine) -> Iterator[tuple[int, Batch]]:
    """Those batches of the mechanisms whose rods join piston and crank pin, with their places."""
    return ((place, batch) for place, batch in enumerate(loaded.mechanisms.batches) if batch.kind.is_direct)


@record
class PistonForceSet(Checked):
    """P, N, S, K and T of pistons with rods, by the reactions in the joints and by the textbook's formula.

    In both the rod's shares at its ends go with what is there, inertia and weight, one with the piston and one with the
    crank; what the rod does beyond that as a body, its slaves and friction are in the reactions alone. NaN for pistons
    without a rod. A slave has no crank pin: its S there, K and T are NaN, and so is the formula.
    """

    inertia_force: Array = quantity(
        "P_j",
        "N",
        _CURVE,
        N_("Inertia of piston and the rod's reciprocating share, toward the shaft"),
        _THEORY,
        "13.30, 13.34",
    )
    piston_force: Array = quantity(
        "P",
        "N",
        _CURVE,
        N_("Force of gas, loads, inertia and weight along the cylinder, toward the shaft"),
        _THEORY,
        "13.30, 13.34",
    )
    side_force: Array = quantity(
        "N", "N", _CURVE, N_("Force of the wall on the piston toward +y"), _THEORY, "13.10, 13.31"
    )
    rod_force_at_piston_pin: Array = quantity(
        "S", "N", _CURVE, N_("Force along the rod at the piston pin, positive in compression"), _THEORY, "13.31, 13.50"
    )
    rod_force_at_crank_pin: Array = quantity(
        "S_A",
        "N",
        _CURVE,
        N_("Force along the rod at the crank pin, positive in compression; of a master another than at the piston pin"),
        _THEORY,
        "13.31, 13.50",
    )
    radial_force: Array = quantity(
        "K",
        "N",
        _CURVE,
        N_("Force at the crank pin toward the shaft, without the rod's rotating mass"),
        _THEORY,
        "13.31, 13.35, 13.36",
    )
    tangential_force: Array = quantity(
        "T",
        "N",
        _CURVE,
        N_("Force at the crank pin in the sense of rotation, without that mass"),
        _THEORY,
        "13.31, 13.35, 13.36",
    )


def piston_force_set(
    pistons: Pistons,
    loaded: LoadedMachine,
    rods: RodsOnGrid,
    crank_pins: CrankPinLoads,
    crank_angle: CrankAngle,
) -> PistonForceSet:
    """Forces of every piston with a rod: exact, by the formula, and by it with two harmonics of inertia.

    Notes
    -----
    Exact means the joints' reactions, with rods as the bodies that they are; docs/theory/forces, eqs. (13.30),
    (13.35), (13.36) and (13.50). The formula, eqs. (13.31) to (13.34), is for rods between a piston and a crank pin.
    """
    phi = crank_angle.angle
    curves = np.full((7, len(phi), len(FORCE_METHODS), len(pistons.names), phi.shape[-1]), np.nan)
    residuals: list[Array] = []
    for one, exact in rods.each:
        put(curves[:, :, 0], one.piston, (*exact[:-1], *_at_pin(one, exact, crank_pins)))
        if one.batch.kind.is_direct:
            two_harmonics = two_harmonic_inertia_force(
                phi + one.batch.members.phase, one.batch.members.geometry, one.reciprocating, one.drive
            )
            for method, inertia in enumerate((exact.inertia, two_harmonics), start=1):
                taken = piston_forces(one.pressed + inertia, one.motion, one.batch.members.geometry)
                piston, side, rod, *pin = taken
                put(curves[:, :, method], one.piston, (inertia, piston, side, rod, rod, *pin))
                residuals.append(_formula_residual(taken, one))
    return PistonForceSet(
        *curves,
        labels={"force_method": FORCE_METHODS},
        checks=tuple(_checks(residuals, end_residual(loaded, rods.each), pin_residual(loaded, rods.each))),
    )


def _at_pin(one: RodsInPistons, forces: ForcesOfRods, crank_pins: CrankPinLoads) -> tuple[Array, Array, Array]:
    """S, K and T at the crank pin; NaN for rods that are on none."""
    loads = (crank_pins.crankpin_radial_without_rod, crank_pins.crankpin_tangential_without_rod)
    radial, tangential = (load[:, one.batch.index] for load in loads)
    return np.where(np.isnan(radial), np.nan, forces.at_crank), radial, tangential


def _checks(formula: Sequence[Array], rods: Array, pins: Array) -> Iterator[Check]:
    """Give the identities of the formula, and those of the reactions."""
    if formula:
        yield Check(
            "piston_forces",
            _("P·f(β): K² + T² = S², TR = Px′ and TR = Ns + Pe, relative to their peaks"),
            np.fmax.reduce(formula, axis=0),
            _LIMIT,
        )
    yield Check(
        "rod_forces",
        _("Force along a rod at one pin against that at the other and what acts between, relative to its pins' loads"),
        rods,
        _LIMIT,
    )
    yield Check(
        "piston_pins",
        _("Force in the piston pin: S² = P² + (N + Y)², of what acts on the piston alone, relative to that"),
        pins,
        _LIMIT,
    )


def _formula_residual(forces: PistonForces, one: RodsInPistons) -> Array:
    """Largest residual of the identities, each relative to its peak, shape (design,); NaN where all are."""
    geometry = one.batch.members.geometry
    found = piston_identities(forces, one.motion, geometry)
    peak = np.fmax.reduce(np.abs(forces.rod), axis=-1)
    arm = (geometry.crank_radius + geometry.rod_length)[..., 0]
    scales = (peak * peak, peak * arm, peak * arm)
    parts = [
        np.fmax.reduce(np.abs(part), axis=-1) / np.where(scale > 0, scale, 1.0)
        for part, scale in zip(found, scales, strict=True)
    ]
    return np.fmax.reduce(np.fmax.reduce(parts), axis=-1)
