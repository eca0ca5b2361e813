"""When a throw's rotating masses load no support: two conditions, static and dynamic, each in two planes."""

from typing import Literal, NamedTuple

import numpy as np

from cranktrain.questions.crankshaft.methods.throw_reactions import (
    ThrowForces,
    ThrowLengths,
    throw_balance,
    throw_length,
)

_ROUNDING = 1e-12
"""Of the largest sum that a residual comes from."""


class BalanceCondition(NamedTuple):
    """A condition for a throw without reactions of rotating masses.

    name: static, of forces, or dynamic, of their moments about the left support; outward, against: what is left over
    in the crank's plane and against the rotation [N, N·m]; scale: the sum of the sizes that it is left over from.
    """

    name: Literal["static", "dynamic"]
    outward: float
    against: float
    scale: float

    @property
    def residual(self) -> float:
        """What is left over, in parts of the sum of all sizes; 0 where there are no forces."""
        return float(np.hypot(self.outward, self.against)) / self.scale if self.scale else 0.0

    @property
    def holds(self) -> bool:
        """Whether nothing is left over but rounding."""
        return self.residual <= _ROUNDING


class BalanceConditions(NamedTuple):
    """Both conditions; only together they leave no reactions."""

    static: BalanceCondition
    dynamic: BalanceCondition

    @property
    def hold(self) -> bool:
        """Whether both do."""
        return self.static.holds and self.dynamic.holds


def balance_conditions(lengths: ThrowLengths, forces: ThrowForces) -> BalanceConditions:
    """Say which condition of a throw without reactions of C₁ … C₁₅ holds, with what is left over.

    Parameters
    ----------
    lengths : ThrowLengths
    forces : ThrowForces
        External counterweights count; K and T do not.

    Returns
    -------
    BalanceConditions

    Notes
    -----
    ΣC = 0 and ΣCz = 0; docs/theory/crankshaft, eq. (24.36).

    Examples
    --------
    >>> sizes = ThrowLengths(*(np.array(0.01) for _name in ThrowLengths._fields))
    >>> none = ThrowForces(*(np.array(0.0) for _name in ThrowForces._fields))
    >>> found = balance_conditions(sizes, none._replace(c1=np.array(100.0), c4=np.array(100.0)))
    >>> found.static.holds, found.dynamic.holds, round(found.dynamic.outward, 6)
    (True, False, 2.5)
    """
    left = throw_balance(lengths, forces, is_first=True, is_last=True)
    outward, against = float(np.ravel(left.outward)[0]), float(np.ravel(left.against)[0])
    moments = float(np.ravel(left.outward_moment)[0]), float(np.ravel(left.against_moment)[0])
    sizes = float(sum(abs(getattr(forces, name)) for name in ThrowForces._fields if name.startswith("c")))
    reach = float(throw_length(lengths) + lengths.l_p1 + lengths.l_p2)
    return BalanceConditions(
        BalanceCondition("static", outward, against, sizes),
        BalanceCondition("dynamic", *moments, sizes * reach),
    )
