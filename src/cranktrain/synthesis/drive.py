"""A drive for a machine: the smallest typical motor that is enough, with the ratio that keeps the crank's speed."""

import math
from collections.abc import Iterator
from typing import Annotated, Literal, NamedTuple

import numpy as np

from cranktrain.analysis.parts import refuse_wrong
from cranktrain.analysis.run import run
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import N_, _
from cranktrain.machine import Machine
from cranktrain.quantities import unlisted
from cranktrain.questions.drive.choosing_ratio import nearest_ratio, preferred_ratios
from cranktrain.questions.drive.motor_checks import SIZING_CHECKS
from cranktrain.questions.drive.motor_sizing import MotorSizing
from cranktrain.questions.drive.motors.catalogue import four_pole_motors
from cranktrain.questions.drive.spec import DriveSpec
from cranktrain.questions.drive.steady_drive import SteadyDrive
from cranktrain.record import record
from cranktrain.spec import words_of
from cranktrain.synthesis.proposal import Alternative, MachineProposal, Number, found, quantity_text
from cranktrain.wording import number

Ratio = Literal["preferred", "exact"]

_SYMBOLS = ("u_M", "u_max", "u_A", "u_t", "u_z", "u_J", "u_n")
_NAMES = ("effective", "peak", "worst_start", "start_time", "starts", "inertia", "speed")
_QUANTITIES = ("largest_share", "mean_motor_speed")
_TURNS = 3
"""Of the exact ratio: the motor's slip moves by little with it."""
_NEAR = 1.3
"""How far from the wanted one preferred ratios are looked for."""


@record
class _Tried:
    """A motor of the range with a ratio of the stage, and what is found of it.

    Attributes
    ----------
    place : int
        In the range of typical motors.
    ratio, overall : float
        Of the stage, and of all stages. [1]
    machine : Machine
    shares : tuple of float
        As `SIZING_CHECKS`; NaN of what is not asked for.
    speed : float
        Mean of the crank in steady running; NaN without it. [rad/s]
    """

    place: int
    ratio: float
    overall: float
    machine: Machine
    shares: tuple[float, ...]
    speed: float

    @property
    def largest(self) -> float:
        """Largest share; infinite where it does not run."""
        return float(np.nanmax(self.shares)) if np.isfinite(self.speed) else math.inf

    @property
    def governing(self) -> str:
        """Name of the check that governs."""
        return _(SIZING_CHECKS[int(np.nanargmax(self.shares))])

    @property
    def power(self) -> float:
        """Rated. [W]"""
        return float(four_pole_motors().power[self.place])


class _Asked(NamedTuple):
    """What is asked: the machine, its crank's speed, which stage is to change, the ratio of the others."""

    machine: Machine
    speed: float
    stage: int
    others: float
    ratio: Ratio


def drive(
    machine: Machine,
    ratio: Annotated[Ratio, N_("Preferred numbers, unless it is to keep the crank's speed exactly.")] = "preferred",
) -> MachineProposal:
    """Propose a typical four-pole motor for a machine, and the ratio of its largest stage.

    Parameters
    ----------
    machine : Machine
        With [drive], a stage, loads, and the speed that its crank shall have.
    ratio : str
        `preferred`, the number of the series R20 that comes nearest, or `exact`.

    Returns
    -------
    MachineProposal
        With `power`, `ratio`, `overall_ratio`, `speed`, `off`, and the share of every check that is asked for. The
        alternatives are the next smaller motor and the next larger one, and the ratios beside.

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
    asked = _asked(machine, ratio)
    chosen = _smallest(asked)
    others = {place: _tried(asked, place) for place in (chosen.place - 1, chosen.place + 1) if _is_there(place)}
    ratios = [_with_ratio(asked, chosen.place, beside) for beside in _beside(chosen.ratio)] if ratio != "exact" else []
    label = _("{power}, ratio {ratio}")
    tried = [*others.values(), *ratios]
    return MachineProposal(
        title=_title(machine),
        numbers=tuple(_numbers(asked, chosen, chosen)),
        alternatives=tuple(
            Alternative(
                label.format(power=number(one.power, "kW"), ratio=number(one.ratio, "1")),
                tuple(_numbers(asked, one, chosen)),
            )
            for one in sorted(tried, key=lambda one: (one.place, one.ratio))
        ),
        remarks=tuple(_remarks(asked, chosen, others.get(chosen.place - 1))),
        tables=(),
        machine=chosen.machine,
        values=_values(asked, chosen),
        whole=("drive.motor",),
    )


def _asked(machine: Machine, ratio: Ratio) -> _Asked:
    """Find what is asked; refuse a machine that lacks something."""
    spec: DriveSpec | None = machine.drive
    shaft = machine.shaft.get("main")
    problems: list[Problem] = []
    if spec is None or not spec.stage:
        allowed = _("is missing: a ratio is that of a stage; [[drive.stage]] ratio = 1 would do")
        problems.append(Problem("drive.stage", None, allowed))
    if shaft is not None and shaft.motion is not None:
        allowed = _("must not stand here: typical motors turn at one speed, and do not follow a wanted motion")
        problems.append(Problem("shaft.main.motion", None, allowed))
    elif shaft is None or shaft.speed is None:
        problems.append(Problem("shaft.main.speed", None, _("is missing: the speed that the crank shall have")))
    refuse(problems)
    assert spec is not None and shaft is not None and shaft.speed is not None
    ratios = [stage.ratio.si for stage in spec.stage]
    stage = int(np.argmax(ratios))
    return _Asked(machine, shaft.speed.si, stage, math.prod(ratios) / ratios[stage], ratio)


def _is_there(place: int) -> bool:
    """Whether the range has such a motor."""
    return 0 <= place < len(four_pole_motors().power)


def _smallest(asked: _Asked) -> _Tried:
    """The smallest motor that passes all checks; larger ones may fail others, as starts an hour."""
    best: _Tried | None = None
    for place in range(len(four_pole_motors().power)):
        trial = _tried(asked, place)
        if trial.largest <= 1:
            return trial
        best = trial if best is None or trial.largest < best.largest else best
    assert best is not None
    if not np.isfinite(best.largest):
        raise InputError([Problem("drive", None, _("no typical motor carries the machine through its cycle"))])
    said = _("no typical motor is enough: {power}, which comes nearest, is used to {share}: {check}")
    words = {"power": number(best.power, "kW"), "share": number(best.largest, "%")}
    raise InputError([Problem("drive", None, said.format(**words, check=best.governing))])


def _tried(asked: _Asked, place: int) -> _Tried:
    """A motor with the ratio that suits it."""
    exact = float(four_pole_motors().values.rated_speed[place]) / asked.speed / asked.others
    if asked.ratio == "preferred":
        near = preferred_ratios(exact / _NEAR, exact * _NEAR)
        return _with_ratio(asked, place, float(nearest_ratio(np.asarray(exact), near).ratio))
    made = _with_ratio(asked, place, exact)
    for _turn in range(_TURNS):
        if np.isfinite(made.speed):
            made = _with_ratio(asked, place, made.ratio * made.speed / asked.speed)
    return made


def _beside(ratio: float) -> tuple[float, ...]:
    """Preferred ratios below and above one of them."""
    near = preferred_ratios(ratio / _NEAR, ratio * _NEAR)
    at = int(np.argmin(np.abs(near - ratio)))
    return float(near[at - 1]), float(near[at + 1])


def _with_ratio(asked: _Asked, place: int, ratio: float) -> _Tried:
    """Run the machine with a motor and a ratio."""
    power = quantity_text(float(four_pole_motors().power[place]), "kW")
    motor = {"kind": "cage", "size": power}
    changed = asked.machine.with_({"drive.motor": motor, f"drive.stage[{asked.stage}].ratio": ratio})
    result = run(changed, quantities=_QUANTITIES)
    if needs := result.needs_of(*_QUANTITIES):
        raise InputError(
            [Problem("drive", None, _("cannot be sized: needs {needs}").format(needs=_(" and ").join(needs)))]
        )
    sizing, overall = result[MotorSizing], ratio * asked.others
    speed = float(result[SteadyDrive].mean_motor_speed[0]) / overall
    return _Tried(place, ratio, overall, changed, tuple(sizing.sizing_share[0, 0].tolist()), speed)


def _values(asked: _Asked, chosen: _Tried) -> dict[str, str]:
    """What the machine's file says otherwise."""
    size = found(chosen.power, "kW", _("the smallest typical motor that is enough"))
    note = _("keeps {speed} at the crank").format(speed=number(asked.speed, "rpm"))
    ratio = f'{{ value = {chosen.ratio!r}, status = "derived", note = "{note}" }}'
    return {"drive.motor.kind": '"cage"', "drive.motor.size": size, f"drive.stage[{asked.stage}].ratio": ratio}


def _title(machine: Machine) -> str:
    """Whose drive."""
    return _("{machine}: drive").format(machine=machine.name) if machine.name else _("Drive")


def _numbers(asked: _Asked, one: _Tried, chosen: _Tried) -> Iterator[Number]:
    """Motor and ratio, and the shares of the checks that are asked for of the chosen one."""
    yield Number("power", "P_n", one.power, "kW", _("Rated power of a typical four-pole motor"))
    yield Number("ratio", "i", one.ratio, "1", _("Ratio of stage {n}").format(n=asked.stage + 1))
    yield Number("overall_ratio", "i_Σ", one.overall, "1", _("Ratio of all stages"))
    yield Number("speed", "n", one.speed, "rpm", _("Mean speed of the crank in steady running"))
    yield Number("off", "Δn", one.speed / asked.speed - 1, "%", _("Off the speed that it shall have"))
    for name, symbol, check, share, own in zip(_NAMES, _SYMBOLS, SIZING_CHECKS, one.shares, chosen.shares, strict=True):
        if not np.isnan(own):
            yield Number(name, symbol, share, "%", _("Used: {check}").format(check=_(check)))


def _remarks(asked: _Asked, chosen: _Tried, smaller: _Tried | None) -> Iterator[str]:
    """Say what governs, how far the next smaller motor misses, and what typical values are."""
    words = {"power": number(chosen.power, "kW"), "share": number(chosen.largest, "%")}
    yield _("What governs {power} is: {check}, {share}.").format(check=chosen.governing, **words)
    if smaller is not None and np.isfinite(smaller.largest):
        by = number(smaller.largest - 1, "%")
        said = _("{power} misses by {by}: {check}.")
        yield said.format(power=number(smaller.power, "kW"), by=by, check=smaller.governing)
    elif smaller is not None:
        yield _("{power} does not carry the machine through its cycle.").format(power=number(smaller.power, "kW"))
    yield _("Values of typical motors are nobody's: a maker's replace them before a motor is bought.")
    if asked.machine.drive is not None and asked.machine.drive.duty is None:
        yield _("Without [drive.duty] it runs on and on, and starts and voltage are not checked.")
