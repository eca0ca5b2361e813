"""The help of `plot`, which names all pictures."""

from typing import Any

from typer.core import TyperCommand


class NamingPictures(TyperCommand):
    """A command whose options `plan` and `sheet` name the pictures, looked for only where help is asked for."""

    def get_help(self, ctx: Any) -> str:
        """Give the help, with the names."""
        from cranktrain.panels.sheets import PICTURES

        options: Any = self.params
        for option in options:
            if option.name in ("plan", "sheet"):
                names = (picture.name for picture in PICTURES if picture.kind == option.name)
                option.help = option.help.format(pictures=", ".join(names))
        return super().get_help(ctx)
