"""The table [crankshaft], put to the throws of every shaft, as arrays."""

from collections.abc import Iterator, Mapping, Sequence
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import Problem, refuse
from cranktrain.language import N_, _
from cranktrain.layout.design import Designs
from cranktrain.motion import ONE, ZERO, Array
from cranktrain.quantities import Given
from cranktrain.questions.crankshaft.metal.pieces_of_throws import WEB_RULES, WebRule
from cranktrain.questions.crankshaft.metal.sections import Material
from cranktrain.questions.crankshaft.metal.shaft import turned_compliance
from cranktrain.questions.crankshaft.pulls import Pulls, pulls_of
from cranktrain.questions.crankshaft.shaft_line import LineBearing, ShaftLine, ShaftLines, each_of
from cranktrain.questions.crankshaft.spec import STEEL, CrankshaftTable, GearSpec
from cranktrain.record import record


class DeclaredShoulders(NamedTuple):
    """Shoulders of one shaft as they stand along it.

    journal: which each is on, from 0, shape (shoulder,); z, shape (design, shoulder) [m]; size: diameter and bore from
    there on, (design, shoulder, 2) [m]; names.
    """

    journal: NDArray[np.intp]
    z: Array
    size: Array
    names: tuple[str, ...]


@record
class DeclaredCrankshaft:
    """One crankshaft of the file, arrays in SI.

    Attributes
    ----------
    shaft : int
        Which of the machine's shafts.
    throw : array of int, shape (pin,)
        Which throw of it each pin belongs to.
    share : Array, shape (pin,)
        Which part of that throw's rods is on the pin: ½ where a far piston has two side rods.
    centres : Array, shape (design, pin)
        z of the pins' middles. [m]
    journals : array of bool, shape (pin + 1,)
        Which journals there are.
    bearing_names : tuple of str
    bearings : Array, shape (design, bearing)
        z of the main bearings. [m]
    standing_on : array of int, shape (bearing,)
        Which journal each stands on, from 0.
    journal : Array, shape (design, pin + 1, 2)
        Diameter and bore, of one with shoulders before the first. [m]
    shoulders : DeclaredShoulders
    at_bearings : Array, shape (design, bearing)
        Diameter of the journal where each bearing stands. [m]
    pin : Array, shape (design, pin, 2)
        Diameter and bore. [m]
    pin_length : Array, shape (design, pin)
        [m]
    web_thickness, web_width, planes : Array, shape (design, pin, 2)
        Of both webs; z of their middles. [m]
    rule : WebRule
    compliance : Array, shape (design, bearing, 2, 2)
        [m/N]
    clearance : Array, shape (design, bearing)
        Radial. [m]
    settlement : Array, shape (design, bearing, 2)
        [m]
    bearing_width : Array, shape (design, bearing)
        NaN where it is not given. [m]
    rod_bearing_width : Array, shape (design,)
        NaN where it is not given. [m]
    thrust : int
        Which bearing takes axial forces.
    pulls : Pulls
    material : Material, shape (design,)
    span_bending : Array, shape (design, bearing − 1), or None
        EI of each span as a straight beam, where the file gives it. [N·m²]
    density : Array, shape (design,)
        [kg/m³]
    web_height : Array, shape (design, 1)
        NaN where it is not given. [m]
    is_elastic, has_clearance : bool
        Whether the file says so of any bearing.
    """

    shaft: int
    throw: NDArray[np.intp]
    share: Array
    centres: Array
    journals: NDArray[np.bool_]
    bearing_names: tuple[str, ...]
    bearings: Array
    standing_on: NDArray[np.intp]
    journal: Array
    shoulders: DeclaredShoulders
    at_bearings: Array
    pin: Array
    pin_length: Array
    web_thickness: Array
    web_width: Array
    planes: Array
    rule: WebRule
    compliance: Array
    clearance: Array
    settlement: Array
    bearing_width: Array
    rod_bearing_width: Array
    thrust: int
    pulls: Pulls
    material: Material
    density: Array
    web_height: Array
    span_bending: Array | None
    is_elastic: bool
    has_clearance: bool


@record
class DeclaredCrankshafts:
    """The crankshafts of the file, one for each shaft of which it says so."""

    needs: ClassVar[str] = N_("[crankshaft]")
    reads: ClassVar[tuple[str, ...]] = ("[shaft.main]",)

    each: tuple[DeclaredCrankshaft, ...]

    @property
    def bearings(self) -> tuple[str, ...]:
        """Names of all main bearings."""
        return tuple(name for one in self.each for name in one.bearing_names)

    @property
    def labels(self) -> dict[str, tuple[str, ...]]:
        """Names of what results have of each."""
        return {"bearing": self.bearings}

    @property
    def is_elastic(self) -> bool:
        """Whether the file says of any bearing how it gives."""
        return any(one.is_elastic for one in self.each)

    @property
    def has_clearance(self) -> bool:
        """Whether it says of any bearing which clearance it has."""
        return any(one.has_clearance for one in self.each)


def declared_crankshafts(designs: Designs) -> DeclaredCrankshafts | None:
    """Put the table to the throws; None where there is none, or nothing says where the throws stand."""
    lines = designs.together.once(ShaftLines)
    found = [
        _declared(designs, number, name, table, line)
        for number, (name, table) in enumerate(lines.tables.items())
        if table is not None and (line := lines.line(designs.together, name)) is not None
    ]
    return DeclaredCrankshafts(tuple(found)) if found else None


def _spans(designs: Designs, table: CrankshaftTable, n: int) -> Array | None:
    """EI of spans where the table gives it, shape (design, span). [N·m²]"""
    given = table.span_bending_stiffness
    return None if given is None else designs.by_design(each_of(given, n))


def _declared(designs: Designs, number: int, name: str, table: CrankshaftTable, line: ShaftLine) -> DeclaredCrankshaft:
    by_design, pins, bearings = designs.by_design, line.pins, line.bearings
    prefix = "" if len(designs.together.shafts) == 1 else f"{name}."

    def pairs(ends: Sequence[tuple[Array, Array]]) -> Array:
        return by_design([one for pair in ends for one in pair]).reshape(designs.n_designs, -1, 2)

    planes, places = pairs(line.planes), by_design([bearing.z for bearing in bearings])
    standing_on = np.sum(planes[0, :, :1] < places[0], axis=0)
    pulls = _pulls(designs, name)
    journal = pairs(list(zip(line.journal_diameter, line.journal_bore, strict=True)))
    shoulders = DeclaredShoulders(
        np.array([one.journal for one in line.shoulders], dtype=np.intp),
        by_design([one.z for one in line.shoulders]),
        pairs([(one.diameter, one.bore) for one in line.shoulders]),
        tuple(one.name for one in line.shoulders),
    )
    gears: Mapping[str, GearSpec] = designs.together.tables.get("gear", {})
    geared = [z.array for gear in gears.values() if name in gear.shafts for z in gear.z]
    beside = (planes.reshape(len(planes), -1), places, pulls.z, shoulders.z, by_design(geared))
    refuse(_shoulder_problems(shoulders.z, np.concatenate(beside, axis=1)))
    return DeclaredCrankshaft(
        shaft=number,
        throw=np.array([pin.throw for pin in pins], dtype=np.intp),
        share=np.array([pin.share for pin in pins]),
        centres=by_design([pin.z for pin in pins]),
        journals=line.journals,
        bearing_names=tuple(f"{prefix}{bearing.name}" for bearing in bearings),
        bearings=places,
        standing_on=standing_on,
        journal=journal,
        shoulders=shoulders,
        at_bearings=_at_bearings(journal[:, standing_on, 0], standing_on, places, shoulders),
        pin=pairs(list(zip(line.pin_diameter, line.pin_bore, strict=True))),
        pin_length=by_design(line.pin_length),
        web_thickness=pairs(line.web_thickness),
        web_width=pairs(line.web_width),
        planes=planes,
        rule=next(rule for rule in WEB_RULES if rule.name == (table.web_length or "ker_wilson")),
        compliance=_compliance(designs, bearings),
        clearance=by_design([_half(bearing.table.clearance) for bearing in bearings]),
        settlement=pairs([_pair(bearing.table.settlement) for bearing in bearings]),
        bearing_width=by_design([_or_nan(bearing.table.width) for bearing in bearings]),
        rod_bearing_width=by_design([_or_nan(table.rod_bearing_width)])[:, 0],
        thrust=_thrust(table, bearings),
        pulls=pulls,
        material=_material(designs, table),
        density=by_design([(table.density or STEEL[2]).array])[:, 0],
        web_height=by_design([_or_nan(table.web_height)]),
        span_bending=_spans(designs, table, len(bearings) - 1),
        is_elastic=any(bearing.table.stiffness for bearing in bearings),
        has_clearance=any(bearing.table.clearance for bearing in bearings),
    )


def _shoulder_problems(z: Array, beside: Array) -> Iterator[Problem]:
    """Find designs in which shoulders stand on another side of something than in the first."""
    is_before = z[..., np.newaxis] <= beside[:, np.newaxis]
    if np.any(is_before != is_before[:1]):
        allowed = _("must stand between the same bearings, webs, pulls, gears and shoulders in all designs")
        yield Problem("crankshaft.shoulder", None, allowed)


def _at_bearings(diameter: Array, standing_on: NDArray[np.intp], z: Array, shoulders: DeclaredShoulders) -> Array:
    """Diameters of journals where bearings stand, of those that have shoulders behind the last before it."""
    found = diameter
    for number, journal in enumerate(shoulders.journal.tolist()):
        is_behind = (standing_on == journal) & (z >= shoulders.z[:, number, np.newaxis])
        found = np.where(is_behind, shoulders.size[:, number, np.newaxis, 0], found)
    return found


def _compliance(designs: Designs, bearings: Sequence[LineBearing]) -> Array:
    """Of every bearing toward X and Y, shape (design, bearing, 2, 2). [m/N]"""
    found = np.zeros((designs.n_designs, len(bearings), 2, 2))
    given = [bearing.table.stiffness for bearing in bearings]
    for axis in (0, 1):
        found[..., axis, axis] = designs.by_design(
            [ZERO if stiffness is None else ONE / stiffness[min(axis, len(stiffness) - 1)].array for stiffness in given]
        )
    if all(bearing.table.stiffness_direction is None for bearing in bearings):
        return found
    sense = -1.0 if designs.together.orientation.is_clockwise else 1.0
    directions = (bearing.table.stiffness_direction for bearing in bearings)
    turned = sense * designs.by_design([ZERO if one is None else one.array for one in directions])
    return turned_compliance(found[..., 0, 0], found[..., 1, 1], turned)


def _material(designs: Designs, table: CrankshaftTable) -> Material:
    young, poisson = (
        designs.by_design([(given or of_steel).array])[:, 0]
        for given, of_steel in zip((table.young_modulus, table.poisson_ratio), STEEL[:2], strict=True)
    )
    return Material(young, young / (2 * (1 + poisson)))


def _thrust(table: CrankshaftTable, bearings: Sequence[LineBearing]) -> int:
    names = [bearing.name for bearing in bearings]
    return len(names) - 1 if table.thrust_bearing is None else names.index(str(table.thrust_bearing))


def _pulls(designs: Designs, shaft: str) -> Pulls:
    """Pulls on a shaft, as the table of each design has them."""
    tables = [design.once(ShaftLines).tables[shaft] for design in designs.each]
    return pulls_of(designs, [table.pull for table in tables if table is not None], "crankshaft.pull")


def _half(given: Given | None) -> Array:
    return ZERO if given is None else given.array / 2


def _or_nan(given: Given | None) -> Array:
    return ZERO * np.nan if given is None else given.array


def _pair(given: tuple[Given, Given] | None) -> tuple[Array, Array]:
    return (ZERO, ZERO) if given is None else (given[0].array, given[1].array)
