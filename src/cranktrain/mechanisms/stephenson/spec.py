"""Stephenson's link motion in the machine file, and how its link is put together."""

from functools import partial
from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from cranktrain.language import N_, Words, _
from cranktrain.mechanisms.chain.assembly import assembled
from cranktrain.mechanisms.chain.steps import NO_START, Coordinates, Structure
from cranktrain.mechanisms.chain.triads import triad_at
from cranktrain.mechanisms.spec import Master, MechanismSpec
from cranktrain.mechanisms.stephenson.kinematics import CURVED, STRAIGHT, Stephenson, stephenson_size
from cranktrain.mechanisms.valve_gear import Admission, Notch, set_ahead
from cranktrain.motion import Array, single
from cranktrain.numerics.designs import over_designs
from cranktrain.quantities import Angle, Given, Length, PositiveLength, TurnedAngle


class StephensonSpec(MechanismSpec, frozen=True):
    """Stephenson's link motion: two eccentrics, a link hung from the reverse shaft's arm, the valve on its line."""

    elsewhere: ClassVar = {
        **MechanismSpec.elsewhere,
        **dict.fromkeys(("lap", "lead"), "angle_of_advance: sin(angle_of_advance) = (lap + lead) / eccentricity"),
        **dict.fromkeys(("advance", "delta"), "angle_of_advance"),
        **dict.fromkeys(("throw", "r", "crank_radius"), "eccentricity"),
    }

    kind: Literal["stephenson"]
    notch: Notch = Field(
        default=Given(1.0, "1"), description=N_("Of the reverser: 1 full gear ahead, 0 mid gear, −1 full gear astern.")
    )
    eccentricity: PositiveLength = Field(description=N_("From shaft centre to the centre of either eccentric."))
    angle_of_advance: Angle = Field(
        description=N_("How far either eccentric stands beyond the right angle to the crank.")
    )
    admission: Admission = Field(default="outside", description=N_("Past the valve's outer edges or its inner ones."))
    rods: Literal["open", "crossed"] = Field(
        default="open", description=N_("Open, if they do not cross while the eccentrics face the link, or crossed.")
    )
    eccentric_rod_length: PositiveLength = Field(description=N_("Of both eccentric rods, to their joints on the link."))
    pin_spacing: PositiveLength = Field(description=N_("Between the joints of the eccentric rods on the link."))
    pin_setback: Length = Field(
        default=Given(0.0, "0 mm"),
        description=N_("Of the line of these joints from the middle of the slot, toward the shaft."),
    )
    link_radius: PositiveLength | None = Field(
        default=None, description=N_("Of the slot, about a centre toward the shaft; unless given, it is straight.")
    )
    saddle_setback: Length = Field(
        default=Given(0.0, "0 mm"),
        description=N_("Of the lifting link's joint from the middle of the slot, toward the shaft."),
    )
    lifting_link_length: PositiveLength = Field(
        description=N_("From the arm of the reverse shaft to the middle of the link.")
    )
    lifting_arm_length: PositiveLength = Field(description=N_("Of the arm on the reverse shaft."))
    lifting_arm_angle: Angle = Field(description=N_("Direction of the arm at mid gear, from x toward y."))
    lifting_arm_swing: TurnedAngle = Field(description=N_("How far the arm turns from mid gear to full gear ahead."))
    reverse_shaft_x: Length = Field(description=N_("Of the reverse shaft, from the main shaft along the valve's line."))
    reverse_shaft_y: Length = Field(description=N_("Of the reverse shaft, from the main shaft toward +y."))
    offset: Length = Field(
        default=Given(0.0, "0 mm"), description=N_("Of the valve's line from the shaft, positive toward +y.")
    )


def structure_of(spec: StephensonSpec) -> Structure:
    """Give the gear's chain: its slot is an arc where it has a radius."""
    return STRAIGHT if spec.link_radius is None else CURVED


def stephenson_geometry(spec: StephensonSpec, _master: Master | None = None) -> Stephenson:
    """Geometry in SI in the notch of the file, with the link put together upright between its rods and the arm."""
    geometry = Stephenson(
        eccentricity=spec.eccentricity.array,
        ahead=set_ahead(spec.angle_of_advance.array, spec.admission),
        rod_length=spec.eccentric_rod_length.array,
        pin_spacing=spec.pin_spacing.array,
        pin_setback=spec.pin_setback.array,
        slot_arc=single(0.0) if spec.link_radius is None else spec.link_radius.array,
        saddle_setback=spec.saddle_setback.array,
        lifting_link_length=spec.lifting_link_length.array,
        reverse_shaft=Coordinates(spec.reverse_shaft_x.array, spec.reverse_shaft_y.array),
        arm_length=spec.lifting_arm_length.array,
        arm_direction=spec.lifting_arm_angle.array + spec.notch.array * spec.lifting_arm_swing.array,
        offset=spec.offset.array,
        side=single(1.0 if spec.rods == "open" else -1.0),
        start=NO_START,
    )
    return over_designs(partial(_put_together, structure_of(spec)), geometry)


def _put_together(structure: Structure, geometry: Stephenson) -> Stephenson:
    """Start the link where it stands upright."""
    size = assembled(structure, stephenson_size(structure, geometry), {"link": _upright(geometry)})
    _step, link = triad_at(structure, 0, size)
    return geometry._replace(start=link.start)


def _upright(geometry: Stephenson) -> Array:
    """Where about the link's three joints lie: across the valve's line, its saddle below or above the arm's end."""
    end = geometry.reverse_shaft.y + geometry.arm_length * np.sin(geometry.arm_direction)
    height = end + np.copysign(geometry.lifting_link_length, geometry.offset - end)
    half = 0.5 * geometry.side * geometry.pin_spacing
    across = np.array([height - half, height + half, height])
    x = np.sqrt(np.maximum(geometry.rod_length**2 - np.abs(across[:2]) ** 2, 0.0))
    saddle = np.mean(x) + geometry.pin_setback - geometry.saddle_setback
    return np.stack([np.append(x, saddle), across], axis=-1)


def stephenson_advice(_geometry: Stephenson) -> Words:
    """Say what holds the link."""
    return _(
        "eccentric rods, link and lifting link must reach each other, and the slot the valve's line; see pin_spacing, "
        "lifting_link_length, lifting_arm_angle and the place of the reverse shaft"
    )
