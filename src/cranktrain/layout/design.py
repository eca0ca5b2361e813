"""A declared machine as questions see it: arranged, with its tables by class; and several designs of one machine."""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any, TypeVar

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.frames import Orientation
from cranktrain.layout.masses import Weighed
from cranktrain.layout.mechanisms import Mechanisms, Pistons, Rockers
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.specs import ShaftSpec
from cranktrain.record import record

Table = TypeVar("Table")
Found = TypeVar("Found")


@record
class Design:
    """One machine as its file declares it.

    Attributes
    ----------
    places : tuple of PlacedMechanism
        Its mechanisms, arranged on shafts and banks.
    shafts : mapping of str to ShaftSpec
    orientation : Orientation
    zero : float
        φ where the shown crank angle is 0. [rad]
    weighed : Weighed
        What it says of masses.
    tables : mapping of str to table
        Those of its file, by key.
    """

    places: tuple[PlacedMechanism, ...]
    shafts: Mapping[str, ShaftSpec]
    orientation: Orientation
    zero: float
    weighed: Weighed
    tables: Mapping[str, Any]

    def table(self, kind: type[Table]) -> Table | None:
        """Give the table of that class; None where the file has none."""
        return next((table for table in self.tables.values() if isinstance(table, kind)), None)

    @property
    def pistons(self) -> tuple[PlacedMechanism, ...]:
        """Those of its mechanisms that drive a slider."""
        return self.driving("slider")

    def driving(self, output: str) -> tuple[PlacedMechanism, ...]:
        """Those of its mechanisms that have this output."""
        return tuple(place for place in self.places if place.kind.output == output)

    @cached_property
    def _found(self) -> dict[object, Any]:
        return {}

    def once(self, find: "Callable[[Design], Found]") -> Found:
        """What is found from this design: once, however often it is asked for."""
        if find not in self._found:
            self._found[find] = find(self)
        return self._found[find]


@record
class Designs:
    """Designs of one machine, which differ in numbers alone, laid out.

    Attributes
    ----------
    each : tuple of Design
        The first speaks for all where numbers do not matter.
    crank_angle : CrankAngle
    mechanisms : Mechanisms
    pistons, rockers : Pistons, Rockers or None
        Those of the mechanisms that drive a slider or a rocker; None where none does.
    """

    each: tuple[Design, ...]
    crank_angle: CrankAngle
    mechanisms: Mechanisms
    pistons: Pistons | None
    rockers: Rockers | None

    @property
    def places(self) -> Sequence[tuple[PlacedMechanism, ...]]:
        """Mechanisms of each design."""
        return [design.places for design in self.each]

    def tables(self, kind: type[Table]) -> tuple[Table, ...]:
        """The table of that class of each design; none where the file has none."""
        return tuple(table for design in self.each if (table := design.table(kind)) is not None)
