"""Curves of the forces at a piston and at its crank pin, under the gas and over the torque."""

from collections.abc import Iterator

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.panels.design import OneDesign, closed
from cranktrain.panels.shapes import Curve, Panel
from cranktrain.panels.sheets.gas.panels import pressure_panel
from cranktrain.panels.sheets.torque.panels import torque_panel

_EXACT, _FORMULA = "exact", "textbook"
_SEEN = 0.02
"""A difference of two curves that can be seen, in parts of the peak."""


def force_panels(result: Result, piston: str | None, design: int = 0) -> Iterator[Panel]:
    """Collect the curves over the crank angle.

    Parameters
    ----------
    result : Result
    piston : str or None
        Whose pressure and forces.
    design : int

    Yields
    ------
    Panel
        Pressure; P, S and N; K and T, of a master with S at the crank pin, of a slave its share; beside them the
        formula's N and T where it is seen to be off; torque of every mechanism, of all together and its mean.
    """
    shown = OneDesign(result, design)
    if piston is not None and shown.has("gas_pressure"):
        yield pressure_panel(shown, piston)
    if piston is not None and has_forces(result, piston):
        yield _at_piston(shown, piston)
        is_on_pin = not np.all(np.isnan(_force(shown, piston, "tangential_force")))
        yield _at_pin(shown, piston) if is_on_pin else _share(shown, piston)
    yield torque_panel(shown)


def has_forces(result: Result, piston: str) -> bool:
    """Whether a piston has a rod, so that it has forces of its own, and anything acts on it."""
    if "piston_force" not in result.catalogue:
        return False
    side, along = (_force(OneDesign(result, 0), piston, name) for name in ("side_force", "rod_force_at_piston_pin"))
    return bool(np.all(np.isfinite(side)) and np.any(along))


def is_off(shown: OneDesign, piston: str, error: str) -> bool:
    """Whether the formula's error can be seen; no formula has none."""
    return formula_error(shown, piston, error) > _SEEN


def formula_error(shown: OneDesign, piston: str, error: str) -> float:
    """Error of a formula for a force of a piston, in parts of the peak."""
    return float(shown(error)[shown.member("force_method", _FORMULA), shown.member("piston", piston)])


def _force(shown: OneDesign, piston: str, name: str, method: str = _EXACT) -> Array:
    """A force of a piston over the cycle. [N]"""
    return closed(shown(name)[shown.member("force_method", method), shown.member("piston", piston)])


def _at_piston(shown: OneDesign, piston: str) -> Panel:
    """P, S and N, and the formula's N where that is seen to be off."""
    curves = [
        Curve(_force(shown, piston, "piston_force"), "main", "p", "P"),
        Curve(_force(shown, piston, "rod_force_at_piston_pin"), "resultant", "F", "S"),
        Curve(_force(shown, piston, "side_force"), "side", "N", "N"),
    ]
    if is_off(shown, piston, "side_force_formula_error"):
        curves.append(Curve(_force(shown, piston, "side_force", _FORMULA), "formula", "N", "N_f"))
    words = next(one.kind.output.words for one in shown.result.machines[0].places if one.name == piston)
    assert words is not None  # of a slider
    return Panel(_(words.forces, piston=piston), "N", shown.cycle, tuple(curves))


def _at_pin(shown: OneDesign, piston: str) -> Panel:
    """T and K at the crank pin, S there where the rod's mass makes it another, and the formula's T."""
    curves = [
        Curve(_force(shown, piston, "tangential_force"), "main", "T", "T"),
        Curve(_force(shown, piston, "radial_force"), "radial", "K", "K"),
    ]
    along, at_crank = (_force(shown, piston, f"rod_force_at_{pin}_pin") for pin in ("piston", "crank"))
    if np.max(np.abs(at_crank - along)) > _SEEN * np.max(np.abs(at_crank)):
        curves.append(Curve(at_crank, "resultant", "F", "S_A"))
    if is_off(shown, piston, "tangential_force_formula_error"):
        curves.append(Curve(_force(shown, piston, "tangential_force", _FORMULA), "formula", "T", "T_f"))
    return Panel(_("Forces at its crank pin"), "N", shown.cycle, tuple(curves))


def _share(shown: OneDesign, piston: str) -> Panel:
    """What a slave brings to the load of its master's crank pin."""
    place = shown.member("mechanism", piston)
    along, toward = (closed(shown(f"crankpin_share_{part}")[place]) for part in ("tangential", "radial"))
    curves = Curve(along, "main", "T", "T_i"), Curve(toward, "radial", "K", "K_i")
    return Panel(_("Its share of the crank pin's load"), "N", shown.cycle, curves)
