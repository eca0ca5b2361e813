"""Forces of pistons as engine dynamics takes them apart: P, N, S, K and T."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.catalogue import quantity
from cranktrain.checks import Check
from cranktrain.engine.forces import LoadedMachine, SolvedCycle
from cranktrain.engine.gas import GasPressures
from cranktrain.engine.layout import CrankAngle, Group, Pistons
from cranktrain.language import N_, _
from cranktrain.linkage.forces import Drive
from cranktrain.loads.piston import (
    PistonForces,
    inertia_force,
    piston_forces,
    piston_identities,
    two_harmonic_inertia_force,
)
from cranktrain.loads.rod_masses import two_masses
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.wording import Names, number

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


class _Direct(NamedTuple):
    """Slider-cranks: their group and its motion, masses that go with the piston, and which pistons they are."""

    group: Group
    motion: Any
    mass: Array
    piston: NDArray[np.intp]


def direct_groups(loaded: LoadedMachine) -> Iterator[tuple[int, Group]]:
    """Those groups of the mechanisms whose rods join piston and crank pin, with their places."""
    return ((place, group) for place, group in enumerate(loaded.mechanisms.groups) if group.kind.name == DIRECT)


def _direct(loaded: LoadedMachine, solved: SolvedCycle) -> Iterator[_Direct]:
    """Find the slider-cranks, with the piston's mass and the rod's share in it."""
    for place, group in direct_groups(loaded):
        bodies = loaded.masses.groups[place].bodies
        share = two_masses(bodies.rod, group.members.geometry.rod_length).second
        piston = loaded.carriers.piston[group.index]
        yield _Direct(group, solved.groups[place].motion, bodies.slider.mass + share, piston)


@record
class PistonForceSet:
    """P, N, S, K and T of pistons on crank pins of their own, the rod as two masses; NaN for other pistons.

    The reciprocating share of the rod goes with the piston, the rotating one is in none of them. What the wall bears of
    the rod as a body, friction and slaves is the reaction in the joint `guide`.
    """

    inertia_force: Array = quantity(
        "P_j", "N", _CURVE, N_("Inertia of piston and the rod's reciprocating share, toward the shaft"), _THEORY
    )
    piston_force: Array = quantity(
        "P", "N", _CURVE, N_("Force of gas and inertia along the cylinder, toward the shaft"), _THEORY
    )
    side_force: Array = quantity(
        "N", "N", _CURVE, N_("Force of the wall on the piston toward +y, the rod as two masses"), _THEORY
    )
    rod_force: Array = quantity("S", "N", _CURVE, N_("Force along the rod, positive in compression"), _THEORY)
    radial_force: Array = quantity(
        "K", "N", _CURVE, N_("Force at the crank pin toward the shaft, without the rod's rotating mass"), _THEORY
    )
    tangential_force: Array = quantity("T", "N", _CURVE, N_("Force at the crank pin in the sense of rotation"), _THEORY)
    checks: tuple[Check, ...] = ()
    labels: Mapping[str, tuple[str, ...]] = field(default_factory=lambda: {"force_method": tuple(_INERTIA)})

    def answer(self, names: Names, design: int) -> str | None:
        """Say the largest forces on piston, wall and rod."""
        del names
        if np.all(np.isnan(self.piston_force[design, 0])):
            return None

        def peak(curve: Array) -> str:
            return number(float(np.nanmax(np.abs(curve[design, 0]))), "kN")

        return _("Largest forces: {piston} along the cylinder, {side} on its wall, {rod} in the rod.").format(
            piston=peak(self.piston_force), side=peak(self.side_force), rod=peak(self.rod_force)
        )


def piston_force_set(
    direct: DirectPistons, loaded: LoadedMachine, solved: SolvedCycle, crank_angle: CrankAngle, gas: GasPressures | None
) -> PistonForceSet:
    """Forces of every piston, exact and by the textbook's two harmonics of inertia.

    Notes
    -----
    Exact means the motion: the rod is two masses in both. docs/theory/forces, eqs. (13.30) to (13.34).
    """
    phi = crank_angle.angle
    drive = loaded.speed.drive(phi)
    sets = np.full((6, len(phi), len(_INERTIA), direct.n_pistons, phi.shape[-1]), np.nan)
    identities: list[Array] = []
    for one in _direct(loaded, solved):
        pressed = 0.0 if gas is None else gas.gas_force[:, one.piston]
        angle = phi + one.group.members.phase
        for method, inertia in enumerate(_INERTIA.values()):
            pulled = inertia(one, angle, drive)
            found = piston_forces(pressed + pulled, one.motion, one.group.members.geometry)
            for part, values in zip(sets, (pulled, *found), strict=True):
                part[:, method, one.piston] = values
            # A rod whose centroid lies beside its line is no two masses: there are no such forces to check.
            if np.any(np.isfinite(one.mass)):
                identities.append(_residual(found, one))
    return PistonForceSet(*sets, checks=(_check(identities),) if identities else ())


def _check(residuals: Sequence[Array]) -> Check:
    """Take the largest of what the identities leave."""
    return Check(
        "piston_forces",
        _("K² + T² = S², TR = Px′ and TR = Ns + Pe, relative to their peaks"),
        np.fmax.reduce(residuals, axis=0),
        _LIMIT,
    )


def _exact_inertia(one: _Direct, _angle: Array, drive: Drive) -> Array:
    return inertia_force(one.motion.slider, one.mass, drive)


def _two_harmonics(one: _Direct, angle: Array, drive: Drive) -> Array:
    return two_harmonic_inertia_force(angle, one.group.members.geometry, one.mass, drive)


_INERTIA: Mapping[str, Callable[[_Direct, Array, Drive], Array]] = {
    "exact": _exact_inertia,
    "two_harmonics": _two_harmonics,
}


def _residual(forces: PistonForces, one: _Direct) -> Array:
    """Largest residual of the identities where links close, each relative to its peak, shape (design,)."""
    geometry = one.group.members.geometry
    found = piston_identities(forces, one.motion, geometry)
    peak = np.fmax.reduce(np.abs(forces.rod), axis=-1)
    arm = (geometry.crank_radius + geometry.rod_length)[..., 0]
    scales = (peak * peak, peak * arm, peak * arm)
    parts = [
        np.fmax.reduce(np.abs(part), axis=-1) / np.where(scale > 0, scale, 1.0)
        for part, scale in zip(found, scales, strict=True)
    ]
    return np.fmax.reduce(np.fmax.reduce(parts), axis=-1)
