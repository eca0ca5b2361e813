"""What torque says in the answer: on the shaft, its orders, and through gears."""

from collections.abc import Iterator

import numpy as np

from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.questions.torque.orders import PhaseStarSums, TorqueOrders
from cranktrain.questions.torque.torques import GearTorques, ShaftTorques
from cranktrain.saying.rows import Amount, AnswerLine, Extent, worded
from cranktrain.saying.wording import Names

_LITTLE = 1e-2
"""Orders that are less than this part of the largest are not named."""
_NAMED = 4
"""How many major orders are named."""


def torque_rows(
    labels: Names, design: int, torques: ShaftTorques, orders: TorqueOrders, stars: PhaseStarSums | None
) -> Iterator[AnswerLine]:
    """Mean and range of the torque: what the machine gives, or what drives it; and its largest orders."""
    mean, most, least = float(torques.mean_torque[design]), torques.largest_torque, torques.smallest_torque
    if torques.is_none[design]:
        yield worded(_("on the shaft"), _("none"))
        return
    low, high = (most, least) if mean < 0 else (least, most)
    sense = -1.0 if mean < 0 else 1.0
    span = Extent(
        sense * float(low.value[design]),
        sense * float(high.value[design]),
        "N*m",
        (float(low.angle[design]), float(high.angle[design])),
    )
    name = _("needed at the shaft") if mean < 0 else _("on the shaft")
    yield worded(name, _("mean {mean}, {span}") if mean else "{span}", mean=Amount(sense * mean, "N*m"), span=span)
    amplitude = orders.torque_order_amplitude[design]
    if largest := [i for i in orders.largest(design) if amplitude[i] > _LITTLE * np.nanmax(amplitude)]:
        said = [(labels["order"][i], Amount(float(amplitude[i]), "N*m")) for i in largest]
        words = ", ".join(f"{order}: {{amount{i}}}" for i, (order, _amount) in enumerate(said))
        yield worded(_("largest orders"), words, **{f"amount{i}": amount for i, (_order, amount) in enumerate(said)})
    yield from () if stars is None else major_rows(labels, design, stars)


def major_rows(labels: Names, design: int, stars: PhaseStarSums) -> Iterator[AnswerLine]:
    """Orders in which all cylinders add up, where not all do."""
    major = [name for name, is_major in zip(labels["order"], stars.is_major[design], strict=True) if is_major]
    if major and len(major) < len(labels["order"]):
        named = ", ".join([*major[:_NAMED], *["…"] * (len(major) > _NAMED)])
        yield worded(_("major orders"), "{orders}", orders=named)


def star_rows(labels: Names, design: int, stars: PhaseStarSums, torques: ShaftTorques | None) -> Iterator[AnswerLine]:
    """Orders in which all cylinders add up, of a machine of which no torque is known."""
    if torques is None:
        yield from major_rows(labels, design, stars)


def gear_rows(labels: Names, design: int, gear: GearTorques) -> Iterator[AnswerLine]:
    """What each shaft passes to the main one, and its share of the work; shafts that pass alike together."""
    shafts, reversals, shares = labels["shaft"], gear.gear_reversals[design], gear.work_share[design]
    passed = {
        i: Extent(float(np.min(torque)), float(np.max(torque)), "N*m")
        for i, torque in enumerate(gear.gear_torque[design])
        if not np.isnan(reversals[i])
    }
    same = grouped((f"{one.least:.6g} to {one.most:.6g}", i) for i, one in passed.items())
    for first, *others in same.values():
        said = "{passed}" if np.isnan(shares[first]) else _("{passed}, {share} of the work")
        if reversals[first]:
            said = _("{said}, reversing {n} times a cycle", said=said, n=f"{reversals[first]:.0f}")
        share = {} if np.isnan(shares[first]) else {"share": Amount(float(shares[first]), "%")}
        name = _("gear from {shafts}", shafts=", ".join(shafts[i] for i in (first, *others)))
        yield worded(name, said, passed=passed[first], **share)
