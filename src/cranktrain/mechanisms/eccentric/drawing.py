"""The eccentric, to be drawn."""

from cranktrain.mechanisms.drawing import Drawing
from cranktrain.mechanisms.eccentric.kinematics import Eccentric
from cranktrain.mechanisms.slider_crank.drawing import slider_crank_drawing
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank
from cranktrain.motion import Array


def eccentric_drawing(angle: Array, geometry: Eccentric) -> Drawing:
    """Positions of shaft, eccentric's centre and valve at each angle, shape (..., n), and what joins them."""
    return slider_crank_drawing(angle + geometry.ahead, SliderCrank(*geometry[:3]))
