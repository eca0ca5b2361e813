"""`view`: a machine as a page that stands alone, in which it moves."""

from collections.abc import Iterator
from pathlib import PurePath

from cranktrain.cli.asked import Asked, in_units_of, units_asked_for
from cranktrain.cli.how_far import says_how_far
from cranktrain.errors import Problem, refuse
from cranktrain.io.machine_file import computed, read_machine
from cranktrain.io.output import STANDARD_OUTPUT, look_first, write_whole
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.web.standalone import standalone_page

_SUFFIXES = (".html", ".htm")


def write_page(asked: Asked) -> None:
    """Compute all that a machine allows, and write the page; say what was written.

    Raises
    ------
    InputError
        With everything that is wrong with the options, else with the machine.
    """
    refuse(_output_problems(asked.output))
    look_first(asked.output or "-", force=asked.force)
    units = units_asked_for(asked.units)
    file = read_machine(asked.file, asked.settings, partial=asked.is_partial)
    with in_units_of(file, units), says_how_far():
        page = standalone_page(computed(file, partial=asked.is_partial))
        write_whole(asked.output or "-", page, force=asked.force)
    if asked.output not in STANDARD_OUTPUT:
        print(_("written: {name}; open it in a browser", name=one_line(asked.output or "")))


def _output_problems(output: str | None) -> Iterator[Problem]:
    """Find what is wrong with the name of the page."""
    if output is None:
        allowed = _("is missing: the name of the page, which ends in .html")
        yield Problem("-o", None, allowed, _("write -o page.html, or -o - for the standard output"))
    elif output not in STANDARD_OUTPUT and PurePath(output).suffix.lower() not in _SUFFIXES:
        allowed = _("must end in .html: it is a page")
        page = PurePath(output or "page").with_suffix(_SUFFIXES[0])
        yield Problem("-o", one_line(output), allowed, _('write "{text}"', text=one_line(str(page))))
