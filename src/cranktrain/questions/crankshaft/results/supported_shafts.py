"""All crankshafts in their bearings, by every method: what these carry of unit loads, found once a run."""

from collections.abc import Sequence

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.loads_in_spans import LoadsInSpans, SpannedLoads, unit_loads
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts
from cranktrain.questions.crankshaft.methods import methods_for
from cranktrain.questions.crankshaft.methods.bearing_method import BearingMethod
from cranktrain.questions.crankshaft.methods.supported_shaft import SupportedShaft, in_bearings
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.record import record


@record
class SupportedShafts:
    """All declared crankshafts in their bearings.

    Attributes
    ----------
    units : tuple of tuple of LoadsInSpans
        Unit loads on each shaft, of each group of its designs.
    by_method : tuple of tuple of SupportedShaft
        By every method that the file has numbers for, the most trusted first: each shaft.
    """

    units: tuple[tuple[LoadsInSpans, ...], ...]
    by_method: tuple[tuple[SupportedShaft, ...], ...]

    @property
    def methods(self) -> tuple[BearingMethod, ...]:
        """The methods."""
        return tuple(shafts[0].method for shafts in self.by_method)

    def borne(self, acting: Sequence[SpannedLoads]) -> Array:
        """Load of the bearings of all shafts by every method, shape (design, method, bearing, 2, n). [N]"""
        by_method = [
            np.concatenate([shaft.borne(loads) for shaft, loads in zip(shafts, acting, strict=True)], axis=1)
            for shafts in self.by_method
        ]
        return np.stack(by_method, axis=1)


def supported_shafts(loaded: LoadedShafts, declared: DeclaredCrankshafts) -> SupportedShafts:
    """Ask every method for what the bearings carry of unit loads; docs/theory/crankshaft, eq. (24.10)."""
    units = tuple(
        tuple(unit_loads(alike, is_geared=bool(shaft.meshes)) for alike in shaft.spans) for shaft in loaded.each
    )
    by_method = tuple(in_bearings(method, loaded.supports, units) for method in methods_for(declared))
    return SupportedShafts(units, by_method)
