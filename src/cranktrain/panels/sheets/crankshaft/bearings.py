"""The sheet of main bearings: a polar diagram of each with all methods overlaid, and the methods' table."""

from collections.abc import Iterator

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import Words, _
from cranktrain.one_line import short
from cranktrain.panels.design import OneDesign
from cranktrain.panels.parts import Polars, Sheet, SheetColumn, Table, TableColumn, sheet_of
from cranktrain.panels.shapes import peak
from cranktrain.panels.sheets.crankshaft.panels import (
    bearing_diagrams,
    chosen_methods,
    diagrams_by_method,
    method_place,
    of_shafts,
)
from cranktrain.questions.crankshaft.methods import title_of
from cranktrain.saying.amounts import BareAmount, UnitLabel
from cranktrain.saying.wording import ABSENT

_NAMES, _WIDEST = 0.16, 0.08
"""Width of the table's names, and of a column at most, in parts of the sheet's."""
_LETTERS = 170
"""Of names that fit side by side into the width."""


def sheet_crankshaft(result: Result, *, design: int = 0, method: str | None = None) -> Sheet:
    """Collect the loads of all main bearings.

    Parameters
    ----------
    result : Result
        Of a machine with [crankshaft].
    design : int
        Which of the result's machines.
    method : str, optional
        By which method alone, `frame_elastic`; several with commas between, or `all`, side by side to one scale, on as
        many sheets one below the other as that takes. Every method in one diagram unless given.

    Returns
    -------
    Sheet

    Raises
    ------
    InputError
        If the bearings have no loads, as of a shaft that floats, or none by a method.
    """
    shown = OneDesign(result, design)
    largest = shown("largest_bearing_load")
    if not np.all(np.isfinite(largest)) or not np.any(largest > 0.0):
        raise InputError([Problem("crankshaft", None, _("gives no loads of bearings, so there is no sheet of them"))])
    words = _("Loads of journals on bearings, as seen from the free end")
    title = _("Loads of the main bearings")
    places = chosen_methods(shown, method)
    if not places:
        diagrams = Polars(bearing_diagrams(shown), notes=words)
        return sheet_of(result, design, title, SheetColumn(1.0, (diagrams, _table(shown))))
    if len(places) == 1:
        title = _(
            "{title} by: {method}", title=title, method=title_of(shown.result.labels["bearing_method"][places[0]])
        )
    n_beside = len(places) if len(places) > 1 else None
    diagrams = Polars(diagrams_by_method(shown, places), notes=words, n_beside=n_beside)
    # Beside many small diagrams there is no room for numbers: those stand on the sheet of all methods.
    parts = (diagrams, _table(shown)) if len(places) == 1 else (diagrams,)
    return sheet_of(result, design, title, SheetColumn(1.0, parts))


def _table(shown: OneDesign) -> Table:
    """The largest loads by every method, beside its line; their spread; and the mean by the first."""
    largest = shown("largest_bearing_load")
    bearings, methods = (shown.result.labels[name] for name in ("bearing", "bearing_method"))
    width = min((1.0 - _NAMES) / len(bearings), _WIDEST)
    names: list[Words] = [*map(title_of, methods), _("methods differ by, %"), _("mean load by the first")]
    head = _("Largest load, {unit}", unit=UnitLabel("N", peak(largest)))
    return Table(
        (
            TableColumn(head, names),
            *(
                TableColumn(short(name, int(width * _LETTERS)), list(_of_bearing(shown, place)), group=shaft)
                for place, (shaft, name) in enumerate(of_shafts(bearings))
            ),
        ),
        tuple(_NAMES + width * (place + 1) for place in range(len(bearings))),
        samples=tuple(method_place(name) if place else 0 for place, name in enumerate(methods)),
    )


def _of_bearing(shown: OneDesign, bearing: int) -> Iterator[Words]:
    """What stands below the name of a bearing."""
    largest, mean = shown("largest_bearing_load"), shown("mean_bearing_load")
    most = peak(largest)
    own = largest[:, bearing]
    yield from (BareAmount(float(load), "N", most) for load in own)
    least = float(np.min(own))
    yield f"{100 * float(np.max(own) - least) / least:.0f}" if least > 0.0 else ABSENT
    yield BareAmount(float(mean[0, bearing]), "N", most)
