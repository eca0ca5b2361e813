"""What a method for the loads of main bearings is."""

from collections.abc import Callable

import numpy as np

from cranktrain.questions.crankshaft.bearing_loads import BearingLoads
from cranktrain.questions.crankshaft.designs_alike import Alike, designs_alike, of_designs
from cranktrain.questions.crankshaft.shaft import Crankshaft
from cranktrain.questions.crankshaft.shaft_loads import ShaftLoads
from cranktrain.record import record

Kernel = Callable[[Crankshaft, ShaftLoads, Alike], BearingLoads]
"""Bearing loads of designs that are alike."""


@record
class BearingMethod:
    """A way to find what bearings carry.

    Attributes
    ----------
    name : str
        How users call it.
    title : str
        How answers call it, not yet translated.
    kernel : callable (Crankshaft, ShaftLoads, Alike) → BearingLoads
    source : str
        Where its equations stand.
    range : str
        What it takes the shaft and its bearings for: a sentence, not yet translated.
    """

    name: str
    title: str
    kernel: Kernel
    source: str
    range: str

    def loads(self, shaft: Crankshaft, loads: ShaftLoads) -> BearingLoads:
        """Bearing loads of any designs, each to the last bit what it gives alone.

        NaN where the shaft floats on a single bearing, or has no stiffness where the method asks for it.
        """
        if shaft.supports.place.shape[1] < 2:
            nothing = np.full((*shaft.supports.place.shape, 2, loads.force.shape[-1]), np.nan)
            return BearingLoads(nothing, nothing, nothing)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            found = [
                (designs, self.kernel(of_designs(shaft, designs), of_designs(loads, designs), alike))
                for designs, alike in designs_alike(shaft, loads)
            ]
        if len(found) == 1:
            return found[0][1]
        n_designs = shaft.supports.place.shape[0]
        joined = [np.empty((n_designs, *values.shape[1:])) for values in found[0][1]]
        for designs, values in found:
            for whole, part in zip(joined, values, strict=True):
                whole[designs] = part
        return BearingLoads(*joined)
