"""What acts on a shaft between two of its bearings, part by part: what has a letter in fig. 35, and what has none."""

from collections.abc import Iterator
from functools import partial
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import InputError, Problem
from cranktrain.language import Words, _
from cranktrain.layout.masses import MechanismMasses
from cranktrain.layout.mechanisms import Batch
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.cut_shaft import spans_of
from cranktrain.questions.crankshaft.bending.shaft_loads import on_axis
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts
from cranktrain.questions.crankshaft.results.crank_sizes import crank_parts
from cranktrain.questions.forces.rod_masses import weighed_ends

CrankMasses = Literal["given", "sizes"]
"""Of which a crank's inertia is: of [masses.crank], as everywhere, or of its sizes in [crankshaft]."""


class ThrowLoad(NamedTuple):
    """A load on the shaft.

    name: in words; letter: of fig. 35, empty of what has none there; z: where along the shaft [m]; force: toward X and
    Y, shape (2, n) [N]; couple: sum of z times force beside that, of the same shape. [N·m]
    """

    name: Words
    letter: str
    z: float
    force: Array
    couple: Array


class ThrowSpan:
    """What lies between two bearings, and at an end of the shaft beyond them, at crank angles φ, shape (1, 1, n)."""

    def __init__(self, of: LoadedShafts, shaft: int, throw: int, angle: Array) -> None:
        self.loaded, self.frames, self.turn, self.one = of.loaded, of.frames, of.turn, of.each[shaft]
        self.carriers = of.loaded.carriers
        declared = self.one.layout.declared
        own = np.flatnonzero(declared.throw == throw)
        self.pin = int(own[0])
        self.span = self._span(own)
        self.left, self.right = declared.bearings[0, self.span - 1 : self.span + 1].tolist()
        self.loads = of.loads(angle)[shaft].loads
        self.on_axis = on_axis(self.loads)
        self.speed = np.broadcast_to(self.loaded.speed.drive(angle).speed, angle.shape)[0, 0]
        self.piece = int(self.one.layout.pins[self.pin])
        pieces = self.one.metal.pieces
        self.radius = float(pieces.radius[0, self.piece])
        self.outward, self.ahead = self._directions(self.pin)
        self.none = np.zeros_like(self.speed)

    def _directions(self, pin: int) -> tuple[Array, Array]:
        """Where a pin points from the shaft's axis, and 90° ahead of that in the sense of rotation."""
        turned = self.loads.turned[0] + self.one.metal.pieces.angle[0, self.one.layout.pins[pin]]
        return np.stack([np.cos(turned), np.sin(turned)]), self.one.layout.turn * np.stack(
            [-np.sin(turned), np.cos(turned)]
        )

    def _span(self, own: NDArray[np.intp]) -> int:
        """Which span the throw's pin is in, from 1; refuse what the text does not speak of."""
        declared = self.one.layout.declared
        spans = spans_of(declared.bearings, declared.centres)[0]
        span, throws = int(spans[own[0]]), declared.throw[spans == spans[own[0]]]
        allowed: Words | None = None
        if not 0 < span < declared.bearings.shape[1]:
            allowed = _("hangs over: (44) to (53) are of a throw between two supports")
        elif own.size > 1:
            allowed = _("has {n} pins, of side rods: (44) to (53) are of one pin between two supports")
            allowed = allowed.format(n=own.size)
        elif throws.size > 1:
            allowed = _(
                "is one of {n} between bearings {left} and {right}, and (44) to (53) are written in one throw's axes; "
                "the split shaft of `run` has them all",
                n=throws.size,
                left=declared.bearing_names[span - 1],
                right=declared.bearing_names[span],
            )
        if allowed is not None:
            raise InputError([Problem("throw_number", str(int(declared.throw[own[0]]) + 1), allowed)])
        return span

    def _is_here(self, z: float) -> bool:
        """Whether a place is between the bearings, or beyond one at an end of the shaft."""
        bearings = self.one.layout.declared.bearings
        span, n = int(spans_of(bearings, np.array([[z]]))[0, 0]), bearings.shape[1]
        return span == self.span or (span == 0 and self.span == 1) or (span == n and self.span == n - 1)

    def every(self, masses: CrankMasses) -> Iterator[ThrowLoad]:
        """All that acts here, with letters or without, in the order in which the shaft's loads stand."""
        one = self.one
        sorts = (
            (one.rods.number.size, self._rod),
            (one.cranks.number.size, partial(self._crank, masses=masses)),
            (one.pins.number.size, partial(self._crank_pin, masses=masses)),
            (one.held.number.size, self._weight),
            (one.layout.declared.pulls.z.shape[1], self._pull),
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

    def _load(self, load: int, name: Words, letter: str = "", force: Array | None = None) -> ThrowLoad:
        """One of the shaft's loads, or a part of it."""
        whole = self.on_axis.force[0, load]
        couples = self.on_axis.couple
        couple = np.zeros_like(whole) if couples is None or force is not None else couples[0, load]
        return ThrowLoad(name, letter, float(self.loads.z[0, load]), whole if force is None else force, couple)

    def _rod(self, load: int, number_of: int) -> Iterator[ThrowLoad]:
        """A rod on this pin: what turns of it, K and T, the weight of what turns; one that hangs over has no letter."""
        mechanism = int(self.one.rods.number[number_of])
        name = self.loaded.mechanisms.names[mechanism]
        if int(self.loads.piece[load]) != self.piece:
            yield self._load(load, _("rod of {name}, on a pin that hangs over", name=name))
            return
        turning, weight = self._turning_rod(mechanism)
        yield self._load(load, name, "turning", turning)
        yield self._load(load, name, "rod", self.on_axis.force[0, load] - turning - weight)
        yield self._load(load, _("weight of what turns of the rods"), "", weight)

    def _turning_rod(self, mechanism: int) -> tuple[Array, Array]:
        """Centrifugal force of a rod's share that turns with the pin, and its weight, toward X and Y. [N]"""
        batch, made, member = self.member(mechanism)
        body = batch.kind.dynamics.by_link(made.bodies).get("rod")
        length = getattr(batch.members.geometry, "rod_length", None)
        if body is None or length is None:
            return np.zeros_like(self.outward), np.zeros_like(self.outward)
        mass = of_member(weighed_ends(body, length).first, member)
        pull = self.frames.common(np.array([mechanism]), *(np.atleast_1d(of_member(g, member)) for g in made.gravity))
        down = np.array([-self.turn * pull.imag.item(), pull.real.item()])[:, np.newaxis]
        return mass * self.radius * self.speed**2 * self.outward, mass * down * np.ones_like(self.outward)

    def member(self, mechanism: int) -> tuple[Batch, MechanismMasses, int]:
        """Batch, bodies and place in it of a mechanism."""
        batches = zip(self.loaded.mechanisms.batches, self.loaded.masses.batches, strict=True)
        batch, made = next(pair for pair in batches if mechanism in pair[0].index)
        return batch, made, batch.index.tolist().index(mechanism)

    def _crank(self, load: int, number_of: int, masses: CrankMasses) -> Iterator[ThrowLoad]:
        """A crank's part on a web: its inertia, and what else acts on it."""
        number, part = self.one.cranks
        web, webs = int(self.loads.piece[load]), self.one.layout.webs[self.pin].tolist()
        mechanism = int(number[number_of])
        outward, ahead = self._directions(int(self.one.layout.rods.pin[self.one.layout.rods.mechanism == mechanism][0]))
        batch, made, member = self.member(mechanism)
        body = batch.kind.dynamics.by_link(made.bodies)["crank"]
        along, across = (of_member(body.mass * arm, member) for arm in (body.along, body.across))
        along -= self._pin_moment(mechanism)
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

    def _pin_moment(self, mechanism: int) -> float:
        """Static moment of what of a crank's mass turns at its pin. [kg·m]"""
        _batch, made, member = self.member(mechanism)
        rods = self.one.layout.rods
        pin = int(rods.pin[rods.mechanism == mechanism][0])
        return of_member(made.at_pin, member) * float(self.one.metal.pieces.radius[0, self.one.layout.pins[pin]])

    def _crank_pin(self, load: int, number_of: int, masses: CrankMasses) -> Iterator[ThrowLoad]:
        """What of a crank turns at its pin: its inertia, and its weight."""
        number, part = self.one.pins
        mechanism = int(number[number_of])
        pin = int(np.flatnonzero(self.one.layout.pins == self.loads.piece[load])[0])
        moment = float(part[0, number_of]) * self._pin_moment(mechanism)
        inertia = moment * self.speed**2 * self._directions(pin)[0]
        is_given = masses == "given"
        if pin != self.pin:
            name = _("crank whose pin hangs over")
            yield self._load(load, name, "", None if is_given else self.on_axis.force[0, load] - inertia)
            return
        if is_given:
            yield self._load(load, _("crank pin"), "pin", inertia)
        rest = self.on_axis.force[0, load] - inertia
        yield self._load(load, _("weight of the crank, and loads on it"), "", rest)

    def _sized(self) -> Iterator[ThrowLoad]:
        """Inertia of pin and webs by their sizes; of other pins here as of what hangs over."""
        declared, parts = self.one.layout.declared, crank_parts(self.one.layout)
        none = np.zeros_like(self.outward)
        for pin in range(declared.throw.size):
            centre, planes = float(declared.centres[0, pin]), declared.planes[0, pin]
            if not self._is_here(centre):
                continue
            radius = float(self.one.metal.pieces.radius[0, self.one.layout.pins[pin]])
            outward = self.speed**2 * self._directions(pin)[0]
            each = [(centre, parts.pin[0, pin] * radius, "pin")]
            each += [(float(planes[side]), parts.web_moment[0, pin, side], f"web {side}") for side in (0, 1)]
            for z, moment, letter in each:
                is_own = pin == self.pin
                name = letter if is_own else _("crank whose pin hangs over")
                yield ThrowLoad(name, letter if is_own else "", z, moment * outward, none)

    def _weight(self, load: int, _number: int) -> Iterator[ThrowLoad]:
        """A balance weight: internal on a web of the throw, external beyond the bearings."""
        z, webs = float(self.loads.z[0, load]), self.one.layout.webs[self.pin].tolist()
        name, letter = _("balance weight"), ""
        if self.loads.on_web[load]:
            web = int(self.loads.piece[load])
            letter = f"counterweight {webs.index(web)}" if web in webs else ""
        elif not self.left < z < self.right:
            letter = "external 0" if z <= self.left else "external 1"
        yield self._load(load, name, letter)

    def _pull(self, load: int, number_of: int) -> Iterator[ThrowLoad]:
        """A belt's pull, a flywheel's weight."""
        yield self._load(load, _("pull {name}", name=self.one.layout.declared.pulls.names[number_of]))

    def _gear(self, load: int, number_of: int) -> Iterator[ThrowLoad]:
        """What the teeth of a gear do, with its thrust."""
        yield self._load(load, _("gear {name}", name=self.one.meshes[number_of][1].name))


def of_member(values: Array, member: int) -> float:
    """The number of one member of a batch, of the first design."""
    whole = np.asarray(values)
    return float(whole[0, member if whole.shape[1] > 1 else 0, 0]) if whole.ndim == 3 else float(np.ravel(whole)[0])
