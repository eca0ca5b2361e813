"""What may be typed after `textbook`, whose option `--source` may stand without a name."""

from collections.abc import Callable
from functools import wraps
from typing import Annotated, Any, ParamSpec

import typer
from typer.core import TyperCommand

from cranktrain.cli.options import Force, Settings, degrees
from cranktrain.cli.task import put_off
from cranktrain.language import N_

_OPTION = "--source"

_Given = ParamSpec("_Given")


class OptionalSource(TyperCommand):
    """A command whose option `--source` without a name asks for a list; Typer would say that it is missing."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Read what was typed, an empty name where none follows."""
        given = list(args)
        for place, word in enumerate(given):
            if word == _OPTION and (place + 1 == len(given) or given[place + 1].startswith("-")):
                given.insert(place + 1, "")
                break
        return super().parse_args(ctx, given)


def _in_print(command: Callable[_Given, None]) -> Callable[_Given, None]:
    """Let all that a command shows stand with true minus signs, degrees, dots and powers."""

    @wraps(command)
    def shown(*given: _Given.args, **named: _Given.kwargs) -> None:
        from cranktrain.saying.typesetting import printed

        with printed():
            command(*given, **named)

    return shown


def add_textbook(app: typer.Typer) -> None:
    """Add the command to the others."""

    @app.command(
        "textbook",
        help=N_(
            "Compare the sources' own formulas with the exact motion: ranges and largest errors.\n\n"
            "Or list the formulas of a source, with what is right and which command shows each. There are five:\n\n"
            "\b\n"
            "  A  steam-engine            motion of a steam engine's piston\n"
            "  B  gandzha                 torque and flywheel moment of a crank-rocker\n"
            "  C  slider-crank-synthesis  a slider-crank from stroke and pressure angle\n"
            "  D  bolotin                 opposed pistons and articulated rods\n"
            "  E  crankshaft-reactions    reactions of a crankshaft's supports\n\n"
            "\b\n"
            "  cranktrain textbook 3d12\n"
            "  cranktrain textbook 3d12 --full\n"
            "  cranktrain textbook 3d12 --table\n"
            "  cranktrain textbook --source\n"
            "  cranktrain textbook --source bolotin\n"
            "  cranktrain textbook --equation I.13\n"
            "  cranktrain textbook 3d12 --forces kgf/cm2 --step 10\n"
            "  cranktrain textbook 3d12 --harmonics\n"
            '  cranktrain textbook --throw example --set "K1=20 kN"\n'
            "  cranktrain textbook --throw example -o throw.toml\n"
            "  cranktrain textbook --throw throw.toml -o throw.svg\n"
            "  cranktrain textbook --drive example\n"
            "  cranktrain textbook --drive example -o drive.svg\n"
            "  cranktrain textbook errata"
        ),
        cls=OptionalSource,
    )
    @put_off
    @_in_print
    def _textbook(
        file: Annotated[
            str,
            typer.Argument(
                metavar="[FILE|errata]",
                help=N_("A machine file, the name of an example, or `errata` for the sources' errors."),
                show_default=False,
            ),
        ] = "",
        settings: Settings = None,
        source: Annotated[
            str | None,
            typer.Option(
                metavar="[NAME]",
                help=N_(
                    "Of one source alone; without FILE its formulas one by one, without NAME a list of the sources."
                ),
            ),
        ] = None,
        equation: Annotated[
            str | None,
            typer.Option(
                metavar="NUMBER",
                help=N_(
                    "Show instead a formula or figure by its number, such as 337 or I.13, of every source that has it."
                ),
            ),
        ] = None,
        table: Annotated[
            bool, typer.Option("--table", help=N_("Show instead the motion over the turn, in steps of 30°."))
        ] = False,
        full: Annotated[
            bool, typer.Option("--full", help=N_("Show all, not one screen: every formula, form, table or error."))
        ] = False,
        errata: Annotated[bool, typer.Option("--errata", help=N_("Show the sources' errors, too."))] = False,
        forces: Annotated[
            str | None,
            typer.Option(
                metavar="UNIT",
                help=N_(
                    "Show instead P, N, S, K, T and M of a piston, exact and by two harmonics: N, kN, kgf, or over the "
                    "piston's area MPa, bar, kgf/cm2."
                ),
            ),
        ] = None,
        step: Annotated[
            float | None,
            typer.Option(
                metavar="10|15|30", parser=degrees, help=N_("Degrees between the rows of forces; 30 unless given.")
            ),
        ] = None,
        piston: Annotated[
            str | None, typer.Option(metavar="NAME", help=N_("Whose forces, such as 2L; the first unless given."))
        ] = None,
        harmonics: Annotated[
            bool,
            typer.Option(
                "--harmonics",
                help=N_("Show instead the harmonics of acceleration and inertia torque: exact, series, two harmonics."),
            ),
        ] = False,
        crank_to_rod_ratio: Annotated[
            str | None,
            typer.Option(metavar="NUMBER", help=N_("Show harmonics for this λ = R/L instead of a machine's.")),
        ] = None,
        throw: Annotated[
            str | None,
            typer.Option(
                metavar="FILE|example",
                help=N_(
                    "Show instead the reactions of a throw's supports, (44) to (53): from a table of its symbols, or "
                    "of a machine's crankshaft."
                ),
            ),
        ] = None,
        throw_number: Annotated[
            str | None,
            typer.Option(
                metavar="NUMBER", help=N_("Which throw of a machine, such as 3, or main.3; the first unless given.")
            ),
        ] = None,
        crank_masses: Annotated[
            str | None,
            typer.Option(
                metavar="given|sizes",
                help=N_(
                    "Of a machine's throw: whether cranks weigh what [masses.crank] says, or by [crankshaft]'s sizes."
                ),
            ),
        ] = None,
        drive: Annotated[
            str | None,
            typer.Option(
                metavar="FILE|example",
                help=N_(
                    "Show instead the drive of a crank-rocker, (1) to (21): from a table of its symbols, or a machine."
                ),
            ),
        ] = None,
        at: Annotated[
            float | None,
            typer.Option(
                metavar="DEG",
                parser=degrees,
                help=N_(
                    "Of a drive: crank angle from the line of the pivots; 60 unless given. Of a machine's throw: crank "
                    "angle; that of the largest load unless given."
                ),
            ),
        ] = None,
        output: Annotated[
            str | None,
            typer.Option(
                "-o",
                "--output",
                metavar="FILE",
                help=N_(
                    "Of a throw: its table as .toml, or its scheme, fig. 35, as .png, .svg or .pdf; of a machine's its "
                    "loads over the cycle as .csv. Of a drive: its table, its curves as .csv, or fig. 2."
                ),
            ),
        ] = None,
        force: Force = False,
    ) -> None:
        from cranktrain.cli.textbook.typed import TextbookRequest, refuse_without_throw

        asked = TextbookRequest(
            file=file or None,
            settings=tuple(settings or ()),
            source=source,
            equation=equation,
            table=table,
            full=full,
            errata=errata,
            forces=forces,
            step=step,
            piston=piston,
            harmonics=harmonics,
            crank_to_rod_ratio=crank_to_rod_ratio,
            throw=throw,
            throw_number=throw_number,
            crank_masses=crank_masses,
            drive=drive,
            at=at,
            output=output,
            force=force,
        )
        if equation is not None:
            from cranktrain.cli.textbook.equation import show_equation as show
        elif drive is not None:
            from cranktrain.cli.textbook.drive import show_drive as show
        elif throw is not None:
            from cranktrain.cli.textbook.throw import show_throw as show
        else:
            refuse_without_throw(asked)
            if harmonics or crank_to_rod_ratio is not None:
                from cranktrain.cli.textbook.harmonics import show_harmonics as show
            elif forces is not None:
                from cranktrain.cli.textbook.forces import show_force_tables as show
            else:
                from cranktrain.cli.textbook.command import show_textbook as show
        show(asked)
