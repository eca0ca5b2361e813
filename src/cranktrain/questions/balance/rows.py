"""What balance says in the answer: which orders shake the frame, and what weights leave of them."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import Listed, Words, _
from cranktrain.motion import Array
from cranktrain.questions.balance.shaken import Shaken
from cranktrain.questions.balance.shaking import ShakingCouples, ShakingForces
from cranktrain.questions.balance.wheels import HammerBlow
from cranktrain.saying.amounts import Amount
from cranktrain.saying.rows import AnswerLine, Telling, entry_called, worded

_NOTHING = 1e-6
"""Of what all parts would do if they added up; less shakes nothing."""
_LITTLE = 1e-2
"""Orders that are less than this part of the largest are not named."""


def force_rows(of: Telling, forces: ShakingForces) -> Iterator[AnswerLine]:
    """Orders of the shaking force."""
    names = (_("shaking force"), _("left with [balance]"))
    return _by_order(of, forces, forces.shaking_force_largest, "shaking_force_largest", names)


def couple_rows(of: Telling, couples: ShakingCouples) -> Iterator[AnswerLine]:
    """Orders of the shaking couple."""
    names = (_("shaking couple"), _("left with [balance]"))
    return _by_order(of, couples, couples.shaking_couple_largest, "shaking_couple_largest", names)


def wheel_rows(of: Telling, blow: HammerBlow) -> Iterator[AnswerLine]:
    """Hammer blow of the wheels, in parts of their loads too, and when it lifts them."""
    yield of.row(_("hammer blow"), blow, "hammer_blow")
    if np.any(np.isfinite(of.values(blow, "hammer_blow_share"))):
        yield of.row(_("of the wheel's load"), blow, "hammer_blow_share", unit="%")
        yield of.row(_("lifts its wheel at"), blow, "lifting_speed")


def _by_order(
    of: Telling, found: Shaken, largest: Array, quantity: str, names: tuple[Words, Words]
) -> Iterator[AnswerLine]:
    """Largest orders, without weights and, where there are any, with them."""
    least, unit = _NOTHING * float(found.gross[of.design]), entry_called(type(found), quantity).shown
    sizes = [
        None if one is None else [(order, size) for order, size in one if size > least]
        for one in found.left(largest, of.design)
    ]
    for name, left in zip(names, sizes, strict=False):
        if left is None:
            yield worded(name, _("not known, as the links do not close all round"))
        elif left or left is sizes[0]:
            named = [one for one in left if one[1] > _LITTLE * left[0][1]]
            said = [
                _("order {order}: {amount}", order=of.labels["order"][i], amount=Amount(size, unit, quantity))
                for i, size in named
            ]
            yield worded(name, Listed(said) if said else _("none"))
        elif sizes[0]:
            yield worded(name, _("nothing"))
