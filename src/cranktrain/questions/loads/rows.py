"""What loads say in the answer: the work of a cycle and the largest power."""

from collections.abc import Iterator

from cranktrain.language import _
from cranktrain.questions.loads.load_work import LoadWork
from cranktrain.rows import AnswerLine, valued
from cranktrain.wording import Names


def load_rows(labels: Names, design: int, work: LoadWork) -> Iterator[AnswerLine]:
    """Work and power of every load: less than 0 where the machine works against it."""
    names = labels["load"]
    yield valued(_("work in a cycle"), work.load_work[design], "J", names)
    yield valued(_("largest power"), work.largest_load_power.value[design], "W", names)
