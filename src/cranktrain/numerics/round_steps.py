"""Round steps: sizes by which numbers are typed."""

import numpy as np


def round_below(size: float) -> float:
    """Give the largest of 1, 2 and 5 times a power of ten that is no larger.

    Examples
    --------
    >>> round_below(0.7), round_below(20.0)
    (0.5, 20.0)
    """
    power = 10.0 ** np.floor(np.log10(size))
    return float(power * next(part for part in (5, 2, 1) if part * power <= size * (1 + 1e-9)))


def decimals_of(step: float) -> int:
    """Give how many decimals a number has that is typed to a step.

    Examples
    --------
    >>> decimals_of(0.05), decimals_of(20.0)
    (2, 0)
    """
    return max(0, -int(np.floor(np.log10(step) + 1e-9)))
