"""The oscillating cylinder, to be drawn."""

from cranktrain.linkage import CrankAndPivot, LinkPoint, fixed, point
from cranktrain.mechanisms.drawing import Block, Drawing, DrawnLink
from cranktrain.mechanisms.oscillating_cylinder.kinematics import oscillating_cylinder
from cranktrain.mechanisms.rocking_guide import slot_points
from cranktrain.motion import Array


def oscillating_cylinder_drawing(angle: Array, geometry: CrankAndPivot) -> Drawing:
    """Shaft, crank pin, trunnion, cylinder and piston rod at each angle, shape (..., n)."""
    motion = oscillating_cylinder(angle, geometry)
    still = 0.0 * angle
    axis = dict(zip("DE", slot_points(motion.cylinder, -2.0 * geometry.crank_radius, geometry.offset), strict=False))
    return Drawing(
        pins={
            "O": fixed(still, still),
            "A": motion.pin,
            "C": fixed(still + geometry.ground_length, still),
            "B": point(motion.cylinder._replace(origin=motion.pin), LinkPoint(-geometry.ground_length, still)),
            **axis,
        },
        links=(DrawnLink("crank", ("O", "A")), DrawnLink("cylinder", ("C", *axis)), DrawnLink("rod", ("A", "B"))),
        guides=(),
        fixed=("O", "C"),
        paths=("A", "B"),
        blocks=(Block("A", ("E" if "E" in axis else "C", "D")),),
        ends=("B", *axis),
    )
