"""`textbook`: the sources' own formulas for a machine, with their ranges and errors; the sources' own errors."""

import os
from dataclasses import replace

from cranktrain.analysis import run
from cranktrain.cli.how_far import says_how_far
from cranktrain.cli.screen.sections import show_page
from cranktrain.cli.textbook.source import machine_file
from cranktrain.cli.textbook.typed import OF_FORCES, TextbookRequest
from cranktrain.errors import InputError, Position, Problem, refuse
from cranktrain.io.examples import example_names
from cranktrain.io.title import title
from cranktrain.language import N_
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.quantities import nearest
from cranktrain.saying.sections import ShownSection
from cranktrain.textbook.motion_statements import NEEDED as MOTION_NEEDED
from cranktrain.textbook.opposed_statements import NEEDED as OPPOSED_NEEDED
from cranktrain.textbook.shown.contents import contents_of, list_of_texts
from cranktrain.textbook.shown.errata import errata_sections
from cranktrain.textbook.shown.machine import first_of_machine, how_to_go_on, unspoken_of, whole_machine
from cranktrain.texts.contents import Text, text_called, text_named

_ERRATA = "errata"
_ERRORS = N_("Errors of the sources, each with what is right")
_STEP = 30.0
"""Of the run on which statements rest: they hang on no angle of its. [deg]"""


def show_textbook(asked: TextbookRequest) -> None:
    """Show the texts, one of them, their errors, or how far their forms are off for a machine.

    Parameters
    ----------
    asked : TextbookRequest
        `file` is a machine file or an example; `errata`, if no file is called so, for the sources' errors alone; none
        for what the texts hold. `source` is the name of the one text that is to be shown; with no name in it, all texts
        are listed.

    Raises
    ------
    InputError
        With everything that is wrong with the machine or the name.
    """
    refuse(asked.beside(_("is for tables of forces: ask for --forces UNIT, too"), *OF_FORCES))
    file = asked.file or ""
    text = _text(asked.source) if asked.source else None
    is_errata = file.casefold() == _ERRATA and not os.path.isfile(file)  # noqa: PTH113 - takes a NUL byte
    if is_errata or (asked.errata and not file):
        refuse(asked.beside(_("is for a machine: name FILE"), "--table", "--set"))
        show_page(_(_ERRORS), errata_sections(text, full=asked.full))
    elif asked.source is not None and not file:
        refuse(asked.beside(_("is for a machine: name FILE"), "--table", "--set"))
        if text is not None:
            show_page(f"[{text.name}] {_(text.title)}", contents_of(text, full=asked.full))
            return
        refuse(asked.beside(_("is for one text: name it, such as --source bolotin"), "--full"))
        show_page(_("The texts whose formulas stand beside the exact ones"), list_of_texts())
    else:
        if text_named(file) and not os.path.exists(file):  # noqa: PTH110 - takes a NUL byte
            allowed = _("is a text, and no machine file is called so")
            repair = _("such as: {example}", example=f"cranktrain textbook --source {file}")
            raise InputError([Problem("", None, allowed, repair, Position(file))])
        _refuse_misspelt(file)
        _show_machine(asked, file, text)


def _refuse_misspelt(file: str) -> None:
    """Refuse what is no file, and nearly the word for the errors."""
    if not os.path.exists(file) and nearest(file, [_ERRATA, *example_names()]) == _ERRATA:  # noqa: PTH110 - NUL bytes
        allowed, repair = _("there is no such file"), _("did you mean {name}?", name=_ERRATA)
        raise InputError([Problem("", None, allowed, repair, Position(one_line(file)))])


def _text(name: str) -> Text:
    """Find a text; of a machine say where its name belongs."""
    try:
        return text_called(name)
    except InputError as error:
        if os.path.isfile(name) or name in example_names():  # noqa: PTH113 - takes a NUL byte
            repair = _("a machine stands before it: cranktrain textbook {file}", file=one_line(name))
            raise InputError([replace(one, repair=repair) for one in error.problems]) from None
        raise


def _show_machine(asked: TextbookRequest, file: str, text: Text | None) -> None:
    """Show what the texts, or one of them, have for a machine: all, or the first screen."""
    examples = _("{one}, or {other}", one="cranktrain textbook 3d12", other="cranktrain textbook --source")
    machine = machine_file(asked, examples).machine
    with says_how_far():
        result = run(machine, step_degrees=_STEP, quantities=(*MOTION_NEEDED, *OPPOSED_NEEDED))
    has = whole_machine if asked.full else first_of_machine
    sections = list(has(machine, result, text, with_table=asked.table))
    if not sections:
        sections.append(unspoken_of(machine, file, asked.settings, text))
    elif not asked.full:
        sections += how_to_go_on(machine, file, asked.settings, text, with_table=asked.table)
    if asked.errata:
        sections += [ShownSection(_(_ERRORS)), *errata_sections(text, full=asked.full)]
    show_page(title(machine), sections)
