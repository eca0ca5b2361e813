"""Forces of loads over time: what a press presses in its stroke."""

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.loads import LinkLoad, Loads
from cranktrain.motion import Array
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.start.record import StartCurves
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _FORCES
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult


@record
class StartForces(StageResult):
    """Forces of loads over time."""

    force_of_load: Array = quantity(
        "F_l",
        "N",
        ("load", "time"),
        N_("Force of each load, as its law has it at the crank's angle and speed"),
        _FORCES,
        "13.52",
    )


def start_forces(curves: StartCurves, loaded: LoadedMachine, loads: Loads, crank_angle: CrankAngle) -> StartForces:
    """Forces that the loads on links have at the crank angles and speeds of a run; docs/theory/forces, eq. (13.52)."""
    forces = _forces(loads)
    angle = curves.crank_angle_turned + crank_angle.zero
    speed = curves.crank_speed[np.newaxis, np.newaxis]
    ways = loaded.load_ways(forces, angle)
    each = [loaded.load_value(load, way, angle, speed)[0, 0] for load, way in zip(forces, ways, strict=True)]
    return StartForces(labels={"load": tuple(load.name for load in forces)}, force_of_load=np.stack(each))


def have_forces(loads: Loads) -> bool:
    """Whether any load on a link is a force."""
    return bool(_forces(loads))


def _forces(loads: Loads) -> list[LinkLoad]:
    return [load for load in loads.each if not load.is_torque]
