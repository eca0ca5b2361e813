"""Which main bearings are to be relieved, on which shaft, and by which method their loads are found."""

from collections.abc import Sequence
from typing import Annotated, Any, NamedTuple

from cranktrain.analysis.grids import FACTS_STEP
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.stages import every_stage, lacking, leading_to
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import _
from cranktrain.layout.shafts import Shafts
from cranktrain.machine import Machine
from cranktrain.quantities import unlisted
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts
from cranktrain.questions.crankshaft.methods import BEARING_METHODS, methods_for
from cranktrain.questions.crankshaft.methods.bearing_method import BearingMethod
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.crankshaft.shaft_layout import ShaftLayout

Method = Annotated[str, tuple(method.name for method in BEARING_METHODS)]


class SoughtBearings(NamedTuple):
    """Which of the crankshafts it is, how it is laid out, which of its bearings are spoken of, and by which method."""

    which: int
    layout: ShaftLayout
    bearings: list[int]
    method: BearingMethod


def sought_bearings(machine: Machine, bearing: str, method: str | None) -> SoughtBearings:
    """Find shaft, bearings and method, or say what the file lacks for them."""
    parts = parts_of((machine,), step=FACTS_STEP)
    absent = lacking(every_stage(), parts)
    if LoadedShafts.__name__ in absent:
        needs = _(" and ").join(absent[LoadedShafts.__name__]) or _("[crankshaft]")
        raise InputError([Problem("", None, _("loads of main bearings need {needs} in the file").format(needs=needs))])
    found: dict[type, Any] = run_stages(leading_to(every_stage(), [LoadedShafts]), parts, absent)
    loaded: LoadedShafts = found[LoadedShafts]
    shafts: Any = parts[Shafts]
    which = next((i for i, one in enumerate(loaded.each) if one.layout.declared.shaft == shafts.main), None)
    if which is None:
        allowed = _("says nothing of [shaft.main], on whose throws counterweights stand")
        raise InputError([Problem("crankshaft", None, allowed)])
    layout = loaded.each[which].layout
    names = layout.declared.bearing_names
    declared: Any = parts[DeclaredCrankshafts]
    linear = [one for one in methods_for(declared) if one.bearings.is_linear]
    problems: list[Problem] = []
    if bearing != "all" and bearing not in names:
        problems.append(unlisted("bearing", bearing, [*names, "all"]))
    if method is not None and method not in [one.name for one in linear]:
        problems.append(_no_method(method, [one.name for one in linear]))
    refuse(problems)
    bearings = list(range(len(names))) if bearing == "all" else [names.index(bearing)]
    return SoughtBearings(which, layout, bearings, next(one for one in linear if method in (None, one.name)))


def _no_method(method: str, linear: Sequence[str]) -> Problem:
    """Say why loads cannot be found, or relieved, by a method."""
    known = next((one for one in BEARING_METHODS if one.name == method), None)
    if known is None:
        return unlisted("method", method, linear)
    if known.bearings.is_linear:
        return Problem("method", method, _("needs {needs} in the file").format(needs=_(known.bearings.needs)))
    allowed = _("is not linear: {bearings} no weights can be proved to be the best; relieve by another, and run")
    repair = _("choose one of: {names}").format(names=", ".join(linear))
    return Problem("method", method, allowed.format(bearings=_(known.bearings.title)), repair)
