"""The sheet of forces: gas, the forces of a piston, torque and its orders, and what they rest on."""

from collections.abc import Iterator
from textwrap import wrap

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.layout.speed_curve import SpeedCurve
from cranktrain.motion import Array
from cranktrain.questions.forces.carriers import carriers_of
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.viz.paper.page import MARGIN, Figure, Page, drawing_settings, mathematics, muted, paper
from cranktrain.viz.paper.style import COLOURS, TEXT
from cranktrain.viz.paper.words import running_words, speed_words, unused_words, zero_words
from cranktrain.viz.sheets.motion import title_block
from cranktrain.viz.sheets.panels import (
    OneDesign,
    chambers_of,
    draw_panels,
    force_panels,
    has_forces,
    is_off,
    prepare,
)
from cranktrain.viz.sheets.torque import draw_orders, draw_stars
from cranktrain.wording import number

_LEFT = 0.55
"""Share of the curves over the crank angle in the width."""

_LETTERS = 68
"""Letters in a line of notes, for each 100 mm."""


def sheet_forces(result: Result, *, size: str = "A4", piston: str | None = None, design: int = 0) -> Figure:
    """Draw the sheet of forces of a machine.

    Parameters
    ----------
    result : Result
        Of a machine with a speed, and masses or gas.
    size : "A4" or "A3"
        Lying.
    piston : str, optional
        Whose forces; the first with a rod unless given.
    design : int
        Which of the result's machines.

    Returns
    -------
    Figure

    Raises
    ------
    InputError
        If the result has no forces, or no such piston.
    """
    shown = OneDesign(result, design)
    if "machine_torque" not in result.catalogue:
        needs = next((one.needs for one in result.missing if "machine_torque" in one.results), ())
        raise InputError([Problem("", None, _("a sheet of forces needs {needs}").format(needs=", ".join(needs)))])
    name = _piston(result, piston)
    with drawing_settings():
        page = Page(*paper(size))
        machine = result.machines[design]
        top = title_block(
            page,
            machine,
            [running_words(machine)],
            [_("Forces. {zero}").format(zero=zero_words(machine))],
            speed_words(result.get(SpeedCurve), design),
            unused_words(result),
        )
        bottom, width = MARGIN, page.width - 2 * MARGIN
        left = (MARGIN + 12.0, bottom, _LEFT * width - 18.0, top - 4.0 - bottom)
        draw_panels(page, shown, list(force_panels(result, name, design)), left)
        start = MARGIN + _LEFT * width + 12.0
        room = (start, page.width - MARGIN, top - 4.0)
        below = _draw_indicator(page, shown, name, room)
        below = draw_orders(page, shown, (room[0], room[1], below))
        below = draw_stars(page, shown, (room[0], room[1], below))
        _write_notes(page, shown, name, (room[0] - 8.0, room[1], below))
        return page.figure


def _piston(result: Result, wanted: str | None) -> str | None:
    """Find the piston: one that is named, else the first that has forces of its own."""
    names = result.labels.get("piston", ())
    if wanted is not None and wanted not in names:
        allowed = _("must be one of this machine's pistons: {names}").format(names=", ".join(names) or _("none"))
        raise InputError([Problem("--mechanism", wanted, allowed)])
    if wanted is not None or "piston_force" not in result.catalogue:
        return wanted or next(iter(names), None)
    return next(name for name in names if has_forces(result, name))


def _master_of(result: Result, piston: str) -> str | None:
    """Whose rod a piston's hangs on; None for one that hangs on none."""
    carriers = carriers_of(result.machines[0].places)
    names = [place.name for place in result.machines[0].places]
    master = int(carriers.master[names.index(piston)])
    return names[master] if master >= 0 else None


def _draw_indicator(page: Page, shown: OneDesign, piston: str | None, place: tuple[float, float, float]) -> float:
    """Draw p over V of the piston's chambers; give where it ends. [mm]"""
    left, right, top = place
    if piston is None or not (shown.has("gas_pressure") and shown.has("chamber_volume")):
        return top
    height = 0.27 * top
    axes = page.axes(left, top - 5.0 - height, right - left, height)
    prepare(axes)
    at = chambers_of(shown.result, piston)
    for later, chamber in enumerate(at):
        volume, pressure = (_closed(shown(name)[chamber]) for name in ("chamber_volume", "gas_pressure"))
        axes.plot(volume * 1e3, pressure / 1e6, color=COLOURS["p"], lw=0.9 if later else 1.4)
    page.heading(left, top - 3.0, _("Indicator diagram, pressure in MPa over volume in litres"))
    if shown.has("indicated_mean_pressure"):
        words = _("mean {mean:.3f} MPa").format(mean=float(shown("indicated_mean_pressure")[at[0]]) / 1e6)
        axes.text(0.98, 0.9, words, ha="right", va="top", transform=axes.transAxes, fontsize=TEXT)
    return top - 5.0 - height - 7.0


def _closed(values: Array) -> Array:
    return np.append(values, values[0])


def _write_notes(page: Page, shown: OneDesign, piston: str | None, place: tuple[float, float, float]) -> None:
    """Say what the curves rest on, as far as there is room."""
    result, design = shown
    left, right, top = place
    notes = list(_notes(result, piston, design))
    letters = int((right - left) * _LETTERS / 100.0)
    room = int((top - MARGIN) / 4.2)
    written = 0
    for note in notes:
        lines = wrap(note, letters)
        if written + len(lines) <= room:
            for below, line in enumerate(lines):
                page.text(left, top - 3.0 - 4.2 * (written + below), line, **muted())
            written += len(lines)


def _on_forces(shown: OneDesign, piston: str) -> Iterator[str]:
    """Sentences on a piston's forces: whose rod they are of, and by how much the formula is off."""
    master = _master_of(shown.result, piston)
    if master is not None:
        yield _(
            "{piston} hangs on the rod of {master}: {radial}, {tangential} are what the crank pin bears of it."
        ).format(piston=piston, master=master, radial=mathematics("K_i"), tangential=mathematics("T_i"))
        return
    yield _("P, S, N, K, T: by the reactions in the joints, K without the rod's rotating mass.")
    errors = {"N": "side_force_formula_error", "T": "tangential_force_formula_error"}
    row = shown.result.labels["piston"].index(piston)
    method = shown.result.labels["force_method"].index("textbook")
    said = [
        _("{error} in {symbol}").format(error=number(float(shown(name)[method, row]), "%"), symbol=symbol)
        for symbol, name in errors.items()
        if is_off(shown, piston, name)
    ]
    if said:
        yield _("f: the textbook's P·f(β), off by up to {errors}.").format(errors=", ".join(said))


def _notes(result: Result, piston: str | None, design: int) -> Iterator[str]:
    """Sentences on what is shown."""
    if piston is not None and has_forces(result, piston):
        yield from _on_forces(OneDesign(result, design), piston)
    yield _("Torque: reactions of rigid links, each mechanism's thin.")
    if result.labels.get("cylinder"):
        yield _("Filled bars: orders in which all cylinders add up.")
    masses = result[LoadedMachine].masses
    if masses.assumed:
        yield _("Rods without a given inertia have that of two masses at their ends.")
    if (said := masses.without_mass()) is not None:
        yield said
    gas = result.get(GasPressures)
    yield from () if gas is None else gas.flags
