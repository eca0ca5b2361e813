"""Pictures: sheets, plans, animations and DXF of a machine and its result. Nothing that computes imports them."""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from cranktrain.viz.cad import dxf
    from cranktrain.viz.centre_plans import plan_centres
    from cranktrain.viz.construction_plans import plan_arc, plan_brix, plan_brix_backward, plan_projection
    from cranktrain.viz.curves import SHEET_QUANTITIES
    from cranktrain.viz.evenness import plan_mertsalov, plan_wittenbauer
    from cranktrain.viz.force_plans import plan_forces
    from cranktrain.viz.forces_sheet import sheet_forces
    from cranktrain.viz.gif import animation
    from cranktrain.viz.machine_sheet import sheet
    from cranktrain.viz.output import save, save_animation
    from cranktrain.viz.pin_polar import plan_polar
    from cranktrain.viz.plans import plan_accelerations, plan_klein, plan_positions, plan_velocities
    from cranktrain.viz.zhukovsky_plan import plan_zhukovsky

__all__ = [
    "SHEET_QUANTITIES",
    "animation",
    "dxf",
    "plan_accelerations",
    "plan_arc",
    "plan_brix",
    "plan_brix_backward",
    "plan_centres",
    "plan_forces",
    "plan_klein",
    "plan_mertsalov",
    "plan_polar",
    "plan_positions",
    "plan_projection",
    "plan_velocities",
    "plan_wittenbauer",
    "plan_zhukovsky",
    "save",
    "save_animation",
    "sheet",
    "sheet_forces",
]

_HOMES = {
    "SHEET_QUANTITIES": "cranktrain.viz.curves",
    "animation": "cranktrain.viz.gif",
    "dxf": "cranktrain.viz.cad",
    "plan_accelerations": "cranktrain.viz.plans",
    "plan_arc": "cranktrain.viz.construction_plans",
    "plan_brix": "cranktrain.viz.construction_plans",
    "plan_brix_backward": "cranktrain.viz.construction_plans",
    "plan_centres": "cranktrain.viz.centre_plans",
    "plan_forces": "cranktrain.viz.force_plans",
    "plan_klein": "cranktrain.viz.plans",
    "plan_mertsalov": "cranktrain.viz.evenness",
    "plan_polar": "cranktrain.viz.pin_polar",
    "plan_positions": "cranktrain.viz.plans",
    "plan_projection": "cranktrain.viz.construction_plans",
    "plan_velocities": "cranktrain.viz.plans",
    "plan_wittenbauer": "cranktrain.viz.evenness",
    "plan_zhukovsky": "cranktrain.viz.zhukovsky_plan",
    "save": "cranktrain.viz.output",
    "save_animation": "cranktrain.viz.output",
    "sheet": "cranktrain.viz.machine_sheet",
    "sheet_forces": "cranktrain.viz.forces_sheet",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"cranktrain.viz has no {name}")
    return getattr(import_module(_HOMES[name]), name)
