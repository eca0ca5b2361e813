"""What may stand at a place of the command line, as its beginning has it; and how a shell asks for it."""

import os
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from cranktrain.cli.app import commands
from cranktrain.cli.completing.names import example_names, results, words
from cranktrain.cli.completing.paths import setting_paths
from cranktrain.cli.options import n_processors

_PICTURES = (".png", ".svg", ".pdf")
_ENDINGS = {
    "run": (".csv", ".json", ".xlsx"),
    "plot": (*_PICTURES, ".gif", ".dxf"),
    "compare": _PICTURES,
    "sweep": (".csv", ".json", ".xlsx", ".nc", ".zarr", *_PICTURES),
}
"""What the name of an output ends in, by command."""

ASKED = "_CRANKTRAIN_COMPLETE"
"""Variable with which a shell asks: the place of the word that is typed, counted from the program's name."""


def candidates(typed: Sequence[str], commands: Any) -> list[str]:
    """Give what may stand in the place of the last word.

    Parameters
    ----------
    typed : sequence of str
        The words after the program's name, the last as far as it is typed.
    commands : Typer's group of commands

    Returns
    -------
    list of str
        Whole words that go on as the last begins; none where the shell knows more, as of files in folders.
    """
    *before, begun = _joined(typed) or [""]
    command = commands.commands.get(before[0]) if before else None
    if command is None:
        possible = [*commands.commands, "--help", "--version"] if not before else []
    else:
        possible = list(_of_command(command, before, begun))
    return [word for word in dict.fromkeys(possible) if word.startswith(begun)]


def _joined(typed: Sequence[str]) -> list[str]:
    """Put together what bash takes apart at `=`: a path and its value, but not an option and its own."""
    words: list[str] = []
    for place, word in enumerate(typed):
        is_setting = place > 1 and typed[place - 1] == "=" and not typed[place - 2].startswith("-")
        if word == "=" and words and words[-1].startswith("--"):
            continue
        if words and (word == "=" or is_setting):
            words[-1] += word
        else:
            words.append(word)
    return words


def _of_command(command: Any, before: Sequence[str], begun: str) -> Iterator[str]:
    """Give what may follow in a command: the value of an option, options, or its next argument."""
    taking = {option: one for one in command.params for option in one.opts if option.startswith("-")}
    last = taking.get(before[-1])
    if last is not None and not getattr(last, "is_flag", False):
        yield from _of_option(last, before, begun)
    elif begun.startswith("-"):
        yield from [option for option in taking if option.startswith("--")]
        yield "--help"
    else:
        place = len(_arguments(taking, before))
        arguments = [one for one in command.params if one.param_type_name == "argument"]
        if place < len(arguments):
            yield from _of_words(arguments[place].metavar or "", begun)
        if before[0] == "textbook" and place == 0:
            yield "errata"


def _arguments(taking: dict[str, Any], before: Sequence[str]) -> list[str]:
    """Give the words after a command that are neither options nor their values."""
    found: list[str] = []
    is_value = False
    for word in before[1:]:
        if not is_value and not word.startswith("-"):
            found.append(word)
        option = None if is_value else taking.get(word)
        is_value = option is not None and not getattr(option, "is_flag", False)
    return found


def _of_option(option: Any, before: Sequence[str], begun: str) -> Iterator[str]:
    """Give values of an option: paths of the machine that is named, results or units with commas between, or words."""
    if option.opts[0] in ("--set", "--vary"):
        files = [word for word in before[1:] if not word.startswith("-") and "=" not in word]
        yield from (f"{path}=" for path in setting_paths(files[0] if files else None))
    elif option.opts[0] in ("--quantities", "--wanted"):
        done, comma, _last = begun.rpartition(",")
        yield from (f"{done}{comma}{name}" for name in results())
    elif "--units" in option.opts:
        done, comma, _last = begun.rpartition(",")
        yield from (f"{done}{comma}{name}" for name in words("units"))
    elif option.opts[0] in ("--least", "--most"):
        yield from results()
    elif "--processes" in option.opts:
        yield from map(str, range(1, n_processors() + 1))
    elif "--scheduler" in option.opts:
        yield "tcp://"
    elif "--cases" in option.opts:
        yield from _files(begun, "*.csv")
    elif "--output" in option.opts:
        stem = begun.partition(".")[0]
        yield from (f"{stem}{ending}" for ending in _ENDINGS.get(before[0], ()) if stem)
    else:
        yield from _of_words(option.metavar or "", begun)


def _of_words(metavar: str, begun: str) -> Iterator[str]:
    """Give what an argument of that name may be: machine files and examples, kinds, or the words that it lists."""
    if "FILE" in metavar.upper().strip("[]").split("|") or metavar == "OTHER":
        yield from example_names()
        yield from _files(begun, "*.toml")
    elif metavar == "RESULT":
        yield from results()
    elif metavar == "KIND":
        yield from words("kinds")
        yield from example_names()
    elif "|" in metavar:
        yield from metavar.strip("[]").split("|")


def _files(begun: str, pattern: str) -> list[str]:
    """Files of a kind, in the folder that is named."""
    folder, slash, name = begun.rpartition("/")
    found = Path(folder + slash or ".").glob(pattern) if not name.startswith(".") else ()
    return sorted(f"{folder}{slash}{path.name}" for path in found)


def show_candidates(arguments: Sequence[str]) -> None:
    """Print what may stand where the shell says, one in a line; nothing where that is unknown or goes wrong."""
    with suppress(ValueError):
        place = int(os.environ[ASKED])
        typed = [*arguments, ""][:place]
        if place > 0 and len(typed) == place:
            for word in candidates(typed, commands()):
                print(word)
