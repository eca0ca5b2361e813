"""How pictures look: colours by quantity, habits of lines, sizes of text. No meaning is in colour alone."""

from collections.abc import Mapping
from typing import NamedTuple

from cranktrain.viz.paper.sketch import Circle, Fill, Habit, Layer, Line

INK = "#1b1d1f"
MUTED = "#5b6066"
RULE = "#c9c9c2"
GRID = "#e4e4de"

COLOURS: Mapping[str, str] = {
    "s": "#005ae6",
    "v": "#095d3d",
    "j": "#b2590f",
    "T": "#93075f",
    "p": "#732cb9",
    "N": "#584414",
    "K": "#1a7da1",
    "F": INK,
    "": MUTED,
}
"""Colour of a quantity: travel, velocity, acceleration, torque and tangential force, gas, side, radial, resultant; of
what is of none."""

FILLS: Mapping[Fill, str] = {"none": "none", "paper": "#ffffff", "light": "#d9dcdf", "dark": "#9aa0a6", "ink": INK}

TEXT, HEADING, SYMBOL, TITLE = 8.0, 8.5, 10.5, 14.0
"""Sizes of text. [pt]"""


class Pen(NamedTuple):
    """Width [pt], colour and dashes (in widths) of a line."""

    width: float
    colour: str
    dashes: tuple[float, ...] = ()


PENS: Mapping[Habit, Pen] = {
    "outline": Pen(0.9, INK),
    "rod": Pen(0.7, INK),
    "thin": Pen(0.45, MUTED),
    "hatch": Pen(0.4, MUTED),
    "dotted": Pen(0.7, MUTED, (1.0, 2.2)),
    "curve": Pen(0.8, INK),
    "axis": Pen(0.45, MUTED, (14.0, 4.0, 2.0, 4.0)),
    "arrow": Pen(0.3, INK),
    "vector": Pen(1.0, INK),
    "load": Pen(1.6, INK),
    "part": Pen(0.6, INK, (5.0, 2.5)),
    "chord": Pen(0.8, INK, (8.0, 2.0, 1.2, 2.0)),
    "construction": Pen(0.45, MUTED, (5.0, 2.5)),
    "none": Pen(0.0, "none"),
}

_COLOURED: Mapping[Layer, str] = {"PLAN_V": COLOURS["v"], "PLAN_A": COLOURS["j"], "LOADS": COLOURS["T"]}

SETTINGS: Mapping[str, object] = {
    "font.family": ["DejaVu Sans"],
    "font.size": TEXT,
    "mathtext.fontset": "stix",
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.edgecolor": INK,
    "axes.linewidth": 0.6,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.major.size": 2.5,
    "ytick.major.size": 2.5,
    "xtick.major.width": 0.5,
    "ytick.major.width": 0.5,
    "axes.unicode_minus": True,
    "axes.formatter.limits": (-9, 12),
    "axes.formatter.useoffset": False,
    "path.simplify": False,
    "svg.hashsalt": "cranktrain",
    "svg.fonttype": "path",
    "pdf.fonttype": 42,
}
"""Settings of the plotting library under which every picture is made and saved; its fonts come with it."""


def pen_of(part: Line | Circle) -> Pen:
    """Pen for a part of a sketch: vectors have the colour of their quantity, loads that of torque."""
    pen = PENS[part.habit]
    is_coloured = part.layer in _COLOURED and part.habit in ("vector", "load", "part", "arrow")
    return pen._replace(colour=_COLOURED[part.layer]) if is_coloured else pen


HATCH = "////"
"""Of what cannot be."""
