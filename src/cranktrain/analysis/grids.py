"""Two grids: facts are found from one of their own, whatever steps a user asks for; curves stand on the user's."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from typing import Any, TypeVar, cast

import numpy as np

from cranktrain.language import Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.question import Parts
from cranktrain.motion import Array
from cranktrain.numerics.nested import each_changed
from cranktrain.numerics.ties import largest_first
from cranktrain.saying.catalogue import entries, values

Outcome = TypeVar("Outcome")

FACTS_STEP = np.pi / 180
"""Of the grid from which facts are found. [rad]"""
_COARSE = 0.02
"""Of a curve's range; what straight lines between its points may miss."""
_ROUGH = 0.05
"""Of its range, by which a curve bends on the average from point to point where it is but rounding."""
_NAMED = 3
"""How many curves a sentence names."""


def on_grid(parts: Parts, step: float) -> Parts:
    """Put another grid of crank angles, with steps in radians, into the parts."""
    grid: Any = parts[CrankAngle]
    n_angles = round(grid.cycle / step)
    return {**parts, CrankAngle: replace(grid, shown=np.arange(n_angles) * grid.cycle / n_angles)}


@cache
def has_curves(outcome: type) -> bool:
    """Whether a stage's result holds any curve."""
    return any(not entry.is_fact for entry in entries(outcome))


def with_curves(facts: Outcome, curves: Outcome, every: int) -> Outcome:
    """Give a result whose facts, checks and flags are those of one run, and whose curves are those of another.

    Parameters
    ----------
    facts, curves : result objects with curves
        Of both runs, which may be one.
    every : int
        Of so many points one is taken.
    """
    fields = {entry.path.partition(".")[0]: None for entry in entries(type(curves)) if not entry.is_fact}
    held = each_changed(lambda curve: curve[..., ::every], tuple(getattr(curves, name) for name in fields))
    return cast("Outcome", replace(cast("Any", facts), **dict(zip(fields, held, strict=True))))


def are_wide(shown: Array) -> bool:
    """Whether the steps of a grid are wider than those from which facts are found."""
    return float(shown[1] - shown[0]) > FACTS_STEP


def coarse_curves(facts: Mapping[type, object], curves: Mapping[type, object], shown: Array) -> tuple[Words, ...]:
    """Say which curves lose more than a little between their points, beside those of the facts' grid.

    Parameters
    ----------
    facts, curves : mapping of type to result object
        Of both runs.
    shown : Array, shape (n,)
        The curves' grid. [rad]
    """
    step = float(shown[1] - shown[0])
    # Designs of one machine differ in numbers alone: the first speaks for all.
    missed = {
        entry.name: _missed(values(outcome, entry)[:1], values(facts[kind], entry)[:1])
        for kind, outcome in curves.items()
        if kind in facts
        for entry in entries(kind)
        if not entry.is_fact
    }
    worst = largest_first([name for name in missed if missed[name] > _COARSE], missed.__getitem__)
    if not worst:
        return ()
    named = ", ".join(f"{name} ({100 * missed[name]:.0f} %)" for name in worst[:_NAMED])
    some: Words = _("{curves} and {n} more", curves=named, n=len(worst) - _NAMED) if len(worst) > _NAMED else named
    said = _(
        "A step of {step:g} deg is coarse for curves, though not for facts: straight lines between points miss up to"
        " this much of the range of {curves}."
    )
    return (said.format(step=round(float(np.degrees(step)), 6), curves=some),)


def _missed(coarse: Array, fine: Array) -> float:
    """Largest difference of a curve from straight lines between its points, in parts of its range over the cycle."""
    n_coarse, n_fine = coarse.shape[-1], fine.shape[-1]
    way: Array = np.arange(n_fine, dtype=np.float64) * (n_coarse / n_fine)
    place = np.floor(way).astype(np.intp)
    share: Array = way - place
    lines: Array = (1 - share) * coarse[..., place % n_coarse] + share * coarse[..., (place + 1) % n_coarse]
    with np.errstate(all="ignore"):
        span: Array = np.fmax.reduce(fine, axis=-1) - np.fmin.reduce(fine, axis=-1)
        off: Array = np.fmax.reduce(np.abs(lines - fine), axis=-1)
        # What bends at every point is rounding about a constant.
        bend = np.mean(np.abs(np.diff(np.nan_to_num(fine), 2, axis=-1)), axis=-1)
        return float(np.fmax.reduce(np.where(bend < _ROUGH * span, off / span, 0.0), axis=None, initial=0.0))
