"""The slider-crank, to be drawn."""

from cranktrain.linkage import fixed
from cranktrain.mechanisms.drawing import Drawing, DrawnLink, Guide
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.motion import Array, Point, single


def slider_crank_drawing(angle: Array, geometry: SliderCrank) -> Drawing:
    """Shaft, crank pin and slider at each angle, shape (..., n), and what joins them."""
    motion = slider_crank(angle, geometry)
    still = 0.0 * angle
    slider = Point(motion.slider, fixed(still, geometry.offset + still).y)
    return Drawing(
        pins={"O": fixed(still, still), "A": motion.pin, "B": slider},
        links=(DrawnLink("crank", ("O", "A")), DrawnLink("rod", ("A", "B"))),
        guides=(Guide("B", single(0.0)),),
        fixed=("O",),
        paths=("A",),
    )
