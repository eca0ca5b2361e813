"""All that the machine does to its crankshaft, at the places where it does it: rods, cranks, balance weights."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.frames import Frames
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import ComplexArray, phasor
from cranktrain.questions.balance.rotating_weights import RotatingWeights
from cranktrain.questions.crankshaft.shaft import Crankshaft
from cranktrain.questions.crankshaft.shaft_loads import ShaftLoads
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.record import record


class ActingPlaces(NamedTuple):
    """Where loads act on the shaft, as `ShaftLoads` has it: pieces, webs; z and radius, shape (design, load)."""

    piece: NDArray[np.intp]
    on_web: NDArray[np.bool_]
    z: Array
    radius: Array
    angle: Array


class _OfMechanisms(NamedTuple):
    """Of every mechanism, in common axes, shape (design, mechanism, n): where its pin is, force on it, on its crank."""

    pin: ComplexArray
    on_pin: ComplexArray
    on_crank: ComplexArray


@record
class LoadedShaft:
    """The crankshaft, and what acts on it at any crank angle.

    Attributes
    ----------
    shaft : Crankshaft
    loaded : LoadedMachine
    frames : Frames
    carrying : array of int, shape (n,)
        Mechanisms that have a crank pin of their own.
    weights : RotatingWeights or None
        Those that turn on the crankshaft.
    places : ActingPlaces
        Of the pins' loads, of the cranks' on the first and the second webs, and of the weights' on both.
    lever : Array, shape (design, weight)
        How much of each weight the second web of its throw takes.
    turn : float
        1 where the shaft runs from X toward Y, −1 where it runs clockwise.
    """

    shaft: Crankshaft
    loaded: LoadedMachine
    frames: Frames
    carrying: NDArray[np.intp]
    weights: RotatingWeights | None
    places: ActingPlaces
    lever: Array
    turn: float

    def loads(self, angle: Array, solved: Sequence[SolvedBatch] | None = None) -> ShaftLoads:
        """What acts at φ, shape (design, 1, n) [rad]; solved, where the machine is solved there already."""
        found = self.loaded.solved(angle) if solved is None else solved
        own = of_mechanisms(self.loaded, self.frames, found)
        half = own.on_crank[:, self.carrying] / 2
        force = np.concatenate([own.on_pin[:, self.carrying], half, half, *self._of_weights(angle)], axis=1)
        return ShaftLoads(
            *self.places,
            turned=direction(own.pin[:, self.carrying[0]], self.turn),
            force=np.stack([-self.turn * force.imag, force.real], axis=2),
        )

    def _of_weights(self, angle: Array) -> list[ComplexArray]:
        """Centrifugal force of the weights on the first and on the second webs, shape (design, weight, n). [N]"""
        if self.weights is None:
            return []
        drive = self.loaded.speed.drive(angle)
        turning = drive.speed**2 - 1j * drive.acceleration
        force = (self.weights.moment * phasor(self.weights.angle))[..., np.newaxis] * phasor(angle) * turning
        second = self.lever[..., np.newaxis]
        return [force * (1 - second), force * second]


def direction(vector: ComplexArray, turn: float) -> Array:
    """Direction from X toward Y of vectors in the common axes. [rad]"""
    return np.arctan2(vector.real, -turn * vector.imag)


def of_mechanisms(loaded: LoadedMachine, frames: Frames, solved: Sequence[SolvedBatch]) -> _OfMechanisms:
    """What all mechanisms do to their cranks, by the reactions of their joints."""
    shape = (len(loaded.speed.value), len(loaded.mechanisms.names), solved[0].forces.driving_torque.shape[-1])
    found = _OfMechanisms(*np.zeros((3, *shape), dtype=np.complex128))
    for batch, one in zip(loaded.mechanisms.batches, solved, strict=True):
        dynamics = batch.kind.dynamics
        at_pin, at_bearing = dynamics.joint("crank_pin"), dynamics.joint("main_bearing")
        if at_pin is None or at_bearing is None:
            continue

        def common(x: Array, y: Array, index: NDArray[np.intp] = batch.index) -> ComplexArray:
            return np.broadcast_to(frames.common(index, x, y), (shape[0], index.size, shape[-1]))

        pin, (bears, holds) = one.motion.pin, (one.forces.joints[joint] for joint in (at_pin, at_bearing))
        on_rod, on_crank = common(bears.x, bears.y), common(holds.x, holds.y)
        values = (common(pin.x.value, pin.y.value), -on_rod, on_rod - on_crank)
        for whole, part in zip(found, values, strict=True):
            whole[:, batch.index] = part
    return found


def acting_places(
    shaft: Crankshaft, planes: Array, throw: NDArray[np.intp], along: Array, weight: NDArray[np.intp]
) -> ActingPlaces:
    """Say where pins, cranks and weights act; what turns with a throw acts in the middle of its webs.

    Parameters
    ----------
    shaft : Crankshaft
    planes : Array, shape (design, throw, 2)
        z of the webs. [m]
    throw : array of int, shape (n,)
        Of every mechanism that has a pin of its own.
    along : Array, shape (design, n)
        z of its rod. [m]
    weight : array of int, shape (weight,)
        Throw of every balance weight, which both its webs carry.
    """
    pin = 2 * throw + 1
    pieces = np.concatenate([pin, pin - 1, pin, 2 * weight, 2 * weight + 1])
    on_web = np.arange(len(pieces)) >= len(throw)
    z = [along, planes[:, throw, 0], planes[:, throw, 1], planes[:, weight, 0], planes[:, weight, 1]]
    own = np.concatenate([pin, pin, pin, *[2 * weight + 1] * 2])
    radius = shaft.pieces.radius[:, own] * np.where(on_web, 0.5, 1.0)
    return ActingPlaces(pieces, on_web, np.concatenate(z, axis=1), radius, shaft.pieces.angle[:, own])


def nearest_throw(centres: Array, z: Array) -> NDArray[np.intp]:
    """The throw that stands nearest to each weight of the first design, shape (weight,)."""
    return np.argmin(np.abs(centres[0] - z[0][:, np.newaxis]), axis=1).astype(np.intp)
