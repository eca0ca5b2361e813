"""What a motor's law is: its torque by speed, some by time as well, and all that hangs on the same numbers."""

from collections.abc import Callable
from typing import Any, Generic, NamedTuple, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Array
from cranktrain.record import record

ByTime: TypeAlias = Callable[[Any, Any, Any], Any]
"""(speed at its own shaft, time since it was switched on, numbers) → a power or a current."""


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


class BriefLimits(NamedTuple):
    """What a motor can do for a moment, at rated voltage; of one design. [N·m]

    Attributes
    ----------
    peak : float
        Its largest torque, of a servo motor at standstill; NaN where it is not known.
    start : float
        The least between standstill and the largest one; NaN where it is not known.
    unknown : str
        What cannot be checked, and why: a sentence without its end, not yet translated.
    """

    peak: float = np.nan
    start: float = np.nan
    unknown: str = ""


class OfRated(NamedTuple):
    """Numbers of a motor whose current its torque decides, and its rated torque [N·m] or current [A]."""

    motor: Any
    rated: Array


Numbers = TypeVar("Numbers", bound=tuple[object, ...])


def _no_breaks(_numbers: object) -> MotorBreaks:
    """Of a motor whose torque is smooth."""
    return MotorBreaks()


def _is_not_free(_numbers: object) -> NDArray[np.bool_]:
    """Of a motor that does not give what it is asked for."""
    return np.asarray(False)


@record
class MotorLaw(Generic[Numbers]):
    """The law of a motor with what starts it, as data.

    Attributes
    ----------
    name : str
        How users call it.
    title : str
        How answers call it, not yet translated.
    kernel : callable
        (speed, numbers) → torque at its own shaft, positive in the sense of a positive speed; of a timed one
        (speed, time, numbers), with the time since it was switched on. [rad/s, s → N·m]
    numbers : type of NamedTuple
    source : str
        Where its equations stand.
    range : str
        What it holds for: a sentence, not yet translated.
    limits : callable (DeclaredMotor, design) → BriefLimits
    is_timed : bool
    breaks : callable
        From the numbers to where the torque jumps or has a kink.
    heat : ByTime, optional
        (speed, time, numbers) → power that heats the motor. [W]
    current : ByTime, optional
        (speed, time, numbers of the current) → line current over the rated one. [1]
    is_on_line : bool
        Whether its torques go with the square of the line's voltage.
    ceiling : callable (speed, numbers) → Array, optional
        The most that it gives either way, of a motor that gives what it is asked for: its top speed is a limit, not a
        speed that it runs at. [rad/s → N·m]
    is_free : callable (numbers) → Array of bool
        Of such a motor: whether nothing less than its ceiling is asked for by its table.
    measured : callable (numbers) → tuple of Array, optional
        First and last speed between which it was measured, of a motor by points. [rad/s]
    """

    name: str
    title: str
    kernel: Callable[..., Array]
    numbers: type[Numbers]
    source: str
    range: str
    limits: Callable[[Any, int], BriefLimits]
    is_timed: bool = False
    breaks: Callable[[Numbers], MotorBreaks] = _no_breaks
    heat: ByTime | None = None
    current: ByTime | None = None
    is_on_line: bool = False
    ceiling: Callable[[Array, Numbers], Array] | None = None
    is_free: Callable[[Numbers], Any] = _is_not_free
    measured: Callable[[Numbers], tuple[Array, Array]] | None = None

    def torque(self, speed: Array, time: Array, numbers: Numbers) -> Array:
        """Torque at its shaft, whether time matters or not. [N·m]"""
        kernel: Callable[..., Any] = self.kernel
        return kernel(speed, time, numbers) if self.is_timed else kernel(speed, numbers)

    @property
    def is_commanded(self) -> bool:
        """Whether it gives what it is asked for, at any speed."""
        return self.ceiling is not None
