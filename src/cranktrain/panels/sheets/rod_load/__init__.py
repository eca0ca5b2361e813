"""What gas and inertia put on piston rods and their pins, with the frame's limits, and where it reverses."""

from cranktrain.language import N_
from cranktrain.panels.picture import Picture

PICTURES = (
    Picture(
        "sheet",
        "rod_load",
        "cranktrain.panels.sheets.rod_load.sheet:sheet_rod_load",
        "cycle",
        needs={"rod_load": N_("a sheet of rod loads needs {needs}")},
        refused={"at": N_("must be left out: the sheet of rod loads has the whole cycle")},
    ),
)
