"""The sources' errors, by the name of the text, of those texts whose formulas are computed."""

from collections.abc import Callable, Mapping

from cranktrain.texts.bolotin_errata import bolotin_errata
from cranktrain.texts.drive_errata import drive_errata
from cranktrain.texts.slider_crank_synthesis import wrong_steps
from cranktrain.texts.steam_engine_errata import steam_errata
from cranktrain.texts.throw_errata import throw_errata
from cranktrain.texts.wrong_step import WrongStep

ERRATA: Mapping[str, Callable[[], tuple[WrongStep, ...]]] = {
    "steam-engine": steam_errata,
    "gandzha": drive_errata,
    "slider-crank-synthesis": wrong_steps,
    "bolotin": bolotin_errata,
    "crankshaft-reactions": throw_errata,
}
"""Each gives its text's wrong steps in the text's order."""
