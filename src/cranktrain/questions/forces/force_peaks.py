"""Largest forces in joints, along rods and at the edges of guides, looked for in windows that all of them share."""

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.guides import GuideCurves
from cranktrain.questions.forces.joint_forces import JointCurves
from cranktrain.questions.forces.largest_forces import PistonCurves
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.peaks import ForcePeaks, largest_of_each

CURVES = (JointCurves, PistonCurves, GuideCurves)


def force_peaks(
    loaded: LoadedMachine,
    events: ForceEvents,
    crank_angle: CrankAngle,
    joints: JointCurves | None,
    pistons: PistonCurves | None,
    guides: GuideCurves | None,
) -> ForcePeaks:
    """Look for the largest values of those curves that there are: only of what is asked."""
    each = [one for one in (joints, pistons, guides) if one is not None]
    found = largest_of_each(loaded, events, crank_angle, each)
    return ForcePeaks({type(one): peak for one, peak in zip(each, found, strict=True)})
