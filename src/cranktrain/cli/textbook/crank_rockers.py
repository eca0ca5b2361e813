"""Velocities of a crank-rocker's pins by the directions of its links, (7) and (10) of Gandzha's text."""

from collections.abc import Iterator, Sequence

import numpy as np
from rich.console import Console

from cranktrain.cli.screen.columns import Column, section_of_columns
from cranktrain.cli.screen.text import section
from cranktrain.language import said as _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.saying.wording import figure, number
from cranktrain.textbook.crank_rocker_statements import (
    AlikeRockers,
    alike_rockers,
    crank_rocker_curves,
    crank_rocker_statements,
)

_STEP = 30
"""Of the crank angle in tables. [deg]"""


def show_crank_rockers(console: Console, places: Sequence[PlacedMechanism], *, with_table: bool) -> bool:
    """Show v_A/v_B and what follows from it for every distinct crank-rocker; whether there is one."""
    rockers = alike_rockers(places)
    for one in rockers:
        heading = _("Velocities of the pins: (4), (7), (10) for {rockers} [gandzha]", rockers=one.of)
        section(console, heading, _said(one))
        if with_table:
            _show_table(console, one)
    return bool(rockers)


def _said(one: AlikeRockers) -> Iterator[str]:
    """Say how exact (10) is, and what (13) and (21) make of it."""
    low, high, rounding, product, length = crank_rocker_statements(one)
    yield _(
        "AC/BC = sin(α − β)/sin(α₁ − β) is v_A/v_B and, times Q, T by (4), without losses: exact, off by {error:.0e} "
        "at most, from rounding. The product of both sines, which the text refutes, is off by up to {refuted:.4f}.",
        error=rounding.value,
        refuted=product.value,
    )
    yield ""
    yield _(
        "By (21) the torque of a constant Q is M_xx times it: from {low} to {high}, where the line that the text "
        "refutes is flat. So it is of a weight or spring; friction reverses with the rocker and never drives.",
        low=f"{low.exact:.4f}",
        high=f"{high.exact:.4f}",
    )
    yield ""
    yield _(
        "(13) prints r₁ = {rocker} where by (12) and (4) it must be r = {radius}: M/Q is r times that.",
        radius=number(length.exact, "mm"),
        rocker=number(length.value, "mm"),
    )


def _show_table(console: Console, one: AlikeRockers) -> None:
    """Show the ratio at round angles of the crank, as the kernel counts it, its square, and torque by load."""
    ratio, product, square, torque = crank_rocker_curves(one, np.deg2rad(np.arange(0, 360, _STEP, dtype=float)))
    assert ratio.exact is not None  # the motion's own
    columns = [
        Column(head, "", tuple(f"{value + 0.0:.4f}" for value in values))
        for head, values in (
            (_("exact"), ratio.exact),
            ("(10)", ratio.values),
            (_("refuted"), product.values),
            ("G_B/G_A (17)", square.values),
        )
    ]
    columns.append(Column("M/Q (13)", "mm", tuple(figure(value, "mm") for value in torque.values)))
    heading = _("v_A/v_B by the crank's angle α from the line of the fixed pivots")
    section_of_columns(console, heading, columns, [f"{step}°" for step in range(0, 360, _STEP)])
