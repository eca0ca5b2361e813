"""What is wrong with crankshafts and gears that only the whole machine shows."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

import numpy as np

from cranktrain.errors import Problem, judged
from cranktrain.language import Words, _
from cranktrain.layout.design import Design
from cranktrain.layout.shafts import throw_positions
from cranktrain.layout.specs import MAIN
from cranktrain.motion import plain
from cranktrain.quantities import Given, one_of
from cranktrain.questions.crankshaft.shaft_line import (
    LinePin,
    ShaftLine,
    ShaftLines,
    line_pins,
    path_of,
    resting,
)
from cranktrain.questions.crankshaft.spec import NEEDED, CrankshaftSpec, CrankshaftTable, GearSpec
from cranktrain.record import record
from cranktrain.saying.wording import as_limit

_TOUCHING = 1e-9
"""Lengths that differ by less are the same. [m]"""


def crankshaft_problems(spec: CrankshaftSpec, design: Design) -> Iterator[Problem]:
    """Find tables of shafts that there are not, what is missing or too much, and what does not stand on the shaft."""
    for name in spec.overrides:
        if name not in design.shafts:
            yield Problem(f"crankshaft.{name}", None, one_of(design.shafts))
    yield from judged(_spacing_of_some(design))
    tables = dict(design.once(ShaftLines).tables)
    if not any(tables.values()) and not spec.overrides:
        tables[MAIN] = spec
    for name, table in tables.items():
        if table is not None:
            yield from judged(_OneShaft(spec, design, name, table).problems())


def _spacing_of_some(design: Design) -> Iterator[Problem]:
    """Find shafts that do not say where their throws stand, where others do: then no place along any is known."""
    without = [name for name, shaft in design.shafts.items() if throw_positions(shaft) is None]
    if any(design.shafts[name].spacing is not None for name in design.shafts if name not in without):
        allowed = _("is missing: either all shafts say where their throws stand, or none")
        yield from (Problem(f"shaft.{name}.spacing", None, allowed) for name in without)


@record
class _OneShaft:
    """The table of one shaft, and whose it is."""

    spec: CrankshaftSpec
    design: Design
    name: str
    table: CrankshaftTable

    def problem(self, key: str, given: Words | None, allowed: Words) -> Problem:
        return Problem(path_of(self.spec, self.name, key), given, allowed)

    def problems(self) -> Iterator[Problem]:
        missing = [key for key in NEEDED if getattr(self.table, key) is None]
        yield from (self.problem(key, None, _("is missing")) for key in missing)
        if throw_positions(self.design.shafts[self.name]) is None:
            return
        if self._has_side_rods and self.table.side_rod_distance is None:
            yield self.problem("side_rod_distance", None, _("is missing: a far piston's side rods have two pins"))
            return
        pins = line_pins(self.table, self.design, self.name)
        assert pins is not None
        at_one_place = list(self._at_one_place(pins))
        if at_one_place:
            yield from at_one_place
            return
        found = [*self._counts(len(pins)), *self._numbers(len(pins))]
        yield from found
        if not found and not missing:
            line = self.design.once(ShaftLines).line(self.design, self.name)
            assert line is not None
            yield from self._in_line(line)

    @property
    def _has_side_rods(self) -> bool:
        return any(place.is_far and place.shaft == self.name for place in self.design.places)

    def _at_one_place(self, pins: Sequence[LinePin]) -> Iterator[Problem]:
        """Find pins that do not stand apart."""
        for one, other in pairwise(pins):
            if plain(other.z - one.z) <= _TOUCHING:
                throws = sorted((one.throw + 1, other.throw + 1))
                allowed = _(
                    "must part throws {one} and {other}, whose pins stand at one place; or leave [crankshaft] out"
                )
                said = allowed.format(one=throws[0], other=throws[1])
                yield Problem(f"shaft.{self.name}.spacing", None, said)

    def _counts(self, n: int) -> Iterator[Problem]:
        """Find lists that are not as long as there are pins or journals."""
        of_pins, of_journals = (1, n), (1, n + 1)
        lengths = {
            **dict.fromkeys(("journal_diameter", "journal_bore"), of_journals),
            **dict.fromkeys(("pin_diameter", "pin_bore", "pin_length"), of_pins),
            **dict.fromkeys(("web_thickness", "web_width"), (1, n, 2 * n)),
        }
        for key, allowed in lengths.items():
            values = getattr(self.table, key)
            if values is not None and len(values) not in allowed:
                counts = ", ".join(map(str, sorted(set(allowed))))
                said = _("must be one value, or a list of as many as there are: {counts}")
                yield self.problem(key, _("a list of {n}", n=len(values)), said.format(counts=counts))

    def _numbers(self, n: int) -> Iterator[Problem]:
        """Find journals and bearings that are not there, and a shaft that floats."""
        table, there = self.table, range(1, n + 2)
        for key in ("journals", "bearings"):
            for number in getattr(table, key) or ():
                if number not in there:
                    allowed = _("must be journals, 1 to {n}", n=n + 1)
                    yield self.problem(key, str(number), allowed)
        if table.journals is not None and table.bearings is not None:
            for number in table.bearings:
                if number in there and number not in table.journals:
                    allowed = _("must be journals that there are, of which journals names {n}")
                    named = ", ".join(map(str, table.journals))
                    yield self.problem("bearings", str(number), allowed.format(n=named))
        own = [str(number) for number in resting(table, n)]
        for name, bearing in table.bearing.items():
            if name not in own and bearing.z is None:
                allowed = _("is missing; only bearings of journals have a place of their own: {names}")
                yield self.problem(f"bearing.{name}.z", None, allowed.format(names=", ".join(own)))
        names = [*own, *(name for name in table.bearing if name not in own)]
        given = table.span_bending_stiffness
        if given is not None and len(given) not in (1, len(names) - 1):
            allowed = _("must be one value, or one for each span between neighbouring bearings: {n}", n=len(names) - 1)
            yield self.problem("span_bending_stiffness", _("a list of {n}", n=len(given)), allowed)
        if len(names) < 2:
            allowed = _("must be two or more, or the shaft floats; name one more in [crankshaft.bearing.NAME]")
            yield self.problem("bearings", ", ".join(names) or None, allowed)
        if table.thrust_bearing is not None and str(table.thrust_bearing) not in names:
            yield self.problem("thrust_bearing", str(table.thrust_bearing), one_of(names))
        if n == 1 and table.bearing_distance is None:
            missing = [one for one in own if one not in table.bearing or table.bearing[one].z is None]
            if missing:
                yield self.problem("bearing_distance", None, _("is missing: one pin alone does not say it"))

    def _in_line(self, line: ShaftLine) -> Iterator[Problem]:
        """Find bores that leave nothing, throws without room, and what stands where it cannot."""
        yield from self._bores(line)
        room = list(self._room(line))
        yield from room
        if room:
            return
        yield from self._standing(line)
        yield from self._rods(line)

    def _bores(self, line: ShaftLine) -> Iterator[Problem]:
        for name in ("journal", "pin"):
            diameters, bores = getattr(line, f"{name}_diameter"), getattr(line, f"{name}_bore")
            for diameter, bore in zip(diameters, bores, strict=True):
                if bore >= diameter:
                    allowed = _("must be less than {name}_diameter = {diameter}")
                    said = allowed.format(name=name, diameter=as_limit(plain(diameter)))
                    yield self.problem(f"{name}_bore", as_limit(plain(bore)), said)
                    break

    def _room(self, line: ShaftLine) -> Iterator[Problem]:
        """Find two webs that leave no journal, and no web, between them."""
        for number, is_there in enumerate(line.journals[1:-1].tolist()):
            begin, end = line.planes[number][1], line.planes[number + 1][0]
            gap = plain(end - begin - (line.web_thickness[number][1] + line.web_thickness[number + 1][0]) / 2)
            if not is_there:
                gap = plain(line.web_thickness[number][1])
            if gap <= _TOUCHING:
                given = self.table.pin_length
                allowed = _("must leave room between pins {one} and {other} with their webs: more than {gap} more")
                said = allowed.format(one=number + 1, other=number + 2, gap=as_limit(-gap))
                yield self.problem("pin_length", _texts(given), said)

    def _standing(self, line: ShaftLine) -> Iterator[Problem]:
        """Find bearings and pulls that stand in a throw, or beyond a pin that hangs over."""
        for bearing in line.bearings:
            if not _on_journal(line, plain(bearing.z)):
                allowed = _("must stand on a journal, clear of webs and pins, and is at {z} from throw 1")
                own = self.table.bearing.get(bearing.name)
                key = "bearing_distance" if own is None else f"bearing.{bearing.name}.z"
                given = self.table.bearing_distance if own is None else own.z
                said = allowed.format(z=as_limit(plain(bearing.z)))
                yield self.problem(key, None if given is None else given.text, said)
        yield from self._directions(line)
        yield from self._apart(line)
        for name, pull in self.table.pull.items():
            if not _on_journal(line, pull.z.si):
                yield self.problem(f"pull.{name}.z", pull.z.text, _("must be on a journal, clear of webs and pins"))
        yield from self._gears(line)
        yield from self._shoulders(line)

    def _shoulders(self, line: ShaftLine) -> Iterator[Problem]:
        """Find shoulders in throws, at one place or within a bearing, and bores that leave nothing."""
        for number, shoulder in enumerate(line.shoulders):
            where, given = f"shoulder.{shoulder.name}", self.table.shoulder[shoulder.name]
            z = plain(shoulder.z)
            if not _on_journal(line, z):
                yield self.problem(f"{where}.z", given.z.text, _("must be on a journal, clear of webs and pins"))
            if number and z - plain(line.shoulders[number - 1].z) <= _TOUCHING:
                allowed = _("must stand apart from {other}", other=line.shoulders[number - 1].name)
                yield self.problem(f"{where}.z", given.z.text, allowed)
            for bearing in line.bearings:
                width = 0.0 if bearing.table.width is None else bearing.table.width.si
                if abs(z - plain(bearing.z)) < width / 2:
                    allowed = _("must stand clear of bearing {name} and its width", name=bearing.name)
                    yield self.problem(f"{where}.z", given.z.text, allowed)
            if shoulder.bore >= shoulder.diameter:
                allowed = _("must be more than its bore, {bore}", bore=as_limit(plain(shoulder.bore)))
                yield self.problem(f"{where}.diameter", given.diameter.text, allowed)

    def _directions(self, line: ShaftLine) -> Iterator[Problem]:
        """Find directions of stiffnesses that are alike all round, or of none."""
        two = [one.name for one in line.bearings if one.table.stiffness is not None and len(one.table.stiffness) == 2]
        allowed = _("is for a stiffness of two directions; give two")
        common = self.table.bearing_stiffness_direction
        if common is not None and not two:
            yield self.problem("bearing_stiffness_direction", common.text, allowed)
        for name, bearing in self.table.bearing.items():
            if bearing.stiffness_direction is not None and name not in two:
                yield self.problem(f"bearing.{name}.stiffness_direction", bearing.stiffness_direction.text, allowed)

    def _apart(self, line: ShaftLine) -> Iterator[Problem]:
        """Find bearings at one place, and such as are too wide to stand beside each other."""
        for one, other in pairwise(line.bearings):
            apart = plain(other.z - one.z)
            widths = [0.0 if own.table.width is None else own.table.width.si for own in (one, other)]
            if apart <= _TOUCHING:
                yield self.problem("bearing", None, _("must stand apart from one another along the shaft"))
            elif apart < sum(widths) / 2:
                allowed = _("must stand clear of one another: {one} and {other} are {apart} apart, and wider")
                said = allowed.format(one=one.name, other=other.name, apart=as_limit(apart))
                yield self.problem("bearing", None, said)

    def _gears(self, line: ShaftLine) -> Iterator[Problem]:
        """Find gears on this shaft that sit in a throw."""
        gears: Mapping[str, GearSpec] = self.design.tables.get("gear", {})
        for name, gear in gears.items():
            if self.name in gear.shafts:
                number = min(gear.shafts.index(self.name), len(gear.z) - 1)
                z = gear.z[number]
                if not _on_journal(line, z.si):
                    allowed = _("must be on a journal of the shaft {shaft}, clear of webs and pins")
                    key = f"z[{number}]" if len(gear.z) > 1 else "z"
                    yield Problem(f"gear.{name}.{key}", z.text, allowed.format(shaft=self.name))

    def _rods(self, line: ShaftLine) -> Iterator[Problem]:
        """Find rods for which there is no place on their pin; of those as far aside the first."""
        found = list[tuple[float, float]]()
        for place in self.design.places:
            if place.shaft != self.name or place.is_far or place.kind.is_slave:
                continue
            number = next(i for i, pin in enumerate(line.pins) if pin.throw == place.throw)
            aside, length = abs(plain(place.stagger)), plain(line.pin_length[number])
            if 2 * aside >= length and (aside, length) not in found:
                found.append((aside, length))
                allowed = _("must reach to the rod of {name}, which is {aside} from the middle of its pin")
                said = allowed.format(name=place.name, aside=as_limit(aside))
                yield self.problem("pin_length", as_limit(length), said)


def _on_journal(line: ShaftLine, z: float) -> bool:
    """Whether a place on the shaft is on a journal that there is."""
    number = sum(plain(pin.z) < z for pin in line.pins)
    if not line.journals[number]:
        return False
    begin = -np.inf if number == 0 else plain(line.planes[number - 1][1] + line.web_thickness[number - 1][1] / 2)
    end = np.inf if number == len(line.pins) else plain(line.planes[number][0] - line.web_thickness[number][0] / 2)
    return begin < z < end


def _texts(given: Sequence[Given] | None) -> str | None:
    return None if given is None else ", ".join(one.text for one in given)
