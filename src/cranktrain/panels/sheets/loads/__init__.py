"""What a machine works against: the sheet of its loads."""

from cranktrain.language import N_
from cranktrain.panels.picture import Picture

_WHOLE = N_("must be left out: the sheet of loads is of the whole machine over its cycle")

PICTURES = (
    Picture(
        "sheet",
        "loads",
        "cranktrain.panels.sheets.loads.sheet:sheet_loads",
        "cycle",
        needs={"load_work": N_("a sheet of loads needs [load.NAME]")},
        refused={"at": _WHOLE, "mechanism": _WHOLE},
    ),
)
