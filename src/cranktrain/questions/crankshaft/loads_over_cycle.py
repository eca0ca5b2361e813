"""All that acts on the crankshafts at the grid's crank angles: once for all that is asked of them there."""

from collections.abc import Sequence

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.questions.crankshaft.acting import LoadedShafts
from cranktrain.questions.crankshaft.loads_in_spans import SpannedLoads
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.record import record


@record
class LoadsOverCycle:
    """Loads on each shaft at the crank angles of the grid."""

    each: Sequence[SpannedLoads]


def loads_over_cycle(loaded: LoadedShafts, solved: SolvedCycle, crank_angle: CrankAngle) -> LoadsOverCycle:
    """Put what the solved machine does to its shafts to their places; docs/theory/crankshaft, eqs. (24.1) to (24.3)."""
    return LoadsOverCycle(loaded.loads(crank_angle.angle, solved.batches))
