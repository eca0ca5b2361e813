"""What is alike where a cycle repeats itself: mechanisms of all kinds, and chambers of all fluids, in one table."""

from collections.abc import Sequence

import numpy as np

from cranktrain.motion import Array
from cranktrain.study.cycle.given import ChamberNumbers, OfFluid, OfKind, OfRepeats, Places


def of_repeats(kinds: Sequence[OfKind], room: ChamberNumbers, fluids: Sequence[OfFluid]) -> OfRepeats:
    """Lay numbers of all kinds and fluids beside one another; of one mechanism alone, which repeats nothing, none."""
    n_mechanisms, n_chambers = sum(kind.mechanism.size for kind in kinds), len(room.partner)
    n_designs = len(room.area) if n_mechanisms > 1 else 0
    of_kind, piston, master = np.full((3, n_mechanisms), -1, dtype=np.intp)
    fluid, phase = np.zeros(n_chambers, dtype=np.intp), np.empty((n_designs, n_mechanisms))
    for place, one in enumerate(kinds):
        index = one.mechanism
        of_kind[index], piston[index], master[index] = place, one.piston, one.master
        phase[:, index] = one.phase[:n_designs]
    for place, one in enumerate(fluids):
        fluid[one.places] = place
    members = [
        np.concatenate([each[:n_designs] for each in (one.geometry, one.bodies, one.gravity)], -1) for one in kinds
    ]
    numbers = _side_by_side(members, [one.mechanism for one in kinds], phase.shape)
    tops = (room.top[:n_designs, room.partner[:, which]] for which in range(2))
    sizes = (room.start, room.ambient, room.smallest, room.largest)
    of_fluids = [one.numbers[:n_designs] for one in fluids]
    volumes = np.concatenate(
        [
            room.area[:n_designs],
            np.stack([*tops, *(each[:n_designs] for each in sizes)], axis=-1),
            _side_by_side(of_fluids, [one.places for one in fluids], (n_designs, n_chambers)),
        ],
        axis=-1,
    )
    angles = np.stack([each[:n_designs] for each in (room.firing, room.least, room.greatest)], axis=-1)
    firing = _firing(piston, room, n_designs)
    return OfRepeats(of_kind, piston, master, phase, firing, numbers, fluid, room.partner, angles, volumes)


def _firing(piston: Places, room: ChamberNumbers, n_designs: int) -> Array:
    """Nominal firing of the first chamber of each mechanism's piston; NaN for none. [rad]"""
    firing = np.full((n_designs, piston.size), np.nan)
    for mechanism, own in enumerate(piston.tolist()):
        chambers: list[int] = np.flatnonzero(np.any(room.partner == own, axis=-1)).tolist() if own >= 0 else []
        for chamber in chambers[:1]:
            firing[:, mechanism] = room.firing[:n_designs, chamber]
    return firing


def _side_by_side(each: Sequence[Array], places: Sequence[Places], shape: tuple[int, int]) -> Array:
    """Rows of some sorts, each at its places, as one array; 0 behind the shorter ones."""
    found = np.zeros((*shape, max((one.shape[-1] for one in each), default=0)))
    for one, index in zip(each, places, strict=True):
        found[:, index, : one.shape[-1]] = one
    return found
