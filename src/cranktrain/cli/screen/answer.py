"""The answer on one screen: what it is, what to mind, the questions' rows, how far it can be trusted, what next."""

from collections.abc import Iterator

from rich.text import Text

from cranktrain.analysis import Result
from cranktrain.cli.screen.foot import foot_lines
from cranktrain.cli.screen.groups import RowGroup, group_lines
from cranktrain.cli.screen.minded import minded_lines
from cranktrain.cli.screen.text import folded
from cranktrain.cli.screen.title import title_lines
from cranktrain.cli.screen.typesetting import typeset
from cranktrain.io.machine_file import MachineFile
from cranktrain.layout.speed_curve import SpeedCurve
from cranktrain.one_line import visible


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
    first, *more = title_lines(result, width)
    blocks = (
        [Text(first, style="bold"), *map(Text, more), *map(Text, _conditions(result, width))],
        map(Text, minded_lines(result, width)),
        group_lines([RowGroup(title, rows) for title, rows in result.rows()], width),
        (Text(visible(line)) for line in foot_lines(file, result, name, width)),
    )
    for number, block in enumerate(blocks):
        lines = list(block)
        if lines and number:
            yield Text()
        yield from lines


def _conditions(result: Result, width: int) -> Iterator[str]:
    """Say at which speed all this is, where it varies."""
    curve = result.get(SpeedCurve)
    if curve is not None:
        yield from folded(typeset(curve.answer(result.labels, 0)), width)
