"""Frames: a mechanism's own axes as they lie in the machine's, X right and Y up, seen from the free end."""

from collections.abc import Sequence
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Array
from cranktrain.numerics.designs import by_design
from cranktrain.numerics.harmonics import ComplexArray, phasor
from cranktrain.record import record


class Frame(NamedTuple):
    """Where a mechanism's axes lie.

    direction: of its x, clockwise from Y [rad]; sense: +1 where it runs clockwise, so that y is x turned clockwise by
    90°, and −1 where it runs anticlockwise.
    """

    direction: Array
    sense: float


class Orientation(NamedTuple):
    """How a machine stands: direction of the first bank's axis from Y in its normal sense [rad], that sense, astern."""

    first_angle: Array
    is_clockwise: bool
    is_astern: bool


def frame_of(place: PlacedMechanism, orientation: Orientation) -> Frame:
    """Find how a place of a machine lies.

    Parameters
    ----------
    place : PlacedMechanism
        Its axis counts from the first bank's, in the sense of its crank.
    orientation : Orientation
        Where a crank turns against the machine's normal sense, the metal stays and y is turned the other way.

    Returns
    -------
    Frame
    """
    normal = 1.0 if orientation.is_clockwise else -1.0
    sense = normal * place.sense
    return Frame(normal * orientation.first_angle + sense * place.axis, sense)


def in_machine_axes(x: Array, y: Array, frame: Frame) -> tuple[Array, Array]:
    """Give a vector or point of a mechanism's own axes in the machine's.

    Parameters
    ----------
    x, y : Array, of one shape
        In the mechanism's axes; any unit.
    frame : Frame

    Returns
    -------
    X, Y : Array of the same shape and unit

    Examples
    --------
    A cylinder that lies 90° clockwise from Y: its x points right, and its y down.

    >>> right, up = in_machine_axes(np.array(2.0), np.array(1.0), Frame(np.pi / 2, 1.0))
    >>> round(float(right), 9), round(float(up), 9)
    (2.0, -1.0)
    """
    cos, sin = np.cos(frame.direction), np.sin(frame.direction)
    return x * sin + frame.sense * y * cos, x * cos - frame.sense * y * sin


def in_own_axes(right: Array, up: Array, frame: Frame) -> tuple[Array, Array]:
    """Give a vector or point of the machine's axes in a mechanism's own, as `in_machine_axes` the other way.

    Parameters
    ----------
    right, up : Array, of one shape
        In the machine's axes, along X and Y; any unit.
    frame : Frame

    Returns
    -------
    x, y : Array of the same shape and unit
    """
    cos, sin = np.cos(frame.direction), np.sin(frame.direction)
    return right * sin + up * cos, frame.sense * (right * cos - up * sin)


@record
class Frames:
    """Where all mechanisms' axes lie in common ones: x along Y, y turned from it in the sense in which `main` runs.

    Attributes
    ----------
    direction : Array, shape (design, mechanism)
        Of each mechanism's x, from the common x. [rad]
    sense : Array, shape (mechanism,)
        1 where its crank turns as `main` does, −1 where it turns against that.
    first : Array, shape (design,)
        Where throw 1 of `main` stands at φ = 0, along the first bank's axis. [rad]
    running : float
        1 where it runs in the machine's normal sense, −1 astern.
    clockwise : bool
        Whether `main` runs clockwise as seen from the free end.
    """

    reads: ClassVar[tuple[str, ...]] = ("angle", "[bank.NAME]")

    direction: Array
    sense: Array
    first: Array
    running: float
    clockwise: bool

    def common(self, index: NDArray[np.intp], x: Array, y: Array) -> ComplexArray:
        """Vectors x + iy in the common axes of some mechanisms' own, shape (design, member, n)."""
        turn = phasor(self.direction[:, index, np.newaxis])
        return np.asarray((x + 1j * self.sense[index, np.newaxis] * y) * turn)


def frames_of(places: Sequence[PlacedMechanism], orientation: Orientation, n_designs: int) -> Frames:
    """Lay out the axes of designs of one machine."""
    running = -1.0 if orientation.is_astern else 1.0
    sense = running if orientation.is_clockwise else -running
    frames = [frame_of(place, orientation) for place in places]
    return Frames(
        direction=sense * by_design([frame.direction for frame in frames], n_designs),
        sense=sense * np.array([frame.sense for frame in frames]),
        first=running * by_design([orientation.first_angle], n_designs)[:, 0],
        running=running,
        clockwise=sense > 0,
    )
