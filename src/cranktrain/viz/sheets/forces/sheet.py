"""The sheet of forces: gas, the forces of a piston, torque and its orders, and what they rest on."""

from collections.abc import Iterator, Sequence
from textwrap import wrap

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.questions.forces.carriers import carriers_of
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.scales import scale_for
from cranktrain.viz.figures import with_unit
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.paper.head import result_page
from cranktrain.viz.paper.page import LINE, MARGIN, Box, Figure, Page, drawing_settings, mathematics
from cranktrain.viz.paper.panels import FORCES, axes_in, draw_curves, draw_panels
from cranktrain.viz.paper.style import TEXT
from cranktrain.viz.paper.tables import write_table
from cranktrain.viz.sheets.crankshaft.polar import draw_diagrams
from cranktrain.viz.sheets.forces.joints import (
    JointForce,
    force_scale,
    joint_diagrams,
    joint_forces,
    joint_panels,
    joint_rows,
)
from cranktrain.viz.sheets.forces.panels import force_panels, formula_error, has_forces, is_off
from cranktrain.viz.sheets.gas.panels import chambers_of, indicator_panel
from cranktrain.viz.sheets.torque.orders import draw_orders, draw_stars

_LEFT = 0.55
"""Share of the curves over the crank angle in the width."""

_POLAR = 0.27
"""Share of the polar diagrams in the height."""

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
    joints = [] if name is not None and has_forces(result, name) else _joints(shown, name)
    page, box = result_page(result, design, size, _("Forces"))
    curves = box._replace(left=box.left + 12.0, width=_LEFT * box.width - 18.0)
    own = list(joint_panels(shown, joints)) if joints else []
    draw_panels(page, [*own, *force_panels(result, name, design)], curves, FORCES)
    left, right = box.left + _LEFT * box.width + 12.0, box.left + box.width
    below = _draw_indicator(page, shown, name, (left, right, box.bottom + box.height))
    if joints:
        below = _draw_joints(page, shown, joints, (left - 8.0, right, below))
    below = draw_orders(page, shown, left, right, below)
    below = draw_stars(page, shown, left, right, below)
    _write_notes(page, shown, name, (left - 8.0, right, below))
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


def _joints(shown: OneDesign, piston: str | None) -> list[JointForce]:
    """Joints of the mechanism of a piston without forces of its own, or of the first."""
    return joint_forces(shown, piston or shown.result.machines[shown.design].places[0].name)


def _draw_joints(
    page: Page, shown: OneDesign, joints: Sequence[JointForce], place: tuple[float, float, float]
) -> float:
    """Draw polar diagrams of the most loaded joints over a table of all; give where it ends. [mm]"""
    left, right, top = place
    height = _POLAR * page.height
    room = Box(left, top - height, right - left, height)
    words = draw_diagrams(page, joint_diagrams(shown, joints), room, force_scale(joints))
    page.notes(left, room.bottom - 3.0, wrap(words, int(room.width * _LETTERS / 100.0)))
    rows = list(joint_rows(shown, joints))
    below = write_table(page, rows, (left, room.bottom - 10.0, room.width), (0.66, 0.8, 1.0))
    return below - 2.0


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
    chambers = chambers_of(shown.result, piston)
    for later, chamber in enumerate(chambers):
        mean = float(shown("indicated_mean_pressure")[chamber])
        said = _("{side} (thin): mean {mean}") if later else _("{side}: mean {mean}")
        words = said if len(chambers) > 1 else _("mean {mean}")
        side = shown.result.labels["chamber"][chamber].rpartition(".")[2]
        yield words.format(side=side, mean=with_unit(mean, scale_for("Pa", abs(mean))))


def _write_notes(page: Page, shown: OneDesign, piston: str | None, place: tuple[float, float, float]) -> None:
    """Say what the curves rest on, as far as there is room."""
    left, right, top = place
    room = int((top - MARGIN) / LINE)
    fitting: list[str] = []
    for note in _notes(shown, piston):
        lines = wrap(note, int((right - left) * _LETTERS / 100.0))
        fitting += lines if len(fitting) + len(lines) <= room else []
    page.notes(left, top - 3.0, fitting)


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
    said = [
        _("{error} in {symbol}").format(
            error=with_unit(formula_error(shown, piston, name), scale_for("%", 1.0)), symbol=symbol
        )
        for symbol, name in errors.items()
        if is_off(shown, piston, name)
    ]
    if said:
        yield _("f: the textbook's P·f(β), off by up to {errors}.").format(errors=", ".join(said))


def _notes(shown: OneDesign, piston: str | None) -> Iterator[str]:
    """Sentences on what is shown: what it leaves out first, as the last ones may find no room."""
    result = shown.result
    masses = result[LoadedMachine].masses
    if (said := result[LoadedMachine].without_mass()) is not None:
        yield said
    if masses.assumed:
        yield _("Rods without a given inertia have that of two masses at their ends.")
    gas = result.get(GasPressures)
    yield from () if gas is None else gas.flags
    if piston is not None and has_forces(result, piston):
        yield from _on_forces(shown, piston)
    yield _("Torque: reactions of rigid links, each mechanism's thin.")
    if result.labels.get("cylinder"):
        yield _("Filled bars: orders in which all cylinders add up.")
