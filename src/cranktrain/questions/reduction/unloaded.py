"""A machine that is not loaded yet: without its loads, a compressor's suction valves held open."""

import numpy as np

from cranktrain.motion import Array
from cranktrain.questions.reduction.static_torques import torque_facts
from cranktrain.transient.gearing import Gearing
from cranktrain.transient.reduced import DISCHARGE, SUCTION, ReducedMachine

_N_ANGLES = 720


def with_open_valves(machine: ReducedMachine) -> ReducedMachine:
    """A compressor whose suction valves are held open."""
    chambers = np.array(machine.chambers)
    chambers[:, DISCHARGE] = chambers[:, SUCTION]
    return machine._replace(chambers=chambers)


def without_loads(machine: ReducedMachine) -> ReducedMachine:
    """A machine on which nothing acts but its weights, and the air under its pistons.

    Loads and gas that comes back over the cycle leave it, and the friction in guides, which is mostly theirs.
    """
    return with_open_valves(machine)._replace(loads=np.asarray(machine.loads)[:0])


def starting_torques(machine: ReducedMachine, corners: Array, gearing: Gearing, cycle: float) -> tuple[float, float]:
    """Largest and mean static torque at the motor of a machine as it starts, with what loads it has then. [N·m]"""
    grid = np.arange(_N_ANGLES) * cycle / _N_ANGLES
    found = torque_facts(machine, corners, cycle, gearing, zero=0.0, grid=grid)
    return float(found.largest.value[0]), float(found.mean[0])
