"""A drive for a machine: the smallest typical motor that is enough, with its ratio, and a flywheel if one is sought."""

import math
from typing import Annotated

import numpy as np

from cranktrain.analysis.parts import refuse_wrong
from cranktrain.declared_types import words_of
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import N_, Words, _
from cranktrain.layout.drive.table import DriveSpec
from cranktrain.machine import Machine
from cranktrain.motors.cage.catalogue import four_pole_motors
from cranktrain.numerics.ties import smallest_of
from cranktrain.quantities import Dimension, Quantity, unlisted
from cranktrain.saying.wording import number
from cranktrain.synthesis.changed_stage import largest_stage, without_stage
from cranktrain.synthesis.drive_trials import (
    AskedDrive,
    Bench,
    Ratio,
    Trial,
    bench_for,
    every_trial,
    part_named,
    ratios_beside,
    sought_flywheel,
    with_ratio,
)
from cranktrain.synthesis.drive_words import alternatives, numbers, remarks
from cranktrain.synthesis.proposal import MachineProposal, found, found_ratio
from cranktrain.synthesis.servo_ratio import servo_ratio
from cranktrain.synthesis.sized_motor import KeptSlip, declared_slip, motor_table, motor_values

_TOLERANCE = 0.05
_START = "drive.duty.start"
_LARGER = 5
"""So many sizes above the chosen one are shown at most, where a flywheel is sought."""

Inertia = Annotated[float | None, Quantity(Dimension.INERTIA, above=0.0)]
Slip = Annotated[float | None, Quantity(Dimension.RATIO, above=0.0, at_most=0.25, example="8 %")]
Tolerance = Annotated[float, Quantity(Dimension.RATIO, at_least=0.0, at_most=0.25, example="5 %")]


def drive(
    machine: Machine,
    ratio: Annotated[Ratio, N_("Preferred numbers, unless it is to keep the crank's speed exactly.")] = "preferred",
    speed_tolerance: Annotated[
        Tolerance, N_("On the crank's speed: preferred numbers within are tried; 5 % unless given.")
    ] = _TOLERANCE,
    flywheel: Annotated[str | None, N_("Name of the part of [drive.part] that is sought as a flywheel.")] = None,
    flywheel_inertia_max: Annotated[Inertia, N_("Largest one of that part; any unless given.")] = None,
    slip: Annotated[Slip, N_("At the rated torque; that of the declared motor unless given.")] = None,
    unloaded_start: Annotated[bool, N_("The machine starts before its loads act.")] = False,
) -> MachineProposal:
    """Propose a typical four-pole motor for a machine, the ratio of its largest stage, and a flywheel if one is sought.

    Parameters
    ----------
    machine : Machine
        With [drive], a stage, loads, and the speed that its crank shall have; or with a wanted motion, then the ratio
        alone is sought, of a servo motor.
    ratio : str
        `preferred`, the number of the series R20 that comes nearest, or `exact`.
    speed_tolerance : float
        Other preferred numbers are tried too that keep the crank's speed within it.
    flywheel : str, optional
        Part of the drive whose inertia is sought: for each motor the least with which it can do the work.
    flywheel_inertia_max : float, optional
        Of that part; a motor that needs more is not enough. [kg·m²]
    slip : float, optional
        Of the motors at their rated torque: by a resistance behind slip rings where the declared motor has them, else
        by the bars of the cage. That of the declared motor where it is not an ordinary one, unless given.
    unloaded_start : bool
        Check starts against weights and drags alone, and put `start = "unloaded"` in [drive.duty].

    Returns
    -------
    MachineProposal
        With `power`, `slip`, `ratio`, `overall_ratio`, `speed`, `off`, `flywheel` where it is sought, and the share of
        every check that is asked for. The alternatives are all sizes that carry the machine, up to one above the chosen
        one, and the ratios beside.

    Raises
    ------
    InputError
        Where something is missing, or no motor of the range is enough.

    Notes
    -----
    Every motor is checked as `run` checks the declared one, over its own steady cycle at its own speed.
    docs/theory/drive, section Sizing of a declared machine.
    """
    refuse([] if ratio in words_of(Ratio) else [unlisted("ratio", ratio, words_of(Ratio))])
    refuse_wrong((machine,))
    shaft = machine.shaft.get("main")
    if shaft is not None and shaft.motion is not None:
        refuse(_beside_motion(flywheel=flywheel, flywheel_inertia_max=flywheel_inertia_max, slip=slip))
        return servo_ratio(machine, ratio)
    starting: dict[str, object] = {_START: "unloaded"} if unloaded_start else {}
    asked = _asked(machine.with_(starting), ratio, speed_tolerance)
    refuse(_flywheel_problems(machine, flywheel, flywheel_inertia_max))
    most = math.inf if flywheel_inertia_max is None else flywheel_inertia_max
    kept = declared_slip(machine)
    bench = bench_for(
        asked._replace(
            kept=kept if slip is None else KeptSlip(kept.is_wound, slip),
            flywheel=None if flywheel is None else sought_flywheel(machine, flywheel, most),
        )
    )
    return _proposal(bench, dict.fromkeys(starting, '"unloaded"'))


def _proposal(bench: Bench, values: dict[str, Words]) -> MachineProposal:
    """Choose, and say what was tried; the file says what was asked otherwise than it did."""
    asked = bench.asked
    sizes, chosen = _sizes(bench)
    beside = () if asked.ratio == "exact" else ratios_beside(chosen.ratio)
    ratios = [with_ratio(bench, chosen.place, one) for one in beside]
    values |= _values(asked, chosen)
    return MachineProposal(
        title=_("{machine}: drive", machine=asked.machine.name) if asked.machine.name else _("Drive"),
        numbers=tuple(numbers(asked, chosen, chosen)),
        alternatives=tuple(alternatives(asked, chosen, sizes, ratios)),
        remarks=tuple(remarks(bench, chosen, sizes)),
        tables=(),
        machine=_driven(asked, chosen),
        values=values,
        whole=("drive.motor", *([f"drive.part.{asked.flywheel.name}"] if asked.flywheel is not None else [])),
    )


def _asked(machine: Machine, ratio: Ratio, tolerance: float) -> AskedDrive:
    """Find what is asked; refuse a machine that lacks something."""
    spec: DriveSpec | None = machine.drive
    shaft = machine.shaft.get("main")
    problems = list(without_stage(spec))
    if shaft is None or shaft.speed is None:
        problems.append(Problem("shaft.main.speed", None, _("is missing: the speed that the crank shall have")))
    refuse(problems)
    assert spec is not None and shaft is not None and shaft.speed is not None
    ratios = [stage.ratio.si for stage in spec.stage]
    stage = largest_stage(spec)
    return AskedDrive(
        machine,
        shaft.speed.si,
        stage,
        math.prod(ratios) / ratios[stage],
        ratio,
        tolerance,
        KeptSlip(),
        flywheel=None,
    )


def _flywheel_problems(machine: Machine, name: str | None, most: float | None) -> list[Problem]:
    """Find a flywheel that is no part of the drive, and a largest one of none."""
    spec: DriveSpec | None = machine.drive
    names = [] if spec is None else list(spec.part)
    if name is None:
        allowed = _("needs flywheel, the name of the part that is sought")
        return [] if most is None else [Problem("flywheel_inertia_max", number(most, "kg·m²"), allowed)]
    if name in names:
        return []
    if not names:
        allowed = _('is no part of the drive; [drive.part.flywheel] on = "motor", inertia = "1 kg*m^2" would be one')
        return [Problem("flywheel", name, allowed)]
    return [unlisted("flywheel", name, names)]


def _beside_motion(**options: float | str | None) -> list[Problem]:
    """Find options that say nothing of a servo motor."""
    allowed = _("must not be given: the motor of a wanted motion has no slip, and a flywheel would be in its way")
    return [Problem(name, str(given), allowed) for name, given in options.items() if given is not None]


def _sizes(bench: Bench) -> tuple[list[Trial], Trial]:
    """Sizes from the smallest that bears the load's mean to one above the chosen one, and the chosen one.

    Where a flywheel is sought larger ones follow, to the first that needs none. Larger motors may fail what smaller
    ones pass, as starts an hour: the first that passes is chosen.
    """
    sizes: list[Trial] = []
    chosen: Trial | None = None
    for one in every_trial(bench):
        sizes.append(one)
        if chosen is None:
            chosen = one if one.largest <= 1 else None
        elif bench.asked.flywheel is None or one.flywheel == 0 or one.place - chosen.place >= _LARGER:
            break
    if chosen is None:
        raise InputError([Problem("drive", None, _none_is_enough(sizes))])
    return sizes, chosen


def _none_is_enough(sizes: list[Trial]) -> Words:
    """Say which motor comes nearest."""
    best = smallest_of(sizes, lambda one: one.largest) if sizes else None
    if best is None or not np.isfinite(best.largest):
        return _("no typical motor carries the machine through its cycle")
    said = _("no typical motor is enough: {power}, which comes nearest, is used to {share}: {check}")
    return said.format(power=number(best.power, "kW"), share=number(best.largest, "%"), check=best.governing)


def _driven(asked: AskedDrive, chosen: Trial) -> Machine:
    """The machine with what is proposed."""
    values: dict[str, object] = {
        "drive.motor": motor_table(chosen.place, asked.kept),
        f"drive.stage[{asked.stage}].ratio": chosen.ratio,
    }
    if asked.flywheel is not None:
        on = part_named(asked.machine, asked.flywheel.name).on
        values[f"drive.part.{asked.flywheel.name}"] = {"on": on, "inertia": f"{chosen.flywheel!r} kg·m²"}
    return asked.machine.with_(values)


def _values(asked: AskedDrive, chosen: Trial) -> dict[str, Words]:
    """What the machine's file says otherwise."""
    motor = motor_values(chosen.place, asked.kept, _("the smallest typical motor that is enough"))
    note = _("keeps {speed} at the crank", speed=number(asked.speed, "rpm"))
    values = {f"drive.motor.{key}": text for key, text in motor.items()}
    values[f"drive.stage[{asked.stage}].ratio"] = found_ratio(chosen.ratio, note)
    if asked.flywheel is not None:
        power = number(float(four_pole_motors().power[chosen.place]), "kW")
        on = part_named(asked.machine, asked.flywheel.name).on
        path = f"drive.part.{asked.flywheel.name}"
        said = _("the least with which {power} is enough", power=power)
        values[f"{path}.on"] = f'"{on}"' if isinstance(on, str) else str(on)
        values[f"{path}.inertia"] = found(chosen.flywheel, "kg·m²", said)
    return values
