"""The same curves of the pistons that are not chosen: thin lines behind those of a tab, for whoever asks for them."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError
from cranktrain.language import Message
from cranktrain.panels.parts import CurveCard, Sheet, SheetColumn, Stack
from cranktrain.panels.shapes import Curve, Panel, peak, scales_of
from cranktrain.web.as_seen import in_bits_seen
from cranktrain.web.parts import PageCurves
from cranktrain.web.saved_curves import with_saved
from cranktrain.web.tab_sheets import columns_beside, is_of_one_piston, made_sheet, sheet_makers
from cranktrain.web.tabs import OtherCurve, PageOthers, PageSheet

_APPROXIMATE = frozenset(("textbook", "formula"))
"""Roles of curves that stand beside those of a piston for comparison with it alone."""


def has_others(result: Result, title: str, sheets: Sequence[PageSheet]) -> bool:
    """Whether sheets under a title, as they are made, have curves that not all pistons are shown with."""
    pistons = {place.name for place in result.machines[0].design.pistons}
    pairs = zip(sheet_makers(result, title), sheets, strict=False)
    own = (sheet for make, sheet in pairs if is_of_one_piston(make))
    parts = (part for sheet in own for column in sheet.columns for part in column if isinstance(part, PageCurves))
    names = ({str(curve.name) for panel in part.panels for curve in panel.curves} for part in parts)
    return len(pistons) > 1 and any(not pistons <= shown for shown in names)


def other_pistons(result: Result, title: str, saved: Result | None = None, piston: str = "") -> PageOthers:
    """Collect the curves of all pistons but the chosen one under a title.

    Parameters
    ----------
    result : Result
    title : str
        Of questions.
    saved : Result, optional
        Of a machine whose curves stand among those of the chosen piston.
    piston : str
        The chosen one; the first where there is none of that name.

    Returns
    -------
    PageOthers
    """
    return PageOthers(tuple(_of_parts(result, title, saved, piston)))


def _of_parts(
    result: Result, title: str, saved: Result | None, piston: str
) -> Iterator[tuple[tuple[OtherCurve, ...], ...]]:
    """Give the curves of each part that has any."""
    for make in sheet_makers(result, title):
        try:
            sheet = made_sheet(result, make, piston)
        except InputError:
            continue
        others = _panels_of_others(result, make, sheet, piston) if is_of_one_piston(make) else {}
        for panels, before in _panels_by_part(sheet.columns, columns_beside(saved, title, make, piston)):
            yield tuple(tuple(_of_panel(panel, others)) for panel in with_saved(panels, before))


def _panels_by_part(
    columns: Sequence[SheetColumn], beside: Sequence[SheetColumn] = ()
) -> Iterator[tuple[Sequence[Panel], Sequence[Panel]]]:
    """Give the panels of each part that has curves, and those of the same part of a saved case."""
    for place, column in enumerate(columns):
        saved = beside[place].parts if place < len(beside) else ()
        for where, part in enumerate(column.parts):
            if isinstance(part, Stack | CurveCard):
                before = saved[where] if where < len(saved) else None
                yield part.panels, before.panels if isinstance(before, Stack | CurveCard) else ()


def _panels(sheet: Sheet) -> list[Panel]:
    """Give all panels of a sheet."""
    return [panel for panels, _none in _panels_by_part(sheet.columns) for panel in panels]


def _panels_of_others(result: Result, make: Callable[..., Any], sheet: Sheet, piston: str) -> dict[str, list[Panel]]:
    """Make the sheet of each piston but the chosen one, and give its panels."""
    found: dict[str, list[Panel]] = {}
    for place in result.machines[0].design.pistons:
        try:
            found[place.name] = _panels(made_sheet(result, make, place.name))
        except InputError:  # it has no such sheet
            continue
    shown = _titles(_panels(sheet))
    first = next((name for name, panels in found.items() if _titles(panels) == shown), "")
    found.pop(piston if piston in found else first, None)
    return found


def _titles(panels: Sequence[Panel]) -> list[str]:
    """Say the titles of panels."""
    return [str(panel.title) for panel in panels]


def _of_panel(panel: Panel, others: Mapping[str, Sequence[Panel]]) -> Iterator[OtherCurve]:
    """Give the curves of others in a panel; none in one that is the same whoever is chosen."""
    found = {name: other for name, panels in others.items() for other in panels if _sort(other) == _sort(panel)}
    if all(_is_same(panel, other) for other in found.values()):
        return
    along, up = scales_of(panel)
    furthest = max(peak(panel.across_of(curve)) for curve in panel.curves)
    shown = {_whose(curve, "") for curve in panel.curves}
    lines: dict[tuple[str, bytes, bytes], OtherCurve] = {}
    for name, other in found.items():
        for curve in other.curves:
            who = _whose(curve, name)
            if who in shown or curve.role in _APPROXIMATE:
                continue
            values = in_bits_seen(up.of(curve.values), up.of(panel.size))
            across = other.across_of(curve)
            places = None if across is panel.across else in_bits_seen(along.of(across), along.of(furthest))
            key = curve.symbol, values.tobytes(), b"" if places is None else places.tobytes()
            before = lines.get(key)
            names = (who,) if before is None else tuple(dict.fromkeys((*before.names, who)))
            lines[key] = OtherCurve(names, curve.symbol, values, places)
    yield from lines.values()


def _whose(curve: Curve, piston: str) -> str:
    """Say whose a curve is: where its panel is of several, whom it names, else the piston of the sheet."""
    return str(curve.name) or piston


def _sort(panel: Panel) -> tuple[str, str, str]:
    """What a panel has in common with the same one of another piston, whom its title may name."""
    title = panel.title.text if isinstance(panel.title, Message) else str(panel.title)
    return title, str(panel.unit), panel.across_unit


def _is_same(panel: Panel, other: Panel) -> bool:
    """Whether all curves of a sheet's own are the same in two panels."""
    own = [curve for curve in panel.curves if curve.role != "saved"]
    return len(own) == len(other.curves) and all(
        np.array_equal(one.values, two.values, equal_nan=True) for one, two in zip(own, other.curves, strict=True)
    )
