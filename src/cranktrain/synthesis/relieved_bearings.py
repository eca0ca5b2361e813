"""Main bearings that are to be relieved, and their loads as weights on the throws change them: linear."""

from collections.abc import Sequence
from typing import Annotated, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis.grids import FACTS_STEP
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.parts import parts_of
from cranktrain.analysis.stages import every_stage, lacking, leading_to, stages_for
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.shafts import Shafts
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.numerics import Peak, largest_between, points_together
from cranktrain.quantities import unlisted
from cranktrain.questions.crankshaft.loads.loaded_shafts import LoadedShafts
from cranktrain.questions.crankshaft.methods import BEARING_METHODS, methods_for
from cranktrain.questions.crankshaft.methods.bearing_method import BearingMethod
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.crankshaft.results.shaft_events import ShaftEvents
from cranktrain.questions.crankshaft.shaft_layout import ShaftLayout
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.record import record
from cranktrain.saying.wording import all_of

Method = Annotated[str, tuple(method.name for method in BEARING_METHODS)]

_WIDEST = np.pi / 9
"""Of a piece of the quadrature. [rad]"""
ASIDE = 1e-9
"""How far from a jump the value on one of its sides is taken. [rad]"""


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
        needs = all_of(absent[LoadedShafts.__name__]) or _("[crankshaft]")
        raise InputError([Problem("", None, _("loads of main bearings need {needs} in the file", needs=needs))])
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
        return Problem("method", method, _("needs {needs} in the file", needs=_(known.bearings.needs)))
    allowed = _("is not linear: {bearings} no weights can be proved to be the best; relieve by another, and run")
    repair = _("choose one of: {names}", names=", ".join(linear))
    return Problem("method", method, allowed.format(bearings=_(known.bearings.title)), repair)


@record
class WeightedShaft:
    """A crankshaft with weights of unknown size.

    Attributes
    ----------
    shafts : LoadedShafts
        Of several designs: the first with all unknowns `at`, each other with one of them more by `more`.
    which : int
        Which of the crankshafts it is.
    at : Array, shape (unknown,)
    more : float
    method : BearingMethod
        A linear one.
    bearings : list of int
        Which of its bearings are spoken of.
    events : ForceEvents
    crank_angle : CrankAngle
    """

    shafts: LoadedShafts
    which: int
    at: Array
    more: float
    method: BearingMethod
    bearings: list[int]
    events: ForceEvents
    crank_angle: CrankAngle

    def vectors(self, shown: Array) -> tuple[Array, Array]:
        """Loads of all its bearings at crank angles, and how unknowns change them.

        Parameters
        ----------
        shown : Array, shape (n,)
            From the grid's zero. [rad]

        Returns
        -------
        base : Array, shape (bearing, n, 2)
            [N]
        change : Array, shape (bearing, n, 2, unknown)
            [N]
        """
        n_designs = len(self.crank_angle.zero)
        acting = self.shafts.loads(np.broadcast_to(shown, (n_designs, 1, shown.size)) + self.crank_angle.zero)
        shaft = self.shafts.each[self.which].metal
        load = np.moveaxis(self.method.of(shaft.supports, acting[self.which]).load, 2, 3)
        change = np.moveaxis(load[1:] - load[0], 0, -1) / self.more
        return load[0] - change @ self.at, change

    def relieved(self, shown: Array) -> tuple[Array, Array]:
        """The same of those bearings that are spoken of."""
        base, change = self.vectors(shown)
        return base[self.bearings], change[self.bearings]

    def largest(self, unknown: Array, sizes: Array) -> Peak:
        """Largest loads, refined on the machine; sizes are those on the grid, shape (bearing, n)."""

        def curves(which: NDArray[np.intp], shown: Array) -> Array:
            base, change = self.relieved(shown.ravel())
            size = np.hypot(*np.moveaxis(base + change @ unknown, -1, 0))
            return size.reshape(-1, *shown.shape)[which, np.arange(which.size)]

        breaks = self.events.whole[:1] - self.crank_angle.zero[:1, 0]
        return largest_between(curves, self.crank_angle.shown, sizes, breaks)

    def quadrature(self) -> tuple[Array, Array]:
        """Crank angles between events, and their weights in a mean over the cycle, shape (n,). [rad, 1]"""
        breaks = self.events.whole[:1] - self.crank_angle.zero[:1, 0]
        angle, weight = points_together(breaks, _WIDEST, self.crank_angle.cycle)
        return angle[0, 0], weight[0, 0] / self.crank_angle.cycle


def weighted_shaft(
    designs: Sequence[Machine], at: Array, more: float, which: int, method: BearingMethod, bearings: list[int]
) -> WeightedShaft:
    """Lay the shaft of some designs out, which differ in weights alone; all is as in `WeightedShaft`."""
    parts = parts_of(designs, step=FACTS_STEP)
    stages = stages_for(designs[0])
    wanted = leading_to(stages, [LoadedShafts, ShaftEvents])
    found: dict[type, Any] = run_stages(wanted, parts, lacking(stages, parts))
    grid: Any = parts[CrankAngle]
    return WeightedShaft(found[LoadedShafts], which, at, more, method, bearings, found[ShaftEvents].of_all, grid)
