"""The constants of (I.13) as numbers: as derived, as reconstructed, and those of the exact motion."""

from collections.abc import Mapping, Sequence

import numpy as np
from rich.console import Console

from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.cli.screen.text import INDENT, section
from cranktrain.grouping import places_of_equal
from cranktrain.language import N_, _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.mechanisms.articulated_rod import ArticulatedRod
from cranktrain.texts.articulated_rod import (
    SlaveHarmonics,
    derived,
    of_exact_motion,
    own_top_distance,
    reconstructed,
)
from cranktrain.wording import ranged, signless

_SETS = {
    N_("reconstructed"): reconstructed,
    N_("derived anew"): derived,
    N_("exact motion"): of_exact_motion,
}


def show_constants(console: Console, places: Sequence[PlacedMechanism]) -> None:
    """Show K, E, F, Φ and Θ of every distinct slave on an articulated rod."""
    slaves = [place for place in places if place.kind.name == "articulated_rod"]
    if not slaves:
        return
    names = [place.name for place in slaves]
    groups: Mapping[ArticulatedRod, list[int]] = places_of_equal([place.geometry for place in slaves])
    rows = [
        (_(name) if len(groups) == 1 else f"{ranged(names, members)}, {_(name)}", rod, constants(rod))
        for rod, members in groups.items()
        for name, constants in _SETS.items()
    ]
    tops = [float(own_top_distance(rod, one)) for _label, rod, one in rows]
    heading = _("Constants of (I.13) for {pistons} [bolotin]").format(pistons=ranged(names, range(len(names))))
    columns = _columns([one for _label, _rod, one in rows], tops)
    section(console, heading, column_tables(columns, [label for label, *_rest in rows], console.width - INDENT))
    said = _(
        "S = H − K − R[E cos(α_l + Φ) + ¼F cos(2α_l − Θ)], with α_l after the crank points along the slave's cylinder. "
        "The source's constants are illegible: reconstructed; those of the exact motion are its first two harmonics. "
        "H is the curve's own top."
    )
    section(console, _("What they are"), [said])


def _columns(sets: Sequence[SlaveHarmonics], tops: Sequence[float]) -> list[Column]:
    """A column for each constant."""
    return [
        Column("E", "", tuple(f"{float(one.first_amplitude):.6f}" for one in sets)),
        Column("Φ", "deg", tuple(signless(f"{np.rad2deg(float(one.first_phase)):.4f}") for one in sets)),
        Column("F", "", tuple(f"{float(one.second_amplitude):.6f}" for one in sets)),
        Column("Θ", "deg", tuple(signless(f"{np.rad2deg(float(one.second_phase)):.3f}") for one in sets)),
        Column("K", "mm", tuple(f"{1e3 * float(one.mean_distance):.3f}" for one in sets)),
        Column("H", "mm", tuple(f"{1e3 * top:.3f}" for top in tops)),
    ]
