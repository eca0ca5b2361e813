"""Trials of motors, ratios and flywheels for a machine: each is checked over its own steady cycle and start."""

import math
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any, Literal, NamedTuple

import numpy as np

from cranktrain.analysis.grids import FACTS_STEP
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.run import run
from cranktrain.errors import InputError, Problem
from cranktrain.language import Words, _
from cranktrain.layout.drive.declared import DeclaredClutch, DeclaredDrive
from cranktrain.layout.drive.shafts import shaft_number
from cranktrain.layout.drive.table import DriveSpec, PartSpec
from cranktrain.machine import Machine
from cranktrain.motors import DeclaredMotor
from cranktrain.motors.cage.catalogue import four_pole_motors
from cranktrain.numerics.ties import first_largest, first_smallest, largest_first
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.questions.reduction.static_torques import StaticTorques
from cranktrain.questions.sizing.choosing_ratio import nearest_ratio, preferred_ratios
from cranktrain.questions.sizing.motor_checks import CHECK_TITLES, CheckedMotor, check_keys, checked_motor
from cranktrain.questions.sizing.motor_sizing import SizedDesign, sized_design
from cranktrain.questions.sizing.parts import DeclaredDuty
from cranktrain.record import record
from cranktrain.saying.labels import titled
from cranktrain.saying.wording import all_of
from cranktrain.synthesis.sized_motor import KeptSlip, motor_table, slip_of_size
from cranktrain.transient.gearing import Gearing, with_inertia

Ratio = Literal["preferred", "exact"]

_QUANTITIES = ("mean_static_torque", "driven_inertia")
_TURNS = 3
"""Of the exact ratio: the motor's slip moves by little with it."""
_NEAR = 1.3
"""How far from the wanted one preferred ratios are looked for, besides the tolerance."""
_N_ANGLES = 2001


class SoughtFlywheel(NamedTuple):
    """A part of the drive whose inertia is sought: its name, shaft (0 the motor's), and the largest one [kg·m²]."""

    name: str
    shaft: int
    most: float


class AskedDrive(NamedTuple):
    """What is asked of a drive.

    Attributes
    ----------
    machine : Machine
    speed : float
        Of the crank. [rad/s]
    stage : int
        Which one's ratio is to change.
    others : float
        Ratio of the other stages together. [1]
    ratio : str
    tolerance : float
        On the speed, in parts of it, of preferred ratios.
    kept : KeptSlip
    flywheel : SoughtFlywheel or None
    """

    machine: Machine
    speed: float
    stage: int
    others: float
    ratio: Ratio
    tolerance: float
    kept: KeptSlip
    flywheel: SoughtFlywheel | None


@record
class Trial:
    """A motor of the range with a ratio and a flywheel, and what is found of it.

    Attributes
    ----------
    place : int
        In the range of typical motors.
    ratio, overall : float
        Of the stage, and of all stages. [1]
    slip : float
        At the motor's rated torque. [1]
    flywheel : float
        Of the part that is sought; NaN where none is. [kg·m²]
    shares : tuple of float
        As `SIZING_CHECKS`; NaN of what is not asked for.
    checks : tuple of str
        What these are called.
    speed : float
        Mean of the crank in steady running; NaN without it. [rad/s]
    checked : CheckedMotor
    """

    place: int
    ratio: float
    overall: float
    slip: float
    flywheel: float
    shares: tuple[float, ...]
    checks: tuple[str, ...]
    speed: float
    checked: CheckedMotor

    @property
    def largest(self) -> float:
        """Largest share; infinite where it does not run."""
        return float(np.nanmax(self.shares)) if np.isfinite(self.speed) else math.inf

    @property
    def of_cycle(self) -> float:
        """Larger share of those that a flywheel lessens, effective and largest torque."""
        return max(self.shares[:2]) if np.isfinite(self.speed) else math.inf

    @property
    def governing(self) -> Words:
        """What people call the check that governs."""
        return titled(CHECK_TITLES, self.checks[first_largest(self.shares)])

    @property
    def power(self) -> float:
        """Rated. [W]"""
        return float(four_pole_motors().power[self.place])

    @property
    def fluctuation(self) -> float:
        """Coefficient of fluctuation of the crank's speed; NaN where it does not run. [1]"""
        cycle = self.checked.cycle
        if cycle is None:
            return math.nan
        turned = float(np.sum(cycle.mesh.width))
        return float(np.ptp(cycle.at(np.linspace(0, turned, _N_ANGLES)))) * cycle.period / turned


@record
class Bench:
    """Where motors are tried: what is asked, the machine behind each ratio, and each motor of the range."""

    asked: AskedDrive
    behind: Callable[[float], "Behind"]
    motor: Callable[[int], DeclaredMotor]


class Behind(NamedTuple):
    """A machine behind one ratio, without the flywheel that is sought."""

    gearing: Gearing
    machines: ReducedMachines
    static: StaticTorques
    motor: DeclaredMotor
    duty: DeclaredDuty
    clutch: DeclaredClutch | None

    @property
    def mean_torque(self) -> float:
        """Mean static torque at the motor, which no flywheel lessens. [N·m]"""
        return float(self.static.mean_static_torque[0, 0])


def bench_for(asked: AskedDrive) -> Bench:
    """Set up the trials for what is asked."""

    @cache
    def behind(ratio: float) -> Behind:
        return _behind(asked, ratio)

    @cache
    def motor(place: int) -> DeclaredMotor:
        changed = asked.machine.with_({"drive.motor": motor_table(place, asked.kept)})
        parts: Any = parts_of((changed,), step=FACTS_STEP)
        return parts[DeclaredMotor]

    return Bench(asked, behind, motor)


def _behind(asked: AskedDrive, ratio: float) -> Behind:
    """Reduce the machine and its loads behind a ratio; a motor of any size stands for all."""
    changed = asked.machine.with_(
        {"drive.motor": motor_table(0, KeptSlip()), f"drive.stage[{asked.stage}].ratio": ratio}
    )
    if asked.flywheel is not None:
        on = part_named(changed, asked.flywheel.name).on
        changed = changed.with_({f"drive.part.{asked.flywheel.name}": {"on": on, "inertia": "0 kg·m²"}})
    result = run(changed, quantities=_QUANTITIES)
    if needs := result.needs_of(*_QUANTITIES):
        raise InputError([Problem("drive", None, _("cannot be sized: needs {needs}", needs=all_of(needs)))])
    parts: Any = parts_of((changed,), step=FACTS_STEP)
    drive, clutch = parts[DeclaredDrive], parts.get(DeclaredClutch)
    motor, duty = parts[DeclaredMotor], parts[DeclaredDuty]
    return Behind(drive.gearings[0], result[ReducedMachines], result[StaticTorques], motor, duty, clutch)


def sought_flywheel(machine: Machine, name: str, most: float) -> SoughtFlywheel:
    """Find the part by its name; it must be there."""
    return SoughtFlywheel(name, shaft_number(part_named(machine, name).on), most)


def part_named(machine: Machine, name: str) -> PartSpec:
    """A part of the drive; it must be there."""
    drive: DriveSpec | None = machine.drive
    assert drive is not None
    return drive.part[name]


def carries_mean(bench: Bench, place: int) -> bool:
    """Whether a motor bears the mean torque of the load for long: with less no flywheel helps it.

    The root mean square of a torque is never less than its mean.
    """
    behind = bench.behind(ratios_for(bench.asked, exact_ratio(bench.asked, place))[0])
    able = float(behind.duty.factor[0]) * float(four_pole_motors().values.rated_torque[place])
    return behind.mean_torque <= able


def exact_ratio(asked: AskedDrive, place: int) -> float:
    """Ratio of the stage with which a motor turns the crank at its speed, while it gives its rated torque. [1]"""
    rated = float(four_pole_motors().values.synchronous_speed[place]) * (1 - slip_of_size(place, asked.kept))
    return rated / asked.speed / asked.others


def ratios_for(asked: AskedDrive, exact: float) -> tuple[float, ...]:
    """Ratios to try: preferred ones that keep the speed within the tolerance, the nearest first and always."""
    reach = _NEAR * (1 + asked.tolerance)
    near = preferred_ratios(exact / reach, exact * reach)
    nearest = float(nearest_ratio(np.asarray(exact), near).ratio)
    within = [one for one in near.tolist() if abs(exact / one - 1) <= asked.tolerance and one != nearest]
    return (nearest, *largest_first(within, lambda one: -abs(math.log(one / exact))))


def ratios_beside(ratio: float) -> tuple[float, float]:
    """Preferred ratios below and above one of them."""
    near = preferred_ratios(ratio / _NEAR, ratio * _NEAR)
    at = first_smallest(np.abs(near - ratio))
    return float(near[at - 1]), float(near[at + 1])


def tried(bench: Bench, place: int) -> Trial:
    """A motor with the ratio that suits it: of those that do, the nearest to the wanted speed; else the least short."""
    asked, exact = bench.asked, exact_ratio(bench.asked, place)
    if asked.ratio == "exact":
        return _kept_speed(bench, place, exact)
    first = with_ratio(bench, place, ratios_for(asked, exact)[0])
    if np.isfinite(first.speed):  # a motor that is far from its rated torque slips otherwise
        exact = first.ratio * first.speed / asked.speed
    best: Trial | None = None
    for ratio in ratios_for(asked, exact):
        one = first if ratio == first.ratio else with_ratio(bench, place, ratio)
        if one.largest <= 1:
            return one
        best = one if best is None or one.largest < best.largest else best
    assert best is not None
    return best


def _kept_speed(bench: Bench, place: int, ratio: float) -> Trial:
    """A motor with the ratio that keeps the crank's speed."""
    made = with_ratio(bench, place, ratio)
    for _turn in range(_TURNS):
        if np.isfinite(made.speed):
            made = with_ratio(bench, place, made.ratio * made.speed / bench.asked.speed)
    return made


def with_ratio(bench: Bench, place: int, ratio: float) -> Trial:
    """A motor behind a ratio, with the flywheel that it needs where one is sought."""
    if bench.asked.flywheel is None:
        return _checked(bench, place, ratio, math.nan)
    return _with_least_flywheel(bench, place, ratio, bench.asked.flywheel)


def _with_least_flywheel(bench: Bench, place: int, ratio: float, sought: SoughtFlywheel) -> Trial:
    """The least flywheel with which effective and largest torque are within; at the largest one where none is.

    Bisection of the logarithm; found to 2 % above, and rounded up to three figures.
    """
    without = _checked(bench, place, ratio, 0.0)
    high = sought.most if math.isfinite(sought.most) else _plenty(bench.behind(ratio), sought.shaft)
    best = _checked(bench, place, ratio, high) if without.of_cycle > 1 else without
    if without.of_cycle <= 1 or best.of_cycle > 1:
        return best
    low = high / _WIDEST
    while high / low > _FINE:
        middle = _rounded_up(math.sqrt(low * high))
        if middle >= high:
            break
        one = _checked(bench, place, ratio, middle)
        if one.of_cycle <= 1:
            high, best = middle, one
        else:
            low = middle
    return best


_WIDEST = 1e6
"""Largest flywheel that is looked at over the smallest."""
_FINE = 1.02
_PLENTY = 1e4
"""Times what turns with the machine: above it no flywheel is looked for."""


def _plenty(behind: Behind, shaft: int) -> float:
    """Inertia above which no flywheel is looked for, on its shaft. [kg·m²]"""
    here = float(behind.static.driven_inertia[0, shaft].mean())
    return _rounded_up(_PLENTY * here)


def _rounded_up(value: float) -> float:
    """Three figures, none less."""
    step = 10.0 ** (math.floor(math.log10(value)) - 2)
    return float(f"{math.ceil(value / step * (1 - 1e-12)) * step:.3g}")


def _checked(bench: Bench, place: int, ratio: float, inertia: float) -> Trial:
    """Check a motor behind a ratio, with an inertia of the flywheel that is sought."""
    asked = bench.asked
    one = design_of(bench, ratio, inertia)
    found = checked_motor(one.with_motor(bench.motor(place), 0), one.asked, one.duty, one.design)
    overall = ratio * asked.others
    speed = math.nan if found.cycle is None else float(np.sum(found.cycle.mesh.width)) / found.cycle.period
    slip = slip_of_size(place, asked.kept)
    checks = check_keys(one.duty, has_clutch=bench.behind(ratio).clutch is not None)
    return Trial(place, ratio, overall, slip, inertia, tuple(found.shares.tolist()), checks, speed, found)


def design_of(bench: Bench, ratio: float, inertia: float) -> SizedDesign:
    """The machine behind a ratio, with an inertia of the flywheel that is sought; NaN is none."""
    behind, sought = bench.behind(ratio), bench.asked.flywheel
    gearing = behind.gearing if sought is None else with_inertia(behind.gearing, sought.shaft, inertia)
    return sized_design(
        0, gearing, behind.machines, behind.static, motor=behind.motor, duty=behind.duty, clutch=behind.clutch
    )


def every_trial(bench: Bench) -> Iterator[Trial]:
    """Motors of the range by rising power; where a flywheel is sought, from the first that bears the mean load."""
    for place in range(len(four_pole_motors().power)):
        if bench.asked.flywheel is None or carries_mean(bench, place):
            yield tried(bench, place)
