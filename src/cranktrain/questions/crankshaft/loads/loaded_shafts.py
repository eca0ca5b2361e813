"""All that the machine does to its crankshafts, where it does it: rods, cranks, balance weights, pulls and gears."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.frames import Frames
from cranktrain.layout.masses import MechanismMasses
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.shaft_loads import LoadsOnShafts
from cranktrain.layout.shafts import Shafts
from cranktrain.linkage.forces import Drive
from cranktrain.motion import Array, Point
from cranktrain.numerics.harmonics import ComplexArray, phasor
from cranktrain.questions.balance.rotating_weights import RotatingWeights
from cranktrain.questions.crankshaft.bending.loads_in_spans import AlikeShafts, SpannedLoads, spanned_loads
from cranktrain.questions.crankshaft.bending.shaft_loads import ActingPlaces, ShaftLoads
from cranktrain.questions.crankshaft.loads.gears import DeclaredGears, Gear, Mesh, tooth_load
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft, Supports
from cranktrain.questions.crankshaft.shaft_layout import ShaftLayout, direction, have_crank_pins
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.record import record


class Shares(NamedTuple):
    """Who acts at a place, by number, and which part of his force does: shape (load,) and (design, load)."""

    number: NDArray[np.intp]
    part: Array


class OfMechanisms(NamedTuple):
    """What every mechanism does to its shaft, arrays of shape (design, mechanism, n).

    Attributes
    ----------
    pin : ComplexArray
        Where its pin is, in common axes. [m]
    on_pin, on_crank : ComplexArray
        Force on it, and on the crank as it turns, but for what of its mass turns at the pin. [N]
    of_pin : ComplexArray
        Inertia and weight of that. [N]
    crank_torque : Array
        Torque of the crank itself beside that of its forces at the pin and in the middle of its webs, in its sense of
        rotation: of a shaft that does not turn evenly, of weight beside the middle, of loads on the crank. [N·m]
    pin_torque : Array
        Torque on the pin beside that of the force on it, in that sense: of a valve gear or a chain, whose own cranks
        the throw's pin holds. [N·m]
    """

    pin: ComplexArray
    on_pin: ComplexArray
    on_crank: ComplexArray
    of_pin: ComplexArray
    crank_torque: Array
    pin_torque: Array


@record
class LoadedShaft:
    """A crankshaft, and what acts on it at any crank angle but its gears.

    Attributes
    ----------
    layout : ShaftLayout
    weights : RotatingWeights or None
        Those that turn on it.
    places : ActingPlaces
        Of rods on pins, of cranks on webs and at pins, of weights, of pulls, and of gears, in that order.
    spans : tuple of AlikeShafts
        How its spans bend, with loads at these places.
    rods, cranks, pins, held : Shares
        Of mechanisms on pins and on webs, and of what of their cranks turns at pins; of weights.
    meshes : tuple of (int, Gear, Mesh)
        Its gears, and the number of each.
    """

    layout: ShaftLayout
    weights: RotatingWeights | None
    places: ActingPlaces
    spans: tuple[AlikeShafts, ...]
    rods: Shares
    cranks: Shares
    pins: Shares
    held: Shares
    meshes: tuple[tuple[int, Gear, Mesh], ...]

    @property
    def n_of_mechanisms(self) -> int:
        """How many of the loads are of mechanisms: the first ones."""
        return sum(shares.number.size for shares in (self.rods, self.cranks, self.pins))

    @property
    def metal(self) -> Crankshaft:
        """Its pieces, webs and bearings."""
        return self.layout.shaft


@record
class LoadedShafts:
    """All declared crankshafts with what acts on them.

    Attributes
    ----------
    each : tuple of LoadedShaft
    loaded : LoadedMachine
    frames : Frames
    shafts : Shafts
    gears : DeclaredGears or None
    given : LoadsOnShafts or None
        Torques on shafts, which gears do not hand on.
    zero : Array, shape (design, 1, 1)
        φ where the shown angle is 0. [rad]
    turn : float
        Of `main`: 1 where it runs from X toward Y, −1 where it runs clockwise.
    """

    each: tuple[LoadedShaft, ...]
    loaded: LoadedMachine
    frames: Frames
    shafts: Shafts
    gears: DeclaredGears | None
    given: LoadsOnShafts | None
    zero: Array
    turn: float

    @property
    def supports(self) -> tuple[Supports, ...]:
        """Bearings of each."""
        return tuple(shaft.metal.supports for shaft in self.each)

    def loads(self, angle: Array, solved: Sequence[SolvedBatch] | None = None) -> tuple[SpannedLoads, ...]:
        """What acts on each at φ, shape (design, 1, n) [rad]; solved, where the machine is solved there already."""
        batches = self.loaded.solved(angle) if solved is None else solved
        mechanisms = of_mechanisms(self.loaded, self.frames, self.shafts, batches)
        handed = [] if self.gears is None else self.gears.handed_on(self._torques(batches, angle))
        return tuple(spanned_loads(shaft.spans, self._on(shaft, mechanisms, angle, handed)) for shaft in self.each)

    def _on(self, shaft: LoadedShaft, mechanisms: OfMechanisms, angle: Array, handed: Sequence[Array]) -> ShaftLoads:
        turned = direction(mechanisms.pin[:, shaft.layout.first], self.turn)
        forces = [
            mechanisms.on_pin[:, shaft.rods.number] * shaft.rods.part[..., np.newaxis],
            mechanisms.on_crank[:, shaft.cranks.number] * shaft.cranks.part[..., np.newaxis],
            mechanisms.of_pin[:, shaft.pins.number] * shaft.pins.part[..., np.newaxis],
            self._of_weights(shaft, angle),
        ]
        of_machine = np.concatenate(forces, axis=1)
        n = angle.shape[-1]
        force = [np.stack([-self.turn * of_machine.imag, of_machine.real], axis=2)]
        pulls = shaft.layout.declared.pulls.force(angle - self.zero)
        force.append(pulls)
        torques = (
            mechanisms.pin_torque[:, shaft.rods.number] * shaft.rods.part[..., np.newaxis],
            mechanisms.crank_torque[:, shaft.cranks.number] * shaft.cranks.part[..., np.newaxis],
        )
        behind = of_machine.shape[1] + pulls.shape[1]
        others = np.zeros((len(turned), behind - sum(part.shape[1] for part in torques), n))
        torque = np.concatenate([*(shaft.layout.turn * part for part in torques), others], axis=1)
        if not shaft.meshes:
            return ShaftLoads(*shaft.places, turned=turned, force=np.concatenate(force, axis=1), torque=torque)
        teeth = [tooth_load(gear, mesh, handed[number], shaft.layout.turn) for number, gear, mesh in shaft.meshes]

        def beside(parts: Sequence[Array]) -> Array:
            """Loads of gears behind nothing for all others."""
            gears = np.stack(parts, axis=1)
            return np.concatenate([np.zeros((len(gears), behind, *gears.shape[2:])), gears], axis=1)

        return ShaftLoads(
            *shaft.places,
            turned=turned,
            force=np.concatenate([*force, np.stack([tooth.force for tooth in teeth], axis=1)], axis=1),
            couple=beside([tooth.couple for tooth in teeth]),
            torque=np.concatenate([torque, np.stack([tooth.torque for tooth in teeth], axis=1)], axis=1),
            thrust=beside([tooth.thrust for tooth in teeth]),
        )

    def _torques(self, solved: Sequence[SolvedBatch], angle: Array) -> Array:
        """What drives each shaft, in its own sense, shape (design, shaft, n). [N·m]"""
        torques = np.zeros((len(self.loaded.speed.value), len(self.shafts.names), angle.shape[-1]))
        for batch, solved_batch in zip(self.loaded.mechanisms.batches, solved, strict=True):
            for member, mechanism in enumerate(batch.index.tolist()):
                torques[:, self.shafts.shaft[mechanism]] -= solved_batch.forces.driving_torque[:, member]
        for load in () if self.given is None else self.given.given:
            torque = load.value(angle - self.zero, self.loaded.speed.drive(angle).speed)
            torques[:, self.shafts.names.index(load.shaft)] += torque[:, 0]
        return torques

    def _of_weights(self, shaft: LoadedShaft, angle: Array) -> ComplexArray:
        """Centrifugal force of the weights at their places, shape (design, place, n). [N]"""
        if shaft.weights is None:
            return np.zeros((len(self.loaded.speed.value), 0, angle.shape[-1]), dtype=np.complex128)
        drive = self.loaded.speed.drive(angle)
        number, part = shaft.held
        ratio, moment, ahead = (
            values[:, number, np.newaxis] for values in (shaft.weights.ratio, shaft.weights.moment, shaft.weights.angle)
        )
        turning = drive.speed**2 - 1j * ratio * drive.acceleration
        return part[..., np.newaxis] * moment * phasor(ahead + ratio * angle) * turning


def of_mechanisms(loaded: LoadedMachine, frames: Frames, shafts: Shafts, solved: Sequence[SolvedBatch]) -> OfMechanisms:
    """What all mechanisms do to their cranks, by the reactions of their joints."""
    shape = (len(loaded.speed.value), len(loaded.mechanisms.names), solved[0].forces.driving_torque.shape[-1])
    vectors = np.zeros((4, *shape), dtype=np.complex128)
    together = OfMechanisms(*vectors, crank_torque=np.zeros(shape), pin_torque=np.zeros(shape))
    batches = zip(loaded.mechanisms.batches, loaded.masses.batches, solved, strict=True)
    for batch, made, solved_batch in batches:
        dynamics = batch.kind.dynamics
        at_pin, at_bearing = dynamics.joint("crank_pin"), dynamics.joint("main_bearing")
        if at_bearing is None:
            continue

        def common(x: Array, y: Array, index: NDArray[np.intp] = batch.index) -> ComplexArray:
            return np.broadcast_to(frames.common(index, x, y), (shape[0], index.size, shape[-1]))

        holds = solved_batch.forces.joints[at_bearing]
        on_crank = common(holds.x, holds.y)
        if at_pin is None:
            together.on_pin[:, batch.index] = -on_crank
            together.pin_torque[:, batch.index] = -solved_batch.forces.driving_torque
            continue
        pin, bears = solved_batch.motion.pin, solved_batch.forces.joints[at_pin]
        on_rod = common(bears.x, bears.y)
        at, of_pin = common(pin.x.value, pin.y.value), common(*_of_pin(pin, made, solved_batch.conditions.drive))
        of_webs = on_rod - on_crank - of_pin
        by_forces = frames.sense[batch.index, np.newaxis] * np.imag(np.conj(at) * (of_webs / 2 + of_pin - on_rod))
        values = (at, -on_rod, of_webs, of_pin, -solved_batch.forces.driving_torque - by_forces, 0.0)
        for whole, part in zip(together, values, strict=True):
            whole[:, batch.index] = part
    _hold_at_pins(together, frames, shafts, loaded.mechanisms)
    return together


def _hold_at_pins(acting: OfMechanisms, frames: Frames, shafts: Shafts, mechanisms: Mechanisms) -> None:
    """Let the pin of their throw hold those mechanisms that have none; docs/theory/crankshaft, eq. (24.3)."""
    have_pins = have_crank_pins(mechanisms)
    for number in np.flatnonzero(~have_pins).tolist():
        beside = (shafts.shaft == shafts.shaft[number]) & (shafts.throw == shafts.throw[number]) & have_pins
        if not np.any(beside):
            continue
        at = acting.pin[:, np.flatnonzero(beside)[0]]
        acting.pin_torque[:, number] -= frames.sense[number] * np.imag(np.conj(at) * acting.on_pin[:, number])


def _of_pin(pin: Point, made: MechanismMasses, drive: Drive) -> tuple[Array, Array]:
    """Weight less inertia of what of cranks turns at their pins, in the mechanisms' axes. [N]"""
    square = drive.speed * drive.speed
    x, y = (
        made.at_pin * (gravity - (along.second * square + along.first * drive.acceleration))
        for gravity, along in zip(made.gravity, pin, strict=True)
    )
    return x, y


@record
class LoadsOverCycle:
    """Loads on each shaft at the crank angles of the grid."""

    each: Sequence[SpannedLoads]


def loads_over_cycle(loaded: LoadedShafts, solved: SolvedCycle, crank_angle: CrankAngle) -> LoadsOverCycle:
    """Put what the solved machine does to its shafts to their places; docs/theory/crankshaft, eqs. (24.1) to (24.3)."""
    return LoadsOverCycle(loaded.loads(crank_angle.angle, solved.batches))
