"""Pictures that a notebook asks a thing for: its curves, those of two machines, its sheets by name."""

from collections.abc import Sequence
from typing import Any

from cranktrain.errors import refuse
from cranktrain.extras import lacking
from cranktrain.panels.pictures import sheet_picture
from cranktrain.panels.plotted import plot_of, plot_of_both
from cranktrain.panels.swept import plot_of_sweep
from cranktrain.viz.drawn_curves import drawn_plot, in_notebook
from cranktrain.viz.paper.page import Figure
from cranktrain.viz.pictures import drawing_of


def plot_run(run: Any, *quantities: str, design: int = 0, **members: "str | Sequence[str]") -> Figure:
    """Draw curves of a run; parameters as of `plot_of`."""
    refuse(lacking("matplotlib", "plot"))
    return drawn_plot(plot_of(run, *quantities, design=design, **members))


def plot_sweep(sweep: Any, *quantities: str) -> Figure:
    """Draw facts of a sweep; parameters as of `plot_of_sweep`."""
    refuse(lacking("matplotlib", "plot"))
    return drawn_plot(plot_of_sweep(sweep, *quantities))


def plot_comparison(comparison: Any, *quantities: str) -> Figure:
    """Draw curves of two machines over each other; parameters as of `plot_of_both`."""
    refuse(lacking("matplotlib", "plot"))
    return drawn_plot(plot_of_both(comparison, *quantities))


def sheet_called(result: Any, name: str = "machine", *, size: str = "A4", design: int = 0) -> Figure:
    """Draw a sheet of a result by its name, on "A4" or "A3"; parameters as of `sheet_picture`."""
    refuse(lacking("matplotlib", "sheet"))
    return in_notebook(drawing_of(sheet_picture(result, name))(result, size=size, design=design))
