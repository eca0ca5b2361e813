"""What a kind of motor is: its numbers, and its torque by speed, some by time as well."""

from collections.abc import Callable
from typing import Any, Generic, NamedTuple, TypeVar

from cranktrain.motion import Array
from cranktrain.record import record


class MotorBreaks(NamedTuple):
    """Where the torque of a motor has a jump or a kink: what walks along it stops there. NaN for none.

    Attributes
    ----------
    speeds : tuple of Array
        Of its shaft; of a timed one those of its law long since it was switched on. [rad/s]
    times : tuple of Array
        Since it was switched on. [s]
    """

    speeds: tuple[Array, ...] = ()
    times: tuple[Array, ...] = ()


Geometry = TypeVar("Geometry", bound=tuple[object, ...])


@record
class Motor(Generic[Geometry]):
    """A kind of motor, as data.

    Attributes
    ----------
    name : str
        How users call it.
    title : str
        How answers call it, not yet translated.
    kernel : callable
        (speed, geometry) → torque at its own shaft, positive in the sense of a positive speed; of a timed one
        (speed, time, geometry), with the time since it was switched on. [rad/s, s → N·m]
    geometry : type of NamedTuple
        Its numbers.
    source : str
        Where its equations stand.
    range : str
        What it holds for: a sentence, not yet translated.
    is_timed : bool
    breaks : callable
        From the numbers to where the torque jumps or has a kink.
    """

    name: str
    title: str
    kernel: Callable[..., Array]
    geometry: type[Geometry]
    source: str
    range: str
    is_timed: bool = False
    breaks: Callable[[Geometry], MotorBreaks] = lambda _geometry: MotorBreaks()

    def torque(self, speed: Array, time: Array, geometry: Geometry) -> Array:
        """Torque at its shaft, whether time matters or not. [N·m]"""
        kernel: Callable[..., Any] = self.kernel
        return kernel(speed, time, geometry) if self.is_timed else kernel(speed, geometry)
