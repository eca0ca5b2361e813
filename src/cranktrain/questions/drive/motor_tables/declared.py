"""A motor as questions take it: its kernel with the numbers of all designs, what its plate says, and what heats it."""

from collections.abc import Callable
from typing import Any, ClassVar, NamedTuple, TypeAlias, cast

import numpy as np

from cranktrain.language import N_
from cranktrain.motion import Array, single
from cranktrain.numerics.nested import mapped
from cranktrain.questions.drive.motors.motor import Motor
from cranktrain.record import record

ByTime: TypeAlias = Callable[[Any, Any, Any], Any]
"""(speed at its own shaft, time since it was switched on, numbers) → a power or a current."""

UNKNOWN = single(float("nan"))
LONG_SINCE = float("inf")
"""Time since it was switched on after which no starter matters any more: what steady running asks for. [s]"""


class Rating(NamedTuple):
    """Rated point, NaN where the table has none; arrays of shape (design,). [N·m, rad/s]"""

    torque: Array = UNKNOWN
    speed: Array = UNKNOWN

    @property
    def power(self) -> Array:
        """At the shaft. [W]"""
        return self.torque * self.speed


@record
class DeclaredMotor:
    """A motor at its own shaft, in all designs.

    Attributes
    ----------
    motor : Motor
        Kernel and title.
    numbers : NamedTuple of arrays
        What its kernel takes; the last axis of each is the design: (design,), of points of a curve (point, design).
    rating : Rating
    top_speed : Array, shape (design,)
        Above which it drives no more: synchronous speed, speed without load; infinite where there is none. [rad/s]
    inertia : Array, shape (design,), or None
        Of its rotor. [kg·m²]
    heat : ByTime or None
        (speed, time, numbers) → power that heats the motor; None where nothing is known of it. [W]
    current : ByTime or None
        (speed, time, numbers of `current_numbers`) → line current over the rated one; None where nothing is known. [1]
    current_numbers : NamedTuple of arrays
        As `numbers`.
    rated_current : Array, shape (design,)
        NaN where it is not known. [A]
    notes, flags : tuple of str
        What was taken where the table says nothing, and what is to be minded about its numbers; of the first design.
    """

    needs: ClassVar[str] = N_("[drive.motor]")

    motor: Motor[Any]
    numbers: Any
    rating: Rating
    top_speed: Array
    inertia: Array | None = None
    heat: ByTime | None = None
    current: ByTime | None = None
    current_numbers: Any = ()
    rated_current: Array = UNKNOWN
    notes: tuple[str, ...] = ()
    flags: tuple[str, ...] = ()

    @property
    def n_designs(self) -> int:
        """How many designs it is of."""
        return self.top_speed.shape[-1]

    def highest_speed(self, design: int) -> float:
        """Top speed; thrice the rated one of a motor that always drives; infinite where neither is known. [rad/s]"""
        top, rated = float(self.top_speed[design]), float(self.rating.speed[design])
        return next((speed for speed in (top, 3 * rated) if np.isfinite(speed)), np.inf)

    def corner_speeds(self, design: int) -> Array:
        """Speeds of its shaft at which its law jumps or has a corner, long since it was switched on, rising. [rad/s]"""
        each = [float(np.ravel(speed[..., design])[0]) for speed in self.motor.breaks(self.numbers).speeds]
        return np.unique([speed for speed in each if np.isfinite(speed)])

    def torque(self, speed: Array, time: Array | float = LONG_SINCE) -> Array:
        """Torque at its shaft.

        Parameters
        ----------
        speed : Array, shape (design, n) or (n,)
            [rad/s]
        time : Array, broadcastable, optional
            Since it was switched on; long since, unless given. [s]

        Returns
        -------
        Array, shape (design, n)
            [N·m]
        """
        return self.motor.torque(speed, cast(Array, time), _over_speeds(self.numbers))

    def heating(self, speed: Array, time: Array | float = LONG_SINCE) -> Array:
        """Power that heats it, shapes as of `torque`; NaN where nothing is known. [W]"""
        return self._by_time(self.heat, self.numbers, speed, time)

    def current_ratio(self, speed: Array, time: Array | float = LONG_SINCE) -> Array:
        """Line current over the rated one, shapes as of `torque`; NaN where nothing is known. [1]"""
        return self._by_time(self.current, self.current_numbers, speed, time)

    def row(self, design: int) -> tuple[Any, ...]:
        """Numbers of one design, plain floats, as kernels of one machine take them; of points of a curve an array."""
        return mapped(lambda _name, number: _plain(number[..., design]), self.numbers)

    def _by_time(self, kernel: ByTime | None, numbers: Any, speed: Array, time: Array | float) -> Array:
        if kernel is None:
            return np.full((self.n_designs, np.shape(speed)[-1]), np.nan)
        return kernel(speed, cast(Array, time), _over_speeds(numbers))


def _over_speeds(numbers: tuple[Any, ...]) -> tuple[Any, ...]:
    return mapped(lambda _name, number: number[..., np.newaxis], numbers)


def _plain(number: Any) -> Any:
    return float(number) if np.ndim(number) == 0 else np.ascontiguousarray(number)
