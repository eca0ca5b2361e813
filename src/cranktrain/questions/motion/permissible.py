"""The pressure angle that a machine's rods are permitted, and by how much they exceed it."""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from cranktrain.language import _
from cranktrain.layout.design import Designs
from cranktrain.motion import Array
from cranktrain.numerics import Extreme
from cranktrain.numerics.ties import first_largest
from cranktrain.record import record
from cranktrain.wording import around_turn, number

_ROUNDING = 1e-9
"""A rod that was made for its limit may miss it by this part."""


@record
class PermissibleAngles:
    """Permissible pressure angle of every piston's rod, shape (design, piston); NaN for one without a limit. [rad]"""

    reads: ClassVar[tuple[str, ...]] = ("[mechanism]",)

    value: Array


def permissible_angles_of(designs: Designs) -> PermissibleAngles | None:
    """Collect the limits; None where there is none at all."""
    limits = [place.spec.pressure_angle_limit for place in designs.together.pistons]
    value = designs.by_design([np.nan if limit is None else limit.array for limit in limits])
    return None if np.all(np.isnan(value)) else PermissibleAngles(value)


def exceeding(permissible: PermissibleAngles, largest: Extreme) -> Iterator[str]:
    """Flag the rod whose pressure angle exceeds its limit the most, and where it does; of all designs the worst."""
    angle = np.abs(largest.value)
    excess = np.where(angle > permissible.value * (1 + _ROUNDING), angle - permissible.value, 0.0)
    if not np.any(excess > 0.0):
        return
    worst = np.unravel_index(first_largest(excess), excess.shape)
    said = _("The rod's pressure angle comes to {angle} (crank at {crank}), {excess} over the permissible {limit}.")
    yield said.format(
        angle=number(float(angle[worst]), "deg"),
        crank=number(float(around_turn(largest.angle[worst])), "deg"),
        excess=number(float(excess[worst]), "deg"),
        limit=number(float(permissible.value[worst]), "deg"),
    )
