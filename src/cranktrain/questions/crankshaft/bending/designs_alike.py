"""Designs whose loads and webs lie between the same bearings, and whose bearings give alike, go together."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.grouping import grouped
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.cut_shaft import spans_of
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft


class Alike(NamedTuple):
    """What is the same in some designs.

    Attributes
    ----------
    loads, webs : array of int
        Between which bearings each load and each web lies, as `spans_of` says.
    is_isotropic : bool
        Whether every bearing gives as much in all directions.
    is_steady : bool
        Whether, beside that, all bearings stand in line: then what they carry of a load that turns with the shaft turns
        with it, and is nothing without loads.
    """

    loads: NDArray[np.intp]
    webs: NDArray[np.intp]
    is_isotropic: bool
    is_steady: bool


def designs_alike(shaft: Crankshaft, z: Array) -> Iterator[tuple[NDArray[np.intp], Alike]]:
    """Which designs go together, and what they have in common, with loads at places z, shape (design, load)."""
    place, compliance = shaft.supports.place, shaft.supports.compliance
    by_load = spans_of(place, z)
    by_web = spans_of(place, shaft.pieces.bounds[:, 1:-1])
    even = (
        (compliance[..., 0, 0] == compliance[..., 1, 1]) & (compliance[..., 0, 1] == 0) & (compliance[..., 1, 0] == 0)
    )
    isotropic = np.all(even, axis=-1)
    steady = isotropic & np.all(shaft.supports.settlement == 0.0, axis=(1, 2))
    keys = (
        (by_load[i].tobytes(), by_web[i].tobytes(), bool(isotropic[i]), bool(steady[i])) for i in range(place.shape[0])
    )
    for designs in grouped((key, design) for design, key in enumerate(keys)).values():
        first = designs[0]
        yield np.array(designs), Alike(by_load[first], by_web[first], bool(isotropic[first]), bool(steady[first]))
