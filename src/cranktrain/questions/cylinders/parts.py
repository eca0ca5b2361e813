"""Cylinders as the file declares them, as SI arrays, and what is wrong with them."""

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import Problem
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.question import Parts
from cranktrain.motion import Array
from cranktrain.questions.cylinders.declared import Cylinder, cylinder_problems, cylinders_of
from cranktrain.questions.cylinders.firing import Cycle, FiringOrder, common_order
from cranktrain.questions.cylinders.firing_order import firing_order_of
from cranktrain.questions.cylinders.ports import Ports
from cranktrain.questions.cylinders.spec import CylindersSpec
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
    cycle = _table(designs.each[0]).cycle_length
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


def chamber_sides(cylinders: Sequence[Cylinder]) -> list[tuple[Cylinder, str]]:
    """Give the cylinder of each chamber and the side of the piston on which that is."""
    return [(cylinder, side) for cylinder in cylinders for side in cylinder.chambers]


def chamber_names(cylinders: Sequence[Cylinder]) -> list[str]:
    """Name the chambers: `1L`, or `1L.head` and `1L.crank` where both sides of the piston work."""
    return [
        cylinder.name if cylinder.chambers == ("head",) else f"{cylinder.name}.{side}"
        for cylinder, side in chamber_sides(cylinders)
    ]


def chambers_of(designs: Sequence[Sequence[Cylinder]], n_pistons: int) -> Chambers | None:
    """Signed area matrix of the working chambers; None where no bore is given."""
    first = designs[0]
    bore, rod = (_si(designs, field) for field in ("bore", "piston_rod"))
    if not first or np.any(np.isnan(bore)):
        return None
    cylinder, sides = _sides(first)
    is_head = sides == "head"
    full, rods = np.pi / 4 * bore**2, np.pi / 4 * np.nan_to_num(rod) ** 2
    # A chamber grows as a near piston moves toward the shaft, on the crank's side it shrinks.
    signed = np.where(is_head, full[:, cylinder], -(full - rods)[:, cylinder])
    areas = np.zeros((len(designs), n_pistons, len(cylinder)))
    of: list[Cylinder] = [first[i] for i in cylinder.tolist()]
    for column, own in enumerate(of):
        areas[:, list(own.pistons), column] = signed[:, [column]] * np.array(own.signs)
    return Chambers(
        names=tuple(chamber_names(first)),
        banks=tuple(own.bank for own in of),
        cylinder=cylinder,
        is_head=is_head,
        areas=areas,
    )


def _si(designs: Sequence[Sequence[Cylinder]], field: str) -> Array:
    """Give a field of all cylinders, shape (design, cylinder), NaN where one has none."""
    given = [[getattr(cylinder.spec, field) for cylinder in design] for design in designs]
    return np.array([[np.nan if value is None else value.si for value in design] for design in given])


def _sides(cylinders: Sequence[Cylinder]) -> tuple[NDArray[np.intp], NDArray[np.str_]]:
    """Which cylinder each chamber is of, and on which side of its piston, shape (chamber,)."""
    sides = [(i, side) for i, cylinder in enumerate(cylinders) for side in cylinder.chambers]
    return np.array([i for i, _side in sides], dtype=np.intp), np.array([side for _i, side in sides], dtype=np.str_)


def compression_ratios_of(designs: Sequence[Sequence[Cylinder]]) -> CompressionRatios | None:
    """Compression ratio of every chamber that has one of its own; None where the leading piston has none.

    The common ratio is the first master's; the heads of the other cylinders share its deck and chamber.
    """
    first, ratio = designs[0], _si(designs, "compression_ratio")
    cylinder, sides = _sides(first)
    is_head = sides == "head"
    heads = np.flatnonzero(is_head).tolist()
    leader = next((k for k in heads if first[int(cylinder[k])].is_master), heads[0] if heads else 0)
    if not first or np.any(np.isnan(ratio[:, cylinder[leader]])):
        return None
    has_own = np.array([one.has_own_ratio for one in first])[cylinder]
    return CompressionRatios(
        value=np.where((cylinder == cylinder[leader]) | ~is_head | has_own, ratio[:, cylinder], np.nan),
        leader=np.where(is_head, leader, np.arange(len(cylinder))),
    )


def ports_of(designs: Sequence[Sequence[Cylinder]]) -> Ports | None:
    """Heights of the ports; None where any cylinder lacks one of the two."""
    height = np.stack([_si(designs, "exhaust_port"), _si(designs, "scavenge_port")], axis=-1)
    return None if not designs[0] or np.any(np.isnan(height)) else Ports(height)
