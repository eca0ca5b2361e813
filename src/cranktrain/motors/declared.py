"""A motor as questions take it: its law with the numbers of all designs, what its plate says, and its brief limits."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any, ClassVar, NamedTuple, cast

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.motion import ONE, Array, single
from cranktrain.motors.law import BriefLimits, ByTime, MotorLaw
from cranktrain.numerics.nested import each_changed, filled, leaves
from cranktrain.numerics.ties import first_largest
from cranktrain.record import record
from cranktrain.saying.wording import number

UNKNOWN = single(float("nan"))
UNLIMITED = single(float("inf"))
LONG_SINCE = float("inf")
"""Time since it was switched on after which no starter matters any more: what steady running asks for. [s]"""

_N_SPEEDS = 20_001
_ROUNDING = 1e-9


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
    law : MotorLaw
    numbers : NamedTuple of arrays
        What its kernel takes; the last axis of each is the design: (design,), of points of a curve (point, design).
    rating : Rating
    top_speed : Array, shape (design,)
        Above which it drives no more: synchronous speed, speed without load; infinite where there is none. [rad/s]
    inertia : Array, shape (design,), or None
        Of its rotor. [kg·m²]
    current_numbers : NamedTuple of arrays, or None
        As `numbers`, what its current hangs on; None where nothing is known of it.
    rated_current : Array, shape (design,)
        NaN where it is not known. [A]
    slip_ratio : Array, shape (design,)
        Slip at the rated torque over that on its plate: more than 1 with a constant resistance behind slip rings. [1]
    is_heat_known : bool
    notes, flags : tuple of Words
        What was taken where the table says nothing, and what is to be minded about its numbers; of the first design.
    """

    needs: ClassVar[str] = N_("[drive.motor]")

    law: MotorLaw[Any]
    numbers: Any
    rating: Rating
    top_speed: Array
    inertia: Array | None = None
    current_numbers: Any = None
    rated_current: Array = UNKNOWN
    slip_ratio: Array = ONE
    is_heat_known: bool = True
    notes: tuple[Words, ...] = ()
    flags: tuple[Words, ...] = ()

    @property
    def n_designs(self) -> int:
        """How many designs it is of."""
        return self.top_speed.shape[-1]

    @property
    def heat(self) -> ByTime | None:
        """Kernel of what heats it; None where nothing is known of it."""
        return self.law.heat if self.is_heat_known else None

    @property
    def current(self) -> ByTime | None:
        """Kernel of its current; None where nothing is known of it."""
        return None if self.current_numbers is None else self.law.current

    def with_designs(self, change: Callable[[Any], Array]) -> "DeclaredMotor":
        """The same motor with the last axis of each of its numbers, the designs, taken or spread out otherwise."""
        numbers, of_current = self.numbers, self.current_numbers
        return replace(
            self,
            numbers=each_changed(change, numbers),
            rating=Rating(*map(change, self.rating)),
            top_speed=change(self.top_speed),
            inertia=None if self.inertia is None else change(self.inertia),
            current_numbers=None if of_current is None else each_changed(change, of_current),
            rated_current=change(self.rated_current),
            slip_ratio=change(self.slip_ratio),
        )

    def over_designs(self, n_designs: int) -> "DeclaredMotor":
        """The same motor with each of its numbers, one number or of shape (..., design), of as many designs."""

        def of_each(number: Any) -> Array:
            found = np.atleast_1d(np.asarray(number, dtype=float))
            return np.broadcast_to(found, (*found.shape[:-1], n_designs))

        return self.with_designs(of_each)

    def of_design(self, design: int) -> "DeclaredMotor":
        """The motor of one design, as the only one."""
        return self.with_designs(lambda number: number[..., design : design + 1])

    def of_each(self) -> "tuple[DeclaredMotor, ...]":
        """The motors of all designs, each as the only one; those whose numbers are the same are one and the same."""
        rows = list[Array]()

        def noted(number: Array) -> Array:
            whole = np.broadcast_to(number, (*number.shape[:-1], self.n_designs))
            rows.append(whole.reshape(-1, self.n_designs))
            return number

        self.with_designs(noted)
        keys = [numbers.tobytes() for numbers in np.concatenate(rows).T]
        known = {key: self.of_design(keys.index(key)) for key in dict.fromkeys(keys)}
        return tuple(known[key] for key in keys)

    def highest_speed(self, design: int) -> float:
        """Top speed; thrice the rated one of a motor that always drives; infinite where neither is known. [rad/s]"""
        top, rated = float(self.top_speed[design]), float(self.rating.speed[design])
        return next((speed for speed in (top, 3 * rated) if np.isfinite(speed)), np.inf)

    def corner_speeds(self, design: int) -> Array:
        """Speeds of its shaft at which its law jumps or has a corner, long since it was switched on, rising. [rad/s]"""
        each = [float(np.ravel(speed[..., design])[0]) for speed in self.law.breaks(self.numbers).speeds]
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
        return self.law.torque(speed, cast(Array, time), _over_speeds(self.numbers))

    def heating(self, speed: Array, time: Array | float = LONG_SINCE) -> Array:
        """Power that heats it, shapes as of `torque`; NaN where nothing is known. [W]"""
        return self._by_time(self.heat, self.numbers, speed, time)

    def current_ratio(self, speed: Array, time: Array | float = LONG_SINCE) -> Array:
        """Line current over the rated one, shapes as of `torque`; NaN where nothing is known. [1]"""
        return self._by_time(self.current, self.current_numbers, speed, time)

    def ceiling(self, speed: Array, design: int) -> Array:
        """The most that a motor which gives what it is asked for gives either way, shape (n,). [N·m]"""
        if self.law.ceiling is None:
            raise ValueError(f"{self.law.name} gives what its law says, not what it is asked for")
        return self.law.ceiling(speed, each_changed(lambda number: number[..., design], self.numbers))

    def is_free(self, design: int) -> bool:
        """Whether it gives what torque its speed takes: one that is asked for nothing less than its ceiling."""
        return self.law.is_commanded and bool(self.law.is_free(self.numbers)[design])

    def measured_speeds(self, design: int) -> tuple[float, float] | None:
        """First and last speed between which it was measured; None of a motor by a formula. [rad/s]"""
        if self.law.measured is None:
            return None
        least, most = self.law.measured(self.numbers)
        return float(least[design]), float(most[design])

    def rated_slip(self, design: int) -> float:
        """Slip at the rated torque: with a resistance behind slip rings more than on the plate, in its proportion. [1]

        docs/theory/drive, eq. (25.14).
        """
        of_plate = 1 - float(self.rating.speed[design]) / float(self.top_speed[design])
        return of_plate * float(self.slip_ratio[design])

    def row(self, design: int) -> tuple[Any, ...]:
        """Numbers of one design, plain floats, as kernels of one machine take them; of points of a curve an array."""
        return each_changed(lambda number: _plain(number[..., design]), self.numbers)

    def _by_time(self, kernel: ByTime | None, numbers: Any, speed: Array, time: Array | float) -> Array:
        if kernel is None:
            return np.full((self.n_designs, np.shape(speed)[-1]), np.nan)
        return kernel(speed, cast(Array, time), _over_speeds(numbers))


def motors_together(each: Sequence[DeclaredMotor]) -> DeclaredMotor:
    """Motors of one law, in their order, as one of all designs; nothing is said of their currents."""
    first = each[0]
    if len(each) == 1:
        return first
    if all(one is first for one in each):
        return replace(first.over_designs(len(each)), current_numbers=None)
    columns = zip(*(leaves(one.numbers) for one in each), strict=True)
    return replace(
        first,
        numbers=filled(first.numbers, (np.concatenate(column, axis=-1) for column in columns)),
        rating=Rating(*(np.concatenate(column) for column in zip(*(one.rating for one in each), strict=True))),
        top_speed=np.concatenate([one.top_speed for one in each]),
        current_numbers=None,
    )


def _over_speeds(numbers: tuple[Any, ...]) -> tuple[Any, ...]:
    return each_changed(lambda number: number[..., np.newaxis], numbers)


def _plain(number: Any) -> Any:
    return float(number) if np.ndim(number) == 0 else np.ascontiguousarray(number)


def curve_limits(motor: DeclaredMotor, design: int) -> BriefLimits:
    """The largest torque of its curve, and the least before that."""
    running = _running(motor, design)
    return BriefLimits(float(np.max(running)), _least_before_largest(running))


def peak_limits(motor: DeclaredMotor, design: int, peak: float, time: float = LONG_SINCE) -> BriefLimits:
    """The same of a motor whose largest torque is one of its numbers; its start at a time since it was switched on."""
    starting = curve(motor, design, _speeds_up(motor, design), time)
    return BriefLimits(peak, _least_before_largest(starting))


def star_limits(motor: DeclaredMotor, design: int) -> BriefLimits:
    """Of a motor that starts otherwise than it runs: the start as it is switched on."""
    return peak_limits(motor, design, float(np.max(_running(motor, design))), 0.0)


def ramped_limits(motor: DeclaredMotor, design: int) -> BriefLimits:
    """Of a motor that starts with its largest torque, as its field begins slowly."""
    largest = float(np.max(_running(motor, design)))
    return BriefLimits(largest, largest)


def start_limits(motor: DeclaredMotor, design: int, unknown: str) -> BriefLimits:
    """Of a motor whose start alone is known: why its largest torque is not."""
    return BriefLimits(start=_least_before_largest(_running(motor, design)), unknown=unknown)


def beyond_measured(motor: DeclaredMotor, design: int, speed: Array) -> Iterator[Words]:
    """Say that a motor by points runs at speeds beyond them; nothing of a motor by a formula. [rad/s]"""
    measured = motor.measured_speeds(design)
    if measured is None:
        return
    least, most = measured
    if np.max(speed) > most * (1 + _ROUNDING) or np.min(speed) < least - _ROUNDING * most:
        said = _("The motor runs beyond its table, {least} to {most}: there it has the torque of the last point.")
        yield said.format(least=number(least, "rpm"), most=number(most, "rpm"))


def curve(motor: DeclaredMotor, design: int, speeds: Array, time: float = LONG_SINCE) -> Array:
    """Torque of one design at speeds, shape (n,). [N·m]"""
    return motor.torque(np.broadcast_to(speeds, (motor.n_designs, speeds.size)), time)[design]


def _running(motor: DeclaredMotor, design: int) -> Array:
    return curve(motor, design, _speeds_up(motor, design))


def _speeds_up(motor: DeclaredMotor, design: int) -> Array:
    """Speeds from standstill up to the highest one that matters. [rad/s]"""
    top, measured = float(motor.top_speed[design]), motor.measured_speeds(design)
    if not np.isfinite(top):
        top = float(motor.rating.speed[design]) if measured is None else measured[1]
    return np.linspace(0.0, top, _N_SPEEDS)


def _least_before_largest(torque: Array) -> float:
    return float(np.min(torque[: first_largest(torque) + 1]))
