"""The eccentric's table of the machine file."""

from collections.abc import Iterator
from typing import ClassVar, Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, Words, _
from cranktrain.mechanisms.eccentric.kinematics import Eccentric
from cranktrain.mechanisms.spec import Master, MechanismSpec
from cranktrain.mechanisms.valve_gear import Admission, set_ahead
from cranktrain.quantities import Angle, Given, Length, PositiveLength
from cranktrain.saying.wording import as_limit


class EccentricSpec(MechanismSpec, frozen=True):
    """One eccentric that drives a valve or a pump; set by its angle of advance, or by how far ahead it stands."""

    elsewhere: ClassVar = {
        **MechanismSpec.elsewhere,
        **dict.fromkeys(("lap", "lead"), "angle_of_advance: sin(angle_of_advance) = (lap + lead) / eccentricity"),
        **dict.fromkeys(("advance", "delta"), "angle_of_advance"),
        **dict.fromkeys(("throw", "r", "crank_radius"), "eccentricity"),
    }

    kind: Literal["eccentric"]
    eccentricity: PositiveLength = Field(description=N_("From shaft centre to the eccentric's centre."))
    rod_length: PositiveLength = Field(description=N_("Of the eccentric rod, to the valve's pin."))
    angle_of_advance: Angle | None = Field(
        default=None,
        description=N_("How far the eccentric stands beyond the right angle to the crank; or angle_ahead."),
    )
    admission: Admission = Field(
        default="outside",
        description=N_("Past the valve's outer edges, with the eccentric 90° + δ ahead, or inner ones, −90° + δ."),
    )
    angle_ahead: Angle | None = Field(
        default=None,
        description=N_("How far the eccentric stands ahead of the crank, instead of advance and admission."),
    )
    offset: Length = Field(
        default=Given(0.0, "0 mm"), description=N_("Of the valve's line from the shaft, positive toward +y.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Find an eccentric that is set twice or not at all."""
        if self.angle_of_advance is None and self.angle_ahead is None:
            yield Problem("angle_of_advance", None, _("is missing; give it, or angle_ahead"))
        if self.angle_ahead is not None:
            for name in ("angle_of_advance", "admission"):
                if name in self.model_fields_set:
                    yield Problem(name, None, _("must not stand beside angle_ahead"))


def eccentric_geometry(spec: EccentricSpec, _master: Master | None = None) -> Eccentric:
    """Geometry in SI, however the eccentric is set."""
    if spec.angle_ahead is not None:
        ahead = spec.angle_ahead.array
    else:
        assert spec.angle_of_advance is not None  # the spec asks for one of the two
        ahead = set_ahead(spec.angle_of_advance.array, spec.admission)
    return Eccentric(spec.eccentricity.array, spec.rod_length.array, spec.offset.array, ahead)


def eccentric_advice(geometry: Eccentric) -> Words:
    """Say how long the rod must be for the shaft to turn."""
    least = geometry.crank_radius + abs(geometry.offset)
    return _("rod_length must be more than eccentricity + |offset| = {least}", least=as_limit(float(least)))
