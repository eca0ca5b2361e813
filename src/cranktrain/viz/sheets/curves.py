"""Curves of a result as panels that share one crank angle: data first, and drawn on a sheet."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis import Result
from cranktrain.language import _
from cranktrain.layout.speed import rates
from cranktrain.layout.speed_curve import SpeedCurve
from cranktrain.linkage.forces import Drive
from cranktrain.machine import Machine
from cranktrain.motion import Array, Coefficient
from cranktrain.plans.placement import first_throw
from cranktrain.plans.turning import turning
from cranktrain.quantities import shown
from cranktrain.viz.paper.page import Axes, Page, formula
from cranktrain.viz.paper.style import COLOURS, GRID, HEADING, INK, MUTED, SYMBOL, TEXT

SHEET_QUANTITIES = (
    *("piston_displacement", "piston_velocity", "piston_velocity_coefficient", "piston_acceleration_coefficient"),
    *("displacement_by_method", "velocity_coefficient_by_method", "acceleration_coefficient_by_method"),
    *("displacement_error", "acceleration_error", "top_dead_centre", "bottom_dead_centre"),
    *("combined_displacement", "inner_volumetric_dead_centre", "outer_volumetric_dead_centre", "chamber_volume"),
    *("rocker_angle", "rocker_velocity_coefficient", "rocker_acceleration_coefficient"),
    *("largest_rocker_angle_at", "smallest_rocker_angle_at", "load_velocity_coefficient"),
)
"""All that a sheet shows of a result: `run(machine, quantities=SHEET_QUANTITIES)` suffices for it."""

Habit = Literal["first", "other", "textbook", "error"]

_FORMS = {"slider_crank": "two_harmonics", "articulated_rod": "reconstructed"}
"""Which of the textbook's forms stands beside each kind."""


DASHES = {"s": (1.5, 1.5), "v": (5.0, 2.0), "j": (9.0, 2.0, 2.0, 2.0)}
"""Dashes of an error by the letter of its quantity, for prints in grey."""

TEXTBOOK_DASHES = (4.0, 8.0)
"""Dashes of a textbook's curve, over the exact one."""


_PAIR = 2
_FEW = 2
"""Up to so many pistons, each has the textbook's curve beside its own."""


_MIDDLE = (4.0, 96.0)
"""Which of the values set the scale where the links cannot close all round. [%]"""


class Curve(NamedTuple):
    """A curve: whose it is, its values at each crank angle, its habit, the letter of its colour."""

    name: str
    values: Array
    habit: Habit
    letter: str


@dataclass(frozen=True)
class Panel:
    """Curves of one quantity over one turn.

    Attributes
    ----------
    title : str
        Its name.
    symbol : str
        As mathematics sets it.
    unit : str
    angle : Array, shape (n,)
        Crank angle from 0 to 360. [deg]
    curves : tuple of Curve
    """

    title: str
    symbol: str
    unit: str
    angle: Array
    curves: tuple[Curve, ...]


class Mark(NamedTuple):
    """A dead centre: whose, at which crank angle [deg], whether it is the top."""

    name: str
    angle: float
    is_top: bool


@dataclass(frozen=True)
class _Turn:
    """One turn of a result: which points of its grid, and the angles, closed at 360. [deg]"""

    result: Result
    design: int
    index: NDArray[np.intp]
    angle: Array

    def curve(self, name: str, *at: int) -> Array:
        """Give a quantity of a member over the turn; an angle that goes round goes on at the end."""
        values = getattr(self.result, name)
        whole = (values[self.design] if self.result.has_designs else values)[at][self.index]
        if name.endswith("angle"):
            whole[-1] += 2 * np.pi * np.rint((whole[-2] - whole[-1]) / (2 * np.pi))
        return whole

    @property
    def drive(self) -> Drive:
        """How the crank turns at each angle; by 1 rad/s where the machine has no speed."""
        phi = np.deg2rad(self.angle) + self.result.grid.zero[self.design, 0, 0]
        return turning(self.result.machines[self.design], self.result.get(SpeedCurve), phi, self.design)

    def moved(self, order: int, names: "_Names", *at: int) -> Array:
        """Give travel, velocity or acceleration of a member, by its motion's value and two derivatives."""
        motion = Coefficient(*(self.curve(name, *at) for name in names))
        return (motion.value, *rates(motion, self.drive))[order]


def drawn_names(result: Result, dimension: str) -> tuple[str, ...]:
    """Name the pistons or rockers of the first throw."""
    names = [place.name for place in first_throw(result.machines[0])]
    return tuple(name for name in result.labels.get(dimension, ()) if name in names)


def panels(result: Result, design: int = 0) -> tuple[Panel, ...]:
    """Collect the curves that a sheet shows.

    Parameters
    ----------
    result : Result
    design : int

    Returns
    -------
    tuple of Panel
        Travel, velocity, acceleration of the first throw's pistons and the textbook's error; of opposed pistons those
        of the first cylinder, with what both do together; or angle and derivatives of the rocker.
    """
    within = np.flatnonzero(result.crank_angle < 360.0)
    closed = np.append(within, within.size % result.crank_angle.size)
    turn = _Turn(result, design, closed, np.append(result.crank_angle[within], 360.0))
    pair = opposed_names(result.machines[design])
    if pair:
        return tuple(_opposed_panels(turn, pair))
    if "piston" in result.labels:
        return tuple(_piston_panels(turn))
    return tuple(_rocker_panels(turn))


def opposed_names(machine: Machine) -> tuple[str, ...]:
    """Name the two pistons of the first drawn cylinder that has two; none where none has."""
    cylinders: dict[str, list[str]] = {}
    for place in first_throw(machine):
        cylinders.setdefault(place.cylinder, []).append(place.name)
    return next((tuple(names) for names in cylinders.values() if len(names) == _PAIR), ())


_Names = tuple[str, str, str]
"""Results that are a motion's value and its two derivatives."""

_EXACT = ("piston_displacement", "piston_velocity_coefficient", "piston_acceleration_coefficient")
_TEXTBOOK = ("displacement_by_method", "velocity_coefficient_by_method", "acceleration_coefficient_by_method")
_ROCKER = ("rocker_angle", "rocker_velocity_coefficient", "rocker_acceleration_coefficient")


class _Row(NamedTuple):
    """A quantity of the pistons: title, symbol, unit, order of the derivative, factor to the unit."""

    title: str
    symbol: str
    unit: str
    order: int
    factor: float


def _piston_rows(turn: _Turn) -> tuple[_Row, ...]:
    """Travel, velocity and acceleration; without a speed by the crank angle."""
    titles = _row_titles(turn)
    has_speed = "piston_velocity" in turn.result.catalogue
    travel = _Row(titles[0], "s", "mm", 0, 1e3)
    if has_speed:
        return travel, _Row(titles[1], "v", "m/s", 1, 1.0), _Row(titles[2], "j", "m/s²", 2, 1.0)
    return travel, _Row(titles[1], "s'", "mm/rad", 1, 1e3), _Row(titles[2], "s''", "mm/rad²", 2, 1e3)


def _row_titles(turn: _Turn) -> tuple[str, str, str]:
    """Titles of travel, velocity and acceleration: of pistons, of valves, or of both."""
    names = drawn_names(turn.result, "piston")
    are_pistons = {place.kind.has_chambers for place in turn.result.machines[turn.design].places if place.name in names}
    if are_pistons == {False}:
        return _("Valve travel"), _("Valve velocity"), _("Valve acceleration")
    if False in are_pistons:
        return (
            _("Travel of piston and valve"),
            _("Velocity of piston and valve"),
            _("Acceleration of piston and valve"),
        )
    return _("Piston travel"), _("Piston velocity"), _("Piston acceleration")


def _opposed_panels(turn: _Turn, names: Sequence[str]) -> Iterator[Panel]:
    """Travel of both pistons of a cylinder and of both together, its volume, both velocities and accelerations."""
    labels = turn.result.labels
    travel, *rates = (
        Panel(
            row.title,
            row.symbol,
            row.unit,
            turn.angle,
            tuple(
                Curve(name, row.factor * turn.moved(row.order, _EXACT, labels["piston"].index(name)), habit, letter)
                for name, habit in zip(names, ("first", "other"), strict=True)
            ),
        )
        for letter, row in zip("svj", _piston_rows(turn), strict=True)
    )
    yield travel
    cylinder = next(p.cylinder for p in turn.result.machines[turn.design].places if p.name == names[0])
    both = shown(1.0, "mm") * turn.curve("combined_displacement", labels["cylinder"].index(cylinder))
    title = _("Travel of both together, cylinder {cylinder}").format(cylinder=cylinder)
    yield Panel(title, r"x_\Sigma", "mm", turn.angle, (Curve(cylinder, both, "first", "s"),))
    if "chamber_volume" in turn.result.catalogue and cylinder in labels.get("chamber", ()):
        volume = shown(1.0, "L") * turn.curve("chamber_volume", labels["chamber"].index(cylinder))
        yield Panel(_("Volume between them"), "V", "L", turn.angle, (Curve(cylinder, volume, "first", "T"),))
    yield from rates


def _piston_panels(turn: _Turn) -> Iterator[Panel]:
    """Travel, velocity, acceleration; and how far the textbook is off."""
    result = turn.result
    names = drawn_names(result, "piston")
    members = [result.labels["piston"].index(name) for name in names]
    worst = _worst(result, members, turn.design)
    told = _told(result, members, turn.design)
    for letter, row in zip("svj", _piston_rows(turn), strict=True):
        curves: list[Curve] = []
        for number, (name, member) in enumerate(zip(names, members, strict=True)):
            curves.append(
                Curve(name, row.factor * turn.moved(row.order, _EXACT, member), "other" if number else "first", letter)
            )
            method = _method(result, member, turn.design)
            if method is not None and member in told:
                textbook = row.factor * turn.moved(row.order, _TEXTBOOK, method, member)
                curves.append(Curve(name, textbook, "textbook", letter))
        yield Panel(row.title, row.symbol, row.unit, turn.angle, tuple(curves))
    if worst is not None:
        yield _error_panel(turn, *worst)


def _method(result: Result, member: int, design: int) -> int | None:
    """Find the textbook's form for a piston; None where no source has one."""
    places = {place.name: place for place in result.machines[design].places}
    form = _FORMS.get(places[result.labels["piston"][member]].kind.name)
    if form is None or "displacement_error" not in result.catalogue:
        return None
    method = result.labels["method"].index(form)
    errors = result.displacement_error[design] if result.has_designs else result.displacement_error
    return None if np.isnan(errors[method, member]) else method


def _worst(result: Result, members: Sequence[int], design: int) -> tuple[int, int] | None:
    """Find the form and piston with the largest error of acceleration."""
    pairs = [(method, member) for member in members if (method := _method(result, member, design)) is not None]
    if not pairs:
        return None
    errors = result.acceleration_error[design] if result.has_designs else result.acceleration_error
    return max(pairs, key=lambda pair: float(errors[pair]))


def _error_panel(turn: _Turn, method: int, member: int) -> Panel:
    """Error of a textbook's form in % of the stroke and of the exact peaks."""
    curves: list[Curve] = []
    for order, letter in enumerate("svj"):
        right = turn.moved(order, _EXACT, member)
        error = 100.0 * (turn.moved(order, _TEXTBOOK, method, member) - right) / np.nanmax(np.abs(right))
        curves.append(Curve(letter, error, "error", letter))
    title = _("Textbook error, piston {piston}").format(piston=turn.result.labels["piston"][member])
    return Panel(title, "", _("% of own maximum"), turn.angle, tuple(curves))


def _rocker_panels(turn: _Turn) -> Iterator[Panel]:
    """Rocker angle and its derivatives; torque factor where a load hangs on it."""
    result = turn.result
    names = drawn_names(result, "rocker")
    members = [result.labels["rocker"].index(name) for name in names]
    has_speed = result.machines[turn.design].main_shaft.speed is not None or result.get(SpeedCurve) is not None
    titles = _("Rocker angle"), _("Rocker angular velocity"), _("Rocker angular acceleration")
    symbols = (r"\theta", r"\omega_3", r"\varepsilon_3") if has_speed else (r"\theta", r"\theta'", r"\theta''")
    units = ("°", "rad/s", "rad/s²") if has_speed else ("°", "rad/rad", "rad/rad²")
    for order, (title, symbol, unit, letter) in enumerate(zip(titles, symbols, units, "svj", strict=True)):
        factor = 1.0 if order else shown(1.0, "deg")
        yield Panel(
            title,
            symbol,
            unit,
            turn.angle,
            tuple(
                Curve(name, factor * turn.moved(order, _ROCKER, member), "other" if number else "first", letter)
                for number, (name, member) in enumerate(zip(names, members, strict=True))
            ),
        )
    if "load_velocity_coefficient" in result.catalogue:
        curves = tuple(
            Curve(name, 1e3 * turn.curve("load_velocity_coefficient", member), "other" if number else "first", "T")
            for number, (name, member) in enumerate(zip(names, members, strict=True))
        )
        title = _("Torque factor: load velocity for each rad/s of the crank")
        yield Panel(title, r"x_Q'", "mm", turn.angle, curves)


def textbook_words(result: Result, design: int = 0) -> str:
    """Name the textbook's forms that stand beside the first throw's pistons; nothing where there are none."""
    if "piston" not in result.labels or opposed_names(result.machines[design]):
        return ""
    words = {"two_harmonics": _("two harmonics (333)–(337)"), "reconstructed": _("(I.13) reconstructed")}
    members = [result.labels["piston"].index(name) for name in drawn_names(result, "piston")]
    told = _told(result, members, design)
    methods = [method for member in sorted(told) if (method := _method(result, member, design)) is not None]
    forms = [words[result.labels["method"][method]] for method in dict.fromkeys(methods)]
    whose = [result.labels["piston"][member] for member in told] if len(members) > _FEW else []
    return ", ".join([*forms, *whose])


def _told(result: Result, members: Sequence[int], design: int) -> set[int]:
    """Pistons beside which the textbook's curve stands: of many, only the one that it misses most."""
    worst = _worst(result, members, design)
    return {member for member in members if len(members) <= _FEW or (worst is not None and member == worst[1])}


def marks(result: Result, design: int = 0) -> tuple[Mark, ...]:
    """Give the true dead centres of what is drawn, in its order; of opposed pistons the cylinders' volumetric ones."""

    def facts(name: str) -> Array:
        values = getattr(result, name)
        return values[design] if result.has_designs else values

    if opposed_names(result.machines[design]):
        drawn = dict.fromkeys(place.cylinder for place in first_throw(result.machines[design]))
        names = [name for name in drawn if name in result.labels["cylinder"]]
        both = (("inner_volumetric_dead_centre", True), ("outer_volumetric_dead_centre", False))
        return tuple(
            Mark(name, float(facts(quantity)[result.labels["cylinder"].index(name)]), is_top)
            for name in names
            for quantity, is_top in both
        )
    dimension, top, bottom = (
        ("piston", "top_dead_centre", "bottom_dead_centre")
        if "piston" in result.labels
        else ("rocker", "largest_rocker_angle_at", "smallest_rocker_angle_at")
    )
    every = (
        Mark(name, float(facts(quantity)[result.labels[dimension].index(name)]), is_top)
        for name in drawn_names(result, dimension)
        for quantity, is_top in ((top, True), (bottom, False))
    )
    return tuple(mark for mark in every if np.isfinite(mark.angle))


def draw_panels(page: Page, shown_panels: Sequence[Panel], box: tuple[float, float, float, float]) -> None:
    """Stack panels over one crank angle in a box: left, bottom, width, height. [mm]"""
    left, bottom, width, height = box
    foot, gap = 9.0, 7.0
    each = (height - foot - gap * len(shown_panels)) / len(shown_panels)
    for number, panel in enumerate(shown_panels):
        low = bottom + foot + (len(shown_panels) - 1 - number) * (each + gap)
        axes = page.axes(left, low, width, each)
        is_last = number == len(shown_panels) - 1
        _draw_panel(axes, panel, is_last=is_last)
        _head(page, panel, (left, left + width, low + each + 1.9))
    page.text(left + width / 2, bottom, _("Crank angle φ, °"), ha="center")


def _head(page: Page, panel: Panel, place: tuple[float, float, float]) -> None:
    """Name a panel over its left end, with symbol and unit; letters of its dashes at the right end."""
    left, right, y = place
    end = page.end(page.heading(left, y, panel.title))
    if panel.symbol:
        colour = COLOURS[panel.curves[0].letter]
        end = page.end(page.text(end + 1.5, y, formula(panel.symbol.replace("'", "′")), color=colour, fontsize=SYMBOL))
    page.text(end, y, f", {panel.unit}", fontsize=HEADING)
    for number, curve in enumerate(reversed([curve for curve in panel.curves if curve.habit == "error"])):
        end, colour = right - 15.0 * number, COLOURS[curve.letter]
        page.text(end, y, formula(curve.letter), ha="right", color=colour, fontsize=SYMBOL)
        page.sample(end - 10.5, end - 3.5, y + 0.9, color=colour, lw=1.1, dashes=DASHES[curve.letter])


def _draw_panel(axes: Axes, panel: Panel, *, is_last: bool) -> None:
    """Draw the curves of a panel: first thick, others thin with hollow rings, textbook dashed in ink."""
    if any(np.nanmin(curve.values) <= 0.0 <= np.nanmax(curve.values) for curve in panel.curves):
        axes.axhline(0.0, color=MUTED, linewidth=0.5, zorder=1)
    axes.grid(color=GRID, linewidth=0.5)
    axes.set_axisbelow(True)
    n_others = sum(curve.habit == "other" for curve in panel.curves)
    for curve in panel.curves:
        colour = COLOURS[curve.letter]
        if curve.habit == "first":
            axes.plot(panel.angle, curve.values, color=colour, linewidth=1.9, zorder=4)
        elif curve.habit == "other":
            axes.plot(panel.angle, curve.values, color=colour, linewidth=0.9 if n_others == 1 else 0.6, zorder=3)
            if n_others == 1:
                ring = np.arange(15.0, 360.0, 30.0)
                values = np.interp(ring, panel.angle, curve.values)
                axes.plot(ring, values, "o", ms=3.2, mfc="white", mec=colour, mew=0.8, zorder=3.5)
        elif curve.habit == "textbook":
            axes.plot(panel.angle, curve.values, color=INK, linewidth=0.6, dashes=TEXTBOOK_DASHES, zorder=5)
        else:
            _draw_error(axes, panel.angle, curve)
    axes.set(xlim=(0.0, 360.0), xticks=range(0, 361, 30))
    axes.margins(y=0.09)
    values = np.stack([curve.values for curve in panel.curves])
    if np.any(np.isnan(values)):
        _leave_open(axes, panel.angle, values)
    axes.tick_params(labelsize=TEXT, labelbottom=is_last, pad=2.0)
    axes.yaxis.set_major_locator(_ticks())
    axes.spines[["top", "right"]].set_visible(False)


def _leave_open(axes: Axes, angle: Array, values: Array) -> None:
    """Shade where the links cannot close, and take the scale from what is not the steep edge beside that."""
    open_there = np.any(np.isnan(values), axis=0)
    axes.fill_between(angle, 0.0, 1.0, where=open_there, transform=axes.get_xaxis_transform(), color=GRID, linewidth=0)
    low, high = np.nanpercentile(values, _MIDDLE)
    axes.set_ylim(low - 0.3 * (high - low), high + 0.3 * (high - low))


def _ticks() -> Any:
    """Few round ticks."""
    from matplotlib.ticker import MaxNLocator

    return MaxNLocator(nbins=4, steps=[1, 2, 5, 10], min_n_ticks=3)


def _draw_error(axes: Axes, angle: Array, curve: Curve) -> None:
    """Draw an error dashed, its letter at its largest value; each letter has dashes of its own, for grey prints."""
    colour = COLOURS[curve.letter]
    axes.plot(angle, curve.values, color=colour, linewidth=1.1, dashes=DASHES[curve.letter])
