"""Torque in the journals and crank pins of all shafts: by all but the bearings once, and by these with each method."""

from collections.abc import Sequence

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.crankshaft.bending.loads_in_spans import SpannedLoads
from cranktrain.questions.crankshaft.bending.torque_along import TorqueOfLoads, torque_by_bearings, torque_of_loads
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts


def torques_of_loads(loaded: LoadedShafts, acting: Sequence[SpannedLoads]) -> list[TorqueOfLoads]:
    """Torque of each shaft by all that acts on it but its bearings."""
    return [
        torque_of_loads(loaded_shaft.metal, spanned.loads)
        for loaded_shaft, spanned in zip(loaded.each, acting, strict=True)
    ]


def torque_in_sections(loaded: LoadedShafts, by_loads: Sequence[TorqueOfLoads], borne: Array | None) -> Array:
    """Torque of every section in the sense of its shaft's rotation, shape (design, section, n). [N·m]

    Parameters
    ----------
    loaded : LoadedShafts
    by_loads : sequence of TorqueOfLoads
    borne : Array, shape (design, bearing, 2, n), or None
        Load of all bearings; without it the torque is right in journals alone. [N]
    """
    torques: list[Array] = []
    before = 0
    for loaded_shaft, of_loads in zip(loaded.each, by_loads, strict=True):
        shaft, torque = loaded_shaft.metal, of_loads.along.begin
        n_bearings = shaft.supports.place.shape[1]
        if borne is not None:
            here = borne[:, before : before + n_bearings]
            torque = torque + torque_by_bearings(shaft, of_loads.axis, here, shaft.pieces.bounds[:, :-1])
        torques.append(loaded_shaft.layout.turn * torque)
        before += n_bearings
    return np.concatenate(torques, axis=1)
