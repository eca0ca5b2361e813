"""Curves of motion over one turn: of pistons with what the textbook says, of opposed pistons, of a rocker."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis import Result
from cranktrain.grouping import grouped
from cranktrain.language import Words, _
from cranktrain.layout.speed import SpeedCurve, rates
from cranktrain.linkage.forces import Drive
from cranktrain.machine import Machine
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics.ties import largest_of
from cranktrain.panels.design import OneDesign
from cranktrain.panels.shapes import Curve, Panel, Role
from cranktrain.plans.drawn_throws import drawn_places
from cranktrain.plans.placement import name_of_output, output_of
from cranktrain.plans.turning import turning

_LETTERS = "svj"
"""Of travel, velocity and acceleration."""

_FORMS = {"slider_crank": "two_harmonics", "articulated_rod": "reconstructed"}
"""Which of the textbook's forms stands beside each kind."""

_PAIR = 2
FEW = 2
"""Up to so many pistons, each has the textbook's curve beside its own."""

_MOTIONS = {
    "piston": ("piston_displacement", "piston_velocity_coefficient", "piston_acceleration_coefficient"),
    "textbook": ("displacement_by_method", "velocity_coefficient_by_method", "acceleration_coefficient_by_method"),
    "rocker": ("rocker_angle", "rocker_velocity_coefficient", "rocker_acceleration_coefficient"),
}
"""Results that are a motion's value and its two derivatives."""

_UNITS = {
    ("piston", True): (("s", "m"), ("v", "m/s"), ("j", "m/s^2")),
    ("piston", False): (("s", "m"), ("s'", "m/rad"), ("s''", "m/rad^2")),
    ("rocker", True): ((r"\theta", "rad"), (r"\omega_3", "rad/s"), (r"\varepsilon_3", "rad/s^2")),
    ("rocker", False): ((r"\theta", "rad"), (r"\theta'", "rad/rad"), (r"\theta''", "rad/rad^2")),
}
"""Symbol and unit of a motion and its derivatives, with and without a speed."""


class _Turn(NamedTuple):
    """One turn of a result: which points of its grid, and the angles, closed at 360. [deg]"""

    shown: OneDesign
    points: NDArray[np.intp]
    angle: Array

    def curve(self, name: str, *at: int) -> Array:
        """Give a quantity of a member over the turn; an angle that goes round goes on at the end."""
        whole = self.shown(name)[at][self.points]
        if self.shown.result.catalogue[name].unit == "rad":
            whole[-1] += 2 * np.pi * np.rint((whole[-2] - whole[-1]) / (2 * np.pi))
        return whole

    @property
    def drive(self) -> Drive:
        """How the crank turns at each angle; by 1 rad/s where the machine has no speed."""
        result, design, _mechanism = self.shown
        phi = np.deg2rad(self.angle) + result.grid.zero[design, 0, 0]
        return turning(result.machines[design], result.get(SpeedCurve), phi, design)

    def motion(self, whose: str, *at: int) -> Array:
        """Travel, velocity and acceleration of a member, by its motion's value and two derivatives, shape (3, n)."""
        motion = Coefficient(*(self.curve(name, *at) for name in _MOTIONS[whose]))
        return np.stack([motion.value, *rates(motion, self.drive)])


def panels(result: Result, design: int = 0, mechanism: str | None = None) -> tuple[Panel, ...]:
    """Collect the curves that a sheet shows.

    Parameters
    ----------
    result : Result
    design : int
    mechanism : str, optional
        Whose throw alone is meant; unless given, one of each sort.

    Returns
    -------
    tuple of Panel
        Travel, velocity, acceleration of the drawn throws' pistons and the textbook's error; of opposed pistons those
        of the first cylinder, with what both do together; or angle and derivatives of the rocker.
    """
    within = np.flatnonzero(result.crank_angle < 360.0)
    index = np.append(within, within.size % result.crank_angle.size)
    turn = _Turn(OneDesign(result, design, mechanism), index, np.append(result.crank_angle[within], 360.0))
    pair = opposed_names(result.machines[design], mechanism)
    if pair:
        return tuple(_opposed_panels(turn, pair))
    return tuple(_panels_of(turn, "piston" if "piston" in result.labels else "rocker"))


def drawn_names(shown: OneDesign, dimension: str) -> tuple[str, ...]:
    """Name the pistons or rockers of the drawn throws."""
    names = [place.name for place in drawn_places(shown.result.machines[shown.design], shown.mechanism)]
    return tuple(name for name in shown.result.labels.get(dimension, ()) if name in names)


def opposed_names(machine: Machine, mechanism: str | None = None) -> tuple[str, ...]:
    """Name the two pistons of the first drawn cylinder that has two; none where none has."""
    cylinders = grouped((place.cylinder, place.name) for place in drawn_places(machine, mechanism))
    return next((tuple(names) for names in cylinders.values() if len(names) == _PAIR), ())


def drawn_forms(shown: OneDesign) -> dict[str, int]:
    """Pistons beside which the textbook's curve stands, with its form: of many only the one that it misses most."""
    forms = _forms(shown)
    chosen = forms if len(drawn_names(shown, "piston")) <= FEW else [_worst(shown, forms)]
    return {name: form for name, form in forms.items() if name in chosen}


def _forms(shown: OneDesign) -> dict[str, int]:
    """Drawn pistons for which a source has a form, and the number of that."""
    if not shown.has("displacement_error"):
        return {}
    kinds = {place.name: place.kind.name for place in shown.result.machines[shown.design].places}
    forms = {
        name: shown.member("motion_method", _FORMS[kinds[name]])
        for name in drawn_names(shown, "piston")
        if kinds[name] in _FORMS
    }
    errors = shown("displacement_error")
    return {name: form for name, form in forms.items() if not np.isnan(errors[form, shown.member("piston", name)])}


def _worst(shown: OneDesign, forms: dict[str, int]) -> str | None:
    """Find the piston with the largest error of acceleration."""
    if not forms:
        return None
    errors = shown("acceleration_error")
    return largest_of(forms, lambda name: float(errors[forms[name], shown.member("piston", name)]))


def _roles(names: Sequence[str]) -> Iterator[Role]:
    """The first one, and a second or many others."""
    for number in range(len(names)):
        yield "first" if number == 0 else "second" if len(names) == _PAIR else "other"


def _motion_panels(
    turn: _Turn, dimension: str, names: Sequence[str], given: Mapping[str, int] | None = None
) -> Iterator[Panel]:
    """Travel, velocity and acceleration of pistons or rockers, with the textbook's; without a speed by crank angle."""
    forms = given or {}
    motions = [turn.motion(dimension, turn.shown.member(dimension, name)) for name in names]
    motions += [turn.motion("textbook", form, turn.shown.member("piston", name)) for name, form in forms.items()]
    roles: list[Role] = [*_roles(names), *("textbook" for _form in forms)]
    result, design, _mechanism = turn.shown
    has_speed = result.machines[design].main_shaft.speed is not None or result.get(SpeedCurve) is not None
    titles = _titles(turn.shown, dimension)
    for order, (symbol, unit) in enumerate(_UNITS[dimension, has_speed]):
        curves = (
            Curve(motion[order], role, _LETTERS[order], name=name)
            for name, role, motion in zip((*names, *forms), roles, motions, strict=True)
        )
        yield Panel(titles[order], unit, turn.angle, tuple(curves), symbol)


def _titles(shown: OneDesign, dimension: str) -> tuple[Words, Words, Words]:
    """Titles of travel, velocity and acceleration: of rockers, of pistons, of valves, or of pistons and valves."""
    if dimension == "rocker":
        return _("Rocker angle"), _("Rocker angular velocity"), _("Rocker angular acceleration")
    result, design, _mechanism = shown
    names = drawn_names(shown, "piston")
    machine = result.machines[design]
    drawn = (output_of(machine, place).words for place in machine.places if place.name in names)
    titles = {words.titles for words in drawn if words is not None}
    if len(titles) == 1:
        ((travel, velocity, acceleration),) = titles
        return _(travel), _(velocity), _(acceleration)
    return _("Travel of piston and valve"), _("Velocity of piston and valve"), _("Acceleration of piston and valve")


def _opposed_panels(turn: _Turn, names: Sequence[str]) -> Iterator[Panel]:
    """Travel of both pistons of a cylinder and of both together, its volume, both velocities and accelerations."""
    result, design, _mechanism = turn.shown
    travel, *rates = _motion_panels(turn, "piston", names)
    yield travel
    cylinder = next(p.cylinder for p in result.machines[design].places if p.name == names[0])
    both = turn.curve("combined_displacement", turn.shown.member("cylinder", cylinder))
    title = _("Travel of both together, cylinder {cylinder}", cylinder=cylinder)
    yield Panel(title, "m", turn.angle, (Curve(both, "first", "s", name=cylinder),), r"x_\Sigma")
    if turn.shown.has("chamber_volume") and cylinder in result.labels.get("chamber", ()):
        volume = turn.curve("chamber_volume", turn.shown.member("chamber", cylinder))
        yield Panel(_("Volume between them"), "m^3", turn.angle, (Curve(volume, "first", "T", name=cylinder),), "V")
    yield from rates


def _panels_of(turn: _Turn, dimension: str) -> Iterator[Panel]:
    """Travel, velocity and acceleration, with what the textbook says; the torque factor of rockers under a load."""
    names = drawn_names(turn.shown, dimension)
    forms = drawn_forms(turn.shown)
    yield from _motion_panels(turn, dimension, names, forms)
    worst = _worst(turn.shown, forms)
    if worst is not None:
        yield _error_panel(turn, worst, forms[worst])
    if dimension == "rocker" and turn.shown.has("load_velocity_coefficient"):
        yield _load_panel(turn, names)


def _error_panel(turn: _Turn, piston: str, form: int) -> Panel:
    """Error of a textbook's form in % of the stroke and of the exact peaks."""
    member = turn.shown.member("piston", piston)
    exact = turn.motion("piston", member)
    peaks = np.nanmax(np.abs(exact), axis=1, keepdims=True)
    errors = 100.0 * (turn.motion("textbook", form, member) - exact) / peaks
    curves = tuple(Curve(error, "error", letter, letter) for error, letter in zip(errors, _LETTERS, strict=True))
    machine = turn.shown.result.machines[turn.shown.design]
    place = next(place for place in machine.places if place.name == piston)
    title = _("Textbook error, {piston}", piston=name_of_output(machine, place))
    return Panel(title, _("% of own maximum"), turn.angle, curves)


def _load_panel(turn: _Turn, names: Sequence[str]) -> Panel:
    """Torque factor of rockers on which a load hangs."""
    values = (turn.curve("load_velocity_coefficient", turn.shown.member("rocker", name)) for name in names)
    curves = (Curve(one, role, "T", name=name) for one, role, name in zip(values, _roles(names), names, strict=True))
    title = _("Torque factor: load velocity for each rad/s of the crank")
    return Panel(title, "m", turn.angle, tuple(curves), "x_Q'")
