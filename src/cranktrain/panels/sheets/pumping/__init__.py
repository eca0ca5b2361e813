"""What the gearbox of a pumping unit gives: card with permissible loads, torque factor, torques, facts."""

from cranktrain.language import N_
from cranktrain.panels.picture import Picture

_WHOLE = N_("must be left out: the sheet of the pumping unit is of the whole machine over its turn")

PICTURES = (
    Picture(
        "sheet",
        "pumping",
        "cranktrain.panels.sheets.pumping.sheet:sheet_pumping",
        "cycle",
        needs={"gearbox_torque": N_("a sheet of the pumping unit needs [pumping]")},
        refused={"at": _WHOLE, "mechanism": _WHOLE},
    ),
)
