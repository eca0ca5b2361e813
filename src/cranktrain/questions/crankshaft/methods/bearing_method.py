"""What a method for the loads of main bearings is, and what it takes the bearings for."""

from collections.abc import Callable
from operator import attrgetter

import numpy as np

from cranktrain.language import N_
from cranktrain.numerics.designs import of_designs
from cranktrain.questions.crankshaft.bending.bearing_loads import BearingLoads
from cranktrain.questions.crankshaft.bending.loads_in_spans import (
    LoadsInSpans,
    SpannedLoads,
    alike_shafts,
    in_order,
    spanned_loads,
)
from cranktrain.questions.crankshaft.bending.shaft_loads import ShaftLoads
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft, Supports
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.record import record

Kernel = Callable[[Supports, LoadsInSpans], BearingLoads]
"""Bearing loads of designs that are alike."""


@record
class TakenBearings:
    """Bearings as a method has them; methods of the same bearings share a line of the answer.

    Attributes
    ----------
    title : str
        How answers call a shaft in such bearings, not yet translated.
    needs : str
        What the machine file must say of them, not yet translated; "" for nothing.
    are_known : callable (DeclaredCrankshafts) → bool
        Whether it does.
    is_linear : bool
        Whether what they bear of loads together is the sum of what they bear of each.
    """

    title: str
    needs: str
    are_known: Callable[[DeclaredCrankshafts], bool]
    is_linear: bool = True


def _always(_declared: DeclaredCrankshafts) -> bool:
    """Of bearings of which nothing need be known."""
    return True


RIGID = TakenBearings(N_("on rigid bearings"), "", _always)
ELASTIC = TakenBearings(N_("on elastic bearings"), N_("[crankshaft] bearing_stiffness"), attrgetter("is_elastic"))
LOOSE = TakenBearings(
    N_("with clearance"), N_("[crankshaft] bearing_clearance"), attrgetter("has_clearance"), is_linear=False
)


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
    bearings : TakenBearings
        The latter as data: what it needs of the file, and with which methods it shares a line of the answer.
    rank : int
        Of trust: 1 is the most trusted. The answer begins with it, and pictures draw it so.
    beside : str or None
        That line where its largest load, `{other}`, stands beside `{load}` in `{bearing}`, that of the most trusted
        method of these bearings, not yet translated; None where it has no place there.
    is_cut : bool
        Whether the shaft is cut at its bearings, so that no span knows of the loads on another.
    trust : str
        What the answer says of whom to trust where this is the best that the file has numbers for, not yet translated:
        `{range}` is what all methods give in `{bearing}`.
    """

    name: str
    title: str
    kernel: Kernel
    source: str
    range: str
    bearings: TakenBearings
    rank: int
    beside: str | None = None
    is_cut: bool = False
    trust: str = N_("{method}; bearing {bearing} by all: {range}")

    def loads(self, shaft: Crankshaft, loads: ShaftLoads) -> BearingLoads:
        """Bearing loads of any designs, each to the last bit what it gives alone."""
        return self.of(shaft.supports, spanned_loads(alike_shafts(shaft, loads.places), loads))

    def of(self, supports: Supports, loads: SpannedLoads) -> BearingLoads:
        """The same of loads whose spans are known, in bearings that may give otherwise than the shaft's."""
        by_group = [self.of_alike(supports, group) for group in loads.groups]
        return BearingLoads(*(in_order(loads.groups, parts) for parts in zip(*by_group, strict=True)))

    def of_alike(self, supports: Supports, loads: LoadsInSpans) -> BearingLoads:
        """The same of those of the designs that are alike.

        NaN where the shaft floats on a single bearing, or has no stiffness where the method asks for it.
        """
        own = of_designs(supports, loads.of.designs)
        n_designs, n_bearings = own.place.shape
        if n_bearings < 2:
            nothing = np.full((n_designs, n_bearings, 2, loads.loads.turned.shape[1]), np.nan)
            return BearingLoads(nothing, nothing, nothing)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            return self.kernel(own, loads)
