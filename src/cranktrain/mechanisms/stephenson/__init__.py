"""Stephenson's link motion: a valve gear of two eccentrics and a link that is raised and lowered."""

from functools import partial
from pathlib import Path
from typing import Any

from cranktrain.language import N_
from cranktrain.mechanisms.by_hand import Handle
from cranktrain.mechanisms.chain.composed import as_chain, kind_of_structure
from cranktrain.mechanisms.chain.steps import Structure
from cranktrain.mechanisms.kind import Kind, Members
from cranktrain.mechanisms.output import VALVE
from cranktrain.mechanisms.stephenson.drawing import stephenson_drawing
from cranktrain.mechanisms.stephenson.kinematics import CURVED, STRAIGHT, Stephenson, stephenson_size
from cranktrain.mechanisms.stephenson.spec import (
    StephensonSpec,
    stephenson_advice,
    stephenson_geometry,
    structure_of,
)

__all__ = ["KIND", "Stephenson", "StephensonSpec"]

_LENGTHS = {
    "eccentricity": "eccentricity",
    "rod_length": "eccentric_rod_length",
    "pin_spacing": "pin_spacing",
    "pin_setback": "pin_setback",
    "saddle_setback": "saddle_setback",
    "lifting_link_length": "lifting_link_length",
    "arm_length": "lifting_arm_length",
    "reverse_shaft.x": "reverse_shaft_x",
    "reverse_shaft.y": "reverse_shaft_y",
    "offset": "offset",
}


def _fields(structure: Structure) -> dict[str, Any]:
    """What the kind says of gears with a curved slot, or with a straight one."""
    lengths = _LENGTHS if structure == STRAIGHT else _LENGTHS | {"slot_arc": "link_radius"}
    return {
        **as_chain(structure, partial(stephenson_size, structure), lengths, slider=VALVE),
        "drawing": partial(stephenson_drawing, structure),
    }


KIND = Kind(
    name="stephenson",
    title=N_("Stephenson's link motion"),
    spec=StephensonSpec,
    geometry=stephenson_geometry,
    has_rod=False,
    closing_advice=stephenson_advice,
    closing_field="eccentric_rod_length",
    members=Members,
    stages=(),
    structure_of=structure_of,
    of_structure=lambda structure: kind_of_structure(KIND, _fields, structure),
    **_fields(CURVED),
    handles=(
        Handle("ahead.pin", ("eccentricity", "angle_of_advance")),
        Handle("reverse_shaft", ("reverse_shaft_x", "reverse_shaft_y")),
    ),
    speed="180 rpm",
    tables=Path(__file__).with_name("starting.toml"),
    example="""\
[mechanism]
kind = "stephenson"
notch = 1                         # 1 full gear ahead, 0 mid gear, -1 full gear astern
eccentricity = "70 mm"
angle_of_advance = "15 deg"
admission = "outside"             # or "inside"
rods = "open"                     # or "crossed": open if they do not cross while the eccentrics face the link
eccentric_rod_length = "1400 mm"
pin_spacing = "300 mm"            # between the joints of the rods on the link
# pin_setback = "75 mm"           # of these joints from the slot, toward the shaft
link_radius = "1400 mm"           # of the slot; without it the slot is straight
# saddle_setback = "0 mm"
lifting_link_length = "400 mm"    # hangs the middle of the link on the arm of the reverse shaft
lifting_arm_length = "450 mm"
lifting_arm_angle = "180 deg"     # at mid gear, from x, away from the shaft, toward y
lifting_arm_swing = "-18 deg"     # from there to full gear ahead
reverse_shaft_x = "1850 mm"
reverse_shaft_y = "-400 mm"
# offset = "0 mm"                 # of the valve's line, toward +y
""",
)
