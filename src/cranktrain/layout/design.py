"""A declared machine as questions see it: arranged, with its tables by class; and several designs of one machine."""

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property, partial
from typing import Any, TypeVar

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.frames import Orientation
from cranktrain.layout.load_tables import LoadTables
from cranktrain.layout.masses import Weighed
from cranktrain.layout.mechanisms import Mechanisms, Pistons, Rockers
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.specs import ShaftSpec
from cranktrain.motion import Array
from cranktrain.numerics.designs import by_design
from cranktrain.record import record

Table = TypeVar("Table")
Found = TypeVar("Found")


@record
class Design:
    """One machine as its file declares it, or several designs of it together: numbers are then columns of them.

    Attributes
    ----------
    places : tuple of PlacedMechanism
        Its mechanisms, arranged on shafts and banks.
    shafts : mapping of str to ShaftSpec
    orientation : Orientation
    zero : Array
        φ where the shown crank angle is 0. [rad]
    weighed : Weighed
        What it says of masses.
    loads : mapping of str
        What it works against, by the path of the tables and by name.
    tables : mapping of str to table
        Those of its file, by key.
    """

    places: tuple[PlacedMechanism, ...]
    shafts: Mapping[str, ShaftSpec]
    orientation: Orientation
    zero: Array
    weighed: Weighed
    loads: LoadTables
    tables: Mapping[str, Any]

    def table(self, kind: type[Table]) -> Table | None:
        """Give the table of that class; None where the file has none."""
        return next((table for table in self.tables.values() if isinstance(table, kind)), None)

    @cached_property
    def pistons(self) -> tuple[PlacedMechanism, ...]:
        """Those of its mechanisms that drive a slider."""
        return self.driving("slider")

    def driving(self, part: str) -> tuple[PlacedMechanism, ...]:
        """Those of its mechanisms that drive a "slider" or a "rocker"."""
        return tuple(place for place in self.places if place.kind.output.part == part)

    @cached_property
    def _found(self) -> dict[object, Any]:
        return {}

    def once(self, find: "Callable[[Design], Found]") -> Found:
        """What is found from this design: once, however often it is asked for."""
        return self.found(find, partial(find, self))

    def found(self, what: object, find: Callable[[], Found]) -> Found:
        """What is found of the machine, under a key that tells it from all else: once, as `once`."""
        if what not in self._found:
            self._found[what] = find()
        return self._found[what]


@record
class Designs:
    """Designs of one machine, which differ in numbers alone, laid out.

    Attributes
    ----------
    each : tuple of Design
        As their files declare them: for what a file of its own holds.
    together : Design
        All of them as one, in which numbers are arrays of shape (design,), or one number; of what is no number, the
        first.
    crank_angle : CrankAngle
    mechanisms : Mechanisms
    pistons, rockers : Pistons, Rockers or None
        Those of the mechanisms that drive a slider or a rocker; None where none does.
    """

    each: tuple[Design, ...]
    together: Design
    crank_angle: CrankAngle
    mechanisms: Mechanisms
    pistons: Pistons | None
    rockers: Rockers | None

    @property
    def n_designs(self) -> int:
        """How many they are."""
        return len(self.each)

    @cached_property
    def different(self) -> tuple[Design, ...]:
        """Those of `each` that are not one: designs of which only numbers in columns differ may be given as one."""
        return tuple({id(design): design for design in self.each}.values())

    @property
    def places(self) -> tuple[PlacedMechanism, ...]:
        """Mechanisms, with the numbers of all designs."""
        return self.together.places

    def by_design(self, numbers: Sequence[Array | float]) -> Array:
        """Put numbers, each one or shape (design,), into an array of shape (design, number)."""
        return by_design(numbers, self.n_designs)
