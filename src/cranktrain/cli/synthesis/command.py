"""What may be typed after `synthesise`: a command for each problem, its wants as options.

Loaded only then: to build these commands takes as long as to show a help.
"""

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Annotated, cast

import typer

from cranktrain.cli.task import Task
from cranktrain.language import _

if TYPE_CHECKING:
    from cranktrain.cli.synthesis.wants import Typed

_app = typer.Typer(
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    help=_(
        "Find dimensions for what a mechanism is to do, and write its machine file.\n\n"
        "Quantities have units. What is left free is chosen, and what else would do stands beside it.\n\n"
        "\b\n"
        '  cranktrain synthesise slider-crank --stroke "160 mm" --pressure-angle "30 deg"\n'
        '  cranktrain synthesise quick-return --stroke "300 mm" --time-ratio 1.2'
    ),
)

_Text = str | None
_Length = Annotated[_Text, typer.Option(metavar="LENGTH")]
_Stroke = Annotated[_Text, typer.Option(metavar="LENGTH", help=_("Between the dead centres."))]
_TimeRatio = Annotated[
    _Text, typer.Option(metavar="NUMBER", help=_("Time of the slow stroke over that of the quick one."))
]
_Bore = Annotated[_Text, typer.Option(metavar="LENGTH", help=_("For the machine file."))]
_Speed = Annotated[_Text, typer.Option(metavar="SPEED", help=_("Of the crank."))]
_Output = Annotated[_Text, typer.Option("-o", "--output", metavar="FILE", help=_("Write the machine file here."))]
_Force = Annotated[bool, typer.Option("--force", help=_("Replace a file that is there."))]


def synthesis_task(arguments: Sequence[str]) -> Task:
    """Read what stands after `synthesise`; errors of usage are the caller's to answer.

    Parameters
    ----------
    arguments : sequence of str
        Nothing asks for help.

    Returns
    -------
    Task
        Or what Typer gives after a help.
    """
    given: object = _app(list(arguments) or ["--help"], prog_name="cranktrain synthesise", standalone_mode=False)
    return cast(Task, given)


def _task(problem: str, typed: "Typed", output: str | None, *, force: bool, with_source: bool = False) -> Task:
    """Put off finding dimensions until Typer has returned."""
    from cranktrain.cli.synthesis.proposals import give_proposal

    return partial(give_proposal, problem, typed, output, force=force, with_source=with_source)


@_app.command(
    "slider-crank",
    help=_(
        "Find a slider-crank for a stroke and the largest permissible pressure angles.\n\n"
        "\b\n"
        '  cranktrain synthesise slider-crank --stroke "160 mm" --pressure-angle "30 deg" \\\n'
        '    --mean-speed "6.3 m/s"\n'
        '  cranktrain synthesise slider-crank --stroke "160 mm" --pressure-angle "20 deg" \\\n'
        '    --return-pressure-angle "40 deg" --offset free -o press.toml\n'
        "  cranktrain synthesise slider-crank --textbook"
    ),
)
def _slider_crank(
    stroke: _Stroke = None,
    pressure_angle: Annotated[
        _Text, typer.Option(metavar="ANGLE", help=_("Largest permissible, on the working stroke."))
    ] = None,
    return_pressure_angle: Annotated[
        _Text, typer.Option(metavar="ANGLE", help=_("On the other stroke; the same unless given."))
    ] = None,
    working_stroke: Annotated[
        _Text, typer.Option(metavar="toward|away", help=_("From the shaft's point of view; toward unless given."))
    ] = None,
    rod_length: Annotated[
        _Text, typer.Option(metavar="LENGTH", help=_("The shortest that keeps the limits unless given."))
    ] = None,
    offset: Annotated[
        _Text, typer.Option(metavar="LENGTH|free", help=_("Of the line of stroke toward +y; 0 unless given."))
    ] = None,
    mean_speed: Annotated[
        _Text, typer.Option(metavar="VELOCITY", help=_("Of the slider over the turn, instead of --speed."))
    ] = None,
    speed: _Speed = None,
    textbook: Annotated[
        bool,
        typer.Option("--textbook", help=_("Show the source's steps, wrong ones named; alone: its own example.")),
    ] = False,
    output: _Output = None,
    force: _Force = False,
) -> Task:
    typed = {
        "stroke": stroke,
        "pressure_angle": pressure_angle,
        "return_pressure_angle": return_pressure_angle,
        "working_stroke": working_stroke,
        "rod_length": rod_length,
        "offset": offset,
        "mean_speed": mean_speed,
        "speed": speed,
    }
    return _task("slider-crank", typed, output, force=force, with_source=textbook)


@_app.command(
    "crank-rocker",
    help=_(
        "Find the crank-rocker of a swing and a time ratio that transmits best.\n\n"
        "\b\n"
        '  cranktrain synthesise crank-rocker --swing "50 deg" --time-ratio 1.2 \\\n'
        '    --rocker-length "400 mm"\n'
        '  cranktrain synthesise crank-rocker --swing "60 deg" --time-ratio 1 --rocker-length "400 mm" \\\n'
        '    --transmission-angle "50 deg" -o rocker.toml'
    ),
)
def _crank_rocker(
    swing: Annotated[_Text, typer.Option(metavar="ANGLE", help=_("Of the rocker."))] = None,
    time_ratio: _TimeRatio = None,
    rocker_length: _Length = None,
    transmission_angle: Annotated[_Text, typer.Option(metavar="ANGLE", help=_("Least that is permitted."))] = None,
    rod_length: Annotated[_Text, typer.Option(metavar="LENGTH", help=_("With a time ratio of 1 only."))] = None,
    slow_swing: Annotated[
        _Text,
        typer.Option(
            metavar="forward|backward", help=_("In the sense of the crank's rotation, or against it; forward.")
        ),
    ] = None,
    speed: _Speed = None,
    output: _Output = None,
    force: _Force = False,
) -> Task:
    typed = {
        "swing": swing,
        "time_ratio": time_ratio,
        "rocker_length": rocker_length,
        "transmission_angle": transmission_angle,
        "rod_length": rod_length,
        "slow_swing": slow_swing,
        "speed": speed,
    }
    return _task("crank-rocker", typed, output, force=force)


@_app.command(
    "quick-return",
    help=_(
        "Find an offset slider-crank with a quick return; beside it a slotted lever and a Whitworth drive.\n\n"
        "\b\n"
        '  cranktrain synthesise quick-return --stroke "300 mm" --time-ratio 1.2\n'
        '  cranktrain synthesise quick-return --stroke "300 mm" --time-ratio 1.2 \\\n'
        '    --rod-length "600 mm" -o shaper.toml'
    ),
)
def _quick_return(
    stroke: _Stroke = None,
    time_ratio: _TimeRatio = None,
    rod_length: Annotated[
        _Text, typer.Option(metavar="LENGTH", help=_("That of the least pressure angle unless given."))
    ] = None,
    slow_stroke: Annotated[
        _Text, typer.Option(metavar="toward|away", help=_("From the shaft's point of view; toward unless given."))
    ] = None,
    speed: _Speed = None,
    output: _Output = None,
    force: _Force = False,
) -> Task:
    typed = {
        "stroke": stroke,
        "ratio": time_ratio,
        "rod_length": rod_length,
        "slow_stroke": slow_stroke,
        "speed": speed,
    }
    return _task("quick-return", typed, output, force=force)


@_app.command(
    "knuckle",
    help=_(
        "Find the knuckle of an articulated rod. Each want decides one of its dimensions; give the others.\n\n"
        "\b\n"
        '  cranktrain synthesise knuckle --crank-radius "90 mm" --master-rod-length "320 mm" \\\n'
        '    --bank-angle "60 deg" --stroke "186.7 mm" --knuckle-radius "85 mm" --rod-length "235 mm"\n'
        '  cranktrain synthesise knuckle --crank-radius "90 mm" --master-rod-length "320 mm" \\\n'
        '    --bank-angle "60 deg" --same-height --unshifted top --rod-length "240 mm" -o v.toml'
    ),
)
def _knuckle(
    crank_radius: _Length = None,
    master_rod_length: _Length = None,
    bank_angle: Annotated[
        _Text, typer.Option(metavar="ANGLE", help=_("From the master's cylinder, in the sense of rotation."))
    ] = None,
    master_offset: _Length = None,
    stroke: Annotated[_Text, typer.Option(metavar="LENGTH", help=_("Want: of the slave."))] = None,
    unshifted: Annotated[
        _Text, typer.Option(metavar="top|bottom", help=_("Want: a dead centre on the cylinder's axis."))
    ] = None,
    same_height: Annotated[
        bool, typer.Option("--same-height", help=_("Want: the master's pin height at the top."))
    ] = False,
    same_ratio: Annotated[
        _Text, typer.Option(metavar="NUMBER", help=_("Want: the master's compression ratio, this."))
    ] = None,
    knuckle_radius: _Length = None,
    rod_length: _Length = None,
    articulation_angle: Annotated[_Text, typer.Option(metavar="ANGLE")] = None,
    bore: _Bore = None,
    speed: _Speed = None,
    output: _Output = None,
    force: _Force = False,
) -> Task:
    typed: Typed = {
        "crank_radius": crank_radius,
        "master_rod_length": master_rod_length,
        "bank_angle": bank_angle,
        "master_offset": master_offset,
        "stroke": stroke,
        "unshifted": unshifted,
        "same_height": same_height,
        "same_ratio": same_ratio,
        "knuckle_radius": knuckle_radius,
        "rod_length": rod_length,
        "articulation_angle": articulation_angle,
        "bore": bore,
        "speed": speed,
    }
    return _task("knuckle", typed, output, force=force)


@_app.command(
    "radial",
    help=_(
        "Choose the knuckles of a radial engine by one of five strategies, and see what the others cost.\n\n"
        "Strategies: plain, unshifted, equal_ratio, equal_stroke, unshifted_equal_ratio.\n\n"
        "\b\n"
        "  cranktrain synthesise radial --cylinders 9 --strategy plain --compression-ratio 6.5 \\\n"
        '    --crank-radius "80 mm" --rod-length "310 mm" --knuckle-radius "75 mm" --slave-rod-length "235 mm"'
    ),
)
def _radial(
    crank_radius: _Length = None,
    rod_length: Annotated[_Text, typer.Option(metavar="LENGTH", help=_("Of the master."))] = None,
    cylinders: Annotated[_Text, typer.Option(metavar="NUMBER", help=_("With the master's."))] = None,
    strategy: Annotated[_Text, typer.Option(metavar="STRATEGY")] = None,
    knuckle_radius: Annotated[
        _Text, typer.Option(metavar="LENGTH", help=_("Of all slaves, or where the search for each begins."))
    ] = None,
    slave_rod_length: Annotated[
        _Text, typer.Option(metavar="LENGTH", help=_("Of all slaves, or where the search for each begins."))
    ] = None,
    compression_ratio: Annotated[_Text, typer.Option(metavar="NUMBER", help=_("Of the master."))] = None,
    bore: _Bore = None,
    speed: _Speed = None,
    output: _Output = None,
    force: _Force = False,
) -> Task:
    typed = {
        "crank_radius": crank_radius,
        "rod_length": rod_length,
        "n_cylinders": cylinders,
        "strategy": strategy,
        "knuckle_radius": knuckle_radius,
        "slave_rod_length": slave_rod_length,
        "compression_ratio": compression_ratio,
        "bore": bore,
        "speed": speed,
    }
    return _task("radial", typed, output, force=force)
