"""The slotted lever, to be drawn."""

from cranktrain.linkage import CrankAndPivot, LinkPoint, fixed, point
from cranktrain.mechanisms.drawing import Block, Drawing, DrawnLink
from cranktrain.mechanisms.slotted_lever.kinematics import slotted_lever
from cranktrain.motion import Array


def slotted_lever_drawing(angle: Array, geometry: CrankAndPivot) -> Drawing:
    """Shaft, crank pin, pivot and the lever's end at each angle, shape (..., n), and their links."""
    motion = slotted_lever(angle, geometry)
    still = 0.0 * angle
    longest = geometry.crank_radius + geometry.ground_length
    return Drawing(
        pins={
            "O": fixed(still, still),
            "A": motion.pin,
            "C": fixed(still + geometry.ground_length, still),
            "B": point(motion.rocker, LinkPoint(1.1 * longest, still)),
        },
        links=(DrawnLink("crank", ("O", "A")), DrawnLink("lever", ("C", "B"))),
        guides=(),
        fixed=("O", "C"),
        paths=("A",),
        blocks=(Block("A", ("C", "B")),),
        ends=("B",),
    )
