"""Which picture a result is asked for."""

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.panels.picture import Picture
from cranktrain.panels.plotted import unknown
from cranktrain.panels.sheets import PICTURES


def sheet_picture(result: Result, name: str) -> Picture:
    """Find a sheet by its name.

    Parameters
    ----------
    result : Result
    name : str

    Returns
    -------
    Picture

    Raises
    ------
    InputError
        Where there is no such sheet, or the result was not asked for what it needs.
    """
    sheets = {one.name: one for one in PICTURES if one.kind == "sheet"}
    if name not in sheets:
        raise InputError([unknown("sheet", name, sheets)])
    if result.asked is not None and not set(sheets[name].quantities or ("",)) <= set(result.asked):
        allowed = _("needs more than the quantities that were asked for: run the machine without `quantities`")
        raise InputError([Problem("sheet", name, allowed)])
    return sheets[name]
