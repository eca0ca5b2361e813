"""The crank angle at which something is asked for."""

import math
from typing import Any

from cranktrain.errors import InputError, Problem
from cranktrain.language import _


def asked_angle(angle: Any) -> float:
    """Read a number of degrees, which is finite.

    Raises
    ------
    InputError
        If it is none.

    Examples
    --------
    >>> asked_angle(60), asked_angle("30")
    (60.0, 30.0)
    """
    try:
        number = float(angle)
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number):
        raise InputError([Problem("at", str(angle), _("must be a number of degrees, such as 60"))])
    return number
