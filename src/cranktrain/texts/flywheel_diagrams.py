"""Wittenbauer's and Mertsalov's diagrams of a flywheel, as data: curves, tangents, and what is read off them."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array
from cranktrain.numerics import Extreme
from cranktrain.numerics.periodic import PeriodicCurve, combined, curve_extremes
from cranktrain.questions.evenness.excess_work import ExcessWork
from cranktrain.questions.evenness.flywheel_inertia import Flywheel
from cranktrain.record import record


class Tangent(NamedTuple):
    """Tangent of the energy–mass curve, work = slope · inertia + intercept; shapes (...).

    Attributes
    ----------
    slope : Array
        ½ω² of the speed that it stands for. [J/(kg·m²)]
    intercept : Array
        Work at inertia 0. [J]
    angle, inertia, work : Array
        Where it touches. [rad, kg·m², J]
    """

    slope: Array
    intercept: Array
    angle: Array
    inertia: Array
    work: Array


@record
class Wittenbauer:
    """Energy–mass diagram: A over J_v through the cycle, and the two tangents that meet in its origin.

    Attributes
    ----------
    inertia, work : Array, shape (..., n)
        J_v and A on the grid; the curve closes. [kg·m², J]
    upper, lower : Tangent
        At the slopes of the largest and the smallest speed: one leaves the curve wholly below, the other above itself.
    origin_inertia, origin_work : Array, shape (...)
        Where the tangents meet: −J_f and −E₀. [kg·m², J]
    """

    inertia: Array
    work: Array
    upper: Tangent
    lower: Tangent
    origin_inertia: Array
    origin_work: Array


@record
class Mertsalov:
    """Mertsalov's diagram: the energy that the flywheel has to take up.

    Attributes
    ----------
    angle : Array, shape (n,)
        [rad]
    work : Array, shape (..., n)
        A. [J]
    carried_energy : Array, shape (..., n)
        ½ω_a² J_v, of the moving parts at the mean speed. [J]
    flywheel_energy : Array, shape (..., n)
        Their difference, A − ½ω_a² J_v. [J]
    smallest, largest : Extreme, shapes (..., 1)
        Of the difference, refined. [rad, J]
    """

    angle: Array
    work: Array
    carried_energy: Array
    flywheel_energy: Array
    smallest: Extreme
    largest: Extreme


def wittenbauer(excess: ExcessWork, inertia: PeriodicCurve, flywheel: Flywheel) -> Wittenbauer:
    """Wittenbauer's diagram of an exact flywheel.

    Parameters
    ----------
    excess : ExcessWork
    inertia : PeriodicCurve
        J_v(φ) of the moving parts. [kg·m²]
    flywheel : Flywheel
        Of `exact_flywheel`, with the same two.

    Returns
    -------
    Wittenbauer

    Notes
    -----
    docs/theory/evenness, eqs. (17.6) and (17.7).
    """

    def tangent(speed: Array, at: Extreme) -> Tangent:
        touched = inertia.value(at.angle)[..., 0], excess.work.value(at.angle)[..., 0]
        return Tangent(speed**2 / 2, at.value[..., 0], at.angle[..., 0], *touched)

    return Wittenbauer(
        inertia.samples,
        excess.work.samples,
        tangent(flywheel.largest_speed, flywheel.upper),
        tangent(flywheel.smallest_speed, flywheel.lower),
        -flywheel.inertia,
        -flywheel.initial_energy,
    )


def mertsalov(excess: ExcessWork, inertia: PeriodicCurve, mean_speed: Array) -> Mertsalov:
    """Mertsalov's diagram at a mean speed [rad/s] of shape (...).

    Notes
    -----
    docs/theory/evenness, eq. (17.9).
    """
    half_square = np.asarray(mean_speed, dtype=float) ** 2 / 2
    work, carried = excess.work.samples, half_square[..., np.newaxis] * inertia.samples
    found = curve_extremes(combined(excess.work, -half_square, inertia))
    return Mertsalov(excess.work.angle, work, carried, work - carried, found.smallest, found.largest)
