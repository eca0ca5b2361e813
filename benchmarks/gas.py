"""Gas in a cylinder: volume and pressure of the ideal four-stroke cycle over a central slider-crank."""

import by_hand
import loops
import numpy as np
from comparison import Comparison, filled

from cranktrain.fluids import VolumeLimits, chamber_state
from cranktrain.fluids.dual import IdealCycle, ideal_pressure
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.motion import Coefficient

CRANK_RADIUS, ROD_LENGTH, AREA, CLEARANCE = 0.04, 0.14, 0.005, 3e-5
CYCLE = IdealCycle(1.2e5, 1.2e5, 1.1e5, 1.36, 1.25, 1.55, 1.45)


def ideal_gas(angles):
    """Volume and pressure by the kernels."""
    slider = slider_crank(angles, SliderCrank(CRANK_RADIUS, ROD_LENGTH, 0.0)).slider
    below = CRANK_RADIUS + ROD_LENGTH - slider.value
    volume = Coefficient(CLEARANCE + AREA * below, -AREA * slider.first, -AREA * slider.second)
    limits = VolumeLimits(CLEARANCE, CLEARANCE + 2.0 * AREA * CRANK_RADIUS)
    return volume.value, ideal_pressure(chamber_state(volume, limits, angles, 4 * np.pi), CYCLE)


def comparisons(n):
    """With NumPy and compiled, at n angles of a cycle between which the dead centres lie."""
    angles = (np.arange(n) + 0.5) * (4 * np.pi / n)
    given = CRANK_RADIUS, ROD_LENGTH, AREA, CLEARANCE
    loop = filled(loops.ideal_gas_loop, angles, (*given, CYCLE), 2)
    loop_by_hand = filled(by_hand.ideal_gas_numba, angles, (*given, tuple(CYCLE)), 2)
    yield Comparison(
        "NumPy",
        "NumPy by hand",
        lambda: ideal_gas(angles),
        lambda: by_hand.ideal_gas_numpy(angles, *given, tuple(CYCLE)),
        list,
        list,
        3.0,
    )
    yield Comparison("compiled", "Numba by hand", loop, loop_by_hand, list, list, 3.0)
