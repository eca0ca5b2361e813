"""The chain from motor to crank as data: what stands on each shaft, in its order, and the stages between."""

from collections.abc import Iterator
from typing import Literal, NamedTuple, TypeAlias

import numpy as np

from cranktrain.language import N_, _
from cranktrain.machine import Machine
from cranktrain.questions.drive.motor_tables import motor_of
from cranktrain.questions.drive.shafts import shaft_number
from cranktrain.questions.drive.spec import DriveSpec, StageSpec

Symbol: TypeAlias = Literal["motor", "disc", "brake", "clutch", "stage", "crank"]

_STAGE, _WORM, _BRAKE, _CLUTCH = N_("gear"), N_("worm gear"), N_("brake"), N_("clutch")


class DriveElement(NamedTuple):
    """Something on a shaft, or a stage behind it.

    Attributes
    ----------
    symbol : Symbol
    words : str
        What it is.
    value : float
        Of a motor and of the crank the speed, at the declared one of the crank; of a part the inertia; of clutch and
        brake the torque while it slips; of a stage the ratio. NaN where it is not known. [rad/s, kg·m², N·m, 1]
    unit : str
    efficiency : float
        Of a stage, toward the crank. [1]
    """

    symbol: Symbol
    words: str
    value: float
    unit: str
    efficiency: float = 1.0


class DriveShaft(NamedTuple):
    """A shaft with what stands on it from the motor's side on; a stage ends each but the last, the crank's."""

    elements: tuple[DriveElement, ...]


def drive_chain(machine: Machine) -> tuple[DriveShaft, ...]:
    """Shafts of a machine's drive, the motor's first; none of a machine without one.

    Parameters
    ----------
    machine : Machine

    Returns
    -------
    tuple of DriveShaft
        With every part, stage, clutch and brake that the file declares, each once.
    """
    spec: DriveSpec | None = machine.drive
    if spec is None:
        return ()
    n_stages = len(spec.stage)
    main = machine.shaft.get("main")
    crank_speed = np.nan if main is None or main.speed is None else main.speed.si
    behind = np.append(np.cumprod([stage.ratio.si for stage in spec.stage][::-1])[::-1], 1.0)
    shafts: list[DriveShaft] = []
    for place in range(n_stages + 1):
        elements = list(_on_shaft(spec, place, n_stages))
        if place < n_stages:
            elements.append(_of_stage(spec.stage[place]))
        else:
            elements.append(DriveElement("crank", _("crank"), float(crank_speed), "rad/s"))
        if place == 0 and spec.motor is not None:
            title = _(motor_of(spec.motor).motor.title)
            elements.insert(0, DriveElement("motor", title, float(crank_speed * behind[0]), "rad/s"))
        shafts.append(DriveShaft(tuple(elements)))
    return tuple(shafts)


def _on_shaft(spec: DriveSpec, place: int, n_stages: int) -> Iterator[DriveElement]:
    """What turns with a shaft by its own name, and clutch and brake."""
    brake, clutch = spec.brake, spec.clutch
    for name, part in spec.part.items():
        if shaft_number(part.on) == place:
            inertia = float(np.ravel(part.moment)[0])
            yield DriveElement("disc", name.replace("_", " "), inertia, "kg*m^2")
    of_clutch = None if clutch is None else shaft_number(clutch.on)
    places = {"motor": 0, "clutch": of_clutch, "crank": n_stages}
    if clutch is not None and of_clutch == place:
        yield DriveElement("clutch", _(_CLUTCH), clutch.torque.si, "N*m")
    if brake is not None and places[brake.on] == place:
        yield DriveElement("brake", _(_BRAKE), brake.torque.si, "N*m")


def _of_stage(stage: StageSpec) -> DriveElement:
    """A stage with its ratio and efficiency."""
    words = _(_STAGE) if stage.lead_angle is None else _(_WORM)
    return DriveElement("stage", words, stage.ratio.si, "1", float(np.ravel(stage.efficiencies[0])[0]))
