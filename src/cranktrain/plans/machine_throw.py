"""A throw of a machine's crankshaft as fig. 35 of [crankshaft-reactions] has it, with what that has no letter for."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple, cast, get_args

import numpy as np

from cranktrain.analysis import Result, run
from cranktrain.errors import Problem, refuse
from cranktrain.grouping import grouped
from cranktrain.language import Listed, Words, _
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest, largest_of
from cranktrain.plans.acting import idle_problems
from cranktrain.plans.throw_loads import CrankMasses, ThrowLoad, ThrowSpan, of_member
from cranktrain.questions.crankshaft.bending.bearing_loads import bearing_loads, end_moments
from cranktrain.questions.crankshaft.bending.cut_shaft import cut_shaft, spans_of
from cranktrain.questions.crankshaft.bending.shaft_loads import AxisLoads
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts
from cranktrain.questions.crankshaft.methods.throw_reactions import (
    ThrowForces,
    ThrowLengths,
    ThrowReactions,
    throw_constituents,
    throw_reactions,
)
from cranktrain.record import record
from cranktrain.texts.throw_table import Rods, Throw

_NEEDED = "largest_bearing_load"
_WEIGHED = "[masses]"
"""Told with [gas], as what acts."""
_ONE_PLACE = 1e-9
"""Loads nearer than this act at one place. [m]"""
_ROUNDING = 1e-13
"""Of the largest force; what is less is none."""


class BeyondLoad(NamedTuple):
    """A load for which the text has no letter: its name, and what it is to the bearings. [N]"""

    name: Words
    share: ThrowReactions


@record
class MachineThrow:
    """A throw of a machine at some crank angles.

    Attributes
    ----------
    name : str
        Number of the throw, with several shafts below its shaft's name.
    bearings : tuple of str
        Those at its left and at its right.
    is_first, is_last : bool
        Whether it is next to an end of its shaft, where (48) and (49) count.
    is_clockwise : bool
        As it turns, seen from its left.
    has_mass : bool
        Whether [masses.crank] says what its crank weighs.
    rods : tuple of Words
        Whose rods are on the pin, those at one place together.
    throw : Throw
        Lengths of one value; forces of shape (n,).
    beyond : tuple of BeyondLoad
        Of shape (n,).
    exact : ThrowReactions
        By the shaft split at its bearings, of all loads between these two and beyond them; of shape (n,).
    """

    name: str
    bearings: tuple[str, str]
    is_first: bool
    is_last: bool
    is_clockwise: bool
    has_mass: bool
    rods: tuple[Words, ...]
    throw: Throw
    beyond: tuple[BeyondLoad, ...]
    exact: ThrowReactions

    @property
    def by_text(self) -> ThrowReactions:
        """By (44) to (53), of the loads for which there are letters."""
        found = throw_constituents(self.throw.lengths, self.throw.forces)
        return throw_reactions(found, is_first=self.is_first, is_last=self.is_last)

    def first(self) -> Throw:
        """The throw at the first of the angles, its forces single numbers."""
        return self.throw._replace(forces=ThrowForces(*(np.array(np.ravel(one)[0]) for one in self.throw.forces)))


class ThrownMachine:
    """A machine whose throws are looked at: solved once for its crankshafts."""

    def __init__(self, machine: Machine) -> None:
        """Lay its crankshafts out, and refuse a machine that has none, or on which nothing acts."""
        result = run(machine, quantities=(_NEEDED,))
        refuse([*idle_problems(machine), *_lacking(machine, result)])
        self.machine, self.loaded, self.crank_angle = machine, result[LoadedShafts], result.crank_angle

    @property
    def throws(self) -> dict[str, tuple[int, int]]:
        """Shaft and throw by the names of throws: their numbers, with several shafts below the shaft's name."""
        names = self.loaded.shafts.names
        return {
            f"{'' if len(names) == 1 else f'{names[one.layout.declared.shaft]}.'}{throw + 1}": (shaft, throw)
            for shaft, one in enumerate(self.loaded.each)
            for throw in sorted(set(one.layout.declared.throw.tolist()))
        }

    def usual_angle(self, over: MachineThrow) -> float:
        """Give the whole degree at which a bearing has its largest load, of a throw at `crank_angle`. [deg]"""
        load = over.exact
        return float(
            self.crank_angle[first_largest(np.maximum(np.hypot(load.kp, load.tp), np.hypot(load.kl, load.tl)))]
        )

    def throw(self, name: str, degrees: Array, masses: CrankMasses = "given") -> MachineThrow:
        """Give a throw at crank angles, shape (n,). [deg]

        Raises
        ------
        InputError
            If there is no such throw, or it is none of which the text speaks.
        """
        name = self._without_shaft(name)
        refuse(self._problems(name, degrees, masses))
        shaft, throw = self.throws[name]
        angle = np.deg2rad(degrees)[np.newaxis, np.newaxis] + self.loaded.zero
        return _Letters(ThrowSpan(self.loaded, shaft, throw, angle)).throw(name, masses)

    def _without_shaft(self, name: str) -> str:
        """Take the shaft's name from a throw's where there is but one shaft."""
        (first, *others) = self.loaded.shafts.names
        return name if others else name.removeprefix(f"{first}.")

    def _problems(self, name: str, degrees: Array, masses: str) -> Iterator[Problem]:
        """Refuse a throw that there is not, no angle, and other masses than those of which there are."""
        if name not in self.throws:
            allowed = _("must be the number of a throw: {names}", names=", ".join(self.throws))
            yield Problem("throw_number", name, allowed)
        if not np.all(np.isfinite(degrees)):
            yield Problem("at", str(degrees[~np.isfinite(degrees)][0]), _("must be a crank angle in degrees"))
        if masses not in (known := get_args(CrankMasses)):
            yield Problem("crank_masses", masses, _("must be one of: {names}", names=", ".join(known)))


def _lacking(machine: Machine, result: Result) -> Iterator[Problem]:
    """What a machine lacks for the loads of its main bearings, by path."""
    if _NEEDED in result.catalogue:
        return
    needs = [need.text for need in result.needs_of(_NEEDED)]
    if not needs:
        yield Problem("mechanism", None, _("must be pistons on a crankshaft: the text speaks of no other machine"))
    for path in (need.replace("] ", ".").strip("[]") for need in needs if need != _WEIGHED):
        if not _is_declared(machine, path):
            yield Problem(path, None, _("is missing: the loads of the main bearings need it"))


def _is_declared(machine: Machine, path: str) -> bool:
    """Whether a machine's file has something at a path."""
    found: object = machine.declared
    for part in path.split("."):
        is_table = isinstance(found, Mapping)
        found = cast("Mapping[str, object]", found).get(part) if is_table else getattr(found, part, None)
    return found is not None


class _Letters:
    """Puts what lies between two bearings to the letters of fig. 35."""

    def __init__(self, of: ThrowSpan) -> None:
        self.of = of

    def throw(self, name: str, masses: CrankMasses) -> MachineThrow:
        """Put every load to its letter, or to those for which there is none."""
        declared = self.of.one.layout.declared
        every = list(self.of.every(masses))
        found = self._lettered(every)
        return MachineThrow(
            name,
            (declared.bearing_names[self.of.span - 1], declared.bearing_names[self.of.span]),
            self.of.span == 1,
            self.of.span == declared.bearings.shape[1] - 1,
            self.of.one.layout.turn < 0,
            self._has_mass(),
            tuple(Listed([one.name for one in found[rod]]) for rod in ("rod 0", "rod 1") if rod in found),
            Throw(self._lengths(found), self._forces(found), self._rods(found)),
            tuple(self._beyond(found.get("", ()))),
            self._shares(every),
        )

    def _lettered(self, every: Sequence[ThrowLoad]) -> dict[str, list[ThrowLoad]]:
        """Loads by their letter; of rods more than two places along the pin, and of external weights more than one."""
        found = grouped((one.letter, one) for one in every)
        places = sorted({round(one.z / _ONE_PLACE) for one in found.get("rod", ())})
        for letter in ("rod", "turning"):
            sides = {place: side for side, place in enumerate(places[:2])}
            for one in found.pop(letter, ()):
                side = sides.get(round(one.z / _ONE_PLACE))
                found.setdefault("" if side is None else f"{letter} {side}", []).append(one)
        for side in ("external 0", "external 1"):
            if side in found:
                first = largest_of(found[side], lambda one: float(np.max(np.hypot(*one.force)))).z
                found.setdefault("", []).extend(one for one in found[side] if abs(one.z - first) > _ONE_PLACE)
                found[side] = [one for one in found[side] if abs(one.z - first) <= _ONE_PLACE]
        return found

    def _lengths(self, found: Mapping[str, Sequence[ThrowLoad]]) -> ThrowLengths:
        """Lengths of fig. 35."""
        declared = self.of.one.layout.declared
        centre = float(declared.centres[0, self.of.pin])
        (left_plane, right_plane), thick = declared.planes[0, self.of.pin], declared.web_thickness[0, self.of.pin]
        first, second = (found[f"rod {side}"][0].z if f"rod {side}" in found else centre for side in (0, 1))
        web_end, web_begin = left_plane + thick[0] / 2, right_plane - thick[1] / 2
        lengths = (
            left_plane - thick[0] / 2 - self.of.left,
            first - web_end,
            centre - first,
            second - centre,
            web_begin - second,
            self.of.right - right_plane - thick[1] / 2,
            *thick,
            self.of.left - found["external 0"][0].z if found.get("external 0") else 0.0,
            found["external 1"][0].z - self.of.right if found.get("external 1") else 0.0,
        )
        return ThrowLengths(*map(np.array, lengths))

    def _forces(self, found: Mapping[str, Sequence[ThrowLoad]]) -> ThrowForces:
        """Forces of fig. 35, each positive as the text has it."""

        def out(letter: str) -> Array:
            return sum((self._parts(one.force)[0] for one in found.get(letter, ())), start=self.of.none)

        def ahead(letter: str) -> Array:
            return sum((self._parts(one.force)[1] for one in found.get(letter, ())), start=self.of.none)

        each = ThrowForces(
            c1=-out("counterweight 0"),
            c2=out("web 0"),
            c3=out("turning 0"),
            c4=out("pin"),
            c5=out("turning 1"),
            c6=out("web 1"),
            c7=-out("counterweight 1"),
            c8=-ahead("web 0"),
            c9=-ahead("web 1"),
            c10=ahead("external 0"),
            c11=-out("external 0"),
            c12=-ahead("external 1"),
            c13=-out("external 1"),
            c14=-ahead("counterweight 0"),
            c15=-ahead("counterweight 1"),
            k1=-out("rod 0"),
            k2=-out("rod 1"),
            t1=ahead("rod 0"),
            t2=ahead("rod 1"),
        )
        rounding = _ROUNDING * max(float(np.max(np.abs(one))) for one in each)
        return ThrowForces(*(np.where(np.abs(one) > rounding, one, 0.0) for one in each))

    def _parts(self, force: Array) -> tuple[Array, Array]:
        """Parts of a force outward and with the rotation."""
        return np.sum(force * self.of.outward, axis=0), np.sum(force * self.of.ahead, axis=0)

    def _rods(self, found: Mapping[str, Sequence[ThrowLoad]]) -> Rods:
        """Whether slaves hang on the rods of the pin, or two are side by side."""
        names = [one.name for one in found.get("rod 0", ())]
        masters = self.of.carriers.master[self.of.carriers.master >= 0].tolist()
        if any(self.of.loaded.mechanisms.names[master] in names for master in masters):
            return "articulated"
        return "two" if "rod 1" in found else "one"

    def _has_mass(self) -> bool:
        """Whether any mechanism of the throw says what the crank weighs."""
        members = [
            self.of.member(int(mechanism))
            for mechanism in self.of.one.layout.rods.mechanism[self.of.one.layout.rods.pin == self.of.pin]
        ]
        bodies = [(batch.kind.dynamics.by_link(made.bodies)["crank"], member) for batch, made, member in members]
        return any(of_member(body.mass, member) > 0 for body, member in bodies)

    def _shares(self, loads: Sequence[ThrowLoad]) -> ThrowReactions:
        """What loads are to both bearings, cut from the rest of the shaft."""
        place = np.array([[self.of.left, self.of.right]])
        z = np.array([[one.z for one in loads]])
        force, couple = (
            np.stack(parts)[np.newaxis] for parts in ([one.force for one in loads], [one.couple for one in loads])
        )
        cut = cut_shaft(place, spans_of(place, z)[0], AxisLoads(z, force, couple))
        borne = bearing_loads(place, cut, end_moments(2, cut), settlement=np.zeros((1, 2, 2, 1)), compliance=None)
        (left_out, left_ahead), (right_out, right_ahead) = (self._parts(borne.load[0, side]) for side in (0, 1))
        return ThrowReactions(-right_out, right_ahead, -left_out, left_ahead)

    def _beyond(self, others: Sequence[ThrowLoad]) -> Iterator[BeyondLoad]:
        """Loads without a letter by their names, but those that are nothing."""
        for name, loads in grouped((one.name, one) for one in others).items():
            if any(np.any(part) for one in loads for part in (one.force, one.couple)):
                yield BeyondLoad(name, self._shares(loads))
