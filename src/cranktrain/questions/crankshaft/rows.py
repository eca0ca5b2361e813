"""What the crankshaft says in the answer: the largest load of a main bearing, by every method."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import N_, _
from cranktrain.questions.crankshaft.stages import MainBearingLoads
from cranktrain.rows import Amount, AnswerLine, worded
from cranktrain.wording import Names

_ROWS = (
    (N_("on elastic bearings"), "frame_elastic", "five_moment"),
    (N_("on rigid bearings"), "frame_rigid", "three_moment"),
    (N_("split at bearings"), "split", ""),
    (N_("with clearance"), "clearance", ""),
)
"""What the bearings are taken for; the method for that, and what stands beside it."""


def bearing_rows(labels: Names, design: int, found: MainBearingLoads) -> Iterator[AnswerLine]:
    """The largest load and where it is, of the crank frame; of the straight shaft beside it."""
    methods, bearings = labels["bearing_method"], labels["bearing"]
    most = dict(zip(methods, found.largest_bearing_load.value[design], strict=True))
    for name, method, beside in _ROWS:
        own = most.get(method)
        if own is None or not np.all(np.isfinite(own)):
            continue
        pieces = {"load": Amount(float(np.max(own)), "N"), "bearing": bearings[int(np.argmax(own))]}
        said = _("{load} in bearing {bearing}")
        if beside:
            said = _("{load} in bearing {bearing}; a straight shaft {other}")
            pieces["other"] = Amount(float(np.max(most[beside])), "N")
        yield worded(_(name), said, **pieces)
