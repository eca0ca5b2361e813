"""What the texts have for a machine: a first screen, or all; how to go on; or that none speaks of it."""

from collections.abc import Iterator, Sequence

from cranktrain.analysis import Result
from cranktrain.errors import InputError
from cranktrain.language import N_, Listed, _
from cranktrain.machine import Machine
from cranktrain.plans.machine_drive import machine_drive, missing_values
from cranktrain.references import REFERENCES
from cranktrain.saying.percents import percent
from cranktrain.saying.sections import PagePart, Part, Rows, ShownSection, section
from cranktrain.textbook.commands import textbook_command
from cranktrain.textbook.shown.forms import motion_sections, usual_sections
from cranktrain.textbook.shown.of_machine import FormErrors, MachinePage, texts_for
from cranktrain.textbook.speaking import speaking
from cranktrain.texts.contents import Text

LARGEST_ERRORS = N_("Largest errors over the turn")
OF_WHAT = N_("Δx in parts of the stroke, Δv and Δj of their exact peaks; of several members the largest.")
"""What the largest errors of forms are errors of."""


def whole_machine(machine: Machine, result: Result, text: Text | None, *, with_table: bool) -> Iterator[PagePart]:
    """Give all that the texts, or one, have for a machine; nothing of one of which none speaks."""
    has = texts_for(machine, text)
    for one in has.values():
        yield from one.whole(MachinePage(machine, result, with_table, text is not None))
    if any(one.usual for one in has.values()):
        explained = _(
            "Δx in parts of the stroke, Δv and Δj of their exact peaks, each curve from its own top; φ after the crank "
            "points along the cylinder, or an eccentric to its valve. λ is crank radius by rod, of a slave its "
            "master's, of an eccentric e/l."
        )
        yield ShownSection(_(LARGEST_ERRORS), (explained,))
    if with_table:
        yield from motion_sections(machine, [one.name for one in has])
    if has:
        yield ShownSection(_("Sources"), (Rows([(f"[{one.name}]", REFERENCES[one.name].text) for one in has]),))


def first_of_machine(machine: Machine, result: Result, text: Text | None, *, with_table: bool) -> Iterator[PagePart]:
    """Give how far each form is off, or with a table the motion by the usual one; nothing where no text speaks."""
    page, has = MachinePage(machine, result, with_table, text is not None), texts_for(machine, text)
    if with_table:
        usual = [part for one, own in has.items() for part in usual_sections(machine, one.name, own.usual)]
        yield from usual
        if usual:
            yield _("Angles count from where a crank points along its cylinder, or an eccentric to its valve.")
    else:
        yield from section(_(LARGEST_ERRORS), _errors([row for own in has.values() for row in own.errors(page)]))
    for own in has.values():
        yield from own.beside(page)


def _errors(rows: Sequence[FormErrors]) -> Iterator[Part]:
    """Lay out errors, and say what they are errors of."""
    if rows:
        cells = [(one.equations, *map(percent, one.errors), Listed((one.of, one.words), ": ")) for one in rows]
        yield Rows([("", "%", "%", "%", ""), *cells], ("", "Δx", "Δv", "Δj", ""), right=(1, 2, 3))
        yield ""
        yield _(OF_WHAT)


def how_to_go_on(
    machine: Machine, file: str, settings: Sequence[str], text: Text | None, *, with_table: bool
) -> Iterator[ShownSection]:
    """Say what shows the rest."""
    has_rocker = any(place.kind.name == "crank_rocker" for place in machine.places)
    said = _to_drive(machine, file, settings) if has_rocker else _to_forms(file, settings, text, with_table=with_table)
    yield from section(_("To go on"), said)


def _to_forms(file: str, settings: Sequence[str], text: Text | None, *, with_table: bool) -> Iterator[Part]:
    """Say what shows the rest of the forms."""
    asked = [file, *(["--source", text.name] if text else [])]
    after_table = {
        ("--table", "--full"): N_("`{command}`: every method, and all else that the texts have over the turn"),
        (): N_("`{command}`: how far the forms are off"),
    }
    after_errors = {
        ("--full",): N_("`{command}`: ranges, where the errors are largest, constructions, constants"),
        ("--table",): N_("`{command}`: the motion over the turn"),
    }
    for more, words in (after_table if with_table else after_errors).items():
        yield _(words, command=textbook_command(*asked, *more, settings=settings))


def _to_drive(machine: Machine, file: str, settings: Sequence[str]) -> Iterator[Part]:
    """Say what shows the machine's drive, with values for what it lacks; nothing of a linkage that has none so."""
    lacking = missing_values(machine)
    try:
        machine_drive(machine, lacking)
    except InputError:
        return
    own = [f"{symbol}={value}" for symbol, value in lacking.items()]
    command = textbook_command("--drive", file, settings=(*settings, *own))
    said = (
        _("`{command}`: (1) to (21), its drive with them; the machine does not say {symbols}: put in your own")
        if lacking
        else _("`{command}`: (1) to (21), its drive with them")
    )
    yield said.format(command=command, symbols=", ".join(lacking))


def unspoken_of(machine: Machine, file: str, settings: Sequence[str], text: Text | None) -> ShownSection:
    """Say that no text, or not this one, has anything for a machine."""
    kinds = ", ".join(dict.fromkeys(place.kind.name for place in machine.places))
    if text is None:
        said = [_("None of the texts has a form of its own for the motion of: {kinds}.", kinds=kinds)]
    else:
        about = _("[{name}] speaks of {subject}; the mechanisms of this machine are: {kinds}.")
        commands = speaking(machine, file, settings)
        said = [
            about.format(name=text.name, subject=_(text.said_of), kinds=kinds),
            _("`{list}`: what this text holds", list=f"cranktrain textbook --source {text.name}"),
            *(_("`{command}` has something for this machine", command=command) for command in commands),
        ]
    return ShownSection(_("Textbook forms"), said)
