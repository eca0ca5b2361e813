"""The articulated rod with its master, to be drawn in the slave cylinder's axes."""

from cranktrain.linkage import fixed, turned
from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.drawing import Drawing, DrawnLink, Guide
from cranktrain.mechanisms.slider_crank.kinematics import slider_crank
from cranktrain.motion import Array, Point, single


def articulated_rod_drawing(angle: Array, geometry: ArticulatedRod) -> Drawing:
    """Shaft, crank pin, both pistons' pins and knuckle at each angle, shape (..., n)."""
    motion = articulated_rod(angle, geometry)
    still = 0.0 * angle
    master = slider_crank(angle, geometry.master)
    master_piston = Point(master.slider, fixed(still, geometry.master.offset + still).y)
    return Drawing(
        pins={
            "O": fixed(still, still),
            "A": turned(motion.pin, geometry.bank_angle),
            "B": turned(master_piston, geometry.bank_angle),
            "C": motion.knuckle,
            "D": Point(motion.slider, fixed(still, geometry.offset + still).y),
        },
        links=(
            DrawnLink("crank", ("O", "A")),
            DrawnLink("master_rod", ("A", "B", "C")),
            DrawnLink("rod", ("C", "D")),
        ),
        guides=(Guide("D", single(0.0)), Guide("B", -geometry.bank_angle)),
        fixed=("O",),
        paths=("A", "C"),
    )
