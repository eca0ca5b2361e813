"""Writing pictures: whole or not at all, and the same bytes for the same picture."""

import os
from collections.abc import Callable, Iterator, Sequence
from io import BytesIO
from math import sqrt
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

from cranktrain.errors import InputError, Position, Problem, refuse
from cranktrain.extras import lacking_for
from cranktrain.io.output import write_whole
from cranktrain.language import said as _

if TYPE_CHECKING:
    from cranktrain.viz.paper.page import Figure

DOTS_PER_INCH = 150

# Without these the libraries write the time, or their own version, into the file.
_UNDATED: dict[str, dict[str, Any]] = {
    ".png": {"Software": None},
    ".svg": {"Date": None, "Creator": "cranktrain"},
    ".pdf": {"CreationDate": None, "ModDate": None, "Producer": None, "Creator": "cranktrain"},
}

FORMATS = tuple(_UNDATED)
"""Suffixes of pictures that `save` writes."""


def save(figure: "Figure | Callable[[], Figure]", path: "str | os.PathLike[str]", *, force: bool = False) -> None:
    """Save a picture, in the form that the file's name asks for.

    Parameters
    ----------
    figure : Figure, or a callable that draws one
        A callable is called only once the file is known to be possible.
    path : str or path-like
        Ends in .png (150 dots to the inch), .svg or .pdf, which has a page for each of several sheets.
    force : bool
        Replace a file that is there.

    Raises
    ------
    InputError
        If the name has another ending, a file is there, or it cannot be written.
    """
    suffix = PurePath(path).suffix.lower()
    if suffix not in _UNDATED:
        allowed = _("must end in one of: {suffixes}", suffixes=", ".join(FORMATS))
        raise InputError([Problem("", os.fspath(path), allowed, position=Position("-o"))])
    refuse(lacking_for(suffix))
    write_whole(path, _pieces(figure, suffix), force=force)


def save_animation(
    result: Any, path: "str | os.PathLike[str]", *, force: bool = False, design: int = 0, piston: str | None = None
) -> None:
    """Save the moving picture of a result as a GIF.

    Parameters
    ----------
    result : Result
    path : str or path-like
    force : bool
        Replace a file that is there.
    design : int
        Which of the result's machines.
    piston : str, optional
        Whose throw alone moves; unless given, one of each sort.

    Raises
    ------
    InputError
        If a file is there, or it cannot be written; the picture is drawn only after that is known.
    """
    from cranktrain.viz.throw.gif import animation

    refuse(lacking_for(".gif"))

    write_whole(path, (animation(result, design=design, piston=piston) for _once in range(1)), force=force)


def _pieces(figure: "Figure | Callable[[], Figure]", suffix: str) -> Iterator[bytes]:
    """Draw and give the file's bytes."""
    from cranktrain.viz.paper.page import drawing_settings

    drawn: Any = figure() if callable(figure) else figure
    with drawing_settings():
        content = BytesIO()
        sheets = _sheets_of(drawn) if suffix == ".pdf" else []
        if len(sheets) > 1:
            _save_pages(drawn, sheets, content)
        else:
            drawn.savefig(content, format=suffix[1:], dpi=DOTS_PER_INCH, metadata=_UNDATED[suffix])
        yield content.getvalue()


def _sheets_of(figure: Any) -> list[Any]:
    """Bounds of the sheets that lie one below the other in a figure: each √2 times as wide as it is high. [inch]"""
    from matplotlib.transforms import Bbox

    width, height = figure.get_size_inches().tolist()
    n_sheets = max(round(height * sqrt(2.0) / width), 1)
    tops = [height * (1.0 - number / n_sheets) for number in range(n_sheets)]
    return [Bbox([[0.0, top - height / n_sheets], [width, top]]) for top in tops]


def _save_pages(figure: Any, sheets: Sequence[Any], content: BytesIO) -> None:
    """Write a figure as a PDF with a page for each sheet, so that a printer prints it to its scale."""
    from matplotlib.backends.backend_pdf import PdfPages

    with PdfPages(content, metadata=_UNDATED[".pdf"]) as pages:
        for sheet in sheets:
            figure.savefig(pages, format="pdf", bbox_inches=sheet)
