"""Below the answer: how far it can be trusted, and what to ask next."""

import shlex
from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from rich.cells import cell_len

from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis import Missing, Result
from cranktrain.analysis.unasked import unasked
from cranktrain.cli.screen.text import folded
from cranktrain.io.description import counted_by_status
from cranktrain.io.machine_file import MachineFile, inputs_of
from cranktrain.language import N_, Words
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.saying.amounts import Amount
from cranktrain.saying.typesetting import KEPT
from cranktrain.saying.wording import all_of
from cranktrain.texts.comparison import TextbookMotion

_MOST_NEEDS, _MOST_OFFERS = 2, 3
_GAP, _BETWEEN = "   ", " · "
_ALL = {
    "published": N_("{n} inputs, all published"),
    "derived": N_("{n} inputs, all derived"),
    "assumed": N_("{n} inputs, all assumed"),
    "fitted": N_("{n} inputs, all fitted"),
    None: N_("{n} inputs without a status"),
}


def foot_lines(file: MachineFile, result: Result, name: str, width: int) -> Iterator[str]:
    """Lay out textbook forms, checks, inputs and what to ask next.

    Parameters
    ----------
    file : MachineFile
    result : Result
    name : str
        Of the file, as typed.
    width : int
        Columns of the screen.
    """
    typed = shlex.quote(name)
    book = _textbook(result)
    if book:
        yield from _with_end(book, f"cranktrain textbook {typed}", width)
    yield from _with_end(f"{_checks(result)} · {_inputs(file)}", "--checks --inputs", width)
    label = _("Next: ")
    offers = ""
    for offer in _offers(file, result.worth_asking):
        longer = f"{offers}{_BETWEEN if offers else ''}{offer}"
        offers = longer if cell_len(label + longer) <= width else offers
    surfaces = _BETWEEN.join(
        one.replace(" ", KEPT) for one in (_("--full everything"), f"plot {typed} -o sheet.pdf", "-o curves.csv")
    )
    for i, line in enumerate([offers, surfaces] if offers else [surfaces]):
        yield from folded(line, width, label if i == 0 else " " * len(label), " " * len(label))


def _with_end(text: str, end: str, width: int) -> Iterator[str]:
    """Put what to type for more behind a text, or below where there is no room."""
    if cell_len(text) + len(_GAP) + cell_len(end) <= width:
        yield f"{text}{_GAP}{end}".replace(KEPT, " ")
    else:
        yield from folded(text, width)
        yield f"  {end}"


def _textbook(result: Result) -> str:
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


def _checks(result: Result) -> str:
    """Count the checks that hold, that do not, and that cannot be judged."""
    judged = [check for check in result.checks if check.judged[0]]
    failed = sum(not check.passed[0] for check in judged)
    left = len(result.checks) - len(judged)
    if failed:
        said = _("✗ {failed} of {n} checks do not hold", failed=failed, n=len(judged))
    elif len(judged) == 1:
        said = _("✓ 1 check holds")
    else:
        said = _("✓ {n} checks hold", n=len(judged)) if judged else _("– no check")
    return _("{said}, {left} not judged", said=said, left=left) if left else said


def _inputs(file: MachineFile) -> str:
    """Count the numbers of the file, and those that nobody measured."""
    inputs = inputs_of(file)
    soft = [one.given for one in inputs if one.given.status in ("assumed", "fitted")]
    if len({one.given.status for one in inputs}) == 1:
        return _(_ALL[inputs[0].given.status], n=len(inputs))
    if soft:
        return _("{n} inputs, of which {counted}", n=len(inputs), counted=counted_by_status(soft))
    return _("{n} inputs: {counted}", n=len(inputs), counted=counted_by_status(one.given for one in inputs))


def _offers(file: MachineFile, missing: Sequence[Missing]) -> Iterator[str]:
    """Say what the file could say next and what that gives: what needs least first, then what a question offers first.

    Where several keys are missing, only of a table that the file has: a press is not asked for a compression ratio.
    What no table can say, as that there be a rod, is not asked for.
    """
    ranked = sorted(
        (len(one.needs), rank, -place if rank else place, tuple(map(str, one.needs)), words)
        for place, name in enumerate(QUESTIONS.names)
        for rank, (quantity, words) in enumerate(_offered(file.machine, name).items())
        for one in missing
        if quantity in one.results and len(one.needs) <= _MOST_NEEDS and all(map(_is_table, one.needs))
    )
    first: dict[tuple[str, ...], str] = {}
    for n_needs, _rank, _place, needs, words in ranked:
        is_more = any(set(needs) > set(fewer) for fewer in first)
        if n_needs == 1 or (not is_more and all(_has_table(file, need) for need in needs)):
            first.setdefault(needs, words)
    for needs, words in list(first.items())[:_MOST_OFFERS]:
        yield f"{all_of(list(map(_shortly, needs)))} {_(words)}".replace(" ", KEPT)


def _offered(machine: Machine, question: str) -> Mapping[str, str]:
    """What a question gives to those who ask next, whether this machine's file asks it or not."""
    return (QUESTIONS.named(question) if question in machine.asks else unasked(question)).offers


def _has_table(file: MachineFile, need: str) -> bool:
    """Whether the table of a key is in the file; one that is missing as a whole has no key."""
    table, _bracket, key = need.removeprefix("[").partition("]")
    return not key or table.partition(".")[0] in file.document.data


def _is_table(need: Words) -> bool:
    """Whether a need is a table of the file, or keys of one."""
    return str(need).startswith("[")


def _shortly(need: str) -> str:
    """Give a table with its one key; of several keys the table, of alternatives the first."""
    table, key = need.partition("] ")[::2]
    return f"{table.removesuffix(']')}]" if not key or "," in key else f"{table}] {key.partition(' ')[0]}"
