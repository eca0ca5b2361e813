"""What the crankshaft says in the answer: the largest load of a main bearing by every method, and which to trust."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.crankshaft.methods import method_named
from cranktrain.questions.crankshaft.methods.bearing_method import ELASTIC, BearingMethod
from cranktrain.questions.crankshaft.results.housing_spread import HousingSpread
from cranktrain.questions.crankshaft.results.main_bearing_loads import MainBearingLoads
from cranktrain.questions.crankshaft.results.section_torques import SectionTorques, widest_sections
from cranktrain.saying.rows import Amount, AnswerLine, Extent, worded
from cranktrain.saying.wording import Names

_ALIKE = 1e-9
"""Loads that differ by less, in parts of the largest, are one."""


def bearing_rows(
    labels: Names, design: int, found: MainBearingLoads, housing: HousingSpread | None
) -> Iterator[AnswerLine]:
    """The largest load and where it is, by what the bearings are taken for; and by how much all methods differ."""
    methods, every = [method_named(name) for name in labels["bearing_method"]], found.largest_bearing_load.value[design]
    for taken in dict.fromkeys(method.bearings for method in methods):
        of_these = [(method, load) for method, load in zip(methods, every, strict=True) if method.bearings is taken]
        (_best, largest), *others = of_these
        if np.all(np.isfinite(largest)):
            yield _by_bearings(_(taken.title), largest, others, labels["bearing"])
            if housing is not None and taken is ELASTIC:
                yield from _by_housing(housing, design)
    if np.all(np.isfinite(every)):
        yield _spread(every, labels["bearing"], methods[0])


def _by_bearings(
    title: str, largest: Array, others: Sequence[tuple[BearingMethod, Array]], bearings: Sequence[str]
) -> AnswerLine:
    """The largest load by the most trusted of the methods that take the bearings for the same, and another beside."""
    load, bearing = Amount(float(np.max(largest)), "N"), bearings[first_largest(largest)]
    for method, other in others:
        if method.beside is not None:
            return worded(title, _(method.beside), load=load, other=Amount(float(np.max(other)), "N"), bearing=bearing)
    return worded(title, _("{load} in bearing {bearing}"), load=load, bearing=bearing)


def _by_housing(housing: HousingSpread, design: int) -> Iterator[AnswerLine]:
    """The largest load where housings are half and twice as stiff as the file has them, if that makes a difference."""
    soft, stiff = (
        float(np.max(own[design])) for own in (housing.bearing_load_soft_housing, housing.bearing_load_stiff_housing)
    )
    if abs(stiff - soft) > _ALIKE * stiff:
        yield worded(_("half, twice as stiff"), _("{soft}, {stiff}"), soft=Amount(soft, "N"), stiff=Amount(stiff, "N"))


def _spread(most: Array, bearings: Sequence[str], best: BearingMethod) -> AnswerLine:
    """Which method to trust, and how much all differ where they differ most; on two bearings they do not."""
    if np.all(np.ptp(most, axis=0) <= _ALIKE * np.max(most)):
        return worded(_("to trust"), _("any: all methods give the same"))
    widest = first_largest(np.ptp(most, axis=0))
    extent = Extent(float(np.min(most[:, widest])), float(np.max(most[:, widest])), "N")
    return worded(_("to trust"), _(best.trust), range=extent, bearing=bearings[widest], method=_(best.title))


def torque_rows(labels: Names, design: int, found: SectionTorques) -> Iterator[AnswerLine]:
    """The worst journal and the worst pin: those with the widest range of their torque."""
    ranges, sections = found.section_torque_range[design, 0], labels["section"]
    journal, pin = widest_sections(ranges, found.labels["section"])
    yield worded(
        _("range of torque"),
        _("{journal} in {in_journal}, {pin} in {in_pin}"),
        journal=Amount(float(ranges[journal]), "N*m"),
        pin=Amount(float(ranges[pin]), "N*m"),
        in_journal=sections[journal],
        in_pin=sections[pin],
    )
