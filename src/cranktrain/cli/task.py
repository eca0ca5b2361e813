"""What a command line asks for, as a task: it is done when Typer has returned."""

from collections.abc import Callable, Sequence
from functools import cache, partial, wraps
from typing import Any, ParamSpec, cast

import typer
from typer.main import get_command

from cranktrain.errors import InputError, Position, Problem
from cranktrain.language import chosen_language
from cranktrain.language import said as _

Task = Callable[[], None]
_Given = ParamSpec("_Given")

_TYPER_STOPPED = 130
"""What newer versions of Typer make of Ctrl-C; older ones raise Abort."""

_USAGE_ERROR = cast("type[Exception]", typer.BadParameter.__mro__[1])  # has no public name in every Typer


def task_of(app: typer.Typer, arguments: Sequence[str], name: str) -> Task:
    """Read a command line.

    Parameters
    ----------
    app : typer.Typer
        Its commands.
    arguments : sequence of str
        What was typed after the name; nothing asks for help.
    name : str
        What the commands stand after.

    Returns
    -------
    Task
        What is to be done.

    Raises
    ------
    InputError
        If the command line is not right.
    KeyboardInterrupt
    """
    try:
        given: object = commands_of(app)(list(arguments) or ["--help"], prog_name=name, standalone_mode=False)
    except _USAGE_ERROR as error:
        raise InputError([_usage_problem(error)]) from None
    except typer.Abort:
        raise KeyboardInterrupt from None
    if given == _TYPER_STOPPED:
        raise KeyboardInterrupt
    return cast("Task", given) if callable(given) else _nothing


def commands_of(app: typer.Typer) -> Any:
    """All commands of an app with their arguments and options, as Typer's group of them, in the reader's language."""
    return _laid_out(app, chosen_language())


@cache
def _laid_out(app: typer.Typer, _language: str | None) -> Any:
    """Those commands, which are laid out once for each language."""
    group: Any = get_command(app)
    for command in (group, *getattr(group, "commands", {}).values()):
        for helped in (command, *command.params):
            helped.help = _(getattr(helped, "help", None) or "")
    return group


def put_off(command: Callable[_Given, None]) -> Callable[_Given, Task]:
    """Let Typer read what a command is given, and do the command when Typer has returned.

    Python takes room for its stack of calls in pieces. Where a piece is just full, each further call has the system map
    a new one and unmap it; what a command imports comes to lie there, below the calls of Typer, and NumPy with it.
    """

    @wraps(command)
    def read(*given: _Given.args, **named: _Given.kwargs) -> Task:
        return partial(command, *given, **named)

    return read


def _nothing() -> None:
    """What is left to do after help or version."""


def _usage_problem(error: Exception) -> Problem:
    """Say in our words what is wrong with a command line."""
    context = getattr(error, "ctx", None)
    command = context.command_path if context is not None else "cranktrain"
    message = getattr(error, "format_message", error.__str__)().strip().rstrip(".")
    message = message[:1].lower() + message[1:]
    return Problem("", None, message, _("see `{command} --help`", command=command), Position(command))
