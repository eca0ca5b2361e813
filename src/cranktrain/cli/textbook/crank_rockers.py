"""Velocities of a crank-rocker's pins by the directions of its links, (7) and (10) of Gandzha's text."""

from collections.abc import Sequence

import numpy as np
from rich.console import Console

from cranktrain.cli.screen.columns import Column, section_of_columns
from cranktrain.cli.screen.text import section
from cranktrain.grouping import places_of_equal
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Array
from cranktrain.numerics import turn_grid
from cranktrain.textbook.crank_rocker import pin_velocity_ratio, product_of_sines
from cranktrain.wording import ranged

_STEP = 30
"""Of the crank angle in tables. [deg]"""


def show_crank_rockers(console: Console, places: Sequence[PlacedMechanism], *, with_table: bool) -> bool:
    """Show v_A/v_B for every distinct crank-rocker; whether there is one."""
    rockers = [place for place in places if place.kind.name == "crank_rocker"]
    names = [place.name for place in rockers]
    for members in places_of_equal([place.geometry for place in rockers]).values():
        first = rockers[members[0]]
        exact, source, refuted = _ratios(first, turn_grid())
        said = _(
            "AC/BC = sin(α − β)/sin(α₁ − β) is v_A/v_B and, times Q, T by (4), without losses: exact, off by "
            "{error:.0e} at most, from rounding; from {least:.4f} to {most:.4f} over a turn. The product of both "
            "sines, which the text refutes, is off by up to {refuted:.4f}."
        ).format(
            error=float(np.nanmax(np.abs(source - exact))),
            least=float(np.nanmin(exact)),
            most=float(np.nanmax(exact)),
            refuted=float(np.nanmax(np.abs(refuted - exact))),
        )
        heading = _("Velocities of the pins: (4), (7), (10) for {rockers} [gandzha]").format(
            rockers=ranged(names, members)
        )
        section(console, heading, [said])
        if with_table:
            _show_table(console, first)
    return bool(rockers)


def _show_table(console: Console, place: PlacedMechanism) -> None:
    """Show the ratio at round angles of the crank, as the kernel counts it."""
    angle = np.deg2rad(np.arange(0, 360, _STEP, dtype=float))
    heads = (_("exact"), "(10)", _("refuted"))
    columns = [
        Column(head, "", tuple(f"{value + 0.0:.4f}" for value in values))
        for head, values in zip(heads, _ratios(place, angle), strict=True)
    ]
    heading = _("v_A/v_B by the crank's angle α from the line of the fixed pivots")
    section_of_columns(console, heading, columns, [f"{step}°" for step in range(0, 360, _STEP)])


def _ratios(place: PlacedMechanism, angle: Array) -> tuple[Array, Array, Array]:
    """v_A/v_B of the motion, by (10), and by the product that the text refutes."""
    motion = place.kind.motion(angle, place.geometry)
    exact = motion.rocker.angle.first * place.geometry.rocker_length / place.geometry.crank_radius
    directions = (angle, motion.rod.angle.value, motion.rocker.angle.value)
    return exact, pin_velocity_ratio(*directions), product_of_sines(*directions)
