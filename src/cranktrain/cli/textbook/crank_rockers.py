"""Velocities of a crank-rocker's pins by the directions of its links, (7) and (10) of Gandzha's text."""

from collections.abc import Iterator, Sequence

import numpy as np
from rich.console import Console

from cranktrain.cli.screen.columns import Column, section_of_columns
from cranktrain.cli.screen.text import section
from cranktrain.grouping import places_of_equal
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Array
from cranktrain.numerics import extremes, turn_grid
from cranktrain.texts.crank_rocker import pin_velocity_ratio, product_of_sines
from cranktrain.wording import figure, number, ranged

_STEP = 30
"""Of the crank angle in tables. [deg]"""


def show_crank_rockers(console: Console, places: Sequence[PlacedMechanism], *, with_table: bool) -> bool:
    """Show v_A/v_B and what follows from it for every distinct crank-rocker; whether there is one."""
    rockers = [place for place in places if place.kind.name == "crank_rocker"]
    names = [place.name for place in rockers]
    for members in places_of_equal([place.geometry for place in rockers]).values():
        first = rockers[members[0]]
        heading = _("Velocities of the pins: (4), (7), (10) for {rockers} [gandzha]").format(
            rockers=ranged(names, members)
        )
        section(console, heading, _said(first))
        if with_table:
            _show_table(console, first)
    return bool(rockers)


def _said(place: PlacedMechanism) -> Iterator[str]:
    """Say how exact (10) is, and what (13) and (21) make of it."""
    exact, source, refuted = _ratios(place, turn_grid())
    low, high = (f"{float(peak.value[0]):.4f}" for peak in extremes(lambda angle: _ratios(place, angle)[0]))
    yield _(
        "AC/BC = sin(α − β)/sin(α₁ − β) is v_A/v_B and, times Q, T by (4), without losses: exact, off by {error:.0e} "
        "at most, from rounding. The product of both sines, which the text refutes, is off by up to {refuted:.4f}."
    ).format(
        error=float(np.nanmax(np.abs(source - exact))),
        refuted=float(np.nanmax(np.abs(refuted - exact))),
    )
    yield ""
    yield _(
        "By (21) the torque of a constant Q is M_xx times it: from {low} to {high}, where the line that the text "
        "refutes is flat. So it is of a weight or spring; friction reverses with the rocker and never drives."
    ).format(low=low, high=high)
    yield ""
    radius, rocker = (number(float(size), "mm") for size in (place.geometry.crank_radius, place.geometry.rocker_length))
    yield _("(13) prints r₁ = {rocker} where by (12) and (4) it must be r = {radius}: M/Q is r times that.").format(
        radius=radius, rocker=rocker
    )


def _show_table(console: Console, place: PlacedMechanism) -> None:
    """Show the ratio at round angles of the crank, as the kernel counts it, its square, and torque by load."""
    angle = np.deg2rad(np.arange(0, 360, _STEP, dtype=float))
    exact, source, refuted = _ratios(place, angle)
    columns = [
        Column(head, "", tuple(f"{value + 0.0:.4f}" for value in values))
        for head, values in (
            (_("exact"), exact),
            ("(10)", source),
            (_("refuted"), refuted),
            ("G_B/G_A (17)", source**2),
        )
    ]
    torque = tuple(figure(value, "mm") for value in place.geometry.crank_radius * source)
    columns.append(Column("M/Q (13)", "mm", torque))
    heading = _("v_A/v_B by the crank's angle α from the line of the fixed pivots")
    section_of_columns(console, heading, columns, [f"{step}°" for step in range(0, 360, _STEP)])


def _ratios(place: PlacedMechanism, angle: Array) -> tuple[Array, Array, Array]:
    """v_A/v_B of the motion, by (10), and by the product that the text refutes."""
    motion = place.kind.motion(angle, place.geometry)
    exact = motion.rocker.angle.first * place.geometry.rocker_length / place.geometry.crank_radius
    directions = (angle, motion.rod.angle.value, motion.rocker.angle.value)
    return exact, pin_velocity_ratio(*directions), product_of_sines(*directions)
