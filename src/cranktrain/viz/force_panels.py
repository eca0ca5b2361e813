"""Curves of forces over the crank angle, as panels: data first, and drawn on a sheet."""

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.viz.page import Axes, Page, formula
from cranktrain.viz.plan_sheet import figure
from cranktrain.viz.style import COLOURS, GRID, MUTED, SYMBOL, TEXT

_EXACT = "exact"
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
        Pressure in MPa; P, S and N; K and T; torque of every mechanism, of all together and its mean.
    """
    shown = OneDesign(result, design)
    if piston is not None and shown.has("gas_pressure"):
        at = chambers_of(result, piston)
        named = [Drawn("p", shown("gas_pressure")[at[0]] / 1e6, "p", 1.6)]
        named += [Drawn("p", shown("gas_pressure")[i] / 1e6, "p", 0.9, (5.0, 2.0)) for i in at[1:]]
        yield ForcePanel(_("Gas pressure at piston {piston}, absolute").format(piston=piston), "MPa", tuple(named))
    if piston is not None and shown.has("piston_force"):
        place, method = result.labels["piston"].index(piston), result.labels["force_method"].index(_EXACT)
        curves = {
            name: shown(name)[method, place]
            for name in ("piston_force", "rod_force", "side_force", "radial_force", "tangential_force")
        }
        if all(np.all(np.isfinite(values)) for values in curves.values()):
            yield from _piston_panels(piston, curves)
    torque = shown("machine_torque")
    factor, unit = (1e3, "kN·m") if np.nanmax(np.abs(torque)) >= _MANY else (1.0, "N·m")
    whole = Drawn(r"T_\Sigma", torque / factor, "T", 1.9)
    mean = Drawn("T_m", np.full_like(torque, np.mean(torque) / factor), "F", 0.9, (6.0, 3.0))
    each = tuple(Drawn("", values / factor, "T", 0.45) for values in shown("mechanism_torque") if np.any(values))
    title = _("Torque on the shaft, mean {mean}").format(mean=figure(float(np.mean(torque)) / factor))
    yield ForcePanel(title, unit, (whole, mean), each if len(each) > 1 else ())


def _piston_panels(piston: str, curves: dict[str, Array]) -> Iterator[ForcePanel]:
    """Forces at the piston, and at the crank pin."""
    along, rod, side = (curves[name] / 1e3 for name in ("piston_force", "rod_force", "side_force"))
    at_piston = (
        Drawn("P", along, "p", 1.6),
        Drawn("S", rod, "F", 0.8, (2.0, 2.0)),
        Drawn("N", side, "N", 1.1, (8.0, 2.0)),
    )
    yield ForcePanel(_("Forces at piston {piston}").format(piston=piston), "kN", at_piston)
    radial, tangential = (curves[name] / 1e3 for name in ("radial_force", "tangential_force"))
    at_pin = (Drawn("T", tangential, "T", 1.6), Drawn("K", radial, "K", 0.9, (6.0, 2.0)))
    yield ForcePanel(_("Forces at its crank pin"), "kN", at_pin)


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
