"""Cylinders as the file declares them, as SI arrays, and what is wrong with them."""

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import Problem, judged
from cranktrain.layout.design import Design, Designs
from cranktrain.layout.question import Parts
from cranktrain.motion import Array
from cranktrain.numerics.designs import by_design
from cranktrain.quantities import Given
from cranktrain.questions.cylinders.declared import Cylinder, cylinder_problems, cylinders_of, name_of_side
from cranktrain.questions.cylinders.firing import Cycle, FiringOrder, common_order
from cranktrain.questions.cylinders.firing_order import firing_order_of, order_of_cranks
from cranktrain.questions.cylinders.ports import Ports
from cranktrain.questions.cylinders.spec import CylindersSpec
from cranktrain.questions.cylinders.travel import CylinderPistons
from cranktrain.questions.cylinders.volumes import ATMOSPHERE, Chambers, CompressionRatios


def cylinders(design: Design) -> tuple[Cylinder, ...]:
    """Give the cylinders of a machine, each with its pistons and dimensions."""
    return cylinders_of(_table(design), design.pistons)


def firing_order(design: Design) -> tuple[FiringOrder | None, tuple[Problem, ...]]:
    """In which order the cylinders of a machine fire, and what is wrong with that."""
    pistons = design.pistons
    leading = [pistons[cylinder.pistons[0]] for cylinder in design.once(cylinders)]
    return firing_order_of(_table(design), leading, zero=design.zero, astern=design.orientation.is_astern)


def order_of_cylinders(design: Design) -> FiringOrder:
    """Give the order in which cylinders work that do so once a turn: as their cranks come."""
    pistons = design.pistons
    return order_of_cranks([pistons[cylinder.pistons[0]] for cylinder in design.once(cylinders)])


def _table(design: Design) -> CylindersSpec:
    return design.table(CylindersSpec) or CylindersSpec()


def _size_problems(design: Design) -> Iterator[Problem]:
    yield from cylinder_problems(_table(design), design.pistons, design.once(cylinders))


def problems(design: Design) -> Iterator[Problem]:
    """Find what does not fit the pistons."""
    yield from judged(_size_problems(design))
    if design.pistons:
        yield from design.once(firing_order)[1]


def parts(designs: Designs, _known: Parts) -> Iterator[object | None]:
    """Cylinders, chambers, ports, cycle and firing order."""
    if designs.pistons is None:
        return
    own, n_designs = designs.together.once(cylinders), designs.n_designs
    cycle = _table(designs.together).cycle_length
    yield cylinder_pistons_of(own)
    yield chambers_of(own, len(designs.pistons.names), n_designs)
    yield compression_ratios_of(own, n_designs)
    yield ports_of(own, n_designs)
    yield None if cycle is None else Cycle(cycle)
    yield common_order(designs.together.once(firing_order)[0], n_designs)


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


def chambers_at(design: Design, piston: str) -> dict[int, str]:
    """Give the places of a piston's chambers among those of all pistons, each with its side of the piston."""
    own = [place.name for place in design.pistons].index(piston)
    sides = chamber_sides(design.once(cylinders))
    return {place: side for place, (cylinder, side) in enumerate(sides) if own in cylinder.pistons}


def chamber_names(cylinders: Sequence[Cylinder]) -> list[str]:
    """Name the chambers: `1L`, or `1L.head` and `1L.crank` where both sides of the piston work."""
    return [
        cylinder.name if cylinder.chambers == ("head",) else name_of_side(cylinder.name, side)
        for cylinder, side in chamber_sides(cylinders)
    ]


def chambers_of(cylinders: Sequence[Cylinder], n_pistons: int, n_designs: int) -> Chambers | None:
    """Signed area matrix of the working chambers; None where no bore is given."""
    bore, rod, ambient = (_si(cylinders, field, n_designs) for field in ("bore", "piston_rod", "ambient"))
    if not cylinders or np.any(np.isnan(bore)):
        return None
    cylinder, sides = _sides(cylinders)
    is_head = sides == "head"
    full, rods = np.pi / 4 * bore**2, np.pi / 4 * np.nan_to_num(rod) ** 2
    # A chamber grows as a near piston moves toward the shaft, on the crank's side it shrinks.
    signed = np.where(is_head, full[:, cylinder], -(full - rods)[:, cylinder])
    areas = np.zeros((n_designs, n_pistons, len(cylinder)))
    of: list[Cylinder] = [cylinders[i] for i in cylinder.tolist()]
    pistons = [(k, *own) for k, one in enumerate(of) for own in zip(one.pistons, one.signs, strict=True)]
    column, piston, sign = zip(*pistons, strict=True)
    areas[:, piston, column] = signed[:, column] * np.array(sign)
    return Chambers(
        names=tuple(chamber_names(cylinders)),
        banks=tuple(own.bank for own in of),
        cylinder=cylinder,
        is_head=is_head,
        areas=areas,
        ambient=np.where(np.isnan(ambient), ATMOSPHERE, ambient)[:, cylinder],
    )


def _si(cylinders: Sequence[Cylinder], field: str, n_designs: int) -> Array:
    """Give a field of all cylinders, shape (design, cylinder), NaN where one has none."""
    return _as_numbers([getattr(cylinder, field) for cylinder in cylinders], n_designs)


def _as_numbers(given: Sequence[Given | None], n_designs: int) -> Array:
    """Numbers of all designs, shape (design, given); NaN for none."""
    return by_design([np.nan if value is None else value.array for value in given], n_designs)


def _sides(cylinders: Sequence[Cylinder]) -> tuple[NDArray[np.intp], NDArray[np.str_]]:
    """Which cylinder each chamber is of, and on which side of its piston, shape (chamber,)."""
    sides = [(i, side) for i, cylinder in enumerate(cylinders) for side in cylinder.chambers]
    return np.array([i for i, _side in sides], dtype=np.intp), np.array([side for _i, side in sides], dtype=np.str_)


def compression_ratios_of(cylinders: Sequence[Cylinder], n_designs: int) -> CompressionRatios | None:
    """Compression ratio of every chamber that has one of its own; None where the leading piston has none.

    The common ratio is the first master's; the heads of the other cylinders share its deck and chamber.
    """
    rooms = [room for one in cylinders for room in one.ratios]
    ratio = _as_numbers([room.ratio for room in rooms], n_designs)
    cylinder, sides = _sides(cylinders)
    is_head = sides == "head"
    heads = np.flatnonzero(is_head).tolist()
    leader = next((k for k in heads if cylinders[int(cylinder[k])].is_master), heads[0] if heads else 0)
    if not cylinders or np.any(np.isnan(ratio[:, leader])):
        return None
    has_own = np.array([room.is_own for room in rooms])
    owners: list[int] = cylinder.tolist()
    of_piston = {piston: k for k in heads for piston in cylinders[int(cylinder[k])].pistons}
    return CompressionRatios(
        value=np.where((cylinder == cylinder[leader]) | ~is_head | has_own, ratio, np.nan),
        leader=np.where(is_head, leader, np.arange(len(cylinder))),
        master=np.array([of_piston.get(cylinders[i].carrier, k) for k, i in enumerate(owners)], dtype=np.intp),
        is_clearance=rooms[leader].is_clearance,
    )


def ports_of(cylinders: Sequence[Cylinder], n_designs: int) -> Ports | None:
    """Heights of the ports; None where any cylinder lacks one of the two."""
    height = np.stack([_si(cylinders, f"{kind}_port", n_designs) for kind in ("exhaust", "scavenge")], axis=-1)
    return None if not cylinders or np.any(np.isnan(height)) else Ports(height)
