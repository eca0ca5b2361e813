"""Where pistons, cylinders or a rocker are at the ends of their way: marks for a ruler over the curves."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.language import Listed, Words, _
from cranktrain.machine import Machine
from cranktrain.panels.design import OneDesign
from cranktrain.panels.parts import Ruler, RulerMark
from cranktrain.panels.ram import upward
from cranktrain.panels.sheets.motion.panels import FEW, drawn_forms, drawn_names, opposed_names
from cranktrain.panels.throw_member import is_ram
from cranktrain.plans.drawn_throws import drawn_places
from cranktrain.plans.placement import output_of, placed
from cranktrain.plans.stroke_lines import unit
from cranktrain.saying.wording import first_that_holds

_ENDS = {
    "piston": ("top_dead_centre", "bottom_dead_centre"),
    "cylinder": ("inner_volumetric_dead_centre", "outer_volumetric_dead_centre"),
    "rocker": ("largest_rocker_angle_at", "smallest_rocker_angle_at"),
}
"""Results that are the ends of a way, the top first."""


def ruler_of(result: Result, design: int = 0, mechanism: str | None = None) -> Ruler:
    """Collect what the ruler shows: dead centres of pistons, volumetric ones of cylinders, or those of a rocker.

    Parameters
    ----------
    result : Result
    design : int
    mechanism : str, optional
        Whose throw alone is meant; unless given, one of each sort.

    Returns
    -------
    Ruler
    """
    shown = OneDesign(result, design, mechanism)
    machine = result.machines[design]
    pair = opposed_names(machine, mechanism)
    if pair:
        cylinders = [
            place.cylinder for place in drawn_places(machine, mechanism) if place.cylinder in result.labels["cylinder"]
        ]
        found = tuple(_marks(shown, "cylinder", dict.fromkeys(cylinders, (_("inner"), _("outer")))))
        return Ruler(_("Volumetric dead centres"), found, pair, is_of_cylinders=True)
    if "piston" not in result.labels:
        words = _("largest at"), _("smallest at")
        found = tuple(_marks(shown, "rocker", dict.fromkeys(drawn_names(shown, "rocker"), words)))
        heading = _("Dead positions of the rocker") if found else _("The rocker turns all round")
        if shown.has("crank_range_start"):
            heading = _("The crank does not turn all round")
        return Ruler(heading, found)
    valves = {place.name for place in machine.places if not place.kind.output.is_loaded}
    words = dict(_words_of_sliders(machine, drawn_names(shown, "piston")))
    found = tuple(_marks(shown, "piston", words))
    names = tuple(dict.fromkeys(mark.name for mark in found))
    heading = first_that_holds(
        (not found, _("No dead centres")),
        (valves >= set(names), _("Ends of valve travel")),
        (not valves.isdisjoint(names), _("Dead centres; ends of valve travel")),
        (True, _("True dead centres")),
    )
    return Ruler(heading, found, names, _textbook_words(shown))


def _words_of_sliders(machine: Machine, names: Sequence[str]) -> Iterator[tuple[str, tuple[Words, Words]]]:
    """Words of the far end of each slider's way and of the near one; of a ram as the machine stands."""
    for place in machine.places:
        words = place.kind.output.words
        if place.name in names and words is not None:
            far, near = map(_, words.ends)
            guides = placed(machine, place, np.zeros(1)).guides if is_ram(output_of(machine, place)) else ()
            up = upward(unit(guides[0].direction).reshape(2)) if guides else 0
            if up:
                far, near = (_("upper"), _("lower"))[::up]
            yield place.name, (far, near)


def _marks(shown: OneDesign, dimension: str, words: Mapping[str, tuple[Words, Words]]) -> Iterator[RulerMark]:
    """Both ends of the way of each, where there are such; words of both by the names of those whose way it is."""
    for name, own in words.items():
        for quantity, is_top, word in zip(_ENDS[dimension], (True, False), own, strict=True):
            angle = float(shown(quantity)[shown.member(dimension, name)])
            if np.isfinite(angle):
                yield RulerMark(name, angle, is_top, word)


def _textbook_words(shown: OneDesign) -> Words:
    """Name the textbook's forms that stand beside the first throw's pistons; nothing where there are none."""
    words = {"two_harmonics": _("two harmonics (333)–(337)"), "reconstructed": _("(I.13) reconstructed")}
    drawn = drawn_forms(shown)
    forms = [words[shown.result.labels["motion_method"][form]] for form in dict.fromkeys(drawn.values())]
    return Listed([*forms, *(drawn if len(drawn_names(shown, "piston")) > FEW else ())])
