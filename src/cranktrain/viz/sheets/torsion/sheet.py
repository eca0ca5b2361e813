"""The sheet of torsion: modes along the shaft, Campbell's diagram, the critical speeds that matter most."""

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.viz.paper.page import MARGIN, Figure, Page, drawing_settings, paper
from cranktrain.viz.paper.words import running_words, speed_of, speed_words, unused_words, zero_words
from cranktrain.viz.plans.sheet import Box
from cranktrain.viz.sheets.motion import title_block
from cranktrain.viz.sheets.torsion.campbell import draw_campbell
from cranktrain.viz.sheets.torsion.modes import draw_modes
from cranktrain.viz.sheets.torsion.panels import campbell, mode_shapes

_LEFT = 0.5
"""Share of the modes in the width."""


def sheet_torsion(result: Result, *, size: str = "A4", design: int = 0) -> Figure:
    """Draw the sheet of torsion of a machine.

    Parameters
    ----------
    result : Result
        Of a machine with [torsion].
    size : "A4" or "A3"
        Lying.
    design : int
        Which of the result's machines.

    Returns
    -------
    Figure

    Raises
    ------
    InputError
        If the machine has no natural frequencies.
    """
    if "natural_frequency" not in result.catalogue:
        raise InputError([Problem("", None, _("a sheet of torsion needs {needs}").format(needs="[torsion]"))])
    shapes = mode_shapes(result, design)
    if not all(np.isfinite(shape.frequency) for shape in shapes):
        raise InputError([Problem("torsion", None, _("gives no natural frequencies, so there is no sheet of them"))])
    with drawing_settings():
        page = Page(*paper(size))
        machine = result.machines[design]
        head = [_("Torsional vibration. {zero}").format(zero=zero_words(machine))]
        at_speed = speed_words(speed_of(result), design)
        top = title_block(page, machine, [running_words(machine)], head, at_speed, unused_words(result)) - 4.0
        width = page.width - 2 * MARGIN
        draw_modes(page, shapes, result.labels["disc"], Box(MARGIN, MARGIN, _LEFT * width - 8.0, top - MARGIN))
        room = Box(MARGIN + _LEFT * width + 10.0, MARGIN, (1 - _LEFT) * width - 10.0, top - MARGIN)
        draw_campbell(page, campbell(result, design), max(len(result.labels.get("cylinder", ())), 1), room)
        return page.figure
