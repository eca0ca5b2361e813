"""Motors of the typical range as a machine file declares them, with the slip that the machine's own motor has."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from cranktrain.language import Words, _
from cranktrain.layout.drive.table import DriveSpec
from cranktrain.machine import Machine
from cranktrain.motors.cage.catalogue import four_pole_motors
from cranktrain.motors.cage.spec import HIGH_SLIP_BREAKDOWN
from cranktrain.numerics.ties import first_smallest
from cranktrain.quantities import shown
from cranktrain.saying.wording import number
from cranktrain.synthesis.proposal import found, found_ratio, quantity_text

_ORDINARY, _MOST_ORDINARY = 1.5, 0.05
"""Up to so many times the slip of a typical motor of its size, and up to 5 %, a cage motor's is an ordinary one."""


class KeptSlip(NamedTuple):
    """Which slip motors of the range are given.

    Attributes
    ----------
    is_wound : bool
        By a resistance behind slip rings; else by the bars of the cage.
    slip : float or None
        At the rated torque; None is that of ordinary cage motors. [1]
    """

    is_wound: bool = False
    slip: float | None = None


class _Entry(NamedTuple):
    """A key of the motor's table: a word, or a number with its unit, "" a plain one; whether the slip decides it."""

    key: str
    value: str | float
    unit: str = ""
    is_of_slip: bool = False


def typical_slip(place: int) -> float:
    """Rated slip of an ordinary cage motor of the range. [1]"""
    values = four_pole_motors().values
    return 1 - float(values.rated_speed[place] / values.synchronous_speed[place])


def declared_slip(machine: Machine) -> KeptSlip:
    """Slip that the machine's own motor has at its rated torque, where it is not that of an ordinary cage motor."""
    drive: DriveSpec | None = machine.drive
    own = None if drive is None or drive.motor is None else drive.motor.slip_at_rating
    if own is None or np.isnan(own.slip):
        return KeptSlip()
    if own.is_by_resistance:
        return KeptSlip(is_wound=True, slip=own.slip)
    nearest = first_smallest(np.abs(four_pole_motors().power - own.power))
    is_high = own.slip > max(_ORDINARY * typical_slip(nearest), _MOST_ORDINARY)
    return KeptSlip(slip=own.slip) if is_high else KeptSlip()


def slip_of_size(place: int, kept: KeptSlip) -> float:
    """Slip at the rated torque of a motor of the range: no less than an ordinary one has. [1]"""
    return max(typical_slip(place), kept.slip or 0.0)


def motor_table(place: int, kept: KeptSlip) -> dict[str, str | float]:
    """Table of a motor of the range, as `Machine.with_` takes it."""
    return {one.key: _text(one.value, one.unit) for one in _entries(place, kept)}


def motor_values(place: int, kept: KeptSlip, note: Words) -> dict[str, Words]:
    """The same as TOML by key, each number with its status; a note says what the size is."""
    of_slip = _("for a slip of {slip} at the rated torque", slip=number(slip_of_size(place, kept), "%"))
    return {entry.key: _toml(entry, of_slip if entry.is_of_slip else note) for entry in _entries(place, kept)}


def _text(value: str | float, unit: str) -> str | float:
    return quantity_text(value, unit) if unit and not isinstance(value, str) else value


def _toml(entry: _Entry, note: Words) -> Words:
    """Value of a key as TOML."""
    if isinstance(entry.value, str):
        return f'"{entry.value}"'
    if entry.key in ("size", "power") or (entry.is_of_slip and entry.unit):
        return found(entry.value, entry.unit, note)
    if entry.is_of_slip:
        return found_ratio(entry.value, note)
    typical = _("typical")
    if entry.unit:
        return found(entry.value, entry.unit, typical, "assumed")
    return found_ratio(entry.value, typical, "assumed")


def _entries(place: int, kept: KeptSlip) -> Iterator[_Entry]:
    """Keys of the table: a size, or a plate with the slip that is kept."""
    motors = four_pole_motors()
    values, power = motors.values, float(motors.power[place])
    slip, field = slip_of_size(place, kept), float(values.synchronous_speed[place])
    if not kept.is_wound and slip == typical_slip(place):
        yield from (_Entry("kind", "cage"), _Entry("size", power, "kW"))
        return
    yield _Entry("kind", "wound_rotor" if kept.is_wound else "cage")
    if not kept.is_wound:
        yield _Entry("curve", "kloss")
    yield _Entry("power", power, "kW")
    if kept.is_wound:
        yield _Entry("speed", float(values.rated_speed[place]), "rpm")
    else:
        yield _Entry("speed", _whole(field * (1 - slip)), "rpm", is_of_slip=True)
    yield _Entry("synchronous_speed", field, "rpm")
    yield _Entry("breakdown_ratio", float(values.breakdown_ratio[place]) if kept.is_wound else HIGH_SLIP_BREAKDOWN)
    if kept.is_wound:
        yield _Entry("resistance_ratio", round(slip / typical_slip(place), 4), is_of_slip=True)
    yield _Entry("inertia", float(motors.inertia[place]), "kg·m²")


def _whole(speed: float) -> float:
    """Speed in whole turns a minute, as plates have it. [rad/s]"""
    per_minute = float(shown(1.0, "rpm"))
    return round(speed * per_minute) / per_minute
