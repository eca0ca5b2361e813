"""A proposed mechanism as a picture: its plan of positions."""

import tomllib
from typing import TYPE_CHECKING

from cranktrain.cli.quiet_pictures import save_quietly
from cranktrain.machine import Machine

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_POSITIONS = 12


def write_plan(path: str, text: str, *, force: bool) -> None:
    """Draw the mechanism of a machine file in twelve positions; a slider-crank in those of [slider-crank-synthesis].

    Parameters
    ----------
    path : str
        Ends in one of `cranktrain.viz.output.FORMATS`.
    text : str
        The machine file.
    force : bool
        Replace a file that is there.

    Raises
    ------
    InputError
        If the picture cannot be written.
    """
    machine = Machine(**tomllib.loads(text))
    save_quietly(lambda: _drawn(machine), path, force=force)


def _drawn(machine: Machine) -> "Figure":
    from cranktrain.plans.positions import source_angles
    from cranktrain.viz.plans.positions import plan_positions

    is_direct = machine.places[0].kind.is_direct
    return plan_positions(machine, source_angles(machine) if is_direct else _POSITIONS)
