"""A machine on a page with its numbers, any of which may be set anew: what is asked, and what is sent."""

from cranktrain.io.description import units_of
from cranktrain.io.machine_file import Input, MachineFile, computed, inputs_of, read_machine
from cranktrain.language import Words, _
from cranktrain.one_line import one_line
from cranktrain.paths import parts_of
from cranktrain.quantities import shown_as_in
from cranktrain.record import record
from cranktrain.saying.names import said_name
from cranktrain.web.packed import Packed, packed
from cranktrain.web.page import ShownMachine, machine_page


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
class CaseWords:
    """Words of a page on which numbers may be changed."""

    machine: Words
    numbers: Words
    undo: Words
    redo: Words
    save: Words
    as_in_file: Words


@record
class PageCase:
    """A machine with its numbers.

    Attributes
    ----------
    machine : ShownMachine
    tables : tuple of NumbersOfTable
    words : CaseWords
    """

    machine: ShownMachine
    tables: tuple[NumbersOfTable, ...]
    words: CaseWords


def packed_case(source: str, settings: tuple[str, ...]) -> Packed:
    """Compute a machine with some numbers set anew, and pack all that a page shows of it.

    Parameters
    ----------
    source : str
        A machine file, or the name of an example.
    settings : tuple of str
        As `read_machine` takes them.

    Raises
    ------
    InputError
        With all that is wrong.
    """
    file = read_machine(source, settings, partial=True)
    with shown_as_in(units_of(file.machine)):
        return packed(PageCase(machine_page(computed(file, partial=True)), _tables(file), _case_words()))


def _case_words() -> CaseWords:
    """Give them."""
    return CaseWords(
        machine=_("Machine"),
        numbers=_("Numbers of the file"),
        undo=_("Undo"),
        redo=_("Redo"),
        save=_("Save the machine file"),
        as_in_file=_("As in the file"),
    )


def text_of_case(source: str, settings: tuple[str, ...]) -> str:
    """Give the machine file with some numbers set anew, its comments where they were.

    Raises
    ------
    InputError
        With all that is wrong.
    """
    return read_machine(source, settings, partial=True).document.text


def _tables(file: MachineFile) -> tuple[NumbersOfTable, ...]:
    """Give the numbers of a file, table by table."""
    tables: dict[str, list[Input]] = {}
    for one in inputs_of(file):
        tables.setdefault(_table_of(one.path), []).append(one)
    return tuple(NumbersOfTable(name, tuple(map(_page_input, inputs))) for name, inputs in tables.items())


def _table_of(path: str) -> str:
    """Name the table in which a number stands, as the file does."""
    names = [str(part) for part in parts_of(path) if isinstance(part, str)]
    return f"[{'.'.join(names[:-1])}]" if len(names) > 1 else ""


def _page_input(one: Input) -> PageInput:
    """Give a number with what is known of it."""
    *_above, last = parts_of(one.path)
    name = said_name(last) if isinstance(last, str) else f"{said_name(str(_above[-1]))} {last + 1}"
    note = "; ".join(one_line(words) for words in (one.given.note, one.given.source) if words)
    return PageInput(one.path, name, one_line(one.given.text), one.given.status or "", note)
