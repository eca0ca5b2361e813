"""Table of the forces on groups: number in the polygon, symbol, joint, length on paper, size."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple, TypeVar

from cranktrain.language import said as _
from cranktrain.one_line import short
from cranktrain.panels.figures import column, figure, rounded
from cranktrain.panels.formulas import in_words, mathematics
from cranktrain.plans.force_polygons import ForcePolygon
from cranktrain.plans.force_sides import INITIAL, PolygonForce
from cranktrain.plans.vectors import spoken_name
from cranktrain.saying.names import said_name
from cranktrain.saying.scales import Scale, scale_for
from cranktrain.saying.wording import first_that_holds
from cranktrain.viz.paper.page import Page
from cranktrain.viz.paper.tables import write_row

Item = TypeVar("Item")

TABLE = 66.0
"""Width of a table of forces. [mm]"""

_LINE, _HEAD = 4.3, 6.0
"""Height of its rows and of its head. [mm]"""

_HEADING = 32
"""Letters of a heading of the table on one line."""

_LETTERS = 15
"""Of a joint's name there is room for so many."""

_ENDS = (0.0, 0.08, 0.26, 0.79, 1.0)
_SIDES = ("left", "left", "left", "right", "right")
"""Where the columns begin or end, in parts of the width."""


class Row(NamedTuple):
    """A row of the table: what its columns say; of a heading the first one alone."""

    columns: tuple[str, ...]
    is_heading: bool = False


def tables(polygons: Sequence[ForcePolygon], height: float, letters: Mapping[str, str], unit: Scale) -> list[list[Row]]:
    """Divide the rows of all forces, in a unit, among tables that are as high as the room. [mm]"""
    room = int((height - _HEAD) / _LINE) - 1
    has_names = len({polygon.mechanism for polygon in polygons}) > 1
    rows = (row for polygon in polygons for row in _rows(polygon, letters, unit, has_names=has_names))
    return packed(rows, lambda table: len(table) <= room - table[-1].is_heading)


def packed(items: Iterable[Item], fits: Callable[[Sequence[Item]], bool]) -> list[list[Item]]:
    """Put items into rows, in order, as many into each as fit; one at least."""
    rows: list[list[Item]] = [[]]
    for item in items:
        if rows[-1] and not fits([*rows[-1], item]):
            rows.append([])
        rows[-1].append(item)
    return rows


def write_forces(page: Page, rows: Sequence[Row], unit: Scale, place: tuple[float, float, float]) -> None:
    """Write a table, in a unit, at a place on the sheet: left, top, width. [mm]"""
    left, top, width = place
    heads = Row(("", _("force"), _("joint"), "mm", unit.label), is_heading=True)
    places = [(left + share * width, side) for share, side in zip(_ENDS, _SIDES, strict=True)]
    lines = [0.0, *(_HEAD + _LINE * number for number in range(len(rows)))]
    for row, line in zip((heads, *rows), lines, strict=True):
        write_row(page, row.columns, places, top - 4.0 - line, is_bold=row.is_heading)
    page.rule(top - 5.4, left, left + width)


def group_words(polygon: ForcePolygon) -> str:
    """Say what a polygon is of: numbers of the links, and the sort of their group."""
    sorts = {INITIAL: _("initial link"), "triad": _("triad")}
    numbers = ", ".join(map(str, polygon.numbers))
    return f"{numbers}: {sorts.get(polygon.sort) or _('group {sort}', sort=polygon.sort)}"


def _rows(polygon: ForcePolygon, letters: Mapping[str, str], unit: Scale, *, has_names: bool) -> Iterator[Row]:
    """Every force of a group: sides by their numbers, torques of loads, whole reactions and those in inner joints."""
    for line in _headings(polygon, has_names=has_names):
        yield Row((line,), is_heading=True)
    sides = [(str(i + 1), force) for i, force in enumerate(polygon.forces)]
    others = [("", span.force) for span in (*polygon.wholes, *polygon.chords)]
    sizes = column([force.size for _number, force in (*sides, *others)], unit)
    rows = [
        Row((number, mathematics(force.symbol), _said(force, letters), rounded(polygon.length(force)), size))
        for (number, force), size in zip((*sides, *others), sizes, strict=True)
    ]
    yield from rows[: len(sides)]
    for torque in polygon.torques:
        newton_metres = scale_for("N*m", abs(torque.value))
        size = figure(float(newton_metres.of(torque.value)))
        yield Row(("", mathematics(torque.symbol), _name(torque.name), newton_metres.label, size))
    yield from rows[len(sides) :]


def _name(load: str) -> str:
    """Name of a load, as far as there is room."""
    return short(load.replace("_", " "), _LETTERS)


def _headings(polygon: ForcePolygon, *, has_names: bool) -> list[str]:
    """Numbers and names of a group's links, on as many lines as they need; of several mechanisms theirs too."""
    named = [f"{number} {said_name(link)}" for number, link in zip(polygon.numbers, polygon.links, strict=True)]
    if has_names:
        named[0] = f"{polygon.mechanism}: {named[0]}"
    *lines, last = packed(named, lambda words: len(", ".join(words)) <= _HEADING)
    return [*(f"{', '.join(line)}," for line in lines), ", ".join(last)]


def _said(force: PolygonForce, letters: Mapping[str, str]) -> str:
    """Cause of a force, how a part of a reaction lies, or the joint of a reaction."""
    pin = letters.get(force.about) or said_name(spoken_name(force.about))
    return first_that_holds(
        (force.cause == "gas", _("gas")),
        (force.cause == "load", _name(force.name)),
        (force.cause == "weight", _("weight")),
        (force.cause == "inertia", _("inertia")),
        (bool(force.about), short(_("about {pin}", pin=in_words(pin)), _LETTERS)),
        (force.symbol.endswith("^n"), _("along the link")),
        (force.symbol.startswith("f_"), _("friction")),
        (True, short(said_name(spoken_name(force.joint.partition("/")[0])), _LETTERS)),
    )
