"""The sources' errors, by the name of the text, of those texts whose formulas are computed."""

from collections.abc import Callable, Mapping

from cranktrain.textbook.bolotin_errata import bolotin_errata
from cranktrain.textbook.drive_errata import drive_errata
from cranktrain.textbook.slider_crank_synthesis import wrong_steps
from cranktrain.textbook.steam_engine_errata import steam_errata
from cranktrain.textbook.throw_errata import throw_errata
from cranktrain.textbook.wrong_step import WrongStep

SYNTHESIS = "slider-crank-synthesis"

ERRATA: Mapping[str, Callable[[], tuple[WrongStep, ...]]] = {
    "steam-engine": steam_errata,
    "gandzha": drive_errata,
    SYNTHESIS: wrong_steps,
    "bolotin": bolotin_errata,
    "crankshaft-reactions": throw_errata,
}
"""Each gives its text's wrong steps in the text's order."""
