"""Walschaerts' gear in the machine file, and how its combination lever is put together."""

from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from cranktrain.language import N_, Words, _
from cranktrain.mechanisms.chain.assembly import assembled
from cranktrain.mechanisms.chain.steps import NO_START, Coordinates
from cranktrain.mechanisms.chain.triads import triad_at
from cranktrain.mechanisms.spec import Master, MechanismSpec
from cranktrain.mechanisms.valve_gear import Admission, Notch, set_ahead
from cranktrain.mechanisms.walschaerts.kinematics import STRUCTURE, Walschaerts, upright, walschaerts_size
from cranktrain.numerics.designs import over_designs
from cranktrain.quantities import Angle, Given, Length, PositiveLength


class WalschaertsSpec(MechanismSpec, frozen=True):
    """Walschaerts' gear: a return crank rocks the link, and the crosshead of a bank adds its part by a lever."""

    elsewhere: ClassVar = {
        **MechanismSpec.elsewhere,
        **dict.fromkeys(
            ("lap", "lead"),
            "valve_pin_distance: lap + lead = crank_radius · valve_pin_distance / lever_length",
        ),
        **dict.fromkeys(("r", "crank_radius"), "eccentricity"),
    }

    kind: Literal["walschaerts"]
    crosshead: str = Field(description=N_("The bank whose crosshead, on the same throw, moves the combination lever."))
    notch: Notch = Field(
        default=Given(1.0, "1"), description=N_("Of the reverser: 1 full gear ahead, 0 mid gear, −1 full gear astern.")
    )
    admission: Admission = Field(default="inside", description=N_("Past the valve's inner edges or its outer ones."))
    eccentricity: PositiveLength = Field(description=N_("From shaft centre to the return crank's pin."))
    eccentric_advance: Angle = Field(
        default=Given(0.0, "0 deg"),
        description=N_("How far the return crank stands ahead of the right angle to the main crank."),
    )
    eccentric_rod_length: PositiveLength = Field(
        description=N_("From the return crank's pin to its joint on the link.")
    )
    trunnion_x: Length = Field(description=N_("Of the link's trunnion, from the shaft along the valve's line."))
    trunnion_y: Length = Field(description=N_("Of the link's trunnion, from the shaft toward +y."))
    foot_distance: PositiveLength = Field(
        description=N_("From the trunnion, along the link, to the eccentric rod's joint.")
    )
    foot_setback: Length = Field(
        default=Given(0.0, "0 mm"), description=N_("Of that joint from the link, toward the shaft.")
    )
    full_gear_die: PositiveLength = Field(
        description=N_("From the trunnion to the block in full gear ahead, toward the foot.")
    )
    radius_rod_length: PositiveLength = Field(
        description=N_("From the block to the combination lever; the radius of the link's slot, too.")
    )
    lever_length: PositiveLength = Field(
        description=N_("Of the combination lever, from the radius rod's pin to the union link's.")
    )
    valve_pin_distance: PositiveLength = Field(
        description=N_("On the combination lever, from the radius rod's pin to the valve's.")
    )
    union_link_length: PositiveLength = Field(description=N_("From the crosshead's drop arm to the combination lever."))
    drop_x: Length = Field(
        default=Given(0.0, "0 mm"),
        description=N_("Of the union link's pin on the crosshead, from the crosshead's pin along the cylinder."),
    )
    drop_y: Length = Field(
        description=N_("Of the union link's pin on the crosshead, from the crosshead's pin toward +y.")
    )
    offset: Length = Field(
        default=Given(0.0, "0 mm"), description=N_("Of the valve's line from the shaft, positive toward +y.")
    )

    master_field: ClassVar[str | None] = "crosshead"


def walschaerts_geometry(spec: WalschaertsSpec, master: Master | None) -> Walschaerts:
    """Geometry in SI in the notch of the file, with the combination lever put together across the valve's line."""
    assert master is not None  # the layout finds the crosshead or refuses the machine
    valve_pin = spec.valve_pin_distance.array
    geometry = Walschaerts(
        master=master.geometry,
        bank_angle=master.bank_angle,
        eccentricity=spec.eccentricity.array,
        ahead=set_ahead(spec.eccentric_advance.array, spec.admission),
        rod_length=spec.eccentric_rod_length.array,
        trunnion=Coordinates(spec.trunnion_x.array, spec.trunnion_y.array),
        foot=spec.foot_distance.array,
        foot_setback=spec.foot_setback.array,
        die=spec.notch.array * spec.full_gear_die.array,
        radius_rod_length=spec.radius_rod_length.array,
        lever_length=spec.lever_length.array,
        valve_pin=valve_pin if spec.admission == "inside" else -valve_pin,
        union_link_length=spec.union_link_length.array,
        drop=Coordinates(spec.drop_x.array, spec.drop_y.array),
        offset=spec.offset.array,
        side=-np.copysign(1.0, spec.trunnion_y.array),
        start=NO_START,
    )
    return over_designs(_put_together, geometry)


def _put_together(geometry: Walschaerts) -> Walschaerts:
    """Start the combination lever where it stands across the valve's line."""
    size = assembled(STRUCTURE, walschaerts_size(geometry), {"combination_lever": upright(geometry)})
    _step, lever = triad_at(STRUCTURE, -1, size)
    return geometry._replace(start=lever.start)


def walschaerts_advice(_geometry: Walschaerts) -> Words:
    """Say what holds the lever."""
    return _(
        "eccentric rod and link must reach each other, radius rod and union link the lever; see trunnion_x, "
        "trunnion_y, foot_distance, radius_rod_length, lever_length, union_link_length and drop_y"
    )
