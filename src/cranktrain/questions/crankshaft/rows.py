"""What the crankshaft says in the answer: the largest load of a main bearing by every method, and which to trust."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import Listed, _
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.crankshaft.methods import method_named
from cranktrain.questions.crankshaft.methods.bearing_method import ELASTIC, BearingMethod
from cranktrain.questions.crankshaft.results.housing_spread import HousingSpread
from cranktrain.questions.crankshaft.results.main_bearing_loads import MainBearingLoads
from cranktrain.questions.crankshaft.results.section_torques import SectionTorques, widest_sections
from cranktrain.saying.amounts import Extent
from cranktrain.saying.rows import AnswerLine, Telling, worded

_LOAD = "largest_bearing_load"
_ALIKE = 1e-9
"""Loads that differ by less, in parts of the largest, are one."""


def bearing_rows(of: Telling, found: MainBearingLoads, housing: HousingSpread | None) -> Iterator[AnswerLine]:
    """The largest load and where it is, by what the bearings are taken for; and by how much all methods differ."""
    methods, every = list(map(method_named, of.labels["bearing_method"])), of.values(found, _LOAD)
    for taken in dict.fromkeys(method.bearings for method in methods):
        of_these = [place for place, method in enumerate(methods) if method.bearings is taken]
        if np.all(np.isfinite(every[of_these[0]])):
            yield _by_bearings(of, found, methods, of_these)
            if housing is not None and taken is ELASTIC:
                yield from _by_housing(of, housing)
    if np.all(np.isfinite(every)):
        yield _spread(every, of.labels["bearing"], methods[0])


def _by_bearings(
    of: Telling, found: MainBearingLoads, methods: Sequence[BearingMethod], of_these: Sequence[int]
) -> AnswerLine:
    """The largest load by the most trusted of the methods that take the bearings for the same, and another beside."""
    every = of.values(found, _LOAD)
    loads = [of.amount(found, _LOAD, place, first_largest(every[place])) for place in of_these]
    title, load, bearing = _(methods[of_these[0]].bearings.title), loads[0], loads[0].member[-1]
    for place, other in zip(of_these[1:], loads[1:], strict=True):
        beside = methods[place].beside
        if beside is not None:
            return worded(title, _(beside, load=load, other=other, bearing=bearing))
    return worded(title, _("{load} in bearing {bearing}", load=load, bearing=bearing))


def _by_housing(of: Telling, housing: HousingSpread) -> Iterator[AnswerLine]:
    """The largest load where housings are half and twice as stiff as the file has them, if that makes a difference."""
    soft, stiff = (
        of.amount(housing, one, first_largest(of.values(housing, one)))
        for one in ("bearing_load_soft_housing", "bearing_load_stiff_housing")
    )
    if abs(stiff.value - soft.value) > _ALIKE * stiff.value:
        yield worded(_("half, twice as stiff"), Listed((soft, stiff)))


def _spread(most: Array, bearings: Sequence[str], best: BearingMethod) -> AnswerLine:
    """Which method to trust, and how much all differ where they differ most; on two bearings they do not."""
    if np.all(np.ptp(most, axis=0) <= _ALIKE * np.max(most)):
        return worded(_("to trust"), _("any: all methods give the same"))
    widest = first_largest(np.ptp(most, axis=0))
    extent = Extent(float(np.min(most[:, widest])), float(np.max(most[:, widest])), "N", quantity=_LOAD)
    return worded(_("to trust"), _(best.trust, range=extent, bearing=bearings[widest], method=_(best.title)))


def torque_rows(of: Telling, found: SectionTorques) -> Iterator[AnswerLine]:
    """The worst journal and the worst pin: those with the widest range of their torque."""
    ranges = of.values(found, "section_torque_range")[0]
    journal, pin = (
        of.amount(found, "section_torque_range", 0, place) for place in widest_sections(ranges, found.labels["section"])
    )
    yield worded(
        _("range of torque"),
        _(
            "{journal} in {in_journal}, {pin} in {in_pin}",
            journal=journal,
            pin=pin,
            in_journal=journal.member[-1],
            in_pin=pin.member[-1],
        ),
    )
