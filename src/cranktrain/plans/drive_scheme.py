"""The chain from motor to crank as data: what stands on each shaft, in its order, and the stages between."""

from collections.abc import Iterator
from typing import Literal, NamedTuple, TypeAlias

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.drive.grip_tables import BrakeSpec, ClutchSpec
from cranktrain.layout.drive.shafts import shaft_number
from cranktrain.layout.drive.table import DriveSpec, StageKind, StageSpec
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.motors import AnyMotor, motor_of

Symbol: TypeAlias = Literal["motor", "disc", "brake", "clutch", "stage", "crank"] | StageKind

STAGES = {
    "gear": N_("gear"),
    "worm": N_("worm gear"),
    "belt": N_("belt"),
    "chain": N_("chain drive"),
    "coupling": N_("coupling"),
    "linkage": N_("linkage"),
    "stage": N_("stage, its kind not said"),
}
"""What stages are called, by symbol."""

MEANINGS = {
    "P": N_("rated power"),
    "n": N_("rated speed"),
    "M_b": N_("breakdown torque"),
    "M_pk": N_("peak torque"),
    "M": N_("torque while it slips"),
    "M_s": N_("torque that it holds"),
    "GD²": N_("flywheel moment"),
    "J": N_("moment of inertia"),
    "i": N_("ratio"),
    "η_f": N_("efficiency toward the crank"),
    "η_b": N_("efficiency from the crank"),
    "M_0": N_("drag at the input"),
}
"""What the letters of facts stand for, as docs/theory/drive and docs/theory/transient have them."""

_BRAKE, _CLUTCH, _FLYWHEEL, _CRANK = N_("brake"), N_("clutch"), N_("flywheel"), N_("crank shaft")


class ChainFact(NamedTuple):
    """A number with its letter and its SI unit."""

    letter: str
    value: float
    unit: str


class DriveElement(NamedTuple):
    """Something on a shaft, or a stage behind it.

    Attributes
    ----------
    symbol : Symbol
        "stage" of one whose kind is not said.
    words : Words
        What it is.
    facts : tuple of ChainFact
        What the file has of it; the letters are those of `MEANINGS`.
    ratio : float
        Of a stage; 1 of all else.
    """

    symbol: Symbol
    words: Words
    facts: tuple[ChainFact, ...] = ()
    ratio: float = 1.0


class DriveShaft(NamedTuple):
    """A shaft with what stands on it from the motor's side on; a stage ends each but the last, the crank's.

    Attributes
    ----------
    elements : tuple of DriveElement
    speed : float
        At the declared speed of the crank; NaN where it has none, or a wanted motion. [rad/s]
    inertia : float
        Of what turns with it, by `[drive]` and `[evenness]`; a clutch locked. [kg·m²]
    """

    elements: tuple[DriveElement, ...]
    speed: float
    inertia: float


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
    behind = np.append(np.cumprod([stage.ratio.si for stage in spec.stage][::-1])[::-1], 1.0)
    speeds = _crank_speed(machine) * behind
    return tuple(_shaft(machine, spec, place, float(speed)) for place, speed in enumerate(speeds))


def _crank_speed(machine: Machine) -> float:
    """Declared speed of a crank that turns at one; NaN of others. [rad/s]"""
    main = machine.shaft.get("main")
    return np.nan if main is None or main.speed is None or main.motion is not None else main.speed.si


def _shaft(machine: Machine, spec: DriveSpec, place: int, speed: float) -> DriveShaft:
    """A shaft by how many stages stand before it."""
    is_last = place == len(spec.stage)
    elements = list(_on_shaft(spec, place, len(spec.stage)))
    inertias = [fact.value for one in elements for fact in one.facts if fact.letter == "J"]
    own = machine.evenness.inertia if is_last and machine.evenness is not None else None
    if own is not None:
        elements.append(DriveElement("disc", _(_FLYWHEEL), (ChainFact("J", _first(own), "kg*m^2"),)))
        inertias.append(_first(own))
    elements.append(DriveElement("crank", _(_CRANK)) if is_last else _of_stage(spec.stage[place]))
    return DriveShaft(tuple(elements), speed, sum(inertias))


def _on_shaft(spec: DriveSpec, place: int, n_stages: int) -> Iterator[DriveElement]:
    """Motor, what turns with a shaft by its own name, clutch and brake."""
    brake, clutch = spec.brake, spec.clutch
    if place == 0 and spec.motor is not None:
        yield DriveElement("motor", _(motor_of(spec.motor).law.title), tuple(_of_motor(spec.motor)))
    for name, part in spec.part.items():
        if shaft_number(part.on) == place:
            yield DriveElement(
                "disc",
                name.replace("_", " "),
                tuple(_of_rotor(part.moment, is_moment=part.flywheel_moment is not None)),
            )
    of_clutch = None if clutch is None else shaft_number(clutch.on)
    places = {"motor": 0, "clutch": of_clutch, "crank": n_stages}
    if clutch is not None and of_clutch == place:
        driven = (ChainFact("J", clutch.driven_inertia.si, "kg*m^2"),) if clutch.driven_inertia.si > 0 else ()
        yield DriveElement("clutch", _(_CLUTCH), (*_of_grip(clutch), *driven))
    if brake is not None and places[brake.on] == place:
        yield DriveElement("brake", _(_BRAKE), tuple(_of_grip(brake)))


def _of_motor(motor: AnyMotor) -> Iterator[ChainFact]:
    """Rated point, largest torque and rotor of a motor, as far as its table has them."""
    rating, largest = motor_of(motor).rating, motor.largest_torque
    facts = [ChainFact("P", _first(rating.power), "W"), ChainFact("n", _first(rating.speed), "rad/s")]
    facts += [] if largest is None else [ChainFact(motor.symbol_of_largest, _first(largest), "N*m")]
    yield from (fact for fact in facts if np.isfinite(fact.value))
    if motor.rotor_inertia is not None:
        yield from _of_rotor(motor.rotor_inertia, is_moment=motor.flywheel_moment is not None)


def _of_rotor(inertia: Array, *, is_moment: bool) -> Iterator[ChainFact]:
    """Inertia of what turns, and its flywheel moment if that is how it is given."""
    yield ChainFact("J", _first(inertia), "kg*m^2")
    if is_moment:
        yield ChainFact("GD²", 4 * _first(inertia), "kg*m^2")


def _of_grip(grip: ClutchSpec | BrakeSpec) -> Iterator[ChainFact]:
    """Torques of a clutch or brake."""
    yield ChainFact("M", grip.torque.si, "N*m")
    if grip.static_torque is not None:
        yield ChainFact("M_s", grip.static_torque.si, "N*m")


def _of_stage(stage: StageSpec) -> DriveElement:
    """A stage with its ratio, its efficiencies both ways, and what it takes whatever it passes on."""
    symbol = stage.kind or ("stage" if stage.lead_angle is None else "worm")
    forward, back = (_first(one) for one in stage.efficiencies)
    facts = [ChainFact("i", stage.ratio.si, "1"), ChainFact("η_f", forward, "1"), ChainFact("η_b", back, "1")]
    facts += [ChainFact("M_0", stage.drag.si, "N*m")] if stage.drag.si > 0 else []
    return DriveElement(symbol, _(STAGES[symbol]), tuple(facts), stage.ratio.si)


def _first(number: Array) -> float:
    """Number of the first design."""
    return float(np.ravel(number)[0])
