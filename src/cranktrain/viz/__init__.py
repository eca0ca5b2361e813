"""Pictures: sheets, plans, animations and DXF of a machine and its result. Nothing that computes imports them."""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from cranktrain.viz.cad import dxf
    from cranktrain.viz.gif import animation
    from cranktrain.viz.paper.output import save, save_animation
    from cranktrain.viz.plans.centres import plan_centres
    from cranktrain.viz.plans.constructions import plan_arc, plan_brix, plan_brix_backward, plan_projection
    from cranktrain.viz.plans.forces import plan_forces
    from cranktrain.viz.plans.motion import plan_accelerations, plan_klein, plan_positions, plan_velocities
    from cranktrain.viz.plans.pin_polar import plan_polar
    from cranktrain.viz.plans.zhukovsky import plan_zhukovsky
    from cranktrain.viz.sheets.curves import SHEET_QUANTITIES
    from cranktrain.viz.sheets.evenness import plan_mertsalov, plan_wittenbauer
    from cranktrain.viz.sheets.forces import sheet_forces
    from cranktrain.viz.sheets.motion import sheet

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
    "SHEET_QUANTITIES": "cranktrain.viz.sheets.curves",
    "animation": "cranktrain.viz.gif",
    "dxf": "cranktrain.viz.cad",
    "plan_accelerations": "cranktrain.viz.plans.motion",
    "plan_arc": "cranktrain.viz.plans.constructions",
    "plan_brix": "cranktrain.viz.plans.constructions",
    "plan_brix_backward": "cranktrain.viz.plans.constructions",
    "plan_centres": "cranktrain.viz.plans.centres",
    "plan_forces": "cranktrain.viz.plans.forces",
    "plan_klein": "cranktrain.viz.plans.motion",
    "plan_mertsalov": "cranktrain.viz.sheets.evenness",
    "plan_polar": "cranktrain.viz.plans.pin_polar",
    "plan_positions": "cranktrain.viz.plans.motion",
    "plan_projection": "cranktrain.viz.plans.constructions",
    "plan_velocities": "cranktrain.viz.plans.motion",
    "plan_wittenbauer": "cranktrain.viz.sheets.evenness",
    "plan_zhukovsky": "cranktrain.viz.plans.zhukovsky",
    "save": "cranktrain.viz.paper.output",
    "save_animation": "cranktrain.viz.paper.output",
    "sheet": "cranktrain.viz.sheets.motion",
    "sheet_forces": "cranktrain.viz.sheets.forces",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"cranktrain.viz has no {name}")
    return getattr(import_module(_HOMES[name]), name)
