"""Where pistons, cylinders or a rocker are at the ends of their way: marks for a ruler over the curves."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import _
from cranktrain.plans.placement import first_throw
from cranktrain.record import record
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.sheets.motion.panels import drawn_names, opposed_names, told_forms

FEW = 2
"""Up to so many mechanisms, each has a ruler of its own."""

SHORT = 3
"""Letters of a name that has room beside the ruler, with a sample of its line."""


_ENDS = {
    "piston": ("top_dead_centre", "bottom_dead_centre"),
    "cylinder": ("inner_volumetric_dead_centre", "outer_volumetric_dead_centre"),
    "rocker": ("largest_rocker_angle_at", "smallest_rocker_angle_at"),
}
"""Results that are the ends of a way, the top first."""


class Mark(NamedTuple):
    """A dead centre: whose, at which crank angle [deg], whether it is the top."""

    name: str
    angle: float
    is_top: bool


@record
class Ruler:
    """What is written over the curves.

    Attributes
    ----------
    heading : str
    words : (str, str)
        Of a mark at the top and at the bottom, or largest and smallest.
    marks : tuple of Mark
    pistons : sequence of str
        Names of the curves.
    textbook : str
        Forms beside the curves, if any.
    is_of_cylinders : bool
        Whether the marks are of cylinders and not of these pistons.
    valves : sequence of str
        Which of the names are valves, that have no top.
    """

    heading: str
    words: tuple[str, str]
    marks: tuple[Mark, ...]
    pistons: Sequence[str] = ()
    textbook: str = ""
    is_of_cylinders: bool = False
    valves: Sequence[str] = ()

    def word(self, mark: Mark) -> str:
        """Word of a mark."""
        words = (_("farthest"), _("nearest")) if mark.name in self.valves else self.words
        return words[0] if mark.is_top else words[1]

    @property
    def names(self) -> list[str]:
        """Whose marks these are."""
        return list(dict.fromkeys(mark.name for mark in self.marks))

    @property
    def is_few(self) -> bool:
        """Whether each of them has a row of its own."""
        return len(self.names) <= FEW

    @property
    def has_legend(self) -> bool:
        """Whether habits of lines are said over the rows: these are of something else, or too small for the names."""
        return self.is_of_cylinders or not self.is_few or any(len(name) > SHORT for name in self.pistons)


def ruler_of(result: Result, design: int = 0) -> Ruler:
    """Collect what the ruler shows: dead centres of pistons, volumetric ones of cylinders, or those of a rocker.

    Parameters
    ----------
    result : Result
    design : int

    Returns
    -------
    Ruler
    """
    shown = OneDesign(result, design)
    machine = result.machines[design]
    pair = opposed_names(machine)
    if pair:
        cylinders = [place.cylinder for place in first_throw(machine) if place.cylinder in result.labels["cylinder"]]
        found = tuple(_marks(shown, "cylinder", dict.fromkeys(cylinders)))
        return Ruler(_("Volumetric dead centres"), (_("inner"), _("outer")), found, pair, is_of_cylinders=True)
    if "piston" not in result.labels:
        found = tuple(_marks(shown, "rocker", drawn_names(result, "rocker")))
        heading = _("Dead positions of the rocker") if found else _("The rocker turns with the crank")
        return Ruler(heading, (_("largest at"), _("smallest at")), found)
    found = tuple(_marks(shown, "piston", drawn_names(result, "piston")))
    names = tuple(dict.fromkeys(mark.name for mark in found))
    valves = [place.name for place in machine.places if not place.kind.has_chambers]
    heading = _("True dead centres") if found else _("No dead centres")
    if found and set(names) <= set(valves):
        heading = _("Ends of valve travel")
    elif set(names) & set(valves):
        heading = _("Dead centres; ends of valve travel")
    return Ruler(heading, (_("TDC"), _("BDC")), found, names, _textbook_words(shown), valves=valves)


def _marks(shown: OneDesign, dimension: str, names: Iterable[str]) -> Iterator[Mark]:
    """Both ends of the way of each, where there are such."""
    for name in names:
        for quantity, is_top in zip(_ENDS[dimension], (True, False), strict=True):
            angle = float(shown(quantity)[shown.member(dimension, name)])
            if np.isfinite(angle):
                yield Mark(name, angle, is_top)


def _textbook_words(shown: OneDesign) -> str:
    """Name the textbook's forms that stand beside the first throw's pistons; nothing where there are none."""
    words = {"two_harmonics": _("two harmonics (333)–(337)"), "reconstructed": _("(I.13) reconstructed")}
    told = told_forms(shown)
    forms = [words[shown.result.labels["method"][form]] for form in dict.fromkeys(told.values())]
    return ", ".join([*forms, *(told if len(drawn_names(shown.result, "piston")) > FEW else ())])
