"""Tables of a piston's forces at round crank angles: exact, by two harmonics of inertia, and how far these are off."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from cranktrain.analysis import run
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.quantities import Dimension, shown, unlisted
from cranktrain.quantities.dimensions import plain, spellings
from cranktrain.study.acting import refuse_idle

STEPS = (10.0, 15.0, 30.0)
"""Steps of the crank angle in which tables of forces are made. [deg]"""

_FORCES: Mapping[str, str] = {
    "P": "piston_force",
    "N": "side_force",
    "S": "rod_force",
    "K": "radial_force",
    "T": "tangential_force",
}
_TORQUE = "M"


class ForceColumn(NamedTuple):
    """A force, or the torque M, at the angles of a table: exact, by two harmonics, in the column's unit; error.

    The error is in parts of the exact curve's peak over the cycle. Two harmonics are NaN for an offset mechanism.
    """

    symbol: str
    unit: str
    exact: Array
    two_harmonics: Array
    error: Array


@dataclass(frozen=True)
class ForceTable:
    """Forces of a piston at round crank angles.

    Attributes
    ----------
    piston : str
    angle : Array, shape (n,)
        Crank angle as the machine shows it. [deg]
    unit : str
        Of the forces, or of the forces over the piston's area.
    area : float or None
        The piston's, over which forces are; None where they are forces. [m²]
    columns : tuple of ForceColumn
        P, N, S, K (Z in some books), T, and the torque M = TR.
    """

    piston: str
    angle: Array
    unit: str
    area: float | None
    columns: tuple[ForceColumn, ...]


def force_table(machine: Machine, *, step: float = 30.0, unit: str = "N", piston: str | None = None) -> ForceTable:
    """Tabulate a piston's forces.

    Parameters
    ----------
    machine : Machine
        With a speed, and masses or gas.
    step : 10, 15 or 30
        Of the crank angle. [deg]
    unit : str
        Of force; or of pressure, for forces over the piston's area.
    piston : str, optional
        With a rod on a crank pin; the first one unless given.

    Returns
    -------
    ForceTable

    Raises
    ------
    InputError
        If nothing acts on the links, the piston has no such forces, or its bore is needed and not given.

    Notes
    -----
    The rod is two masses in both; only the inertia differs. docs/theory/forces, eqs. (13.30) to (13.34).
    """
    name, is_pressure = _unit(unit)
    if step not in STEPS:
        raise InputError([unlisted("--step", f"{step:g}", [f"{one:g}" for one in STEPS])])
    refuse_idle(machine)
    result = run(machine, quantities=_FORCES.values())
    found = _piston(machine, piston)
    area = _area(machine, found) if is_pressure else None
    row = result.labels["piston"].index(found)
    kept = np.isclose(result.crank_angle % step, 0.0)
    radius = next(place.geometry.crank_radius for place in machine.places if place.name == found)
    per_unit = shown(1.0, name)

    def column(symbol: str, quantity: str, factor: float, column_unit: str) -> ForceColumn:
        exact, textbook = (
            factor * getattr(result, quantity)[result.labels["force_method"].index(method), row]
            for method in ("exact", "two_harmonics")
        )
        peak = float(np.max(np.abs(exact))) or 1.0
        return ForceColumn(symbol, column_unit, exact[kept], textbook[kept], ((textbook - exact) / peak)[kept])

    torque = "kgf·m" if name.startswith("kgf") else "N·m"
    columns = [column(symbol, quantity, per_unit / (area or 1.0), name) for symbol, quantity in _FORCES.items()]
    columns.append(column(_TORQUE, _FORCES["T"], radius * shown(1.0, torque), torque))
    return ForceTable(found, result.crank_angle[kept], name, area, tuple(columns))


def _unit(text: str) -> tuple[str, bool]:
    """Read a unit of force or pressure: its listed form, and whether it is of pressure."""
    for dimension in (Dimension.FORCE, Dimension.PRESSURE):
        found = spellings(dimension).get(plain(text))
        if found is not None and not _is_gauge(found[1]):
            return found[1], dimension is Dimension.PRESSURE
    units = [unit.name for dimension in (Dimension.FORCE, Dimension.PRESSURE) for unit in dimension.units]
    listed = [*(one for one in units if not _is_gauge(one)), "kgf/cm²"]
    raise InputError([unlisted("--forces", text, listed)])


def _is_gauge(unit: str) -> bool:
    """Whether a unit of pressure counts from the ambient one: a force over an area is no such pressure."""
    return shown(0.0, unit) != 0.0


def _piston(machine: Machine, wanted: str | None) -> str:
    """Find a piston whose rod is on a crank pin."""
    direct = [place.name for place in machine.places if place.kind.name == "slider_crank"]
    if not direct:
        allowed = _("this machine has no piston whose rod is on a crank pin")
        raise InputError([Problem("--piston", wanted, allowed)])
    if wanted is None:
        return direct[0]
    if wanted not in direct:
        raise InputError([unlisted("--piston", wanted, direct)])
    return wanted


def _area(machine: Machine, piston: str) -> float:
    """Area of a piston, π/4 of its bore squared. [m²]"""
    at = next(i for i, place in enumerate(machine.pistons) if place.name == piston)
    bore = next(one.spec.bore for one in machine.cylinders if at in one.pistons)
    if bore is None:
        raise InputError([Problem("cylinder.bore", None, _("is missing: forces over the piston's area need it"))])
    return np.pi / 4 * bore.si**2
