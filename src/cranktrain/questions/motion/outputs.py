"""What sliders are where it is known whether they have a cylinder about them: pistons, rams, valves."""

from collections.abc import Iterator, Sequence
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.grouping import grouped
from cranktrain.layout.mechanisms import Pistons
from cranktrain.mechanisms.output import OutputPart
from cranktrain.record import record


@record
class InCylinders:
    """Says that the machine's sliders that can have a cylinder have one; without it there are none."""

    reads: ClassVar[tuple[str, ...]] = ("[cylinder]",)


def outputs_of(pistons: Pistons, cylinders: InCylinders | None) -> tuple[OutputPart, ...]:
    """What each slider is."""
    return tuple(one if cylinders is not None or one.bare is None else one.bare for one in pistons.outputs)


def members_by_output(outputs: Sequence[OutputPart]) -> Iterator[tuple[OutputPart, NDArray[np.intp]]]:
    """Which sliders are the same: those in cylinders first, those without a load last."""
    members = grouped((output, member) for member, output in enumerate(outputs))
    for output in sorted(members, key=lambda output: output.rank):
        yield output, np.array(members[output])
