"""What balance says in the answer: which orders shake the frame, and what weights leave of them."""

from collections.abc import Iterator

from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.questions.balance.shaken import Shaken
from cranktrain.questions.balance.shaking import ShakingCouples, ShakingForces
from cranktrain.rows import Amount, Row, worded
from cranktrain.wording import Names


def force_rows(labels: Names, design: int, forces: ShakingForces) -> Iterator[Row]:
    """Orders of the shaking force."""
    names = (_("shaking force"), _("left with [balance]"))
    return _by_order(labels, design, forces, forces.shaking_force_largest, "N", names)


def couple_rows(labels: Names, design: int, couples: ShakingCouples) -> Iterator[Row]:
    """Orders of the shaking couple."""
    names = (_("shaking couple"), _("left with [balance]"))
    return _by_order(labels, design, couples, couples.shaking_couple_largest, "N*m", names)


def _by_order(
    labels: Names, design: int, found: Shaken, largest: Array, unit: str, names: tuple[str, str]
) -> Iterator[Row]:
    """Largest orders, without weights and, where there are any, with them."""
    for name, left in zip(names, found.left(largest, design), strict=False):
        if left is None:
            yield worded(name, _("not known, as the links do not close all round"))
            continue
        said = {f"amount{i}": Amount(float(size), unit) for i, (_order, size) in enumerate(left)}
        words = ", ".join(
            _("order {order}: {amount}").format(order=labels["order"][order], amount=f"{{amount{i}}}")
            for i, (order, _size) in enumerate(left)
        )
        yield worded(name, words or _("none"), **said)
