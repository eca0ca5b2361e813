"""`textbook --throw`: (44) to (53) for a throw, each constituent and all together, and its two balances."""

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path, PurePath
from typing import NamedTuple

import numpy as np
from rich.console import Console
from rich.text import Text

from cranktrain import texts
from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.cli.screen.text import INDENT, page, section, table
from cranktrain.cli.textbook.throw_output import output_problems, write_throw
from cranktrain.errors import InputError, Position, Problem, problems_as, refuse
from cranktrain.io.document import Document
from cranktrain.io.syntax import parsed
from cranktrain.language import _
from cranktrain.one_line import one_line
from cranktrain.questions.crankshaft.throw_reactions import (
    ThrowConstituents,
    ThrowReactions,
    throw_constituents,
    throw_length,
    throw_reactions,
)
from cranktrain.references import REFERENCES
from cranktrain.texts.throw_conditions import BalanceCondition, balance_conditions
from cranktrain.texts.throw_table import CHAIN, Throw, read_throw
from cranktrain.wording import figure, number

EXAMPLE = "example"
_SOURCE = "crankshaft-reactions"
_SETTING = Position("--set")


class _ThrowFile(NamedTuple):
    """A throw and the text that declares it."""

    throw: Throw
    text: str


def show_throw(
    source: str, settings: Sequence[str], output: str | None, *, force: bool, others: Mapping[str, str | None]
) -> None:
    """Show a throw's reactions, or write its table or its scheme.

    Parameters
    ----------
    source : str
        A file with its table, or `example`, if no file is called so.
    settings : sequence of str
        `SYMBOL=VALUE`
    output : str or None
        File to write instead: .toml, .png, .svg, .pdf.
    force : bool
        Replace a file that is there.
    others : mapping of options to str or None
        What else was typed and means nothing here.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    allowed = _("must be left out beside --throw")
    found = [Problem(name, value or None, allowed) for name, value in others.items() if value is not None]
    refuse([*found, *output_problems(output)])
    file = read_throw_file(source, settings)
    if output is not None:
        write_throw(file.throw, file.text, one_line(PurePath(source).name), output, force=force)
        return
    with page(_("Reactions of the supports of a throw, (44) to (53) [{source}]").format(source=_SOURCE)) as console:
        _show(console, file.throw)


def read_throw_file(source: str, settings: Sequence[str]) -> _ThrowFile:
    """Read a throw's table with some values set anew; what is wrong stands at its line, or at `--set`."""
    typed = _document(source)
    document, keys = typed, list[str]()
    for setting in settings:
        key, equals, value = (part.strip() for part in setting.partition("="))
        if not equals or not key.isidentifier():
            allowed = _('must be SYMBOL=VALUE, such as "K1=20 kN"')
            raise InputError([Problem("", setting, allowed, position=_SETTING)])
        try:
            document = document.with_value(key, value)
        except InputError as error:
            raise InputError(replace(problem, position=_SETTING) for problem in error.problems) from None
        keys.append(key)
    try:
        return _ThrowFile(read_throw(parsed(document.text, document.name)), document.text)
    except InputError as error:
        raise InputError(
            replace(problem, position=_SETTING) if problem.path in keys else document.located(problem)
            for problem in error.problems
        ) from None


def _document(source: str) -> Document:
    """Read the text of a throw's table; a file that says nothing is refused."""
    if not source.strip():
        allowed = _("must be the name of a file with a throw's table, or `{example}`").format(example=EXAMPLE)
        raise InputError([Problem("--throw", '""', allowed)])
    is_file = os.path.isfile(source)  # noqa: PTH113 - takes a NUL byte
    if source.strip().casefold() == EXAMPLE and not is_file:
        path = Path(texts.__file__).parent / "throw_example.toml"
        return Document.from_text(path.read_text(encoding="utf-8"), EXAMPLE)
    repair = _("start with: {command}").format(command="cranktrain textbook --throw example -o throw.toml")
    with problems_as(lambda problem: replace(problem, repair=problem.repair or repair)):
        document = Document.read(source)
    if not parsed(document.text, document.name):
        raise InputError([Problem("", None, _("no throw in it"), repair, Position(document.name))])
    return document


def _show(console: Console, throw: Throw) -> None:
    """Show lengths, reactions, balance, and what is to be minded."""
    width = console.width - INDENT
    found = throw_constituents(throw.lengths, throw.forces)
    section(console, _("The throw"), _throw_lines(throw))
    section(console, _("Loads of the journals on the bearings L and P"), _reaction_lines(found, width))
    section(console, _("Whether the rotating masses, C1 to C15, load the bearings"), _balance_lines(throw, width))
    section(console, _("Mind"), table(("", ""), [("-", one) for one in _notes()], fold=width))
    section(console, _("Source"), [REFERENCES[_SOURCE].text])


def _throw_lines(throw: Throw) -> Iterator[str]:
    """Say what l is, and how many rods there are."""
    rods = {
        "one": _("One rod on the pin, K1 and T1."),
        "two": _("Two rods side by side, K1, T1 and K2, T2."),
        "articulated": _("An articulated pair: one resultant K1, T1 on the master's axis, K2 = T2 = 0."),
    }
    chain = " + ".join(CHAIN)
    yield f"l = {chain} = {number(float(throw_length(throw.lengths)), 'mm')}"
    yield rods[throw.rods]


def _reaction_lines(found: ThrowConstituents, width: int) -> Iterator[str | Text]:
    """Each constituent in a row, all together in the last, and the resultants."""
    whole = throw_reactions(found, is_first=True, is_last=True)
    rows: list[tuple[str, ThrowReactions]] = [
        (_("rotating masses (44) (45) (46) (47)"), found.rotating),
        (_("left external counterweight (48)"), found.first),
        (_("right external counterweight (49)"), found.last),
        (_("K of the rods (50) (52)"), found.normal),
        (_("T of the rods (51) (53)"), found.tangential),
        (_("together"), whole),
    ]
    columns = [
        Column(head, "N", tuple(figure(float(getattr(one, name)), "N") for _label, one in rows))
        for head, name in (("R_KP", "kp"), ("R_TP", "tp"), ("R_KL", "kl"), ("R_TL", "tl"))
    ]
    yield _("K inward, to the axis; T with the rotation, at the crank pin's angle.")
    yield from column_tables(columns, [label for label, _one in rows], width)
    yield ""
    right, left = np.hypot(whole.kp, whole.tp), np.hypot(whole.kl, whole.tl)
    yield _("Resultants: R_P = {right}, R_L = {left}.").format(
        right=number(float(right), "N"), left=number(float(left), "N")
    )


def _balance_lines(throw: Throw, width: int) -> Iterator[str | Text]:
    """Both conditions with what is left over, and what follows."""
    found = balance_conditions(throw.lengths, throw.forces)
    names = {"static": _("static, ΣC = 0"), "dynamic": _("dynamic, ΣCz = 0 about L")}
    rows = [
        (names[one.name], _left(one, one.outward), _left(one, one.against), _("holds") if one.holds else _("does not"))
        for one in found
    ]
    heads = (_("balance"), _("outward"), _("against the rotation"), "")
    yield from table(heads, rows, right=(1, 2))
    yield ""
    if found.hold:
        yield _("Both hold: the rotating masses load no bearing.")
    elif found.static.holds:
        yield _(
            "Static balance alone: the forces are equal and opposite, but a couple is left, and loads both bearings "
            "alike, in opposite directions."
        )
    elif found.dynamic.holds:
        yield _("The resultant passes through L: it alone bears it.")
    else:
        yield _("Neither holds: (44) to (49) say what the bearings bear.")


def _left(one: BalanceCondition, value: float) -> str:
    """Write what is left over; none but rounding as 0."""
    unit = "N" if one.name == "static" else "N*m"
    return number(0.0 if one.holds else value, unit)


def _notes() -> Iterator[str]:
    """What the text leaves open, and how it is read here."""
    yield _(
        "C8, C9, C12, C14, C15 count against the rotation: the text is silent, but only so may (45) be added to (51)"
    )
    yield _("C3 and C5 hold what turns of the rods: K1 and K2 must not hold it again")
    yield _("where external counterweights are moments at the ends of a continuous shaft, (48) and (49) count twice")
    yield _("`cranktrain textbook errata --source crankshaft`: what is wrong in the text and left open by it")
