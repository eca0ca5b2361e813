"""Pictures for the terminal, without what the plotting library says of its fonts and its folder."""

import logging
from collections.abc import Callable
from typing import TYPE_CHECKING

from cranktrain.viz.output import save

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def hush() -> None:
    """Keep the plotting library from saying what no user asked for."""
    logging.getLogger("matplotlib").setLevel(logging.ERROR)


def save_quietly(draw: "Callable[[], Figure]", output: str, *, force: bool) -> None:
    """Draw and save a picture, as `cranktrain.viz.save` does."""
    hush()
    save(draw, output, force=force)
