"""The answer on one screen: what it is, what to mind, the questions' rows, how far it can be trusted, what next."""

from collections.abc import Iterator, Sequence

from rich.text import Text

from cranktrain.analysis import Result
from cranktrain.analysis.minded import to_mind
from cranktrain.cli.screen.foot import foot_lines
from cranktrain.cli.screen.groups import group_lines
from cranktrain.cli.screen.text import folded
from cranktrain.grouping import grouped
from cranktrain.io.machine_file import MachineFile
from cranktrain.io.title import headed
from cranktrain.language import said as _
from cranktrain.layout.speed import SpeedCurve
from cranktrain.one_line import visible
from cranktrain.saying.typesetting import typeset

_MOST_LINES = 3
"""Of one flag; `--full` has the rest."""
MARK = "! "
"""Before what is to be minded."""


def answer_lines(file: MachineFile, result: Result, name: str, width: int) -> Iterator[Text]:
    """Lay out the answer.

    Parameters
    ----------
    file : MachineFile
    result : Result
        Of one machine.
    name : str
        Of the file, as typed.
    width : int
        Columns of the screen.

    Yields
    ------
    Text
        Lines.
    """
    first, *more = [line for part in headed(result) if part for line in folded(part, width)]
    blocks = (
        [Text(first, style="bold"), *map(Text, more), *map(Text, conditions(result, width))],
        map(Text, minded_lines(result, width)),
        group_lines(tuple(result.answer_rows()), width),
        (Text(visible(line)) for line in foot_lines(file, result, name, width)),
    )
    for number, block in enumerate(blocks):
        lines = list(block)
        if lines and number:
            yield Text()
        yield from lines


def conditions(result: Result, width: int) -> Iterator[str]:
    """Say at which speed all this is, where it varies."""
    curve = result.get(SpeedCurve)
    if curve is not None:
        yield from folded(typeset(str(curve.condition(0))), width)


def minded(result: Result) -> list[str]:
    """Give sentences to mind, those that say the same of several in one."""
    unused, failed, flags = to_mind(result)
    return [*map(str, (*unused, *failed)), *joined(list(map(str, flags)))]


def joined(flags: Sequence[str]) -> Iterator[str]:
    """Join flags that say the same of several: what they have in common stands for all.

    Examples
    --------
    >>> list(joined(["Far off: 1L; 3L.", "Near.", "Far off: 2L."]))
    ['Far off … (--full)', 'Near.']
    """
    for head, ends in grouped((one.partition(": ")[0], one) for one in flags).items():
        yield ends[0] if len(ends) == 1 else _of_several(head)


def _of_several(said: str) -> str:
    """What flags of several have in common, before their list."""
    return _("{said} … (--full)", said=said.partition(": ")[0])


def minded_lines(result: Result, width: int) -> Iterator[str]:
    """Lay them out, each behind a mark, in a width of columns."""
    for sentence in minded(result):
        said = typeset(visible(sentence))
        lines = folded(said, width, MARK, " " * len(MARK))
        if len(lines) >= _MOST_LINES and "; " in said:  # a list
            lines = folded(_of_several(said), width, MARK, " " * len(MARK))
        if len(lines) > _MOST_LINES:
            lines = folded(said, width, MARK, " " * len(MARK), at_most=_MOST_LINES)
        yield from lines
