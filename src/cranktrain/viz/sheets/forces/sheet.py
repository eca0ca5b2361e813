"""The sheet of forces: gas, the forces of a piston, torque and its orders, and what they rest on."""

from collections.abc import Iterator, Sequence
from textwrap import wrap

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _
from cranktrain.questions.forces.carriers import carriers_of
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.saying.scales import scale_for
from cranktrain.viz.figures import with_unit
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.paper.head import result_page
from cranktrain.viz.paper.page import LINE, MARGIN, Box, Figure, Page, drawing_settings, mathematics
from cranktrain.viz.paper.panels import FORCES, axes_in, draw_curves, draw_panels
from cranktrain.viz.paper.style import TEXT
from cranktrain.viz.paper.tables import LEAST_ROW, ROW, write_table
from cranktrain.viz.sheets.crankshaft.polar import draw_diagrams
from cranktrain.viz.sheets.forces.at_crank import crank_panels, crank_torques
from cranktrain.viz.sheets.forces.joints import (
    MOST_CURVES,
    JointForce,
    SharedPin,
    force_scale,
    joint_diagrams,
    joint_forces,
    joint_panels,
    joint_rows,
    mechanism_of,
    pins_shared,
)
from cranktrain.viz.sheets.forces.panels import force_panels, formula_error, has_forces, is_off
from cranktrain.viz.sheets.gas.panels import chambers_of, indicator_panel
from cranktrain.viz.sheets.torque.orders import ORDERS, draw_orders, draw_stars
from cranktrain.viz.sheets.torque.panels import order_bars, torque_panel

_LEFT = 0.55
"""Share of the curves over the crank angle in the width."""

_POLAR = 0.27
"""Share of the polar diagrams in the height."""

_LEAST_POLAR = 34.0
"""Height of the polar diagrams beside a table of many joints. [mm]"""
_SCALE = 10.0
"""Under the diagrams, for their scale. [mm]"""
_HEADS = 20.0
"""What heads, rules and ticks of the table and of the torque's orders need. [mm]"""

_LETTERS = 68
"""Letters in a line of notes, for each 100 mm."""


@drawing_settings()
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
    name = _piston(result, piston)
    has_own = name is not None and has_forces(result, name)
    joints = [] if has_own else joint_forces(shown, mechanism_of(shown, name))
    page, box = result_page(result, design, size, _("Forces"))
    left, right = box.left + _LEFT * box.width + 12.0, box.left + box.width
    below = _draw_indicator(page, shown, name, (left, right, box.bottom + box.height))
    if joints:
        below = _draw_joints(page, shown, joints, (left - 8.0, right, below))
    below = draw_orders(page, shown, left, right, below)
    below = draw_stars(page, shown, left, right, below)
    rest = _write_notes(page, list(_force_notes(shown, name, joints)), (left - 8.0, right, below - 3.0))
    curves = box._replace(left=box.left + 12.0, width=_LEFT * box.width - 18.0)
    foot = _write_foot(page, rest, curves)
    own = [*joint_panels(shown, joints), *crank_panels(shown)] if joints else []
    above = curves._replace(bottom=curves.bottom + foot, height=curves.height - foot)
    draw_panels(page, [*own, *force_panels(result, name, design)], above, FORCES)
    return page.figure


def _piston(result: Result, wanted: str | None) -> str | None:
    """Find the piston: one that is named, else the first that has forces of its own."""
    names = result.labels.get("piston", ())
    if wanted is not None and wanted not in names:
        allowed = _("must be one of this machine's pistons: {names}", names=", ".join(names) or _("none"))
        raise InputError([Problem("--mechanism", wanted, allowed)])
    if wanted is not None or "piston_force" not in result.catalogue:
        return wanted or next(iter(names), None)
    return next((name for name in names if has_forces(result, name)), next(iter(names), None))


def _draw_joints(
    page: Page, shown: OneDesign, joints: Sequence[JointForce], place: tuple[float, float, float]
) -> float:
    """Draw polar diagrams of the most loaded joints over a table of all; give where it ends. [mm]

    Diagrams, then rows are made smaller where there are many joints; those that bear least may find no room.
    """
    left, right, top = place
    head, *rows = joint_rows(shown, joints)
    free = top - MARGIN - _SCALE - _HEADS - ORDERS * page.height
    line = ROW if free - _POLAR * page.height >= (len(rows) + 1) * ROW else LEAST_ROW
    n_most = int((free - _LEAST_POLAR) / line) - 1
    if len(rows) > n_most:
        left_out = _("and {n} that bear less", n=len(rows) - n_most + 1)
        rows = [*rows[: n_most - 1], (left_out, "", "", "")]
    height = min(_POLAR * page.height, free - (len(rows) + 1) * line)
    room = Box(left, top - height, right - left, height)
    words = draw_diagrams(page, joint_diagrams(shown, joints), room, force_scale(joints))
    page.notes(left, room.bottom - 3.0, wrap(words, int(room.width * _LETTERS / 100.0)))
    below = write_table(page, [head, *rows], (left, room.bottom - _SCALE, room.width), (0.66, 0.8, 1.0), line)
    return below - 2.0


def _draw_indicator(page: Page, shown: OneDesign, piston: str | None, place: tuple[float, float, float]) -> float:
    """Draw p over V of the piston's chambers; give where it ends. [mm]"""
    left, right, top = place
    if piston is None or not (shown.has("gas_pressure") and shown.has("chamber_volume")):
        return top
    height = 0.27 * top
    axes = axes_in(page, Box(left, top - 5.0 - height, right - left, height))
    panel = indicator_panel(shown, piston)
    draw_curves(axes, panel)
    page.heading(left, top - 3.0, panel.title)
    if shown.has("indicated_mean_pressure"):
        words = "\n".join(_means(shown, piston))
        axes.text(0.98, 0.9, words, ha="right", va="top", transform=axes.transAxes, fontsize=TEXT)
    return top - 5.0 - height - 7.0


def _means(shown: OneDesign, piston: str) -> Iterator[str]:
    """Mean pressure of each of a piston's chambers; where there are two, whose, and that the second's card is thin."""
    chambers = chambers_of(shown, piston)
    for later, (chamber, side) in enumerate(chambers.items()):
        mean = float(shown("indicated_mean_pressure")[chamber])
        said = _("{side} (thin): mean {mean}") if later else _("{side}: mean {mean}")
        words = said if len(chambers) > 1 else _("mean {mean}")
        yield words.format(side=side, mean=with_unit(mean, scale_for("Pa", abs(mean))))


def _write_notes(page: Page, notes: Sequence[str], place: tuple[float, float, float]) -> Sequence[str]:
    """Say what the curves rest on, note by note; give those that find no room. [mm]"""
    left, right, top = place
    room = int((top - MARGIN) / LINE) + 1
    fitting: list[str] = []
    for number, note in enumerate(notes):
        lines = wrap(note, int((right - left) * _LETTERS / 100.0))
        if len(fitting) + len(lines) > room:
            page.notes(left, top, fitting)
            return notes[number:]
        fitting += lines
    page.notes(left, top, fitting)
    return ()


def _write_foot(page: Page, notes: Sequence[str], below: Box) -> float:
    """Write notes at the foot of a room, under what is drawn in it; give how high they are. [mm]"""
    lines = [line for note in notes for line in wrap(note, int(below.width * _LETTERS / 100.0))]
    page.notes(below.left, below.bottom + LINE * (len(lines) - 1), lines)
    return LINE * len(lines) + 2.0 if lines else 0.0


def _force_notes(shown: OneDesign, piston: str | None, joints: Sequence[JointForce]) -> Iterator[str]:
    """Sentences on what is shown: first what is left out, last what the lines mean."""
    result = shown.result
    masses = result[LoadedMachine].masses
    if (said := result[LoadedMachine].without_mass()) is not None:
        yield str(said)
    if masses.assumed:
        yield _("Rods without a given inertia have that of two masses at their ends.")
    gas = result.get(GasPressures)
    yield from () if gas is None else map(str, gas.flags)
    if piston is not None and has_forces(result, piston):
        yield from _on_forces(shown, piston)
    if joints:
        yield from _on_joints(shown, joints, mechanism_of(shown, piston))
    several = any(curve.role == "each" for curve in torque_panel(shown).curves)
    yield (
        _("Torque: reactions of rigid links, each mechanism's thin.")
        if several
        else _("Torque: reactions of rigid links.")
    )
    bars = order_bars(shown)
    if np.any(bars.is_major & (bars.amplitude > 0)):
        yield _("Filled bars: orders in which all cylinders add up.")


def _on_joints(shown: OneDesign, joints: Sequence[JointForce], mechanism: str) -> Iterator[str]:
    """Say which torque goes into the crank, which comes out of it, whose pins are, and which joints have no curve."""
    torques = zip(crank_torques(shown), (mathematics("M_st"), "½J′ω²"), strict=True)
    said = [symbol for torque, symbol in torques if np.any(torque)]
    if said:
        yield _(
            "{symbols}: into the crank; {torque}: out of it, with the opposite sign.",
            symbols=", ".join(said),
            torque=mathematics("T_Σ"),
        )
    yield from _on_shared_pins(list(pins_shared(shown, mechanism)))
    if len(joints) > MOST_CURVES:
        yield _("Curves are of the {n} joints that bear most.", n=MOST_CURVES)


def _on_shared_pins(pins: Sequence[SharedPin]) -> Iterator[str]:
    """Say whose a pin of several links is taken to be."""
    if len(pins) > 1:
        yield _("Where three links or more meet, the pin is part of the rod of the pair that makes the joint.")
        return
    said = _("{joint} joins {n} links: its pin is part of {owner}, and {others} hang on that.")
    for pin in pins:
        others = _(" and ").join(pin.others)
        yield said.format(joint=pin.joint, n=len(pin.others) + 1, owner=pin.owner, others=others)


def _master_of(result: Result, piston: str) -> str | None:
    """Whose rod a piston's hangs on; None for one that hangs on none."""
    carriers = carriers_of(result.machines[0].places)
    names = [place.name for place in result.machines[0].places]
    master = int(carriers.master[names.index(piston)])
    return names[master] if master >= 0 else None


def _on_forces(shown: OneDesign, piston: str) -> Iterator[str]:
    """Sentences on a piston's forces: whose rod they are of, and by how much the formula is off."""
    master = _master_of(shown.result, piston)
    if master is not None:
        yield _(
            "{piston} hangs on the rod of {master}: {radial}, {tangential} are what the crank pin bears of it.",
            piston=piston,
            master=master,
            radial=mathematics("K_i"),
            tangential=mathematics("T_i"),
        )
        return
    yield _("P, S, N, K, T: by the reactions in the joints, K without the rod's rotating mass.")
    errors = {"N": "side_force_formula_error", "T": "tangential_force_formula_error"}
    said = [
        _(
            "{error} in {symbol}",
            error=with_unit(formula_error(shown, piston, name), scale_for("%", 1.0)),
            symbol=symbol,
        )
        for symbol, name in errors.items()
        if is_off(shown, piston, name)
    ]
    if said:
        yield _("f: the textbook's P·f(β), off by up to {errors}.", errors=", ".join(said))
