"""A machine on a page with its numbers, any of which may be set anew: what is asked, and what is sent."""

from collections.abc import Iterator, Sequence
from functools import lru_cache
from pathlib import Path

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.grouping import grouped
from cranktrain.io.added_tables import with_part
from cranktrain.io.machine_file import Input, MachineFile, computed, inputs_of
from cranktrain.io.machine_source import MachineSource, source_called, source_of_text
from cranktrain.io.offers import offered_tables, with_table
from cranktrain.language import Words, _, in_language, languages, spoken_language
from cranktrain.mechanisms.by_hand import Clicked
from cranktrain.one_line import one_line
from cranktrain.panels.additions import DrawnAddition, added_table, drawn_additions
from cranktrain.panels.handles import DrawnHandle, drawn_handles
from cranktrain.paths import PathParts, item_at, parts_of, path_text
from cranktrain.record import record
from cranktrain.saying.names import said_name
from cranktrain.web.asked import MOST_KEPT, Case, ClickedPart, SentMachine
from cranktrain.web.case_words import CaseWords, case_words
from cranktrain.web.exporting import exported
from cranktrain.web.going_on import page_going_on
from cranktrain.web.other_pistons import other_pistons
from cranktrain.web.packed import Packed, packed
from cranktrain.web.page import ShownMachine, machine_page, page_members_of, shown_throw, tab_content, tab_names
from cranktrain.web.whence import page_whence

_MOST_INPUTS = 2000
"""Numbers of which it is kept what is shown; of a machine all but one stay when somebody changes that."""
_MOST_MECHANISMS = 200
"""Of a machine; a thousand take a gigabyte."""


@record
class PageInput:
    """A number of a machine file.

    Attributes
    ----------
    path : str
        In the file.
    name : Words
        What people call it.
    text : str
        As it is typed.
    status, note : str
        How the number came about, and in which sense or from where; nothing where the file does not say.
    """

    path: str
    name: Words
    text: str
    status: str
    note: str


@record
class NumbersOfTable:
    """Numbers of a table of the file, under its name."""

    name: str
    inputs: tuple[PageInput, ...]


@record
class PageLanguage:
    """A language that a page may be in: its code, and what it calls itself."""

    code: str
    name: str


@record
class PageCase:
    """A machine with its numbers.

    Attributes
    ----------
    machine : ShownMachine
    tables : tuple of NumbersOfTable
    varied : str
        Path of the number that is varied first where any may be.
    language : str
        Code of that in which it is.
    languages : tuple of PageLanguage
        All that there are.
    words : CaseWords
    """

    machine: ShownMachine
    tables: tuple[NumbersOfTable, ...]
    varied: str
    language: str
    languages: tuple[PageLanguage, ...]
    words: CaseWords


@record
class PageHandles:
    """Pins of the drawing that may be moved, and parts that may be added by clicks.

    Attributes
    ----------
    handles : tuple of DrawnHandle
    additions : tuple of DrawnAddition
    open : tuple of Words
        Where the links cannot close, and what would let them; none where they close all round.
    """

    handles: tuple[DrawnHandle, ...]
    additions: tuple[DrawnAddition, ...]
    open: tuple[Words, ...]


def packed_page(case: Case, tab: str, beside: Case | None = None, piston: str = "") -> Packed:
    """Compute what a page shows with a tab open, and pack it.

    Parameters
    ----------
    case : Case
    tab : str
        Its name; the first where there is none of it.
    beside : Case, optional
        A saved case that stands beside it.
    piston : str
        Whose throw and curves are shown; the first one's where there is none of that name.

    Returns
    -------
    Packed

    Raises
    ------
    InputError
        With all that is wrong with the machine.
    """
    file, result = _computed(case)
    with result.in_its_units():
        page = machine_page(result, tab, _result_of(beside), piston)
        words = case_words(adds_parts=any(place.kind.additions for place in file.machine.places))
        inputs = inputs_of(file)
        tables = _tables(file, inputs)
        return packed(PageCase(page, tables, _varied_first(inputs), spoken_language(), tuple(_languages()), words))


def packed_tab(case: Case, tab: str, beside: Case | None = None, piston: str = "") -> Packed:
    """Compute what stands on a tab, and pack it; as `packed_page`."""
    _file, result = _computed(case)
    with result.in_its_units():
        return packed(tab_content(result, _tab_of(result, tab), _result_of(beside), piston))


def packed_others(case: Case, tab: str, beside: Case | None = None, piston: str = "") -> Packed:
    """Collect the curves of the pistons that are not chosen on a tab, and pack them; as `packed_page`."""
    _file, result = _computed(case)
    with result.in_its_units():
        return packed(other_pistons(result, _tab_of(result, tab), _result_of(beside), piston))


def packed_trust(case: Case) -> Packed:
    """Compute what is to be minded, all checks, and how one may go on, and pack them; as `packed_page`."""
    file, result = _computed(case)
    with result.in_its_units():
        return packed(page_going_on(file, result))


def packed_members(case: Case, piston: str = "") -> Packed:
    """Find pins and links of what is drawn over the cycle, and pack them; as `packed_page`."""
    _file, result = _computed(case)
    with result.in_its_units():
        return packed(page_members_of(result, piston))


def packed_handles(case: Case, piston: str = "") -> Packed:
    """Find what of the drawing may be moved, and what added to it, and pack it; as `packed_page`."""
    file, _result = _computed(case)
    places = shown_throw(file.machine, piston)
    handles = drawn_handles(file.machine, places, [one.path for one in inputs_of(file)])
    additions = drawn_additions(file.machine, places)
    return packed(PageHandles(handles, additions, tuple(problem.allowed for problem in file.machine.closing_problems)))


def file_text(case: Case, key: str = "", part: ClickedPart | None = None) -> str:
    """Give the machine file with the numbers in place, its comments where they were.

    Parameters
    ----------
    case : Case
    key : str
        Of a table that is to stand in it, too, of those that are offered to the machine.
    part : ClickedPart, optional
        That is to stand in it, too, and nothing else then.

    Raises
    ------
    InputError
        With all that is wrong with the machine; for a table that is not offered, and a part that cannot be.
    """
    if part is not None:
        file, _result = _computed(case)
        clicks = [Clicked(*one) for one in part.clicks]
        return with_part(file.document.text, *added_table(file.machine, part.mechanism, part.name, part.angle, clicks))
    file = machine_file_of(case)
    if not key:
        return file.document.text
    try:
        return with_table(file, key)
    except KeyError:
        names = ", ".join(table.key for table in offered_tables(file))
        raise InputError([Problem("key", key, _("must be one of: {names}", names=names))]) from None


def packed_whence(case: Case, quantity: str) -> Packed:
    """Find where a number is from, and pack it; as `packed_page`."""
    file, result = _computed(case)
    with result.in_its_units():
        return packed(page_whence(file, result, quantity))


def export_of(case: Case, tab: str, suffix: str) -> bytes:
    """Make a file to take away, as `exported` does."""
    return exported(*_computed(case), tab, suffix)


def _tab_of(result: Result, name: str) -> str:
    """Give the name of a tab; of the first where there is none of it."""
    names = tab_names(result)
    return name if name in names else names[0]


def _result_of(case: Case | None) -> Result | None:
    """Compute a saved case, if there is one."""
    return None if case is None else _computed(case)[1]


def _computed(case: Case) -> tuple[MachineFile, Result]:
    """Read and compute; of what a page asks one after the other each part is computed once."""
    return _kept(case, _written(case))


@lru_cache(MOST_KEPT)
def _kept(case: Case, written: int) -> tuple[MachineFile, Result]:
    """Read and compute; quantities are found when they are asked for."""
    file = _read(case, written)
    return file, computed(file, partial=True)


def machine_file_of(case: Case) -> MachineFile:
    """Read a machine: of one that was sent its text, which is never taken for the name of anything."""
    return _read(case, _written(case))


def _written(case: Case) -> int:
    """When the file of a machine was written; 0 of one that is none, which stays as it is. [ns]"""
    file = Path(case.machine) if isinstance(case.machine, str) else None
    return file.stat().st_mtime_ns if file is not None and file.exists() else 0


@lru_cache(MOST_KEPT)
def _source(machine: str | SentMachine, _written: int, _language: str) -> MachineSource:
    """Take a machine file as it is typed: it stays while its numbers are set anew. Its name has words."""
    if isinstance(machine, str):
        return source_called(machine)
    return source_of_text(machine.text, dict(machine.files))


def _read(case: Case, written: int) -> MachineFile:
    """Read a machine of a file that was written at some time."""
    file = _source(case.machine, written, spoken_language()).with_set(case.settings, partial=True)
    n_mechanisms = len(file.machine.places)
    if n_mechanisms > _MOST_MECHANISMS:
        allowed = _("has {n} mechanisms; a page shows at most {limit}", n=n_mechanisms, limit=_MOST_MECHANISMS)
        raise InputError([Problem("", None, allowed, _("ask for its answer with `cranktrain run`"))])
    return file


def _languages() -> Iterator[PageLanguage]:
    """Give the languages, each under its own name: each translates "English" by what it is called itself."""
    for code in languages():
        with in_language(code):
            name = str(_("English"))
        yield PageLanguage(code, name)


def _tables(file: MachineFile, inputs: Sequence[Input]) -> tuple[NumbersOfTable, ...]:
    """Give the numbers of a file, table by table."""
    tables = grouped((_table_of(one.path), one) for one in inputs)
    return tuple(
        NumbersOfTable(_table_name(file, above), tuple(map(_page_input, own))) for above, own in tables.items()
    )


@lru_cache(_MOST_INPUTS)
def _table_of(path: str) -> PathParts:
    """Find the table in which a number stands: above its key, or the key of its list."""
    parts = parts_of(path)
    return parts[: max((place for place, part in enumerate(parts) if isinstance(part, str)), default=0)]


def _varied_first(inputs: Sequence[Input]) -> str:
    """Path of a number on which much depends: of the first in the table of a mechanism that is not 0."""
    given = [one.path for one in inputs if one.given.si != 0.0]
    return next((path for path in given if "mechanism" in parts_of(path)), given[0] if given else "")


def _table_name(file: MachineFile, above: PathParts) -> str:
    """Name a table by its path, with the name that it has in the file beside where it has one."""
    called = item_at(file.document.data, (*above, "name")) if above else None
    path = f"[{path_text(above)}]" if above else ""
    return f"{path} {called}" if isinstance(called, str) else path


@lru_cache(_MOST_INPUTS)
def _page_input(one: Input) -> PageInput:
    """Give a number with what is known of it."""
    *_above, last = parts_of(one.path)
    name = said_name(last) if isinstance(last, str) else f"{said_name(str(_above[-1]))} {last + 1}"
    note = "; ".join(one_line(words) for words in (one.given.note, one.given.source) if words)
    return PageInput(one.path, name, one_line(one.given.text), one.given.status or "", note)
