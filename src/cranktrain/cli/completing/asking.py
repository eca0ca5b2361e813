"""The answer to a shell that asks for completions."""

import os
from collections.abc import Sequence
from contextlib import suppress

from cranktrain.cli.app import commands
from cranktrain.cli.completing.candidates import candidates

ASKED = "_CRANKTRAIN_COMPLETE"
"""Variable with which a shell asks: the place of the word that is typed, counted from the program's name."""


def show_candidates(arguments: Sequence[str]) -> None:
    """Print what may stand where the shell says, one in a line; nothing where that is unknown or goes wrong."""
    with suppress(ValueError):
        place = int(os.environ[ASKED])
        typed = [*arguments, ""][:place]
        if place > 0 and len(typed) == place:
            for word in candidates(typed, commands()):
                print(word)
