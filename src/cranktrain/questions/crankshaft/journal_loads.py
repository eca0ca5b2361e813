"""Main journals in axes that turn with the shaft: their loads, wear of journals and bearings, places for oil holes."""

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.checks import StageResult
from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.motion import Array
from cranktrain.questions.crankshaft.acting import LoadedShaft
from cranktrain.questions.crankshaft.cycle_points import CyclePoints
from cranktrain.questions.crankshaft.parts import DeclaredCrankshaft
from cranktrain.questions.crankshaft.stages import MainBearingLoads, methods_for
from cranktrain.questions.crankshaft.turning_axes import in_turning_axes
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANKSHAFT as _THEORY

_FACT = ("bearing_method", "bearing")
_CURVE, _RAYS = (*_FACT, "crank_angle"), (*_FACT, "ray")


@record
class JournalLoads(StageResult):
    """Loads of the main bearings in axes that turn with the shaft."""

    journal_load_along: Array = quantity(
        "Q_L",
        "N",
        _CURVE,
        N_("Load of the journal on the main bearing in the direction of the crank of throw 1"),
        _THEORY,
    )
    journal_load_across: Array = quantity(
        "Q_A",
        "N",
        _CURVE,
        N_("Load of the journal on the main bearing, 90° from the crank of throw 1 in the sense of rotation"),
        _THEORY,
    )


@record
class JournalWear(StageResult):
    """Means over the cycle of what journals and main bearings do to each other, by each method."""

    journal_wear: Array = quantity(
        "W_J", "N", _RAYS, N_("Mean load on each ray of the journal, from throw 1 in the sense of rotation"), _THEORY
    )
    journal_oil_hole: Array = quantity(
        "γ_J", "rad", _FACT, N_("Place for the oil hole of the journal, from throw 1 in the sense of rotation"), _THEORY
    )
    bearing_wear: Array = quantity(
        "W_B",
        "N",
        _RAYS,
        N_("Mean load on each ray of the main bearing, from upward in the sense of rotation"),
        _THEORY,
    )
    bearing_oil_hole: Array = quantity(
        "γ_B",
        "rad",
        _FACT,
        N_("Place for the oil hole of the main bearing, from upward in the sense of rotation"),
        _THEORY,
    )


def journal_loads(
    loaded: LoadedShaft, bearings: MainBearingLoads, solved: SolvedCycle, crank_angle: CrankAngle
) -> JournalLoads:
    """Turn the loads of the main bearings into axes of the shaft.

    Notes
    -----
    docs/theory/crankshaft, eq. (24.44).
    """
    direction = _first_throw(loaded, loaded.loads(crank_angle.angle, solved.batches).turned)
    return JournalLoads(
        *in_turning_axes(bearings.main_bearing_load_x, bearings.main_bearing_load_y, direction, loaded.turn)
    )


def journal_wear(loaded: LoadedShaft, declared: DeclaredCrankshaft, points: CyclePoints) -> JournalWear:
    """Wear of journals and bearings by quadrature between events.

    Notes
    -----
    docs/theory/crankshaft, eqs. (24.46) and (24.47).
    """
    acting = loaded.loads(points.angle, points.solved)
    found = [method.loads(loaded.shaft, acting).load for method in methods_for(declared)]
    x, y = np.moveaxis(np.stack(found, axis=1), 3, 0)
    journal = points.wear(*in_turning_axes(x, y, _first_throw(loaded, acting.turned), loaded.turn))
    bearing = points.wear(y, loaded.turn * -x)
    return JournalWear(*journal, *bearing)


def _first_throw(loaded: LoadedShaft, turned: Array) -> Array:
    """Direction of the crank of throw 1, from X toward Y, shape (design, 1, 1, n). [rad]"""
    own = loaded.shaft.pieces.angle[:, 1, np.newaxis] + turned
    return own[:, np.newaxis, np.newaxis]
