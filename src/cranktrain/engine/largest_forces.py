"""Largest forces of pistons, walls and rods, and by how much the textbook's formula is off."""

from collections.abc import Sequence
from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from cranktrain.catalogue import quantity
from cranktrain.engine.crank_pins import largest_on_grid
from cranktrain.engine.forces import Carriers
from cranktrain.engine.layout import CrankAngle
from cranktrain.engine.piston_forces import FORCE_METHODS, PistonForceSet
from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.wording import Names, number, ranged

_FACT = ("piston",)
_ERROR = ("force_method", "piston")
_THEORY = "docs/theory/forces"
_EXACT, _FORMULA = FORCE_METHODS.index("exact"), FORCE_METHODS.index("textbook")
_ALIKE = 1e-9
"""Forces that differ by less, relative, are the same."""


@record
class LargestForces:
    """Largest forces of every piston with a rod, by the reactions; errors of the formula, in parts of the exact peak."""

    largest_piston_force: Array = quantity(
        "P_max", "N", _FACT, N_("Largest force along the cylinder, either way"), _THEORY
    )
    largest_piston_force_at: Array = quantity(
        "φ(P_max)", "deg", _FACT, N_("Crank angle of the largest force along the cylinder"), _THEORY
    )
    largest_side_force: Array = quantity("N_max", "N", _FACT, N_("Largest force of the wall, on either side"), _THEORY)
    largest_side_force_at: Array = quantity(
        "φ(N_max)", "deg", _FACT, N_("Crank angle of the largest force of the wall"), _THEORY
    )
    largest_rod_force: Array = quantity(
        "S_max", "N", _FACT, N_("Largest force along the rod at either pin, in compression or tension"), _THEORY
    )
    largest_rod_force_at: Array = quantity(
        "φ(S_max)", "deg", _FACT, N_("Crank angle of the largest force along the rod"), _THEORY
    )
    side_force_formula_error: Array = quantity(
        "ΔN_f", "1", _ERROR, N_("Largest error of the method's side force, in parts of the exact peak"), _THEORY
    )
    tangential_force_formula_error: Array = quantity(
        "ΔT_f", "1", _ERROR, N_("Largest error of the method's tangential force, in parts of the exact peak"), _THEORY
    )
    is_master: NDArray[np.bool_] = field(default_factory=lambda: np.zeros(0, dtype=np.bool_))

    def answer(self, names: Names, design: int) -> str | None:
        """Say the largest forces on pistons, walls and rods, and what the formula misses where slaves hang on a rod."""
        sizes = [part[design] for part in (self.largest_piston_force, self.largest_side_force, self.largest_rod_force)]
        if not all(np.any(size > 0) for size in sizes):
            return None
        piston, side, rod = (_largest_of(names["piston"], size) for size in sizes)
        said = _("Largest forces: {piston} along the cylinder, {side} on its wall, {rod} in the rod.").format(
            piston=piston, side=side, rod=rod
        )
        masters = np.flatnonzero(self.is_master)
        errors = [
            part[design, _FORMULA, masters]
            for part in (self.side_force_formula_error, self.tangential_force_formula_error)
        ]
        if not all(np.any(error > 0) for error in errors):
            return said
        off = _("P·f(β), which knows no slaves, is off by up to {side} in N and {tangential} in T of {masters}.").format(
            side=number(float(np.nanmax(errors[0])), "%"),
            tangential=number(float(np.nanmax(errors[1])), "%"),
            masters=ranged(names["piston"], masters.tolist()),
        )
        return f"{said} {off}"


def largest_forces(forces: PistonForceSet, carriers: Carriers, crank_angle: CrankAngle) -> LargestForces:
    """Find the largest of the forces of all pistons."""
    piston, side, small_end, big_end = (
        np.abs(curve[:, _EXACT])
        for curve in (
            forces.piston_force,
            forces.side_force,
            forces.rod_force_at_piston_pin,
            forces.rod_force_at_crank_pin,
        )
    )
    found = (largest_on_grid(size, crank_angle) for size in (piston, side, np.fmax(small_end, big_end)))
    is_master = np.zeros(piston.shape[1], dtype=np.bool_)
    is_master[carriers.piston[carriers.master[carriers.master >= 0]]] = True
    return LargestForces(
        *(fact for value_and_angle in found for fact in value_and_angle),
        _errors(forces.side_force),
        _errors(forces.tangential_force),
        is_master=is_master,
    )


def _errors(curves: Array) -> Array:
    """Largest error of every method, in parts of the exact peak, shape (design, force_method, piston)."""
    exact = curves[:, _EXACT, np.newaxis]
    peak = np.max(np.abs(exact), axis=-1)
    return np.max(np.abs(curves - exact), axis=-1) / np.where(peak > 0, peak, np.nan)


def _largest_of(names: Sequence[str], size: Array) -> str:
    """Say the largest of some forces, and whose it is unless all are alike."""
    largest = float(np.nanmax(size))
    alike = np.flatnonzero(size >= (1 - _ALIKE) * largest).tolist()
    said = number(largest, "kN")
    return said if len(alike) == np.count_nonzero(~np.isnan(size)) else f"{said} ({ranged(names, alike)})"
