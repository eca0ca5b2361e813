"""Drives whose loads drive them, or that lose nearly all: computed with all the same, and flagged."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.drive.declared import DeclaredDrive
from cranktrain.motion import Array
from cranktrain.motors import DeclaredMotor
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.questions.loads.load_work import LoadWork
from cranktrain.record import record
from cranktrain.saying.checks import Flagged, Limit, flagged
from cranktrain.saying.wording import number

# Gears have 0.95 and more, belts 0.9, self-locking worms 0.3 to 0.5, screws 0.2.
_STAGE_EFFICIENCY = Limit(
    np.inf,
    "",
    N_("A stage with an efficiency of {value} loses nearly all; self-locking worms have 0.2 and more: is it right?"),
    0.15,
)
_DRIVES = 1e-6
"""Of what all loads do and take: less work than that is none."""


@record
class UnlikelyDrive(Flagged):
    """Drives that hardly any machine has."""


def unlikely_drive(
    drive: DeclaredDrive | None,
    motor: DeclaredMotor | None,
    work: LoadWork | None,
    gas: GasPressures | None,
    crank_angle: CrankAngle,
) -> UnlikelyDrive:
    """Flag what is unlikely, as far as it is known."""
    found: list[Words] = [] if drive is None else [*flagged(_STAGE_EFFICIENCY, drive.forward)]
    if motor is not None and work is not None:
        found += _driving(work, None if gas is None else gas.work_over(crank_angle))
    return UnlikelyDrive(unlikely=tuple(found))


def _driving(work: LoadWork, of_gas: Array | None) -> Iterator[Words]:
    """Flag loads that do work over a cycle, where nothing else but a motor takes it."""
    own = np.sum(work.load_work, axis=1)
    gross = np.sum(np.abs(work.load_work), axis=1)
    by_gas = 0.0 if of_gas is None else np.sum(of_gas, axis=1)
    # What fires drives the motor as it should.
    is_driven = (own > _DRIVES * gross) & (own + by_gas > _DRIVES * gross) & (by_gas <= 0)
    if np.any(is_driven):
        design = int(np.argmax(is_driven))
        each = work.load_work[design]
        names = ", ".join(name for name, one in zip(work.labels["load"], each.tolist(), strict=True) if one > 0)
        said = _("{names} drives the machine with {work} a cycle, and its motor brakes: are its sense and side right?")
        yield said.format(names=names, work=number(float(own[design]), "J"))
