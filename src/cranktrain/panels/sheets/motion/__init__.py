"""How a machine moves: its sheet, plans, the sources' constructions, a moving picture and a DXF."""

from cranktrain.language import N_
from cranktrain.panels.picture import Picture

SHEET_QUANTITIES = (
    *("piston_displacement", "piston_velocity", "piston_velocity_coefficient", "piston_acceleration_coefficient"),
    *("displacement_by_method", "velocity_coefficient_by_method", "acceleration_coefficient_by_method"),
    *("displacement_error", "acceleration_error", "top_dead_centre", "bottom_dead_centre"),
    *("combined_displacement", "inner_volumetric_dead_centre", "outer_volumetric_dead_centre", "chamber_volume"),
    *("rocker_angle", "rocker_velocity_coefficient", "rocker_acceleration_coefficient"),
    *("largest_rocker_angle_at", "smallest_rocker_angle_at", "load_velocity_coefficient"),
)
"""All that a sheet shows of a result: `run(machine, quantities=SHEET_QUANTITIES)` suffices for it."""

_EVENLY = N_("must be left out: Klein's construction is for a crank that turns evenly; ask for accelerations")
_ALIKE = {"speed": N_("must be left out: this plan is the same at every speed")}
_ONE_TURN = N_("must be left out: a .gif shows one turn")
_STEPS = N_("must be left out: a .gif shows positions in even steps of the crank angle")
_ALL_PLANS = N_("must be left out: a .dxf holds all plans, in true millimetres")

_MOTION = "cranktrain.viz.plans.motion"
_CONSTRUCTIONS = "cranktrain.viz.plans.constructions"

PICTURES = (
    Picture(
        "sheet",
        "machine",
        "cranktrain.panels.sheets.motion.sheet:sheet",
        "cycle",
        quantities=SHEET_QUANTITIES,
        takes=("scale",),
    ),
    Picture(
        "plan",
        "positions",
        "cranktrain.viz.plans.positions:plan_positions",
        "angles",
        source_angles="shown",
        takes=("scale",),
    ),
    Picture("plan", "scheme", "cranktrain.viz.plans.scheme:plan_scheme", "angles", refused=_ALIKE, takes=("letters",)),
    Picture("plan", "velocities", f"{_MOTION}:plan_velocities", "angles"),
    Picture("plan", "accelerations", f"{_MOTION}:plan_accelerations", "angles"),
    Picture("plan", "klein", f"{_MOTION}:plan_klein", "angles", refused={"speed": _EVENLY}),
    Picture("plan", "centres", "cranktrain.viz.plans.centres:plan_centres", "angles", refused=_ALIKE),
    *(
        Picture(
            "plan",
            name,
            f"{_CONSTRUCTIONS}:plan_{name}",
            "angles",
            refused=_ALIKE,
            source_angles="cylinder",
            takes=("scale",),
        )
        for name in ("arc", "projection", "brix")
    ),
    Picture(
        "plan", "brix-backward", f"{_CONSTRUCTIONS}:plan_brix_backward", "angles", refused=_ALIKE, takes=("scale",)
    ),
    Picture(
        "file",
        ".gif",
        "cranktrain.viz.throw.gif:animation",
        "cycle",
        quantities=SHEET_QUANTITIES,
        refused=dict.fromkeys(("plan", "at", "size", "sheet"), _ONE_TURN) | {"speed": _STEPS},
    ),
    Picture(
        "file",
        ".dxf",
        "cranktrain.viz.plans.cad:dxf",
        "angles",
        refused=dict.fromkeys(("plan", "size", "sheet"), _ALL_PLANS),
    ),
)

VECTORS = ("cranktrain.panels.sheets.motion.vectors:velocities",)
