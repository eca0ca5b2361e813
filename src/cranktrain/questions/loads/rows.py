"""What loads say in the answer: work and power, and how large they are at most."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import _
from cranktrain.numerics import Peak
from cranktrain.questions.loads.load_work import LoadWork
from cranktrain.rows import Amount, AnswerLine, valued
from cranktrain.wording import Names


def load_rows(labels: Names, design: int, work: LoadWork) -> Iterator[AnswerLine]:
    """Work and power of every load: less than 0 where the machine works against it; largest force or torque."""
    names = labels["load"]
    yield valued(_("work in a cycle"), work.load_work[design], "J", names)
    yield valued(_("mean power"), work.mean_load_power[design], "W", names)
    yield valued(_("largest power"), work.largest_load_power.value[design], "W", names)
    yield _largest(_("largest force"), work.largest_load_force, "N", names, design)
    yield _largest(_("largest torque"), work.largest_load_moment, "N*m", names, design)


def _largest(name: str, peak: Peak, unit: str, names: Sequence[str], design: int) -> AnswerLine:
    """Largest size of every load of a sort, of one alone also where."""
    value, angle = peak.value[design], peak.angle[design]
    if len(names) > 1 or not np.isfinite(angle[0]):
        return valued(name, value, unit, names)
    return valued(name, value, unit, names, _("at {angle}"), angle=Amount(float(angle[0]), "position"))
