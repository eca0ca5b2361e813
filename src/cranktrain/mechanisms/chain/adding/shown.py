"""A chain as it is drawn, where parts are added to it by clicks: what was clicked there, and how numbers are typed."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import N_, Words, _
from cranktrain.mechanisms.by_hand import FINE, AddedTable, Clicked, Taken
from cranktrain.mechanisms.chain.groups import Made
from cranktrain.mechanisms.chain.kinematics import chain_made
from cranktrain.mechanisms.chain.parts import ChainTable, PartSpec
from cranktrain.mechanisms.chain.steps import ChainSize, Structure
from cranktrain.mechanisms.chain.table import chain_geometry, structure_of
from cranktrain.motion import Array, Link, Point
from cranktrain.numerics import turn_grid
from cranktrain.numerics.round_steps import decimals_of, round_below
from cranktrain.quantities import shown
from cranktrain.quantities.number import measured

_COARSE = turn_grid(72)
_NEAR = 4.0
"""Steps within which what is clicked beside a point or a line is meant to be on it: clicks miss by as much."""
_ROUND_DIRECTION, _NEAR_DIRECTION = 15.0, 3.0
"""Between directions one of which a guide or a slot has that is so near to it; else it has whole degrees. [deg]"""

ON_PIN: Mapping[Taken, str] = {"pin": N_("on {name}")}
"""What begins on a pin."""


class Typing(NamedTuple):
    """How lengths are typed: their unit, how much one of it is [m], and to which step in it."""

    unit: str
    size: float
    step: float

    def rounded(self, length: float) -> float:
        """Give a length as it is when it is typed. [m]"""
        return round(length / self.size / self.step) * self.step * self.size

    def text(self, length: float) -> str:
        """Type a length."""
        decimals = decimals_of(self.step)
        return f"{round(length / self.size / self.step) * self.step + 0.0:.{decimals}f} {self.unit}"

    def texts(self, place: Array) -> list[str]:
        """Type where something is."""
        return [self.text(float(one)) for one in place]

    def reaching(self, one: float, other: float, apart: float) -> tuple[float, float]:
        """Give the lengths of two links between pins so far apart such that they still meet when they are typed. [m]

        Where they lie nearly in line, the shorter one grows by as many steps as it takes.
        """
        long, short = sorted(map(self.rounded, (one, other)), reverse=True)
        lacks = max(apart - (long + short), (long - short) - apart)
        if lacks >= 0.0:
            short += (np.floor(lacks / self.size / self.step) + 1.0) * self.step * self.size
        return (long, short) if one >= other else (short, long)

    def is_small(self, length: float) -> bool:
        """Whether a length may be a click that missed."""
        return abs(length) < _NEAR * self.step * self.size

    def is_there(self, one: Array, other: Array) -> bool:
        """Whether two places may be meant to be one."""
        return self.is_small(distance(one, other))

    def beside(self, length: float) -> float:
        """Give how far something is beside a line, which may be meant to be on it. [m]"""
        return 0.0 if self.is_small(length) else self.rounded(length)


class ShownChain(NamedTuple):
    """A chain as it is drawn at a crank angle, and how its lengths are typed."""

    spec: ChainTable
    angle: float
    structure: Structure
    size: ChainSize
    made: Made
    typing: Typing

    def pin(self, clicked: Clicked) -> Array:
        """Where a pin is, shape (2,). [m]"""
        at = place_of(self._taken(clicked, Point))
        if not np.all(np.isfinite(at)):
            raise refusal(clicked, _("is nowhere at this crank angle, as links cannot close; turn the crank"))
        return at

    def place(self, clicked: Clicked) -> Array:
        """Where a click was, or the pin that it took, shape (2,). [m]"""
        return self.pin(clicked) if clicked.name else np.array([clicked.x, clicked.y])

    def on_link(self, name: str, place: Array) -> tuple[float, float]:
        """How far along a link from its first pin, and to the left of its line, a place is. [m]"""
        clicked = Clicked(name, *map(float, place))
        link = self._taken(clicked, Link)
        x, y = place - place_of(link.origin)
        cos, sin = float(np.ravel(link.cos)[0]), float(np.ravel(link.sin)[0])
        along, across = float(x * cos + y * sin), float(y * cos - x * sin)
        if not np.isfinite(along):
            raise refusal(clicked, _("is nowhere at this crank angle, as links cannot close; turn the crank"))
        return along, across

    def _taken(self, clicked: Clicked, sort: type[Any]) -> Any:
        """Find what a click took."""
        part = self.made.get(clicked.name)
        if not isinstance(part, sort):
            raise none_of(clicked, [name for name, one in self.made.items() if isinstance(one, sort)])
        return part

    def new(self, names: Iterable[str], besides: Iterable[str] = ()) -> str:
        """Give the first name that nothing has, not even what else is added; behind all of them one with a number."""
        taken = {*self.made, *self.spec.points, *self.spec.crank, *besides}
        given = tuple(names)
        numbered = (f"{given[0]}{number}" for number in range(2, len(taken) + 3))
        return next(name for name in (*given, *numbered) if name not in taken)

    def grown(self, part: PartSpec) -> tuple[Structure, ChainSize]:
        """Give the chain with one more part."""
        grown = self.spec.model_copy(update={"part": (*self.spec.part, part)})
        return structure_of(grown), chain_geometry(grown, None)


def shown_chain(spec: ChainTable, angle: float) -> ShownChain:
    """Draw a chain at a crank angle."""
    structure, size = structure_of(spec), chain_geometry(spec, None)
    with np.errstate(all="ignore"):
        turn = chain_made(structure, _COARSE, size)
        made = chain_made(structure, np.array([angle]), size)
    pins = [np.stack(np.broadcast_arrays(one.x.value, one.y.value)) for one in turn.values() if isinstance(one, Point)]
    reach = max(float(np.nanmax(np.hypot(*pin), initial=0.0)) for pin in pins)
    typed = measured(next(iter(spec.crank.values())).radius.text)
    unit = typed.unit if typed is not None else "mm"
    size_of_unit = 1.0 / float(shown(1.0, unit))
    return ShownChain(
        spec, angle, structure, size, made, Typing(unit, size_of_unit, round_below(reach / size_of_unit / FINE))
    )


def to_chain(
    added: Callable[[ShownChain, Sequence[Clicked]], AddedTable],
) -> Callable[[ChainTable, Sequence[Clicked], float], AddedTable]:
    """Give what adds a part to the chain of a table."""
    return lambda spec, clicks, angle: added(shown_chain(spec, angle), clicks)


def item(**keys: Any) -> AddedTable:
    """Give one more part of a chain."""
    return AddedTable("part", keys, is_item=True)


def link_from(shown: ShownChain, name: str, start: Clicked, length: float) -> Mapping[str, str]:
    """Give the keys of a link from a pin."""
    return {"name": name, "from": start.name, "length": shown.typing.text(length)}


def place_of(point: Point) -> Array:
    """Where a point is at the one angle, shape (2,). [m]"""
    return np.array([np.ravel(point.x.value)[0], np.ravel(point.y.value)[0]])


def distance(one: Array, other: Array) -> float:
    """How far two places are apart. [m]"""
    return float(np.hypot(*(one - other)))


def round_direction(degrees: float) -> float:
    """Give a direction as it is typed. [deg]"""
    near = round(degrees / _ROUND_DIRECTION) * _ROUND_DIRECTION
    return near if abs(degrees - near) < _NEAR_DIRECTION else float(round(degrees))


def degrees_text(degrees: float) -> str:
    """Type whole degrees."""
    return f"{degrees + 0.0:.0f} deg"


def none_of(clicked: Clicked, names: Iterable[str]) -> InputError:
    """Say what a click may take."""
    return refusal(clicked, _("must be one of: {names}", names=", ".join(names) or "–"))


def refusal(clicked: Clicked, allowed: Words) -> InputError:
    """Say what is wrong with what was clicked."""
    return InputError([Problem("addition", clicked.name or None, allowed)])


def refused(why: Words) -> InputError:
    """Say what is wrong with what was clicked on the ground, or with all clicks."""
    return InputError([Problem("addition", None, why)])
