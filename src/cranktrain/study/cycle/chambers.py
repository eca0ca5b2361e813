"""Events of chambers in the compiled cycle: where volumes turn and kinks are, and on which branch a panel lies."""

import numpy as np

from cranktrain.motion import Array

TURN = 2 * np.pi


def branch_at(angle: float, least: float, greatest: float, cycle: float) -> tuple[float, float]:
    """Sense and turn of a chamber at φ, by the strokes: as `chamber_state` finds them by the volume's slope."""
    after = angle - least
    after -= cycle * np.floor(after / cycle)
    opens = greatest - least
    opens -= TURN * np.floor(opens / TURN)
    within = after - TURN * np.floor(after / TURN)
    sense = 1.0 if within < opens else -1.0
    if cycle < 1.5 * TURN:
        return sense, 1.0
    # the working turn goes from the greatest volume before the least one to that after it
    return sense, 1.0 if after < opens or after > TURN + opens else -1.0


def branch_from(
    panel: int, starts: Array, widths: Array, least: float, greatest: float, cycle: float
) -> tuple[float, float, int]:
    """Sense and turn of a chamber in a panel, and which panel is the first after it on another branch."""
    sense, turn = branch_at(starts[panel] + 0.5 * widths[panel], least, greatest, cycle)
    after = panel + 1
    while after < starts.size:
        its_sense, its_turn = branch_at(starts[after] + 0.5 * widths[after], least, greatest, cycle)
        if its_sense != sense or its_turn != turn:
            break
        after += 1
    return sense, turn, after


STEPS, SETTLED, NEARLY = 30, 1e-12, 1e-5
"""Steps to a dead centre or a kink, one after which there is no other, and one of Halley's method after which the next
one, which goes by its third power, is less than rounding. [rad]"""


def nearer(away: float, sense: float, excess: float, rate: float, rate_slope: float) -> float:
    """One step of Halley's method to where a volume has a kink, by how far that is from the dead centre. [rad]"""
    move = excess / (rate - excess * rate_slope / (2.0 * rate))
    return min(max(away - sense * move, away / 4.0), np.pi)


def toward_end(sign: float, slope: float, bend: float, around: Array) -> float:
    """One step to where a slider turns back, no farther than the points that were looked at are apart. [rad]"""
    apart = around[0, 1] - around[0, 0]
    if sign * bend < 0.0:
        return min(max(-slope / bend, -apart), apart)
    return np.copysign(apart / 2.0, sign * slope)
