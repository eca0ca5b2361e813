"""What a command line asks for, as a task: it is done when Typer has returned."""

from collections.abc import Callable, Sequence
from copy import copy
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
        commands = _laid_out(app, chosen_language(), _named(app, arguments))
        given: object = commands(list(arguments) or ["--help"], prog_name=name, standalone_mode=False)
    except _USAGE_ERROR as error:
        raise InputError([_usage_problem(error)]) from None
    except typer.Abort:
        raise KeyboardInterrupt from None
    if given == _TYPER_STOPPED:
        raise KeyboardInterrupt
    return cast("Task", given) if callable(given) else _nothing


def commands_of(app: typer.Typer) -> Any:
    """All commands of an app with their arguments and options, as Typer's group of them, in the reader's language."""
    return _laid_out(app, chosen_language(), None)


def _named(app: typer.Typer, arguments: Sequence[str]) -> str | None:
    """Which command is named; None for help about all of them, what is no command, or where there is but one."""
    registered = (*app.registered_commands, *app.registered_groups)
    is_named = bool(arguments) and app.registered_callback is not None
    return next((one.name for one in registered if is_named and one.name == arguments[0]), None)


@cache
def _laid_out(app: typer.Typer, _language: str | None, name: str | None) -> Any:
    """Those commands, or the named one alone, laid out once for each language: all take as long as a small run."""
    if name is not None:
        app = copy(app)
        app.registered_commands = [one for one in app.registered_commands if one.name == name]
        app.registered_groups = [one for one in app.registered_groups if one.name == name]
    group: Any = get_command(app)
    for command in (group, *getattr(group, "commands", {}).values()):
        for helped in (command, *command.params):
            helped.help = _(getattr(helped, "help", None) or "")
        for parameter in command.params:
            parameter.process_value = partial(_processed, parameter, parameter.process_value)
    return group


def _processed(parameter: Any, process: Callable[[Any, Any], Any], context: Any, value: Any) -> Any:
    """Read what was given; for what was not given Typer would make an adapter too, which takes a millisecond."""
    if value is None and not parameter.required and parameter.callback is None:
        return () if parameter.multiple or parameter.nargs == -1 else None
    return process(context, value)


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
