"""What shows a thing stands above the thing: here it is found by name, and loaded when it is first asked for."""

from collections.abc import Callable
from importlib import import_module
from typing import Any

_HOMES = {
    "checks_record": "io.tables",
    "conventions": "io.conventions",
    "curves_frame": "io.frames",
    "dataset_of": "analysis.dataset",
    "facts_frame": "io.frames",
    "layout_words": "io.description",
    "machine_html": "analysis.representations",
    "machine_line": "analysis.representations",
    "page_lines": "cli.screen.sections",
    "plot_comparison": "viz.curves",
    "plot_run": "viz.curves",
    "plot_sweep": "viz.curves",
    "result_html": "analysis.representations",
    "result_line": "analysis.representations",
    "result_lines": "analysis.representations",
    "result_sections": "analysis.result_sections",
    "save_machine": "io.saving",
    "sheet_called": "viz.curves",
    "summary_of_designs": "analysis.designs_summary",
    "units_of": "io.description",
    "view_of": "web.viewing",
}


def face(name: str) -> Callable[..., Any]:
    """Give a function that stands above its caller.

    Parameters
    ----------
    name : str

    Returns
    -------
    callable

    Examples
    --------
    >>> face("machine_line").__module__
    'cranktrain.analysis.representations'
    """
    function: Callable[..., Any] = getattr(import_module(f"cranktrain.{_HOMES[name]}"), name)
    return function
