"""Main journals in axes that turn with the shaft: their loads, wear of journals and bearings, places for oil holes."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_smallest
from cranktrain.questions.crankshaft.bending.loads_in_spans import SpannedLoads
from cranktrain.questions.crankshaft.bending.shaft_loads import ShaftLoads
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShaft, LoadedShafts, LoadsOverCycle
from cranktrain.questions.crankshaft.results.bearings_between_events import BearingsBetweenEvents
from cranktrain.questions.crankshaft.results.main_bearing_loads import MainBearingLoads
from cranktrain.questions.crankshaft.results.shaft_events import ShaftPoints
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANKSHAFT as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_FACT = ("bearing_method", "bearing")
_CURVE, _RAYS = (*_FACT, "crank_angle"), (*_FACT, "ray")


@record
class JournalLoads(StageResult):
    """Loads of the main bearings in axes that turn with the shaft."""

    journal_load_along: Array = quantity(
        "Q_L",
        "N",
        _CURVE,
        N_("Load of the journal on the main bearing in the direction of the crank of throw 1"),
        _THEORY,
        "24.44",
    )
    journal_load_across: Array = quantity(
        "Q_A",
        "N",
        _CURVE,
        N_("Load of the journal on the main bearing, 90° from the crank of throw 1 in the sense of rotation"),
        _THEORY,
        "24.44",
    )


@record
class JournalWear(StageResult):
    """Means over the cycle of what journals and main bearings do to each other, by each method."""

    journal_wear: Array = quantity(
        "W_J",
        "N",
        _RAYS,
        N_("Mean load on each ray of the journal, from throw 1 in the sense of rotation"),
        _THEORY,
        "24.46, 24.47",
    )
    journal_oil_hole: Array = quantity(
        "γ_J",
        "rad",
        _FACT,
        N_("Place for the oil hole of the journal, from throw 1 in the sense of rotation"),
        _THEORY,
        "24.46, 24.47",
    )
    bearing_wear: Array = quantity(
        "W_B",
        "N",
        _RAYS,
        N_("Mean load on each ray of the main bearing, from upward in the sense of rotation"),
        _THEORY,
        "24.46, 24.47",
    )
    bearing_oil_hole: Array = quantity(
        "γ_B",
        "rad",
        _FACT,
        N_("Place for the oil hole of the main bearing, from upward in the sense of rotation"),
        _THEORY,
        "24.46, 24.47",
    )


def journal_loads(loaded: LoadedShafts, bearings: MainBearingLoads, over_cycle: LoadsOverCycle) -> JournalLoads:
    """Turn the loads of the main bearings into axes of their shafts.

    Notes
    -----
    docs/theory/crankshaft, eq. (24.44).
    """
    directions, senses = _axes(loaded, over_cycle.each)
    x, y = bearings.main_bearing_load_x, bearings.main_bearing_load_y
    return JournalLoads(*in_turning_axes(x, y, directions, senses))


def journal_wear(loaded: LoadedShafts, between: BearingsBetweenEvents, within: ShaftPoints) -> JournalWear:
    """Wear of journals and bearings by quadrature between events.

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.46) and (24.47).
    """
    x, y = np.moveaxis(between.load, 3, 0)
    directions, senses = _axes(loaded, between.acting)
    journal, bearing = within.points.wear(in_turning_axes(x, y, directions, senses), (y, -senses * x))
    return JournalWear(*journal, *bearing)


def _axes(loaded: LoadedShafts, acting: Sequence[SpannedLoads]) -> tuple[Array, Array]:
    """Of every bearing's shaft the direction of throw 1's crank [rad], and its sense: (design, 1, bearing, n or 1)."""
    directions = [
        np.repeat(first_throw(shaft, spanned.loads)[:, np.newaxis], shaft.metal.supports.place.shape[1], axis=1)
        for shaft, spanned in zip(loaded.each, acting, strict=True)
    ]
    senses = [np.full(shaft.metal.supports.place.shape[1], shaft.layout.turn) for shaft in loaded.each]
    return np.concatenate(directions, axis=1)[:, np.newaxis], np.concatenate(senses)[:, np.newaxis]


def first_throw(shaft: LoadedShaft, acting: ShaftLoads) -> Array:
    """Direction of the crank of a shaft's throw 1, from X toward Y, shape (design, n). [rad]"""
    piece = shaft.layout.pins[first_smallest(shaft.layout.declared.throw)]
    return shaft.metal.pieces.angle[:, piece, np.newaxis] + acting.turned


class TurningLoad(NamedTuple):
    """Load of journals on their bearings in axes of the shaft: along a throw's crank, and 90° ahead of it. [N]"""

    along: Array
    across: Array


def in_turning_axes(x: Array, y: Array, direction: Array, turn: Array | float) -> TurningLoad:
    """Loads toward X and Y, in axes that turn with a shaft.

    Parameters
    ----------
    x, y : Array, shape (..., n)
    direction : Array, broadcastable to (..., n)
        Of the first of these axes, from X toward Y. [rad]
    turn : float, or Array broadcastable to (..., n)
        1 where the shaft runs from X toward Y, −1 where it runs the other way.

    Returns
    -------
    TurningLoad, shape (..., n)

    Notes
    -----
    docs/theory/crankshaft, eq. (24.44).

    Examples
    --------
    A load to the right, of a shaft that turns clockwise, while throw 1 points up:

    >>> along, across = in_turning_axes(np.array([5.0]), np.array([0.0]), np.array([np.pi / 2]), -1.0)
    >>> round(float(along[0]), 9), float(across[0])
    (0.0, 5.0)
    """
    cos, sin = np.cos(direction), np.sin(direction)
    return TurningLoad(x * cos + y * sin, turn * (y * cos - x * sin))
