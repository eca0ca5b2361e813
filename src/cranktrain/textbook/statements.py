"""What a text states of a machine, formula by formula, beside what is right: records, tables of them, curves."""

import csv
import io
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields
from functools import cached_property
from itertools import chain, count
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.extras import imported
from cranktrain.language import Said, Words, _
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.saying.catalogue import DEFINITION, Entry
from cranktrain.saying.names import key_of_symbol
from cranktrain.saying.run import Axis, Run
from cranktrain.texts.contents import numbers_in, plain_number
from cranktrain.texts.largest_errors import LargestErrors

if TYPE_CHECKING:
    import pandas

__all__ = ["Statement", "StatementCurve", "Statements", "Verdict"]

Verdict: TypeAlias = Literal["right", "approximate", "out of range", "printed", "refuted", "beyond"]
"""Right: exact; approximate, in the range that the text gives, or out of it; printed: wrong in print; refuted: by the
text itself; beyond: what the text has no term for."""

ERRORS = ("Δx", "Δv", "Δj")
"""Of displacement in parts of the stroke, of velocity and acceleration in parts of the exact peaks."""
_ROUNDING = 1e-12
LARGEST = "largest"
"""Where an error is given: where it is largest over the turn."""


@record
class _Stated:
    """What numbers and curves of a text have in common."""

    source: str
    equation: str
    symbol: str
    words: Words
    of: str

    @property
    def name(self) -> str:
        """What it is, in the reader's language."""
        return str(self.words)


@record
class Statement(_Stated):
    """One number of a text, of one machine.

    Attributes
    ----------
    source : str
        Name of the text.
    equation : str
        Its own number: `(14)`; of several that give one number all of them.
    symbol : str
    words : Words
        What it is.
    of : str
        Whose it is: a piston, a cylinder, a throw; empty where there is but one.
    at : str
        Where or of what: `at` the asked angle, `largest`, `mean`, …
    value : float
        By the text. In SI.
    unit : str
        Of `value` and `exact`.
    verdict : Verdict
    exact : float
        What is right; NaN where nothing stands beside it.
    crank_angle : float
        Where it is so; NaN of what holds for the turn. [deg]
    """

    at: str
    value: float
    unit: str
    verdict: Verdict
    exact: float = np.nan
    crank_angle: float = np.nan

    @property
    def error(self) -> float:
        """By how much the text is off."""
        return self.value - self.exact


_COLUMNS = ["name" if one.name == "words" else one.name for one in fields(Statement)]
"""Of a table of statements."""


@record
class StatementCurve(_Stated):
    """A text's curve over the crank angle.

    Attributes
    ----------
    source, equation, symbol, words, of, unit, verdict
        As a `Statement` has them.
    values : Array, shape (crank_angle,)
        By the text.
    exact : Array or None
        What is right; None where nothing stands beside it.
    """

    unit: str
    verdict: Verdict
    values: Array
    exact: Array | None = None


@record
class Statements(Run):
    """All that a text states of a machine, in the text's order.

    Attributes
    ----------
    heading : Words
    each : tuple of Statement
    crank_angle : Array, shape (crank_angle,)
        Of the curves. [deg]
    over_turn : tuple of StatementCurve
    sentences : mapping of Words to tuple of Words
        What is to be said of them, by what it is about.
    """

    heading: Words
    each: tuple[Statement, ...]
    crank_angle: Array
    over_turn: tuple[StatementCurve, ...] = ()
    sentences: Mapping[Words, tuple[Words, ...]] = field(default_factory=dict[Words, tuple[Words, ...]])

    @property
    def title(self) -> str:
        """What they are of, in the reader's language."""
        return str(self.heading)

    @property
    def notes(self) -> dict[str, tuple[str, ...]]:
        """The sentences in the reader's language."""
        return {str(subject): tuple(map(str, said)) for subject, said in self.sentences.items()}

    @property
    def subject(self) -> Words:
        """What they are of."""
        return self.heading

    @property
    def axis(self) -> Axis | None:
        """Crank angles, which the curves are over; None without curves."""
        return Axis("crank_angle", "deg", "φ", self.crank_angle) if self.over_turn else None

    @cached_property
    def _named(self) -> "dict[str, Statement | StatementCurve]":
        """Statements and curves by keys of symbol, whose, where and number; counted where these are alike."""
        named: dict[str, Statement | StatementCurve] = {}
        for one in (*self.each, *self.over_turn):
            where = one.at if isinstance(one, Statement) else one.verdict
            name = "_".join(map(key_of_symbol, filter(None, (one.symbol, one.of, where, one.equation))))
            counted = chain((name,), (f"{name}_{n}" for n in count(2)))
            named[next(free for free in counted if free not in named)] = one
        return named

    @property
    def catalogue(self) -> Mapping[str, Entry]:
        """What is stated, along `form`, by the text and exact, and of curves the crank angle."""
        return {
            name: Entry(
                name,
                one.symbol,
                one.unit,
                ("form", "crank_angle") if isinstance(one, StatementCurve) else ("form",),
                ", ".join(filter(None, (one.name, one.of, one.at if isinstance(one, Statement) else ""))),
                one.source,
                one.equation or DEFINITION,
                name,
                one.unit,
            )
            for name, one in self._named.items()
        }

    @property
    def labels(self) -> Mapping[str, tuple[str, ...]]:
        """The text's, and the exact one beside it."""
        return {"form": ("text", "exact")}

    def __getattr__(self, name: str) -> Array:
        """Give what is stated by its name, by the text and exact, or NaN where nothing stands beside."""
        if name.startswith("_") or name not in self._named:
            raise AttributeError(name)
        one = self._named[name]
        if isinstance(one, Statement):
            return np.array([one.value, one.exact])
        return np.stack([one.values, np.full_like(one.values, np.nan) if one.exact is None else one.exact])

    def about(self) -> Iterator[tuple[str, Words]]:
        """What heads a file of them: what they are of, and what is to be said."""
        yield "statements", self.heading
        for subject, sentences in self.sentences.items():
            yield from ((str(subject), sentence) for sentence in sentences)

    def before(self) -> Mapping[str, object]:
        """What a .json has before its numbers: what they are of, what is to be said, verdicts."""
        verdicts = {name: one.verdict for name, one in self._named.items()}
        return {"statements": self.title, "notes": {k: list(v) for k, v in self.notes.items()}, "verdicts": verdicts}

    def __len__(self) -> int:
        """How many there are."""
        return len(self.each)

    def __iter__(self) -> Iterator[Statement]:
        """One after another."""
        return iter(self.each)

    def numbered(self, equation: str | int) -> tuple[Statement, ...]:
        """Those of a formula by its number in the text, with or without brackets.

        Raises
        ------
        InputError
            If none has that number, with those that there are.
        """
        asked = plain_number(str(equation))
        found = tuple(one for one in self.each if asked in numbers_in(one.equation))
        if not found:
            there = ", ".join(dict.fromkeys(one.equation for one in self.each if one.equation))
            allowed = _("must be one of the numbers that there are: {numbers}", numbers=there or _("none"))
            raise InputError([Problem("equation", str(equation), allowed)])
        return found

    def __repr__(self) -> str:
        """Show what they are of and how many there are, in one line."""
        shown = _("<Statements: {title}; {n} numbers, {n_curves} curves>")
        return str(shown.format(title=self.heading, n=len(self.each), n_curves=len(self.over_turn)))

    @property
    def frame(self) -> "pandas.DataFrame":
        """As a data frame, a row for each."""
        rows = [[getattr(one, name) for name in _COLUMNS] for one in self.each]
        return _pandas("frame").DataFrame(rows, columns=_COLUMNS)

    def csv(self) -> str:
        """The curves as a table over the crank angle, in SI; exact ones beside, where they are none of the others.

        Where there are no curves, the numbers with their names, a row for each. It is another table than other runs
        have: what a text says stands in it by the text's own number and letters, with the verdict on it.
        """
        if not self.over_turn:
            return self._csv_of_numbers()
        heads, columns = ["crank_angle_deg"], [self.crank_angle]
        are_several = len({one.of for one in self.over_turn}) > 1
        for one in self.over_turn:
            numbered, unit = (f"{one.equation} " if one.equation else ""), f"[{one.unit}]"
            whose = f", {one.of}" if are_several else ""
            heads.append(f"{numbered}{one.symbol} {one.verdict}: {one.name}{whose} {unit}")
            columns.append(one.values)
            if one.exact is not None and not any(np.array_equal(one.exact, other.values) for other in self.over_turn):
                heads.append(f"{one.symbol} exact{whose} {unit}")
                columns.append(one.exact)
        lines = [",".join(f'"{head}"' for head in heads)]
        lines += [",".join(f"{value + 0.0:.12g}" for value in row) for row in np.stack(columns, axis=1)]
        return "\n".join(lines) + "\n"

    def _csv_of_numbers(self) -> str:
        """Every record in a row; what is not known is empty."""
        text = io.StringIO(newline="")
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(_COLUMNS)
        for one in self.each:
            writer.writerow(_plain(getattr(one, name)) for name in _COLUMNS)
        return text.getvalue()

    @property
    def curve_frame(self) -> "pandas.DataFrame":
        """The curves as a data frame over the crank angle: columns by equation, name, whose, verdict and unit."""
        pandas = _pandas("curve_frame")
        columns: dict[tuple[str, ...], Array] = {}
        for one in self.over_turn:
            named = (one.equation, one.name, one.of)
            columns[*named, one.verdict, one.unit] = one.values
            if one.exact is not None:
                columns[*named, "exact", one.unit] = one.exact
        heads = pandas.MultiIndex.from_tuples(list(columns), names=("equation", "name", "of", "verdict", "unit"))
        values = np.stack(list(columns.values()), axis=1) if columns else np.zeros((self.crank_angle.size, 0))
        return pandas.DataFrame(values, pandas.Index(self.crank_angle, name="crank_angle"), heads)


def _plain(value: str | float) -> str:
    """Write a cell of a table; of NaN an empty one."""
    if isinstance(value, str):
        return value
    return f"{value + 0.0:.12g}" if np.isfinite(value) else ""


def _pandas(asked: str) -> Any:
    """Import what makes data frames."""
    return imported("pandas", asked, _("take the records themselves"))


@dataclass(frozen=True, slots=True, repr=False)
class Heading(Said):
    """Words with a large letter before."""

    words: Words

    def said(self, say: Callable[[object], object]) -> str:
        """Say them."""
        text = str(say(self.words))
        return text[:1].upper() + text[1:]

    def each(self) -> Iterable[object]:
        """Give them."""
        return (self.words,)


class MotionForm(NamedTuple):
    """Whose form it is, the numbers of its three equations or of one for all, what it is in words, where it is off."""

    source: str
    equations: Sequence[str]
    words: Words
    at: str = LARGEST


def error_statements(
    form: MotionForm, of: str, errors: Sequence[tuple[float, float]], verdict: Verdict
) -> Iterator[Statement]:
    """Give the three errors [1], each with its angle [deg]; what is but rounding is at none."""
    for order, (symbol, (error, angle)) in enumerate(zip(ERRORS, errors, strict=True)):
        equation = form.equations[min(order, len(form.equations) - 1)]
        where = angle % 360.0 if abs(error) > _ROUNDING else np.nan
        yield Statement(form.source, equation, symbol, form.words, of, form.at, error, "1", verdict, 0.0, where)


def with_degrees(errors: LargestErrors) -> list[tuple[float, float]]:
    """Give errors with their angles. [1, deg]"""
    return [(float(error.value), float(np.rad2deg(error.angle))) for error in errors]
