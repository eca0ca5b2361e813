"""Kinematics of the articulated rod: a slave rod on a knuckle pin of the master rod, in a cylinder of its own."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage import AHEAD, Crank, LinkPoint, Slide, crank, point, slide, slide_gap, turned
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.motion import Array, Coefficient, Handed, Link, Point


class ArticulatedRod(NamedTuple):
    """The master, and the slave on it.

    knuckle_radius: crank pin to knuckle pin [m]; articulation_angle ζ: from the master rod to the knuckle radius [rad];
    bank_angle γ: from the master cylinder's axis to the slave's [rad]; rod_length, offset: of the slave, in its own
    cylinder's axes [m].
    """

    master: SliderCrank
    knuckle_radius: Array
    articulation_angle: Handed
    bank_angle: Handed
    rod_length: Array
    offset: Handed


class ArticulatedRodMotion(NamedTuple):
    """The master's crank pin and rod in the master's axes; knuckle pin, slider and rod in the slave cylinder's."""

    pin: Point
    master_rod: Link
    knuckle: Point
    slider: Coefficient
    rod: Link


def articulated_rod(angle: Array, geometry: ArticulatedRod) -> ArticulatedRodMotion:
    """Slave piston on an articulated rod, and its derivatives by the crank angle.

    Parameters
    ----------
    angle : Array, shape (..., n)
        Crank angle from the *master* cylinder's axis. [rad]
    geometry : ArticulatedRod, fields broadcastable to (..., 1)

    Returns
    -------
    ArticulatedRodMotion, shape (..., n)
        NaN where master or slave cannot close.

    Notes
    -----
    s = P + √(l² − Q²), P = R cos(α − γ) + r cos(ζ − γ − β), Q = R sin(α − γ) + r sin(ζ − γ − β). Exact;
    docs/theory/articulated-rod; (I.13) of [Bolotin] is its two-harmonic form.
    """
    master = slider_crank(angle, geometry.master)
    knuckle = turned(
        point(master.rod, LinkPoint(geometry.knuckle_radius, geometry.articulation_angle)), geometry.bank_angle
    )
    slave = slide(knuckle, Slide(geometry.rod_length, geometry.offset, AHEAD))
    return ArticulatedRodMotion(master.pin, master.rod, knuckle, slave.slider, slave.rod)


def articulated_rod_gap(angle: Array, geometry: ArticulatedRod) -> Array:
    """By how much the shorter of master and slave rod is long enough; negative where the links cannot close. [m]

    The slave has to bridge Q − e, with the Q of `articulated_rod`.
    """
    master = geometry.master
    pin = crank(angle, Crank(master.crank_radius))
    rise = master.offset - pin.y.value
    reach = np.sqrt((master.rod_length - rise) * (master.rod_length + rise))
    along = geometry.knuckle_radius / master.rod_length
    ahead = geometry.articulation_angle - geometry.bank_angle
    knuckle = along * (np.cos(ahead) * rise + np.sin(ahead) * reach)
    across = np.cos(geometry.bank_angle) * pin.y.value - np.sin(geometry.bank_angle) * pin.x.value + knuckle
    return np.fmin(
        slide_gap(pin, Slide(master.rod_length, master.offset, AHEAD)),
        geometry.rod_length - np.abs(across - geometry.offset),
    )
