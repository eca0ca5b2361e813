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
from cranktrain.cli.textbook.beside_forms import (
    show_constants,
    show_constructions,
    show_exact_root,
    show_from_crank_side,
    show_opposed,
)
from cranktrain.cli.textbook.crank_rockers import show_crank_rockers
from cranktrain.cli.textbook.errata import show_errata
from cranktrain.cli.textbook.forms import explain_forms, show_forms, show_motion
from cranktrain.cli.textbook.source import machine_file
from cranktrain.cli.textbook.speaking import speaking
from cranktrain.cli.textbook.summary import go_on, show_summary
from cranktrain.cli.textbook.texts import show_text, show_texts
from cranktrain.errors import InputError, Position, Problem, refuse
from cranktrain.io.examples import example_names
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.one_line import one_line
from cranktrain.quantities import nearest
from cranktrain.references import REFERENCES
from cranktrain.textbook.alike import alike
from cranktrain.textbook.motion_statements import NEEDED as MOTION_NEEDED
from cranktrain.textbook.opposed_statements import NEEDED as OPPOSED_NEEDED
from cranktrain.textbook.opposed_statements import opposed_cylinders
from cranktrain.texts.contents import Text, text_called, text_named
from cranktrain.texts.plain_cranks import PLAIN

_ERRATA = "errata"
_STEP = 30.0
"""Of the run on which statements rest: they hang on no angle of its. [deg]"""
_OF_CRANK_ROCKERS = "gandzha"


def show_textbook(
    file: str, settings: Sequence[str], *, source: str | None = None, full: bool, with_table: bool, with_errata: bool
) -> None:
    """Show the texts, one of them, their errors, or how far their forms are off for a machine.

    Parameters
    ----------
    file : str
        A machine file or an example; `errata`, if no file is called so, for the sources' errors alone; none for what
        the texts hold.
    settings : sequence of str
        `PATH=VALUE`
    source : str, optional
        Name of the one text that is to be shown; with no name in it, all texts are listed.
    full : bool
        Whether to show all, not the first screen alone.
    with_table : bool
        Whether to show the motion over the turn.
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
        refuse(_without_machine(settings, with_table=with_table))
        with page(_("Errors of the sources, each with what is right")) as console:
            show_errata(console, text, full=full)
    elif source is not None and not file:
        refuse(_without_machine(settings, with_table=with_table))
        if text is None and full:
            raise InputError([Problem("--full", None, _("is for one text: name it, such as --source bolotin"))])
        show_texts() if text is None else show_text(text, has_forms=text.name in _SHOWN, full=full)
    else:
        if text_named(file) and not os.path.exists(file):  # noqa: PTH110 - takes a NUL byte
            allowed = _("is a text, and no machine file is called so")
            repair = _("such as: {example}", example=f"cranktrain textbook --source {file}")
            raise InputError([Problem("", None, allowed, repair, Position(file))])
        _refuse_misspelt(file)
        _show_machine(file, settings, text, full=full, with_table=with_table, with_errata=with_errata)


def _refuse_misspelt(file: str) -> None:
    """Refuse what is no file, and nearly the word for the errors."""
    if not os.path.exists(file) and nearest(file, [_ERRATA, *example_names()]) == _ERRATA:  # noqa: PTH110 - NUL bytes
        allowed, repair = _("there is no such file"), _("did you mean {name}?", name=_ERRATA)
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
            repair = _("a machine stands before it: cranktrain textbook {file}", file=one_line(name))
            raise InputError([replace(one, repair=repair) for one in error.problems]) from None
        raise


def _show_machine(
    file: str, settings: Sequence[str], text: Text | None, *, full: bool, with_table: bool, with_errata: bool
) -> None:
    """Show what the texts, or one of them, have for a machine: all, or the first screen."""
    examples = _("{one}, or {other}", one="cranktrain textbook 3d12", other="cranktrain textbook --source")
    machine = machine_file(file, settings, examples).machine
    with says_how_far():
        result = run(machine, step_degrees=_STEP, quantities=(*MOTION_NEEDED, *OPPOSED_NEEDED))
    with page(title(machine)) as console:
        if full:
            is_spoken_of = _show_all(console, machine, result, text, with_table=with_table)
        elif is_spoken_of := show_summary(console, machine, result, text, with_table=with_table):
            section(console, _("To go on"), go_on(machine, file, settings, text, with_table=with_table))
        if not is_spoken_of:
            section(console, _("Textbook forms"), _unspoken(machine, file, settings, text))
        if with_errata:
            console.print()
            console.print(Line(_("Errors of the sources, each with what is right"), style="bold"))
            show_errata(console, text, full=full)


def _show_all(console: Console, machine: Machine, result: Result, text: Text | None, *, with_table: bool) -> bool:
    """Show all that the texts, or one, have for a machine; whether there is anything."""
    shown = {name: show for name, show in _SHOWN.items() if text is None or name == text.name}
    spoken = [name for name, show in shown.items() if show(console, machine, result, with_table=with_table)]
    if spoken:
        if spoken != [_OF_CRANK_ROCKERS]:
            explain_forms(console)
        if with_table:
            show_motion(console, machine, spoken)
        rows = [(f"[{name}]", REFERENCES[name].text) for name in spoken]
        section(console, _("Sources"), table(("", ""), rows, fold=console.width - INDENT))
    return bool(spoken)


def _unspoken(machine: Machine, file: str, settings: Sequence[str], text: Text | None) -> Iterator[str]:
    """Say that no text, or not this one, has anything for a machine."""
    kinds = ", ".join(dict.fromkeys(place.kind.name for place in machine.places))
    if text is None:
        yield _("None of the texts has a form of its own for the motion of: {kinds}.", kinds=kinds)
        return
    yield _(
        "[{name}] speaks of {subject}; the mechanisms of this machine are: {kinds}.",
        name=text.name,
        subject=_(text.said_of),
        kinds=kinds,
    )
    yield _("`{list}`: what this text holds", list=f"cranktrain textbook --source {text.name}")
    for command in speaking(machine, file, settings):
        yield _("`{command}` has something for this machine", command=command)


def _steam(console: Console, machine: Machine, result: Result, *, with_table: bool) -> bool:
    """Show the steam engine's forms and constructions; whether there are slider-cranks or eccentrics."""
    is_spoken_of = show_forms(console, machine, result, "steam-engine")
    pistons = alike(machine.places, PLAIN)
    if pistons:
        show_exact_root(console, pistons, [place for place in machine.places if place.kind.name in PLAIN])
        show_from_crank_side(console, pistons, with_table=with_table)
        show_constructions(console, machine, pistons, with_table=with_table)
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
