"""What is said of a motor that is enough, and of a flywheel that is to be found."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.questions.sizing.flywheel_sizing import DriveFlywheel
from cranktrain.questions.sizing.motor_checks import CHECK_TITLES, is_with_load
from cranktrain.questions.sizing.motor_sizing import MotorSizing
from cranktrain.saying.labels import titled
from cranktrain.saying.rows import Amount, AnswerLine, worded
from cranktrain.saying.wording import Names


def sizing_rows(labels: Names, design: int, found: MotorSizing) -> Iterator[AnswerLine]:
    """What governs the declared motor, and the smallest typical one that passes."""
    _declared, chosen, smaller = found.largest_share[design].tolist()
    yield from _used(found, design)
    if np.isfinite(chosen):
        words = _("typical {power}, used to {share}")
        if is_with_load(found.governing(design, 1)):
            words += _(" if it starts loaded")
        if np.isfinite(smaller):
            words += _("; {less} misses by {by}: {missed}")
        yield worded(
            _("motor that is enough"),
            words,
            power=Amount(float(found.sized_power[design, 1]), "W"),
            share=Amount(chosen, "%"),
            **_smaller(found, design, smaller),
        )


def _used(found: MotorSizing, design: int) -> Iterator[AnswerLine]:
    """Every share of the declared motor that is asked for; of a start with its load at the worst angle, if it must."""
    shares: dict[str, Amount | str] = {}
    words: list[str] = []
    for check, share in zip(found.labels["sizing_check"], found.sizing_share[design, 0].tolist(), strict=True):
        if np.isfinite(share):
            piece = f"share_{len(shares)}"
            shares[piece] = Amount(share, "%")
            said = _("{share} if it must start with load at the worst angle") if is_with_load(check) else ""
            words.append((said or _("{check} {share}")).format(check=titled(CHECK_TITLES, check), share=f"{{{piece}}}"))
    if shares:
        yield worded(_("motor is used to"), ", ".join(words), **shares)
    if found.unknown:
        yield worded(_("not checked of it"), found.unknown)


def _smaller(found: MotorSizing, design: int, share: float) -> dict[str, Amount | str]:
    """Pieces that tell of the next smaller motor, where there is one that runs."""
    if not np.isfinite(share):
        return {}
    power = Amount(float(found.sized_power[design, 2]), "W")
    return {"less": power, "by": Amount(share - 1, "%"), "missed": titled(CHECK_TITLES, found.governing(design, 2))}


def flywheel_rows(labels: Names, design: int, found: DriveFlywheel) -> Iterator[AnswerLine]:
    """Flywheel for the wanted torque or evenness, and what it does to the effective torque."""
    words, numbers = found.words_and_numbers(design)
    yield worded(_("flywheel of the drive"), words, **numbers)
