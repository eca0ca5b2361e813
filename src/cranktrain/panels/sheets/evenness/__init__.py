"""How evenly a machine runs: both diagrams of the flywheel."""

from cranktrain.language import N_
from cranktrain.panels.picture import Picture

_WHOLE_CYCLE = N_("must be left out: this plan is of the whole machine over its cycle")
_FOUND_FROM = N_("must be left out: this diagram is what the running speed is found from")

PICTURES = tuple(
    Picture(
        "plan",
        name,
        f"cranktrain.panels.sheets.evenness.diagrams:plan_{name}",
        "cycle",
        refused={"at": _WHOLE_CYCLE, "mechanism": _WHOLE_CYCLE, "speed": _FOUND_FROM},
    )
    for name in ("wittenbauer", "mertsalov")
)
