"""Forces of pistons as engine dynamics takes them apart, P, N, S, K, T: by reactions, and by the textbook's formula."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.catalogue import quantity
from cranktrain.checks import Check
from cranktrain.engine.crank_pins import CrankPinLoads
from cranktrain.engine.forces import LoadedMachine, SolvedCycle
from cranktrain.engine.gas import GasPressures
from cranktrain.engine.layout import CrankAngle, Group, PistonRods, Pistons
from cranktrain.language import N_, _
from cranktrain.linkage.forces import Drive, Wrench, turned_wrench
from cranktrain.loads.piston import (
    PistonForces,
    RodForces,
    inertia_force,
    piston_forces,
    piston_identities,
    rod_forces,
    two_harmonic_inertia_force,
)
from cranktrain.loads.rod_masses import TwoMasses, weighed_ends
from cranktrain.mechanisms.kind import Role
from cranktrain.motion import Array
from cranktrain.record import record

_CURVE = ("force_method", "piston", "crank_angle")
_THEORY = "docs/theory/forces"
_LIMIT = 1e-12
DIRECT = "slider_crank"
"""Kind whose rod joins piston and crank pin, and nothing else does."""


@record
class DirectPistons:
    """Pistons of which some at least have rods on the crank pin itself."""

    needs: ClassVar[str] = ""

    n_pistons: int


def direct_pistons_of(pistons: Pistons) -> DirectPistons | None:
    """Count the pistons; None where no rod sits on a crank pin."""
    has_some = any(group.kind.name == DIRECT for group in pistons.groups)
    return DirectPistons(len(pistons.names)) if has_some else None


def direct_groups(loaded: LoadedMachine) -> Iterator[tuple[int, Group]]:
    """Those groups of the mechanisms whose rods join piston and crank pin, with their places."""
    return ((place, group) for place, group in enumerate(loaded.mechanisms.groups) if group.kind.name == DIRECT)


class _Rods(NamedTuple):
    """Rods of one kind of mechanism, each in a piston: motion, joints, shares at both ends, and which pistons.

    weight is the rod's; aside its first moment across its line; reciprocating the piston's mass with the rod's share.
    """

    group: Group
    motion: Any
    joints: Sequence[Wrench]
    masses: TwoMasses
    weight: Wrench
    aside: Array
    reciprocating: Array
    piston: NDArray[np.intp]

    @property
    def pins(self) -> tuple[Wrench, Wrench]:
        """Reactions in the rod's pins: on it at the crank or a master's rod, by it on the piston."""
        return self.joint("crank_pin", "knuckle_pin"), self.joint("piston_pin")

    def joint(self, *roles: Role) -> Wrench:
        """Reaction in the mechanism's own joint with the first of some roles that any has."""
        places = (self.group.kind.dynamics.joint(role) for role in roles)
        return self.joints[next(place for place in places if place is not None)]


def _rods(loaded: LoadedMachine, solved: SolvedCycle) -> Iterator[_Rods]:
    """Find the rods of pistons."""
    for group, one, made in zip(loaded.mechanisms.groups, solved.groups, loaded.masses.groups, strict=True):
        if group.kind.has_rod and group.kind.output == "slider":
            rod = made.bodies.rod
            masses = weighed_ends(rod, group.members.geometry.rod_length)
            yield _Rods(
                group,
                one.motion,
                one.forces.joints,
                masses,
                Wrench(rod.mass * made.gravity.x, rod.mass * made.gravity.y, 0.0 * rod.mass),
                rod.mass * rod.across,
                made.bodies.slider.mass + masses.second,
                loaded.carriers.piston[group.index],
            )


@record
class PistonForceSet:
    """P, N, S, K and T of pistons with rods, by the reactions in the joints and by the textbook's formula.

    In both the rod's shares at its ends go with what is there, one with the piston and one with the crank; what the rod
    does beyond that as a body, its slaves and friction are in the reactions alone. NaN for pistons without a rod. A
    slave has no crank pin: its S there, K and T are NaN, and so is the formula.
    """

    inertia_force: Array = quantity(
        "P_j", "N", _CURVE, N_("Inertia of piston and the rod's reciprocating share, toward the shaft"), _THEORY
    )
    piston_force: Array = quantity(
        "P", "N", _CURVE, N_("Force of gas and inertia along the cylinder, toward the shaft"), _THEORY
    )
    side_force: Array = quantity("N", "N", _CURVE, N_("Force of the wall on the piston toward +y"), _THEORY)
    rod_force_at_piston_pin: Array = quantity(
        "S", "N", _CURVE, N_("Force along the rod at the piston pin, positive in compression"), _THEORY
    )
    rod_force_at_crank_pin: Array = quantity(
        "S_A",
        "N",
        _CURVE,
        N_("Force along the rod at the crank pin, positive in compression; of a master another than at the piston pin"),
        _THEORY,
    )
    radial_force: Array = quantity(
        "K", "N", _CURVE, N_("Force at the crank pin toward the shaft, without the rod's rotating mass"), _THEORY
    )
    tangential_force: Array = quantity(
        "T", "N", _CURVE, N_("Force at the crank pin in the sense of rotation, without that mass"), _THEORY
    )
    checks: tuple[Check, ...] = ()
    labels: Mapping[str, tuple[str, ...]] = field(default_factory=lambda: {"force_method": FORCE_METHODS})


def piston_force_set(
    rods: PistonRods,
    loaded: LoadedMachine,
    solved: SolvedCycle,
    crank_pins: CrankPinLoads,
    crank_angle: CrankAngle,
    gas: GasPressures | None,
) -> PistonForceSet:
    """Forces of every piston with a rod: exact, by the formula, and by it with two harmonics of inertia.

    Notes
    -----
    Exact means the joints' reactions, with rods as the bodies that they are; docs/theory/forces, eqs. (13.30),
    (13.35), (13.36) and (13.50). The formula, eqs. (13.31) to (13.34), is for rods between a piston and a crank pin.
    """
    phi = crank_angle.angle
    drive = loaded.speed.drive(phi)
    curves = np.full((7, len(phi), len(FORCE_METHODS), rods.value.size, phi.shape[-1]), np.nan)
    along: list[tuple[_Rods, RodForces]] = []
    residuals: list[Array] = []
    for one in _rods(loaded, solved):
        pressed: Array | float = 0.0 if gas is None else gas.gas_force[:, one.piston]
        pulled = inertia_force(one.motion.slider, one.reciprocating, drive)
        found = rod_forces(one.motion.rod, one.motion.slider, one.pins, one.masses, drive)
        along.append((one, found))
        exact = (pulled, pressed + pulled, one.joint("guide").y, found.at_piston, *_at_pin(one.group, found, crank_pins))
        _fill(curves[:, :, 0], one.piston, exact)
        if one.group.kind.name == DIRECT:
            for method, inertia in enumerate(_FORMULAS.values(), start=1):
                pulled = inertia(one, phi + one.group.members.phase, drive)
                taken = piston_forces(pressed + pulled, one.motion, one.group.members.geometry)
                piston, side, rod, *pin = taken
                _fill(curves[:, :, method], one.piston, (pulled, piston, side, rod, rod, *pin))
                residuals.append(_formula_residual(taken, one))
    return PistonForceSet(*curves, checks=tuple(_checks(residuals, _rod_residual(loaded, along, drive))))


def _fill(curves: Array, piston: NDArray[np.intp], values: Sequence[Array]) -> None:
    for curve, value in zip(curves, values, strict=True):
        curve[:, piston] = value


def _at_pin(group: Group, along: RodForces, crank_pins: CrankPinLoads) -> tuple[Array, Array, Array]:
    """S, K and T at the crank pin; NaN for rods that are on none."""
    loads = (crank_pins.crankpin_load_radial_without_rod, crank_pins.crankpin_load_tangential_without_rod)
    radial, tangential = (load[:, group.index] for load in loads)
    return np.where(np.isnan(radial), np.nan, along.at_crank), radial, tangential


def _exact_motion(one: _Rods, _angle: Array, drive: Drive) -> Array:
    return inertia_force(one.motion.slider, one.reciprocating, drive)


def _two_harmonics(one: _Rods, angle: Array, drive: Drive) -> Array:
    return two_harmonic_inertia_force(angle, one.group.members.geometry, one.reciprocating, drive)


_FORMULAS: Mapping[str, Callable[[_Rods, Array, Drive], Array]] = {
    "textbook": _exact_motion,
    "two_harmonics": _two_harmonics,
}
"""P·f(β), by what its P takes for the inertia."""

FORCE_METHODS = ("exact", *_FORMULAS)


def _checks(formula: Sequence[Array], rods: Array) -> Iterator[Check]:
    """Give the identities of the formula, and those of the reactions."""
    if formula:
        yield Check(
            "piston_forces",
            _("P·f(β): K² + T² = S², TR = Px′ and TR = Ns + Pe, relative to their peaks"),
            np.nanmax(formula, axis=0),
            _LIMIT,
        )
    yield Check(
        "rod_forces",
        _("Force along a rod at one pin against that at the other and what acts between, relative to what its pins bear"),
        rods,
        _LIMIT,
    )


def _formula_residual(forces: PistonForces, one: _Rods) -> Array:
    """Largest residual of the identities, each relative to its peak, shape (design,); NaN where all are."""
    geometry = one.group.members.geometry
    found = piston_identities(forces, one.motion, geometry)
    peak = np.max(np.abs(forces.rod), axis=-1)
    arm = (geometry.crank_radius + geometry.rod_length)[..., 0]
    scales = (peak * peak, peak * arm, peak * arm)
    parts = [
        np.max(np.abs(part), axis=-1) / np.where(scale > 0, scale, 1.0)
        for part, scale in zip(found, scales, strict=True)
    ]
    return np.max(np.where(np.isnan(parts), 0.0, parts), axis=(0, 2))


def _rod_residual(loaded: LoadedMachine, along: Sequence[tuple[_Rods, RodForces]], drive: Drive) -> Array:
    """Largest difference of the forces at both ends of a rod, less what acts between, over what its pins bear.

    What slaves hand over is taken from their own knuckle pins. Shape (design,).
    """
    top, master = loaded.mechanisms.nominal_top, loaded.carriers.master
    shape = (*top.shape[:2], along[0][1].at_piston.shape[-1])
    # Of the master's rod on its slaves' together, in the master's axes.
    x, y = np.zeros((2, *shape))
    for one, _found in along:
        place = one.group.kind.dynamics.joint("knuckle_pin")
        if place is not None:
            on = master[one.group.index]
            turned = turned_wrench(one.joints[place], top[:, on] - top[:, one.group.index])
            for member, mechanism in enumerate(on.tolist()):
                x[:, mechanism] += turned.x[:, member]
                y[:, mechanism] += turned.y[:, member]
    worst = [np.zeros(len(top))]
    for one, found in along:
        rod, index = one.motion.rod, one.group.index
        turning = rod.angle.second * (drive.speed * drive.speed) + rod.angle.first * drive.acceleration
        between = (one.weight.x - x[:, index]) * rod.cos + (one.weight.y - y[:, index]) * rod.sin
        peak = np.max([np.max(np.hypot(pin.x, pin.y), axis=-1) for pin in one.pins], axis=0)
        off = np.max(np.abs(found.at_crank - found.at_piston + between + one.aside * turning), axis=-1) / np.where(peak > 0, peak, 1.0)
        worst.append(np.max(np.where(np.isnan(off), 0.0, off), axis=-1))
    return np.max(worst, axis=0)
