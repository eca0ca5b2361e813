"""The declared machine: the domains' tables together, and what only they together can check."""

import re
from collections.abc import Mapping, Sequence
from typing import Any, Literal, cast

import numpy as np
from pydantic import Field, ValidationError, model_validator

from cranktrain.engine.cylinders import (
    CYCLES,
    chambers_of,
    compression_ratios_of,
    cylinder_problems,
    cylinders_of,
    firing_order_of,
)
from cranktrain.engine.layout import CrankAngle, Mechanisms, Pistons, Rockers, Speed, mechanisms_of
from cranktrain.engine.places import Place, places_of
from cranktrain.engine.points import link_points_of, point_problems
from cranktrain.engine.rockers import LoadRadius
from cranktrain.engine.specs import BankSpec, CylindersSpec, ShaftsSpec
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.mechanisms import AnyMechanism
from cranktrain.mechanisms.closing import open_ranges
from cranktrain.mechanisms.crank_rocker import CrankRockerSpec
from cranktrain.quantities import Angle, Given
from cranktrain.spec import Spec, problems
from cranktrain.wording import number

Parts = dict[type, object]
"""What a machine declares, in SI: one object of each type; stages ask for them by type."""


class Machine(Spec, frozen=True):
    """A machine as its file declares it, with units and provenance.

    Raises
    ------
    InputError
        With everything that is wrong, each with its path in the machine file.

    Examples
    --------
    >>> machine = Machine(
    ...     mechanism={"kind": "slider_crank", "stroke": "80 mm", "rod_length": "136 mm"},
    ...     shaft={"main": {"speed": "5200 rpm"}},
    ... )
    >>> machine.mechanism.rod_length.si
    0.136
    """

    name: str = ""
    rotation: Literal["clockwise", "anticlockwise"] = "clockwise"
    running: Literal["ahead", "astern"] = "ahead"
    crank_zero: Angle = Given(0.0, "0 deg")
    angle: Angle = Given(0.0, "0 deg")
    shaft: ShaftsSpec = ShaftsSpec()
    mechanism: AnyMechanism | None = None
    bank: Mapping[str, BankSpec] = Field(default={})
    cylinder: CylindersSpec = CylindersSpec()

    def __init__(self, **data: Any) -> None:
        try:
            super().__init__(**data)
        except ValidationError as error:
            raise InputError(_as_in_file(problem, data) for problem in problems(error, Machine)) from None

    @model_validator(mode="after")
    def _has_a_mechanism(self) -> "Machine":
        """Refuse a machine with no mechanism, or with one beside its banks."""
        if self.mechanism is not None and self.bank:
            allowed = _("must not stand beside [bank]; give the mechanism of each bank in [bank.NAME.mechanism]")
            raise InputError([Problem("mechanism", None, allowed)])
        if self.mechanism is None and not self.bank:
            allowed = _("is missing; a machine needs a [mechanism], or banks with [bank.NAME.mechanism]")
            raise InputError([Problem("mechanism", None, allowed)])
        return self

    @property
    def is_astern(self) -> bool:
        """Whether it runs against its normal sense of rotation."""
        return self.running == "astern"

    @property
    def places(self) -> tuple[Place, ...]:
        """Every mechanism of the machine, arranged on shaft and banks; none where they cannot be arranged."""
        return _arranged(self)[0]


def _as_in_file(problem: Problem, data: Mapping[str, Any]) -> Problem:
    """Give a problem the path that the file has: one value where a list was made of it, overrides as tables."""
    path = problem.path.replace("cylinder.overrides.", "cylinder.")
    found = re.fullmatch(r"(bank\.[^.]+\.mechanism)\[(\d+)\](?:\.([^.\[]+)(.*))?", path)
    if found is not None:
        table, index, field, rest = found.groups(default="")
        value = _at(data, f"{table}.{field}") if field else None
        item = f"[{index}]" if isinstance(value, list) else ""
        path = f"{table}.{field}{item}{rest}" if field else table
    elif (single := re.fullmatch(r"(.*)\[0\]", path)) is not None and not isinstance(
        _at(data, single[1]), list | tuple
    ):
        path = single[1]
    return Problem(path, problem.given, problem.allowed, problem.repair, problem.position)


def _at(data: object, path: str) -> object:
    """What stands at a plain dotted path; None where nothing does."""
    for name in path.split("."):
        data = cast(Mapping[str, object], data).get(name) if isinstance(data, Mapping) else None
    return data


def _arranged(machine: Machine) -> tuple[tuple[Place, ...], tuple[Problem, ...]]:
    """Arrange the mechanisms; a bare `[mechanism]` is a bank of one."""
    if machine.mechanism is None:
        return places_of(machine.shaft.main, machine.bank, astern=machine.is_astern)
    bank = BankSpec.model_construct(
        angle=(machine.angle,), mechanism=(machine.mechanism,), throws=(1,), stagger=Given(0.0, "0 mm")
    )
    return places_of(machine.shaft.main, {"": bank}, astern=machine.is_astern, prefix="")


def machine_problems(machine: Machine, *, partial: bool = False) -> tuple[Problem, ...]:
    """Find what only the whole machine can show to be wrong.

    Parameters
    ----------
    machine : Machine
    partial : bool
        Accept links that cannot close over the whole turn.

    Returns
    -------
    tuple of Problem
    """
    places, found = _arranged(machine)
    if found:
        return found
    pistons = [place for place in places if place.kind.output == "slider"]
    found = (*point_problems(places), *cylinder_problems(machine.cylinder, pistons))
    if pistons:
        found = (*found, *firing_order_of(machine.cylinder, pistons, astern=machine.is_astern)[1])
    return found if partial else (*found, *_closing_problems(machine, places))


def _closing_problems(machine: Machine, places: Sequence[Place]) -> tuple[Problem, ...]:
    """Say over which crank angles a mechanism cannot close, once for each geometry."""
    found: list[Problem] = []
    zero = machine.crank_zero.si * (-1.0 if machine.is_astern else 1.0)
    for place in {(place.path, place.geometry): place for place in places}.values():
        ranges = open_ranges(place.kind.gap, place.geometry)
        if not ranges:
            continue
        angles = _(" and ").join(
            _("{start} to {end}").format(
                start=number(float(np.mod(one.start - place.phase - zero, 2 * np.pi)), "deg"),
                end=number(float(np.mod(one.end - place.phase - zero, 2 * np.pi)), "deg"),
            )
            for one in ranges
        )
        short = max(one.short for one in ranges)
        never = ranges[0].end - ranges[0].start >= 2 * np.pi
        allowed = (
            _("the links can close at no crank angle (short by {short})")
            if never
            else _("the links cannot close at crank angles {angles} (short by {short})")
        ).format(angles=angles, short=number(short, "mm"))
        allowed = f"{allowed}; {place.kind.closing_advice(place.geometry)}"
        given = getattr(place.spec, "rod_length", None)
        found.append(Problem(f"{place.path}.rod_length", given.text if given else None, allowed))
    return tuple(found)


def layout(machines: Sequence[Machine], *, step: float, partial: bool = False) -> Parts:
    """Lay out designs of one machine as SI arrays with a leading design axis.

    Parameters
    ----------
    machines : sequence of Machine
        The same mechanisms in the same places; only numbers differ.
    step : float
        Of the crank-angle grid, a whole part of the cycle. [rad]
    partial : bool
        Accept links that cannot close over the whole turn: NaN there.

    Returns
    -------
    Parts
        By type: `CrankAngle`, `Mechanisms`, `Pistons`, `Rockers`, each kind's members, `Speed`, `Chambers`, …; what
        the machines do not declare is left out.

    Raises
    ------
    InputError
    """
    found = [problem for machine in machines for problem in machine_problems(machine, partial=partial)]
    if found:
        raise InputError(dict.fromkeys(found))
    designs = [machine.places for machine in machines]
    _refuse_different(designs)
    first = machines[0]
    astern = first.is_astern
    cycle = CYCLES[first.cylinder.cycle] if first.cylinder.cycle else 2 * np.pi
    sense = -1.0 if astern else 1.0
    zero = np.array([[[sense * machine.crank_zero.si]] for machine in machines])
    grid = np.arange(round(cycle / step), dtype=np.float64) * step
    mechanisms = mechanisms_of(Mechanisms, designs)
    parts: list[object] = [CrankAngle(grid, zero, cycle), mechanisms]
    parts += [*(group.members for group in mechanisms.groups), link_points_of(designs, astern=astern)]
    pistons = _with_output(designs, "slider")
    rockers = _with_output(designs, "rocker")
    if pistons[0]:
        cylinders = [cylinders_of(machine.cylinder, some) for machine, some in zip(machines, pistons, strict=True)]
        parts += [
            mechanisms_of(Pistons, pistons),
            chambers_of(cylinders),
            compression_ratios_of(cylinders),
            firing_order_of(first.cylinder, pistons[0], astern=astern)[0],
        ]
    if rockers[0]:
        parts += [mechanisms_of(Rockers, rockers), _load_radius(rockers)]
    speeds = [machine.shaft.main.speed for machine in machines]
    if all(speed is not None for speed in speeds):
        parts.append(Speed(np.array([[[speed.si]] for speed in speeds if speed is not None])))
    return {type(part): part for part in parts if part is not None}


def _refuse_different(designs: Sequence[Sequence[Place]]) -> None:
    """Refuse designs that differ in more than numbers."""
    shapes = [tuple((place.name, place.bank, place.kind.name) for place in design) for design in designs]
    for number_, shape in enumerate(shapes[1:], start=2):
        if shape != shapes[0]:
            allowed = _("design {number} must have the same mechanisms in the same places as the first")
            raise InputError([Problem("", None, allowed.format(number=number_))])


def _with_output(designs: Sequence[Sequence[Place]], output: str) -> list[list[Place]]:
    """Those places whose mechanism drives a slider, or a rocker."""
    return [[place for place in design if place.kind.output == output] for design in designs]


def _load_radius(designs: Sequence[Sequence[Place]]) -> LoadRadius | None:
    """Load radius of every rocker; None unless all have one."""
    radii = [
        [
            [place.spec.load_radius.si]
            for place in design
            if isinstance(place.spec, CrankRockerSpec) and place.spec.load_radius
        ]
        for design in designs
    ]
    complete = all(len(found) == len(design) for found, design in zip(radii, designs, strict=True))
    return LoadRadius(np.array(radii)) if complete else None
