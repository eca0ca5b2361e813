"""A machine's crank-rocker as the drive of [gandzha]: its numbers by that source's symbols."""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from cranktrain.errors import InputError, Problem, problems_as
from cranktrain.language import N_, _
from cranktrain.layout.drive.table import DriveSpec
from cranktrain.layout.load_tables import LoadSpec
from cranktrain.layout.masses import masses_of
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.texts.crank_rocker_drive import Drivetrain
from cranktrain.texts.drive_table import CrankRockerDrive, LoadSense, read_drive
from cranktrain.transient.gearing import stages

_KIND = "crank_rocker"
_OF_STAGES = frozenset({"i", "eta_p", "eta_sh"})
_SAID = {
    "i": ("drive.stage.ratio", N_("is missing: those of all stages make i"), "40"),
    "eta_p": ("drive.stage.efficiency", N_("is missing: those of all gears make η_p"), "0.94"),
    "eta_sh": ("drive.stage", N_('is missing: the efficiency of those of kind "linkage" makes η_ш'), "0.9"),
    "Q": ("load", N_("must have a torque on the rocker, or a force on it with a radius, of one size: Q r₁"), "4 kN"),
    "GD2_0": ("drive.part", N_("is missing, with the rotor's inertia: the motor's shaft has (GD²)₀"), "2 kg*m^2"),
    "GD2_O1": ("masses.rocker", N_("is missing: the rocker's shaft has GD²"), "200 kg*m^2"),
}
"""Where a machine says what the text needs, what it would say there, and a value that may be set instead."""


def _in_python(symbol: str, value: str) -> str:
    """Write how a symbol is set, as functions take it."""
    return f'set={{"{symbol}": "{value}"}}'


def machine_drive(
    machine: Machine,
    typed: Mapping[str, object] = MappingProxyType({}),
    *,
    as_set: Callable[[str, str], str] = _in_python,
) -> CrankRockerDrive:
    """Give a machine's crank-rocker and its drive as the text on these takes them.

    Parameters
    ----------
    machine : Machine
    typed : mapping
        Other values by the text's symbols, as `read_drive` takes them. With i, eta_p or eta_sh among them the symbols
        stand for the stages of [drive].
    as_set : callable
        How a symbol with its value is set, for what is said where one is missing.

    Returns
    -------
    CrankRockerDrive

    Raises
    ------
    InputError
        If there is no crank-rocker, or neither the machine nor `typed` says what the text needs, with the path where
        the machine would.
    """
    data = drive_data(machine) | dict(typed)

    def said(problem: Problem) -> Problem:
        if problem.path in data or problem.path not in _SAID:
            return problem
        path, allowed, value = _SAID[problem.path]
        repair = _("or {example}", example=as_set(problem.path, value))
        return replace(problem, path=path, allowed=_(allowed), repair=repair)

    with problems_as(said):
        drive = read_drive(data)
    if "Q" not in typed:
        drive = drive._replace(load_sense=_load_sense(machine))
    if machine.drive is None or not _OF_STAGES.isdisjoint(typed):
        return drive
    return drive._replace(train=drivetrain_of(machine.drive))


def missing_values(machine: Machine) -> dict[str, str]:
    """Give what the text needs and a machine with a crank-rocker lacks: symbols, each with a value that might be."""
    known = drive_data(machine)
    return {symbol: value for symbol, (_path, _allowed, value) in _SAID.items() if symbol not in known}


def drive_data(machine: Machine, mechanism: str | None = None) -> dict[str, object]:
    """Give a machine's crank-rocker by the symbols that `read_drive` takes, as far as the machine says them.

    Parameters
    ----------
    machine : Machine
        Its [drive], if any, gives i, eta_p and GD2_0; [masses] gives m, p, q, I, J and GD2_O1; loads on the rocker of
        one size give Q.
    mechanism : str, optional
        Name of the crank-rocker; the first unless given.

    Returns
    -------
    dict
        Texts with their units.

    Raises
    ------
    InputError
        If there is none.
    """
    found = [one for one in machine.places if one.kind.name == _KIND and mechanism in (None, one.name)]
    if not found:
        raise InputError([Problem("mechanism", mechanism, _("must have a crank-rocker: the text speaks of no other"))])
    place = found[0]
    geometry = place.geometry
    lengths = (geometry.crank_radius, geometry.rod_length, geometry.rocker_length, geometry.ground_length)
    data: dict[str, object] = {
        symbol: _written(length, "m") for symbol, length in zip(("r", "l", "r1", "d"), lengths, strict=True)
    }
    data["branch"] = "open" if float(geometry.side) > 0 else "crossed"
    return data | dict(_of_gear(machine)) | dict(_of_masses(machine, place)) | dict(_of_loads(machine, place))


def drivetrain_of(drive: DriveSpec) -> Drivetrain:
    """The stages of a machine's [drive] with their own losses: those of kind "linkage" are the text's η_ш."""
    each = [
        (_first(stage.ratio.array), *map(_first, stage.efficiencies), _first(stage.drag.array)) for stage in drive.stage
    ]
    is_linkage = [stage.kind == "linkage" for stage in drive.stage]
    of_gears = math.prod(own[1] for own, is_pins in zip(each, is_linkage, strict=True) if not is_pins)
    ahead, back = (
        math.prod(own[way] for own, is_pins in zip(each, is_linkage, strict=True) if is_pins) for way in (1, 2)
    )
    gearing = stages(0.0, *((ratio, forward, back, drag, 0.0) for ratio, forward, back, drag in each))
    return Drivetrain(gearing, *map(np.array, (of_gears, ahead, back)), is_of_machine=True)


def _of_gear(machine: Machine) -> Iterator[tuple[str, object]]:
    """Ratio and efficiency of all stages; flywheel moment of what turns with their shafts, at the motor."""
    drive = machine.drive
    if drive is None:
        return
    ratios = [_first(stage.ratio.array) for stage in drive.stage]
    train = drivetrain_of(drive)
    yield "eta_sh", float(train.linkage_efficiency)
    yield "i", float(np.prod(ratios))
    yield "eta_p", float(train.gear_efficiency)
    motor = None if drive.motor is None else drive.motor.rotor_inertia
    if motor is None and not drive.part:
        return
    own = 0.0 if motor is None else float(np.ravel(motor)[0])
    for part in drive.part.values():
        turned = 1.0 if part.on == "motor" else float(np.prod(ratios[: part.on]))
        own += float(np.ravel(part.moment)[0]) / turned**2
    yield "GD2_0", _written(4 * own, "kg*m^2")


def _of_masses(machine: Machine, place: PlacedMechanism) -> Iterator[tuple[str, object]]:
    """The rod, and what turns about the fixed pivots: inertia about its centre of mass and its mass at its distance."""
    rod = _body(machine, place, "rod")
    yield "J", _written(inertia_about_pivot(machine, place, "crank"), "kg*m^2")
    if (driven := inertia_about_pivot(machine, place, "rocker")) > 0:
        yield "GD2_O1", _written(4 * driven, "kg*m^2")
    if rod[0] > 0:
        values = zip(("m", "p", "q", "I"), rod, ("kg", "m", "m", "kg*m^2"), strict=True)
        yield from ((symbol, _written(value, unit)) for symbol, value, unit in values)


def inertia_about_pivot(machine: Machine, place: PlacedMechanism, link: str) -> float:
    """Moment of inertia of a crank or rocker about its fixed pivot, 0 of one without mass. [kg·m²]"""
    mass, along, across, own = _body(machine, place, link)
    return own + mass * (along**2 + across**2)


def _body(machine: Machine, place: PlacedMechanism, link: str) -> tuple[float, ...]:
    """Mass, place along and across, and inertia of a link. [kg, m, m, kg·m²]"""
    (bodies,) = (batch.bodies for batch in masses_of((place,), machine.weighed, 1).batches)
    body = dict(zip(place.kind.dynamics.moving, bodies, strict=True))[link]
    return tuple(float(np.ravel(one)[0]) for one in body)


def _of_loads(machine: Machine, place: PlacedMechanism) -> Iterator[tuple[str, object]]:
    """Q of the loads on the rocker, if each is of one size: a torque, or a force across the rocker on an arm."""
    own = [load for load in machine.load.values() if load.on.rpartition(".")[2] == "rocker"]
    torques = [_torque(load) for load in own]
    if own and None not in torques:
        torque = sum(one for one in torques if one is not None)
        yield "Q", _written(torque / float(place.geometry.rocker_length), "N")


def _load_sense(machine: Machine) -> LoadSense:
    """Whether what loads the rocker resists wherever it turns, or has a direction of its own, or there is both."""
    resists = {load.sense == "resisting" for load in machine.load.values() if load.on.rpartition(".")[2] == "rocker"}
    if len(resists) > 1:
        return "both"
    return "resisting" if True in resists else "active"


def _torque(load: LoadSpec) -> float | None:
    """Torque of a load against the growing angle of the rocker; of one that resists its size. None where it varies."""
    varies = (load.crank_angles, load.travel, load.swing, load.direction, load.at_speed, load.at_turning)
    sizes = load.force if load.torque is None else load.torque
    if any(one is not None for one in varies) or sizes is None or len(sizes) > 1:
        return None
    if load.torque is None and load.radius is None:
        return None
    arm = 1.0 if load.torque is not None or load.radius is None else load.radius.si
    torque = -next(iter(sizes)).si * arm
    return abs(torque) if load.sense == "resisting" else torque


def _first(value: Array) -> float:
    """The number of a machine that is no column of designs."""
    return float(np.ravel(value)[0])


def _written(value: Array | float, unit: str) -> str:
    """Write an SI number so that it is read again as the same."""
    return f"{float(np.ravel(value)[0])!r} {unit}"
