"""`textbook --harmonics`: reads the machine, or the ratio, whose harmonics are asked for, and shows them."""

from cranktrain.cli.screen.sections import show_page
from cranktrain.cli.textbook.source import file_missing, machine_file
from cranktrain.cli.textbook.typed import OF_FORCES, TextbookRequest
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.io.title import title
from cranktrain.language import said as _
from cranktrain.quantities import Dimension, Quantity
from cranktrain.questions.torque.rod_harmonics import MOST_RATIO
from cranktrain.textbook.shown.harmonics import harmonic_sections, machine_harmonics

_EXAMPLE = "cranktrain textbook 3d12 --harmonics"
_OTHERS = ("--table", "--full", "--errata", "--source", "--forces", *OF_FORCES)


def show_harmonics(asked: TextbookRequest) -> None:
    """Show the tables of a machine, or of a ratio of crank radius and rod.

    Raises
    ------
    InputError
        With everything that is wrong with the request, or with the machine.
    """
    ratio = _given_ratio(asked)
    if ratio is not None:
        show_page(_("Central slider-crank"), harmonic_sections({f"λ = {ratio:g}": ratio}))
        return
    machine = machine_file(asked, _EXAMPLE).machine
    show_page(title(machine), machine_harmonics(machine, asked.file or "", asked.settings))


def _given_ratio(asked: TextbookRequest) -> float | None:
    """Read the ratio, where one is given, and refuse what does not go with it or with harmonics."""
    problems = [*asked.beside(_("is for the motion or its forces: ask for it without harmonics"), *_OTHERS)]
    ratio = None
    if asked.crank_to_rod_ratio is None:
        problems += [] if asked.file else [file_missing(_EXAMPLE)]
    else:
        try:
            ratio = Quantity(Dimension.RATIO, above=0.0, at_most=MOST_RATIO).given(asked.crank_to_rod_ratio).si
        except InputError as error:
            problems += [Problem("--crank-to-rod-ratio", one.given, one.allowed, one.repair) for one in error.problems]
        of_machine = asked.beside(_("is for a machine: name FILE"), "--set")
        own = asked.beside(_("has ratios of its own: give one or the other"), "FILE")
        problems += own if asked.file else of_machine
    refuse(problems)
    return ratio
