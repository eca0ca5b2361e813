"""A crank-rocker's drive by the symbols of [gandzha], as a small table that a user writes."""

from collections.abc import Iterator, Mapping
from typing import Annotated, Literal, NamedTuple

import numpy as np
from pydantic import ConfigDict

from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.layout.bodies import Friction
from cranktrain.mechanisms.crank_rocker.facts import grashof_class
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker
from cranktrain.motion import Array
from cranktrain.quantities import (
    Dimension,
    FlywheelMoment,
    Given,
    Length,
    NonNegativeInertia,
    NonNegativeLength,
    PositiveLength,
    PositiveMass,
    PositiveRatio,
    Quantity,
)
from cranktrain.quantities.fields import Force
from cranktrain.spec import Spec, validated
from cranktrain.texts.crank_rocker_drive import Drivetrain, RigidRod, drivetrain
from cranktrain.texts.friction_circles import FrictionRadii, friction_radius

Efficiency = Annotated[Given, Quantity(Dimension.RATIO, above=0.0, at_most=1.0)]
Torque = Annotated[Given, Quantity(Dimension.TORQUE)]
LoadSense = Literal["", "active", "resisting", "both"]

_KEYS = {
    "load": "Q",
    "idle_torque": "M_xx0",
    "gear_moment": "GD2_0",
    "driven_moment": "GD2_O1",
    "rod_mass": "m",
    "rod_along": "p",
    "rod_across": "q",
    "rod_inertia": "I",
    "crank_inertia": "J",
    "friction": "f",
    "shaft_pin": "r_O",
    "crank_pin": "r_B",
    "rocker_pin": "r_A",
    "pivot_pin": "r_O1",
}
_SIDES = {"open": 1.0, "crossed": -1.0}
_OF_PINS = ("shaft_pin", "crank_pin", "rocker_pin", "pivot_pin")


def _key(name: str) -> str:
    """Symbol of a field."""
    return _KEYS.get(name, name)


class DriveTable(Spec, frozen=True):
    """A crank-rocker's drive: lengths, gear, load and flywheel moments; the rod's mass and pins that rub if known."""

    model_config = ConfigDict(alias_generator=_key)

    r: PositiveLength
    l: PositiveLength
    r1: PositiveLength
    d: PositiveLength
    branch: Literal["open", "crossed"] = "open"
    i: PositiveRatio
    eta_p: Efficiency
    eta_sh: Efficiency
    load: Force
    idle_torque: Torque | None = None
    gear_moment: FlywheelMoment
    driven_moment: FlywheelMoment
    rod_mass: PositiveMass | None = None
    rod_along: Length | None = None
    rod_across: Length = Given(0.0, "0 mm")
    rod_inertia: NonNegativeInertia | None = None
    crank_inertia: NonNegativeInertia | None = None
    friction: Friction | None = None
    shaft_pin: NonNegativeLength | None = None
    crank_pin: NonNegativeLength | None = None
    rocker_pin: NonNegativeLength | None = None
    pivot_pin: NonNegativeLength | None = None

    def _problems(self) -> Iterator[Problem]:
        """Find a linkage that is no crank-rocker, half a rod, and friction without pins."""
        if int(np.ravel(grashof_class(self.geometry))[0]) != 0:
            allowed = _(
                "must be a crank-rocker: r the shortest link, and r + the longest less than both others together"
            )
            yield Problem("r", self.r.text, allowed)
        of_rod = {"rod_along": self.rod_along, "rod_inertia": self.rod_inertia}
        for name, given in of_rod.items():
            if (given is None) != (self.rod_mass is None):
                has_mass = self.rod_mass is not None
                allowed = _("is missing; m has it") if has_mass else _("must be left out without m")
                yield Problem(_key(name), None if given is None else given.text, allowed)
        if self.friction is not None and all(getattr(self, name) is None for name in _OF_PINS):
            yield Problem(
                _key("shaft_pin"), None, _("is missing, with r_B, r_A, r_O1: radii of the pins that f rubs on")
            )
        for name in ("gear_moment", "driven_moment"):
            given = getattr(self, name)
            if given.si < 0:
                yield Problem(_key(name), given.text, _("must not be less than 0"))

    @property
    def geometry(self) -> CrankRocker:
        """Four lengths and the side. [m]"""
        r, l, r1, d = (np.array(one.si) for one in (self.r, self.l, self.r1, self.d))
        return CrankRocker(r, l, r1, d, np.array(_SIDES[self.branch]))


DRIVE_KEYS = tuple(_key(name) for name in DriveTable.model_fields)
"""Symbols that a drive's table may have."""


class CrankRockerDrive(NamedTuple):
    """A crank-rocker and its drive, in SI.

    load: Q, tangential force at A against the growing α₁ [N]; idle_torque: M_xx0 on the rocker's shaft [N·m];
    gear_moment: (GD²)₀; driven_moment: GD² on O₁ [kg·m²]; rod, crank_inertia: not in the source; friction: radii of the
    friction circles, None where none are known; load_sense: of a machine's load, empty of a Q that was given.
    """

    geometry: CrankRocker
    train: Drivetrain
    load: Array
    idle_torque: Array
    gear_moment: Array
    driven_moment: Array
    rod: RigidRod
    crank_inertia: Array
    friction: FrictionRadii | None = None
    load_sense: LoadSense = ""

    @property
    def has_masses(self) -> bool:
        """Whether rod or crank has what the source leaves out."""
        return float(self.rod.mass) > 0 or float(self.crank_inertia) > 0


def read_drive(data: Mapping[str, object]) -> CrankRockerDrive:
    """Read a drive's table.

    Parameters
    ----------
    data : mapping
        By the source's symbols, each text with its unit: r, l, r1, d, branch, i, eta_p, eta_sh, Q, M_xx0, GD2_0,
        GD2_O1; beyond the source m, p, q, I of the rod, J of the crank; f and r_O, r_B, r_A, r_O1 of pins
        that rub.

    Returns
    -------
    CrankRockerDrive

    Raises
    ------
    InputError
        With everything that is wrong.

    Examples
    --------
    >>> links = {"r": "250 mm", "l": "700 mm", "r1": "500 mm", "d": "800 mm"}
    >>> drive = read_drive(
    ...     links | {"i": 40, "eta_p": 0.94, "eta_sh": 0.9, "Q": "4 kN", "GD2_0": "2 kg*m^2", "GD2_O1": "200 kg*m^2"}
    ... )
    >>> float(drive.load), float(drive.idle_torque)
    (4000.0, 2000.0)
    """
    table = validated(DriveTable, data)
    radii = None
    if table.friction is not None:
        pins = (_number(getattr(table, name)) for name in _OF_PINS)
        radii = FrictionRadii(*(friction_radius(table.friction.array, pin) for pin in pins))
    rod = (table.rod_mass, table.rod_along, table.rod_across, table.rod_inertia)
    idle = table.load.array * table.r1.array if table.idle_torque is None else table.idle_torque.array
    return CrankRockerDrive(
        table.geometry,
        drivetrain(table.i.array, table.eta_p.array, table.eta_sh.array),
        table.load.array,
        idle,
        table.gear_moment.array,
        table.driven_moment.array,
        RigidRod(*map(_number, rod)),
        _number(table.crank_inertia),
        radii,
    )


def _number(given: Given | None) -> Array:
    """SI value of a number that may be left out."""
    return np.array(0.0 if given is None else given.si)
