"""Excess work of a torque that is given by samples."""

import numpy as np

from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.periodic import fourier_integral
from cranktrain.questions.evenness.excess_work import excess_of


def excess_work(excess, cycle=TURN, by=fourier_integral):
    """Excess work of a torque in equal steps over the cycle."""
    return excess_of(by(excess, cycle), np.mean(excess, axis=-1))
