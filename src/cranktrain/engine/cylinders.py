"""Cylinders: bores, compression ratios and firing order of the file, put to the pistons of a layout."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cranktrain.engine.firing import FiringOrder, firing_angles
from cranktrain.engine.places import Place
from cranktrain.engine.specs import CylinderSpec, CylindersSpec
from cranktrain.engine.volumes import Chambers, CompressionRatios
from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.wording import number

CYCLES = {"two-stroke": 2 * np.pi, "four-stroke": 4 * np.pi}
"""Length of a cycle by name. [rad]"""


@dataclass(frozen=True)
class Cylinder:
    """One piston's cylinder: what its own table, its bank's or the common one gives, the nearest first."""

    piston: str
    bank: str
    spec: CylinderSpec
    has_own_ratio: bool
    is_master: bool

    @property
    def chambers(self) -> tuple[str, ...]:
        """Sides of the piston on which there is a chamber."""
        return self.spec.chambers or ("head",)


def cylinders_of(common: CylindersSpec, pistons: Sequence[Place]) -> tuple[Cylinder, ...]:
    """Give every piston its cylinder."""
    cylinders: list[Cylinder] = []
    for place in pistons:
        own = [common.overrides[name] for name in (place.name, place.bank) if name in common.overrides]
        fields = {
            name: next((value for table in (*own, common) if (value := getattr(table, name)) is not None), None)
            for name in CylinderSpec.model_fields
        }
        cylinders.append(
            Cylinder(
                piston=place.name,
                bank=place.bank,
                spec=CylinderSpec.model_construct(**fields),
                has_own_ratio=any(table.compression_ratio is not None for table in own),
                is_master=place.kind.name == "slider_crank",
            )
        )
    return tuple(cylinders)


def cylinder_problems(common: CylindersSpec, pistons: Sequence[Place]) -> tuple[Problem, ...]:
    """Find overrides of nothing, bores given for some pistons only, and piston rods that do not fit."""
    problems: list[Problem] = []
    known = dict.fromkeys([name for place in pistons for name in (place.bank, place.name) if name])
    for name in common.overrides:
        if name not in known:
            allowed = _("is neither a field of [cylinder] nor a bank or piston of this machine: {known}")
            problems.append(Problem(f"cylinder.{name}", None, allowed.format(known=", ".join(known))))
    cylinders = cylinders_of(common, pistons)
    without = [cylinder.piston for cylinder in cylinders if cylinder.spec.bore is None]
    if without and len(without) < len(cylinders):
        allowed = _("is missing for {pistons}, while others have one").format(pistons=", ".join(without))
        problems.append(Problem("cylinder.bore", None, allowed))
    for cylinder in cylinders:
        bore, rod = cylinder.spec.bore, cylinder.spec.piston_rod
        if bore is not None and rod is not None and rod.si >= bore.si:
            allowed = _("must be less than the bore, {bore}").format(bore=bore.text)
            problems.append(Problem("cylinder.piston_rod", rod.text, allowed))
            break
    return tuple(problems)


def chambers_of(designs: Sequence[Sequence[Cylinder]]) -> Chambers | None:
    """Signed area matrix of the working chambers; None where no bore is given."""
    first = designs[0]
    if not first or any(cylinder.spec.bore is None for design in designs for cylinder in design):
        return None
    sides = [(i, side) for i, cylinder in enumerate(first) for side in cylinder.chambers]
    areas = np.zeros((len(designs), len(first), len(sides)))
    for d, design in enumerate(designs):
        for column, (i, side) in enumerate(sides):
            areas[d, i, column] = _signed_area(design[i].spec, side)
    return Chambers(
        names=tuple(
            first[i].piston if len(first[i].chambers) == 1 and side == "head" else f"{first[i].piston}.{side}"
            for i, side in sides
        ),
        banks=tuple(first[i].bank for i, _side in sides),
        areas=areas,
    )


def _signed_area(spec: CylinderSpec, side: str) -> float:
    """Area by which a chamber grows as its piston moves toward the shaft. [m²]"""
    assert spec.bore is not None  # looked at before
    full = np.pi / 4 * spec.bore.si**2
    return full if side == "head" else -(full - (np.pi / 4 * spec.piston_rod.si**2 if spec.piston_rod else 0.0))


def compression_ratios_of(designs: Sequence[Sequence[Cylinder]]) -> CompressionRatios | None:
    """Compression ratio of every chamber that has one of its own; None where the leading piston has none.

    The common ratio is the first master's; the other pistons share its deck and chamber.
    """
    first = designs[0]
    leader = next((i for i, cylinder in enumerate(first) if cylinder.is_master), 0)
    if not first or any(design[leader].spec.compression_ratio is None for design in designs):
        return None
    sides = [(i, side) for i, cylinder in enumerate(first) for side in cylinder.chambers]
    value = np.full((len(designs), len(sides)), np.nan)
    for d, design in enumerate(designs):
        for column, (i, side) in enumerate(sides):
            ratio = design[i].spec.compression_ratio
            if ratio is not None and (i == leader or side == "crank" or design[i].has_own_ratio):
                value[d, column] = ratio.si
    column = next(k for k, (i, _side) in enumerate(sides) if i == leader)
    return CompressionRatios(value, np.full(len(sides), column, dtype=np.intp))


def firing_order_of(
    common: CylindersSpec, pistons: Sequence[Place], *, astern: bool
) -> tuple[FiringOrder | None, tuple[Problem, ...]]:
    """Read the firing order; None where the file has none or no cycle.

    Running astern it is read backwards from the same first piston.
    """
    if common.firing_order is None or common.cycle is None:
        return None, ()
    path = "cylinder.firing_order"
    names = [place.name for place in pistons]
    problems = tuple(
        Problem(
            f"cylinder.numbers.{number}",
            name,
            _("must be a piston of this machine: {pistons}").format(pistons=", ".join(names)),
        )
        for number, name in common.numbers.items()
        if name not in names
    )
    order = [common.numbers.get(word, word) for word in re.split(r"[\s,–-]+", common.firing_order.strip()) if word]
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
    if wrong:
        allowed = _("must name each piston once ({pistons}); {wrong}").format(
            pistons=", ".join(names), wrong="; ".join(wrong)
        )
        problems = (*problems, Problem(path, common.firing_order, allowed))
    if problems:
        return None, problems
    if astern:
        order = [order[0], *order[:0:-1]]
    index = np.array([names.index(name) for name in order], dtype=np.intp)
    tops = np.mod(np.array([pistons[names.index(name)].nominal_top for name in order]), 2 * np.pi)
    cycle = CYCLES[common.cycle]
    if firing_angles(tops, cycle) is None:
        tops = np.where(tops > 2 * np.pi - 1e-9, 0.0, tops)
        turns = [2 * np.pi * turn for turn in range(round(cycle / (2 * np.pi)))]
        possible = ", ".join(
            f"{name} {_(' or ').join(number(float(top + turn), 'deg') for turn in turns)}"
            for name, top in zip(order, tops, strict=True)
        )
        allowed = _("cannot fire so: as the crank pins stand, the pistons are at their tops at {possible}").format(
            possible=possible
        )
        return None, (Problem(path, common.firing_order, allowed),)
    return FiringOrder(index), ()
