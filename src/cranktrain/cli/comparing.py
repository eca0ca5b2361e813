"""What may be typed after `compare`."""

from typing import Annotated

import typer

from cranktrain.cli.options import Decimal, File, Force, Partial, Quantities, Settings, Units, Why, listed
from cranktrain.cli.task import put_off
from cranktrain.language import N_


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
