"""Torques at speeds, as lists of a motor's table: their arrays, and what is wrong with them."""

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.quantities import Given


def points(listed: tuple[Given, ...]) -> Array:
    """Numbers of a list, shape (point, design), of one design (point, 1)."""
    return np.stack(np.broadcast_arrays(*(np.atleast_1d(one.array) for one in listed)))


def curve_problems(speeds: tuple[Given, ...], torques: tuple[Given, ...], path: str = "") -> Iterator[Problem]:
    """Find speeds that do not rise, torques that are not as many, and a motor that never drives."""
    if len(torques) != len(speeds):
        allowed = _("must be as many as speeds, {n}").format(n=len(speeds))
        yield Problem(f"{path}torques", None, allowed)
    if all(torque.si <= 0 for torque in torques):
        yield Problem(f"{path}torques", None, _("must be more than 0 at one speed or more, or it never drives"))
    for place, (one, other) in enumerate(pairwise(speeds), 1):
        if other.si <= one.si:
            allowed = _(
                "must be more than the speed before it, {speed}: one torque for each speed, or it is no function"
            )
            yield Problem(f"{path}speeds[{place}]", other.text, allowed.format(speed=one.text))
