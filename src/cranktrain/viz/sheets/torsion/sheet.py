"""The sheet of torsion: modes along the shaft, Campbell's diagram, the critical speeds that matter most."""

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.viz.paper.head import result_page
from cranktrain.viz.paper.page import Figure, drawing_settings
from cranktrain.viz.sheets.torsion.campbell import draw_campbell
from cranktrain.viz.sheets.torsion.modes import draw_modes
from cranktrain.viz.sheets.torsion.panels import campbell, mode_shapes

_LEFT = 0.5
"""Share of the modes in the width."""


@drawing_settings()
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
    shapes = mode_shapes(result, design)
    if not all(np.isfinite(shape.frequency) for shape in shapes):
        raise InputError([Problem("torsion", None, _("gives no natural frequencies, so there is no sheet of them"))])
    page, box = result_page(result, design, size, _("Torsional vibration"))
    draw_modes(page, shapes, result.labels["disc"], box._replace(width=_LEFT * box.width - 8.0))
    room = box._replace(left=box.left + _LEFT * box.width + 10.0, width=(1 - _LEFT) * box.width - 10.0)
    draw_campbell(page, campbell(result, design), max(len(result.labels.get("cylinder", ())), 1), room)
    return page.figure
