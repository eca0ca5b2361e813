"""What Gandzha's text has for a machine: velocities of a crank-rocker's pins by the directions of its links."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.saying.sections import Column, Decimals, Grid, Part, ShownSection
from cranktrain.saying.wording import number
from cranktrain.textbook.crank_rocker_statements import (
    AlikeRockers,
    alike_rockers,
    crank_rocker_curves,
    crank_rocker_statements,
)
from cranktrain.textbook.shown.of_machine import MachinePage, TextOfMachine, nothing
from cranktrain.textbook.shown.tables import EXACT, ROUND_ANGLES, degrees


def _whole(page: MachinePage) -> Iterator[ShownSection]:
    """Give v_A/v_B and what follows from it for every distinct crank-rocker."""
    for one in alike_rockers(page.machine.places):
        heading = _("Velocities of the pins: (4), (7), (10) for {rockers} [gandzha]", rockers=one.of)
        yield ShownSection(heading, tuple(_said(one)))
        if page.with_table:
            yield _table(one)


def _said(one: AlikeRockers) -> Iterator[Part]:
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


def _table(one: AlikeRockers) -> ShownSection:
    """The ratio at round angles of the crank, as the kernel counts it, its square, and torque by load."""
    ratio, product, square, torque = crank_rocker_curves(one, np.deg2rad(ROUND_ANGLES))
    assert ratio.exact is not None  # the motion's own
    ratios = {_(EXACT): ratio.exact, "(10)": ratio.values, _("refuted"): product.values, "G_B/G_A (17)": square.values}
    columns = [Column(head, values.tolist(), how=Decimals(4)) for head, values in ratios.items()]
    columns.append(Column("M/Q (13)", torque.values.tolist(), "mm"))
    heading = _("v_A/v_B by the crank's angle α from the line of the fixed pivots")
    return ShownSection(heading, (Grid(columns, degrees(ROUND_ANGLES)),))


OF_MACHINE = TextOfMachine(
    speaks=lambda machine: bool(alike_rockers(machine.places)), whole=_whole, beside=_whole, errors=nothing
)
