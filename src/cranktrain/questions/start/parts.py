"""How a run begins and ends, as machines declare it."""

from typing import ClassVar

from cranktrain.layout.drive.table import StartSpec
from cranktrain.record import record


@record
class DeclaredStart:
    """How a run begins and ends, as the table of the first design says."""

    reads: ClassVar[tuple[str, ...]] = ("[drive.start]",)

    spec: StartSpec
