"""The crank-rocker, to be drawn."""

from cranktrain.linkage import fixed
from cranktrain.mechanisms.change_points import Form
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, crank_rocker
from cranktrain.mechanisms.crank_rocker.through import crank_rocker_through
from cranktrain.mechanisms.drawing import Drawing, DrawnLink
from cranktrain.motion import Array


def crank_rocker_drawing(angle: Array, geometry: CrankRocker, form: Form = "") -> Drawing:
    """Shaft, crank pin, joint and pivot at each angle, shape (..., n), and what joins them."""
    motion = crank_rocker_through(form, angle, geometry) if form else crank_rocker(angle, geometry)
    still = 0.0 * angle
    return Drawing(
        pins={
            "O": fixed(still, still),
            "A": motion.pin,
            "B": motion.joint,
            "C": fixed(still + geometry.ground_length, still),
        },
        links=(DrawnLink("crank", ("O", "A")), DrawnLink("rod", ("A", "B")), DrawnLink("rocker", ("C", "B"))),
        guides=(),
        fixed=("O", "C"),
        paths=("A", "B"),
    )
