"""What mechanisms have in common whose crank rocks or turns a guide about a fixed pivot."""

import numpy as np
from pydantic import Field

from cranktrain.language import N_
from cranktrain.linkage import CrankAndPivot, LinkPoint, point
from cranktrain.mechanisms.spec import Master, MechanismSpec
from cranktrain.motion import Array, Handed, Link, Point, chosen
from cranktrain.quantities import Given, Length, PositiveLength


class RockingGuideSpec(MechanismSpec, frozen=True):
    """Crank, pivot and the offset of the guide's line from it."""

    crank_radius: PositiveLength = Field(description=N_("From shaft centre to crank pin."))
    ground_length: PositiveLength
    offset: Length = Given(0.0, "0 mm")


def rocking_guide_geometry(spec: RockingGuideSpec, _master: Master | None = None) -> CrankAndPivot:
    """Lengths in SI."""
    radius, ground = spec.crank_radius.array, spec.ground_length.array
    return CrankAndPivot(radius, ground, spec.offset.array, chosen(ground >= radius, 1.0, -1.0))


def slot_points(guide: Link, along: Array, offset: Handed) -> tuple[Point, ...]:
    """End of a guide's line, so far along it, and, where the line lies beside the pivot, the pivot's foot on it."""
    if not np.any(offset):
        return (point(guide, LinkPoint(along, 0.0 * along)),)
    end = LinkPoint(np.hypot(along, offset), np.arctan2(offset, along))
    return point(guide, end), point(guide, LinkPoint(offset, 0.0 * offset + np.pi / 2))
