"""The command `textbook`, whose option `--source` may stand without a name."""

from typing import Any

from typer.core import TyperCommand

_OPTION = "--source"


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
