"""The slider-crank, to be drawn."""

from cranktrain.mechanisms.drawing import Drawing, DrawnLink, Guide
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.motion import Array, Coefficient, Point, single


def slider_crank_drawing(angle: Array, geometry: SliderCrank) -> Drawing:
    """Shaft, crank pin and slider at each angle, shape (..., n), and what joins them."""
    motion = slider_crank(angle, geometry)
    still = Coefficient(0.0 * angle, 0.0 * angle, 0.0 * angle)
    height = Coefficient(geometry.offset + still.value, still.value, still.value)
    return Drawing(
        pins={"O": Point(still, still), "A": motion.pin, "B": Point(motion.slider, height)},
        links=(DrawnLink("crank", ("O", "A")), DrawnLink("rod", ("A", "B"))),
        guides=(Guide("B", single(0.0)),),
        fixed=("O",),
        paths=("A",),
    )
