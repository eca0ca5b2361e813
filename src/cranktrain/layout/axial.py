"""Places along the shaft: where each mechanism stands between throw 1 and the flywheel."""

from collections.abc import Mapping, Sequence
from typing import ClassVar

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.specs import MAIN, ShaftSpec
from cranktrain.motion import Array
from cranktrain.record import record


@record
class AxialPlaces:
    """Distance of every mechanism from throw 1 along Z, shape (design, mechanism). [m]

    mid_plane, shape (design,), lies halfway between the first and the last throw of `main`: z̄, about which couples
    count. [m]
    """

    needs: ClassVar[str] = N_("[shaft.main] spacing")

    value: Array
    mid_plane: Array


def axial_places_of(
    shafts: Sequence[Mapping[str, ShaftSpec]], designs: Sequence[Sequence[PlacedMechanism]]
) -> AxialPlaces | None:
    """Add up the gaps between throws, and the banks' stagger; None where several throws have no spacing."""
    throws = [{name: throw_positions(shaft) for name, shaft in design.items()} for design in shafts]
    if any(along is None for positions in throws for along in positions.values()):
        return None
    return AxialPlaces(
        np.array(
            [
                [
                    along[place.throw] + place.stagger
                    for place in design
                    if (along := positions[place.shaft]) is not None
                ]
                for positions, design in zip(throws, designs, strict=True)
            ]
        ),
        np.array([0.0 if (along := positions[MAIN]) is None else along[-1] / 2 for positions in throws]),
    )


def throw_positions(shaft: ShaftSpec) -> Array | None:
    """Distance of every throw from throw 1, shape (throw,); None where it is not given. [m]"""
    n_gaps = len(shaft.throws) - 1
    if n_gaps == 0:
        return np.zeros(1)
    if shaft.spacing is None:
        return None
    gaps = [gap.si for gap in shaft.spacing]
    return np.cumsum([0.0, *(gaps * n_gaps if len(gaps) == 1 else gaps)])
