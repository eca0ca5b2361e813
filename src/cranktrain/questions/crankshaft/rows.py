"""What the crankshaft says in the answer: the largest load of each main bearing, by every method."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.questions.crankshaft.stages import MainBearingLoads
from cranktrain.rows import AnswerLine, Extent, worded
from cranktrain.wording import Names


def bearing_rows(labels: Names, design: int, found: MainBearingLoads) -> Iterator[AnswerLine]:
    """By every method the largest loads, from the bearing that has least to the one that has most."""
    most = found.largest_bearing_load.value[design]
    for method, own in zip(labels["bearing_method"], most, strict=True):
        if not np.all(np.isfinite(own)):
            continue
        worst = labels["bearing"][int(np.argmax(own))]
        yield worded(
            method.replace("_", " "),
            _("{range}, most in bearing {bearing}").format(range="{range}", bearing=worst),
            range=Extent(float(np.min(own)), float(np.max(own)), "N"),
        )
