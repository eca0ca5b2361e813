"""Where pins, journals and bearings wear, and where their oil holes go."""

from cranktrain.language import N_
from cranktrain.panels.picture import Picture
from cranktrain.panels.sheets.crankshaft import REFUSED

PICTURES = (
    Picture(
        "sheet",
        "wear",
        "cranktrain.panels.sheets.wear.sheet:sheet_wear",
        "cycle",
        needs={"crankpin_wear": N_("a sheet of wear needs {needs}")},
        refused=REFUSED,
        takes=("method",),
        follows="crankpins",
    ),
)
