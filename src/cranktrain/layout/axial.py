"""Places along the shaft: where each mechanism stands between throw 1 and the flywheel."""

from collections.abc import Mapping, Sequence
from itertools import accumulate
from typing import ClassVar

from cranktrain.language import N_
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.specs import MAIN, ShaftSpec
from cranktrain.motion import ZERO, Array
from cranktrain.numerics.designs import by_design
from cranktrain.record import record


@record
class AxialPlaces:
    """Distance of every mechanism from throw 1 along Z, shape (design, mechanism). [m]

    throw is that of the middle of its throw, from which the bank's stagger sets it aside. [m]
    mid_plane, shape (design,), lies halfway between the first and the last throw of `main`: z̄, about which couples
    count. [m]
    """

    needs: ClassVar[str] = N_("[shaft.main] spacing")
    reads: ClassVar[tuple[str, ...]] = ("[bank.NAME]", "[shaft.NAME]")

    value: Array
    throw: Array
    mid_plane: Array


def axial_places_of(
    shafts: Mapping[str, ShaftSpec], places: Sequence[PlacedMechanism], n_designs: int
) -> AxialPlaces | None:
    """Add up the gaps between throws, and the banks' stagger; None where several throws have no spacing."""
    positions = {name: along for name, shaft in shafts.items() if (along := throw_positions(shaft)) is not None}
    if len(positions) < len(shafts):
        return None
    return AxialPlaces(
        by_design([positions[place.shaft][place.throw] + place.stagger for place in places], n_designs),
        by_design([positions[place.shaft][place.throw] for place in places], n_designs),
        by_design([positions[MAIN][-1] / 2], n_designs)[:, 0],
    )


def throw_positions(shaft: ShaftSpec) -> list[Array] | None:
    """Distance of every throw from throw 1; None where it is not given. [m]"""
    n_gaps = len(shaft.throws) - 1
    if n_gaps == 0:
        return [ZERO]
    if shaft.spacing is None:
        return None
    gaps = [gap.array for gap in shaft.spacing]
    return list(accumulate(gaps * n_gaps if len(gaps) == 1 else gaps, initial=ZERO))
