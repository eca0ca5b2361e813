"""Where pins, journals and bearings wear, and where their oil holes go."""

from cranktrain.language import N_
from cranktrain.viz.picture import Picture
from cranktrain.viz.sheets.crankshaft import REFUSED

PICTURES = (
    Picture(
        "sheet",
        "wear",
        "cranktrain.viz.sheets.wear.sheet:sheet_wear",
        "cycle",
        needs={"crankpin_wear": N_("a sheet of wear needs {needs}")},
        refused=REFUSED,
        follows="crankpins",
    ),
)
