"""A crankshaft in its bearings: what these carry by a method, from unit loads where a sum of them is enough."""

from collections.abc import Sequence

from cranktrain.motion import Array
from cranktrain.numerics.products import product_by_columns
from cranktrain.questions.crankshaft.bending.blocks import turned_by
from cranktrain.questions.crankshaft.bending.loads_in_spans import LoadsInSpans, SpannedLoads, in_order
from cranktrain.questions.crankshaft.metal.shaft import Supports
from cranktrain.questions.crankshaft.methods.bearing_method import BearingMethod
from cranktrain.record import record


@record
class SupportedShaft:
    """A crankshaft in its bearings, as one method takes them.

    Attributes
    ----------
    method : BearingMethod
    supports : Supports
    by_unit : tuple of (Array or None)
        Of each group of designs that are alike, what the bearings carry of its unit loads in axes that turn with the
        shaft, shape (design, 2 · bearing, unit load) [N/N, N/(N·m)]; None where that is another at each crank angle, of
        several loads together is not their sum, or is nothing of most, in bearings far from them.
    """

    method: BearingMethod
    supports: Supports
    by_unit: tuple[Array | None, ...]

    def borne(self, acting: SpannedLoads) -> Array:
        """Load of all bearings toward X and Y, shape (design, bearing, 2, n); each design's as it is alone. [N]"""
        pairs = zip(acting.groups, self.by_unit, strict=True)
        loads = [
            self._solved(group) if by_unit is None else turned_by(_of_units(by_unit, group), -group.loads.turned)
            for group, by_unit in pairs
        ]
        return in_order(acting.groups, loads)

    def turning(self, acting: SpannedLoads) -> Array:
        """The same in axes that turn with the shaft."""
        pairs = zip(acting.groups, self.by_unit, strict=True)
        loads = [
            turned_by(self._solved(group), group.loads.turned) if by_unit is None else _of_units(by_unit, group)
            for group, by_unit in pairs
        ]
        return in_order(acting.groups, loads)

    def _solved(self, group: LoadsInSpans) -> Array:
        """Load of all bearings of designs that are alike, from their loads as they are."""
        return self.method.of_alike(self.supports, group).load


def _of_units(by_unit: Array, group: LoadsInSpans) -> Array:
    """Load of all bearings of designs that are alike, in axes that turn with the shaft."""
    load = product_by_columns(by_unit, group.turning)
    return load.reshape(len(load), -1, 2, load.shape[-1])


def in_bearings(
    method: BearingMethod, supports: Sequence[Supports], units: Sequence[Sequence[LoadsInSpans]]
) -> tuple[SupportedShaft, ...]:
    """Each shaft in some bearings, as a method takes them."""
    return tuple(
        SupportedShaft(method, bearings, tuple(_by_unit(method, bearings, group) for group in groups))
        for bearings, groups in zip(supports, units, strict=True)
    )


def _by_unit(method: BearingMethod, supports: Supports, unit: LoadsInSpans) -> Array | None:
    """What bearings carry of unit loads, as `SupportedShaft` has it."""
    is_sum = method.bearings.is_linear and unit.of.alike.is_steady and not method.is_cut
    if not is_sum or supports.place.shape[1] < 2:
        return None
    found = method.of_alike(supports, unit).load
    return found.reshape(len(found), -1, found.shape[-1])
