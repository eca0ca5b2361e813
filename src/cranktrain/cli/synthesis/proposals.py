"""A proposal: asked for, written, shown, and how to go on."""

import shlex
import tomllib
from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from functools import partial as with_arguments
from pathlib import PurePath
from typing import TYPE_CHECKING

from cranktrain.cli.asked import in_units_of
from cranktrain.cli.how_far import says_how_far
from cranktrain.cli.quiet_pictures import save_quietly
from cranktrain.cli.run_files import form_of, write_run
from cranktrain.cli.screen.sections import show_sections
from cranktrain.cli.screen.text import page
from cranktrain.cli.synthesis.requirements import Typed, proposed
from cranktrain.how_far import say_how_far
from cranktrain.io.added_tables import with_tables, with_values
from cranktrain.io.machine_file import MachineFile, read_machine
from cranktrain.io.output import STANDARD_OUTPUT, write_machine_file
from cranktrain.io.writers import Form
from cranktrain.language import Words
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.one_line import one_line
from cranktrain.saying.typesetting import printed
from cranktrain.saying.wording import number
from cranktrain.synthesis.counterweights import CounterweightProposal
from cranktrain.synthesis.proposal import MachineProposal, Proposal
from cranktrain.synthesis.proposal_sections import proposal_sections
from cranktrain.textbook.shown.errata import first_errors
from cranktrain.textbook.shown.synthesis import SOURCE_EXAMPLE, step_sections
from cranktrain.textbook.synthesis_statements import SOURCE as SYNTHESIS
from cranktrain.texts.contents import text_called
from cranktrain.viz.output import FORMATS

if TYPE_CHECKING:
    from matplotlib.figure import Figure

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
        File to write: the machine file, `-` for that alone on the standard output; the numbers, by the suffix; a
        picture for its plan of positions, of what is for no machine that there is.
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
    form = _form(output, () if file is not None else FORMATS)
    is_own = with_source and not any(typed.get(name) for name in SOURCE_EXAMPLE)
    wanted = _with_example(typed) if is_own else typed
    with says_how_far():
        proposal = proposed(problem, wanted, file, None if file is None else _progress)
    suffix = PurePath(output or "").suffix.lower()
    is_plan = suffix in FORMATS and file is None
    if output is not None and form is not None:
        write_run(proposal, form, output, {}, force=force)
        return
    if is_plan:
        write_plan(output or "", proposal.machine_file(), force=force)
    elif output is not None:
        write_machine_file(output, _machine_file(proposal, file), force=force)
    if output in STANDARD_OUTPUT:
        return
    with page(one_line(str(proposal.title))) as console:
        show_sections(console, proposal_sections(proposal))
        if with_source:
            with printed():
                show_sections(console, () if is_own else step_sections(typed))
                show_sections(console, first_errors(text_called(SYNTHESIS)))
        console.print()
        if output is None:
            said = _("-o FILE.toml writes it as a machine file, for: cranktrain run FILE.toml")
        elif is_plan:
            said = _("written: {name}", name=one_line(output))
        else:
            command = shlex.join(["cranktrain", "run", one_line(output)])
            said = _("written: {name}; go on with: {command}", name=one_line(output), command=command)
        console.print(said, soft_wrap=True)


def _form(output: str | None, pictures: Sequence[str]) -> Form | None:
    """How numbers are to be written; None of a machine file, of one without a suffix, too, or a picture."""
    is_named = output is not None and output not in STANDARD_OUTPUT and PurePath(output).suffix
    return form_of(output, others=(".toml", *pictures)) if output is not None and is_named else None


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
