"""`textbook`: the sources' own formulas for a machine, with their ranges and errors; the sources' own errors."""

import os
from collections.abc import Iterator, Sequence
from dataclasses import replace

from rich.console import Console
from rich.text import Text as Line

from cranktrain.analysis import Result, run
from cranktrain.cli.how_far import says_how_far
from cranktrain.cli.screen.text import INDENT, page, section, table
from cranktrain.cli.screen.title import title
from cranktrain.cli.textbook.constructions import show_constructions
from cranktrain.cli.textbook.crank_rockers import show_crank_rockers
from cranktrain.cli.textbook.crank_side import show_from_crank_side
from cranktrain.cli.textbook.errata import show_errata
from cranktrain.cli.textbook.forms import NEEDED as FORMS_NEEDED
from cranktrain.cli.textbook.forms import STEP, explain_forms, show_forms, show_motion
from cranktrain.cli.textbook.opposed import show_opposed
from cranktrain.cli.textbook.slaves import show_constants
from cranktrain.cli.textbook.source import machine_file
from cranktrain.cli.textbook.texts import show_text, show_texts
from cranktrain.errors import InputError, Position, Problem, refuse
from cranktrain.grouping import places_of_equal
from cranktrain.io.examples import example_names
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.one_line import one_line
from cranktrain.quantities import nearest
from cranktrain.references import REFERENCES
from cranktrain.textbook.opposed_statements import NEEDED as OPPOSED_NEEDED
from cranktrain.textbook.opposed_statements import opposed_cylinders
from cranktrain.texts.contents import Text, text_called, text_named

_ERRATA = "errata"
_OF_CRANK_ROCKERS = "gandzha"


def show_textbook(
    file: str, settings: Sequence[str], *, source: str | None = None, with_table: bool, with_errata: bool
) -> None:
    """Show the texts, one of them, their errors, or their forms for a machine with ranges and largest errors.

    Parameters
    ----------
    file : str
        A machine file or an example; `errata`, if no file is called so, for the sources' errors alone; none for what
        the texts hold.
    settings : sequence of str
        `PATH=VALUE`
    source : str, optional
        Name of the one text that is to be shown; with no name in it, all texts are listed.
    with_table : bool
        Whether to show the motion by each method.
    with_errata : bool
        Whether to show the sources' errors.

    Raises
    ------
    InputError
        With everything that is wrong with the machine or the name.
    """
    text = _text(source) if source else None
    is_errata = file.casefold() == _ERRATA and not os.path.isfile(file)  # noqa: PTH113 - takes a NUL byte
    if is_errata or (with_errata and not file):
        with page(_("Errors of the sources, each with what is right")) as console:
            show_errata(console, text)
    elif source is not None and not file:
        refuse(_without_machine(settings, with_table=with_table))
        show_texts() if text is None else show_text(text, has_forms=text.name in _SHOWN)
    else:
        if text_named(file) and not os.path.exists(file):  # noqa: PTH110 - takes a NUL byte
            allowed = _("is a text, and no machine file is called so")
            repair = _("such as: {example}").format(example=f"cranktrain textbook --source {file}")
            raise InputError([Problem("", None, allowed, repair, Position(file))])
        _refuse_misspelt(file)
        _show_machine(file, settings, text, with_table=with_table, with_errata=with_errata)


def _refuse_misspelt(file: str) -> None:
    """Refuse what is no file, and nearly the word for the errors."""
    if not os.path.exists(file) and nearest(file, [_ERRATA, *example_names()]) == _ERRATA:  # noqa: PTH110 - NUL bytes
        allowed, repair = _("there is no such file"), _("did you mean {name}?").format(name=_ERRATA)
        raise InputError([Problem("", None, allowed, repair, Position(one_line(file)))])


def _without_machine(settings: Sequence[str], *, with_table: bool) -> Iterator[Problem]:
    """Refuse what means nothing where no machine is named."""
    allowed = _("is for a machine: name FILE")
    if with_table:
        yield Problem("--table", None, allowed)
    if settings:
        yield Problem("--set", settings[0], allowed)


def _text(name: str) -> Text:
    """Find a text; of a machine say where its name belongs."""
    try:
        return text_called(name)
    except InputError as error:
        if os.path.isfile(name) or name in example_names():  # noqa: PTH113 - takes a NUL byte
            repair = _("a machine stands before it: cranktrain textbook {file}").format(file=one_line(name))
            raise InputError([replace(one, repair=repair) for one in error.problems]) from None
        raise


def _show_machine(
    file: str, settings: Sequence[str], text: Text | None, *, with_table: bool, with_errata: bool
) -> None:
    """Show what the texts, or one of them, have for a machine."""
    machine = machine_file(file, settings, "cranktrain textbook 3d12, or cranktrain textbook --source").machine
    with says_how_far():
        result = run(machine, step_degrees=STEP, quantities=(*FORMS_NEEDED, *OPPOSED_NEEDED))
    shown = {name: show for name, show in _SHOWN.items() if text is None or name == text.name}
    with page(title(machine)) as console:
        spoken = [name for name, show in shown.items() if show(console, machine, result, with_table=with_table)]
        if spoken:
            if spoken != [_OF_CRANK_ROCKERS]:
                explain_forms(console)
            if with_table:
                show_motion(console, machine, result, spoken)
            rows = [(f"[{name}]", REFERENCES[name].text) for name in spoken]
            section(console, _("Sources"), table(("", ""), rows, fold=console.width - INDENT))
        else:
            section(console, _("Textbook forms"), _unspoken(machine, file, text))
        if with_errata:
            console.print()
            console.print(Line(_("Errors of the sources, each with what is right"), style="bold"))
            show_errata(console, text)


def _unspoken(machine: Machine, file: str, text: Text | None) -> Iterator[str]:
    """Say that no text, or not this one, has anything for a machine."""
    kinds = ", ".join(dict.fromkeys(place.kind.name for place in machine.places))
    if text is None:
        yield _("None of the texts has a form of its own for the motion of: {kinds}.").format(kinds=kinds)
        return
    yield _("[{name}] speaks of {subject}; the mechanisms of this machine are: {kinds}.").format(
        name=text.name, subject=_(text.said_of), kinds=kinds
    )
    yield _("`{command}` shows what the texts have for it, `{list}` what this one holds.").format(
        command=f"cranktrain textbook {one_line(file)}", list=f"cranktrain textbook --source {text.name}"
    )


def _steam(console: Console, machine: Machine, result: Result, *, with_table: bool) -> bool:
    """Show the steam engine's forms and constructions; whether there are slider-cranks."""
    is_spoken_of = show_forms(console, machine, result, "steam-engine")
    cranks = [place for place in machine.places if place.kind.name == "slider_crank"]
    if cranks:
        groups = places_of_equal([place.geometry for place in cranks])
        show_from_crank_side(console, cranks, groups, with_table=with_table)
        show_constructions(console, machine, cranks, groups, with_table=with_table)
    return is_spoken_of


def _bolotin(console: Console, machine: Machine, result: Result, *, with_table: bool) -> bool:
    """Show slaves on articulated rods and opposed pistons; whether there are any."""
    is_spoken_of = show_forms(console, machine, result, "bolotin")
    show_constants(console, machine.places)
    cylinders = opposed_cylinders(machine.places)
    if cylinders:
        show_opposed(console, cylinders, result, with_table=with_table)
    return is_spoken_of or bool(cylinders)


def _gandzha(console: Console, machine: Machine, result: Result, *, with_table: bool) -> bool:
    """Show the pins' velocities of crank-rockers; whether there are any."""
    return show_crank_rockers(console, machine.places, with_table=with_table)


_SHOWN = {"steam-engine": _steam, _OF_CRANK_ROCKERS: _gandzha, "bolotin": _bolotin}
"""What each text has for a machine, by its name."""
