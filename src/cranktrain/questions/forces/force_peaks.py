"""Largest forces and torques: the machine is solved once, in all windows in which what is asked may be largest."""

import numpy as np

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.numerics import Peak
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.guides import GuideCurves
from cranktrain.questions.forces.joint_forces import JointCurves
from cranktrain.questions.forces.largest_forces import PistonCurves
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.peaks import ForcePeaks, MachineCurves, largest_together
from cranktrain.questions.forces.torque_curves import TorqueCurves

CURVES = (JointCurves, PistonCurves, GuideCurves, TorqueCurves)


def force_peaks(
    loaded: LoadedMachine,
    events: ForceEvents,
    crank_angle: CrankAngle,
    joints: JointCurves | None,
    pistons: PistonCurves | None,
    guides: GuideCurves | None,
    torques: TorqueCurves | None,
) -> ForcePeaks:
    """Look for the largest values of those curves that there are: only of what is asked."""
    each = [one for one in (joints, pistons, guides, torques) if one is not None]
    found = largest_together(loaded, events, crank_angle, each)
    peaks: dict[type[MachineCurves], Peak] = {type(one): peak for one, peak in zip(each, found, strict=True)}
    if np.any(loaded.unheld):
        # Of forces that go beyond all bounds none is the largest; torques have limits.
        for one in (joints, pistons, guides):
            if one is not None:
                is_beyond = loaded.unheld[:, one.rows]
                peaks[type(one)] = Peak(*(np.where(is_beyond, np.nan, part) for part in peaks[type(one)]))
    return ForcePeaks(peaks)
