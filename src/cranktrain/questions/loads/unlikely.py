"""Loads on sliders on a stroke on which nobody works: computed with all the same, and flagged."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.grouping import grouped
from cranktrain.language import Words, _
from cranktrain.layout.load_laws import BySpeed, ByTravel
from cranktrain.layout.loads import LinkLoad
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.record import record
from cranktrain.saying.checks import Flagged
from cranktrain.saying.wording import number

_N_ANGLES = 1440
"""Of a turn, or of two: fine enough to see on which stroke a load acts, and where there."""
_START, _END = 0.01, 0.9
"""Parts of the stroke: a load that acts before the first and not after the second begins at its start, and ends in it.
A pump's goes on to the end."""
_FREE = 0.01
"""Of the work on the other way, and of the largest size: less is a corner that is not sharp."""


@record
class UnlikelyStrokes(Flagged):
    """Loads on sliders where their machines hardly work."""


def unlikely_strokes(loaded: LoadedMachine | None) -> UnlikelyStrokes:
    """Flag resisting forces on sliders whose way back is free that begin with the stroke, or act on the way back."""
    if loaded is None or loaded.loads is None:
        return UnlikelyStrokes()
    loads = loaded.loads.each
    sliding = [load for load in loads if load.is_slider and load.resists and not isinstance(load.law, BySpeed)]
    others = {(load.mechanism, load.link) for load in loads if load.is_slider and load not in sliding}
    each = grouped(((load.mechanism, load.link), load) for load in sliding)
    found = (said for at, own in each.items() if at not in others for said in _of_slider(loaded, own))
    return UnlikelyStrokes(unlikely=tuple(found))


def _of_slider(loaded: LoadedMachine, loads: Sequence[LinkLoad]) -> Iterator[Words]:
    """Flag what all such loads of one slider do together."""
    # Aside from dead centres, where none acts.
    turned = np.linspace(0.0, 2 * TURN, _N_ANGLES, endpoint=False) + TURN / _N_ANGLES
    angle = turned[np.newaxis, np.newaxis]
    ways = loaded.load_ways(loads, angle)
    rows = [loaded.load_value(*row, angle, np.ones_like(angle)) for row in zip(loads, ways, strict=True)]
    size = np.sum(np.abs(np.concatenate(np.broadcast_arrays(*rows), axis=1)), axis=1)
    out, place = (loads[0].counts * (part + 0 * angle)[:, 0] for part in (ways[0].rate, ways[0].place))
    name = " + ".join(load.name for load in loads)
    is_counted = all(isinstance(load.law, ByTravel) for load in loads)
    listed = max(load.law.most for load in loads if isinstance(load.law, ByTravel)) if is_counted else 0.0
    for own in zip(*np.broadcast_arrays(size, out, place), strict=True):
        said = tuple(_of_design(name, *own, listed=listed, is_counted=is_counted))
        if said:
            yield from said
            return


def _of_design(load: str, size: Array, out: Array, place: Array, *, listed: float, is_counted: bool) -> Iterator[Words]:
    """Say what is unlikely of a size over the angles, by the speed and the place of what it acts on.

    listed is the largest size that the file has, of a load over its travel.
    """
    if np.max(size) <= _FREE * listed:
        return  # it acts nowhere to speak of
    power = size * out
    work_out, work_back = float(np.sum(power[power > 0])), -float(np.sum(power[power < 0]))
    is_out = work_out > work_back
    if not min(work_out, work_back) <= _FREE * max(work_out, work_back):
        return  # both ways, or none that is known
    acts = (size > _FREE * np.max(size)) & ((out > 0) == is_out)
    from_least = (place - np.min(place)) / np.ptp(place)
    gone = (from_least if is_out else 1 - from_least)[acts]
    begins_late = not gone.size or np.min(gone) > _START
    if is_counted and not is_out:
        if begins_late or np.max(gone) <= _END:  # a pump delivers on all of it
            yield _(
                "{load} acts on the way back alone, with up to {most}: are force and force_back right? Of a machine"
                ' that works as it comes back counts = "against" says so, and force and force_back change places.',
                load=load,
                most=number(float(np.max(size)), "kN"),
            )
        return
    if begins_late or np.max(gone) > _END:
        return
    yield _(
        "{load} begins at the start of its stroke and acts on {share} % of it, with the way back free: does its travel,"
        " or its crank angle, count from the right end?",
        load=load,
        share=f"{100 * float(np.max(gone)):.3g}",
    )
