"""The ratio between a servo motor and a crank that follows a wanted motion: that of the least rms torque."""

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from cranktrain.analysis.grids import FACTS_STEP
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.run import run
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import N_, Words, _
from cranktrain.layout.drive.declared import DeclaredDrive
from cranktrain.layout.drive.table import DriveSpec
from cranktrain.machine import Machine
from cranktrain.motors import DeclaredMotor
from cranktrain.numerics.roots import bracketed_roots
from cranktrain.numerics.ties import first_largest, first_smallest, smallest_of
from cranktrain.questions.servo.demand import ServoDemand
from cranktrain.questions.servo.rocking import RockingDrive
from cranktrain.questions.servo.stages import ServoDrive
from cranktrain.questions.sizing.choosing_ratio import preferred_ratios
from cranktrain.saying.wording import all_of, number
from cranktrain.synthesis.changed_stage import largest_stage, without_stage
from cranktrain.synthesis.proposal import Alternative, MachineProposal, Number, found_ratio
from cranktrain.transient.gearing import Gearing, overall_ratio

_QUANTITIES = ("servo_rms_torque", "rocking_rms_torque")
_CHECKS = (N_("effective torque"), N_("largest torque or power"), N_("speed"))
_NAMES = (("effective", "u_M"), ("peak_share", "u_max"), ("speed_share", "u_n"))
_WIDEST = 1000.0
"""Ratios are looked for so far above and below that of the file."""
_BESIDE = 4
"""So many preferred numbers are shown above and below the chosen one."""
_N_FINE = 2001
_ASIDE = 2e-4
"""Between two logarithms of ratios behind which the torque is the same: the least is midway, as it grows alike to both
sides. Of torques so near the least themselves no ratio would come out closer than 1e-8."""
_WITHIN = 1 - 1e-9
"""For rounding."""


class _Servo(NamedTuple):
    """The demand of a wanted motion, the gearing whose stage is to change, and the motor where it is declared."""

    machine: Machine
    demand: ServoDemand
    gearing: Gearing
    stage: int
    motor: DeclaredMotor | None


class _Behind(NamedTuple):
    """What a motor does behind a ratio; shares, in the order of `_CHECKS`, are NaN where its limits are not known."""

    ratio: float
    overall: float
    rms: float
    peak: float
    speed: float
    power: float
    shares: tuple[float, ...]

    @property
    def largest(self) -> float:
        """Largest share; 0 where none is known."""
        return max((share for share in self.shares if not math.isnan(share)), default=0.0)

    @property
    def governing(self) -> Words:
        """Name of the check that governs."""
        return _(_CHECKS[first_largest(self.shares)])


def servo_ratio(machine: Machine, ratio: str) -> MachineProposal:
    """Propose the ratio of the largest stage for a machine with a wanted motion.

    Parameters
    ----------
    machine : Machine
        With nothing wrong; with [shaft.main.motion], [drive], a stage, and the inertia of the rotor.
    ratio : str
        `preferred`, a number of the series R20, or `exact`.

    Returns
    -------
    MachineProposal
        With `ratio`, `best_ratio`, `overall_ratio`, `rms`, `peak`, `peak_speed`, `peak_power`, and the shares of what a
        declared servo motor can do.

    Raises
    ------
    InputError
        Where something is missing, or the declared motor is not enough behind any ratio.

    Notes
    -----
    docs/theory/drive, eqs. (25.20), (25.29) and (25.41). The torque is that which `run` gives at the file's own ratio.
    """
    case = _case(machine)
    own = float(case.gearing.ratio[case.stage])
    best = _least_rms(case, own)
    near = [_at(case, one) for one in preferred_ratios(own / _WIDEST, own * _WIDEST).tolist()]
    tried = near if ratio == "preferred" else [best, *(_at(case, one) for one in _fine(own, best))]
    passing = [one for one in tried if one.largest <= 1]
    if not passing:
        raise InputError([Problem("drive.motor", None, _not_enough(smallest_of(tried, lambda one: one.largest)))])
    chosen = smallest_of(passing, lambda one: one.rms)
    note = _("the least effective torque of the motor")
    return MachineProposal(
        title=_("{machine}: drive", machine=machine.name) if machine.name else _("Drive"),
        numbers=tuple(_numbers(case, chosen, best)),
        alternatives=tuple(_alternatives(case, chosen, near, own)),
        remarks=tuple(_remarks(case, chosen, best, near)),
        tables=(),
        machine=machine.with_({f"drive.stage[{case.stage}].ratio": chosen.ratio}),
        values={f"drive.stage[{case.stage}].ratio": found_ratio(chosen.ratio, note)},
    )


def _case(machine: Machine) -> _Servo:
    """Run the machine for what its crank asks; refuse one that lacks something."""
    spec: DriveSpec | None = machine.drive
    refuse(without_stage(spec))
    assert spec is not None
    parts: Any = parts_of((machine,), step=FACTS_STEP)
    gearing, motor = parts[DeclaredDrive].gearings[0], parts.get(DeclaredMotor)
    problems: list[Problem] = []
    if motor is not None and not motor.law.is_commanded:
        allowed = _('must be kind = "servo": only such a motor follows a wanted motion')
        problems.append(Problem("drive.motor.kind", spec.motor.kind if spec.motor else None, allowed))
    elif not gearing.motor_inertia > 0:
        allowed = _(
            "has no inertia at the motor: the rotor's decides on the ratio; give it in [drive.motor], or in"
            ' [drive.part.rotor] on = "motor"'
        )
        problems.append(Problem("drive", None, allowed))
    refuse(problems)
    return _Servo(machine, _demand(machine), gearing, largest_stage(spec), motor)


def _demand(machine: Machine) -> ServoDemand:
    """What the crank asks, whichever way it moves."""
    result = run(machine, quantities=_QUANTITIES)
    turning, rocking = result.get(ServoDrive), result.get(RockingDrive)
    if turning is not None:
        return turning.demands[0]
    if rocking is not None:
        return rocking.demands[0]
    needs = all_of(result.needs_of(*_QUANTITIES))
    raise InputError([Problem("drive", None, _("cannot be sized: needs {needs}", needs=needs))])


def _at(case: _Servo, ratio: float) -> _Behind:
    """What the motor does behind a ratio."""
    ratios = np.where(np.arange(case.gearing.ratio.size) == case.stage, ratio, case.gearing.ratio)
    gearing = case.gearing._replace(ratio=ratios)
    demand = case.demand.behind(gearing)
    speed = demand.top_speed
    return _Behind(
        ratio,
        float(overall_ratio(gearing)),
        demand.rms,
        demand.peak_torque,
        speed,
        demand.peak_power,
        _shares(case.motor, demand, speed),
    )


def _shares(motor: DeclaredMotor | None, demand: ServoDemand, speed: float) -> tuple[float, ...]:
    """What is asked of a declared motor over what it can do; NaN where it does not say."""
    if motor is None:
        return (math.nan,) * len(_CHECKS)
    rated, top = float(motor.rating.torque[0]), float(motor.top_speed[0])
    at_once = demand.peak_share(motor.ceiling(demand.motor_speed, 0))
    return demand.rms / rated, at_once, speed / top if math.isfinite(top) else math.nan


def _fine(own: float, best: _Behind) -> list[float]:
    """Ratios close together, for limits that leave out the best one; among them that of the largest speed."""
    fine: list[float] = np.geomspace(own / _WIDEST, own * _WIDEST, _N_FINE).tolist()
    return fine if math.isnan(best.shares[-1]) else [best.ratio / best.shares[-1] * _WITHIN, *fine]


def _least_rms(case: _Servo, own: float) -> _Behind:
    """The ratio of the least rms torque, whatever the motor bears."""
    half = 0.5 * _ASIDE

    def growth(logarithm: float) -> float:
        return _at(case, math.exp(logarithm + half)).rms - _at(case, math.exp(logarithm - half)).rms

    low, high = math.log(own / _WIDEST), math.log(own * _WIDEST)
    if growth(low) >= 0 or growth(high) <= 0:
        return _at(case, math.exp(low if growth(low) >= 0 else high))
    found = bracketed_roots(np.vectorize(growth, otypes=[float]), np.array([low]), np.array([high]))
    return _at(case, math.exp(float(found[0])))


def _not_enough(best: _Behind) -> Words:
    """Say by how much the declared motor misses."""
    said = _("is not enough behind any ratio: behind {ratio}, which comes nearest, it is used to {share}: {check}")
    return said.format(ratio=number(best.ratio, "1"), share=number(best.largest, "%"), check=best.governing)


def _numbers(case: _Servo, one: _Behind, best: _Behind | None = None) -> Iterator[Number]:
    """Ratio and what the motor does behind it."""
    yield Number("ratio", "i", one.ratio, "1", _("Ratio of stage {n}", n=case.stage + 1))
    if best is not None:
        yield Number("best_ratio", "i_opt", best.ratio, "1", _("That of the least effective torque"))
        yield Number("overall_ratio", "i_Σ", one.overall, "1", _("Ratio of all stages"))
    yield Number("rms", "M_rms", one.rms, "N·m", _("Effective torque of the motor, rests counted"))
    yield Number("peak", "M_max", one.peak, "N·m", _("Largest torque of the motor"))
    yield Number("peak_speed", "n_max", one.speed, "rpm", _("Largest speed of the motor"))
    yield Number("peak_power", "P_max", one.power, "kW", _("Largest power of the motor, driving or braking"))
    for (name, symbol), check, share in zip(_NAMES, _CHECKS, one.shares, strict=True):
        if not math.isnan(share):
            yield Number(name, symbol, share, "%", _("Used: {check}", check=_(check)))


def _alternatives(case: _Servo, chosen: _Behind, near: list[_Behind], own: float) -> Iterator[Alternative]:
    """Preferred ratios below and above, and that of the file."""
    place = first_smallest([abs(math.log(one.ratio / chosen.ratio)) for one in near])
    for one in near[max(place - _BESIDE, 0) : place + _BESIDE + 1]:
        if one.ratio != chosen.ratio:
            label = _("enough") if one.largest <= 1 else _("misses by {by}", by=number(one.largest - 1, "%"))
            yield Alternative(_("ratio beside") if case.motor is None else label, tuple(_numbers(case, one)))
    yield Alternative(_("as the file has it"), tuple(_numbers(case, _at(case, own))))


def _remarks(case: _Servo, chosen: _Behind, best: _Behind, near: list[_Behind]) -> Iterator[Words]:
    """Say what the ratio costs, and what governs."""
    more = number(chosen.rms / best.rms - 1, "%")
    yield _(
        "The least effective torque is {rms}, behind {ratio}; behind {chosen} it is more by {more}.",
        rms=number(best.rms, "N·m"),
        ratio=number(best.ratio, "1"),
        chosen=number(chosen.ratio, "1"),
        more=more,
    )
    if case.motor is None:
        yield _('Without [drive.motor] kind = "servo" its limits are not known: the effective torque alone decides.')
        return
    yield _("What governs the motor is: {check}, {share}.", check=chosen.governing, share=number(chosen.largest, "%"))
    better = [one for one in near if one.rms < chosen.rms and one.largest > 1]
    if better:
        one = smallest_of(better, lambda each: each.rms)
        said = _("Behind {ratio} it would have less effective torque, and misses by {by}: {check}.")
        yield said.format(ratio=number(one.ratio, "1"), by=number(one.largest - 1, "%"), check=one.governing)
