"""Arguments and options that several commands have."""

import math
import os
from typing import Annotated

import typer

from cranktrain.language import N_
from cranktrain.language import said as _

File = Annotated[
    str, typer.Argument(metavar="FILE", help=N_("A machine file, or the name of an example."), show_default=False)
]
Output = Annotated[str | None, typer.Option("-o", "--output", metavar="FILE", help=N_("Write to this file."))]
Force = Annotated[bool, typer.Option("--force", help=N_("Replace a file that is there."))]
Settings = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="PATH=VALUE", help=N_("Another value for this run; as often as needed.")),
]
Partial = Annotated[bool, typer.Option("--partial", help=N_("Accept links that do not close all round: NaN there."))]

AllTables = Annotated[
    bool, typer.Option("--full", help=N_("With every table that suits the kind, behind comment marks."))
]

ResultsOutput = Annotated[
    str | None,
    typer.Option(
        "-o",
        "--output",
        metavar="FILE",
        help=N_("Write curves to .csv, or all results to .json, .xlsx or .nc; by each method only if named."),
    ),
]
StartOutput = Annotated[
    str | None,
    typer.Option(
        "-o",
        "--output",
        metavar="FILE",
        help=N_("Write curves over time to .csv or .json, or draw them: .png, .svg, .pdf."),
    ),
]
Decimal = Annotated[
    str, typer.Option(metavar="point|comma", help=N_("In a .csv; a comma as spreadsheets take it, with semicolons."))
]
Facts = Annotated[bool, typer.Option("--facts", help=N_("Into a .csv facts instead of curves."))]
Full = Annotated[
    bool, typer.Option("--full", help=N_("Show all instead: answers, facts, peaks, checks, inputs, what is missing."))
]
Checks = Annotated[bool, typer.Option("--checks", help=N_("Show how well each check holds."))]
Inputs = Annotated[bool, typer.Option("--inputs", help=N_("Show every number of the file and where it is from."))]
Missing = Annotated[bool, typer.Option("--missing", help=N_("Show what the file could say, and what that would give."))]

At = Annotated[
    str | None,
    typer.Option("--at", metavar="ANGLES", help=N_("Curves at these crank angles, in degrees: 140, or 0,30..720.")),
]
AtTimes = Annotated[
    str | None, typer.Option("--at", metavar="TIMES", help=N_("Curves at these times, in seconds: 0.5, or 0,0.1..2."))
]
CurveTable = Annotated[
    str | None,
    typer.Option("--table", metavar="NAME", help=N_("A table of curves: motion, forces, bearings, drive or pumping.")),
]
OfMember = Annotated[
    str | None,
    typer.Option("--of", "--piston", metavar="NAME", help=N_("Whose curves the table has; the first one's.")),
]
Every = Annotated[
    str | None, typer.Option("--every", metavar="DEGREES", help=N_("How far apart lines of the table are."))
]

Why = Annotated[
    str | None,
    typer.Option("--why", metavar="WORDS", help=N_("Show where a number is from: its equation, stages and inputs.")),
]

Quantities = Annotated[
    str | None,
    typer.Option(metavar="A,B,…", help=N_("Only these results; `cranktrain list results` names all.")),
]

Units = Annotated[
    str | None,
    typer.Option("--units", metavar="UNIT,…", help=N_("Show numbers in these units: bar,kW,in; the rest as usual.")),
]

RunningSpeed = Annotated[
    bool,
    typer.Option(
        "--running-speed", help=N_("All at the speed of steady running that [evenness] gives, not a constant one.")
    ),
]

SpeedCurve = Annotated[
    str | None,
    typer.Option(
        "--speed-curve",
        metavar="FILE",
        help=N_("All at the speed over the crank angle that this file of two columns has."),
    ),
]


def n_processors() -> int:
    """How many processors this process may use."""
    # Not every system lets a process have some of them alone.
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def listed(text: str) -> tuple[str, ...]:
    """Take words with commas between apart."""
    return tuple(word.strip() for word in text.split(",") if word.strip())


def degrees(text: str | float) -> float:
    """Read a number of degrees, which is finite."""
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise typer.BadParameter(_("{text} must be a number of degrees, such as 0.5", text=text))
    return number
