"""Curves of forces over the crank angle, as panels: data first, and drawn on a sheet."""

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.viz.paper.page import Axes, Page, formula
from cranktrain.viz.paper.style import COLOURS, GRID, MUTED, SYMBOL, TEXT
from cranktrain.viz.plans.sheet import figure

_EXACT, _FORMULA = "exact", "textbook"
_SEEN = 0.02
"""A difference of two curves that can be seen, in parts of the peak."""
_HEAD, _GAP, _FOOT = 5.2, 9.0, 9.0
"""Above panels for the first one's head, between them, and below them for the crank angle. [mm]"""

_TALLEST = 60.0
"""Of panels, where there are few. [mm]"""

_MANY = 20e3
"""From here on newton metres are shown by the thousand."""


class OneDesign(NamedTuple):
    """A result and which of its designs."""

    result: Result
    design: int

    def __call__(self, name: str) -> Array:
        """Give a quantity of the design."""
        values: Array = getattr(self.result, name)
        return values[self.design] if self.result.has_designs else values

    def has(self, name: str) -> bool:
        """Whether there is such a quantity."""
        return name in self.result.catalogue


class Drawn(NamedTuple):
    """A curve: its symbol as mathematics sets it, values, the letter of its colour, width, dashes."""

    symbol: str
    values: Array
    letter: str
    width: float
    dashes: tuple[float, ...] = ()


class ForcePanel(NamedTuple):
    """Curves of one kind over the crank angle: title, unit, curves that are named at its head, curves that are not."""

    title: str
    unit: str
    named: tuple[Drawn, ...]
    others: tuple[Drawn, ...] = ()


def force_panels(result: Result, piston: str | None, design: int = 0) -> Iterator[ForcePanel]:
    """Collect the curves over the crank angle.

    Parameters
    ----------
    result : Result
    piston : str or None
        Whose pressure and forces.
    design : int

    Yields
    ------
    ForcePanel
        Pressure in MPa; P, S and N; K and T, of a master with S at the crank pin, of a slave its share; beside them the
        formula's N and T where it is seen to be off; torque of every mechanism, of all together and its mean.
    """
    shown = OneDesign(result, design)
    if piston is not None and shown.has("gas_pressure"):
        at = chambers_of(result, piston)
        named = [Drawn("p", shown("gas_pressure")[at[0]] / 1e6, "p", 1.6)]
        named += [Drawn("p", shown("gas_pressure")[i] / 1e6, "p", 0.9, (5.0, 2.0)) for i in at[1:]]
        yield ForcePanel(_("Gas pressure at piston {piston}, absolute").format(piston=piston), "MPa", tuple(named))
    if piston is not None and has_forces(result, piston):
        yield from _piston_panels(shown, piston)
    torque = shown("machine_torque")
    factor, unit = (1e3, "kN·m") if np.nanmax(np.abs(torque)) >= _MANY else (1.0, "N·m")
    whole = Drawn(r"T_\Sigma", torque / factor, "T", 1.9)
    average = float(shown("mean_torque")) / factor
    mean = Drawn("T_m", np.full_like(torque, average), "F", 0.9, (6.0, 3.0))
    each = tuple(Drawn("", values / factor, "T", 0.45) for values in shown("mechanism_torque") if np.any(values))
    title = _("Torque on the shaft, mean {mean}").format(mean=figure(average))
    yield ForcePanel(title, unit, (whole, mean), each if len(each) > 1 else ())


def has_forces(result: Result, piston: str) -> bool:
    """Whether a piston has a rod, so that it has forces of its own, and anything acts on it."""
    if "piston_force" not in result.catalogue:
        return False
    at = _method(result, _EXACT), result.labels["piston"].index(piston)
    side, along = (OneDesign(result, 0)(name)[at] for name in ("side_force", "rod_force_at_piston_pin"))
    return bool(np.all(np.isfinite(side)) and np.any(along))


def is_off(shown: OneDesign, piston: str, error: str) -> bool:
    """Whether the formula's error can be seen; no formula has none."""
    result = shown.result
    found = shown(error)[_method(result, _FORMULA), result.labels["piston"].index(piston)]
    return bool(found > _SEEN)


def _method(result: Result, name: str) -> int:
    return result.labels["force_method"].index(name)


def _piston_panels(shown: OneDesign, piston: str) -> Iterator[ForcePanel]:
    """Forces at the piston, and at the crank pin."""
    result = shown.result
    row, place = result.labels["piston"].index(piston), result.labels["mechanism"].index(piston)

    def curve(name: str, method: str = _EXACT) -> Array:
        return shown(name)[_method(result, method), row] / 1e3

    at_piston = [
        Drawn("P", curve("piston_force"), "p", 1.6),
        Drawn("S", curve("rod_force_at_piston_pin"), "F", 0.8, (2.0, 2.0)),
        Drawn("N", curve("side_force"), "N", 1.1, (8.0, 2.0)),
    ]
    if is_off(shown, piston, "side_force_formula_error"):
        at_piston.append(Drawn("N_f", curve("side_force", _FORMULA), "N", 0.5, (3.0, 2.0)))
    is_valve = not next(one.kind.has_chambers for one in result.machines[0].places if one.name == piston)
    title = _("Forces at valve {piston}") if is_valve else _("Forces at piston {piston}")
    yield ForcePanel(title.format(piston=piston), "kN", tuple(at_piston))
    tangential = curve("tangential_force")
    if np.all(np.isnan(tangential)):
        shares = (shown(f"crankpin_share_{part}")[place] / 1e3 for part in ("tangential", "radial"))
        named = [Drawn("T_i", next(shares), "T", 1.6), Drawn("K_i", next(shares), "K", 0.9, (6.0, 2.0))]
        yield ForcePanel(_("Its share of the crank pin's load"), "kN", tuple(named))
        return
    at_pin = [Drawn("T", tangential, "T", 1.6), Drawn("K", curve("radial_force"), "K", 0.9, (6.0, 2.0))]
    at_crank = curve("rod_force_at_crank_pin")
    if np.max(np.abs(at_crank - at_piston[1].values)) > _SEEN * np.max(np.abs(at_crank)):
        at_pin.append(Drawn("S_A", at_crank, "F", 0.8, (2.0, 2.0)))
    if is_off(shown, piston, "tangential_force_formula_error"):
        at_pin.append(Drawn("T_f", curve("tangential_force", _FORMULA), "T", 0.5, (3.0, 2.0)))
    yield ForcePanel(_("Forces at its crank pin"), "kN", tuple(at_pin))


def chambers_of(result: Result, piston: str) -> list[int]:
    """Places of a piston's chambers: of its own name, of both its sides, or of the cylinder that it shares."""
    names = result.labels["chamber"]
    return [
        i
        for i, name in enumerate(names)
        if name == piston or name.startswith(f"{piston}.") or piston.startswith(f"{name}.")
    ] or [0]


def draw_panels(
    page: Page, shown: OneDesign, found: Sequence[ForcePanel], box: tuple[float, float, float, float]
) -> None:
    """Stack the panels over one crank angle."""
    left, bottom, width, height = box
    each = min((height - _FOOT - _HEAD - _GAP * (len(found) - 1)) / len(found), _TALLEST)
    angle = shown.result.crank_angle
    cycle = float(len(angle) * (angle[1] - angle[0]))
    for number, panel in enumerate(found):
        low = bottom + height - _HEAD - (number + 1) * each - number * _GAP
        axes = page.axes(left, low, width, each)
        prepare(axes)
        axes.axhline(0.0, color=MUTED, linewidth=0.6, zorder=1)
        for curve in (*panel.others, *panel.named):
            values = np.append(curve.values, curve.values[0])
            style: Any = (0, curve.dashes) if curve.dashes else "-"
            axes.plot(np.append(angle, cycle), values, color=COLOURS[curve.letter], lw=curve.width, ls=style)
        axes.set(xlim=(0.0, cycle), xticks=np.arange(0.0, cycle + 1.0, 60.0 if cycle > 360.0 else 30.0))
        axes.tick_params(labelbottom=number == len(found) - 1)
        _head(page, panel, (left, left + width, low + each + 2.2))
    page.text(
        left + width / 2,
        bottom + height - _HEAD - len(found) * (each + _GAP) + _GAP - _FOOT,
        _("Crank angle φ, °"),
        ha="center",
    )


def prepare(axes: Axes) -> None:
    """Give axes our grid, ticks and frame."""
    from matplotlib.ticker import MaxNLocator

    axes.grid(color=GRID, linewidth=0.5)
    axes.set_axisbelow(True)
    axes.margins(y=0.08)
    axes.tick_params(labelsize=TEXT, pad=2.0)
    axes.yaxis.set_major_locator(MaxNLocator(nbins=4, steps=[1, 2, 5, 10], min_n_ticks=3))
    axes.spines[["top", "right"]].set_visible(False)


def _head(page: Page, panel: ForcePanel, place: tuple[float, float, float]) -> None:
    """Title at the left, samples of the curves with their symbols at the right."""
    left, right, y = place
    page.heading(left, y, f"{panel.title}, {panel.unit}")
    for number, curve in enumerate(reversed(panel.named)):
        x = right - 18.0 * number
        colour = COLOURS[curve.letter]
        page.text(x, y, formula(curve.symbol), ha="right", color=colour, fontsize=SYMBOL)
        manner = {"dashes": curve.dashes} if curve.dashes else {}
        page.sample(x - 14.0, x - 6.5, y + 0.9, color=colour, lw=curve.width, **manner)
