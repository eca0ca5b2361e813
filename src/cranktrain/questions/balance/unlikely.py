"""Balance weights that shake the frame more than the machine without them: computed with all the same, and flagged."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import Words, _
from cranktrain.layout.speed import Speed
from cranktrain.questions.balance.shaking import ShakingForces
from cranktrain.questions.balance.weights import BalanceWeights, DeclaredBalance
from cranktrain.record import record
from cranktrain.saying.checks import Flagged
from cranktrain.saying.wording import number

_MORE = 0.01
"""By so much of the machine's largest force, and of what the weights could do together: less is their rounding."""


@record
class UnlikelyBalance(Flagged):
    """Balance weights that do the contrary of what they are for."""


def unlikely_balance(
    shaking: ShakingForces | None, weights: BalanceWeights | None, declared: DeclaredBalance | None, speed: Speed | None
) -> UnlikelyBalance:
    """Flag weights of the file that make the largest shaking force larger."""
    if shaking is None or weights is None or declared is None or speed is None:
        return UnlikelyBalance()
    has_given = declared.given.moment.shape[-1] > 0
    return UnlikelyBalance(unlikely=tuple(_heavier(shaking, weights, speed)) if has_given else ())


def _heavier(shaking: ShakingForces, weights: BalanceWeights, speed: Speed) -> Iterator[Words]:
    largest = np.max(np.hypot(shaking.shaking_force_x, shaking.shaking_force_y), axis=-1)
    without, balanced = largest[:, 0], largest[:, -1]
    own = weights.weights
    together = np.sum(np.abs(own.moment) * own.ratio**2, axis=-1) * speed.mean[:, 0, 0] ** 2
    more = balanced - without
    is_more = (more > _MORE * without) & (more > _MORE * together)
    if np.any(is_more):
        design = int(np.argmax(is_more))
        said = _(
            "With [balance] the largest shaking force is {balanced}, without {without}: are angles and sizes of its"
            " weights right, and all that turns in [masses]?"
        )
        yield said.format(balanced=number(float(balanced[design]), "kN"), without=number(float(without[design]), "kN"))
