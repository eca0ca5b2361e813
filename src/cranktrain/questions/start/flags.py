"""What [drive.start] says in vain, told where the machine is run over a cycle."""

from collections.abc import Iterator

from cranktrain.language import Words, _
from cranktrain.questions.gas.declared import DeclaredGas
from cranktrain.questions.start.parts import DeclaredStart
from cranktrain.record import record
from cranktrain.saying.checks import Flagged


@record
class StartFlags(Flagged):
    """Keys of [drive.start] that nothing is made of."""


def start_flags(start: DeclaredStart, gas: DeclaredGas | None) -> StartFlags:
    """Flag a pressure at the beginning that no chamber can have."""
    return StartFlags(flags=tuple(_flags(start, gas)))


def _flags(start: DeclaredStart, gas: DeclaredGas | None) -> Iterator[Words]:
    """Only a compressor's chambers begin at a pressure; other gas goes by the crank angle."""
    remembers = gas is not None and any(table.fluid.name == "compressor" for table in gas.tables)
    if "gas_pressure" in start.texts and not remembers:
        yield _('[drive.start] gas_pressure is not used: [gas] kind = "compressor" is missing.')
