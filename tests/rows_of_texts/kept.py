"""What checks of rows share: where they are kept, machines that were run once, closeness."""

from collections import Counter
from functools import cache

import numpy as np

import cranktrain as ct
from cranktrain.texts.contents import TEXTS

EXACT, CLOSE = 1e-12, 1e-9
PHI = np.radians(np.arange(360.0))
CHECKS = {}


def row(letter, number, place=0):
    """The check of the row with that number, and of several the one at that place."""

    def kept(check):
        CHECKS[letter, number, place] = check
        return check

    return kept


def rows():
    """Every row with the command that shows it of a machine."""
    for text in TEXTS:
        places = Counter()
        for one in text.formulas:
            yield (text.letter, one.number, places[one.number]), one.of_machine or one.command
            places[one.number] += 1


@cache
def ran(machine, *quantities, step=1.0):
    return ct.run(machine, quantities=quantities, step_degrees=step)


@cache
def moved(machine):
    return ct.textbook.motion(machine)


def same(found, wanted, within=EXACT):
    """Alike to a part of the largest."""
    size = max(float(np.max(np.abs(wanted))), 1e-300)
    np.testing.assert_allclose(found, wanted, rtol=0, atol=within * size)


def curve_of(found, number, whose, symbol, name=""):
    return next(
        one
        for one in found.over_turn
        if (one.equation, one.of, one.symbol) == (number, whose, symbol) and name in one.name
    )


def argument(command, option):
    return command[command.index(option) + 1]
