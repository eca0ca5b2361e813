"""A result as a page in a notebook, or in a file."""

import os
from html import escape

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.io.output import write_whole
from cranktrain.language import _
from cranktrain.record import record
from cranktrain.web.standalone import standalone_page

_HEIGHT = 760
"""Of a page in a notebook. [px]"""


@record
class View:
    """A result as a page, which a notebook shows: it moves there, and in files made of the notebook, without a kernel.

    Attributes
    ----------
    html : str
        The whole page.
    """

    html: str

    def _repr_html_(self) -> str:
        """Show it in a frame of its own, whose script reaches nothing outside."""
        return (
            f'<iframe srcdoc="{escape(self.html)}" sandbox="allow-scripts" '
            f'style="width: 100%; height: {_HEIGHT}px; border: 0"></iframe>'
        )

    def __repr__(self) -> str:
        """Say what it is, not all that is in it."""
        return f"<page, {len(self.html.encode()) / 1e3:.0f} kB>"

    def save(self, path: "str | os.PathLike[str]", *, force: bool = False) -> None:
        """Write it as a file that a browser opens.

        Parameters
        ----------
        path : str or path-like
        force : bool
            Replace a file that is there.

        Raises
        ------
        InputError
            If a file is there and `force` is not given, or it cannot be written.
        """
        write_whole(path, self.html, force=force)


def view_of(result: Result) -> View:
    """Give a result as a page, in the units of its file.

    Raises
    ------
    InputError
        Of a result of several designs, or one that was asked for some quantities alone.
    """
    if result.has_designs:
        raise InputError([Problem("view", None, _("is of one machine: this result has several designs"))])
    if result.asked is not None:
        allowed = _("needs more than the quantities that were asked for: run the machine without `quantities`")
        raise InputError([Problem("view", None, allowed)])
    with result.in_its_units():
        return View(standalone_page(result))
