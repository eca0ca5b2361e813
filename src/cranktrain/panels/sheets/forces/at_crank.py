"""What the crank of a mechanism without a piston's forces needs: torque against loads and changing inertia, and J."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.panels.design import OneDesign, closed
from cranktrain.panels.shapes import Curve, Panel, peak
from cranktrain.questions.forces.loaded_machine import LoadedMachine

_NOTHING = 1e-9
"""Of the largest torque: less is rounding."""


class CrankTorques(NamedTuple):
    """What must be put into the crank over the cycle, shape (n,): to hold the loads; ½J′ω², as inertia changes. [N·m]

    A torque that is rounding alone is 0.
    """

    static: Array
    changing: Array


def crank_torques(shown: OneDesign) -> CrankTorques:
    """Split the driving torque of a machine, less what speeds the crank up, Jε.

    What holds the loads is as at the declared speed, of loads and friction that go with it, too.

    Notes
    -----
    M = M_st + Jε + ½J′ω². docs/theory/forces, eq. (13.7).
    """
    result = shown.result
    crank = result[LoadedMachine].speed.drive(result.grid.angle)
    speed, acceleration = (part[min(shown.design, len(part) - 1), 0] for part in crank)
    inertia, slope, driving = (shown(name) for name in ("reduced_inertia", "reduced_inertia_slope", "driving_torque"))
    changing = 0.5 * slope * speed**2
    held = driving - inertia * acceleration - changing
    least = _NOTHING * max(map(peak, (held, changing, driving)))
    return CrankTorques(*(one if peak(one) > least else np.zeros(one.shape) for one in (held, changing)))


def crank_panels(shown: OneDesign) -> Iterator[Panel]:
    """Collect the curves over the crank angle: torque that the crank needs; reduced inertia and its slope."""
    torques = crank_torques(shown)
    curves = (
        Curve(closed(torques.static), "whole", "T", "M_{st}"),
        Curve(closed(torques.changing), "carried", "j", r"½J′\omega^2"),
    )
    drawn = tuple(curve for curve in curves if np.any(curve.values))
    if drawn:
        yield Panel(_("Torque that the crank needs"), "N*m", shown.cycle, drawn)
    if np.any(shown("reduced_inertia")):
        inertia = Curve(closed(shown("reduced_inertia")), "main", "s", "J")
        slope = Curve(closed(shown("reduced_inertia_slope")), "side", "v", "J′")
        yield Panel(_("Reduced inertia, and its slope by the angle"), "kg*m^2", shown.cycle, (inertia, slope))
