"""What is taken away from a page: a machine's answers as a page of their own, tables, pictures, a drawing for CAD."""

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.extras import lacking_for
from cranktrain.io.machine_file import MachineFile
from cranktrain.io.writers import SUFFIXES, Form, written
from cranktrain.language import Words, _
from cranktrain.panels.sheets import pictures_of
from cranktrain.record import record
from cranktrain.web.standalone import standalone_page

_PAGE = ".html"
_N_ANGLES = 12
"""Of the plans of a drawing for CAD."""


@record
class ExportForm:
    """A form in which something is taken away: how its file's name ends, and what it is."""

    suffix: str
    words: Words


def export_forms() -> tuple[ExportForm, ...]:
    """Give those for which all that they need is installed."""
    known = {
        _PAGE: _("a page of its own"),
        ".csv": _("curves as a table"),
        ".xlsx": _("all results as a workbook"),
        ".nc": _("all results as NetCDF"),
        ".json": _("all results as JSON"),
        ".png": _("the sheet as a picture"),
        ".svg": _("the sheet as a drawing"),
        ".pdf": _("the sheet to print"),
        ".dxf": _("plans for CAD"),
    }
    return tuple(ExportForm(suffix, words) for suffix, words in known.items() if not any(lacking_for(suffix)))


def exported(file: MachineFile, result: Result, tab: str, suffix: str) -> bytes:
    """Make a file.

    Parameters
    ----------
    file : MachineFile
    result : Result
        What is computed of it.
    tab : str
        Of which a sheet is drawn; where it has none, that of the machine.
    suffix : str
        How the file's name ends.

    Returns
    -------
    bytes

    Raises
    ------
    InputError
        If there is no such form, or it needs a package that is not installed or something that the file lacks.
    """
    forms = [form.suffix for form in export_forms()]
    if suffix not in forms:
        raise InputError([Problem("suffix", suffix, _("must be one of: {names}", names=", ".join(forms)))])
    with result.in_its_units():
        if suffix == _PAGE:
            return standalone_page(result).encode()
        if suffix in SUFFIXES:
            return b"".join(_pieces(file, result, suffix))
        with TemporaryDirectory() as folder:
            path = Path(folder) / f"drawn{suffix}"
            _DRAWN[suffix](result, tab, path)
            return path.read_bytes()


def _pieces(file: MachineFile, result: Result, suffix: str) -> Iterator[bytes]:
    """Write a table."""
    for piece in written(Form(suffix), result, file.document.data, tuple(result.catalogue), is_all=True):
        yield piece if isinstance(piece, bytes) else piece.encode()


def _sheet(result: Result, tab: str, path: Path) -> None:
    """Draw the first sheet of a tab, or the machine's."""
    from cranktrain.viz.curves import sheet_called  # only where something is drawn
    from cranktrain.viz.output import save

    questions = (question for question in result.machines[0].questions if question.title == tab)
    sheets = (one for question in questions for one in pictures_of(question.name) if one.kind == "sheet")
    name = next((one.name for one in sheets if all(need in result.catalogue for need in one.needs)), "machine")
    save(lambda: sheet_called(result, name), path)


def _plans(result: Result, _tab: str, path: Path) -> None:
    """Draw all plans of the first mechanism."""
    from cranktrain.viz.plans.cad import dxf  # only where something is drawn

    dxf(result.machines[0], _N_ANGLES, path)


_DRAWN: Mapping[str, Callable[[Result, str, Path], None]] = {
    ".png": _sheet,
    ".svg": _sheet,
    ".pdf": _sheet,
    ".dxf": _plans,
}
