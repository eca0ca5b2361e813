"""Torque of all mechanisms together, and what journals pass on of it, as curves of which the largest are asked."""

from collections.abc import Sequence
from functools import partial

import numpy as np

from cranktrain.layout.shafts import Shafts
from cranktrain.motion import Array
from cranktrain.numerics.gathering import gathered
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.forces.peaks import MachineCurves
from cranktrain.questions.forces.solved_cycle import SolvedCycle, driving_torques
from cranktrain.record import record


@record
class TorqueCurves(MachineCurves):
    """Torque of the machine, the same against it, and its size in every journal.

    passed: what journals pass on, on the grid, shape (design, journal, n). [N·m]
    """

    passed: Array


def torque_curves(loaded: LoadedMachine, solved: SolvedCycle, shafts: Shafts) -> TorqueCurves:
    """Torque of all mechanisms, that against it, and its size in the journals."""
    passed = _passed_torques(solved.driving_torque, shafts)
    samples = _curves(solved.driving_torque, passed)
    of_all = np.array([-1] * samples.shape[1], dtype=np.intp)
    return TorqueCurves(of_all, samples, partial(_curves_at, loaded, shafts), passed=passed)


def _curves_at(loaded: LoadedMachine, shafts: Shafts, found: Sequence[SolvedBatch]) -> Array:
    """What `TorqueCurves` has on the grid, of mechanisms that are solved at any angles."""
    driving = driving_torques(loaded, found)
    return _curves(driving, _passed_torques(driving, shafts))


def _curves(driving: Array, passed: Array) -> Array:
    """Put the curves together of what must drive each mechanism and of what journals pass on."""
    whole = np.sum(driving, axis=1, keepdims=True)
    return np.concatenate([-whole, whole, np.abs(passed)], axis=1)


def _passed_torques(driving: Array, shafts: Shafts) -> Array:
    """Torque that every journal passes on, from what must drive each mechanism, shape (design, journal, n)."""
    rows: list[Array] = []
    for shaft, n_throws in enumerate(shafts.n_throws):
        own = shafts.shaft == shaft
        by_throw = gathered(-driving[:, own], shafts.throw[own], n_throws)
        rows.append(journal_torque(by_throw))
    return np.concatenate(rows, axis=1)


def journal_torque(throw_torque: Array) -> Array:
    """Torque that each main journal passes on, gathered from the free end toward the flywheel.

    Parameters
    ----------
    throw_torque : Array, shape (..., throw, n)
        Torque of each throw's pistons, throw 1 at the free end. [N·m]

    Returns
    -------
    Array, shape (..., throw + 1, n)
        Journal 0 stands before throw 1, the last one at the flywheel, where all of it comes out. [N·m]

    Notes
    -----
    The shaft is rigid and turns evenly: its own inertia takes no part. docs/theory/harmonics-and-orders, eq. (15.13).
    """
    return np.concatenate([np.zeros_like(throw_torque[..., :1, :]), np.cumsum(throw_torque, axis=-2)], axis=-2)
