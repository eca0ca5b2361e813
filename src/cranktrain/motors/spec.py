"""What the tables of all kinds of motors have in common: the rotor's inertia, a rated point, torques at speeds."""

from abc import abstractmethod
from collections.abc import Iterable, Iterator
from itertools import pairwise
from typing import Annotated, ClassVar, NamedTuple

import numpy as np
from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, Words, _
from cranktrain.motion import Array, plain
from cranktrain.motors.declared import DeclaredMotor, Rating
from cranktrain.quantities import (
    Dimension,
    Given,
    NonNegativeInertia,
    PositivePower,
    PositiveSpeed,
    PositiveTorque,
    Quantity,
)
from cranktrain.spec import Spec, missing

NonNegativeMoment = Annotated[Given, Quantity(Dimension.FLYWHEEL_MOMENT, at_least=0.0)]


class RatedSlip(NamedTuple):
    """How far a motor falls behind its field at the rated torque.

    Attributes
    ----------
    slip : float
        NaN where its table does not say it. [1]
    power : float
        At the shaft there. [W]
    is_by_resistance : bool
        Behind slip rings; else by the bars of a cage.
    """

    slip: float
    power: float
    is_by_resistance: bool = False


class DrivingMotorSpec(Spec, frozen=True):
    """What every motor of a machine file declares; all speeds and torques are those of its own shaft."""

    symbol_of_largest: ClassVar[str] = "M_b"
    """Symbol of `largest_torque`."""

    kind: str
    inertia: NonNegativeInertia | None = Field(default=None, description=N_("Moment of inertia of the rotor."))
    flywheel_moment: NonNegativeMoment | None = Field(
        default=None, description=N_("GD², four times the rotor's moment of inertia; instead of inertia.")
    )

    @abstractmethod
    def declared(self) -> DeclaredMotor:
        """Give what it says, in SI; numbers are one number or of shape (design,)."""

    def _problems(self) -> Iterator[Problem]:
        """Find a rotor given twice."""
        if self.inertia is not None and self.flywheel_moment is not None:
            allowed = _("must not stand beside inertia; GD² = 4 J says the same")
            yield Problem("flywheel_moment", None, allowed)

    @property
    def rotor_inertia(self) -> Array | None:
        """Moment of inertia of the rotor, however it is given; None where it is not. [kg·m²]"""
        if self.inertia is not None:
            return self.inertia.array
        return None if self.flywheel_moment is None else self.flywheel_moment.array / 4

    @property
    def largest_torque(self) -> Array | None:
        """Breakdown torque of an induction motor, peak torque of a servo motor; None of other kinds. [N·m]"""
        return None

    @property
    def slip_at_rating(self) -> RatedSlip | None:
        """Slip of a motor for which a typical one with the same slip can stand; None of other kinds."""
        return None


class RatedSpec(DrivingMotorSpec, frozen=True):
    """A motor whose plate may say a rated point: its speed, and power or torque."""

    power: PositivePower | None = Field(default=None, description=N_("Rated power at the shaft; or torque."))
    torque: PositiveTorque | None = Field(default=None, description=N_("Rated torque; or power."))
    speed: PositiveSpeed | None = Field(default=None, description=N_("Rated speed."))

    def _problems(self) -> Iterator[Problem]:
        """Find power and torque beside each other, and one of them without the speed."""
        yield from super()._problems()
        if self.power is not None and self.torque is not None:
            yield Problem("torque", None, _("must not stand beside power, from which it follows with speed"))
        if self.speed is None and (self.power is not None or self.torque is not None):
            yield from missing_keys(self, ("speed",))
        if self.speed is not None and self.power is None and self.torque is None:
            yield Problem("torque", None, _("is missing; give torque or power beside speed"))

    @property
    def has_no_plate(self) -> bool:
        """Whether nothing of a rated point is there."""
        return self.speed is None and self.power is None and self.torque is None

    @property
    def is_rated(self) -> bool:
        """Whether it has a rated point."""
        return self.speed is not None and (self.power is not None or self.torque is not None)

    @property
    def rating(self) -> Rating:
        """Rated point; NaN where there is none."""
        if self.speed is None:
            return Rating()
        if self.torque is not None:
            return Rating(self.torque.array, self.speed.array)
        return Rating() if self.power is None else Rating(self.power.array / self.speed.array, self.speed.array)


def motor_of(spec: DrivingMotorSpec, n_designs: int = 1) -> DeclaredMotor:
    """Motor that a table declares.

    Parameters
    ----------
    spec : DrivingMotorSpec
        Of one design, or of several in columns.
    n_designs : int

    Returns
    -------
    DeclaredMotor
        Its numbers of as many designs.
    """
    return spec.declared().over_designs(n_designs)


def missing_keys(spec: Spec, names: Iterable[str]) -> Iterator[Problem]:
    """Find keys that are needed, and are not there."""
    for name in names:
        if getattr(spec, name) is None:
            yield Problem(name, None, missing(type(spec).model_fields[name].annotation, name))


def out_of_place(spec: Spec, names: Iterable[str], allowed: Words) -> Iterator[Problem]:
    """Find keys that say nothing here, or the same once more."""
    for name in names:
        if getattr(spec, name) is not None:
            yield Problem(name, None, allowed)


def first(number: Array) -> float:
    """Number of the first design."""
    return plain(np.ravel(number)[0])


def points(listed: tuple[Given, ...]) -> Array:
    """Numbers of a list, shape (point, design), of one design (point, 1)."""
    return np.stack(np.broadcast_arrays(*(np.atleast_1d(one.array) for one in listed)))


def curve_problems(speeds: tuple[Given, ...], torques: tuple[Given, ...], path: str = "") -> Iterator[Problem]:
    """Find speeds that do not rise, torques that are not as many, and a motor that never drives."""
    if len(torques) != len(speeds):
        allowed = _("must be as many as speeds, {n}", n=len(speeds))
        yield Problem(f"{path}torques", None, allowed)
    if all(torque.si <= 0 for torque in torques):
        yield Problem(f"{path}torques", None, _("must be more than 0 at one speed or more, or it never drives"))
    for place, (one, other) in enumerate(pairwise(speeds), 1):
        if other.si <= one.si:
            allowed = _(
                "must be more than the speed before it, {speed}: one torque for each speed, or it is no function"
            )
            yield Problem(f"{path}speeds[{place}]", other.text, allowed.format(speed=one.text))
