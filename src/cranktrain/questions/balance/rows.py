"""What balance says in the answer: which orders shake the frame, and what weights leave of them."""

from collections.abc import Iterator

from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.questions.balance.shaken import Shaken
from cranktrain.questions.balance.shaking import ShakingCouples, ShakingForces
from cranktrain.saying.rows import Amount, AnswerLine, worded
from cranktrain.saying.wording import Names

_NOTHING = 1e-6
"""Of what all parts would do if they added up; less shakes nothing."""
_LITTLE = 1e-2
"""Orders that are less than this part of the largest are not named."""


def force_rows(labels: Names, design: int, forces: ShakingForces) -> Iterator[AnswerLine]:
    """Orders of the shaking force."""
    names = (_("shaking force"), _("left with [balance]"))
    return _by_order(labels, design, forces, forces.shaking_force_largest, "N", names)


def couple_rows(labels: Names, design: int, couples: ShakingCouples) -> Iterator[AnswerLine]:
    """Orders of the shaking couple."""
    names = (_("shaking couple"), _("left with [balance]"))
    return _by_order(labels, design, couples, couples.shaking_couple_largest, "N*m", names)


def _by_order(
    labels: Names, design: int, found: Shaken, largest: Array, unit: str, names: tuple[str, str]
) -> Iterator[AnswerLine]:
    """Largest orders, without weights and, where there are any, with them."""
    least = _NOTHING * float(found.gross[design])
    sizes = [
        None if one is None else [(order, size) for order, size in one if size > least]
        for one in found.left(largest, design)
    ]
    for name, left in zip(names, sizes, strict=False):
        if left is None:
            yield worded(name, _("not known, as the links do not close all round"))
        elif left or left is sizes[0]:
            named = [one for one in left if one[1] > _LITTLE * left[0][1]]
            said = {f"amount{i}": Amount(size, unit) for i, (_order, size) in enumerate(named)}
            words = ", ".join(
                _("order {order}: {amount}", order=labels["order"][order], amount=f"{{amount{i}}}")
                for i, (order, _size) in enumerate(named)
            )
            yield worded(name, words or _("none"), **said)
        elif sizes[0]:
            yield worded(name, _("nothing"))
