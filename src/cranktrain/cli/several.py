"""What may be typed after `compare`, `sweep` and `start`: several machines, or several designs of one."""

from typing import Annotated

import typer

from cranktrain.cli.options import (
    AtTimes,
    Decimal,
    File,
    Force,
    Partial,
    Quantities,
    Settings,
    StartOutput,
    Units,
    Why,
    listed,
)
from cranktrain.cli.task import put_off
from cranktrain.language import N_

Vary = Annotated[
    list[str] | None,
    typer.Option(
        "--vary",
        metavar="PATH=VALUES",
        help=N_("What is varied: 130..160 mm:31, or 1000, 1500 rpm, or words; as often as needed."),
    ),
]


def add_compare(app: typer.Typer) -> None:
    """Add the command to the others."""

    @app.command(
        "compare",
        help=N_(
            "Put two machines side by side, or one and itself with other values: rows with their difference.\n\n"
            "With two machines --set goes for both; with one the second is that one with the values set.\n\n"
            "\b\n"
            "  cranktrain compare 3d12 kamaz_740\n"
            "  cranktrain compare 3d12 kamaz_740 -o both.png\n"
            '  cranktrain compare vaz_21213 --set "shaft.main.speed=3000 rpm"\n'
            "  cranktrain compare jumo_205 jumo_205e --quantities combined_stroke,displacement"
        ),
    )
    @put_off
    def _compare(
        file: File,
        other: Annotated[
            str | None, typer.Argument(metavar="OTHER", help=N_("The second machine."), show_default=False)
        ] = None,
        settings: Settings = None,
        quantities: Quantities = None,
        why: Why = None,
        output: Annotated[
            str | None,
            typer.Option(
                "-o",
                "--output",
                metavar="FILE",
                help=N_("Write the facts of both: .csv, .json, .xlsx or .nc; or draw their curves: .png, .svg, .pdf."),
            ),
        ] = None,
        decimal: Decimal = "point",
        partial_turn: Partial = False,
        units: Units = None,
        force: Force = False,
    ) -> None:
        from cranktrain.cli.compare import CompareRequest, show_comparison

        names = None if quantities is None else listed(quantities)
        request = CompareRequest(
            file=file,
            second=other,
            settings=tuple(settings or ()),
            quantities=names,
            why=why,
            is_partial=partial_turn,
            output=output,
            decimal=decimal,
            force=force,
            units=units,
        )
        show_comparison(request)


def add_sweep(app: typer.Typer) -> None:
    """Add the command to the others."""

    @app.command(
        "sweep",
        help=N_(
            "Compute facts of a machine over values of its file: a curve, a map, or a list of designs.\n\n"
            "\b\n"
            "  cranktrain sweep vaz_21213 --vary rod_length=110..170mm:31 --wanted largest_side_force,largest_torque\n"
            '  cranktrain sweep vaz_21213 --vary rod_length=110..170mm:31 --vary "speed=2000, 5400 rpm" -o rods.png\n'
            '  cranktrain sweep 3d12 --vary "shaft.main.speed=1000..2000 rpm:11" -o speeds.csv\n'
            "  cranktrain sweep mine.toml --cases designs.csv --wanted largest_torque -o designs.xlsx\n"
            "  cranktrain sweep vaz_21213 --vary rod_length=110..170mm:100000 --yes -o rods.zarr --resume\n"
            "  cranktrain sweep tilting_table --start --vary drive.stage[0].ratio=30..50:5\n"
            "  cranktrain sweep vaz_21213 --vary rod_length=110..170mm:61 --least largest_side_force --save best.toml"
        ),
    )
    @put_off
    def _sweep(
        file: File,
        vary: Vary = None,
        cases: Annotated[
            str | None,
            typer.Option(
                "--cases",
                metavar="FILE",
                help=N_("Designs one by one instead: a .csv with a path at the head of each column."),
            ),
        ] = None,
        wanted: Annotated[
            str | None,
            typer.Option(
                metavar="A,B,…", help=N_("These facts; those that the machine's answer begins with unless given.")
            ),
        ] = None,
        least: Annotated[
            str | None, typer.Option(metavar="FACT", help=N_("Say which design has the least of this fact."))
        ] = None,
        most: Annotated[
            str | None, typer.Option(metavar="FACT", help=N_("Say which design has the most of this fact."))
        ] = None,
        save: Annotated[
            str | None, typer.Option(metavar="FILE", help=N_("With --least or --most: write that design's file."))
        ] = None,
        start: Annotated[
            bool, typer.Option("--start", help=N_("Facts of each design's start, as [drive.start] says."))
        ] = False,
        settings: Settings = None,
        output: Annotated[
            str | None,
            typer.Option(
                "-o",
                "--output",
                metavar="FILE",
                help=N_("Write the facts: .csv, .json, .xlsx, .nc or a store .zarr; or draw them: .png, .svg, .pdf."),
            ),
        ] = None,
        resume: Annotated[
            bool, typer.Option("--resume", help=N_("Go on with the store that -o names; where none is, begin it."))
        ] = False,
        processes: Annotated[
            str | None, typer.Option(metavar="N", help=N_("How many may work at once; all processors unless given."))
        ] = None,
        scheduler: Annotated[
            str | None, typer.Option(metavar="ADDRESS", help=N_("Let a cluster of Dask work: tcp://HOST:8786."))
        ] = None,
        yes: Annotated[bool, typer.Option("--yes", help=N_("However long it takes."))] = False,
        decimal: Decimal = "point",
        units: Units = None,
        force: Force = False,
    ) -> None:
        from cranktrain.cli.sweep import SweepRequest, show_sweep

        show_sweep(
            SweepRequest(
                file=file,
                vary=tuple(vary or ()),
                cases=cases,
                wanted=None if wanted is None else listed(wanted),
                least=least,
                most=most,
                save=save,
                over_time=start,
                settings=tuple(settings or ()),
                output=output,
                processes=processes,
                scheduler=scheduler,
                is_resumed=resume,
                is_meant=yes,
                decimal=decimal,
                units=units,
                force=force,
            )
        )


def add_start(app: typer.Typer) -> None:
    """Add the command to the others."""

    @app.command(
        "start",
        help=N_(
            "Run a machine with its motor over time: start, stall, coasting or braking, as [drive.start] says.\n\n"
            "\b\n"
            "  cranktrain start tilting_table\n"
            '  cranktrain start tilting_table --set "drive.start.angle=60 deg"\n'
            "  cranktrain start tilting_table --at 0,0.1..1\n"
            "  cranktrain start tilting_table -o start.csv\n"
            "  cranktrain start tilting_table -o start.png\n"
            "  cranktrain start tilting_table --vary drive.stage[0].ratio=30..50:5 --wanted start_duration"
        ),
    )
    @put_off
    def _start(
        file: File,
        output: StartOutput = None,
        settings: Settings = None,
        at: AtTimes = None,
        why: Why = None,
        vary: Vary = None,
        wanted: Annotated[
            str | None,
            typer.Option(metavar="A,B,…", help=N_("With --vary: these facts; how long, torques, heat unless given.")),
        ] = None,
        yes: Annotated[bool, typer.Option("--yes", help=N_("With --vary: however long it takes."))] = False,
        decimal: Decimal = "point",
        full: Annotated[bool, typer.Option("--full", help=N_("Show every event."))] = False,
        units: Units = None,
        force: Force = False,
    ) -> None:
        from cranktrain.cli.start import StartRequest, show_start

        show_start(
            StartRequest(
                file=file,
                settings=tuple(settings or ()),
                output=output,
                force=force,
                units=units,
                decimal=decimal,
                full=full,
                at=at,
                why=why,
                vary=tuple(vary or ()),
                wanted=None if wanted is None else listed(wanted),
                is_meant=yes,
            )
        )
