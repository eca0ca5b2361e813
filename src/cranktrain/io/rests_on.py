"""What an answer rests on, in a line: numbers of the file, equations, how far textbooks are off."""

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.analysis.behind import tables_behind
from cranktrain.grouping import grouped
from cranktrain.io.description import counted_by_status
from cranktrain.io.input_sections import inputs_in
from cranktrain.io.machine_file import Input, inputs_of_machine
from cranktrain.language import N_
from cranktrain.language import said as _
from cranktrain.saying.amounts import Amount
from cranktrain.saying.catalogue import cited
from cranktrain.saying.rows import AnswerLine
from cranktrain.texts.comparison import TextbookMotion

_ALL = {
    "published": N_("{n} inputs, all published"),
    "derived": N_("{n} inputs, all derived"),
    "assumed": N_("{n} inputs, all assumed"),
    "fitted": N_("{n} inputs, all fitted"),
    None: N_("{n} inputs without a status"),
}
_BETWEEN = " · "


def rests_on(result: Result, title: str, rows: Iterable[AnswerLine]) -> str:
    """Say what rows under a title rest on; nothing of none.

    Parameters
    ----------
    result : Result
    title : str
        Of questions.
    rows : iterable of AnswerLine
        Those that say most there.
    """
    told = [name for row in rows for name in row.quantities]
    quantities = [name for name in dict.fromkeys(told) if name in result.catalogue]
    return _BETWEEN.join(_pieces(result, title, quantities)) if quantities else ""


def _pieces(result: Result, title: str, quantities: Sequence[str]) -> Iterator[str]:
    """Say on which numbers and equations quantities rest, and under the first title how far textbooks are off."""
    machine = result.machines[0]
    tables = tables_behind(machine, result.computed.kinds, quantities)
    inputs = tuple(inputs_in(inputs_of_machine(machine), tables))
    if inputs:
        yield _("Rests on {inputs}", inputs=inputs_counted(inputs))
    entries = [result.catalogue[name] for name in quantities]
    pages = grouped((entry.source, number) for entry in entries for number in entry.numbers.split(", "))
    for page, numbers in pages.items():
        yield cited(page, ", ".join(dict.fromkeys(filter(None, numbers))))
    if title == machine.questions[0].title and (book := textbook_words(result)):
        yield book


def textbook_words(result: Result) -> str:
    """Say how far the forms that textbooks use most are off in acceleration, of masters and of slaves."""
    found = result.get(TextbookMotion)
    if found is None:
        return ""
    errors = found.acceleration_error.value[0]
    said: list[str] = []
    for method, words in (("two_harmonics", N_("up to {off} off")), ("reconstructed", N_("of slaves {off}"))):
        own = errors[result.labels["motion_method"].index(method)]
        if np.any(np.isfinite(own)):
            said.append(_(words, off=Amount(float(np.nanmax(own)), "error")))
    return _("Textbook forms: {forms}", forms=", ".join(said)) if said else ""


def inputs_counted(inputs: Sequence[Input]) -> str:
    """Count numbers of a file, and those that nobody measured."""
    soft = [one.given for one in inputs if one.given.status in ("assumed", "fitted")]
    if len({one.given.status for one in inputs}) == 1:
        return _(_ALL[inputs[0].given.status], n=len(inputs))
    if soft:
        return _("{n} inputs, of which {counted}", n=len(inputs), counted=counted_by_status(soft))
    return _("{n} inputs: {counted}", n=len(inputs), counted=counted_by_status(one.given for one in inputs))
