"""What gear and belt stages between motor and crank ask of it: losses by the sign of the torque passed on."""

from typing import NamedTuple, TypeAlias

import numpy as np

from cranktrain.motion import Array, chosen

UNIQUE, NONE, SEVERAL = 0, 1, 2
"""How many accelerations satisfy the law: one; none; more than one, as in irreversible gearing that jams."""


class Gearing(NamedTuple):
    """Stages from motor to crank, in this order; each number of one stage stands in an array of shape (stage,).

    Attributes
    ----------
    motor_inertia : float
        Of all that turns with the motor. [kg·m²]
    ratio : Array
        Speed before a stage over that behind it, above 0. [1]
    forward, backward : Array
        Efficiency while power flows toward the crank, and back from it; the latter is below 0 in irreversible
        gearing, which must be driven even by a load that drives. [1]
    drag : Array
        Torque that a stage takes at its own input whatever it passes on. [N·m]
    inertia : Array
        Of what turns behind a stage; of the last one, what turns with the crank. [kg·m²]
    """

    motor_inertia: float
    ratio: Array
    forward: Array
    backward: Array
    drag: Array
    inertia: Array


Solved: TypeAlias = tuple[float, float, int]
"""Acceleration of the crank [rad/s²], torque that losses take at the crank [N·m], and which of `UNIQUE`, …"""


def with_inertia(gearing: Gearing, shaft: int, inertia: float) -> Gearing:
    """Gearing with something more on a shaft, 0 the motor's, n that behind stage n. [kg·m²]"""
    if shaft == 0:
        return gearing._replace(motor_inertia=gearing.motor_inertia + inertia)
    return gearing._replace(inertia=gearing.inertia + inertia * (np.arange(gearing.ratio.size) == shaft - 1))


def stages(motor_inertia: float, *each: tuple[float, float, float, float, float]) -> Gearing:
    """Gearing of stages given as (ratio, forward, backward, drag, inertia) each; none is a motor on the crank itself.

    Examples
    --------
    >>> one = stages(0.02, (40.0, 0.846, 2 - 1 / 0.846, 0.0, 0.0))
    >>> round(float(acceleration(100.0, 1.0, 18.0, 500.0, one)[0]), 5)
    63.98651
    """
    columns = np.array(each, dtype=float).reshape(-1, 5).T.copy()
    return Gearing(float(motor_inertia), columns[0], columns[1], columns[2], columns[3], columns[4])


def equal_friction(forward: Array) -> Array:
    """Efficiency backward of a stage that loses as much work by friction as forward, 2 − 1/η. [1]"""
    return 2 - 1 / forward


def worm_efficiencies(lead: Array, friction: Array) -> tuple[Array, Array]:
    """Efficiency of a worm that drives its wheel, and of one that is driven by it, by lead and friction angle. [rad]

    Notes
    -----
    tan λ/tan(λ + ϱ) and tan(λ − ϱ)/tan λ; docs/theory/transient, eq. (26.3). Below 0 it holds by itself.
    """
    return np.tan(lead) / np.tan(lead + friction), np.tan(lead - friction) / np.tan(lead)


def input_torque(output: Array, sense: Array, ratio: Array, forward: Array, backward: Array) -> Array:
    """Torque at a stage's input for one at its output, load and inertia behind it together.

    Parameters
    ----------
    output : Array
        [N·m]
    sense : Array
        Sign of the speed.
    ratio, forward, backward : Array
        As of `Gearing`; all of shapes that broadcast.

    Returns
    -------
    Array
        g(x). [N·m] docs/theory/transient, eq. (26.1).
    """
    return output / ratio * chosen(output * sense > 0, 1 / forward, backward)


def one_stage_acceleration(torque: Array, sense: Array, inertia: Array, load: Array, gearing: Gearing) -> Array:
    """Acceleration of a crank behind one stage, of arrays that broadcast: exact, without iteration.

    Parameters
    ----------
    torque : Array
        Of the motor. [N·m]
    sense : Array
        Sign of the speed.
    inertia : Array
        Reduced to the crank, without the motor's. [kg·m²]
    load : Array
        Torque that load and ½J′ω² take at the crank. [N·m]
    gearing : Gearing
        Of one stage without drag, with A + η_b J > 0.

    Returns
    -------
    Array
        [rad/s²] docs/theory/transient, eq. (26.4).
    """
    ratio, whole = gearing.ratio[0], inertia + gearing.inertia[0]
    motor, driving = gearing.motor_inertia * ratio * ratio, ratio * torque
    transmitted = whole * driving + motor * load
    factor = chosen(transmitted * sense > 0, 1 / gearing.forward[0], gearing.backward[0])
    return (driving - factor * load) / (motor + factor * whole)


def acceleration(torque: float, sense: float, inertia: float, load: float, gearing: Gearing) -> Solved:
    """Acceleration of a crank behind any number of stages, and what is lost: the pattern of signs that fits itself.

    Parameters
    ----------
    torque : float
        Of the motor. [N·m]
    sense : float
        Sign of the speed; of a crank at rest that of the motion asked about.
    inertia : float
        Reduced to the crank, without what `gearing` has. [kg·m²]
    load : float
        Torque that load and ½J′ω² take at the crank. [N·m]
    gearing : Gearing

    Returns
    -------
    Solved
        With an acceleration of NaN where none or several satisfy the law.

    Notes
    -----
    docs/theory/transient, eqs. (26.5) and (26.6). A kernel for numbers; it compiles.
    """
    found, lost, n_found = np.nan, np.nan, 0
    is_simple = True
    for back in gearing.backward:
        is_simple = is_simple and back > 0
    for pattern in range(1 << len(gearing.ratio)):
        slope, level = _by_pattern(pattern, sense, inertia, load, gearing)
        trial = (torque - level) / slope
        fits, taken = _checked(pattern, trial, sense, inertia, load, gearing)
        if fits and (n_found == 0 or abs(trial - found) > 1e-12 * abs(found)):
            found, lost = trial, taken
            n_found += 1
            if is_simple:
                break
    if n_found == 1:
        return found, lost, UNIQUE
    if n_found == 0:
        return np.nan, np.nan, NONE
    return np.nan, np.nan, SEVERAL


def accelerations(torque: float, sense: float, inertia: float, load: float, gearing: Gearing) -> list[float]:
    """All accelerations that satisfy the law, the greatest first: none, one or two. [rad/s²]"""
    found: list[float] = []
    for pattern in range(1 << len(gearing.ratio)):
        slope, level = _by_pattern(pattern, sense, inertia, load, gearing)
        trial = (torque - level) / slope
        if _checked(pattern, trial, sense, inertia, load, gearing)[0] and trial not in found:
            found.append(float(trial))
    return sorted(found, reverse=True)


def always_moves(inertia: Array, gearing: Gearing) -> bool:
    """Whether the law has one solution whatever the torques: no pattern of signs has a slope of 0 or below.

    A crank's inertia changes over a turn; an irreversible stage with a small motor may be well only on a part of it.
    """
    worst = np.inf
    for whole in np.ravel(inertia):
        for pattern in range(1 << len(gearing.ratio)):
            worst = min(worst, _by_pattern(pattern, 1.0, float(whole), 0.0, gearing)[0])
    return bool(worst > 0)


def _factor(pattern: int, stage: int, gearing: Gearing) -> float:
    return gearing.backward[stage] if pattern >> stage & 1 else 1.0 / gearing.forward[stage]


def _by_pattern(pattern: int, sense: float, inertia: float, load: float, gearing: Gearing) -> tuple[float, float]:
    """Motor torque as a line over the acceleration, slope and level, for one pattern of signs."""
    n = len(gearing.ratio)
    slope, level, overall = inertia, load, 1.0
    for stage in range(n - 1, -1, -1):
        # what turns behind a stage belongs to what the stage passes on
        slope += gearing.inertia[stage] * overall
        part = _factor(pattern, stage, gearing) / gearing.ratio[stage]
        slope *= part
        level = level * part + gearing.drag[stage] * sense
        overall *= gearing.ratio[stage]
    return slope + gearing.motor_inertia * overall, level


def _checked(
    pattern: int, trial: float, sense: float, inertia: float, load: float, gearing: Gearing
) -> tuple[bool, float]:
    """Whether each stage passes on a torque of the sign that was supposed, and the losses at the crank."""
    n = len(gearing.ratio)
    output, overall, lost = inertia * trial + load, 1.0, 0.0
    fits = True
    for stage in range(n - 1, -1, -1):
        output += gearing.inertia[stage] * overall * trial
        flow = output * sense
        fits = fits and (flow <= 0 if pattern >> stage & 1 else flow >= 0)
        part = _factor(pattern, stage, gearing)
        lost += (part - 1.0) * output * overall
        output = output * part / gearing.ratio[stage] + gearing.drag[stage] * sense
        overall *= gearing.ratio[stage]
        lost += gearing.drag[stage] * sense * overall
    return fits, lost


def overall_ratio(gearing: Gearing) -> float:
    """Speed of the motor over that of the crank. [1]"""
    overall = 1.0
    for ratio in gearing.ratio:
        overall *= ratio
    return overall


def turning_inertia(gearing: Gearing) -> float:
    """Of motor and stages, reduced to the crank by their energy. [kg·m²]"""
    total, overall = 0.0, 1.0
    for stage in range(len(gearing.ratio) - 1, -1, -1):
        total += gearing.inertia[stage] * overall * overall
        overall *= gearing.ratio[stage]
    return total + gearing.motor_inertia * overall * overall
