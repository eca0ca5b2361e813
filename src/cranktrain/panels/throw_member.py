"""One mechanism to draw: its pins over a turn, the line of its stroke, its bore; and where shafts and cylinders are."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.mechanisms.drawing import Drawing, Guide
from cranktrain.mechanisms.output import OutputPart
from cranktrain.motion import Array, Point
from cranktrain.panels.crosshead import CrossheadDrawing, crosshead_of
from cranktrain.panels.ram import RamDrawing, ram_of, upward
from cranktrain.plans.placement import output_of
from cranktrain.plans.stroke_lines import Along, guide_line, unit
from cranktrain.questions.cylinders.declared import SIDES, cylinders_of
from cranktrain.record import record


@record
class DrawnMechanism:
    """One mechanism, where it stands, in metres or millimetres.

    Attributes
    ----------
    place : PlacedMechanism
    is_first : bool
        Drawn filled; all others hollow.
    turn : Drawing
        Its pins at crank angles all round a turn, shape (n,), in the unit of length of all its lengths.
    bore : float or None
        None where the file has none.
    centre : Array, shape (2,)
        Of its shaft, from the main one.
    cut : float
        By how much its rod is drawn too short, broken.
    works_at_crank : bool
        Whether its piston has a chamber at the crank end, so that a piston rod leads to a crosshead.
    piston_rod : float or None
        Diameter of that rod; None where the file has none.
    is_bare : bool
        Whether it works on something outside a cylinder, as a press's ram does.
    """

    place: PlacedMechanism
    is_first: bool
    turn: Drawing
    bore: float | None
    centre: Array
    cut: float = 0.0
    works_at_crank: bool = False
    piston_rod: float | None = None
    is_bare: bool = False

    @cached_property
    def turn_pins(self) -> dict[str, Array]:
        """Where its pins are over the turn, by name, shape (2, n)."""
        return self.turn.positions

    @property
    def output(self) -> str | None:
        """Name of the pin that slides in this mechanism's own guide; None for a rocker."""
        is_slider = self.place.kind.output.is_slider
        return self.turn.guides[0].pin if is_slider and self.turn.guides else None

    @property
    def crank_pin(self) -> str:
        """Name of the crank's pin: the second of the link that is drawn first."""
        return self.turn.links[0].pins[1]

    @property
    def metal(self) -> tuple[str, ...]:
        """Names of its pins without the points that are only followed."""
        return tuple(name for name in self.turn.pins if name not in self.turn.points)

    @property
    def is_plain(self) -> bool:
        """Whether it is drawn link by link: a mechanism that is not one of the engine's."""
        return not self.place.kind.is_outlined

    @cached_property
    def stroke_line(self) -> Along:
        """Line on which the output pin travels; its foot is nearest the shaft."""
        return self.line_of(self.turn.guides[0])

    def line_of(self, guide: Guide) -> Along:
        """Line of one of its guides, which needs one angle at which the links close; its foot is nearest the shaft."""
        pin = self.turn_pins[guide.pin]
        closed = np.flatnonzero(np.isfinite(pin[0]))
        return guide_line(guide.direction, pin[:, closed[0] if closed.size else 0], self.centre)

    @cached_property
    def travel(self) -> tuple[float, float]:
        """Nearest and farthest place of the output pin on its line; NaN without a line."""
        if not self.turn.guides:
            return np.nan, np.nan
        places = self.stroke_line.place(self.turn_pins[self.turn.guides[0].pin])
        return float(np.nanmin(places)), float(np.nanmax(places))

    @cached_property
    def crosshead(self) -> CrossheadDrawing | None:
        """Crosshead and cylinder of a piston that works at its crank end; None of any other, or without a bore."""
        return self.crosshead_along(np.array(self.travel))

    def crosshead_along(self, travel: Array) -> CrossheadDrawing | None:
        """Give crosshead and cylinder for a travel of the pin, its nearest and farthest place, shape (2,)."""
        if self.bore is None or not self.works_at_crank or not self.turn.guides:
            return None
        return crosshead_of(travel, self.bore, self.piston_rod)

    @cached_property
    def ram(self) -> RamDrawing | None:
        """Ram over its bed, of a slider without a cylinder that works downward; None of any other."""
        return self.ram_along(np.array(self.travel)) if self.output is not None else None

    def ram_along(self, travel: Array) -> RamDrawing | None:
        """Give the ram for a travel of the pin, its nearest and farthest place, shape (2,)."""
        if not self.is_bare or not self.turn.guides:
            return None
        return ram_of(travel) if upward(self.stroke_line.along) < 0 else None

    @property
    def toward_chamber(self) -> float:
        """+1 where its crown is the end away from its shaft, −1 of a piston with side rods."""
        return -1.0 if self.place.is_far else 1.0

    @property
    def width(self) -> float:
        """Bore; where the file has none, 0.6 of the stroke for the crosshead that is drawn instead."""
        if self.ram is not None:
            return self.ram.width
        return self.bore if self.bore is not None else 0.6 * (self.travel[1] - self.travel[0])


@record
class CylinderSizes:
    """How large cylinders are.

    Attributes
    ----------
    bores : mapping of mechanism to float
        [m]
    ports : mapping of cylinder to mapping of "exhaust" and "scavenge" to float
        Heights of ports. [m]
    bare : set of mechanism
        Those that work on something outside a cylinder.
    rods : mapping of mechanism to float or None
        Diameters of the piston rods of those that work at their crank end, None where the file has none. [m]
    """

    bores: Mapping[str, float]
    ports: Mapping[str, Mapping[str, float]]
    rods: Mapping[str, float | None]
    bare: frozenset[str]

    def member(
        self, place: PlacedMechanism, turn: Drawing, centre: Array, *, is_first: bool, per_metre: float = 1.0
    ) -> DrawnMechanism:
        """Give a mechanism to draw with its sizes, in a unit of length of which a metre has so many."""
        bore, rod = self.bores.get(place.name), self.rods.get(place.name)
        return DrawnMechanism(
            place=place,
            is_first=is_first,
            turn=turn,
            bore=None if bore is None else per_metre * bore,
            centre=centre,
            works_at_crank=place.name in self.rods,
            piston_rod=None if rod is None else per_metre * rod,
            is_bare=place.name in self.bare,
        )


def is_ram(output: OutputPart) -> bool:
    """Whether a part is a slider that works on something outside a cylinder."""
    return output.is_slider and output.is_loaded and not output.has_chambers


def cylinder_sizes(machine: Machine, places: Sequence[PlacedMechanism]) -> CylinderSizes:
    """Say how large the cylinders of some mechanisms are, of what the file gives."""
    pistons = [place for place in places if place.kind.output.is_slider]
    cylinders = cylinders_of(machine.cylinder, pistons)
    bored = ((pistons[i].name, one.bore) for one in cylinders for i in one.pistons)
    ports = {
        cylinder.name: {
            end: height.si
            for end, height in (("exhaust", cylinder.exhaust_port), ("scavenge", cylinder.scavenge_port))
            if height is not None
        }
        for cylinder in cylinders
    }
    rods = {
        pistons[i].name: None if one.piston_rod is None else one.piston_rod.si
        for one in cylinders
        if SIDES[1] in one.chambers
        for i in one.pistons
    }
    bare = (one.name for one in pistons if is_ram(output_of(machine, one)))
    return CylinderSizes({name: bore.si for name, bore in bored if bore is not None}, ports, rods, frozenset(bare))


def standing(drawing: Drawing, centre: Array, cut: float = 0.0) -> Drawing:
    """Move a drawing to where its shaft is; with a cut, its output so much nearer to the shaft."""

    def moved(pin: Point, by: Array) -> Point:
        return Point(*(part._replace(value=part.value + step) for part, step in zip(pin, by, strict=True)))

    pins = {name: moved(pin, centre) for name, pin in drawing.pins.items()}
    if cut:
        guide = drawing.guides[0]
        pins[guide.pin] = moved(pins[guide.pin], -cut * unit(guide.direction).reshape(2))
    return replace(drawing, pins=pins)
