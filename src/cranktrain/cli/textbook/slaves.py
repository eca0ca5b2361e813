"""The constants of (I.13) as numbers: as derived, as reconstructed, and those of the exact motion."""

from collections.abc import Sequence

import numpy as np
from rich.console import Console

from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.cli.screen.text import INDENT, section
from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.textbook.constants_statements import EQUATION, SOURCE, alike_slaves, constants_statements
from cranktrain.textbook.statements import Statement
from cranktrain.wording import ranged, signless

_DECIMALS = {"E": 6, "Φ": 4, "F": 6, "Θ": 3, "K": 3, "H": 3}


def show_constants(console: Console, places: Sequence[PlacedMechanism]) -> None:
    """Show K, E, F, Φ, Θ and H of every distinct slave on an articulated rod."""
    slaves = alike_slaves(places)
    if not slaves:
        return
    found = constants_statements(slaves)
    rows = grouped(((one.name if len(slaves) == 1 else f"{one.of}, {one.name}"), one) for one in found)
    sets = [{one.symbol: one for one in members} for members in rows.values()]
    columns = [_column(symbol, [each.get(symbol) for each in sets]) for symbol in _DECIMALS]
    names = [place.name for place in places if place.kind.is_slave]
    heading = _("Constants of {equation} for {pistons} [{source}]").format(
        equation=EQUATION, pistons=ranged(names, range(len(names))), source=SOURCE
    )
    section(console, heading, column_tables(columns, list(rows), console.width - INDENT))
    for subject, sentences in found.notes.items():
        section(console, subject, sentences)


def _column(symbol: str, members: Sequence[Statement | None]) -> Column:
    """One constant of every set; blank where a set has none."""
    unit = {"1": "", "rad": "deg", "m": "mm"}[next(one.unit for one in members if one is not None)]
    return Column(symbol, unit, tuple("" if one is None else _written(one) for one in members))


def _written(one: Statement) -> str:
    value = {"1": one.value, "rad": np.rad2deg(one.value), "m": 1e3 * one.value}[one.unit]
    return signless(f"{value:.{_DECIMALS[one.symbol]}f}")
