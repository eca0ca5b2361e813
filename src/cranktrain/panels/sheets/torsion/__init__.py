"""At which speeds a crankshaft vibrates in torsion: its modes, and Campbell's diagram."""

from cranktrain.language import N_
from cranktrain.panels.picture import Picture

_WHOLE = N_("must be left out: the sheet of torsion is of the whole crankshaft")

PICTURES = (
    Picture(
        "sheet",
        "torsion",
        "cranktrain.panels.sheets.torsion.sheet:sheet_torsion",
        "cycle",
        needs={"natural_frequency": N_("a sheet of torsion needs [torsion], and one crankshaft")},
        quantities=("natural_frequency", "critical_speed", "mode_vector_sum", "trial_amplitude"),
        refused={
            "at": _WHOLE,
            "mechanism": _WHOLE,
            "speed": N_("must be left out: natural frequencies are the same at every speed"),
        },
    ),
)
