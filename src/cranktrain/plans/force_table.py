"""Tables of a piston's forces at round crank angles: exact, by the textbook's formula, and how far this is off."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis import Result, run
from cranktrain.errors import InputError, Problem
from cranktrain.language import Words, _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.plans.acting import refuse_absent, refuse_idle
from cranktrain.plans.placement import name_of_output
from cranktrain.quantities import Dimension, shown, unlisted
from cranktrain.quantities.dimensions import plain, spellings
from cranktrain.questions.cylinders.declared import cylinders_of
from cranktrain.questions.forces.carriers import carriers_of
from cranktrain.record import record

STEPS = (10.0, 15.0, 30.0)
"""Steps of the crank angle in which tables of forces are made. [deg]"""

_AT_PISTON = {"P": "piston_force", "N": "side_force", "S": "rod_force_at_piston_pin"}
_KNUCKLED = {"S_A": "rod_force_at_crank_pin"}
_AT_PIN = {"K": "radial_force", "T": "tangential_force"}
_SHARES = {"K_i": "crankpin_share_radial", "T_i": "crankpin_share_tangential"}
_QUANTITIES = (*_AT_PISTON.values(), *_KNUCKLED.values(), *_AT_PIN.values(), *_SHARES.values())


@record
class ForceColumn:
    """A force, or the torque M, at the angles of a table, in the column's unit, by the joints' reactions and otherwise.

    By the textbook's formula and by that with two harmonics of inertia; NaN of a slave, for which there is none. Their
    errors are in parts of the exact curve's peak over the cycle.
    """

    symbol: str
    unit: str
    exact: Array
    textbook: Array
    textbook_error: Array
    two_harmonics: Array
    two_harmonics_error: Array


@record
class ForceTable:
    """Forces of a piston at round crank angles.

    Attributes
    ----------
    piston : str
    called : Words
        What it is and its name: piston 1L, ram 1.
    angle : Array, shape (n,)
        Crank angle as the machine shows it. [deg]
    unit : str
        Of the forces, or of the forces over the piston's area.
    area : float or None
        The piston's, over which forces are; None where they are forces. [m²]
    columns : tuple of ForceColumn
        P, N, S, K (Z in some books), T, and the torque M = TR; S of a master at the piston pin, S_A at the crank pin,
        where slaves are in it; of a slave its share of what the pin bears, K_i, T_i and M_i.
    sort : "plain", "master" or "slave"
        What the piston's rod is.
    """

    piston: str
    called: Words
    angle: Array
    unit: str
    area: float | None
    columns: tuple[ForceColumn, ...]
    sort: Literal["plain", "master", "slave"]


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
        With a rod; the first one whose rod is on a crank pin unless given.

    Returns
    -------
    ForceTable

    Raises
    ------
    InputError
        If nothing acts on the links, the piston has no such forces, or its bore is needed and not given.

    Notes
    -----
    docs/theory/forces, eqs. (13.30) to (13.36) and (13.50).
    """
    name, is_pressure = _unit(unit)
    if step not in STEPS:
        raise InputError([unlisted("--step", f"{step:g}", [f"{one:g}" for one in STEPS])])
    refuse_idle(machine)
    place = _piston(machine, piston)
    result = run(machine, quantities=_QUANTITIES)
    area = _area(machine, place) if is_pressure else None
    kept = np.isclose(result.crank_angle % step, 0.0)
    per_unit = shown(1.0, name) / (area or 1.0)
    torque = "kgf·m" if name.startswith("kgf") else "N·m"
    pin = place.kind.motion(np.zeros(1), place.geometry).pin
    arm = float(np.hypot(pin.x.value[0], pin.y.value[0])) * shown(1.0, torque)
    sort = _sort(machine, place)
    at_pin = _SHARES if sort == "slave" else _KNUCKLED | _AT_PIN if sort == "master" else _AT_PIN
    quantities = _AT_PISTON | at_pin
    refuse_absent(result, quantities.values())
    if not np.any(np.isfinite(getattr(result, _AT_PISTON["P"]))):
        allowed = _("must act with a force that is a number: see what `run` says of the gas and the motion")
        raise InputError([Problem("gas", None, allowed)])
    curves = {symbol: _by_method(result, quantity, place.name) for symbol, quantity in quantities.items()}
    columns = [_column(symbol, name, per_unit * curve, kept) for symbol, curve in curves.items()]
    turning = "T_i" if sort == "slave" else "T"
    columns.append(_column(turning.replace("T", "M"), torque, arm * curves[turning], kept))
    called = name_of_output(machine, place)
    return ForceTable(place.name, called, result.crank_angle[kept], name, area, tuple(columns), sort)


def _by_method(result: Result, quantity: str, piston: str) -> Array:
    """Curves of a piston by the reactions, the formula and two harmonics, shape (3, n); NaN where there is none."""
    of_all = getattr(result, quantity)
    if "force_method" not in result.catalogue[quantity].dimensions:
        exact = of_all[result.labels["mechanism"].index(piston)]
        return np.stack([exact, *2 * [np.full_like(exact, np.nan)]])
    methods = [result.labels["force_method"].index(method) for method in ("exact", "textbook", "two_harmonics")]
    return of_all[methods, result.labels["piston"].index(piston)]


def _column(symbol: str, unit: str, curves: Array, kept: NDArray[np.bool_]) -> ForceColumn:
    """Take a column's angles out of its curves, with their errors."""
    exact, textbook, two_harmonics = curves
    peak = float(np.max(np.abs(exact))) or 1.0
    taken = ((curve[kept], (curve - exact)[kept] / peak) for curve in (textbook, two_harmonics))
    return ForceColumn(symbol, unit, exact[kept], *(values for pair in taken for values in pair))


def _sort(machine: Machine, place: PlacedMechanism) -> Literal["plain", "master", "slave"]:
    """What a piston's rod is: on another's, with others on it, or neither."""
    if place.kind.dynamics.on_master is not None:
        return "slave"
    return "master" if machine.places.index(place) in carriers_of(machine.places).master else "plain"


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


def _piston(machine: Machine, wanted: str | None) -> PlacedMechanism:
    """Find a piston with a rod; unless named, the first whose rod is on a crank pin."""
    rods = {place.name: place for place in machine.design.pistons if place.kind.has_rod}
    if not rods:
        raise InputError([Problem("mechanism", None, _("this machine has no piston with a rod"))])
    if wanted is None:
        on_pins = (place for place in rods.values() if place.kind.dynamics.joint("crank_pin") is not None)
        return next(on_pins)
    if wanted not in rods:
        raise InputError([unlisted("--piston", wanted, list(rods))])
    return rods[wanted]


def _area(machine: Machine, piston: PlacedMechanism) -> float:
    """Area of a piston, π/4 of its bore squared. [m²]"""
    bores = (cylinder.bore for cylinder in cylinders_of(machine.cylinder, [piston]))
    bore = next(bores, None)
    if bore is None:
        raise InputError([Problem("cylinder.bore", None, _("is missing: forces over the piston's area need it"))])
    return np.pi / 4 * bore.si**2
