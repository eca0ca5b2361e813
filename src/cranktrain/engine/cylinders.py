"""Cylinders: bores, compression ratios and firing order of the file, put to the pistons of a layout."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from cranktrain.engine.firing import FiringOrder, firing_angles, within_turn
from cranktrain.engine.places import Place
from cranktrain.engine.specs import CylinderSpec, CylindersSpec
from cranktrain.engine.volumes import Chambers, CompressionRatios
from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.wording import number

CYCLES = {"two-stroke": 2 * np.pi, "four-stroke": 4 * np.pi}
"""Length of a cycle by name. [rad]"""


@dataclass(frozen=True)
class Cylinder:
    """One piston's cylinder: what its own table, its bank's or the common one gives, the nearest first.

    Attributes
    ----------
    piston, bank : str
    spec : CylinderSpec
    paths : mapping of str to str
        Where in the machine file each field that is given stands.
    is_master : bool
        Whether the piston hangs on the crank pin itself.
    is_piston : bool
        Whether it is one, and not a valve.
    """

    piston: str
    bank: str
    spec: CylinderSpec
    paths: Mapping[str, str]
    is_master: bool
    is_piston: bool

    @property
    def has_own_ratio(self) -> bool:
        """Whether a table of its own or of its bank gives the compression ratio."""
        return self.paths.get("compression_ratio", _COMMON_RATIO) != _COMMON_RATIO

    @property
    def chambers(self) -> tuple[str, ...]:
        """Sides of the piston on which there is a chamber; a valve has none."""
        return (self.spec.chambers or ("head",)) if self.is_piston else ()


_COMMON_RATIO = "cylinder.compression_ratio"


def cylinders_of(common: CylindersSpec, pistons: Sequence[Place]) -> tuple[Cylinder, ...]:
    """Give every piston its cylinder."""
    return tuple(_cylinder(common, place) for place in pistons)


def _cylinder(common: CylindersSpec, place: Place) -> Cylinder:
    """Take each field from the nearest table that gives it."""
    tables: list[tuple[str, CylinderSpec]] = [
        (f"cylinder.{name}", common.overrides[name]) for name in (place.name, place.bank) if name in common.overrides
    ]
    fields: dict[str, Any] = {}
    paths: dict[str, str] = {}
    for path, table in (*tables, ("cylinder", common)):
        for name in CylinderSpec.model_fields:
            value = getattr(table, name)
            if value is not None and name not in fields:
                fields[name], paths[name] = value, f"{path}.{name}"
    spec = CylinderSpec.model_construct(**fields)
    kind = place.kind
    return Cylinder(
        place.name, place.bank, spec, paths, is_master=kind.name == "slider_crank", is_piston=kind.has_chambers
    )


def cylinder_problems(common: CylindersSpec, pistons: Sequence[Place]) -> tuple[Problem, ...]:
    """Find cylinders and overrides of nothing, bores given for some pistons only, piston rods that do not fit."""
    pistons = [place for place in pistons if place.kind.has_chambers]
    if not pistons:
        allowed = _("is not for this machine, which has no pistons")
        return (Problem("cylinder", None, allowed),) if common.model_fields_set else ()
    known = dict.fromkeys([name for place in pistons for name in (place.bank, place.name) if name])
    allowed = _("is neither a key of [cylinder] nor a bank or piston of this machine: {known}")
    problems = [
        Problem(f"cylinder.{name}", None, allowed.format(known=", ".join(known)))
        for name in common.overrides
        if name not in known
    ]
    cylinders = cylinders_of(common, pistons)
    without = [cylinder.piston for cylinder in cylinders if cylinder.spec.bore is None]
    if without and len(without) < len(cylinders):
        allowed = _("is missing for {pistons}, while others have one").format(pistons=", ".join(without))
        problems.append(Problem("cylinder.bore", None, allowed))
    for cylinder in cylinders:
        bore, rod = cylinder.spec.bore, cylinder.spec.piston_rod
        if bore is not None and rod is not None and rod.si >= bore.si:
            allowed = _("must be less than the bore, {bore}").format(bore=bore.text)
            problems.append(Problem(cylinder.paths["piston_rod"], rod.text, allowed))
    return tuple(dict.fromkeys(problems))


def chambers_of(designs: Sequence[Sequence[Cylinder]]) -> Chambers | None:
    """Signed area matrix of the working chambers; None where no bore is given."""
    first = designs[0]
    if all(not cylinder.chambers for cylinder in first):
        return None
    if any(cylinder.spec.bore is None for design in designs for cylinder in design if cylinder.chambers):
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

    The common ratio is the first master's; the heads of the other pistons share its deck and chamber.
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


def firing_order_of(
    common: CylindersSpec, pistons: Sequence[Place], *, astern: bool
) -> tuple[FiringOrder | None, tuple[Problem, ...]]:
    """Read the firing order; None where the file has none. Running astern it is read backwards from the same piston.

    Whether the crank pins allow it can be told where the cycle is known, too.
    """
    names = [place.name for place in pistons]
    problems = _number_problems(common, names)
    if common.firing_order is None or problems:
        return None, problems
    order = [common.numbers.get(word, word) for word in re.split(r"[\s,–-]+", common.firing_order.strip()) if word]
    problems = _order_problems(common, order, names)
    if problems:
        return None, problems
    if astern:
        order = [order[0], *order[:0:-1]]
    index = [names.index(name) for name in order]
    problems = _throw_problems(common, order, within_turn(np.array([pistons[i].nominal_top for i in index])))
    by_piston = {name: word for word, name in common.numbers.items()}
    numbers = tuple(by_piston.get(name, name) for name in order) if by_piston else ()
    return (None if problems else FiringOrder(np.array(index, dtype=np.intp), numbers)), problems


def _number_problems(common: CylindersSpec, names: Sequence[str]) -> tuple[Problem, ...]:
    """Find a maker's numbers for no piston, or two for one."""
    problems: list[Problem] = []
    numbered: dict[str, str] = {}
    for word, name in common.numbers.items():
        allowed = None
        if name not in names:
            allowed = _("must be a piston of this machine: {pistons}").format(pistons=", ".join(names))
        elif name in numbered:
            allowed = _("must be another piston: this one is number {number}").format(number=numbered[name])
        if allowed is not None:
            problems.append(Problem(f"cylinder.numbers.{word}", name, allowed))
        numbered.setdefault(name, word)
    return tuple(problems)


def _order_problems(common: CylindersSpec, order: Sequence[str], names: Sequence[str]) -> tuple[Problem, ...]:
    """Find pistons that the order does not name once."""
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
    allowed = _("must name each piston once ({pistons}); {wrong}").format(
        pistons=", ".join(names), wrong="; ".join(wrong)
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
