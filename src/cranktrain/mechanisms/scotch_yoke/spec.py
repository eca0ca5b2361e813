"""The scotch yoke's table of the machine file."""

from collections.abc import Iterator
from math import pi, sin
from typing import Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, Words, _
from cranktrain.mechanisms.scotch_yoke.kinematics import ScotchYoke
from cranktrain.mechanisms.spec import Master, MechanismSpec
from cranktrain.quantities import Angle, Given, Length, PositiveLength

_LEAST_SINE = 1e-3


class ScotchYokeSpec(MechanismSpec, frozen=True):
    """Crank by its radius, line of stroke by its offset, slot by its angle from the line of stroke."""

    kind: Literal["scotch_yoke"]
    crank_radius: PositiveLength = Field(description=N_("From shaft centre to crank pin."))
    offset: Length = Field(
        default=Given(0.0, "0 mm"),
        description=N_(
            "Of the line of stroke from the shaft, positive toward +y: 90° ahead of the stroke's direction."
        ),
    )
    slot_angle: Angle = Field(
        default=Given(pi / 2, "90 deg"),
        description=N_("From the line of stroke to the slot, in the sense of rotation."),
    )

    def _problems(self) -> Iterator[Problem]:
        """Find a slot along the guide, where the slider would run away."""
        if abs(sin(self.slot_angle.si)) < _LEAST_SINE:
            yield Problem("slot_angle", None, _("must not lie along the line of stroke: 90 deg is across it"))


def scotch_yoke_geometry(spec: ScotchYokeSpec, _master: Master | None = None) -> ScotchYoke:
    """Lengths and angle in SI."""
    return ScotchYoke(spec.crank_radius.array, spec.offset.array, spec.slot_angle.array)


def scotch_yoke_advice(_geometry: ScotchYoke) -> Words:
    """Say what would let it close."""
    return _("slot_angle must not lie along the line of stroke: 90 deg is across it")
