"""What may be typed: the commands with their arguments, options and help. A command is done when Typer has returned."""

from collections.abc import Sequence
from typing import Annotated, Any

import typer

from cranktrain.cli.naming_pictures import NamingPictures
from cranktrain.cli.options import (
    AllTables,
    At,
    Checks,
    CurveTable,
    Decimal,
    Every,
    Facts,
    File,
    Force,
    Full,
    Inputs,
    Missing,
    OfMember,
    Output,
    Partial,
    Quantities,
    ResultsOutput,
    RunningSpeed,
    Settings,
    SpeedCurve,
    Units,
    Why,
    degrees,
    listed,
)
from cranktrain.cli.several import add_compare, add_start, add_sweep
from cranktrain.cli.task import Task, commands_of, put_off, task_of
from cranktrain.cli.texts import add_textbook
from cranktrain.cli.tools import add_tools
from cranktrain.language import N_
from cranktrain.version import VERSION

# Typer's own handlers would swallow Ctrl-C and closed pipes, so that nothing runs before it has returned; its Rich help
# costs as much time as a run.
_app = typer.Typer(
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)


def task(arguments: Sequence[str]) -> Task:
    """What a command line asks for; errors of usage are `InputError`."""
    return task_of(_app, arguments, "cranktrain")


def commands() -> Any:
    """All commands with their arguments and options, as Typer's group of them."""
    return commands_of(_app)


def _version(asked: bool) -> None:
    if asked:
        typer.echo(f"cranktrain {VERSION}")
        raise typer.Exit


@_app.callback(
    help=N_(
        "Exact mechanics of any machine with a crank in it.\n\n"
        "\b\n"
        "To start:\n"
        "  cranktrain list                           the examples\n"
        "  cranktrain run 3d12                       what one of them does\n"
        "  cranktrain new slider_crank -o mine.toml  a machine file of your own"
    )
)
def _cranktrain(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help=N_("Say the version and end."))
    ] = False,
) -> None:
    del version


@_app.command(
    "list",
    help=N_(
        "List examples (unless said otherwise), kinds of mechanism, or results; or all that leads to one of these.\n\n"
        "\b\n"
        "  cranktrain list\n"
        "  cranktrain list kinds\n"
        "  cranktrain list results | grep dead_centre\n"
        "  cranktrain list results --behind largest_bearing_load --of 3d12"
    ),
)
@put_off
def _list(
    what: Annotated[str, typer.Argument(metavar="[examples|kinds|results]", show_default=False)] = "examples",
    behind: Annotated[
        str | None,
        typer.Option(
            "--behind",
            metavar="RESULT",
            help=N_("What leads to this result: tables of the file, stages in their order, with file and equation."),
        ),
    ] = None,
    of: Annotated[
        str | None, typer.Option("--of", metavar="FILE", help=N_("With --behind: in this machine file, or example."))
    ] = None,
) -> None:
    from cranktrain.cli.lists import show_list

    show_list(what, behind, of)


@_app.command(
    "new",
    help=N_(
        "Give a commented machine file of one KIND of mechanism, ready to run, or a copy of an example.\n\n"
        "`cranktrain list kinds` and `cranktrain list examples` name them.\n\n"
        "\b\n"
        "  cranktrain new slider_crank\n"
        "  cranktrain new crank_rocker -o mine.toml\n"
        "  cranktrain new walschaerts --full -o locomotive.toml\n"
        "  cranktrain new 3d12 -o engine.toml"
    ),
)
@put_off
def _new(
    kind: Annotated[str, typer.Argument(metavar="KIND", show_default=False)],
    full: AllTables = False,
    output: Output = None,
    force: Force = False,
) -> None:
    from cranktrain.cli.new import write_new

    write_new(kind, output, full=full, force=force)


@_app.command(
    "check",
    help=N_(
        "Say all that is wrong with a machine file, or what it allows to compute.\n\n"
        "\b\n"
        "  cranktrain check 3d12\n"
        "  cranktrain check r-1340"
    ),
)
@put_off
def _check(file: File) -> None:
    from cranktrain.cli.check import show_check

    show_check(file)


@_app.command(
    "run",
    help=N_(
        "Compute all that a machine file allows, and show the answer on one screen.\n\n"
        "\b\n"
        "  cranktrain run 3d12\n"
        "  cranktrain run 3d12 --full\n"
        '  cranktrain run 3d12 --set "shaft.main.speed=1800 rpm"\n'
        "  cranktrain run 3d12 --quantities stroke,piston_displacement\n"
        "  cranktrain run 3d12 --at 140 --quantities piston_force,side_force\n"
        "  cranktrain run 3d12 --table forces --piston 1R --every 15\n"
        '  cranktrain run 3d12 --why "side force"\n'
        "  cranktrain run 3d12 -o 3d12.csv --step 0.5\n"
        "  cranktrain run 3d12 -o facts.csv --facts --decimal comma\n"
        "  cranktrain run 3d12 --running-speed"
    ),
)
@put_off
def _run(
    file: File,
    output: ResultsOutput = None,
    settings: Settings = None,
    quantities: Quantities = None,
    step: Annotated[
        float, typer.Option(metavar="DEGREES", parser=degrees, help=N_("Of the crank angle, in curves."))
    ] = 1.0,
    at: At = None,
    table: CurveTable = None,
    of: OfMember = None,
    every: Every = None,
    running_speed: RunningSpeed = False,
    speed_curve: SpeedCurve = None,
    partial_turn: Partial = False,
    decimal: Decimal = "point",
    facts: Facts = False,
    full: Full = False,
    checks: Checks = False,
    inputs: Inputs = False,
    missing: Missing = False,
    why: Why = None,
    units: Units = None,
    force: Force = False,
) -> None:
    from cranktrain.cli.asked import CurvesAsked
    from cranktrain.cli.run import RunRequest, Shown, show_run

    names = None if quantities is None else listed(quantities)
    request = RunRequest(
        file=file,
        settings=tuple(settings or ()),
        quantities=names,
        step_degrees=step,
        is_partial=partial_turn,
        is_at_running_speed=running_speed,
        speed_curve=speed_curve,
        output=output,
        force=force,
        units=units,
        decimal=decimal,
        facts=facts,
        curves=CurvesAsked(at, table, of, every),
        why=why,
    )
    show_run(request, Shown(full=full, checks=checks, inputs=inputs, missing=missing))


add_compare(_app)
add_sweep(_app)
add_start(_app)


@_app.command(
    "plot",
    help=N_(
        "Draw a machine: its sheet, a plan, a moving picture or a DXF; the file's name says which.\n\n"
        "\b\n"
        "  cranktrain plot 3d12 -o 3d12.png\n"
        "  cranktrain plot 3d12 --plan positions --count 12 --mechanism 1L -o positions.svg\n"
        "  cranktrain plot 3d12 --plan accelerations --at 30,60 -o accelerations.pdf\n"
        "  cranktrain plot 3d12 --plan forces --at 30,60 --mechanism 1L -o polygons.svg\n"
        "  cranktrain plot 3d12 --sheet forces -o forces.pdf\n"
        "  cranktrain plot vaz_21213 --sheet forces --running-speed -o running.pdf\n"
        "  cranktrain plot pumping_unit_c57 -o unit.gif"
    ),
    cls=NamingPictures,
)
@put_off
def _plot(
    file: File,
    output: Annotated[
        str | None,
        typer.Option(
            "-o",
            "--output",
            metavar="FILE",
            help=N_("Needed. .png, .svg or .pdf: a sheet, or a plan; .gif: one turn; .dxf: all plans in one."),
        ),
    ] = None,
    plan: Annotated[
        str | None,
        typer.Option(
            metavar="PLAN",
            help=N_("A plan, a construction of the old texts or a diagram: {pictures}."),
        ),
    ] = None,
    sheet: Annotated[
        str | None,
        typer.Option(metavar="SHEET", help=N_("The sheet of the machine, unless given; one of: {pictures}.")),
    ] = None,
    at: Annotated[
        str | None,
        typer.Option(
            metavar="ANGLES",
            help=N_(
                "Crank angles in degrees, such as 30,60; `source` the source's twelve, "
                "`source 30` at that permissible pressure angle."
            ),
        ),
    ] = None,
    count: Annotated[
        str | None, typer.Option(metavar="N", help=N_("Of a plan: at how many crank angles, evenly over a turn."))
    ] = None,
    mechanism: Annotated[
        str | None,
        typer.Option(metavar="NAME", help=N_("Which one a plan, the sheet of forces or a .dxf is of, such as 1R.")),
    ] = None,
    size: Annotated[str | None, typer.Option(metavar="A4|A3", help=N_("Of the paper; A4 unless given."))] = None,
    scale: Annotated[
        str | None,
        typer.Option(
            metavar="1:N", help=N_("Of a sheet, positions and constructions; the largest that fits unless given.")
        ),
    ] = None,
    letters: Annotated[
        str | None,
        typer.Option(metavar="SOURCE", help=N_("Of a scheme: letters as a source has them, such as bolotin.")),
    ] = None,
    method: Annotated[
        str | None,
        typer.Option(
            metavar="METHOD,…",
            help=N_("Of main bearings, in the sheets crankshaft and wear: split, five_moment; all, each by itself."),
        ),
    ] = None,
    units: Units = None,
    running_speed: RunningSpeed = False,
    speed_curve: SpeedCurve = None,
    settings: Settings = None,
    partial_turn: Partial = False,
    force: Force = False,
) -> None:
    from cranktrain.cli.plot import PlotRequest, write_picture

    request = PlotRequest(
        file=file,
        settings=tuple(settings or ()),
        is_partial=partial_turn,
        output=output,
        force=force,
        plan=plan,
        at=at,
        mechanism=mechanism,
        size=size,
        count=count,
        scale=scale,
        letters=letters,
        method=method,
        units=units,
        sheet=sheet,
        is_at_running_speed=running_speed,
        speed_curve=speed_curve,
    )
    write_picture(request)


@_app.command(
    "view",
    help=N_(
        "Write the machine as a page in which it moves beside its curves; it needs no server and no network.\n\n"
        "\b\n"
        "  cranktrain view 3d12 -o 3d12.html\n"
        '  cranktrain view vaz_21213 --set "shaft.main.speed=3000 rpm" -o vaz.html'
    ),
)
@put_off
def _view(
    file: File,
    output: Annotated[
        str | None, typer.Option("-o", "--output", metavar="FILE", help=N_("Needed: the page, .html."))
    ] = None,
    units: Units = None,
    settings: Settings = None,
    partial_turn: Partial = False,
    force: Force = False,
) -> None:
    from cranktrain.cli.asked import Asked
    from cranktrain.cli.view import write_page

    write_page(Asked(file, tuple(settings or ()), partial_turn, output, force, units))


@_app.command(
    "web",
    help=N_(
        "Serve a page to this computer, on which machines move, and any of their numbers may be changed.\n\n"
        "\b\n"
        "  cranktrain web\n"
        "  cranktrain web 3d12"
    ),
)
@put_off
def _web(
    file: Annotated[
        str | None,
        typer.Argument(metavar="[FILE]", help=N_("A machine file, or the name of an example."), show_default=False),
    ] = None,
    port: Annotated[int | None, typer.Option(metavar="N", help=N_("The first that is free unless given."))] = None,
    host: Annotated[
        str, typer.Option(metavar="HOST", help=N_("At which it listens; others ask for a token."))
    ] = "127.0.0.1",
    no_browser: Annotated[
        bool, typer.Option("--no-browser", help=N_("Open no browser; say the address alone."))
    ] = False,
) -> None:
    from cranktrain.cli.web import serve

    serve(file, port, host, opens=not no_browser)


@_app.command(
    "synthesise",
    add_help_option=False,
    context_settings={"ignore_unknown_options": True, "allow_extra_args": True, "allow_interspersed_args": False},
    help=N_("Find dimensions for what a mechanism is to do, and write its machine file."),
)
@put_off
def _synthesise(context: typer.Context) -> None:
    from cranktrain.cli.synthesis.command import app  # its many options are told to Typer only when they are needed

    task_of(app, context.args, "cranktrain synthesise")()


add_textbook(_app)
add_tools(_app)
