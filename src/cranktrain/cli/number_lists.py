"""Numbers as typed in a list: `140`, or `5,10,0,30..720`, where dots go on in steps of the two numbers before them."""

import math
from collections.abc import Callable
from fractions import Fraction

from cranktrain.errors import InputError, Problem
from cranktrain.language import said as _

_MOST = 100_000
"""Numbers at once."""


def exact(word: str) -> Fraction:
    """Read a number as it is typed; `ValueError` where it is none, or no finite one."""
    number = float(word)
    if not math.isfinite(number):
        raise ValueError(word)
    # The shortest digits of a double are those that were typed, however large their exponent.
    return Fraction(repr(number))


def numbers_listed(
    option: str, text: str, allowed: str, example: str, read: Callable[[str], Fraction] = exact
) -> list[Fraction]:
    """Read a list of numbers.

    Parameters
    ----------
    option, text : str
        Where it was typed, and what.
    allowed : str
        What may be.
    example : str
        Of a list with dots.
    read : callable
        Of one number: raises a `ValueError` where it is none, an `InputError` where it may not be.

    Raises
    ------
    InputError
    """
    found: list[Fraction] = []
    for word in text.split(","):
        first, dots, last = word.partition("..")
        try:
            found.append(read(first))
            end = read(last) if dots else found[-1]
        except InputError:
            raise
        except ValueError:
            raise InputError([Problem(option, text, allowed)]) from None
        if dots:
            step = found[-1] - found[-2] if len(found) > 1 else Fraction(0)
            if step <= 0 or (end - found[-1]) / step > _MOST:
                repair = _("write the first two before the dots: {example}", example=example)
                raise InputError([Problem(option, text, allowed, repair)])
            found += [found[-1] + step * (line + 1) for line in range(math.floor((end - found[-1]) / step))]
    return found
