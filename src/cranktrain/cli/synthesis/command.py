"""What may be typed after `synthesise`: a command for each problem, its requirements as options.

Loaded only then: to build these commands takes as long as to show a help.
"""

from collections.abc import Callable
from functools import partial
from inspect import Parameter, Signature, signature
from typing import Annotated

import typer

from cranktrain.cli.options import File, Force
from cranktrain.cli.synthesis.proposals import give_proposal
from cranktrain.cli.synthesis.requirements import form_of, is_of_machine, option_of, requirements_of
from cranktrain.cli.task import Task
from cranktrain.declared_types import parts_of
from cranktrain.language import N_

app = typer.Typer(
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    help=N_(
        "Find dimensions for what a mechanism is to do, and write its machine file.\n\n"
        "Quantities have units. What is left free is chosen, and what else would do stands beside it.\n\n"
        "\b\n"
        '  cranktrain synthesise slider-crank --stroke "160 mm" --pressure-angle "30 deg"\n'
        '  cranktrain synthesise quick-return --stroke "300 mm" --time-ratio 1.2'
    ),
)

_HELP = {
    "slider-crank": N_(
        "Find a slider-crank for a stroke and the largest permissible pressure angles.\n\n"
        "\b\n"
        '  cranktrain synthesise slider-crank --stroke "160 mm" --pressure-angle "30 deg" \\\n'
        '    --mean-speed "6.3 m/s"\n'
        '  cranktrain synthesise slider-crank --stroke "160 mm" --pressure-angle "20 deg" \\\n'
        '    --return-pressure-angle "40 deg" --offset free -o press.toml\n'
        '  cranktrain synthesise slider-crank --stroke "160 mm" --pressure-angle "30 deg" \\\n'
        '    --rod-length "270 mm" -o plan.svg\n'
        "  cranktrain synthesise slider-crank --textbook"
    ),
    "crank-rocker": N_(
        "Find the crank-rocker of a swing and a time ratio that transmits best.\n\n"
        "\b\n"
        '  cranktrain synthesise crank-rocker --swing "50 deg" --time-ratio 1.2 \\\n'
        '    --rocker-length "400 mm"\n'
        '  cranktrain synthesise crank-rocker --swing "60 deg" --time-ratio 1 --rocker-length "400 mm" \\\n'
        '    --transmission-angle "50 deg" -o rocker.toml'
    ),
    "quick-return": N_(
        "Find an offset slider-crank with a quick return; beside it a slotted lever and a Whitworth drive.\n\n"
        "\b\n"
        '  cranktrain synthesise quick-return --stroke "300 mm" --time-ratio 1.2\n'
        '  cranktrain synthesise quick-return --stroke "300 mm" --time-ratio 1.2 \\\n'
        '    --rod-length "600 mm" -o shaper.toml'
    ),
    "knuckle": N_(
        "Find the knuckle of an articulated rod. Each requirement decides one of its dimensions; give the others.\n\n"
        "\b\n"
        '  cranktrain synthesise knuckle --crank-radius "90 mm" --master-rod-length "320 mm" \\\n'
        '    --bank-angle "60 deg" --stroke "186.7 mm" --knuckle-radius "85 mm" --rod-length "235 mm"\n'
        '  cranktrain synthesise knuckle --crank-radius "90 mm" --master-rod-length "320 mm" \\\n'
        '    --bank-angle "60 deg" --same-height --unshifted top --rod-length "240 mm" -o v.toml'
    ),
    "radial": N_(
        "Choose the knuckles of a radial engine by one of five strategies, and see what the others cost.\n\n"
        "Strategies: plain, unshifted, equal_ratio, equal_stroke, unshifted_equal_ratio.\n\n"
        "\b\n"
        "  cranktrain synthesise radial --cylinders 9 --strategy plain --compression-ratio 6.5 \\\n"
        '    --crank-radius "80 mm" --rod-length "310 mm" --knuckle-radius "75 mm" --slave-rod-length "235 mm"'
    ),
    "counterweights": N_(
        "Find the counterweights that leave the least load in a main bearing of a machine, or in all.\n\n"
        "Methods: those of its bearing loads but clearance. Weights: each, alike, mirrored, webs. Angle: opposite, "
        "free.\n\n"
        "\b\n"
        "  cranktrain synthesise counterweights vaz_21213 --bearing 3\n"
        "  cranktrain synthesise counterweights vaz_21213 --aim mean --weights mirrored \\\n"
        '    --radius "45 mm" --largest-mass "1.2 kg" -o weighted.toml'
    ),
    "counterbalance": N_(
        "Find the counterbalance of a pumping unit for equal peaks of its gearbox torque, or its least rms.\n\n"
        "\b\n"
        "  cranktrain synthesise counterbalance pumping_unit_c57\n"
        "  cranktrain synthesise counterbalance pumping_unit_c57 --aim least-rms -o evened.toml"
    ),
    "drive": N_(
        "Find the smallest typical motor that is enough for a machine, with the ratio of its gear.\n\n"
        "\b\n"
        "  cranktrain synthesise drive jaw_crusher\n"
        "  cranktrain synthesise drive tilting_table --ratio exact -o driven.toml"
    ),
}
"""What each problem is, with what may be typed for it."""

_Textbook = Annotated[
    bool, typer.Option("--textbook", help=N_("Show the source's steps, wrong ones named; alone: its own example."))
]
_Output = Annotated[
    str | None,
    typer.Option(
        "-o",
        "--output",
        metavar="FILE",
        help=N_("Write the machine file: .toml; its numbers: .csv, .json, .xlsx, .nc; or draw it: .png, .svg, .pdf."),
    ),
]


def _command(problem: str) -> Callable[..., Task]:
    """Make what Typer is to read: a function with a problem's requirements for parameters, and options of its own."""

    def command(
        *,
        file: File | None = None,
        textbook: _Textbook = False,
        output: _Output = None,
        force: Force = False,
        **typed: str | bool | None,
    ) -> Task:
        return partial(give_proposal, problem, typed, output, force=force, with_source=textbook, source=file)

    file, textbook, *own, _typed = signature(command).parameters.values()
    if is_of_machine(problem):
        own = [file.replace(annotation=File, default=Parameter.empty), *own]
    if problem == "slider-crank":  # the only one of which a source has an example
        own = [textbook, *own]
    command.__signature__ = Signature([*map(_option, requirements_of(problem)), *own])
    return command


def _option(requirement: Parameter) -> Parameter:
    """Declare a requirement as an option that need not be typed: what is missing is told with all that is wrong."""
    parts = list(parts_of(requirement.annotation))
    is_truth = bool in parts
    about = next((part for part in parts if isinstance(part, str)), "")
    option = typer.Option(option_of(requirement.name), metavar=None if is_truth else form_of(requirement), help=about)
    return Parameter(
        requirement.name,
        Parameter.KEYWORD_ONLY,
        default=False if is_truth else None,
        annotation=Annotated[bool if is_truth else str | None, option],
    )


for _problem, _text in _HELP.items():
    app.command(_problem, help=_text)(_command(_problem))
