"""How far a crank frame twists between its throws under a torque that goes through it."""

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.numerics.designs import of_designs
from cranktrain.questions.crankshaft.bending.bent_spans import Bent, crank_line, web_line
from cranktrain.questions.crankshaft.bending.designs_alike import Alike, designs_alike
from cranktrain.questions.crankshaft.bending.frame_spans import bent_spans
from cranktrain.questions.crankshaft.bending.shaft_loads import ActingPlaces
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft


def twist_when_free(shaft: Crankshaft, pins: NDArray[np.intp]) -> Array:
    """Twist between the middles of neighbouring pins by a unit torque, of journals that may turn in their bearings.

    Parameters
    ----------
    shaft : Crankshaft
    pins : array of int, shape (throw,)
        Which pieces the pins are, in line.

    Returns
    -------
    Array, shape (design, gap)
        [rad/(N·m)]

    Notes
    -----
    Bearings that are points have nothing to bear: what each part twists by itself adds up.
    docs/theory/torsion, eq. (23.13).
    """
    line = crank_line(shaft)
    length, rigid = np.diff(shaft.pieces.bounds, axis=1), np.sum(shaft.webs.rigid, axis=-1)
    lengths = [web_line(line, web)[1] for web in range(shaft.pieces.radius.shape[1] - 1)]
    way = np.stack(lengths, axis=1) if lengths else np.zeros_like(rigid)
    pieces = length / shaft.pieces.torsion
    webs = np.maximum(way - rigid, 0.0) / shaft.webs.bending_across
    found = [
        (pieces[:, one] + pieces[:, other]) / 2
        + np.sum(pieces[:, one + 1 : other], axis=-1)
        + np.sum(webs[:, one:other], axis=-1)
        for one, other in _pairs(pins)
    ]
    return np.stack(found, axis=1) if found else np.zeros((length.shape[0], 0))


def twist_when_clamped(shaft: Crankshaft, pins: NDArray[np.intp]) -> Array:
    """The same of journals that cannot turn aside in their bearings, which hold them by moments.

    Parameters
    ----------
    shaft : Crankshaft
    pins : array of int, shape (throw,)

    Returns
    -------
    Array, shape (design, gap)
        [rad/(N·m)]; NaN on less than two bearings.

    Notes
    -----
    docs/theory/torsion, eqs. (23.14) to (23.17).
    """
    free, relief = twist_when_free(shaft, pins), np.full((shaft.pieces.radius.shape[0], pins.size), np.nan)
    if shaft.supports.place.shape[1] > 1:
        marks = _marks(shaft, pins)
        for designs, alike in designs_alike(shaft, marks.z):
            relief[designs] = _relief(of_designs(shaft, designs), of_designs(marks, designs), alike)
    return free + np.diff(relief, axis=1)


def _pairs(pins: NDArray[np.intp]) -> list[tuple[int, int]]:
    return list(zip(pins[:-1].tolist(), pins[1:].tolist(), strict=True))


def _marks(shaft: Crankshaft, pins: NDArray[np.intp]) -> ActingPlaces:
    """The middles of the pins, where the twist is asked for."""
    bounds = shaft.pieces.bounds
    return ActingPlaces(
        pins,
        np.zeros(pins.size, dtype=np.bool_),
        (bounds[:, pins] + bounds[:, pins + 1]) / 2,
        shaft.pieces.radius[:, pins],
        shaft.pieces.angle[:, pins],
    )


def _relief(shaft: Crankshaft, marks: ActingPlaces, alike: Alike) -> Array:
    """By how much the moments in the bearings turn the pins back, against the last bearing, shape (design, throw)."""
    bent = bent_spans(shaft, marks, alike)
    held = _moments(bent.first, bent.last)
    through = _turned(bent.first.twist, held)
    found = np.zeros(marks.z.shape)
    for span in range(held.shape[1]):
        found[:, alike.loads <= span] += through[:, span, np.newaxis]
    for mark, at in bent.points.items():
        found[:, mark] += _turned(at.twist, held[:, alike.loads[mark] - 1])
    return found


def _moments(first: Bent, last: Bent) -> Array:
    """Moments at the ends of spans that keep these from turning under a unit torque, of opposite sign.

    Shape (design, span, 4).
    """
    shape = first.twist.shape[:2]
    columns = np.concatenate([-first.slope, last.slope], axis=-1).reshape(*shape, 4, 4)
    by_torque = first.twist.reshape(*shape, 4, 1)
    return np.asarray(np.linalg.solve(np.swapaxes(columns, -1, -2), by_torque), dtype=np.float64)[..., 0]


def _turned(twist: Array, moments: Array) -> Array:
    """Twist by moments, shape (…, 4), of that by unit ones, shape (…, 2, 2)."""
    return np.sum(twist.reshape(moments.shape) * moments, axis=-1)
