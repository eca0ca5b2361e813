"""A proposal on the screen: its numbers, what else was considered, remarks, and how to go on."""

import shlex
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import nullcontext
from functools import partial as with_arguments
from pathlib import PurePath
from typing import TYPE_CHECKING

from rich.console import Console
from rich.text import Text

from cranktrain.cli.asked import in_units_of
from cranktrain.cli.how_far import says_how_far
from cranktrain.cli.quiet_pictures import save_quietly
from cranktrain.cli.screen.columns import Column, column_tables, worded_tables
from cranktrain.cli.screen.text import INDENT, page, section, table
from cranktrain.cli.screen.typesetting import printed
from cranktrain.cli.synthesis.requirements import Typed, proposed
from cranktrain.cli.textbook.errata import SOURCE_EXAMPLE, show_first_errors
from cranktrain.cli.textbook.synthesis import show_steps
from cranktrain.grouping import grouped
from cranktrain.how_far import say_how_far
from cranktrain.io.added_tables import with_tables, with_values
from cranktrain.io.machine_file import MachineFile, read_machine
from cranktrain.io.output import STANDARD_OUTPUT, write_machine_file
from cranktrain.language import Words
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.one_line import one_line
from cranktrain.quantities import chosen_unit
from cranktrain.saying.wording import figure, number
from cranktrain.synthesis.counterweights import CounterweightProposal
from cranktrain.synthesis.proposal import MachineProposal, Number, Proposal
from cranktrain.textbook.synthesis_statements import SOURCE as SYNTHESIS
from cranktrain.viz.output import FORMATS

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_ROUNDING = 1e-12
"""Of the largest number of a column: below it is nothing but rounding."""

_POSITIONS = 12


def give_proposal(
    problem: str,
    typed: Typed,
    output: str | None,
    *,
    force: bool,
    with_source: bool = False,
    source: str | None = None,
) -> None:
    """Find dimensions, write their machine file where one is asked for, and show them.

    Parameters
    ----------
    problem : str
        As `proposed` takes it.
    typed : mapping
        The requirements.
    output : str or None
        File to write; `-` for the machine file alone on the standard output; a picture for its plan of positions, of
        what is for no machine that there is.
    force : bool
        Replace a file that is there.
    with_source : bool
        Whether to show the source's own example and its errors, with no requirement typed for its requirements.
    source : str or None
        Machine file or example that it is for, where it is for one.
    """
    file = None if source is None else read_machine(source)
    with nullcontext() if file is None else in_units_of(file):
        _give_proposal(problem, typed, output, file, force=force, with_source=with_source)


def _give_proposal(
    problem: str, typed: Typed, output: str | None, file: MachineFile | None, *, force: bool, with_source: bool
) -> None:
    """Do so, in the units in which numbers are shown."""
    is_own = with_source and not any(typed.get(name) for name in SOURCE_EXAMPLE)
    wanted = _with_example(typed) if is_own else typed
    with says_how_far():
        proposal = proposed(problem, wanted, file, None if file is None else _progress)
    is_plan = output is not None and PurePath(output).suffix.lower() in FORMATS and file is None
    if is_plan:
        write_plan(output or "", proposal.machine_file(), force=force)
    elif output is not None:
        write_machine_file(output, _machine_file(proposal, file), force=force)
    if output in STANDARD_OUTPUT:
        return
    with page(one_line(str(proposal.title))) as console:
        show_proposal(console, proposal)
        if with_source:
            with printed():
                if not is_own:
                    show_steps(console, typed)
                show_first_errors(console, SYNTHESIS)
        console.print()
        if output is None:
            said = _("-o FILE.toml writes it as a machine file, for: cranktrain run FILE.toml")
        elif is_plan:
            said = _("written: {name}", name=one_line(output))
        else:
            command = shlex.join(["cranktrain", "run", one_line(output)])
            said = _("written: {name}; go on with: {command}", name=one_line(output), command=command)
        console.print(said, soft_wrap=True)


def _with_example(typed: Typed) -> Typed:
    """Take the source's own example for what is not typed; a crank's speed stands for the slider's."""
    own = {name: value for name, value in SOURCE_EXAMPLE.items() if name != "mean_speed" or not typed.get("speed")}
    return {**own, **{name: value for name, value in typed.items() if value}}


def _progress(reached: float, bound: float) -> None:
    """Say how far a search is."""
    say_how_far(with_arguments(_how_far, reached, bound))


def _how_far(reached: float, bound: float) -> str:
    said = _("searching: {reached} reached, nothing goes below {bound}")
    return said.format(reached=number(reached, "kN"), bound=number(bound, "kN"))


def _machine_file(proposal: Proposal, file: MachineFile | None) -> str:
    """The machine file of a proposal; of one for a machine, that one's own with what is proposed in it."""
    if file is not None and isinstance(proposal, MachineProposal):
        return with_values(file.document.text, _said(proposal.values), proposal.whole)
    if file is None or not isinstance(proposal, CounterweightProposal):
        return proposal.machine_file()
    tables = [_said(table.keys) for table in proposal.tables]
    return with_tables(file.document.text, "balance.weight", tables, proposal.taken_out)


def _said(values: Mapping[str, Words]) -> dict[str, str]:
    """What is to stand in a file, said."""
    return {key: str(value) for key, value in values.items()}


def show_proposal(console: Console, proposal: Proposal) -> None:
    """Show numbers, alternatives and remarks."""
    width = console.width - INDENT
    section(console, _("Proposed"), _numbers(proposal.numbers, width))
    section(console, _("Also considered"), _alternatives(proposal, width))
    section(console, _("Mind"), map(str, proposal.remarks))


def _numbers(numbers: Sequence[Number], width: int) -> Iterator[str | Text]:
    """Numbers one in a line; those of several members, such as the strokes of cylinders, in columns."""
    single = [one for one in numbers if not one.member]
    if single:
        rows = [(str(one.sentence), one.symbol, figure(one.value, one.unit), _unit(one)) for one in single]
        yield from table(("", "", "", ""), rows, right=(2,))
    several = grouped((one.name, one) for one in numbers if one.member)
    members = grouped((tuple(one.member for one in each), each) for each in several.values())
    for i, (labels, columns) in enumerate(members.items()):
        if i or single:
            yield ""
        yield from column_tables([_column(each[0], each) for each in columns], labels, width)
        yield ""
        yield _legend([each[0] for each in columns])


def _alternatives(proposal: Proposal, width: int) -> Iterator[str | Text]:
    """Tables of alternatives, one for each set of numbers; those that the proposal has too stand beside its own."""
    own = {one.key: one for one in proposal.numbers}
    others = [(str(label), {one.key: one for one in numbers}) for label, numbers in proposal.alternatives]
    families = grouped((tuple(own if set(other) <= set(own) else other), (label, other)) for label, other in others)
    for i, (names, rows) in enumerate(families.items()):
        if i:
            yield ""
        if names == tuple(own):
            rows.insert(0, (_("as proposed"), own))
        shown = {name: next(numbers[name] for _label, numbers in rows if name in numbers) for name in names}
        columns = {name: _column(one, [numbers.get(name) for _label, numbers in rows]) for name, one in shown.items()}
        kept = [name for name, column in columns.items() if len(set(filter(None, column.texts))) > 1] or list(columns)
        yield from worded_tables([columns[name] for name in kept], [label for label, _numbers in rows], width)
        yield ""
        yield _legend([shown[name] for name in kept])


def _column(like: Number, numbers: Sequence[Number | None]) -> Column:
    """A column of one kind of number; empty where a row has none."""
    least = _ROUNDING * max((abs(one.value) for one in numbers if one is not None), default=0.0)
    texts = tuple(
        "" if one is None else figure(one.value if abs(one.value) > least else 0.0, one.unit) for one in numbers
    )
    return Column(like.symbol, _unit(like), texts)


def _unit(one: Number) -> str:
    """Unit in which it is shown; nothing for a plain number."""
    return chosen_unit(one.unit) or one.unit.removeprefix("1")


def _legend(numbers: Sequence[Number]) -> str:
    """Say what the symbols are."""
    said = [(one.symbol, str(one.sentence)) for one in numbers]
    return "; ".join(f"{symbol} {sentence[:1].lower()}{sentence[1:]}" for symbol, sentence in said)


def write_plan(path: str, text: str, *, force: bool) -> None:
    """Draw the mechanism of a machine file in twelve positions; a slider-crank in those of [slider-crank-synthesis].

    Parameters
    ----------
    path : str
        Ends in one of `cranktrain.viz.output.FORMATS`.
    text : str
        The machine file.
    force : bool
        Replace a file that is there.

    Raises
    ------
    InputError
        If the picture cannot be written.
    """
    machine = Machine(**tomllib.loads(text))
    save_quietly(lambda: _drawn(machine), path, force=force)


def _drawn(machine: Machine) -> "Figure":
    from cranktrain.plans.positions import source_angles
    from cranktrain.viz.plans.positions import plan_positions

    is_direct = machine.places[0].kind.is_direct
    return plan_positions(machine, source_angles(machine) if is_direct else _POSITIONS)
