"""The scotch yoke, to be drawn."""

import numpy as np

from cranktrain.linkage import fixed
from cranktrain.mechanisms.kind import Drawing, DrawnLink, Guide, pin_positions
from cranktrain.mechanisms.scotch_yoke.kinematics import ScotchYoke, scotch_yoke
from cranktrain.motion import Array, single


def scotch_yoke_drawing(angle: Array, geometry: ScotchYoke) -> Drawing:
    """Positions of shaft, crank pin, slider and the slot's ends at each angle, shape (..., n), and what joins them."""
    motion = scotch_yoke(angle, geometry)
    still = 0.0 * angle
    slope = 1.0 / np.sin(geometry.slot_angle)
    low, high = (
        (
            motion.slider.value + along * slope * np.cos(geometry.slot_angle),
            still + geometry.offset + along,
        )
        for along in (
            -1.2 * geometry.crank_radius - geometry.offset,
            1.2 * geometry.crank_radius - geometry.offset,
        )
    )
    return Drawing(
        pins={
            **pin_positions(O=fixed(still, still), A=motion.pin),
            "B": (motion.slider.value, still + geometry.offset),
            "C": low,
            "D": high,
        },
        links=(DrawnLink("crank", ("O", "A")), DrawnLink("yoke", ("C", "B", "D"))),
        guides=(Guide("B", single(0.0)),),
        fixed=("O",),
        paths=("A",),
    )
