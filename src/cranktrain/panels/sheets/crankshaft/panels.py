"""Loads of bearings and pins as curves in the plane, and the torque along the shaft, out of a result."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.grouping import grouped
from cranktrain.language import Listed, Words, _
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.panels.design import OneDesign, closed
from cranktrain.panels.shapes import Curve, Panel, PolarCurve, PolarDiagram, polar_diagram
from cranktrain.quantities.refusal import unlisted
from cranktrain.questions.crankshaft.methods import BEARING_METHODS, title_of
from cranktrain.questions.crankshaft.results.section_torques import SECTIONS
from cranktrain.saying.wording import ranged

_SHAPE = 6
"""Loads that are the same to so many figures are drawn once."""
_LONGEST = 12
"""Letters of the names of alike pins; of more only the first is named."""
_NEXT = 1e-6


class AlikePins(NamedTuple):
    """Crank pins whose loads are alike but in their phase: the first one's number, and how all are called."""

    first: int
    names: str


ALL = "all"
"""Word for every method."""


def chosen_methods(shown: OneDesign, method: str | None) -> tuple[int, ...]:
    """Find methods that are asked for, by their places along `bearing_method`; none unless asked.

    Parameters
    ----------
    shown : OneDesign
    method : str or None
        Names with commas between, or `all`.

    Raises
    ------
    InputError
        If a name is none of a method by which the result has loads, or stands beside `all`.
    """
    if method is None:
        return ()
    known = shown.result.labels.get("bearing_method", ())
    if not known:
        allowed = _("must be left out: there are no loads of main bearings, by no method")
        raise InputError([Problem("method", method, allowed)])
    names = dict.fromkeys(name.strip().casefold() for name in method.split(","))
    if list(names) == [ALL]:
        return tuple(range(len(known)))
    if ALL in names:
        allowed = _("must be `all` by itself, which is every method, or without it: {methods}")
        raise InputError([Problem("method", method, allowed.format(methods=", ".join(known)))])
    refuse(unlisted("method", name, (*known, ALL)) for name in names if name not in known)
    return tuple(known.index(name) for name in names)


def diagrams_by_method(shown: OneDesign, places: Sequence[int]) -> tuple[PolarDiagram, ...]:
    """Loads of one main bearing after the other, by each method by itself; places along `bearing_method`."""
    methods, bearings = (shown.result.labels[name] for name in ("bearing_method", "bearing"))
    x, y = (shown(f"main_bearing_load_{axis}") for axis in "xy")
    at = shown("largest_bearing_load_at")
    title = _("Bearing {name}") if len(places) == 1 else _("{name}: {method}")
    return tuple(
        _diagram(
            shown,
            title.format(name=name, method=title_of(methods[place])),
            [(None, x[place, bearing], y[place, bearing])],
            float(at[place, bearing]),
        )
        for bearing, name in enumerate(bearings)
        for place in places
    )


def bearing_diagrams(shown: OneDesign) -> tuple[PolarDiagram, ...]:
    """Loads of every main bearing in fixed axes, by every method, the most trusted first."""
    methods, bearings = (shown.result.labels[name] for name in ("bearing_method", "bearing"))
    x, y = (shown(f"main_bearing_load_{axis}") for axis in "xy")
    at = shown("largest_bearing_load_at")[0]
    return tuple(
        _diagram(
            shown,
            _("Bearing {name}", name=name),
            [
                (method_place(method) if place else 0, x[place, bearing], y[place, bearing])
                for place, method in enumerate(methods)
            ],
            float(at[bearing]),
        )
        for bearing, name in enumerate(bearings)
    )


def method_place(name: str) -> int:
    """Place of a method in the order of trust, from 0."""
    return next(place for place, one in enumerate(BEARING_METHODS) if one.name == name)


def alike_pins(shown: OneDesign) -> tuple[AlikePins, ...]:
    """Crank pins that bear a rod and a load, apart by what they bear."""
    mean, largest = shown("mean_crankpin_load"), shown("largest_crankpin_load")
    holes, names = shown("crankpin_oil_hole"), shown.result.labels["mechanism"]
    is_loaded = np.isfinite(mean) & (largest > 0.0)
    known = np.flatnonzero(is_loaded & np.any(np.isfinite(shown("rod_bearing_wear")), axis=-1)).tolist()
    keys = [tuple(f"{value[i]:.{_SHAPE}g}" for value in (mean, largest, holes)) for i in known]
    return tuple(
        AlikePins(members[0], _together(names, members)) for members in grouped(zip(keys, known, strict=True)).values()
    )


def _together(names: Sequence[str], members: Sequence[int]) -> str:
    """Name some pins, where that is short; else the first, and how many more there are."""
    every = ranged(names, members)
    return every if len(every) <= _LONGEST else f"{names[members[0]]} +{len(members) - 1}"


def crank_pin_diagrams(shown: OneDesign, pin: AlikePins) -> tuple[PolarDiagram, PolarDiagram]:
    """Load of a pin in its own axes, away from the shaft up; and of the rod's bearing, toward the piston up."""
    at = float(shown("largest_crankpin_load_at")[pin.first])
    ways = (
        ("crankpin_load_tangential", "crankpin_load_radial", -1.0, _("On the pin, {names}")),
        ("rod_bearing_load_across", "rod_bearing_load_along", 1.0, _("On the rod's bearing, {names}")),
    )
    pin_load, rod_load = (
        _diagram(
            shown, title.format(names=pin.names), [(None, shown(across)[pin.first], up * shown(along)[pin.first])], at
        )
        for across, along, up, title in ways
    )
    return pin_load, rod_load


def _diagram(
    shown: OneDesign, title: Words, curves: Sequence[tuple[int | None, Array, Array]], at: float
) -> PolarDiagram:
    """Close all curves, and find the first one's largest."""
    found = tuple(PolarCurve(np.stack([closed(x), closed(y)]), place) for place, x, y in curves)
    # Beside a jump the curve's points are on either side of it.
    beside = np.abs(shown.cycle - at) <= shown.cycle[1] * (1 + _NEXT)
    size = np.where(beside, np.hypot(*found[0].points), -1.0)
    return polar_diagram(title, found, shown.cycle, found[0].points[:, first_largest(size)], at)


def on_journals(shown: OneDesign) -> NDArray[np.bool_]:
    """Which sections of the shaft are journals."""
    return np.array([SECTIONS[0] in name for name in shown.result.labels["section"]])


def of_shafts(names: Sequence[str]) -> list[tuple[str, str]]:
    """Shafts of names of bearings or journals, where there are several, and what they are called on them."""
    return [(shaft, name) for shaft, _dot, name in (whole.rpartition(".") for whole in names)]


def torque_panels(shown: OneDesign) -> Iterator[Panel]:
    """Torque in journals, and in pins if there is any, by the first method; that of the widest range is thick."""
    torque, ranges = shown("section_torque")[0], shown("section_torque_range")[0]
    names, journals = shown.result.titles["section"], on_journals(shown)
    for title, which in ((_("Torque in journals"), journals), (_("Torque in crank pins"), ~journals)):
        own = np.flatnonzero(which)
        if not np.any(torque[own]):
            continue  # as in a pin that hangs over the end
        worst = int(own[first_largest(ranges[own])])
        curves = [
            Curve(closed(torque[i]), "whole" if i == worst else "each", "T", name=names[i])
            for i in sorted(own.tolist(), key=lambda i: i == worst)
        ]
        said = Listed((title, Listed((_("thick that of widest range"), names[worst]))), ": ")
        yield Panel(said, "N*m", shown.cycle, tuple(curves))
