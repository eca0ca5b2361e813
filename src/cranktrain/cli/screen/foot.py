"""Below the answer: how far it can be trusted, and what to ask next."""

import shlex
from collections.abc import Iterator

from rich.cells import cell_len

from cranktrain.analysis import Result
from cranktrain.cli.screen.text import folded
from cranktrain.io.asked_next import next_words
from cranktrain.io.machine_file import MachineFile, inputs_of
from cranktrain.io.rests_on import inputs_counted, textbook_words
from cranktrain.language import said as _
from cranktrain.saying.typesetting import KEPT

_GAP, _BETWEEN = "   ", " · "


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
    book = textbook_words(result)
    if book:
        yield from _with_end(book, f"cranktrain textbook {typed}", width)
    yield from _with_end(f"{_checks(result)} · {inputs_counted(inputs_of(file))}", "--checks --inputs", width)
    label = _("Next: ")
    offers = ""
    for offer in next_words(file.machine, result.worth_asking):
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
