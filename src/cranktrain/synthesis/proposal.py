"""A synthesis: what it wants, in SI, and what it proposes: dimensions, what else was considered, the machine file."""

import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, NamedTuple, TypeAlias

import numpy as np

from cranktrain.brief import brief_fields
from cranktrain.errors import Problem
from cranktrain.language import N_, Listed, Said, Words, _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.paths import quoted
from cranktrain.quantities import Dimension, Quantity, Status, read, shown
from cranktrain.record import record
from cranktrain.saying.catalogue import DEFINITION, Entry
from cranktrain.saying.run import Run
from cranktrain.saying.wording import as_limit

Length: TypeAlias = Annotated[float, Quantity(Dimension.LENGTH)]
Angle: TypeAlias = Annotated[float, Quantity(Dimension.ANGLE)]
Ratio: TypeAlias = Annotated[float, Quantity(Dimension.RATIO)]
Velocity: TypeAlias = Annotated[float, Quantity(Dimension.VELOCITY)]
Count: TypeAlias = Annotated[int, Quantity(Dimension.RATIO, example="9")]
TimeRatio: TypeAlias = Annotated[
    float,
    Quantity(Dimension.RATIO, example="1.2"),
    N_("Time of the slow stroke over that of the quick one."),
]
Bore: TypeAlias = Annotated[float, Quantity(Dimension.LENGTH, above=0.0), N_("For the machine file.")]
Speed: TypeAlias = Annotated[float, Quantity(Dimension.SPEED, above=0.0), N_("Of the crank.")]
Friction: TypeAlias = Annotated[
    float, Quantity(Dimension.RATIO, above=0.0, at_most=2.0), N_("Coefficient of friction of the slider on its guide.")
]
Mass: TypeAlias = Annotated[float, Quantity(Dimension.MASS)]

_DIMENSIONS = {
    "mm": Dimension.LENGTH,
    "deg": Dimension.ANGLE,
    "rpm": Dimension.SPEED,
    "kg": Dimension.MASS,
    "N": Dimension.FORCE,
    "kN": Dimension.FORCE,
    "lbf": Dimension.FORCE,
    "kW": Dimension.POWER,
    "kg·m²": Dimension.INERTIA,
}
_UNITS = {
    "mm": ("m", "m"),
    "deg": ("rad", "rad"),
    "rpm": ("rad/s", "rpm"),
    "kg": ("kg", "kg"),
    "N": ("N", "N"),
    "kN": ("N", "N"),
    "lbf": ("N", "N"),
    "N·m": ("N*m", "N*m"),
    "kW": ("W", "W"),
    "kg·m²": ("kg*m^2", "kg*m^2"),
    "%": ("1", "%"),
}
"""The catalogue's unit of numbers by the one in which they are shown, and by what that is found; others are alike."""
_SOURCE = "docs/theory/synthesis"
_MOST_DIGITS = 17
_ROUNDINGS = 2
"""By how many units in its last place a text may miss a value: 160 mm are not to read 160.00000000000003."""
_LINE = 116


def not_positive(
    requirements: Mapping[str, float | None], written: Callable[[float], Words] = as_limit
) -> list[Problem]:
    """Problems of requirements that are not more than 0, each written as a length unless said; None is none."""
    return [
        Problem(name, written(value), _("must be more than 0"))
        for name, value in requirements.items()
        if value is not None and not value > 0
    ]


def plain(value: float) -> str:
    """A number without its unit."""
    return f"{value:g}"


class Number(NamedTuple):
    """A number of a proposal: name, symbol, value in SI, the unit to show it in, and what it is in a sentence.

    member: which throw, web, cylinder or bearing it is of, where there are several.
    """

    name: str
    symbol: str
    value: float
    unit: str
    sentence: Words
    member: str = ""

    @property
    def key(self) -> str:
        """By what a proposal gives it: `mass(2)` is the mass at throw 2."""
        return f"{self.name}({self.member})" if self.member else self.name


class Alternative(NamedTuple):
    """Something else that was considered: what it is, and its numbers beside the proposal's."""

    label: Words
    numbers: tuple[Number, ...]

    def __repr__(self) -> str:
        """Show it in a line."""
        return brief_fields("Alternative", self._asdict().items())


class ProposedTable(NamedTuple):
    """A table of a machine file: its head, and each key with its value as TOML text."""

    head: str
    keys: Mapping[str, Words]


@record
class Proposal(Run):
    """Dimensions that give what was wanted.

    Attributes
    ----------
    title : Words
    numbers : tuple of Number
    alternatives : tuple of Alternative
    remarks : tuple of Words
    tables : tuple of ProposedTable
        What a machine file of it says.
    """

    title: Words
    numbers: tuple[Number, ...]
    alternatives: tuple[Alternative, ...]
    remarks: tuple[Words, ...]
    tables: tuple[ProposedTable, ...]

    @property
    def subject(self) -> Words:
        """What it is of."""
        return self.title

    @property
    def catalogue(self) -> Mapping[str, Entry]:
        """Its numbers, along `choice` and, where there are several of one, `member`."""
        found: dict[str, Entry] = {}
        for one in self._every:
            unit, shown_by = _UNITS.get(one.unit, (one.unit, one.unit))
            dimensions = ("choice", "member") if one.member else ("choice",)
            said = str(one.sentence)
            found[one.name] = Entry(
                one.name, one.symbol, unit, dimensions, said, _SOURCE, DEFINITION, one.name, shown_by
            )
        return found

    @property
    def _every(self) -> Iterator[Number]:
        """All numbers, those of alternatives too."""
        yield from self.numbers
        for one in self.alternatives:
            yield from one.numbers

    @property
    def labels(self) -> Mapping[str, tuple[str, ...]]:
        """What is proposed and what else was considered, by numbers; throws, webs, cylinders or bearings."""
        members = tuple(dict.fromkeys(one.member for one in self._every if one.member))
        choices = ("proposed", *(str(place + 1) for place in range(len(self.alternatives))))
        return {"choice": choices, **({"member": members} if members else {})}

    @property
    def titles(self) -> Mapping[str, tuple[str, ...]]:
        """What people call these."""
        return {**self.labels, "choice": (str(_("as proposed")), *(str(one.label) for one in self.alternatives))}

    def __getattr__(self, name: str) -> Array:
        """Give a number by its name for all choices, in the unit of its entry; NaN where a choice has none."""
        if name.startswith("_") or name not in self.catalogue:
            raise AttributeError(name)
        is_of_members = "member" in self.catalogue[name].dimensions
        members = self.labels["member"] if is_of_members else ("",)
        found = np.full((len(self.labels["choice"]), len(members)), np.nan)
        for row, numbers in enumerate((self.numbers, *(one.numbers for one in self.alternatives))):
            for one in numbers:
                if one.name == name:
                    found[row, members.index(one.member)] = one.value
        return found if is_of_members else found[:, 0]

    def about(self) -> Iterator[tuple[str, Words]]:
        """What heads a file of it: what it is of, what choices are, and what is to be minded."""
        yield "proposal", self.title
        for label, one in zip(self.labels["choice"][1:], self.alternatives, strict=True):
            yield f"choice {label}", one.label
        for remark in self.remarks:
            yield "mind", remark

    def before(self) -> Mapping[str, object]:
        """What a .json has before its numbers: what it is of, what choices are, and what is to be minded."""
        choices = dict(zip(self.labels["choice"], self.titles["choice"], strict=True))
        return {"proposal": str(self.title), "choices": choices, "remarks": list(map(str, self.remarks))}

    def __repr__(self) -> str:
        """Show what it is of, and how much there is, in a line."""
        about = _(
            "<Proposal: {title}: {n} numbers, alternatives: {others}>",
            title=self.title,
            n=len(self.numbers),
            others=len(self.alternatives),
        )
        return str(about)

    def value(self, name: str) -> float:
        """Give a number by its name, in SI: `stroke`, or `stroke(2)` of one of several members.

        Raises
        ------
        KeyError
            If the proposal has no such number.
        """
        return {one.key: one.value for one in self.numbers}[name]

    def machine_file(self) -> str:
        """Write the machine file: TOML with the status of every number, the remarks as comments; ready to run."""
        lines = [
            line
            for comment in (self.title, *self.remarks)
            for line in textwrap.wrap(str(comment), _LINE, initial_indent="# ", subsequent_indent="# ")
        ]
        lines += ["", f"name = {quoted(str(self.title))}"]
        for table in self.tables:
            lines += ["", f"[{table.head}]", *(f"{key} = {value}" for key, value in table.keys.items())]
        return "\n".join(lines) + "\n"


@record
class MachineProposal(Proposal):
    """Other values for a machine that there is.

    Attributes
    ----------
    machine : Machine
        With them.
    values : mapping of str to Words
        What its file says otherwise, as TOML by path.
    whole : tuple of str
        Paths of tables of which nothing else is to stand.
    """

    machine: Machine
    values: Mapping[str, Words]
    whole: tuple[str, ...] = ()


def listed_in_lines(values: Sequence[Words]) -> Words:
    """Write a TOML list of long values, one in a line."""
    return Listed(("[\n", *(part for value in values for part in ("    ", value, ",\n")), "]"), "")


def quantity_text(value: float, unit: str) -> str:
    """Write a quantity with as few digits as read back to the same value, but for rounding.

    Parameters
    ----------
    value : float
        In SI.
    unit : str
        `mm`, `deg`, `rpm`, `kg`, `N`, `kN`, `lbf`, `kW` or `kg·m²`.

    Returns
    -------
    str

    Examples
    --------
    >>> quantity_text(0.08, "mm"), quantity_text(1 / 3, "mm")
    ('80 mm', '333.3333333333333 mm')
    """
    size = shown(value, unit)
    text = ""
    for digits in range(1, _MOST_DIGITS + 1):
        text = f"{np.format_float_positional(float(f'{size:.{digits}g}'), trim='-')} {unit}"
        if abs(read(text, _DIMENSIONS[unit]) - value) <= _ROUNDINGS * np.spacing(abs(value)):
            break
    return text


@dataclass(frozen=True, slots=True, repr=False)
class _Noted(Said):
    """A value of a machine file, which is TOML, with its status and a note."""

    value: str
    note: Words
    status: Status | None = None

    def said(self, say: Callable[[object], object]) -> str:
        """Write it as TOML text."""
        status = "" if self.status is None else f'status = "{self.status}", '
        return f"{{ value = {self.value}, {status}note = {quoted(str(say(self.note)))} }}"

    def each(self) -> Iterable[object]:
        """Give its note."""
        return (self.note,)


def wanted(value: float, unit: str) -> Words:
    """Give a quantity that was wanted as it stands, to be written as TOML text."""
    return _Noted(quoted(quantity_text(value, unit)), _("as wanted"))


def wanted_ratio(value: float) -> Words:
    """Give a plain number that was wanted, as `wanted` gives a quantity."""
    return _Noted(repr(value), _("as wanted"))


def found(value: float, unit: str, note: Words, status: Status = "derived") -> Words:
    """Give a quantity that follows from the requirements, to be written as TOML text with its status."""
    return _Noted(quoted(quantity_text(value, unit)), note, status)


def found_ratio(value: float, note: Words, status: Status = "derived") -> Words:
    """Give a plain number that follows from the requirements, as `found` gives a quantity."""
    return _Noted(repr(value), note, status)


def shaft_table(speed: float | None, note: Words | None = None) -> tuple[ProposedTable, ...]:
    """Write the shaft's table with its speed [rad/s], where there is one; a note says how it was found."""
    if speed is None:
        return ()
    return (
        ProposedTable("shaft.main", {"speed": wanted(speed, "rpm") if note is None else found(speed, "rpm", note)}),
    )
