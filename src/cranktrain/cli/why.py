"""`run --why`: where a printed number is from: its quantity, its equation, the stages and the inputs behind it."""

from collections.abc import Iterator

from rich.text import Text

from cranktrain.analysis import Result
from cranktrain.analysis.behind import behind
from cranktrain.analysis.pipeline import Pipeline
from cranktrain.cli.screen.report import input_table, show_numbers
from cranktrain.cli.screen.text import INDENT, page, section
from cranktrain.cli.screen.title import title
from cranktrain.errors import InputError, Problem
from cranktrain.io.machine_file import Input, MachineFile, inputs_of
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.quantities import nearest
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.names import spelled

_NAMED = 6
"""Other quantities that the words fit."""
_OF_A_BANK = 2
"""Keys in the path of a bank, of which nothing below is its own."""


def show_why(file: MachineFile, result: Result, words: str) -> None:
    """Show where a number is from."""
    meant, others = quantities_called(words, result)
    entry, *beside = meant
    found = behind(entry.name, file.machine)
    with page(title(file.machine)) as console:
        show_numbers(console, result, [one.name for one in meant], is_all=False)
        section(console, _("Where it is from"), _origin(entry, found, [*beside, *others], result))
        inputs = list(_inputs(file, found))
        section(console, _("What this rests on"), input_table(inputs, console.width - INDENT))


def quantities_called(words: str, result: Result) -> tuple[list[Entry], list[Entry]]:
    """Quantities that words mean, and others that they may mean.

    A quantity by its own name; those that lines of the answer tell which are called so; else one by words in its name,
    or by its symbol.
    """
    catalogue, asked = result.catalogue, spelled(words).lower().split()
    fitting = [entry for entry in catalogue.values() if set(asked) <= set(entry.words.lower().split())] if asked else []
    by_symbol = [entry for entry in catalogue.values() if entry.symbol == words.strip()]
    fitting = sorted(fitting, key=lambda entry: len(entry.words.split())) + by_symbol
    meant = [catalogue[words]] if words in catalogue else _of_line(words, result) or fitting[:1]
    if not meant:
        near = nearest("_".join(asked), list(catalogue))
        allowed = _("must be words in the name of a result, or its symbol; `cranktrain list results` names all")
        raise InputError([Problem("--why", words, allowed, _('write "{text}"', text=near) if near else None)])
    return meant, [entry for entry in fitting if entry not in meant]


def _of_line(words: str, result: Result) -> list[Entry]:
    """What the lines of the answer tell that are called so."""
    asked = " ".join(words.split()).lower()
    called = (row for _title, rows in result.rows() for row in rows if one_line(str(row.name)).lower() == asked)
    names = dict.fromkeys(name for row in called for name in row.quantities)
    return [result.catalogue[name] for name in names if name in result.catalogue]


def _origin(entry: Entry, found: Pipeline, others: list[Entry], result: Result) -> Iterator[str | Text]:
    """What a quantity is, its equation, in symbols where it is a line of others, and the stages that lead to it."""
    yield from map(str, result.why(entry.name))
    yield _("Stages: {stages}", stages=" → ".join(stage.name for stage in found.stages))
    yield _("More: cranktrain list results --behind {name}", name=entry.name)
    if others:
        named = [other.name for other in others[:_NAMED]] + (["…"] if len(others) > _NAMED else [])
        yield _("The words fit these, too: {names}", names=", ".join(named))


def _inputs(file: MachineFile, found: Pipeline) -> Iterator[Input]:
    """Numbers of the file in the tables that are read on the way."""
    read = {table.strip("[]") for part in found.declared for table in part.tables}
    for one in inputs_of(file):
        path = one.path.partition("[")[0].split(".")
        above = [".".join(path[:length]) for length in range(1, len(path) + 1)]
        # Of a bank or a shaft its own keys; of what else has a name all that stands in it.
        own = above if path[0] not in ("bank", "shaft") else [above[-2], *above[_OF_A_BANK:]]
        if not read.isdisjoint(own):
            yield one
