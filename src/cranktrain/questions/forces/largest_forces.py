"""Largest forces of pistons, walls and rods, and by how much the textbook's formula is off."""

from collections.abc import Sequence
from dataclasses import field
from functools import partial

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, _
from cranktrain.layout.mechanisms import Pistons
from cranktrain.motion import Array
from cranktrain.numerics import Extreme
from cranktrain.numerics.nested import put
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.forces.peaks import ForcePeaks, MachineCurves, one_sided, relative
from cranktrain.questions.forces.piston_forces import FORCE_METHODS, PistonForceSet
from cranktrain.questions.forces.rods_in_pistons import ForcesOfRods, RodsInPistons, RodsOnGrid, rods_in_pistons
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import Flagged

_FACT = ("piston",)
_ERROR = ("force_method", "piston")
_EXACT, _FORMULA = FORCE_METHODS.index("exact"), FORCE_METHODS.index("textbook")
_SAID = ("P", "N", "S", "S")
_ALIKE = 1e-9
"""Forces that differ by less, relative, are the same."""


@record
class LargestForces(Flagged):
    """Largest forces of every piston with a rod, by the reactions; errors of the formula, in parts of exact peaks.

    Attributes
    ----------
    is_master : array of bool, shape (piston,)
    has_rod_loads : bool
        Whether gas works on both sides of a piston, so that rod loads say more than the largest force in a rod.
    """

    largest_piston_force: Extreme = extreme(
        "P_max",
        "N",
        _FACT,
        N_("Largest force along the cylinder, either way"),
        N_("Crank angle of the largest force along the cylinder"),
        _THEORY,
        "13.30",
        worst="largest",
    )
    largest_side_force: Extreme = extreme(
        "N_max",
        "N",
        _FACT,
        N_("Largest force of the wall, on either side"),
        N_("Crank angle of the largest force of the wall"),
        _THEORY,
        "13.10",
        worst="largest",
    )
    largest_rod_force: Extreme = extreme(
        "S_max",
        "N",
        _FACT,
        N_("Largest force along the rod at either pin, in compression or tension"),
        N_("Crank angle of the largest force along the rod"),
        _THEORY,
        "13.50",
        worst="largest",
    )
    side_force_formula_error: Array = quantity(
        "ΔN_f",
        "1",
        _ERROR,
        N_("Largest error of the method's side force, at whole degrees, in parts of the exact peak"),
        _THEORY,
        "13.10, 13.31",
    )
    tangential_force_formula_error: Array = quantity(
        "ΔT_f",
        "1",
        _ERROR,
        N_("Largest error of the method's tangential force, at whole degrees, in parts of the exact peak"),
        _THEORY,
        "13.31, 13.35, 13.36",
    )
    is_master: NDArray[np.bool_] = field(kw_only=True)
    has_rod_loads: bool = field(kw_only=True)


@record
class PistonCurves(MachineCurves):
    """Sizes of those of P, N, S and S at the crank that are asked for: which, and of which piston, (curve,).

    shape: how many of all there are, and of which designs and pistons.
    """

    which: NDArray[np.intp]
    piston: NDArray[np.intp]
    shape: tuple[int, int, int]


def piston_curves(pistons: Pistons, loaded: LoadedMachine, rods: RodsOnGrid) -> PistonCurves:
    """Sizes of the forces of all pistons by the reactions."""
    shape = len(_SAID), len(loaded.speed.value), len(pistons.names)
    samples = _sizes(shape, rods.each)
    for one, _forces in rods.each:
        if not one.is_on_pin:
            samples[3][:, one.piston] = np.nan
    which, piston = _asked(samples)
    sizes = partial(_sizes_asked, loaded, shape, which, piston)
    own = np.moveaxis(samples[which, :, piston], 0, 1)
    return PistonCurves(loaded.carriers.driven[piston], own, sizes, which=which, piston=piston, shape=shape)


def _sizes_asked(
    loaded: LoadedMachine,
    shape: tuple[int, int, int],
    which: NDArray[np.intp],
    piston: NDArray[np.intp],
    found: tuple[SolvedBatch, ...],
) -> Array:
    """Those sizes that are asked for, of mechanisms that are solved at any angles, shape (design, curve, n)."""
    each = [(one, one.forces) for one in rods_in_pistons(loaded, found)]
    return np.moveaxis(_sizes(shape, each)[which, :, piston], 0, 1)


def _sizes(shape: tuple[int, int, int], rods: Sequence[tuple[RodsInPistons, ForcesOfRods]]) -> Array:
    """Sizes of P, N and S at either pin of all pistons, shape (force, design, piston, n)."""
    curves = np.full((*shape, rods[0][1].piston.shape[-1]), np.nan)
    for one, forces in rods:
        put(curves, one.piston, forces[1:])
    return np.abs(curves)


def largest_forces(
    forces: PistonForceSet, loaded: LoadedMachine, curves: PistonCurves, peaks: ForcePeaks
) -> LargestForces:
    """Find the largest of the forces of all pistons, refined on the mechanisms."""
    which, asked, peak = curves.which, curves.piston, peaks.of(curves)
    value, at = np.full((2, *curves.shape), np.nan)
    value[which, :, asked], at[which, :, asked] = peak.value.T, peak.angle.T
    # Along the rod the larger of both ends counts.
    is_at_crank = value[3] > value[2]
    value[2], at[2] = (np.where(is_at_crank, part[3], part[2]) for part in (value, at))
    master = loaded.carriers.master
    is_master = np.zeros(curves.shape[2], dtype=np.bool_)
    is_master[loaded.carriers.piston[master[master >= 0]]] = True
    names = [
        f"{_SAID[i]} {loaded.mechanisms.names[j]}" for i, j in zip(which.tolist(), curves.rows.tolist(), strict=True)
    ]
    # What rests on no mass and no gas is no answer.
    value, at = (np.where(value > 0, part, np.nan) for part in (value, at))
    return LargestForces(
        *(Extreme(*one) for one in zip(at[:3], value[:3], strict=True)),
        side_force_formula_error=_errors(forces.side_force),
        tangential_force_formula_error=_errors(forces.tangential_force),
        is_master=is_master,
        has_rod_loads=loaded.gas is not None and loaded.gas.chambers.are_double_acting,
        flags=tuple(one_sided([(_("largest"), peak)], names)),
    )


def _asked(samples: Array) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Which curves of which pistons are asked for: S at the crank pin only where it is another."""
    known = ~np.all(np.isnan(samples), axis=(1, 3))
    at_piston, at_crank = samples[2:]
    peak = np.fmax.reduce(at_piston, axis=-1, keepdims=True)
    known[3] &= np.any(np.abs(at_crank - at_piston) > _ALIKE * peak, axis=(0, 2))
    which, piston = np.nonzero(known)
    return which, piston


def _errors(curves: Array) -> Array:
    """Largest error of every method, in parts of the exact peak, shape (design, force_method, piston)."""
    exact = curves[:, _EXACT, np.newaxis]
    return relative(curves - exact, exact)
