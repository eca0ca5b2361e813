"""A proposed mechanism as a picture: its plan of positions."""

import logging
import tomllib
from typing import TYPE_CHECKING

from cranktrain.machine import Machine
from cranktrain.viz.output import FORMATS, save

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PLANS = FORMATS
"""Suffixes of names that ask for the plan instead of the machine file."""
_POSITIONS = 12


def write_plan(path: str, text: str, *, force: bool) -> None:
    """Draw the mechanism of a machine file in twelve positions; a slider-crank in those of [slider-crank-synthesis].

    Parameters
    ----------
    path : str
        Ends in one of `PLANS`.
    text : str
        The machine file.
    force : bool
        Replace a file that is there.

    Raises
    ------
    InputError
        If the picture cannot be written.
    """
    # What the plotting library says of its fonts and its folder is nothing that a user asked for.
    logging.getLogger("matplotlib").setLevel(logging.ERROR)
    machine = Machine(**tomllib.loads(text))
    save(lambda: _drawn(machine), path, force=force)


def _drawn(machine: Machine) -> "Figure":
    from cranktrain.plans.positions import source_angles
    from cranktrain.viz.plans.positions import plan_positions

    is_slider_crank = machine.places[0].kind.name == "slider_crank"
    return plan_positions(machine, source_angles(machine) if is_slider_crank else _POSITIONS)
