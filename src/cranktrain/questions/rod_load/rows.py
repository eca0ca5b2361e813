"""What rod loads say in the answer: the largest in compression and in tension, and for how long they reverse."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.rod_load.limits import RodLoadUse
from cranktrain.questions.rod_load.loads import CROSSHEAD_PIN, RodLoads
from cranktrain.questions.rod_load.reversal import Reversals
from cranktrain.saying.rows import AnswerLine, Telling


def rod_load_rows(of: Telling, loads: RodLoads, reversals: Reversals, use: RodLoadUse | None) -> Iterator[AnswerLine]:
    """At the crosshead pin: of one piston in a line what it bears, of several a line each."""
    pin = CROSSHEAD_PIN
    if len(of.labels["piston"]) == 1:
        words = _("{values}, tension {tension}", tension=of.amount(loads, "largest_rod_tension", pin, 0))
        yield of.row(_("rod load"), loads, "largest_rod_compression", words, at=(pin,))
        ends = (of.amount(reversals, name, pin, 0) for name in ("tension_begins", "tension_ends"))
        words = _("{values}, from {begins} to {ends}", **dict(zip(("begins", "ends"), ends, strict=True)))
        yield of.row(_("in tension for"), reversals, "tension_arc", words, at=(pin,))
    else:
        yield of.row(_("rod load, compression"), loads, "largest_rod_compression", at=(pin,))
        yield of.row(_("rod load, tension"), loads, "largest_rod_tension", at=(pin,))
        yield of.row(_("in tension for"), reversals, "tension_arc", at=(pin,))
    if use is not None:
        yield from _of_limits(of, use)


def _of_limits(of: Telling, use: RodLoadUse) -> Iterator[AnswerLine]:
    """What the loads take of the frame's limits, where that is most."""
    values = of.values(use, "rod_load_use")
    limit, piston = divmod(first_largest(np.nan_to_num(values)), values.shape[-1])
    words = _("{values} by the {load}") if values.shape[-1] == 1 else _("{values} by the {load} of {piston}")
    said = words.format(load=of.titles["frame_limit"][limit], piston=of.labels["piston"][piston])
    yield of.row(_("frame is used to"), use, "rod_load_use", said, at=(limit,), own=[piston], unit="%")
