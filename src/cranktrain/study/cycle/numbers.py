"""Numbers of designs as the compiled cycle takes them, from what the layout and the stages have."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.fluids import AnyFluid
from cranktrain.layout.masses import Masses, MechanismMasses
from cranktrain.layout.mechanisms import Batch, Mechanisms
from cranktrain.motion import Array
from cranktrain.numerics.nested import leaves
from cranktrain.questions.cylinders.travel import CylinderTravel
from cranktrain.questions.forces.carriers import Carriers
from cranktrain.questions.forces.solved_cycle import Member
from cranktrain.questions.gas.chambers import GasInChambers
from cranktrain.study.cycle.given import ChamberNumbers, Found, OfFluid, OfKind, Repeats, Work
from cranktrain.study.cycle.nodes import SIZES, nodes
from cranktrain.study.cycle.panels import MOST_PANELS
from cranktrain.study.cycle.structure import CycleStructure, KindSource, Shape, shape_of
from cranktrain.study.cycle.tops import room_for_tops

MOST_POINTS = 2048
"""Points of a design that are kept."""
_APART = 200
"""By how many points more than whole pages hold rows begin apart: as many as a cycle has, about."""
_N_OF_ALL = 10
"""Rows of the machine as a whole: cosine and sine, gas, squares, torque, how it runs."""


class NumbersOfKinds(NamedTuple):
    """What of each kind stands in the source, and the numbers of its mechanisms."""

    sources: tuple[KindSource, ...]
    numbers: tuple[OfKind, ...]


def of_kinds(mechanisms: Mechanisms, masses: Masses, carriers: Carriers, joints: Sequence[Member]) -> NumbersOfKinds:
    """Numbers of all mechanisms, kind by kind."""
    n_designs = len(mechanisms.nominal_top)
    masters = frozenset(carriers.master[carriers.master >= 0].tolist())
    each = zip(mechanisms.batches, masses.batches, strict=True)
    found = [
        (_source(batch, made, carriers, masters), _numbers(place, batch, made, carriers, joints, n_designs))
        for place, (batch, made) in enumerate(each)
    ]
    return NumbersOfKinds(tuple(source for source, _own in found), tuple(own for _source, own in found))


def _source(batch: Batch, made: MechanismMasses, carriers: Carriers, masters: frozenset[int]) -> KindSource:
    return KindSource(
        batch.kind,
        shape_of(batch.members.geometry),
        len(made.bodies),
        has_slaves=not masters.isdisjoint(batch.index.tolist()),
        has_pistons=bool(np.any(carriers.piston[batch.index] >= 0)),
    )


def _numbers(
    place: int, batch: Batch, made: MechanismMasses, carriers: Carriers, joints: Sequence[Member], n_designs: int
) -> OfKind:
    index = batch.index
    joint = np.full((index.size, len(batch.kind.dynamics.reactions)), -1, dtype=np.intp)
    for row, one in enumerate(joints):
        if one.batch == place:
            joint[one.member, one.place] = row
    shape = n_designs, index.size
    phase = _side_by_side([batch.members.phase], shape)[..., 0]
    return OfKind(
        mechanism=index,
        piston=carriers.piston[index],
        master=carriers.master[index],
        joint=joint,
        phase=phase,
        ahead=np.stack([np.cos(phase), np.sin(phase)], axis=-1),
        geometry=_side_by_side(leaves(batch.members.geometry), shape),
        bodies=_side_by_side([part for body in made.bodies for part in body], shape),
        gravity=_side_by_side(list(made.gravity), shape),
    )


def _side_by_side(parts: Sequence[Array], shape: tuple[int, ...]) -> Array:
    """Numbers of shape (design, member, 1), or broadcastable, as one array (design, member, number)."""
    found = np.empty((*shape, len(parts)))
    for place, part in enumerate(parts):
        found[..., place : place + 1] = part
    return found


class NumbersOfGas(NamedTuple):
    """What of each fluid stands in the source, and the numbers of fluids and chambers."""

    sources: tuple[tuple[AnyFluid, Shape], ...]
    numbers: tuple[OfFluid, ...]
    room: ChamberNumbers


def of_gas(gas: GasInChambers | None, travel: CylinderTravel | None, n_designs: int) -> NumbersOfGas:
    """Numbers of the chambers and of what they hold; none without gas."""
    if gas is None or travel is None:
        nothing, no_kinks = np.zeros((n_designs, 0)), np.zeros(0)
        room = ChamberNumbers(
            partner=np.zeros((0, 2), dtype=np.intp),
            area=np.zeros((n_designs, 0, 2)),
            start=nothing,
            top=nothing,
            ambient=nothing,
            smallest=nothing,
            largest=nothing,
            firing=nothing,
            least=nothing,
            greatest=nothing,
            kink=np.zeros((n_designs, 0, 0)),
            sense=no_kinks,
            turn=no_kinks,
        )
        return NumbersOfGas((), (), room)
    partner, area = _partners(gas)
    least, greatest = gas.dead_centres(travel)
    kink, sense, turn = _kinks(gas)
    numbers: list[OfFluid] = []
    for one in gas.fillings:
        shape = n_designs, one.places.size
        numbers.append(OfFluid(one.places, _side_by_side(leaves(one.ready), shape)))
    room = ChamberNumbers(
        partner=partner,
        area=area,
        start=_of_designs(gas.start[..., 0], n_designs),
        top=_of_designs(gas.tops[..., 0], n_designs),
        ambient=_of_designs(gas.chambers.ambient, n_designs),
        smallest=_of_designs(gas.limits.smallest[..., 0], n_designs),
        largest=_of_designs(gas.limits.largest[..., 0], n_designs),
        firing=_of_designs(gas.firing[..., 0], n_designs),
        least=_of_designs(least, n_designs),
        greatest=_of_designs(greatest, n_designs),
        kink=_of_designs(kink, n_designs),
        sense=sense,
        turn=turn,
    )
    sources = tuple((one.fluid, shape_of(one.ready)) for one in gas.fillings)
    return NumbersOfGas(sources, tuple(numbers), room)


def _of_designs(values: Array, n_designs: int) -> Array:
    """Values of all designs, of which there may be one row for all."""
    found = np.empty((n_designs, *values.shape[1:]))
    found[:] = values
    return found


def _partners(gas: GasInChambers) -> tuple[np.ndarray, Array]:
    """Pistons of each chamber and their areas, shape (chamber, 2) and (design, chamber, 2)."""
    areas = gas.chambers.areas
    works = np.any(areas != 0.0, axis=0)
    partner = np.zeros((works.shape[1], 2), dtype=np.intp)
    area = np.zeros((len(gas.firing), works.shape[1], 2))
    for chamber in range(works.shape[1]):
        own = np.flatnonzero(works[:, chamber]).tolist()
        partner[chamber] = own[0], own[-1]
        for place, piston in enumerate(own):
            area[:, chamber, place] = areas[:, piston, chamber]
    return partner, area


def _kinks(gas: GasInChambers) -> tuple[Array, Array, Array]:
    """Volumes of all kinks, shape (design, chamber, kink), and on which branch they are, shape (kink,)."""
    each = [(one.places, kink) for one in gas.fillings for kink in one.fluid.kinks(one.ready, one.rooms.limits)]
    volume = np.full((*gas.firing.shape[:2], len(each)), np.nan)
    for place, (places, kink) in enumerate(each):
        volume[:, places, place] = np.broadcast_to(kink.volume, (len(volume), len(places), 1))[..., 0]
    sense, turn = (np.array([getattr(kink, name) for _places, kink in each], dtype=float) for name in ("sense", "turn"))
    return volume, sense, turn


class _Rows:
    """Rows for curves, one behind another in one block.

    Each begins elsewhere in a page of memory than those beside it: what begins alike shares few places near the
    processor, where a loop over many curves finds them again.
    """

    def __init__(self, n_rows: int) -> None:
        self._free = np.zeros((n_rows, MOST_PANELS * max(SIZES) + _APART))

    def taken(self, *shape: int) -> Array:
        """Take rows that are free, shape (…, point)."""
        n_rows = int(np.prod(shape))
        found, self._free = self._free[:n_rows], self._free[n_rows:]
        return found.reshape((*shape, found.shape[1]))


def room_to_work(
    structure: CycleStructure, room: ChamberNumbers, n_mechanisms: int, n_pistons: int, n_joints: int
) -> Work:
    """Room for the curves of one design."""
    n_chambers, asks = len(room.partner), structure.asks
    n_pressures = n_chambers if "pressure" in asks else 0
    n_forces = n_joints if "joint" in asks else 0
    n_rods = n_pistons if "rod" in asks else 0
    rows = _Rows(_N_OF_ALL + 2 * n_pistons + 3 * n_mechanisms + n_pressures + 2 * n_forces + 4 * n_rods)
    return Work(
        cos=rows.taken(),
        sin=rows.taken(),
        slider=rows.taken(n_pistons),
        push=rows.taken(n_pistons),
        gas=rows.taken(),
        on_rod=rows.taken(3, n_mechanisms),
        repeats=Repeats(
            mechanism=np.zeros(n_mechanisms, dtype=np.intp),
            piston=np.zeros(n_pistons, dtype=np.intp),
            chamber=np.zeros(n_chambers, dtype=np.intp),
            is_taken=np.zeros(n_mechanisms, dtype=np.bool_),
            is_first=np.ones(n_chambers, dtype=np.bool_),
        ),
        pole=np.zeros(n_chambers),
        away=np.zeros(n_chambers),
        torque=rows.taken(2),
        running=rows.taken(4),
        pressure=rows.taken(n_pressures),
        joint_x=rows.taken(n_forces),
        joint_y=rows.taken(n_forces),
        rod=rows.taken(4, n_rods),
        tops=room_for_tops(rows.taken(), nodes()),
        speeds=np.zeros(5),
    )


def nothing_found(structure: CycleStructure, work: Work, n_designs: int) -> Found:
    """Room for the facts of all designs, of which none is known yet."""
    keeps = "points" in structure.asks

    def unknown(*shape: int) -> Array:
        return np.full((n_designs, *shape), np.nan)

    return Found(
        is_known=np.zeros(n_designs, dtype=np.bool_),
        torque=unknown(5),
        pressure=unknown(len(work.pressure), 2),
        joint=unknown(len(work.joint_x), 2),
        rod=unknown(work.rod.shape[1], 6),
        work=unknown(),
        flywheel=unknown(6),
        running=unknown(5),
        n_panels=np.zeros(n_designs, dtype=np.intp),
        panel=np.zeros((n_designs, 2, MOST_PANELS if keeps else 0)),
        row=np.zeros((n_designs, MOST_PANELS if keeps else 0), dtype=np.intp),
        angle=np.zeros((n_designs, MOST_POINTS if keeps else 0)),
        push=np.zeros((n_designs, len(work.push) if keeps else 0, MOST_POINTS if keeps else 0)),
    )
