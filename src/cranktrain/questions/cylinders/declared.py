"""Cylinders: bores, compression ratios and firing order of the file, put to the pistons of a layout."""

import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.layout.places import Place
from cranktrain.motion import Array
from cranktrain.questions.cylinders.firing import FiringOrder, firing_angles, within_turn
from cranktrain.questions.cylinders.given_firing import given_firing
from cranktrain.questions.cylinders.ports import Ports
from cranktrain.questions.cylinders.spec import CylinderSpec, CylindersSpec
from cranktrain.questions.cylinders.travel import CylinderPistons
from cranktrain.questions.cylinders.volumes import Chambers, CompressionRatios
from cranktrain.record import record
from cranktrain.wording import number

CYCLES = {"two-stroke": 2 * np.pi, "four-stroke": 4 * np.pi}
"""Length of a cycle by name. [rad]"""


@record
class Cylinder:
    """One cylinder: what its own table, its bank's or the common one gives, the nearest first.

    Attributes
    ----------
    name, bank : str
    pistons : tuple of int
        Which of the pistons work in it: one, or the exhaust and the scavenge piston.
    signs : tuple of float
        Of each of them: +1 where room grows as the piston moves toward its shaft, −1 of one with side rods.
    spec : CylinderSpec
    paths : mapping of str to str
        Where in the machine file each field that is given stands.
    is_master : bool
        Whether its pistons hang on crank pins themselves.
    """

    name: str
    bank: str
    pistons: tuple[int, ...]
    signs: tuple[float, ...]
    spec: CylinderSpec
    paths: Mapping[str, str]
    is_master: bool

    @property
    def has_own_ratio(self) -> bool:
        """Whether a table of its own or of its bank gives the compression ratio."""
        return self.paths.get("compression_ratio", _COMMON_RATIO) != _COMMON_RATIO

    @property
    def chambers(self) -> tuple[str, ...]:
        """Sides of the piston on which there is a chamber."""
        return self.spec.chambers or ("head",)


_COMMON_RATIO = "cylinder.compression_ratio"


def cylinders_of(common: CylindersSpec, pistons: Sequence[Place]) -> tuple[Cylinder, ...]:
    """Give every cylinder its pistons and its dimensions; a valve has none."""
    members: dict[str, list[int]] = {}
    for i, place in enumerate(pistons):
        if place.kind.has_chambers:
            members.setdefault(place.cylinder, []).append(i)
    return tuple(_cylinder(common, pistons, tuple(index)) for index in members.values())


def _cylinder(common: CylindersSpec, pistons: Sequence[Place], index: tuple[int, ...]) -> Cylinder:
    """Take each field from the nearest table that gives it."""
    places = [pistons[i] for i in index]
    name, bank = places[0].cylinder, places[0].bank
    tables: list[tuple[str, CylinderSpec]] = [
        (f"cylinder.{key}", common.overrides[key]) for key in (name, bank) if key in common.overrides
    ]
    fields: dict[str, Any] = {}
    paths: dict[str, str] = {}
    for path, table in (*tables, ("cylinder", common)):
        for field in CylinderSpec.model_fields:
            value = getattr(table, field)
            if value is not None and field not in fields:
                fields[field], paths[field] = value, f"{path}.{field}"
    return Cylinder(
        name=name,
        bank=bank,
        pistons=index,
        signs=tuple(-1.0 if place.is_far else 1.0 for place in places),
        spec=CylinderSpec.model_construct(**fields),
        paths=paths,
        is_master=all(place.kind.name == "slider_crank" for place in places),
    )


def cylinder_problems(
    common: CylindersSpec, pistons: Sequence[Place], cylinders: Sequence[Cylinder]
) -> tuple[Problem, ...]:
    """Find cylinders and overrides of nothing, bores given for some pistons only, piston rods that do not fit."""
    pistons = [place for place in pistons if place.kind.has_chambers]
    if not pistons:
        allowed = _("is not for this machine, which has no pistons")
        return (Problem("cylinder", None, allowed),) if common.model_fields_set else ()
    known = dict.fromkeys([name for place in pistons for name in (place.bank, place.cylinder) if name])
    allowed = _("is neither a key of [cylinder] nor a bank or cylinder of this machine: {known}")
    problems = [
        Problem(f"cylinder.{name}", None, allowed.format(known=", ".join(known)))
        for name in common.overrides
        if name not in known
    ]
    without = [cylinder.name for cylinder in cylinders if cylinder.spec.bore is None]
    if without and len(without) < len(cylinders):
        allowed = _("is missing for {cylinders}, while others have one").format(cylinders=", ".join(without))
        problems.append(Problem("cylinder.bore", None, allowed))
    for cylinder in cylinders:
        bore, rod = cylinder.spec.bore, cylinder.spec.piston_rod
        if bore is not None and rod is not None and rod.si >= bore.si:
            allowed = _("must be less than the bore, {bore}").format(bore=bore.text)
            problems.append(Problem(cylinder.paths["piston_rod"], rod.text, allowed))
        if len(cylinder.pistons) > 1 and cylinder.chambers != ("head",):
            allowed = _("must be left out for opposed pistons, which have one chamber between them")
            problems.append(Problem(cylinder.paths["chambers"], None, allowed))
    return tuple(dict.fromkeys(problems))


def cylinder_pistons_of(cylinders: Sequence[Cylinder]) -> CylinderPistons | None:
    """Say which pistons work in which cylinder, and in which sense; None where there are valves alone."""
    if not cylinders:
        return None
    return CylinderPistons(
        names=tuple(cylinder.name for cylinder in cylinders),
        index=np.array([[cylinder.pistons[0], cylinder.pistons[-1]] for cylinder in cylinders], dtype=np.intp),
        signs=np.array([(*cylinder.signs, 0.0)[:2] for cylinder in cylinders]),
    )


def chambers_of(designs: Sequence[Sequence[Cylinder]], n_pistons: int) -> Chambers | None:
    """Signed area matrix of the working chambers; None where no bore is given."""
    first = designs[0]
    if not first or any(cylinder.spec.bore is None for design in designs for cylinder in design):
        return None
    sides = [(i, side) for i, cylinder in enumerate(first) for side in cylinder.chambers]
    areas = np.zeros((len(designs), n_pistons, len(sides)))
    for d, design in enumerate(designs):
        for column, (i, side) in enumerate(sides):
            cylinder = design[i]
            areas[d, list(cylinder.pistons), column] = _signed_area(cylinder.spec, side) * np.array(cylinder.signs)
    return Chambers(
        names=tuple(
            first[i].name if len(first[i].chambers) == 1 and side == "head" else f"{first[i].name}.{side}"
            for i, side in sides
        ),
        banks=tuple(first[i].bank for i, _side in sides),
        cylinder=np.array([i for i, _side in sides], dtype=np.intp),
        is_head=np.array([side == "head" for _i, side in sides]),
        areas=areas,
    )


def _signed_area(spec: CylinderSpec, side: str) -> float:
    """Area by which a chamber grows as a near piston moves toward the shaft. [m²]"""
    assert spec.bore is not None  # looked at before
    full = np.pi / 4 * spec.bore.si**2
    return full if side == "head" else -(full - (np.pi / 4 * spec.piston_rod.si**2 if spec.piston_rod else 0.0))


def compression_ratios_of(designs: Sequence[Sequence[Cylinder]]) -> CompressionRatios | None:
    """Compression ratio of every chamber that has one of its own; None where the leading piston has none.

    The common ratio is the first master's; the heads of the other cylinders share its deck and chamber.
    """
    first = designs[0]
    sides = [(i, side) for i, cylinder in enumerate(first) for side in cylinder.chambers]
    heads = [(k, i) for k, (i, side) in enumerate(sides) if side == "head"]
    leader, leading = next(
        ((k, i) for k, i in heads if first[i].is_master), heads[0] if heads else (0, sides[0][0] if sides else 0)
    )
    if not sides or any(design[leading].spec.compression_ratio is None for design in designs):
        return None
    value = np.full((len(designs), len(sides)), np.nan)
    for d, design in enumerate(designs):
        for column, (i, side) in enumerate(sides):
            ratio = design[i].spec.compression_ratio
            if ratio is not None and (i == leading or side == "crank" or design[i].has_own_ratio):
                value[d, column] = ratio.si
    leaders = [leader if side == "head" else column for column, (_i, side) in enumerate(sides)]
    return CompressionRatios(value, np.array(leaders, dtype=np.intp))


def ports_of(designs: Sequence[Sequence[Cylinder]]) -> Ports | None:
    """Heights of the ports; None where any cylinder lacks one of the two."""
    if not designs[0] or any(
        cylinder.spec.exhaust_port is None or cylinder.spec.scavenge_port is None
        for design in designs
        for cylinder in design
    ):
        return None
    return Ports(
        piston=np.array([[cylinder.pistons[0], cylinder.pistons[-1]] for cylinder in designs[0]], dtype=np.intp),
        height=np.array(
            [
                [
                    [port.si for port in (cylinder.spec.exhaust_port, cylinder.spec.scavenge_port) if port is not None]
                    for cylinder in design
                ]
                for design in designs
            ]
        ),
    )


def firing_order_of(
    common: CylindersSpec, leading: Sequence[Place], *, zero: float, astern: bool
) -> tuple[FiringOrder | None, tuple[Problem, ...]]:
    """Read the firing order of cylinders, each by its leading piston, or their firing angles; None without either.

    zero is φ where the shown crank angle is 0 [rad]. Running astern the order is read backwards from the same cylinder.
    Whether the crank pins allow it can be told where the cycle is known, too.
    """
    names = [place.cylinder for place in leading]
    problems = _number_problems(common, names)
    if common.firing_angles is not None and common.cycle is not None and not problems:
        return given_firing(common, leading, CYCLES[common.cycle], zero=zero, astern=astern)
    if common.firing_order is None or problems:
        own = _own_order(common, leading) if not problems else None
        return own, problems
    order = [common.numbers.get(word, word) for word in re.split(r"[\s,–-]+", common.firing_order.strip()) if word]
    problems = _order_problems(common, order, names)
    if problems:
        return None, problems
    if astern:
        order = [order[0], *order[:0:-1]]
    index = [names.index(name) for name in order]
    problems = _throw_problems(common, order, within_turn(np.array([leading[i].nominal_top for i in index])))
    by_cylinder = {name: word for word, name in common.numbers.items()}
    numbers = tuple(by_cylinder.get(name, name) for name in order) if by_cylinder else ()
    return (None if problems else FiringOrder(np.array(index, dtype=np.intp), numbers)), problems


def _own_order(common: CylindersSpec, leading: Sequence[Place]) -> FiringOrder | None:
    """Order in which cylinders fire that have no choice: one alone, and those of a two-stroke as their cranks come."""
    if not leading or (len(leading) > 1 and common.cycle != "two-stroke"):
        return None
    tops = within_turn(np.array([place.nominal_top for place in leading]))
    return FiringOrder(np.argsort(tops, kind="stable"))


def _number_problems(common: CylindersSpec, names: Sequence[str]) -> tuple[Problem, ...]:
    """Find a maker's numbers for no cylinder, or two for one."""
    problems: list[Problem] = []
    numbered: dict[str, str] = {}
    for word, name in common.numbers.items():
        allowed = None
        if name not in names:
            allowed = _("must be a cylinder of this machine: {cylinders}").format(cylinders=", ".join(names))
        elif name in numbered:
            allowed = _("must be another cylinder: this one is number {number}").format(number=numbered[name])
        if allowed is not None:
            problems.append(Problem(f"cylinder.numbers.{word}", name, allowed))
        numbered.setdefault(name, word)
    return tuple(problems)


def _order_problems(common: CylindersSpec, order: Sequence[str], names: Sequence[str]) -> tuple[Problem, ...]:
    """Find cylinders that the order does not name once."""
    unknown = [name for name in order if name not in names]
    twice = sorted({name for name in order if order.count(name) > 1})
    left_out = [name for name in names if name not in order]
    wrong = [
        text.format(names=", ".join(those))
        for text, those in (
            (_("unknown: {names}"), unknown),
            (_("twice: {names}"), twice),
            (_("left out: {names}"), left_out),
        )
        if those
    ]
    if not wrong:
        return ()
    allowed = _("must name each cylinder once ({cylinders}); {wrong}").format(
        cylinders=", ".join(names), wrong="; ".join(wrong)
    )
    return (Problem("cylinder.firing_order", common.firing_order, allowed),)


def _throw_problems(common: CylindersSpec, order: Sequence[str], tops: Array) -> tuple[Problem, ...]:
    """Find an order in which the crank pins do not bring the pistons to their tops."""
    if common.cycle is None or firing_angles(tops, CYCLES[common.cycle]) is not None:
        return ()
    turns = [2 * np.pi * turn for turn in range(round(CYCLES[common.cycle] / (2 * np.pi)))]
    possible = ", ".join(
        f"{name} {_(' or ').join(number(float(top + turn), 'deg') for turn in turns)}"
        for name, top in zip(order, tops, strict=True)
    )
    allowed = _("cannot fire so: as the crank pins stand, the pistons are at their tops at {possible}")
    return (Problem("cylinder.firing_order", common.firing_order, allowed.format(possible=possible)),)
