"""`textbook --forces`: reads whose forces are asked for, and shows their tables."""

from cranktrain.cli.screen.sections import show_page
from cranktrain.cli.textbook.source import machine_file
from cranktrain.cli.textbook.typed import TextbookRequest
from cranktrain.errors import problems_as, refuse
from cranktrain.io.title import title
from cranktrain.language import said as _
from cranktrain.plans.force_table import force_table
from cranktrain.textbook.commands import textbook_command
from cranktrain.textbook.shown.forces import force_sections
from cranktrain.textbook.speaking import with_speaking

_STEP = 30.0
"""Of the crank angle unless given. [deg]"""


def show_force_tables(asked: TextbookRequest) -> None:
    """Show the tables: with `full` the forces by each method, too, with their errors at every angle.

    Raises
    ------
    InputError
        With everything that is wrong with the machine, or with the request.
    """
    unit, step = asked.forces or "", _STEP if asked.step is None else asked.step
    refuse(asked.beside(_("is for the motion: ask for it without forces"), "--source", "--table", "--errata"))
    file = machine_file(asked, f"cranktrain textbook 3d12 --forces {unit}")
    with (
        problems_as(lambda problem: problem if problem.path.startswith("-") else file.document.located(problem)),
        problems_as(with_speaking(file.machine, asked.file or "", asked.settings, ("mechanism",))),
    ):
        table = force_table(file.machine, step=step, unit=unit, piston=asked.piston)
    typed = asked.typed("--piston") if step == _STEP else asked.typed("--step", "--piston")
    options = (word for pair in typed for word in pair)
    whole = textbook_command(asked.file or "", "--forces", unit, *options, "--full", settings=asked.settings)
    show_page(title(file.machine), force_sections(table, whole=None if asked.full else whole))
