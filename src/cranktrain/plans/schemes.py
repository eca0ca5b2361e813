"""Schemes of mechanisms with the letters of the sources' figures, as data."""

from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import N_, _
from cranktrain.layout.frames import in_machine_axes
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.mechanisms.drawing import Drawing
from cranktrain.motion import Array
from cranktrain.numerics.extremes import extremes
from cranktrain.plans.placement import frame, output_motion
from cranktrain.plans.positions import closed_angles
from cranktrain.plans.together import placed_together, places_called, together_name
from cranktrain.plans.vectors import angle_of, cross
from cranktrain.record import record


class MarkedAngle(NamedTuple):
    """An angle with its letter: at which point, from which direction to which [rad from X], its value as it counts."""

    letter: str
    words: str
    vertex: Array
    start: float
    end: float
    value: float


class MarkedLength(NamedTuple):
    """A length between two pins, with its letter. [m]"""

    letter: str
    words: str
    pins: tuple[str, str]
    value: float


class MarkedForce(NamedTuple):
    """A force at a pin, with its letter, its direction from X [rad], and its size in parts of Q."""

    letter: str
    words: str
    pin: str
    direction: float
    value: float


@record
class Scheme:
    """A mechanism at one crank angle with the letters of a source's figure.

    Attributes
    ----------
    mechanism, source, figure : str
        figure as the source numbers it.
    angle : float
        Crank angle as the machine shows it. [deg]
    drawing : Drawing
        Pins of shape (1,) in machine axes. [m]
    letters : mapping of pins to str
        The source's names.
    points : mapping of str to Array, shape (2,)
        Points that are no pins, by letter. [m]
    angles, lengths, forces : tuples
    thin : tuple of Array, shape (2, n)
        Lines that the marks need. [m]
    """

    mechanism: str
    source: str
    figure: str
    angle: float
    drawing: Drawing
    letters: Mapping[str, str]
    points: Mapping[str, Array]
    angles: tuple[MarkedAngle, ...]
    lengths: tuple[MarkedLength, ...]
    forces: tuple[MarkedForce, ...] = ()
    thin: tuple[Array, ...] = ()


class _Marks(NamedTuple):
    """What a figure marks; as the fields of `Scheme`."""

    letters: Mapping[str, str]
    angles: tuple[MarkedAngle, ...]
    lengths: tuple[MarkedLength, ...]
    points: Mapping[str, Array] = {}
    forces: tuple[MarkedForce, ...] = ()
    thin: tuple[Array, ...] = ()


class _View(NamedTuple):
    """A machine's places at one crank angle: pins by name in machine axes [m], φ [rad]."""

    machine: Machine
    places: tuple[PlacedMechanism, ...]
    pins: Mapping[str, Array]
    phi: float

    def along(self, place: PlacedMechanism, turn: float = 0.0) -> float:
        """Direction of a place's x, or of what is turned from it in its crank's sense, from X. [rad]"""
        axes = frame(self.machine, place)
        return float(np.arctan2(*in_machine_axes(np.cos(turn), np.sin(turn), axes)[::-1]))

    def turned(self, place: PlacedMechanism, direction: float, turn: float) -> float:
        """A direction turned on in the sense of a place's crank. [rad]"""
        return direction - frame(self.machine, place).sense * turn

    def angle(
        self, letter: str, words: str, at: str, place: PlacedMechanism, start: float, value: float
    ) -> MarkedAngle:
        """An angle that counts from a direction in the sense of a place's crank."""
        return MarkedAngle(letter, words, self.pins[at], start, self.turned(place, start, value), value)

    def between(self, place: PlacedMechanism, start: str, end: str) -> float:
        """Direction from a pin to another from a place's own x, in the sense of its crank, −π to π. [rad]"""
        turn = -frame(self.machine, place).sense * (angle_of(self.pins[end] - self.pins[start]) - self.along(place))
        return float((turn + np.pi) % (2 * np.pi) - np.pi)

    def length(self, letter: str, words: str, start: str, end: str) -> MarkedLength:
        """Length between two pins."""
        return MarkedLength(letter, words, (start, end), float(np.hypot(*(self.pins[end] - self.pins[start]))))


def scheme(
    machine: Machine, angle: float = 50.0, *, mechanism: str | None = None, letters: str | None = None
) -> Scheme:
    """A mechanism at one crank angle with the letters of a source's figure.

    Parameters
    ----------
    machine : Machine
    angle : float
        Crank angle as the machine shows it. [deg]
    mechanism : str, optional
        Its name; the first slave of throw 1, or the first mechanism, unless given. Of a cylinder with opposed pistons
        by its name or unnamed both.
    letters : str, optional
        The source: `steam-engine`, `bolotin` or `gandzha`; that which has the mechanism, unless given.

    Returns
    -------
    Scheme

    Raises
    ------
    InputError
        If no figure of the sources, or of this one, has such a mechanism.

    Examples
    --------
    >>> pump = Machine(mechanism={"kind": "slider_crank", "stroke": "160 mm", "rod_length": "160 mm"})
    >>> found = scheme(pump, 90.0)
    >>> found.figure, [(one.letter, round(float(np.rad2deg(one.value)), 6)) for one in found.angles]
    ('146', [('φ', 90.0), ('θ', 30.0)])
    """
    places = places_called(machine, mechanism)
    closed_angles(machine, places, [angle])
    first, *others = places
    sort = "opposed" if others else first.kind.name
    source, figure, marked = _figure(sort, letters, together_name(places))
    phi = float(np.deg2rad(angle) + machine.zero)
    drawing = placed_together(machine, places, np.array([phi]))
    pins = {name: pin[:, 0] for name, pin in drawing.positions.items()}
    marks = marked(_View(machine, places, pins, phi))
    return Scheme(together_name(places), source, figure, angle, drawing, **marks._asdict())


def _figure(sort: str, letters: str | None, name: str) -> "tuple[str, str, Callable[[_View], _Marks]]":
    """Find a source's figure of a sort of mechanism."""
    known = {figure[0] for figures in _FIGURES.values() for figure in figures}
    asked = None if letters is None else letters.strip().casefold()
    if asked is not None and asked not in known:
        allowed = _("must be one of: {sources}", sources=", ".join(sorted(known)))
        raise InputError([Problem("letters", letters, allowed)])
    found = [figure for figure in _FIGURES.get(sort, ()) if asked in (None, figure[0])]
    if not found:
        allowed = (
            _("no source has a figure of such a mechanism as {name}")
            if letters is None
            else _("has no figure of such a mechanism as {name}")
        )
        raise InputError([Problem("letters", letters, allowed.format(name=name))])
    return found[0]


def _slider_crank(view: _View) -> _Marks:
    """Fig. 146 of [steam-engine]."""
    (place,) = view.places
    along = view.along(place)
    rod = -view.between(place, "A", "B")
    angles = (
        view.angle("φ", N_("crank angle from the head-side dead centre"), "O", place, along, _turn(view, place)),
        MarkedAngle(
            "θ",
            N_("rod's angle to the line of stroke"),
            view.pins["B"],
            along + np.pi,
            view.turned(place, along + np.pi, -rod),
            rod,
        ),
    )
    lengths = (view.length("R", N_("crank"), "O", "A"), view.length("L", N_("rod"), "A", "B"))
    return _Marks({"O": "O", "A": "A", "B": "B"}, angles, lengths)


def _opposed(view: _View) -> _Marks:
    """Fig. 1.3 of [bolotin]: exhaust and scavenge piston (indices в and п), the exhaust crank ahead by Δ."""
    ends = {place.name.rpartition(".")[2]: place for place in view.places}
    turns = {end: _turn_from_inner(view, place) for end, place in ends.items()}
    lead = float((turns["exhaust"] - turns["scavenge"] + np.pi) % (2 * np.pi) - np.pi)
    on_one_shaft = len({place.shaft for place in view.places}) == 1
    letters: dict[str, str] = {}
    angles: list[MarkedAngle] = []
    lengths: list[MarkedLength] = []
    thin: list[Array] = []
    for i, (end, place) in enumerate(ends.items()):
        number, mark = (str(i + 1) if i else ""), _INDICES[end]
        letters |= {f"{pin}{number}": f"{pin}_{mark}" for pin in ("AB" if on_one_shaft else "OAB")}
        shaft, inner = f"O{number}", view.along(place, np.pi if place.is_far else 0.0)
        arm = float(np.hypot(*(view.pins[f"A{number}"] - view.pins[shaft])))
        if place.is_far:
            thin.append(np.stack([view.pins[shaft], view.pins[shaft] + 1.2 * arm * _unit(inner)], axis=1))
        if end == "exhaust":
            words = N_("exhaust crank from its inner dead centre")
            angles.append(view.angle("α", words, shaft, place, inner, turns[end]))
        else:
            words = N_("scavenge crank from its inner dead centre")
            angles.append(view.angle("α − Δ", words, shaft, place, inner, turns[end]))
            start = view.turned(place, inner, turns[end])
            angles.append(view.angle("Δ", N_("lead of the exhaust crank"), shaft, place, start, lead))
            tip = view.pins[shaft] + 1.2 * arm * _unit(view.turned(place, start, lead))
            thin.append(np.stack([view.pins[shaft], tip], axis=1))
        lengths.append(view.length(f"R_{mark}", _crank_words(end), shaft, f"A{number}"))
        lengths.append(view.length(f"L_{mark}", _rod_words(end), f"A{number}", f"B{number}"))
    if on_one_shaft:
        letters["O"] = "O"
    return _Marks(letters, tuple(angles), tuple(lengths), thin=tuple(thin))


_INDICES = {"exhaust": "в", "scavenge": "п"}
"""The text's own letters of the two pistons: выпускной, продувочный."""


def _crank_words(end: str) -> str:
    return N_("exhaust crank") if end == "exhaust" else N_("scavenge crank")


def _rod_words(end: str) -> str:
    return N_("exhaust rod") if end == "exhaust" else N_("scavenge rod")


def _articulated(view: _View) -> _Marks:
    """Fig. 1.4 of [bolotin]: the slave rod CB_l on the master rod AB."""
    (place,) = view.places
    geometry = place.geometry
    slave = view.along(place)
    master = view.turned(place, slave, -float(geometry.bank_angle))
    rod = angle_of(view.pins["B"] - view.pins["A"])
    beta = float(np.arcsin(geometry.master.crank_radius * np.sin(_turn(view, place)) / geometry.master.rod_length))
    bank, joint = float(geometry.bank_angle), float(geometry.articulation_angle)
    offset = joint - bank
    angles = (
        view.angle("γ", N_("bank angle"), "O", place, master, bank),
        view.angle("α", N_("crank angle from the master's top"), "O", place, master, _turn(view, place)),
        MarkedAngle("β", N_("master rod's angle to its cylinder"), view.pins["B"], master + np.pi, rod + np.pi, beta),
        view.angle("ζ", N_("angle of articulation"), "A", place, rod, joint),
        view.angle("ψ", N_("offset angle, ζ − γ"), "A", place, view.turned(place, rod, bank), offset),
    )
    lengths = (
        view.length("R", N_("crank"), "O", "A"),
        view.length("L", N_("master rod"), "A", "B"),
        view.length("r", N_("knuckle radius"), "A", "C"),
        view.length("l", N_("slave rod"), "C", "D"),
    )
    ray = view.pins["A"] + 1.4 * float(geometry.knuckle_radius) * _unit(view.turned(place, rod, bank))
    letters = {"O": "O", "A": "A", "B": "B", "C": "C", "D": "B_l"}
    return _Marks(letters, angles, lengths, thin=(np.stack([view.pins["A"], ray], axis=1),))


def _crank_rocker(view: _View) -> _Marks:
    """Fig. 1 of [gandzha]: crank OB, rod AB, rocker O₁A, the instant centre C of the rod."""
    (place,) = view.places
    along = view.along(place)
    alpha = _turn(view, place)
    beta, rocker = view.between(place, "A", "B"), view.between(place, "C", "B")
    ends = extremes(lambda at: output_motion(view.machine, place, at).value)
    swing = float(np.ravel(ends.largest.value - ends.smallest.value)[0])
    length = float(place.geometry.rocker_length)
    limits = [view.along(place, float(np.ravel(one.value)[0])) for one in (ends.smallest, ends.largest)]
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.sin(alpha - beta) / np.sin(rocker - beta)
        along_rod = float(1.0 / abs(np.sin(rocker - beta)))
    rod = angle_of(view.pins["B"] - view.pins["A"])
    push = rod + np.pi if np.sin(rocker - beta) > 0 else rod
    angles = (
        view.angle("α", N_("direction of the crank"), "O", place, along, alpha),
        view.angle("β", N_("direction of the rod"), "A", place, along, beta),
        view.angle("α_1", N_("direction of the rocker"), "C", place, along, rocker),
        view.angle("γ", N_("swing of the rocker"), "C", place, limits[0], swing),
    )
    forces = (
        MarkedForce(
            "Q",
            N_("tangential force at A"),
            "B",
            view.turned(place, angle_of(view.pins["B"] - view.pins["C"]), np.pi / 2),
            1.0,
        ),
        MarkedForce("Q'", N_("force along the rod, (2)"), "B", push, along_rod),
        MarkedForce(
            "T",
            N_("tangential force at B, (4)"),
            "A",
            view.turned(place, angle_of(view.pins["A"]), np.pi / 2 * np.sign(share)),
            float(abs(share)),
        ),
    )
    thin = [np.stack([view.pins["C"], view.pins["C"] + length * _unit(limit)], axis=1) for limit in limits]
    level = 0.35 * length * _unit(along)
    thin += [np.stack([view.pins[pin], view.pins[pin] + level], axis=1) for pin in "OAC"]
    centre = _crossing(view.pins["O"], view.pins["A"], view.pins["C"], view.pins["B"])
    points = {} if centre is None else {"C": centre}
    thin += [np.stack([view.pins[pin], centre], axis=1) for pin in ("A", "B") if centre is not None]
    lengths = (
        view.length("r", N_("crank"), "O", "A"),
        view.length("r_1", N_("rocker"), "C", "B"),
    )
    letters = {"O": "O", "A": "B", "B": "A", "C": "O_1"}
    return _Marks(letters, angles, lengths, points, forces, tuple(thin))


def _turn(view: _View, place: PlacedMechanism) -> float:
    """Angle of a place's crank, 0 to 2π. [rad]"""
    return float((view.phi + place.phase) % (2 * np.pi))


def _turn_from_inner(view: _View, place: PlacedMechanism) -> float:
    """Angle of a place's crank from its piston's inner dead centre, 0 to 2π. [rad]"""
    return float((view.phi - place.inner_dead_centre) % (2 * np.pi))


def _unit(direction: float) -> Array:
    return np.array([np.cos(direction), np.sin(direction)])


def _crossing(one: Array, through: Array, other: Array, by: Array) -> Array | None:
    """Where two lines meet, each through two points; None where that is too far to be drawn."""
    first, second = through - one, by - other
    turn = cross(first, second)
    far = float(np.hypot(*(other - one)))
    if abs(turn) < 1e-9 * far**2:
        return None
    found = one + cross(other - one, second) / turn * first
    return found if float(np.hypot(*found)) < _FAR * far else None


_FAR = 2.5
"""How many ground lengths from the shaft an instant centre is drawn."""

_FIGURES: "Mapping[str, tuple[tuple[str, str, Callable[[_View], _Marks]], ...]]" = {
    "slider_crank": (("steam-engine", "146", _slider_crank),),
    "opposed": (("bolotin", "1.3", _opposed),),
    "articulated_rod": (("bolotin", "1.4", _articulated),),
    "crank_rocker": (("gandzha", "1", _crank_rocker),),
}
"""Figures by the mechanism that they show: source, number, what it marks."""
