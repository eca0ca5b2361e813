"""Curves of a saved case among those of a machine, and by how much they differ."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.panels.shapes import Curve, Panel, peak

_ROUNDING = 1e-9
"""Of the largest value: a difference that is less is none."""


def with_saved(panels: Sequence[Panel], others: Sequence[Panel]) -> tuple[Panel, ...]:
    """Add a saved case's curves to the panels that have them, behind all others."""
    found = _matched(panels, others)
    return tuple(panel if other is None else _with_curves(panel, other) for panel, other in found)


def differences(panels: Sequence[Panel], others: Sequence[Panel]) -> tuple[Panel, ...]:
    """Give panels of how much more the curves are than a saved case's, where these have values."""
    found = (_difference(panel, other) for panel, other in _matched(panels, others) if other is not None)
    return tuple(panel for panel in found if any(np.any(np.isfinite(curve.values)) for curve in panel.curves))


def _matched(panels: Sequence[Panel], others: Sequence[Panel]) -> list[tuple[Panel, Panel | None]]:
    """Find for each panel the one of the same quantity with the same curves."""
    known = {_sort(other): other for other in others}
    return [(panel, known.get(_sort(panel))) for panel in panels]


def _sort(panel: Panel) -> tuple[object, ...]:
    """What a panel and the same one of another machine have in common."""
    curves = tuple((curve.role, curve.letter, curve.symbol, str(curve.name)) for curve in panel.curves)
    return str(panel.title), str(panel.unit), panel.across_unit, curves


def _with_curves(panel: Panel, other: Panel) -> Panel:
    """Add the curves of the same panel of a saved case; limits that were those of its own curves alone go."""
    saved = tuple(
        Curve(curve.values, "saved", "", across=other.across_of(curve), is_cloud=curve.is_cloud)
        for curve in other.curves
    )
    return replace(panel, curves=(*panel.curves, *saved))


def _difference(panel: Panel, other: Panel) -> Panel:
    """Give by how much more each curve is."""
    pairs = zip(panel.curves, other.curves, strict=True)
    curves = tuple(
        replace(curve, values=_more(curve.values, _at(panel.across_of(curve), other.across_of(before), before.values)))
        for curve, before in pairs
    )
    title = _("{title}, now less saved", title=panel.title)
    return replace(panel, title=title, curves=curves, marks=(), levels=(), below=(), corner=(), limits=None)


def _more(now: Array, saved: Array) -> Array:
    """Give by how much values are more; what is rounding beside the largest of them is nothing."""
    found = now - saved
    return np.where(np.abs(found) <= _ROUNDING * max(peak(now), peak(saved)), 0.0, found)


def _at(places: Array, across: Array, values: Array) -> Array:
    """Read a curve where another stands, if it is over the same; NaN outside."""
    if np.array_equal(places, across):
        return values
    if np.any(np.diff(across) < 0.0):
        return np.full(len(places), np.nan)
    return np.interp(places, across, values, left=np.nan, right=np.nan)
