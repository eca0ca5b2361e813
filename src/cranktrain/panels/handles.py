"""Handles on a machine's drawing as data: how far a pin goes for a change of the numbers that say where it is."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import takewhile
from typing import Any, NamedTuple, cast

import numpy as np

from cranktrain.layout.frames import in_machine_axes
from cranktrain.layout.places import PlacedMechanism, with_table
from cranktrain.machine import Machine
from cranktrain.mechanisms.by_hand import FINE, Handle
from cranktrain.motion import Array
from cranktrain.numerics.round_steps import round_below
from cranktrain.panels.members import are_one
from cranktrain.paths import PathParts, parts_of, path_text
from cranktrain.plans.link_points import followed_pin
from cranktrain.plans.placement import frame, placed, shaft_places
from cranktrain.quantities import Given, shown
from cranktrain.quantities.number import measured
from cranktrain.record import record
from cranktrain.spec import Spec

HANDLE_STEP = 3.0
"""Between crank angles at which slopes are known. [deg]"""

_ANGLES = np.arange(0.0, 360.0 + HANDLE_STEP / 2, HANDLE_STEP)
_MOST = 2
"""Numbers that one pin changes: it has two coordinates."""
_CHANGE = 1e-6
"""Of a number, by which its slope is found, in parts of it or of 1."""
_FIGURES = 50.0
"""So many steps of a number, or some more, are the number itself."""


@record
class HandledNumber:
    """A number that a handle changes.

    Attributes
    ----------
    paths : tuple of str
        Where it stands in the file; several mechanisms on one pin have it in common.
    number : float
        As it is typed.
    unit : str
        What is typed behind it.
    step : float
        To which it is rounded, in its unit.
    slope : Array, shape (2, n)
        How far the pin goes for one of its unit, X and Y, at crank angles that stand evenly from 0 to a whole turn,
        both included; NaN where the links cannot close. [m]
    """

    paths: tuple[str, ...]
    number: float
    unit: str
    step: float
    slope: Array


@record
class DrawnHandle:
    """A pin that may be moved, and the one or two numbers that this changes.

    Attributes
    ----------
    mechanism, pin : str
    numbers : tuple of HandledNumber
    at : Array, shape (2,), or None
        Where it stands, X and Y; None of a pin of the drawing. [m]
    slides : str
        Pin of the drawing that slides in the guide on which it stands.
    """

    mechanism: str
    pin: str
    numbers: tuple[HandledNumber, ...]
    at: Array | None
    slides: str


class _Held(NamedTuple):
    """A pin of a mechanism, where it is over the turn, and what is typed of it, by path."""

    place: PlacedMechanism
    handle: Handle
    at: Array
    typed: Mapping[str, Given]


def drawn_handles(
    machine: Machine, places: Sequence[PlacedMechanism], declared: Sequence[str]
) -> tuple[DrawnHandle, ...]:
    """Give the handles of what is drawn.

    Parameters
    ----------
    machine : Machine
    places : sequence of PlacedMechanism
    declared : sequence of str
        Paths of the numbers that the file has; others are changed by no handle.

    Returns
    -------
    tuple of DrawnHandle
        Where mechanisms have a pin in common, and the same numbers of it, one for all of them.
    """
    held = [one for place in places for one in _held(machine, place, declared)]
    # One that reaches much farther than all else is drawn shorter.
    size = min((_size(place, held) for place in places), default=0.0)
    found: list[DrawnHandle] = []
    taken: list[_Held] = []
    for one in held:
        if any(_is_same(one, other) for other in taken):
            continue
        taken.append(one)
        others = [other for other in held if _is_same(one, other)]
        numbers = tuple(_numbers(machine, one, others, size))
        if numbers:
            found.append(_drawn(machine, one, numbers))
    return tuple(found)


def _drawn(machine: Machine, one: _Held, numbers: tuple[HandledNumber, ...]) -> DrawnHandle:
    """Give a handle as it stands on the drawing."""
    at = None if one.handle.at is None else one.at[:, 0] + shaft_places(machine).centres[one.place.shaft]
    return DrawnHandle(one.place.name, one.handle.pin, numbers, at, one.handle.slides)


def _held(machine: Machine, place: PlacedMechanism, declared: Sequence[str]) -> Iterator[_Held]:
    """Give the pins of a mechanism of whose numbers the file has some."""
    if not (place.kind.handles or place.spec.points):
        return
    positions = placed(machine, place, _angles(machine)).positions
    followed = (Handle(followed_pin(name, positions), _point_numbers(name)) for name in place.spec.points)
    # Where one is on another pin, the pin's handle lies above it.
    for handle in (*followed, *place.kind.handles):
        known = ((path, number_at(place.spec, parts_of(path))) for path in handle.numbers)
        typed = {path: given for path, given in known if given is not None and _in_file(place, path) in declared}
        at = positions.get(handle.pin) if handle.at is None else _at(machine, place, handle)
        if typed and at is not None:
            yield _Held(place, handle, at, dict(list(typed.items())[:_MOST]))


def _at(machine: Machine, place: PlacedMechanism, handle: Handle) -> Array:
    """Where a pin, or what else is held, is over the turn, from its shaft, shape (2, n). [m]"""
    if handle.at is None:
        return placed(machine, place, _angles(machine)).positions[handle.pin]
    with np.errstate(all="ignore"):  # what cannot close is NaN
        x, y = (np.ravel(part) + np.zeros(_ANGLES.size) for part in handle.at(place.geometry))
    return np.stack(in_machine_axes(x, y, frame(machine, place)))


def _point_numbers(name: str) -> tuple[str, ...]:
    """Numbers that say where on its link a followed point is."""
    return tuple(path_text(("points", name, number)) for number in ("along", "across"))


def _size(place: PlacedMechanism, held: Sequence[_Held]) -> float:
    """How far pins of a mechanism that may be moved come from the main shaft; infinite where there are none. [m]"""
    reach = [float(np.nanmax(np.abs(one.at), initial=0.0)) for one in held if one.place is place]
    return max(reach, default=np.inf) or np.inf


def _angles(machine: Machine) -> Array:
    """Crank angles φ of a turn. [rad]"""
    return np.ravel(np.deg2rad(_ANGLES) + machine.zero)


def _in_file(place: PlacedMechanism, path: str) -> str:
    """Path of a number in the machine file."""
    first = "".join(takewhile(lambda letter: letter not in ".[", path))
    return place.path_of(first) + path.removeprefix(first)


def _is_same(one: _Held, other: _Held) -> bool:
    """Whether two pins are one, and what is typed of them is alike."""
    alike = {path: given.text for path, given in one.typed.items()} == {
        path: given.text for path, given in other.typed.items()
    }
    return alike and are_one(one.at, other.at)


def _numbers(machine: Machine, one: _Held, others: Sequence[_Held], size: float) -> Iterator[HandledNumber]:
    """Give the numbers of a pin that move it."""
    for path, given in one.typed.items():
        typed = measured(given.text)
        slope = _slope(machine, one, path, given)
        per_unit = 1.0 if typed is None or not typed.unit else 1.0 / float(shown(1.0, typed.unit))
        most = float(np.nanmax(np.hypot(*slope), initial=0.0)) * per_unit
        if typed is not None and most > 0.0:
            number = float(typed.number)
            yield HandledNumber(
                paths=tuple(dict.fromkeys(_in_file(other.place, path) for other in others)),
                number=number,
                unit=typed.unit,
                step=round_below(min(size / (FINE * most), abs(number) / _FIGURES or np.inf)),
                slope=slope * per_unit,
            )


def _slope(machine: Machine, one: _Held, path: str, given: Given) -> Array:
    """Give how far a pin goes for a change of a number, by differences to both sides, shape (2, n)."""
    change = _CHANGE * (abs(given.si) or 1.0)
    beside = [place for place in machine.places if (place.shaft, place.throw) == (one.place.shaft, one.place.throw)]

    def at(si: float) -> Array:
        spec = with_number(one.place.spec, parts_of(path), replace(given, si=si))
        return _at(machine, with_table(one.place, spec, beside), one.handle)

    return (at(given.si + change) - at(given.si - change)) / (2 * change)


def number_at(table: object, parts: PathParts) -> Given | None:
    """Give a number of a table that is written in it; None where there is none, or it is a default."""
    for part in parts:
        if isinstance(table, Spec):
            table = getattr(table, str(part)) if part in table.model_fields_set else None
        elif isinstance(table, Mapping):
            table = cast("Mapping[object, object]", table).get(part)
        else:
            table = cast("Sequence[object]", table)[cast(int, part)] if table is not None else None
    return table if isinstance(table, Given) else None


def with_number(table: Any, parts: PathParts, given: Given) -> Any:
    """Give a table with another number at a path that it has; nothing is checked."""
    if not parts:
        return given
    first, *rest = parts
    if isinstance(table, Spec):
        return table.model_copy(update={str(first): with_number(getattr(table, str(first)), tuple(rest), given)})
    if isinstance(table, Mapping):
        own = cast("Mapping[object, Any]", table)
        return {**own, first: with_number(own[first], tuple(rest), given)}
    items = list(cast("Sequence[Any]", table))
    items[cast(int, first)] = with_number(items[cast(int, first)], tuple(rest), given)
    return tuple(items)
