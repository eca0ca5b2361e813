"""Walschaerts' valve gear: a return crank, a link about a fixed trunnion, and a combination lever on the crosshead."""

from pathlib import Path

from cranktrain.language import N_
from cranktrain.mechanisms.by_hand import Handle
from cranktrain.mechanisms.chain.composed import as_chain
from cranktrain.mechanisms.kind import Kind, Members
from cranktrain.mechanisms.output import VALVE
from cranktrain.mechanisms.walschaerts.kinematics import STRUCTURE, Walschaerts, walschaerts_size
from cranktrain.mechanisms.walschaerts.spec import WalschaertsSpec, walschaerts_advice, walschaerts_geometry

__all__ = ["KIND", "Walschaerts", "WalschaertsSpec"]

_LENGTHS = {
    "master.crank_radius": N_("crank_radius of the crosshead's bank"),
    "master.rod_length": N_("rod_length of the crosshead's bank"),
    "eccentricity": "eccentricity",
    "rod_length": "eccentric_rod_length",
    "trunnion.x": "trunnion_x",
    "trunnion.y": "trunnion_y",
    "foot": "foot_distance",
    "foot_setback": "foot_setback",
    "die": "full_gear_die",
    "radius_rod_length": "radius_rod_length",
    "lever_length": "lever_length",
    "valve_pin": "valve_pin_distance",
    "union_link_length": "union_link_length",
    "drop.x": "drop_x",
    "drop.y": "drop_y",
    "offset": "offset",
}

KIND = Kind(
    name="walschaerts",
    title=N_("Walschaerts' valve gear"),
    spec=WalschaertsSpec,
    geometry=walschaerts_geometry,
    has_rod=False,
    closing_advice=walschaerts_advice,
    closing_field="radius_rod_length",
    members=Members,
    stages=(),
    **as_chain(STRUCTURE, walschaerts_size, _LENGTHS, slider=VALVE),
    handles=(
        Handle("return.pin", ("eccentricity", "eccentric_advance")),
        Handle("trunnion", ("trunnion_x", "trunnion_y")),
    ),
    speed="280 rpm",
    tables=Path(__file__).with_name("starting.toml"),
    example="""\
[bank.cylinder]
angle = "90 deg"

[bank.cylinder.mechanism]
kind = "slider_crank"
crank_radius = "330 mm"
rod_length = "2800 mm"

[bank.valve]
angle = "90 deg"

[bank.valve.mechanism]
kind = "walschaerts"
crosshead = "cylinder"            # the bank whose crosshead, on the same throw, moves the combination lever
notch = 1                         # 1 full gear ahead, 0 mid gear, -1 full gear astern
admission = "inside"              # or "outside"
eccentricity = "160 mm"           # of the return crank's pin, from the shaft
eccentric_advance = "-5.71 deg"   # how far the return crank stands ahead of the right angle to the main crank
eccentric_rod_length = "1766 mm"
trunnion_x = "1800 mm"            # of the link, from the shaft: x away from it, y to the side that the crank turns to
trunnion_y = "-595 mm"
foot_distance = "420 mm"          # from the trunnion to the eccentric rod's joint on the link
foot_setback = "50 mm"            # of that joint from the link, toward the shaft
full_gear_die = "190 mm"          # of the block from the trunnion, toward the foot, in full gear ahead
radius_rod_length = "1440 mm"
lever_length = "850 mm"           # combination lever: from radius rod to union link
valve_pin_distance = "95 mm"      # on it, from radius rod to valve
union_link_length = "450 mm"
# drop_x = "0 mm"                 # of the union link's pin on the crosshead, from the crosshead's own
drop_y = "255 mm"
offset = "-500 mm"                # of the valve's line from the shaft, toward +y
""",
)
