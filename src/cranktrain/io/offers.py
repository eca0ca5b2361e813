"""Tables that a machine's file has not, each with values of a machine like it: as a new file of its kind has them."""

import re
from collections.abc import Mapping
from dataclasses import replace
from functools import cache

from cranktrain.errors import InputError
from cranktrain.io.machine_file import MachineFile
from cranktrain.io.syntax import parsed
from cranktrain.language import Words, _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine, machine_problems
from cranktrain.mechanisms import KINDS
from cranktrain.quantities.dimensions import Dimension, is_unit
from cranktrain.quantities.number import measured
from cranktrain.record import record
from cranktrain.saying.comments import with_said_comments

_POWERS: Mapping[Dimension, int] = {
    Dimension.LENGTH: 1,
    Dimension.AREA: 2,
    Dimension.VOLUME: 3,
    Dimension.SPEED: -1,
    Dimension.FREQUENCY: -1,
    Dimension.TIME: 1,
    Dimension.FORCE: 2,
    Dimension.TORQUE: 3,
    Dimension.ENERGY: 3,
    Dimension.POWER: 2,
    Dimension.MASS: 3,
    Dimension.INERTIA: 5,
    Dimension.FLYWHEEL_MOMENT: 5,
    Dimension.STIFFNESS: 1,
    Dimension.TORSIONAL_STIFFNESS: 3,
    Dimension.BENDING_STIFFNESS: 4,
    Dimension.FLOW: 2,
    Dimension.MASS_FLOW: 2,
}
"""Of the size of a machine of the same materials, at the same stresses and the same speed of its pistons, with which
its numbers go; pressures, ratios, temperatures and velocities stay."""

_QUOTED = re.compile(r'(?<= = )"([^"]*)"')
_FIGURES = 2
_ALIKE = 1.25
"""Two sizes are one where neither is more than this part of the other: values stay as they are."""


@record
class OfferedTable:
    """A table, with the tables in it, that a file may have.

    Attributes
    ----------
    key : str
        Its name in the file.
    words : Words
        What is there with it, or what stands in it.
    text : str
        What stands in the file then.
    """

    key: str
    words: Words
    text: str


def offered_tables(file: MachineFile) -> tuple[OfferedTable, ...]:
    """Give the tables that a machine's file has not, and that would be right in it as they are.

    Parameters
    ----------
    file : MachineFile

    Returns
    -------
    tuple of OfferedTable
        As a new file of the kind of its first mechanism has them; sizes go with the crank.
    """
    if not file.machine.places:
        return ()
    first = file.machine.places[0]
    ratio = _radius(first) / _radius_of_kind(first.kind.name)
    lacking = (table for table in _tables(first.kind.name) if table.key not in file.document.data)
    sized = (replace(one, words=_(str(one.words)), text=_sized(one.text, ratio)) for one in lacking)
    return tuple(table for table in sized if _is_right(file, table))


def with_table(file: MachineFile, key: str) -> str:
    """Give the text of a machine's file with one of the tables that are offered.

    Raises
    ------
    KeyError
        If none of that name is.
    """
    texts = {table.key: table.text for table in offered_tables(file)}
    return f"{file.document.text.rstrip()}\n\n{with_said_comments(texts[key])}\n"


@cache
def _tables(kind: str) -> tuple[OfferedTable, ...]:
    """Tables that suit a kind, in the order in which its new file has them, the parts of one together."""
    path = KINDS.named(kind).tables
    text = "" if path is None else path.read_text(encoding="utf-8")
    found: dict[str, OfferedTable] = {}
    for section in re.split(r"\n\s*\n", text):
        lines = [line.removeprefix("# ").rstrip() for line in section.strip().splitlines()]
        head = re.match(r"\[+([\w]+)[^#]*(?:# (.*))?", lines[0])
        if head is None or not section.lstrip().startswith("# ["):
            continue
        key, words = head.groups()
        before = found.get(key)
        if before is None:
            found[key] = OfferedTable(key, words or "", "\n".join(lines))
        else:
            found[key] = replace(before, text="\n\n".join((before.text, "\n".join(lines))))
    return tuple(found.values())


def _is_right(file: MachineFile, table: OfferedTable) -> bool:
    """Whether the machine with the table is one."""
    try:
        machine = file.machine.with_({table.key: parsed(table.text, table.key)[table.key]})
    except InputError:
        return False
    return not machine_problems(machine, partial=True)


@cache
def _radius_of_kind(name: str) -> float:
    """Crank radius of the machine in a new file of a kind. [m]"""
    example = parsed(KINDS.named(name).example, name)
    return _radius(Machine(**example).places[0])


def _radius(place: PlacedMechanism) -> float:
    """Crank radius, 1 of a mechanism that has no one number for it. [m]"""
    return float(getattr(place.geometry, "crank_radius", 1.0))


def _sized(text: str, ratio: float) -> str:
    """Give the text of tables with the sizes of a machine that is so many times as large; they are assumed."""
    return _QUOTED.sub(lambda found: _similar(found[1], ratio), text)


def _similar(text: str, ratio: float) -> str:
    """Give a quantity of a machine that is so many times as large, to two figures; words as they are."""
    parts = measured(text)
    if parts is None or not parts.unit:
        return f'"{text}"'
    power = next((power for dimension, power in _POWERS.items() if is_unit(parts.unit, dimension)), 0)
    if power and max(ratio, 1.0 / ratio) > _ALIKE:
        text = f"{float(f'{float(parts.number) * ratio**power:.{_FIGURES}g}'):.12g} {parts.unit}"
    return f'{{ value = "{text}", status = "assumed" }}'
