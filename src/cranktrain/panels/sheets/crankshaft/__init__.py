"""What bearings and pins carry: polar diagrams by every method, torque along the shaft."""

from cranktrain.language import N_
from cranktrain.panels.picture import Picture

_WHOLE = N_("must be left out: the sheet is of the whole crankshaft over its cycle")
REFUSED = {"at": _WHOLE, "mechanism": _WHOLE}
"""By every sheet of a whole crankshaft."""

PICTURES = (
    Picture(
        "sheet",
        "crankshaft",
        "cranktrain.panels.sheets.crankshaft.bearings:sheet_crankshaft",
        "cycle",
        needs={"main_bearing_load_x": N_("a sheet of main bearings needs {needs}")},
        refused=REFUSED,
        takes=("method",),
    ),
    Picture(
        "sheet",
        "crankpins",
        "cranktrain.panels.sheets.crankshaft.pins:sheet_crankpins",
        "cycle",
        needs={"crankpin_wear": N_("a sheet of crank pins needs {needs}")},
        refused=REFUSED,
    ),
    Picture(
        "sheet",
        "shaft_torque",
        "cranktrain.panels.sheets.crankshaft.torque:sheet_shaft_torque",
        "cycle",
        needs={"section_torque": N_("a sheet of the torque along the shaft needs {needs}")},
        refused=REFUSED,
    ),
)
