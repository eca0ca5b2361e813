"""What rod loads take of the frame's limits."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import N_, Words, _
from cranktrain.layout.mechanisms import Pistons
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.rod_load.declared import LIMITS, DeclaredRodLoads
from cranktrain.questions.rod_load.loads import CROSSHEAD_PIN, GAS, RodLoads
from cranktrain.record import record
from cranktrain.references import CONVENTIONS
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import DEFINITION, quantity
from cranktrain.saying.checks import Flagged
from cranktrain.saying.labels import Titles
from cranktrain.saying.wording import number

_LIMIT = ("frame_limit", "piston")
LIMIT_TITLES: Titles = {
    "gas_compression": N_("gas load in compression"),
    "gas_tension": N_("gas load in tension"),
    "compression": N_("rod load in compression"),
    "tension": N_("rod load in tension"),
}


@record
class RodLoadUse(Flagged):
    """Largest rod loads over the limits of the frame; NaN where the file has none."""

    rod_load_limit: Array = quantity(
        "F_lim", "N", _LIMIT, N_("What the frame bears, as the file gives it"), CONVENTIONS, DEFINITION
    )
    rod_load_use: Array = quantity(
        "F/F_lim",
        "1",
        _LIMIT,
        N_("Largest rod load over the frame's limit: gas alone, and gas and inertia at the crosshead pin"),
        _THEORY,
        "13.55",
        worst="largest",
    )


def have_limits(declared: DeclaredRodLoads) -> bool | str:
    """Whether the file says what the frame may bear."""
    return bool(np.any(np.isfinite(declared.limits))) or N_("[rod_load] compression, tension")


def rod_load_use(pistons: Pistons, declared: DeclaredRodLoads, loads: RodLoads) -> RodLoadUse:
    """Largest loads over their limits."""
    compression, tension = loads.largest_rod_compression.value, loads.largest_rod_tension.value
    largest = np.stack([part[:, place] for place in (GAS, CROSSHEAD_PIN) for part in (compression, tension)], axis=1)
    use = largest / declared.limits
    return RodLoadUse(declared.limits, use, labels={"frame_limit": LIMITS}, flags=tuple(_flags(pistons.names, use)))


def _flags(names: tuple[str, ...], use: Array) -> Iterator[Words]:
    """Flag loads beyond their limits: of each limit the worst."""
    for limit, title in enumerate(LIMIT_TITLES.values()):
        own = np.nan_to_num(use[:, limit])
        if np.any(own > 1):
            piston = first_largest(np.max(own, axis=0))
            said = _("The {load} of {piston} is {share} of the frame's limit.")
            yield said.format(load=_(title), piston=names[piston], share=number(float(np.max(own)), "%"))
