"""`--why`: where a printed number is from: its quantity, its equation, the stages and the inputs behind it."""

from collections.abc import Iterable, Iterator

from cranktrain.analysis.result_sections import number_sections
from cranktrain.cli.screen.sections import show_page
from cranktrain.errors import InputError, Problem
from cranktrain.io.input_sections import input_section, inputs_behind
from cranktrain.io.machine_file import MachineFile
from cranktrain.language import Words
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.quantities import nearest
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.names import spelled
from cranktrain.saying.run import BehindQuantity, Run
from cranktrain.saying.sections import PagePart, section

_NAMED = 6
"""Other quantities that the words fit."""


def refuse_beside(words: str | None, others: Iterable[object]) -> None:
    """Refuse whatever else is to be shown or written where it is asked why."""
    if words is not None and any(others):
        repair = _("leave -o, --at, --table and options of what is shown out")
        raise InputError([Problem("--why", words, _("is shown alone"), repair)])


def show_why(head: str, run: Run, words: str, file: MachineFile | None = None) -> None:
    """Show where a number is from; of a machine with what it rests on in its file."""
    show_page(head, _why(run, words, file))


def _why(run: Run, words: str, file: MachineFile | None) -> Iterator[PagePart]:
    """The quantities that words mean: their numbers, where the first is from, what it rests on."""
    meant, others = quantities_called(words, run)
    entry, *beside = meant
    yield from number_sections(run, [one.name for one in meant], is_all=False)
    found = run.behind(entry.name)
    yield from section(_("Where it is from"), _origin(entry, found, [*beside, *others], run))
    if file is not None and found is not None:
        yield from input_section(list(inputs_behind(file, found)))


def quantities_called(words: str, run: Run) -> tuple[list[Entry], list[Entry]]:
    """Quantities that words mean, and others that they may mean.

    A quantity by its own name; those that lines of the answer tell which are called so; else one by words in its name,
    or by its symbol.
    """
    catalogue, asked = run.catalogue, spelled(words).lower().split()
    fitting = [entry for entry in catalogue.values() if set(asked) <= set(entry.words.lower().split())] if asked else []
    by_symbol = [entry for entry in catalogue.values() if entry.symbol == words.strip()]
    fitting = sorted(fitting, key=lambda entry: len(entry.words.split())) + by_symbol
    meant = [catalogue[words]] if words in catalogue else _of_line(words, run) or fitting[:1]
    if not meant:
        near = nearest("_".join(asked), list(catalogue))
        allowed = _("must be words in the name of a result, or its symbol; `cranktrain list results` names all")
        raise InputError([Problem("--why", words, allowed, _('write "{text}"', text=near) if near else None)])
    return meant, [entry for entry in fitting if entry not in meant]


def _of_line(words: str, run: Run) -> list[Entry]:
    """What the lines of the answer tell that are called so."""
    asked = " ".join(words.split()).lower()
    each = (row for _title, rows in run.answer_rows() for row in rows)
    called = (row for row in each if one_line(str(row.name)).lower() == asked)
    names = dict.fromkeys(name for row in called for name in row.quantities)
    return [run.catalogue[name] for name in names if name in run.catalogue]


def _origin(entry: Entry, found: BehindQuantity | None, others: list[Entry], run: Run) -> Iterator[Words]:
    """What a quantity is, its equation, in symbols where it is a line of others, and the stages that lead to it."""
    yield from run.why(entry.name)
    if found is not None:
        yield _("Stages: {stages}", stages=" → ".join(found.stages))
        yield from [found.more] if found.more else []
    if others:
        named = [other.name for other in others[:_NAMED]] + (["…"] if len(others) > _NAMED else [])
        yield _("The words fit these, too: {names}", names=", ".join(named))
