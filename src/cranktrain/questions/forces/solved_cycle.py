"""Forces of every mechanism on the grid of crank angles."""

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.record import record


@record
class SolvedCycle:
    """Forces of every mechanism on the grid of crank angles; nothing that people read as it is."""

    batches: tuple[SolvedBatch, ...]


def solved_cycle(loaded: LoadedMachine, crank_angle: CrankAngle, gas: GasPressures | None) -> SolvedCycle:
    """Solve the machine on its grid; docs/theory/forces, eqs. (13.1) to (13.3)."""
    return SolvedCycle(loaded.solved(crank_angle.angle, gas_force=None if gas is None else gas.gas_force))
