"""A throw of a machine's crankshaft as fig. 35 of [crankshaft-reactions] has it, with what that has no letter for."""

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis import run
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.layout.masses import MechanismMasses
from cranktrain.layout.mechanisms import Batch
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.plans.acting import refuse_idle
from cranktrain.questions.crankshaft.acting import LoadedShafts
from cranktrain.questions.crankshaft.bearing_loads import bearing_loads, end_moments
from cranktrain.questions.crankshaft.crank_sizes import crank_parts
from cranktrain.questions.crankshaft.shaft_loads import AxisLoads, on_axis
from cranktrain.questions.crankshaft.spans import cut_shaft, spans_of
from cranktrain.questions.crankshaft.throw_reactions import (
    ThrowForces,
    ThrowLengths,
    ThrowReactions,
    throw_constituents,
    throw_reactions,
)
from cranktrain.questions.forces.rod_masses import weighed_ends
from cranktrain.record import record
from cranktrain.texts.throw_table import Rods, Throw

CrankMasses = Literal["given", "sizes"]
"""Of which a crank's inertia is: of [masses.crank], as everywhere, or of its sizes in [crankshaft]."""

CRANK_MASSES = ("given", "sizes")

_NEEDED = "largest_bearing_load"
_ONE_PLACE = 1e-9
"""Loads nearer than this act at one place. [m]"""
_ROUNDING = 1e-13
"""Of the largest force; what is less is none."""


class BeyondLoad(NamedTuple):
    """A load for which the text has no letter: its name, and what it is to the bearings. [N]"""

    name: str
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
    rods : tuple of str
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
    rods: tuple[str, ...]
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
        refuse_idle(machine)
        result = run(machine, quantities=(_NEEDED,))
        if _NEEDED not in result.catalogue:
            needs = ", ".join(result.needs_of(_NEEDED))
            allowed = _("the loads of its main bearings need {needs}").format(needs=needs)
            repair = _("`cranktrain textbook FILE` shows what the texts have for other machines")
            raise InputError([Problem("", None, allowed, repair)])
        self.machine, self.loaded, self.crank_angle = machine, result[LoadedShafts], result.crank_angle

    @property
    def throws(self) -> dict[str, tuple[int, int]]:
        """Shaft and throw by the names of throws: their numbers, with several shafts below the shaft's name."""
        names = self.loaded.shafts.names
        return {
            f"{'' if len(names) == 1 else f'{names[one.laid.declared.shaft]}.'}{throw + 1}": (shaft, throw)
            for shaft, one in enumerate(self.loaded.each)
            for throw in sorted(set(one.laid.declared.throw.tolist()))
        }

    def usual_angle(self, name: str, masses: CrankMasses = "given") -> float:
        """The whole degree at which one of the throw's bearings has the largest load of its cycle. [deg]"""
        load = self.throw(name, self.crank_angle, masses).exact
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
        refuse(self._problems(name, degrees, masses))
        shaft, throw = self.throws[name]
        angle = np.deg2rad(degrees)[np.newaxis, np.newaxis] + self.loaded.zero
        return _Span(self.loaded, shaft, throw, angle).throw(name, masses)

    def _problems(self, name: str, degrees: Array, masses: str) -> Iterator[Problem]:
        """Refuse a throw that there is not, no angle, and other masses than those of which there are."""
        if name not in self.throws:
            allowed = _("must be the number of a throw: {names}").format(names=", ".join(self.throws))
            yield Problem("throw_number", name, allowed)
        if not np.all(np.isfinite(degrees)):
            yield Problem("at", str(degrees[~np.isfinite(degrees)][0]), _("must be a crank angle in degrees"))
        if masses not in CRANK_MASSES:
            yield Problem("crank_masses", masses, _("must be one of: {names}").format(names=", ".join(CRANK_MASSES)))


class _Load(NamedTuple):
    """A load on the shaft.

    name: in words; letter: of fig. 35, empty of what has none there; z: where along the shaft [m]; force: toward X and
    Y, shape (2, n) [N]; couple: sum of z times force beside that, of the same shape. [N·m]
    """

    name: str
    letter: str
    z: float
    force: Array
    couple: Array


class _Span:
    """What lies between two bearings, and at an end of the shaft beyond them, at crank angles φ, shape (1, 1, n)."""

    def __init__(self, of: LoadedShafts, shaft: int, throw: int, angle: Array) -> None:
        self.loaded, self.frames, self.turn, self.one = of.loaded, of.frames, of.turn, of.each[shaft]
        self.carriers = of.loaded.carriers
        declared = self.one.laid.declared
        own = np.flatnonzero(declared.throw == throw)
        self.pin = int(own[0])
        self.span = self._span(own)
        self.left, self.right = declared.bearings[0, self.span - 1 : self.span + 1].tolist()
        self.loads = of.loads(angle)[shaft].loads
        self.on_axis = on_axis(self.loads)
        self.speed = np.broadcast_to(self.loaded.speed.drive(angle).speed, angle.shape)[0, 0]
        self.piece = int(self.one.laid.pins[self.pin])
        pieces = self.one.shaft.pieces
        self.radius = float(pieces.radius[0, self.piece])
        self.outward, self.ahead = self._directions(self.pin)
        self.none = np.zeros_like(self.speed)

    def _directions(self, pin: int) -> tuple[Array, Array]:
        """Where a pin points from the shaft's axis, and 90° ahead of that in the sense of rotation."""
        turned = self.loads.turned[0] + self.one.shaft.pieces.angle[0, self.one.laid.pins[pin]]
        return np.stack([np.cos(turned), np.sin(turned)]), self.one.laid.turn * np.stack(
            [-np.sin(turned), np.cos(turned)]
        )

    def _span(self, own: NDArray[np.intp]) -> int:
        """Which span the throw's pin is in, from 1; refuse what the text does not speak of."""
        declared = self.one.laid.declared
        spans = spans_of(declared.bearings, declared.centres)[0]
        span, throws = int(spans[own[0]]), declared.throw[spans == spans[own[0]]]
        allowed = ""
        if not 0 < span < declared.bearings.shape[1]:
            allowed = _("hangs over: (44) to (53) are of a throw between two supports")
        elif own.size > 1:
            allowed = _("has {n} pins, of side rods: (44) to (53) are of one pin between two supports")
            allowed = allowed.format(n=own.size)
        elif throws.size > 1:
            allowed = _(
                "is one of {n} between bearings {left} and {right}, and (44) to (53) are written in one throw's axes; "
                "the split shaft of `run` has them all"
            ).format(n=throws.size, left=declared.bearing_names[span - 1], right=declared.bearing_names[span])
        if allowed:
            raise InputError([Problem("throw_number", str(int(declared.throw[own[0]]) + 1), allowed)])
        return span

    def throw(self, name: str, masses: CrankMasses) -> MachineThrow:
        """Put every load to its letter, or to those for which there is none."""
        declared = self.one.laid.declared
        every = list(self._every(masses))
        found = self._lettered(every)
        return MachineThrow(
            name,
            (declared.bearing_names[self.span - 1], declared.bearing_names[self.span]),
            self.span == 1,
            self.span == declared.bearings.shape[1] - 1,
            self.one.laid.turn < 0,
            self._has_mass(),
            tuple(", ".join(one.name for one in found[rod]) for rod in ("rod 0", "rod 1") if rod in found),
            Throw(self._lengths(found), self._forces(found), self._rods(found)),
            tuple(self._beyond(found.get("", ()))),
            self._shares(every),
        )

    def _is_here(self, z: float) -> bool:
        """Whether a place is between the bearings, or beyond one at an end of the shaft."""
        bearings = self.one.laid.declared.bearings
        span, n = int(spans_of(bearings, np.array([[z]]))[0, 0]), bearings.shape[1]
        return span == self.span or (span == 0 and self.span == 1) or (span == n and self.span == n - 1)

    def _every(self, masses: CrankMasses) -> Iterator[_Load]:
        """All that acts here, with letters or without, in the order in which the shaft's loads stand."""
        one = self.one
        sorts = (
            (one.rods.number.size, self._rod),
            (one.cranks.number.size, partial(self._crank, masses=masses)),
            (one.held.number.size, self._weight),
            (one.laid.declared.pulls.z.shape[1], self._pull),
            (len(one.meshes), self._gear),
        )
        load = 0
        for n, of_sort in sorts:
            for number_of in range(n):
                if self._is_here(float(self.loads.z[0, load])):
                    yield from of_sort(load, number_of)
                load += 1
        if masses == "sizes":
            yield from self._sized()

    def _load(self, load: int, name: str, letter: str = "", force: Array | None = None) -> _Load:
        """One of the shaft's loads, or a part of it."""
        whole = self.on_axis.force[0, load]
        couples = self.on_axis.couple
        couple = np.zeros_like(whole) if couples is None or force is not None else couples[0, load]
        return _Load(name, letter, float(self.loads.z[0, load]), whole if force is None else force, couple)

    def _rod(self, load: int, number_of: int) -> Iterator[_Load]:
        """A rod on this pin: what turns of it, K and T, the weight of what turns; one that hangs over has no letter."""
        mechanism = int(self.one.rods.number[number_of])
        name = self.loaded.mechanisms.names[mechanism]
        if int(self.loads.piece[load]) != self.piece:
            yield self._load(load, _("rod of {name}, on a pin that hangs over").format(name=name))
            return
        turning, weight = self._turning_rod(mechanism)
        yield self._load(load, name, "turning", turning)
        yield self._load(load, name, "rod", self.on_axis.force[0, load] - turning - weight)
        yield self._load(load, _("weight of what turns of the rods"), "", weight)

    def _turning_rod(self, mechanism: int) -> tuple[Array, Array]:
        """Centrifugal force of a rod's share that turns with the pin, and its weight, toward X and Y. [N]"""
        batch, made, member = self._member(mechanism)
        body = batch.kind.dynamics.by_link(made.bodies).get("rod")
        length = getattr(batch.members.geometry, "rod_length", None)
        if body is None or length is None:
            return np.zeros_like(self.outward), np.zeros_like(self.outward)
        mass = _of_member(weighed_ends(body, length).first, member)
        pull = self.frames.common(np.array([mechanism]), *(np.atleast_1d(_of_member(g, member)) for g in made.gravity))
        down = np.array([-self.turn * pull.imag.item(), pull.real.item()])[:, np.newaxis]
        return mass * self.radius * self.speed**2 * self.outward, mass * down * np.ones_like(self.outward)

    def _member(self, mechanism: int) -> tuple[Batch, MechanismMasses, int]:
        """Batch, bodies and place in it of a mechanism."""
        batches = zip(self.loaded.mechanisms.batches, self.loaded.masses.batches, strict=True)
        batch, made = next(pair for pair in batches if mechanism in pair[0].index)
        return batch, made, batch.index.tolist().index(mechanism)

    def _crank(self, load: int, number_of: int, masses: CrankMasses) -> Iterator[_Load]:
        """A crank's part on a web: its inertia, and what else acts on it."""
        number, part = self.one.cranks
        web, webs = int(self.loads.piece[load]), self.one.laid.webs[self.pin].tolist()
        mechanism = int(number[number_of])
        outward, ahead = self._directions(int(self.one.laid.rods.pin[self.one.laid.rods.mechanism == mechanism][0]))
        batch, made, member = self._member(mechanism)
        body = batch.kind.dynamics.by_link(made.bodies)["crank"]
        along, across = (_of_member(body.mass * arm, member) for arm in (body.along, body.across))
        share = float(part[0, number_of]) * self.speed**2
        inertia = share * (along * outward + across * ahead)
        if web not in webs:
            name = _("crank whose pin hangs over")
            yield self._load(load, name, "", None if masses == "given" else self.on_axis.force[0, load] - inertia)
            return
        if masses == "given":
            yield self._load(load, _("web"), f"web {webs.index(web)}", inertia)
        rest = self.on_axis.force[0, load] - inertia
        yield self._load(load, _("weight of the crank, and loads on it"), "", rest)

    def _sized(self) -> Iterator[_Load]:
        """Inertia of pin and webs by their sizes; of other pins here as of what hangs over."""
        declared, parts = self.one.laid.declared, crank_parts(self.one.laid)
        none = np.zeros_like(self.outward)
        for pin in range(declared.throw.size):
            centre, planes = float(declared.centres[0, pin]), declared.planes[0, pin]
            if not self._is_here(centre):
                continue
            radius = float(self.one.shaft.pieces.radius[0, self.one.laid.pins[pin]])
            outward = self.speed**2 * self._directions(pin)[0]
            each = [(centre, parts.pin[0, pin] * radius, "pin")]
            each += [(float(planes[side]), parts.web_moment[0, pin, side], f"web {side}") for side in (0, 1)]
            for z, moment, letter in each:
                is_own = pin == self.pin
                name = letter if is_own else _("crank whose pin hangs over")
                yield _Load(name, letter if is_own else "", z, moment * outward, none)

    def _weight(self, load: int, _number: int) -> Iterator[_Load]:
        """A balance weight: internal on a web of the throw, external beyond the bearings."""
        z, webs = float(self.loads.z[0, load]), self.one.laid.webs[self.pin].tolist()
        name, letter = _("balance weight"), ""
        if self.loads.on_web[load]:
            web = int(self.loads.piece[load])
            letter = f"counterweight {webs.index(web)}" if web in webs else ""
        elif not self.left < z < self.right:
            letter = "external 0" if z <= self.left else "external 1"
        yield self._load(load, name, letter)

    def _pull(self, load: int, number_of: int) -> Iterator[_Load]:
        """A belt's pull, a flywheel's weight."""
        yield self._load(load, _("pull {name}").format(name=self.one.laid.declared.pulls.names[number_of]))

    def _gear(self, load: int, number_of: int) -> Iterator[_Load]:
        """What the teeth of a gear do, with its thrust."""
        yield self._load(load, _("gear {name}").format(name=self.one.meshes[number_of][1].name))

    def _lettered(self, every: Sequence[_Load]) -> dict[str, list[_Load]]:
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
                first = max(found[side], key=lambda one: float(np.max(np.hypot(*one.force)))).z
                found.setdefault("", []).extend(one for one in found[side] if abs(one.z - first) > _ONE_PLACE)
                found[side] = [one for one in found[side] if abs(one.z - first) <= _ONE_PLACE]
        return found

    def _lengths(self, found: Mapping[str, Sequence[_Load]]) -> ThrowLengths:
        """Lengths of fig. 35."""
        declared = self.one.laid.declared
        centre = float(declared.centres[0, self.pin])
        (left_plane, right_plane), thick = declared.planes[0, self.pin], declared.web_thickness[0, self.pin]
        first, second = (found[f"rod {side}"][0].z if f"rod {side}" in found else centre for side in (0, 1))
        web_end, web_begin = left_plane + thick[0] / 2, right_plane - thick[1] / 2
        lengths = (
            left_plane - thick[0] / 2 - self.left,
            first - web_end,
            centre - first,
            second - centre,
            web_begin - second,
            self.right - right_plane - thick[1] / 2,
            *thick,
            self.left - found["external 0"][0].z if found.get("external 0") else 0.0,
            found["external 1"][0].z - self.right if found.get("external 1") else 0.0,
        )
        return ThrowLengths(*map(np.array, lengths))

    def _forces(self, found: Mapping[str, Sequence[_Load]]) -> ThrowForces:
        """Forces of fig. 35, each positive as the text has it."""

        def out(letter: str) -> Array:
            return sum((self._parts(one.force)[0] for one in found.get(letter, ())), start=self.none)

        def ahead(letter: str) -> Array:
            return sum((self._parts(one.force)[1] for one in found.get(letter, ())), start=self.none)

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
        return np.sum(force * self.outward, axis=0), np.sum(force * self.ahead, axis=0)

    def _rods(self, found: Mapping[str, Sequence[_Load]]) -> Rods:
        """Whether slaves hang on the rods of the pin, or two are side by side."""
        names = [one.name for one in found.get("rod 0", ())]
        masters = self.carriers.master[self.carriers.master >= 0].tolist()
        if any(self.loaded.mechanisms.names[master] in names for master in masters):
            return "articulated"
        return "two" if "rod 1" in found else "one"

    def _has_mass(self) -> bool:
        """Whether any mechanism of the throw says what the crank weighs."""
        members = [
            self._member(int(mechanism))
            for mechanism in self.one.laid.rods.mechanism[self.one.laid.rods.pin == self.pin]
        ]
        bodies = [(batch.kind.dynamics.by_link(made.bodies)["crank"], member) for batch, made, member in members]
        return any(_of_member(body.mass, member) > 0 for body, member in bodies)

    def _shares(self, loads: Sequence[_Load]) -> ThrowReactions:
        """What loads are to both bearings, cut from the rest of the shaft."""
        place = np.array([[self.left, self.right]])
        z = np.array([[one.z for one in loads]])
        force, couple = (np.stack([one[part] for one in loads])[np.newaxis] for part in (3, 4))
        cut = cut_shaft(place, spans_of(place, z)[0], AxisLoads(z, force, couple))
        borne = bearing_loads(place, cut, end_moments(2, cut), settlement=np.zeros((1, 2, 2, 1)), compliance=None)
        (left_out, left_ahead), (right_out, right_ahead) = (self._parts(borne.load[0, side]) for side in (0, 1))
        return ThrowReactions(-right_out, right_ahead, -left_out, left_ahead)

    def _beyond(self, others: Sequence[_Load]) -> Iterator[BeyondLoad]:
        """Loads without a letter by their names, but those that are nothing."""
        for name, loads in grouped((one.name, one) for one in others).items():
            if any(np.any(part) for one in loads for part in (one.force, one.couple)):
                yield BeyondLoad(name, self._shares(loads))


def _of_member(values: Array, member: int) -> float:
    """The number of one member of a batch, of the first design."""
    whole = np.asarray(values)
    return float(whole[0, member if whole.shape[1] > 1 else 0, 0]) if whole.ndim == 3 else float(np.ravel(whole)[0])
