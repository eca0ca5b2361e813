"""Loads on the shaft that an engine cannot turn: computed with all the same, and flagged."""

import numpy as np

from cranktrain.language import _
from cranktrain.numerics.ties import largest_of
from cranktrain.questions.evenness.shaft_balance import ShaftBalance
from cranktrain.record import record
from cranktrain.saying.checks import Flagged
from cranktrain.saying.wording import number


@record
class UnlikelyEvenness(Flagged):
    """Loads on the shaft that hardly any machine has."""


def unlikely_evenness(balance: ShaftBalance | None) -> UnlikelyEvenness:
    """Flag loads that take much more than a machine gives which drives them; what is driven itself has a motor."""
    if balance is None:
        return UnlikelyEvenness()
    given, left = balance.machine, balance.left
    over = [design for design in range(given.size) if given[design] > 0 and balance.undeclared(design) < 0]
    if not over:
        return UnlikelyEvenness()
    worst = largest_of(over, lambda design: float(np.abs(left[design]) / given[design]))
    said = _("Loads on the shaft take {load} on the mean, and the machine gives {machine}: are their sizes right?")
    taken, machine = (number(float(of[worst]), "N*m") for of in (balance.taken, given))
    return UnlikelyEvenness(unlikely=(said.format(load=taken, machine=machine),))
