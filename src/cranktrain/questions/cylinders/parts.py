"""Cylinders as the file declares them, as SI arrays, and what is wrong with them."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.errors import Problem
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.question import Parts
from cranktrain.questions.cylinders.declared import Cylinder, cylinder_problems, cylinders_of
from cranktrain.questions.cylinders.firing import Cycle, FiringOrder, common_order
from cranktrain.questions.cylinders.firing_order import firing_order_of
from cranktrain.questions.cylinders.ports import Ports
from cranktrain.questions.cylinders.spec import CylinderSpec, CylindersSpec
from cranktrain.questions.cylinders.travel import CylinderPistons
from cranktrain.questions.cylinders.volumes import Chambers, CompressionRatios


def cylinders(design: Design) -> tuple[Cylinder, ...]:
    """Give the cylinders of a machine, each with its pistons and dimensions."""
    return cylinders_of(_table(design), design.pistons)


def firing_order(design: Design) -> tuple[FiringOrder | None, tuple[Problem, ...]]:
    """In which order the cylinders of a machine fire, and what is wrong with that."""
    leading = [design.pistons[cylinder.pistons[0]] for cylinder in design.once(cylinders)]
    return firing_order_of(_table(design), leading, zero=design.zero, astern=design.orientation.is_astern)


def _table(design: Design) -> CylindersSpec:
    return design.table(CylindersSpec) or CylindersSpec()


def problems(design: Design) -> Iterator[Problem]:
    """Find what does not fit the pistons."""
    yield from cylinder_problems(_table(design), design.pistons, design.once(cylinders))
    if design.pistons:
        yield from design.once(firing_order)[1]


def parts(designs: Designs, _known: Parts) -> Iterator[object | None]:
    """Cylinders, chambers, ports, cycle and firing order."""
    if designs.pistons is None:
        return
    each = [design.once(cylinders) for design in designs.each]
    cycle = _table(designs.first).cycle_length
    yield cylinder_pistons_of(each[0])
    yield chambers_of(each, len(designs.pistons.names))
    yield compression_ratios_of(each)
    yield ports_of(each)
    yield None if cycle is None else Cycle(cycle)
    yield common_order([design.once(firing_order)[0] for design in designs.each])


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
        np.array(
            [
                [
                    [port.si for port in (cylinder.spec.exhaust_port, cylinder.spec.scavenge_port) if port is not None]
                    for cylinder in design
                ]
                for design in designs
            ]
        ),
    )
