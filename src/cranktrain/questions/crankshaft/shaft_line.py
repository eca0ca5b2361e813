"""One shaft's table, put to its throws: pins, webs, journals and bearings in line, each with its own numbers."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.design import Design
from cranktrain.layout.shafts import throw_positions
from cranktrain.motion import ZERO, Array, plain
from cranktrain.quantities import Given
from cranktrain.questions.crankshaft.spec import NEEDED, BearingSpec, CrankshaftSpec, CrankshaftTable
from cranktrain.record import record

_NO_BORE = (Given(0.0, "0 mm"),)
Ends = tuple[Array, Array]
"""Of the first and of the second web of a pin."""


class LinePin(NamedTuple):
    """A crank pin: its throw, from 0, which share of what that throw's rods do it has, and z of its middle. [m]"""

    throw: int
    share: float
    z: Array


class LineBearing(NamedTuple):
    """A main bearing: its name, z of its middle [m], and what the file says of it."""

    name: str
    z: Array
    table: BearingSpec


class LineShoulder(NamedTuple):
    """A shoulder: its name, the journal, from 0, that it is on; z, and diameter and bore from there on. [m]"""

    name: str
    journal: int
    z: Array
    diameter: Array
    bore: Array


@record
class ShaftLine:
    """A shaft's parts in line, numbers of one design or of several.

    Attributes
    ----------
    pins : tuple of LinePin
        From the free end to the flywheel.
    journals : array of bool, shape (pin + 1,)
        Which journals there are.
    bearings : tuple of LineBearing
        In the order in which they stand.
    journal_diameter, journal_bore : tuple of Array, one for each journal
        [m]
    pin_diameter, pin_bore, pin_length : tuple of Array, one for each pin
        [m]
    web_thickness, web_width, planes : tuple of Ends, one for each pin
        Of both its webs, and z of their middles; from pin to pin a web is as thick as the gap. [m]
    shoulders : tuple of LineShoulder
        In the order in which they stand.
    """

    pins: tuple[LinePin, ...]
    journals: NDArray[np.bool_]
    bearings: tuple[LineBearing, ...]
    journal_diameter: tuple[Array, ...]
    journal_bore: tuple[Array, ...]
    pin_diameter: tuple[Array, ...]
    pin_bore: tuple[Array, ...]
    pin_length: tuple[Array, ...]
    web_thickness: tuple[Ends, ...]
    web_width: tuple[Ends, ...]
    planes: tuple[Ends, ...]
    shoulders: tuple[LineShoulder, ...]

    @property
    def is_between(self) -> tuple[bool, ...]:
        """Whether one web leads from each pin but the last to the next."""
        return tuple((~self.journals[1:-1]).tolist())


def table_of(spec: CrankshaftSpec, shaft: str) -> CrankshaftTable | None:
    """What the file says of one shaft: its own table over that of all; None where it says no section of it."""
    of_shaft = spec.overrides.get(shaft)
    if of_shaft is None:
        return None if all(getattr(spec, name) is None for name in NEEDED) else spec
    given = {name: _either(getattr(of_shaft, name), getattr(spec, name)) for name in CrankshaftTable.model_fields}
    return CrankshaftTable.model_construct(**given)


def _either(of_shaft: Any, common: Any) -> Any:
    """What is given, or else what holds for all; of tables by name both."""
    if isinstance(of_shaft, Mapping):
        return common | cast("Mapping[str, object]", of_shaft)
    return common if of_shaft is None else of_shaft


class ShaftLines:
    """The crankshafts of a design, which holds them: each put in line when somebody asks for it, and once."""

    def __init__(self, design: Design) -> None:
        spec = design.table(CrankshaftSpec)
        self._lines = dict[str, ShaftLine | None]()
        self.tables: Mapping[str, CrankshaftTable | None] = {
            name: None if spec is None else table_of(spec, name) for name in design.shafts
        }

    def line(self, design: Design, shaft: str) -> ShaftLine | None:
        """Give one of the design in line, of whose table all is there; None where nothing says where its throws are."""
        if shaft not in self._lines:
            table = self.tables[shaft]
            pins = None if table is None else line_pins(table, design, shaft)
            self._lines[shaft] = None if table is None or pins is None else shaft_line(table, pins)
        return self._lines[shaft]


def path_of(spec: CrankshaftSpec, shaft: str, key: str) -> str:
    """Path of a key in the file: of the shaft's own table where that gives it."""
    of_shaft = spec.overrides.get(shaft)
    is_of_shaft = of_shaft is not None and (
        key.partition(".")[0] in of_shaft.model_fields_set or not spec.model_fields_set & {key}
    )
    return f"crankshaft.{shaft}.{key}" if is_of_shaft else f"crankshaft.{key}"


def line_pins(table: CrankshaftTable, design: Design, shaft: str) -> tuple[LinePin, ...] | None:
    """Pins of a shaft in line; None where nothing says where its throws stand."""
    throws = throw_positions(design.shafts[shaft])
    if throws is None:
        return None
    far = {place.throw for place in design.places if place.shaft == shaft and place.is_far}
    pins: list[LinePin] = []
    for throw, z in enumerate(throws):
        if throw in far and table.side_rod_distance is not None:
            away = table.side_rod_distance.array / 2
            pins += [LinePin(throw, 0.5, z - away), LinePin(throw, 0.5, z + away)]
        else:
            pins.append(LinePin(throw, 1.0, z))
    return tuple(sorted(pins, key=lambda pin: _first(pin.z)))


def shaft_line(table: CrankshaftTable, pins: Sequence[LinePin]) -> ShaftLine:
    """Put a table in which all is there, and lists are as long as they must be, to the pins."""
    n = len(pins)
    has = np.array([table.journals is None or number in table.journals for number in range(1, n + 2)])
    lengths = each_of(table.pin_length, n)
    thickness, width = _webs(table.web_thickness, n), _webs(table.web_width, n)
    ends = [(pin.z - length / 2, pin.z + length / 2) for pin, length in zip(pins, lengths, strict=True)]
    planes = [(begin - first / 2, end + last / 2) for (begin, end), (first, last) in zip(ends, thickness, strict=True)]
    for before in np.flatnonzero(~has[1:-1]).tolist():
        begin, end = ends[before][1], ends[before + 1][0]
        thickness[before] = (thickness[before][0], end - begin)
        planes[before] = (planes[before][0], (begin + end) / 2)
        thickness[before + 1] = (end - begin, thickness[before + 1][1])
        planes[before + 1] = ((begin + end) / 2, planes[before + 1][1])
    bores = each_of(table.journal_bore or _NO_BORE, n + 1)
    return ShaftLine(
        tuple(pins),
        has,
        _bearings(table, pins, has),
        each_of(table.journal_diameter, n + 1),
        bores,
        each_of(table.pin_diameter, n),
        each_of(table.pin_bore or _NO_BORE, n),
        lengths,
        tuple(thickness),
        tuple(width),
        tuple(planes),
        tuple(_shoulders(table, pins, bores)),
    )


def _shoulders(table: CrankshaftTable, pins: Sequence[LinePin], bores: Sequence[Array]) -> Iterator[LineShoulder]:
    """Shoulders as they stand, each with the bore of its own or that before it."""
    before = list(bores)
    for name, shoulder in sorted(table.shoulder.items(), key=lambda named: _first(named[1].z.array)):
        z = shoulder.z.array
        journal = sum(_first(pin.z) < _first(z) for pin in pins)
        if shoulder.bore is not None:
            before[journal] = shoulder.bore.array
        yield LineShoulder(name, journal, z, shoulder.diameter.array, before[journal])


def resting(table: CrankshaftTable, n_pins: int) -> tuple[int, ...]:
    """Numbers of the journals that rest in a bearing."""
    there = range(1, n_pins + 2) if table.journals is None else table.journals
    return tuple(sorted(there if table.bearings is None else table.bearings))


def beyond(table: CrankshaftTable, pins: Sequence[LinePin]) -> Array:
    """From the first and the last pin to the bearing beyond. [m]"""
    if table.bearing_distance is not None:
        return table.bearing_distance.array
    return (pins[1].z - pins[0].z) / 2 if len(pins) > 1 else ZERO


def _bearings(table: CrankshaftTable, pins: Sequence[LinePin], has: NDArray[np.bool_]) -> tuple[LineBearing, ...]:
    """Bearings of journals and those of names of their own, as they stand."""
    away = beyond(table, pins)
    middles = [(pin.z + next_pin.z) / 2 for pin, next_pin in pairwise(pins)]
    places = [pins[0].z - away, *middles, pins[-1].z + away]
    numbers = {str(number): places[number - 1] for number in resting(table, len(pins)) if has[number - 1]}
    more = {name: ZERO for name in table.bearing if name not in numbers}
    common = _with_common(table, BearingSpec())
    tables = {name: _with_common(table, bearing) for name, bearing in table.bearing.items()}
    bearings = [_bearing(name, place, tables.get(name, common)) for name, place in (numbers | more).items()]
    return tuple(sorted(bearings, key=lambda bearing: _first(bearing.z)))


def _bearing(name: str, place: Array, table: BearingSpec) -> LineBearing:
    """Put a bearing where its table says, or else the journal on which it stands."""
    return LineBearing(name, place if table.z is None else table.z.array, table)


def _with_common(table: CrankshaftTable, bearing: BearingSpec) -> BearingSpec:
    """Fill up the table of a bearing by what holds for all."""
    common = {
        "stiffness": table.bearing_stiffness,
        "stiffness_direction": table.bearing_stiffness_direction,
        "clearance": table.bearing_clearance,
        "width": table.bearing_width,
    }
    given = {key: getattr(bearing, key) for key in common}
    return bearing.model_copy(update={key: common[key] if own is None else own for key, own in given.items()})


def _first(value: Array) -> float:
    return plain(value[0] if getattr(value, "ndim", 0) else value)  # `np.ndim` would make an array of a number


def each_of(given: Sequence[Given] | None, n: int) -> tuple[Array, ...]:
    """Give as many numbers as there are, of one value for all or one for each."""
    values = [value.array for value in given or ()]
    return tuple(values * n if len(values) == 1 else values)


def _webs(given: Sequence[Given] | None, n_pins: int) -> list[Ends]:
    """Both webs of every pin: one value for all, one for each pin, or one for each web."""
    values = each_of(given, n_pins) if len(given or ()) in (1, n_pins) else each_of(given, 2 * n_pins)
    return list(zip(values[::2], values[1::2], strict=True)) if len(values) > n_pins else [(web, web) for web in values]
