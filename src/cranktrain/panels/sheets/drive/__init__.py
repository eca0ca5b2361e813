"""What the motor must give: torques and speed over a turn, the way through its curve; and a start over time."""

from cranktrain.language import N_
from cranktrain.panels.picture import Picture

_WHOLE = N_("must be left out: the sheet of the drive is of the whole machine over its turn")

PICTURES = (
    Picture(
        "sheet",
        "drive",
        "cranktrain.panels.sheets.drive.sheet:sheet_drive",
        "cycle",
        needs={"static_torque": N_("a sheet of the drive needs [drive] {needs}")},
        refused={"at": _WHOLE, "mechanism": _WHOLE},
    ),
    Picture("start", "start", "cranktrain.panels.sheets.drive.start:start_picture", "time"),
)
