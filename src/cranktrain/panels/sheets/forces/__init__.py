"""Which forces act: their sheet, polygons, Zhukovsky's lever and a crank pin's polar diagram."""

from cranktrain.language import N_
from cranktrain.panels.picture import Picture

PICTURES = (
    Picture(
        "sheet",
        "forces",
        "cranktrain.panels.sheets.forces.sheet:sheet_forces",
        "cycle",
        needs={"machine_torque": N_("a sheet of forces needs {needs}")},
        refused={"at": N_("must be left out: the sheet of forces has the whole cycle")},
    ),
    Picture("plan", "forces", "cranktrain.viz.plans.forces:plan_forces", "angles"),
    Picture("plan", "zhukovsky", "cranktrain.viz.plans.zhukovsky:plan_zhukovsky", "angles"),
    Picture("plan", "polar", "cranktrain.viz.plans.pin_polar:plan_polar", "angles"),
)

VECTORS = ("cranktrain.panels.sheets.forces.vectors:forces",)
