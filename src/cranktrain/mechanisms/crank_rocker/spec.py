"""The crank-rocker's table of the machine file."""

from collections.abc import Iterator
from typing import Literal

from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, Words, _
from cranktrain.mechanisms.change_points import NOT_CROSSED, Form, FourBar, form_of
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker
from cranktrain.mechanisms.spec import Master, MechanismSpec
from cranktrain.motion import Array, single
from cranktrain.quantities import PositiveLength
from cranktrain.saying.wording import as_limit

_SIDES = {"left": 1.0, "right": -1.0}


class CrankRockerSpec(MechanismSpec, frozen=True):
    """Four lengths, and the side of the line from crank pin to rocker pivot on which the joint lies.

    load_radius is the radius about the rocker's pivot at which the load is carried, such as the horsehead of a beam
    pumping unit: with it the travel of the load is known. load_direction says whether the load's travel counts with the
    rocker's angle, which grows in the normal sense of rotation, or against it.
    """

    kind: Literal["crank_rocker"]
    crank_radius: PositiveLength = Field(description=N_("From shaft centre to crank pin."))
    rod_length: PositiveLength = Field(description=N_("From crank pin to the joint of rod and rocker."))
    rocker_length: PositiveLength = Field(description=N_("From the rocker's pivot to its joint with the rod."))
    ground_length: PositiveLength = Field(description=N_("From shaft centre to the rocker's pivot."))
    side: Literal["left", "right"] = Field(
        default="left",
        description=N_("Of the line from crank pin to pivot, on which the joint lies, seen in the sense of rotation."),
    )
    crossed: bool = Field(
        default=False,
        description=N_(
            "Whether a linkage of a parallelogram's lengths is the crossed one, whose rocker turns against the crank."
        ),
    )
    load_radius: PositiveLength | None = Field(
        default=None,
        description=N_("About the pivot, at which the load is carried; with it, its travel and the torque factor."),
    )
    load_direction: Literal["with", "against"] = Field(
        default="with", description=N_("Whether the load's travel counts with the rocker's angle or against it.")
    )

    def _problems(self) -> Iterator[Problem]:
        """Refuse what would be crossed and is no parallelogram."""
        if self.crossed and not crank_rocker_form(self):
            yield Problem("crossed", "true", _(NOT_CROSSED))

    @property
    def load_arm(self) -> Array | None:
        """Radius about the pivot at which the load is carried, negative against the rocker's angle. [m]"""
        if self.load_radius is None:
            return None
        return self.load_radius.array if self.load_direction == "with" else -self.load_radius.array


def crank_rocker_form(spec: CrankRockerSpec) -> Form:
    """Form in which the links pass change points; nothing where they pass none."""
    lengths = (spec.crank_radius, spec.rod_length, spec.rocker_length, spec.ground_length)
    return form_of(FourBar(*(length.array for length in lengths)), spec.crossed)


def crank_rocker_geometry(spec: CrankRockerSpec, _master: Master | None = None) -> CrankRocker:
    """Lengths in SI and the side as a sign."""
    return CrankRocker(
        spec.crank_radius.array,
        spec.rod_length.array,
        spec.rocker_length.array,
        spec.ground_length.array,
        single(_SIDES[spec.side]),
    )


def crank_rocker_advice(geometry: CrankRocker) -> Words:
    """Say how long the rod must be for the crank to turn, if any rod lets it."""
    farthest = geometry.ground_length + geometry.crank_radius
    nearest = abs(geometry.ground_length - geometry.crank_radius)
    least = max(farthest - geometry.rocker_length, geometry.rocker_length - nearest)
    most = geometry.rocker_length + nearest
    if least >= most and geometry.rocker_length == geometry.crank_radius:
        return _("rod_length must be {least}, for a parallelogram", least=as_limit(float(geometry.ground_length)))
    if least >= most and geometry.rocker_length == geometry.ground_length:
        return _("rod_length must be {least}, for a kite", least=as_limit(float(geometry.crank_radius)))
    if geometry.crank_radius == geometry.ground_length:
        return _(
            "with ground_length = crank_radius the crank turns all round only where rod_length = rocker_length, and "
            "the links come back after two turns of it, not one (Galloway's linkage); this version knows no such period"
        )
    if least >= most:
        return _("no rod_length lets the crank turn: the crank or the ground must be the shortest link")
    return _("rod_length must lie between {least} and {most}", least=as_limit(float(least)), most=as_limit(float(most)))
