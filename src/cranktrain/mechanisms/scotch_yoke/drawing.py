"""The scotch yoke, to be drawn."""

import numpy as np

from cranktrain.linkage import fixed
from cranktrain.mechanisms.drawing import Block, Drawing, DrawnLink, Guide
from cranktrain.mechanisms.scotch_yoke.kinematics import ScotchYoke, scotch_yoke
from cranktrain.motion import Array, Coefficient, Point, single


def scotch_yoke_drawing(angle: Array, geometry: ScotchYoke) -> Drawing:
    """Shaft, crank pin, slider and the slot's ends at each angle, shape (..., n), and what joins them."""
    motion = scotch_yoke(angle, geometry)
    still = 0.0 * angle
    lean = np.cos(geometry.slot_angle) / np.sin(geometry.slot_angle)

    def of_yoke(height: Array) -> Point:
        """Point of the slot at a height over the line of stroke."""
        along = motion.slider._replace(value=motion.slider.value + height * lean)
        return Point(along, Coefficient(geometry.offset + height + still, still, still))

    return Drawing(
        pins={
            "O": fixed(still, still),
            "A": motion.pin,
            "B": of_yoke(still),
            "C": of_yoke(-1.2 * geometry.crank_radius - geometry.offset),
            "D": of_yoke(1.2 * geometry.crank_radius - geometry.offset),
        },
        links=(DrawnLink("crank", ("O", "A")), DrawnLink("yoke", ("C", "B", "D"))),
        guides=(Guide("B", single(0.0)),),
        fixed=("O",),
        paths=("A",),
        blocks=(Block("A", ("B",)),),
        ends=("C", "D"),
    )
