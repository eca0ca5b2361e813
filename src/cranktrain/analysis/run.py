"""From a machine to its result: layout, then every stage that the machine allows."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import lru_cache
from functools import partial as with_arguments
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from cranktrain.analysis.grids import FACTS_STEP, has_curves, on_grid
from cranktrain.analysis.outcomes import Finding, Outcomes, StageRun
from cranktrain.analysis.parts import parts_of, refuse_wrong
from cranktrain.analysis.result import Result
from cranktrain.analysis.stages import (
    KEPT,
    Step,
    every_stage,
    homes,
    lacking,
    leading_to,
    missing_results,
    stages_for,
    stages_giving,
    stages_of,
    steps_of,
)
from cranktrain.errors import InputError, Problem
from cranktrain.how_far import within
from cranktrain.language import Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.question import Parts, Stage
from cranktrain.layout.speed import SpeedCurve, SpeedWanted
from cranktrain.machine import Machine

if TYPE_CHECKING:
    from cranktrain.analysis.kept_outcomes import KeptOutcomes

_FINEST, _COARSEST = 0.01, 90.0
_BY_DESIGN = 2
"""Axes of a speed of one's own that differs among designs."""
_ONE_STEP = 1e-12
"""Steps that differ by less are one. [rad]"""
_LARGE = 2**24
"""A block of memory as large as all arrays of a run. [B]"""

# Glibc gives what a run frees back to the system, and has each page of it mapped and cleared again by the next run, a
# tenth of its time, until a block was freed that is large; no page of this one is ever used.
np.empty(_LARGE, dtype=np.uint8)


def run(
    machine: Machine | Sequence[Machine],
    *,
    speed: SpeedWanted = "constant",
    step_degrees: float = 1.0,
    partial: bool = False,
    quantities: str | Iterable[str] | None = None,
    stages: Sequence[Stage] | None = None,
) -> Result:
    """Compute all that a machine file allows.

    Parameters
    ----------
    machine : Machine, or a sequence of machines
        Several designs of one machine give a leading dimension `design`.
    speed : "constant", "running", array-like of shape (crank_angle,) or (design, crank_angle), or SpeedCurve
        At which everything is computed: the declared one all round; that of steady running, which a first run finds and
        a second is at; one's own at the crank angles of the grid; or what `speed_over_cycle` gave. [rad/s]
    step_degrees : float
        Of the crank angles at which curves stand; the cycle must be a whole number of steps. Facts do not depend on it.
        [deg]
    partial : bool
        Compute where the links close and give NaN where they do not, instead of refusing the machine.
    quantities : str or iterable of str, optional
        Names from the catalogue; only the stages that these need are run. All unless given.
    stages : sequence of Stage
        Those of what the machine's file asks unless given.

    Returns
    -------
    Result

    Raises
    ------
    InputError
        With everything that is wrong with the machine, the speed, the step or the names.

    Examples
    --------
    >>> result = run(Machine(mechanism={"kind": "slider_crank", "stroke": "80 mm", "rod_length": "136 mm"}))
    >>> result.stroke
    array([0.08])
    """
    machines = (machine,) if isinstance(machine, Machine) else tuple(machine)
    if not machines:
        raise InputError([Problem("", None, _("there must be at least one machine"))])
    step = _step(step_degrees)
    refuse_wrong(machines, partial=partial)
    asked = (quantities,) if isinstance(quantities, str) else quantities
    names = None if asked is None else tuple(asked)
    steps = _steps(machines[0].asks, machines[0].kinds, None if stages is None else tuple(stages), names)
    if isinstance(machine, Machine) or isinstance(speed, SpeedCurve):
        return _run(machines, speed, step, steps, has_designs=not isinstance(machine, Machine))
    from cranktrain.analysis.blocks import MOST_AT_ONCE, block_sizes, is_kept, joined

    if len(machines) <= MOST_AT_ONCE:
        return _run(machines, speed, step, steps, has_designs=True)
    sizes = block_sizes(len(machines))
    ends = np.cumsum(sizes).tolist()
    own = np.asarray(speed)
    blocks: list[Result] = []
    found: list[list[object]] = []
    coarse: list[Words] = []
    for start, end in zip([0, *ends], ends, strict=False):
        of_block = own[start:end] if own.ndim == _BY_DESIGN else speed
        with within(with_arguments(_designs, start + 1, end, len(machines))):
            block = _run(machines[start:end], of_block, step, steps, has_designs=True)
            found.append([block.computed[kind] for kind in block.computed.kinds if is_kept(kind, names)])
            coarse += block.computed.coarse
            # Of all that a block has found, no more is kept.
            blocks.append(replace(block, computed=Outcomes({}, dict(block.computed.known))))
    given: dict[type, object] = {type(parts[0]): joined(parts, sizes) for parts in zip(*found, strict=True)}
    labels = {**blocks[0].labels, "design": _numbered(machines)}
    return replace(blocks[0], machines=machines, computed=Outcomes(given, labels, coarse=tuple(dict.fromkeys(coarse))))


class _Steps(NamedTuple):
    """Stages of a run: all that there may be, with what is known of others; those that are run; and those told of."""

    every: tuple[Stage, ...]
    known: tuple[Step, ...]
    chosen: tuple[Stage, ...]
    told: tuple[Step, ...]


@lru_cache(maxsize=KEPT)
def _steps(
    questions: tuple[str, ...],
    kinds: tuple[str, ...],
    stages: tuple[Stage, ...] | None,
    names: tuple[str, ...] | None,
) -> _Steps:
    """Choose the stages that lead to some quantities, or to all that questions ask of mechanisms of some kinds."""
    if stages is None:
        every, known = stages_of(questions, kinds), steps_of(questions, kinds)
        if names is None:
            return _Steps(every, known, every, known)
        if not homes(every).keys() >= set(names):
            every = known = every_stage()
    else:
        every = known = stages
    chosen = every if names is None else _needed(every, names)
    return _Steps(every, known, chosen, chosen)


def _designs(first: int, last: int, n_designs: int) -> Words:
    """Which of many designs are worked on."""
    return _("designs {first} to {last} of {n}", first=first, last=last, n=n_designs)


def _run(
    machines: tuple[Machine, ...],
    speed: SpeedWanted,
    step: float,
    steps: _Steps,
    *,
    has_designs: bool,
) -> Result:
    """Compute all designs at once."""
    parts = _at_speed(parts_of(machines, step=FACTS_STEP), speed, steps.every, step)
    absent = lacking(steps.known, parts)
    chosen = [one for one in steps.chosen if one.outcome not in absent]
    kept = None if has_designs else _kept(machines[0])
    facts = curves = StageRun(chosen, parts, kept)
    # Curves want points as close as facts, or closer: of these a coarser step takes some.
    n_between = int(np.ceil(step / FACTS_STEP - _ONE_STEP))
    if abs(step / n_between - FACTS_STEP) > _ONE_STEP:
        drawn = leading_to(chosen, [one.gives for one in chosen if has_curves(one.gives)])
        curves = StageRun(drawn, on_grid(parts, step / n_between))
    grid: Any = on_grid(parts, step)[CrankAngle]
    outcomes = Outcomes(
        {SpeedCurve: parts[SpeedCurve]} if SpeedCurve in parts else {},
        {"design": _numbered(machines), **facts.labels},
        Finding([one.gives for one in chosen], facts, curves, n_between, grid.shown),
    )
    outcomes.find(one.gives for one in chosen if one.refuses)
    return Result(
        machines=machines,
        has_designs=has_designs,
        grid=grid,
        computed=outcomes,
        missing=missing_results(steps.told, absent),
        lacking=absent,
    )


def _kept(machine: Machine) -> "KeptOutcomes | None":
    """Give what stages gave of machines from which one comes by `with_`; None where it comes from none."""
    if "alike" not in vars(machine):
        return None
    from cranktrain.analysis.kept_outcomes import KeptOutcomes  # most machines are run as they are

    return machine.alike.setdefault(KeptOutcomes, KeptOutcomes())


def speed_over_cycle(machine: Machine, speed: SpeedWanted) -> SpeedCurve | None:
    """How a machine's shaft turns, at any crank angle.

    Parameters
    ----------
    machine : Machine
    speed : "constant", "running", array-like of shape (crank_angle,), or SpeedCurve
        As `run` takes it, on a grid in steps of 1°.

    Returns
    -------
    SpeedCurve or None
        None for a constant speed, unless the file itself says how the shaft turns.

    Raises
    ------
    InputError
        Where the file does not say what the running speed needs, there is none, or the speeds given are none.
    """
    if isinstance(speed, SpeedCurve):
        return speed
    if isinstance(speed, str) and speed == "constant" and not machine.main_shaft.turns_unevenly:
        return None
    refuse_wrong((machine,))
    declared = parts_of((machine,), step=FACTS_STEP)
    parts: dict[type, Any] = _at_speed(declared, speed, stages_for(machine), FACTS_STEP)
    return parts[SpeedCurve]


def _at_speed(parts: Parts, speed: SpeedWanted, stages: Sequence[Stage], step: float) -> Parts:
    """Put the speed that is wanted into the parts."""
    if isinstance(speed, str) and speed == "constant":
        return parts
    from cranktrain.analysis.second_run import with_speed  # most runs are at the declared speed

    return with_speed(parts, speed, stages, step)


def _step(degrees: float) -> float:
    """Step in radians, if it divides a turn."""
    if _FINEST <= degrees <= _COARSEST:
        n_steps = 360 / degrees
        if abs(n_steps - round(n_steps)) < 1e-9 * n_steps:
            return 2 * np.pi / round(n_steps)
    allowed = _("must be from {least} to {most} degrees, a whole number of which make a turn")
    raise InputError([Problem("step", f"{degrees:g} deg", allowed.format(least=_FINEST, most=f"{_COARSEST:g}"))])


def _needed(stages: Sequence[Stage], names: Sequence[str]) -> tuple[Stage, ...]:
    """Those stages that the named quantities need, in order, and those that take what there is."""
    needed = leading_to(stages, [one.gives for one in stages_giving(stages, names, "quantities")])
    # What needs nothing, as flags on masses, takes what there is.
    return tuple(one for one in stages if one in needed or set(one.needs) <= set(one.optional))


def _numbered(machines: Sequence[Machine]) -> tuple[str, ...]:
    """Names of designs."""
    return tuple(str(i + 1) for i in range(len(machines)))
