"""Parts that are added to a chain by clicks on its drawing: a followed point, a pin, two links, a link and a slider."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import N_, Words, _
from cranktrain.mechanisms.by_hand import FINE, AddedTable, Addition, Click, Clicked, Taken
from cranktrain.mechanisms.chain.groups import SHAFT, Made
from cranktrain.mechanisms.chain.kinematics import chain_made
from cranktrain.mechanisms.chain.parts import ChainTable, PinPartSpec
from cranktrain.mechanisms.chain.steps import PinStep
from cranktrain.mechanisms.chain.table import chain_geometry, structure_of
from cranktrain.motion import Array, Link, Point
from cranktrain.numerics import turn_grid
from cranktrain.numerics.round_steps import decimals_of, round_below
from cranktrain.numerics.ties import smallest_of
from cranktrain.quantities import shown
from cranktrain.quantities.number import measured

_COARSE = turn_grid(72)
_NEAR = 4.0
"""Steps within which a guide beside a fixed point goes through it: clicks miss by as much."""
_ROUND_DIRECTION, _NEAR_DIRECTION = 15.0, 3.0
"""Between directions one of which a guide has that is so near to it; else it has one of whole degrees. [deg]"""
_FIXED = ("C", "D", "E", "F")
"""Names of fixed points."""


class _Typing(NamedTuple):
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


class _Shown(NamedTuple):
    """A chain as it is drawn at a crank angle, and how its lengths are typed."""

    spec: ChainTable
    angle: float
    made: Made
    typing: _Typing

    def pin(self, clicked: Clicked) -> Array:
        """Where a pin is. [m]"""
        at = _place(self._taken(clicked, Point))
        if not np.all(np.isfinite(at)):
            raise _refusal(clicked, _("is nowhere at this crank angle, as links cannot close; turn the crank"))
        return at

    def on_link(self, clicked: Clicked) -> tuple[float, float]:
        """How far along a link from its first pin, and to the left of its line, a click is. [m]"""
        link = self._taken(clicked, Link)
        x, y = np.array([clicked.x, clicked.y]) - _place(link.origin)
        cos, sin = float(np.ravel(link.cos)[0]), float(np.ravel(link.sin)[0])
        along, across = float(x * cos + y * sin), float(y * cos - x * sin)
        if not np.isfinite(along):
            raise _refusal(clicked, _("is nowhere at this crank angle, as links cannot close; turn the crank"))
        return along, across

    def _taken(self, clicked: Clicked, sort: type[Any]) -> Any:
        """Find what a click took."""
        part = self.made.get(clicked.name)
        if not isinstance(part, sort):
            names = [name for name, one in self.made.items() if isinstance(one, sort)]
            raise _refusal(clicked, _("must be one of: {names}", names=", ".join(names)))
        return part

    def new(self, names: Iterable[str]) -> str:
        """Give the first name that nothing has; behind all of them the first with a number."""
        taken = {*self.made, *self.spec.points, *self.spec.crank}
        given = tuple(names)
        numbered = (f"{given[0]}{number}" for number in range(2, len(taken) + 3))
        return next(name for name in (*given, *numbered) if name not in taken)


def _shown(spec: ChainTable, angle: float) -> _Shown:
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
    return _Shown(spec, angle, made, _Typing(unit, size_of_unit, round_below(reach / size_of_unit / FINE)))


def _place(point: Point) -> Array:
    """Where a point is at the one angle, shape (2,). [m]"""
    return np.array([np.ravel(point.x.value)[0], np.ravel(point.y.value)[0]])


def _refusal(clicked: Clicked, allowed: Words) -> InputError:
    """Say what is wrong with what was clicked."""
    return InputError([Problem("addition", clicked.name or None, allowed)])


def _followed(shown: _Shown, clicks: Sequence[Clicked]) -> AddedTable:
    """A point on a link that is followed."""
    return AddedTable(f"points.{shown.new('GHKLM')}", _point_on(shown, clicks[0]))


def _pin(shown: _Shown, clicks: Sequence[Clicked]) -> AddedTable:
    """A pin on a link, or a fixed point."""
    (clicked,) = clicks
    if clicked.name:
        return AddedTable("part", {"type": "point", "name": shown.new("P"), **_point_on(shown, clicked)}, is_item=True)
    return AddedTable("fixed", {shown.new(_FIXED): [shown.typing.text(clicked.x), shown.typing.text(clicked.y)]})


def _point_on(shown: _Shown, clicked: Clicked) -> Mapping[str, str]:
    """Keys that say where on a link a point is."""
    along, across = shown.on_link(clicked)
    return {"link": clicked.name, "along": shown.typing.text(along), "across": shown.typing.text(across)}


def _pair(shown: _Shown, clicks: Sequence[Clicked]) -> AddedTable:
    """Two links that meet in a joint."""
    first, joint, last = clicks
    start, end, at = shown.pin(first), shown.pin(last), np.array([joint.x, joint.y])
    if first.name == last.name:
        raise _refusal(last, _("is where the first link begins; take another pin"))
    for pin, clicked in ((start, first), (end, last)):
        if shown.typing.is_small(float(np.hypot(*(at - pin)))):
            raise _refusal(clicked, _("is where both links would meet; let them meet elsewhere"))
    (x, y), (across, up) = end - start, at - start
    to_joint, from_joint = (float(np.hypot(*(at - pin))) for pin in (start, end))
    rod, rocker = shown.typing.reaching(to_joint, from_joint, float(np.hypot(x, y)))
    part: dict[str, Any] = {
        "type": "pin",
        "rod": _link(shown, "rod", first, rod),
        "rocker": _link(shown, "rocker", last, rocker),
        "joint": shown.new("B"),
        "side": "left" if x * up - y * across > 0.0 else "right",
    }
    crossed = {**part, "crossed": True}
    step, plain = _joint(shown, part)
    if step.form and np.hypot(*(_joint(shown, crossed)[1] - at)) < np.hypot(*(plain - at)):
        part = crossed
    return AddedTable("part", part, is_item=True)


def _link(shown: _Shown, name: str, start: Clicked, length: float) -> Mapping[str, str]:
    """A link of a new name from a pin."""
    return {"name": shown.new([name]), "from": start.name, "length": shown.typing.text(length)}


def _joint(shown: _Shown, part: Mapping[str, Any]) -> tuple[PinStep, Array]:
    """Put two links on the chain: how they pass change points, and where their joint is."""
    grown = shown.spec.model_copy(update={"part": (*shown.spec.part, PinPartSpec.model_validate(part))})
    structure = structure_of(grown)
    with np.errstate(all="ignore"):
        made = chain_made(structure, np.array([shown.angle]), chain_geometry(grown, None))
    step = structure.steps[-1]
    assert isinstance(step, PinStep)
    return step, _place(made[step.joint])


def _slide(shown: _Shown, clicks: Sequence[Clicked]) -> AddedTable:
    """A link with a slider on a fixed guide."""
    first, slider, toward = clicks
    start, at = shown.pin(first), np.array([slider.x, slider.y])
    if shown.typing.is_small(float(np.hypot(*(at - start)))):
        raise _refusal(first, _("is where the slider would be, on a link of no length; put it elsewhere"))
    way = np.array([toward.x, toward.y]) - at
    if shown.typing.is_small(float(np.hypot(*way))):
        raise _refusal(toward, _("the third click says no direction, so near to the slider's pin"))
    degrees = _round_direction(float(np.degrees(np.arctan2(way[1], way[0]))))
    along = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
    across = np.array([-along[1], along[0]])
    offset, through = _beside_fixed(shown, at, across)
    # The slider's pin as it is with the guide as it is typed.
    at = along * (along @ at) + across * (across @ _place(shown.made[through]) + shown.typing.rounded(offset))
    return AddedTable(
        "part",
        {
            "type": "slide",
            "rod": _link(shown, "rod", first, np.hypot(*(at - start))),
            "slider": shown.new(["slider"]),
            "guide": {"through": through, "direction": f"{degrees + 0.0:.0f} deg", "offset": shown.typing.text(offset)},
            "side": "ahead" if along @ (at - start) >= 0.0 else "behind",
        },
        is_item=True,
    )


def _round_direction(degrees: float) -> float:
    """Give a direction as it is typed. [deg]"""
    near = round(degrees / _ROUND_DIRECTION) * _ROUND_DIRECTION
    return near if abs(degrees - near) < _NEAR_DIRECTION else float(round(degrees))


def _beside_fixed(shown: _Shown, at: Array, across: Array) -> tuple[float, str]:
    """Give the fixed point that a guide through a place misses least, and by how much, to the guide's left. [m]"""
    offsets = {name: float(across @ (at - _place(shown.made[name]))) for name in (SHAFT, *shown.spec.fixed)}
    through = smallest_of(offsets, lambda name: abs(offsets[name]))
    return 0.0 if shown.typing.is_small(offsets[through]) else offsets[through], through


def _to_chain(
    added: Callable[[_Shown, Sequence[Clicked]], AddedTable],
) -> Callable[[ChainTable, Sequence[Clicked], float], AddedTable]:
    """Give what adds a part to the chain of a table."""
    return lambda spec, clicks, angle: added(_shown(spec, angle), clicks)


_ON_PIN: Mapping[Taken, str] = {"pin": N_("on {name}")}
_ON_LINK: Mapping[Taken, str] = {"link": N_("point on {name}")}
_ON_LINK_OR_GROUND: Mapping[Taken, str] = {"link": N_("pin on {name}"), "ground": N_("fixed point")}

ADDITIONS = (
    Addition(
        "point",
        N_("Followed point"),
        (Click(N_("Where on a link is the point that is followed?"), _ON_LINK),),
        _to_chain(_followed),
    ),
    Addition(
        "pin",
        N_("Pin"),
        (Click(N_("Where is the pin: on a link, or on the ground as a fixed point?"), _ON_LINK_OR_GROUND),),
        _to_chain(_pin),
    ),
    Addition(
        "pair",
        N_("Two links"),
        (
            Click(N_("On which pin does the first link begin?"), _ON_PIN),
            Click(N_("Where do both links meet?"), {"ground": N_("joint")}),
            Click(N_("On which pin does the second link end?"), _ON_PIN),
        ),
        _to_chain(_pair),
    ),
    Addition(
        "slider",
        N_("Link and slider"),
        (
            Click(N_("On which pin does the link begin?"), _ON_PIN),
            Click(N_("Where is the pin of the slider?"), {"ground": N_("slider")}),
            Click(N_("In which direction does its guide run?"), {"ground": N_("guide")}),
        ),
        _to_chain(_slide),
    ),
)
"""What may be added to a chain."""
