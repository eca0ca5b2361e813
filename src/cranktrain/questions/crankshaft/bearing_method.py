"""What a method for the loads of main bearings is."""

from collections.abc import Callable

import numpy as np

from cranktrain.numerics.designs import of_designs
from cranktrain.questions.crankshaft.bearing_loads import BearingLoads
from cranktrain.questions.crankshaft.loads_in_spans import LoadsInSpans, SpannedLoads, alike_shafts, spanned_loads
from cranktrain.questions.crankshaft.shaft import Crankshaft, Supports
from cranktrain.questions.crankshaft.shaft_loads import ShaftLoads
from cranktrain.record import record

Kernel = Callable[[Supports, LoadsInSpans], BearingLoads]
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
    kernel : callable (Supports, LoadsInSpans) → BearingLoads
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
        """Bearing loads of any designs, each to the last bit what it gives alone."""
        return self.of(shaft.supports, spanned_loads(alike_shafts(shaft, loads.places), loads))

    def of(self, supports: Supports, loads: SpannedLoads) -> BearingLoads:
        """The same of loads whose spans are known, in bearings that may give otherwise than the shaft's.

        NaN where the shaft floats on a single bearing, or has no stiffness where the method asks for it.
        """
        n_designs, n_angles = loads.loads.turned.shape
        shape = (n_designs, loads.n_bearings, 2, n_angles)
        if loads.n_bearings < 2:
            nothing = np.full(shape, np.nan)
            return BearingLoads(nothing, nothing, nothing)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            found = [self.kernel(of_designs(supports, own.of.designs), own) for own in loads.groups]
        if len(found) == 1:
            return found[0]
        joined = [np.empty(shape) for _part in BearingLoads._fields]
        for own, values in zip(loads.groups, found, strict=True):
            for whole, part in zip(joined, values, strict=True):
                whole[own.of.designs] = part
        return BearingLoads(*joined)
