"""Torque in the journals and crank pins of all shafts: by all but the bearings once, and by these with each method."""

from collections.abc import Sequence

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.blocks import turned_by
from cranktrain.questions.crankshaft.bending.loads_in_spans import SpannedLoads
from cranktrain.questions.crankshaft.bending.torque_along import TorqueOfLoads, torque_by_bearings, torque_of_loads
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts


def torques_of_loads(loaded: LoadedShafts, acting: Sequence[SpannedLoads]) -> list[TorqueOfLoads]:
    """Torque of each shaft by all that acts on it but its bearings."""
    return [
        torque_of_loads(shaft.metal, spanned.loads, spanned.turning_force)
        for shaft, spanned in zip(loaded.each, acting, strict=True)
    ]


def in_turning_axes(borne: Array, acting: Sequence[SpannedLoads], loaded: LoadedShafts) -> list[Array]:
    """Load of the bearings of each shaft in axes that turn with it, from that of all, (design, bearing, 2, n). [N]"""
    ends = np.cumsum([supports.place.shape[1] for supports in loaded.supports])
    parts = np.split(borne, ends[:-1], axis=1)
    return [turned_by(load, spanned.loads.turned) for load, spanned in zip(parts, acting, strict=True)]


def torque_in_sections(loaded: LoadedShafts, by_loads: Sequence[TorqueOfLoads], borne: Sequence[Array]) -> Array:
    """Torque of every section in the sense of its shaft's rotation, shape (design, section, n). [N·m]

    Parameters
    ----------
    loaded : LoadedShafts
    by_loads : sequence of TorqueOfLoads
    borne : sequence of Array, shape (design, bearing, 2, n)
        Load of the bearings of each shaft in axes that turn with it; of none, the torque is right in journals alone.
        [N]
    """
    torques: list[Array] = []
    for place, (one, of_loads) in enumerate(zip(loaded.each, by_loads, strict=True)):
        torque = of_loads.torque
        if borne:
            begin = one.metal.pieces.bounds[:, :-1]
            torque = torque + torque_by_bearings(one.metal, of_loads.axis, borne[place], begin)
        torques.append(one.layout.turn * torque)
    return np.concatenate(torques, axis=1)
