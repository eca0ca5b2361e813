"""The driver's forces: the bearing's reaction, and the torque that turns the crank as it turns."""

from typing import NamedTuple

import numpy as np

from cranktrain.linkage.crank import Crank
from cranktrain.linkage.forces.wrench import Wrench, added, handed_back
from cranktrain.linkage.point import fixed
from cranktrain.motion import ONE, ZERO, Array, Coefficient, Link, Point, single

_NOT_ASKED = single(np.nan)


class CrankReactions(NamedTuple):
    """Wrench of the bearing on the crank, without moment; torque that must be applied to the crank [N·m]."""

    bearing: Wrench
    driving_torque: Array


def crank_link(pin: Point, geometry: Crank) -> Link:
    """Crank as a link, from the shaft's centre to its pin; its angle's value is NaN, as no force asks for it."""
    return Link(
        fixed(ZERO, ZERO),
        Coefficient(_NOT_ASKED, ONE, ZERO),
        pin.x.value / geometry.radius,
        pin.y.value / geometry.radius,
    )


def crank_reactions(load: Wrench) -> CrankReactions:
    """Reactions of a shaft.

    Parameters
    ----------
    load : Wrench, shape (..., n)
        All that its cranks bear and what hangs on them hands back, about the shaft's centre.

    Returns
    -------
    CrankReactions, shape (..., n)
    """
    return CrankReactions(Wrench(-load.x, -load.y, 0.0 * load.moment), -load.moment)


def carrying_crank(crank: Link, on_crank: Wrench, pin: Point, reaction: Wrench) -> CrankReactions:
    """Reactions of a shaft with one crank, on whose pin one group hangs.

    Parameters
    ----------
    crank : Link, coefficients of shape (..., n)
    on_crank : Wrench, shape (..., n)
        All that acts on the crank but its joints, about the shaft's centre.
    pin : Point
        The crank pin. [m]
    reaction : Wrench, shape (..., n)
        Of the crank on the group.

    Returns
    -------
    CrankReactions, shape (..., n)
    """
    return crank_reactions(added(on_crank, handed_back(crank, pin, reaction)))
