"""What the crankshaft says in the answer: the largest load of a main bearing by every method, and which to trust."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.crankshaft.housing import HousingSpread
from cranktrain.questions.crankshaft.section_torques import SectionTorques, widest_sections
from cranktrain.questions.crankshaft.stages import MainBearingLoads
from cranktrain.rows import Amount, AnswerLine, Extent, worded
from cranktrain.wording import Names

_ROWS = (
    (
        N_("on elastic bearings"),
        "frame_elastic",
        "five_moment",
        N_("{load} in bearing {bearing}; a straight shaft {other}"),
    ),
    (N_("on rigid bearings"), "frame_rigid", "split", N_("{load} in bearing {bearing}; split {other}")),
    (N_("with clearance"), "clearance", "clearance", N_("{load} in bearing {bearing}")),
)
"""What the bearings are taken for; the method for that, and what stands beside it; how both are said."""
_TRUST = {
    "frame_elastic": N_("elastic frame; bearing {bearing} by all: {range}"),
    "frame_rigid": N_("between both; bearing {bearing}: {range}"),
}
"""Which method to trust, by the best that the file has numbers for."""
_ALIKE = 1e-9
"""Loads that differ by less, in parts of the largest, are one."""


def bearing_rows(
    labels: Names, design: int, found: MainBearingLoads, housing: HousingSpread | None
) -> Iterator[AnswerLine]:
    """The largest load and where it is, of the crank frame; of other methods beside it; and by how much all differ."""
    bearings = labels["bearing"]
    most = dict(zip(labels["bearing_method"], found.largest_bearing_load.value[design], strict=True))
    for name, method, beside, said in _ROWS:
        own = most.get(method)
        if own is not None and np.all(np.isfinite(own)):
            load, other = (Amount(float(np.max(each)), "N") for each in (own, most[beside]))
            yield worded(_(name), _(said), load=load, other=other, bearing=bearings[first_largest(own)])
            if housing is not None and method == "frame_elastic":
                yield from _by_housing(housing, design)
    every = np.stack(list(most.values()))
    if np.all(np.isfinite(every)):
        yield _spread(every, bearings, next(name for name in _TRUST if name in most))


def _by_housing(housing: HousingSpread, design: int) -> Iterator[AnswerLine]:
    """The largest load where housings are half and twice as stiff as the file has them, if that makes a difference."""
    soft, stiff = (
        float(np.max(own[design])) for own in (housing.bearing_load_soft_housing, housing.bearing_load_stiff_housing)
    )
    if abs(stiff - soft) > _ALIKE * stiff:
        yield worded(_("half, twice as stiff"), _("{soft}, {stiff}"), soft=Amount(soft, "N"), stiff=Amount(stiff, "N"))


def _spread(most: Array, bearings: Sequence[str], best: str) -> AnswerLine:
    """Which method to trust, and how much all differ where they differ most; on two bearings they do not."""
    if np.all(np.ptp(most, axis=0) <= _ALIKE * np.max(most)):
        return worded(_("to trust"), _("any: all methods give the same"))
    widest = first_largest(np.ptp(most, axis=0))
    extent = Extent(float(np.min(most[:, widest])), float(np.max(most[:, widest])), "N")
    return worded(_("to trust"), _(_TRUST[best]), range=extent, bearing=bearings[widest])


def torque_rows(labels: Names, design: int, found: SectionTorques) -> Iterator[AnswerLine]:
    """The worst journal and the worst pin: those with the widest range of their torque."""
    ranges, sections = found.section_torque_range[design, 0], labels["section"]
    journal, pin = widest_sections(ranges, sections)
    yield worded(
        _("range of torque"),
        _("{journal} in {in_journal}, {pin} in {in_pin}"),
        journal=Amount(float(ranges[journal]), "N*m"),
        pin=Amount(float(ranges[pin]), "N*m"),
        in_journal=sections[journal],
        in_pin=sections[pin],
    )
