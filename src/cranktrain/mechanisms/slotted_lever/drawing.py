"""The slotted lever, to be drawn."""

from cranktrain.linkage import CrankAndPivot, fixed
from cranktrain.mechanisms.drawing import Block, Drawing, DrawnLink
from cranktrain.mechanisms.rocking_guide import slot_points
from cranktrain.mechanisms.slotted_lever.kinematics import slotted_lever
from cranktrain.motion import Array


def slotted_lever_drawing(angle: Array, geometry: CrankAndPivot) -> Drawing:
    """Shaft, crank pin, pivot and the lever's end at each angle, shape (..., n), and their links."""
    motion = slotted_lever(angle, geometry)
    still = 0.0 * angle
    longest = geometry.crank_radius + geometry.ground_length
    slot = dict(zip("BD", slot_points(motion.rocker, 1.1 * longest, geometry.offset), strict=False))
    return Drawing(
        pins={
            "O": fixed(still, still),
            "A": motion.pin,
            "C": fixed(still + geometry.ground_length, still),
            **slot,
        },
        links=(DrawnLink("crank", ("O", "A")), DrawnLink("lever", ("C", *slot))),
        guides=(),
        fixed=("O", "C"),
        paths=("A",),
        blocks=(Block("A", ("D" if "D" in slot else "C", "B")),),
        ends=tuple(slot),
    )
