"""Below the answer: how far it can be trusted, and what to ask next."""

import shlex
import textwrap
from collections.abc import Iterator, Sequence

import numpy as np
from rich.cells import cell_len

from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis import Missing, Result
from cranktrain.cli.screen.amounts import filled
from cranktrain.io.description import counted_by_status
from cranktrain.io.machine_file import MachineFile, inputs_of
from cranktrain.language import _
from cranktrain.rows import Amount
from cranktrain.textbook.comparison import TextbookMotion

_MOST_NEEDS, _MOST_OFFERS = 2, 3
_GAP = "   "


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
    offers = list(_offers(result.missing))
    label = _("Next: ")
    ends = _("--full everything · plot {file} -o sheet.pdf · -o curves.csv").format(file=typed)
    lines = [" · ".join(offers), ends] if offers else [ends]
    for i, line in enumerate(lines):
        yield from textwrap.wrap(
            line,
            width,
            initial_indent=label if i == 0 else " " * len(label),
            subsequent_indent=" " * len(label),
            break_on_hyphens=False,
            break_long_words=False,
        )


def _with_end(text: str, end: str, width: int) -> Iterator[str]:
    """Put what to type for more behind a text, or below where there is no room."""
    if cell_len(text) + len(_GAP) + cell_len(end) <= width:
        yield f"{text}{_GAP}{end}"
    else:
        yield from textwrap.wrap(text, width, break_on_hyphens=False)
        yield f"  {end}"


def _textbook(result: Result) -> str:
    """Say how far the forms that textbooks use most are off in acceleration, of masters and of slaves."""
    found = result.get(TextbookMotion)
    if found is None:
        return ""
    errors = found.acceleration_error.value[0]
    said: list[str] = []
    for method, words in (("two_harmonics", _("two harmonics {off}")), ("reconstructed", _("(I.13) of slaves {off}"))):
        own = errors[result.labels["method"].index(method)]
        if np.any(np.isfinite(own)):
            said.append(filled(words, {"off": Amount(float(np.nanmax(own)), "error")}))
    return _("Textbook forms are off by up to: {forms}").format(forms=", ".join(said)) if said else ""


def _checks(result: Result) -> str:
    """Count the checks that hold, that do not, and that cannot be judged."""
    judged = [check for check in result.checks if check.judged[0]]
    failed = sum(not check.passed[0] for check in judged)
    left = len(result.checks) - len(judged)
    if failed:
        said = _("✗ {failed} of {n} checks do not hold").format(failed=failed, n=len(judged))
    elif len(judged) == 1:
        said = _("✓ 1 check holds")
    else:
        said = _("✓ {n} checks hold").format(n=len(judged)) if judged else _("– no check")
    return _("{said}, {left} not judged").format(said=said, left=left) if left else said


def _inputs(file: MachineFile) -> str:
    """Count the numbers of the file, and those that nobody measured."""
    inputs = inputs_of(file)
    soft = [one.given for one in inputs if one.given.status in ("assumed", "fitted")]
    if soft:
        return _("{n} inputs, of which {counted}").format(n=len(inputs), counted=counted_by_status(soft))
    return _("{n} inputs: {counted}").format(n=len(inputs), counted=counted_by_status(one.given for one in inputs))


def _offers(missing: Sequence[Missing]) -> Iterator[str]:
    """Say what the file could say next and what that gives: what needs least first."""
    offers = [(name, words) for question in QUESTIONS for name, words in question.offers.items()]
    found = [
        (one.needs, _(words))
        for name, words in offers
        for one in missing
        if name in one.results and len(one.needs) <= _MOST_NEEDS
    ]
    ranked = dict(sorted(found, key=lambda one: len(one[0])))
    for needs, words in list(ranked.items())[:_MOST_OFFERS]:
        yield f"{_(' and ').join(needs)} {words}"
