"""What torque says in the answer: on the shaft, its orders, and through gears."""

from collections.abc import Iterator

import numpy as np

from cranktrain.grouping import grouped
from cranktrain.language import Listed, _
from cranktrain.questions.torque.orders import PhaseStarSums, TorqueOrders
from cranktrain.questions.torque.torques import GearTorques, ShaftTorques
from cranktrain.saying.amounts import Extent
from cranktrain.saying.rows import AnswerLine, Telling, worded

_LITTLE = 1e-2
"""Orders that are less than this part of the largest are not named."""
_NAMED = 4
"""How many major orders are named."""


def torque_rows(
    of: Telling, torques: ShaftTorques, orders: TorqueOrders, stars: PhaseStarSums | None
) -> Iterator[AnswerLine]:
    """Mean and range of the torque: what the machine gives, or what drives it; and its largest orders."""
    if torques.is_none[of.design]:
        yield worded(_("on the shaft"), _("none"))
        return
    is_driven = of.values(torques, "mean_torque") < 0
    sense = -1.0 if is_driven else 1.0
    mean = of.amount(torques, "mean_torque", sense=sense)
    ends = ("largest_torque", "smallest_torque") if is_driven else ("smallest_torque", "largest_torque")
    span = of.extent(torques, *ends, sense=sense, placed=True)
    name = _("needed at the shaft") if is_driven else _("on the shaft")
    yield worded(name, _("mean {mean}, {span}", mean=mean, span=span) if mean.value else span)
    amplitude = of.values(orders, "torque_order_amplitude")
    if largest := [i for i in orders.largest(of.design) if amplitude[i] > _LITTLE * np.nanmax(amplitude)]:
        said = [of.amount(orders, "torque_order_amplitude", i) for i in largest]
        yield worded(_("largest orders"), Listed([Listed((*one.member, one), ": ") for one in said]))
    yield from () if stars is None else major_rows(of, stars)


def major_rows(of: Telling, stars: PhaseStarSums) -> Iterator[AnswerLine]:
    """Orders in which all cylinders add up, where not all do."""
    names = of.labels["order"]
    major = [name for name, is_major in zip(names, stars.stars.is_major[of.design], strict=True) if is_major]
    if major and len(major) < len(names):
        named = ", ".join([*major[:_NAMED], *["…"] * (len(major) > _NAMED)])
        yield worded(_("major orders"), named, quantity="phase_star_sum")


def star_rows(of: Telling, stars: PhaseStarSums, torques: ShaftTorques | None) -> Iterator[AnswerLine]:
    """Orders in which all cylinders add up, of a machine of which no torque is known."""
    if torques is None:
        yield from major_rows(of, stars)


def gear_rows(of: Telling, gear: GearTorques) -> Iterator[AnswerLine]:
    """What each shaft passes to the main one, and its share of the work; shafts that pass alike together."""
    shafts, reversals = of.labels["shaft"], of.values(gear, "gear_reversals")
    passed = {
        i: Extent(float(np.min(torque)), float(np.max(torque)), "N*m", quantity="gear_torque")
        for i, torque in enumerate(of.values(gear, "gear_torque"))
        if not np.isnan(reversals[i])
    }
    same = grouped((f"{one.least:.6g} to {one.most:.6g}", i) for i, one in passed.items())
    for first, *others in same.values():
        share = of.amount(gear, "work_share", first, unit="%")
        with_share = _("{passed}, {share} of the work", passed=passed[first], share=share)
        said = passed[first] if np.isnan(share.value) else with_share
        if reversals[first]:
            said = _("{said}, reversing {n} times a cycle", said=said, n=f"{reversals[first]:.0f}")
        yield worded(_("gear from {shafts}", shafts=", ".join(shafts[i] for i in (first, *others))), said)
