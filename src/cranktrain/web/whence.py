"""Where a number of a page is from: its quantity, its equation, the stages and the numbers of the file behind it."""

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.io.input_sections import inputs_behind
from cranktrain.io.machine_file import MachineFile
from cranktrain.language import Words, _
from cranktrain.record import record
from cranktrain.saying.names import said_name


@record
class PageWhence:
    """Where a number is from.

    Attributes
    ----------
    title : Words
        What its quantity is called.
    sentences : tuple of Words
        What it is, its equation and where that stands.
    stages : tuple of str
        That lead to it, as they run.
    inputs : tuple of str
        Paths of the numbers of the file behind it.
    """

    title: Words
    sentences: tuple[Words, ...]
    stages: tuple[str, ...]
    inputs: tuple[str, ...]


def page_whence(file: MachineFile, result: Result, name: str) -> PageWhence:
    """Find where a quantity is from.

    Raises
    ------
    InputError
        If the result has none of that name.
    """
    if name not in result.catalogue:
        raise InputError([Problem("quantity", name, _("is no result of this machine"))])
    found = result.behind(name)
    inputs = tuple(one.path for one in inputs_behind(file, found))
    return PageWhence(said_name(name), tuple(result.why(name)), found.stages, inputs)
