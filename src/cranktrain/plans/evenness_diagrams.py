"""Wittenbauer's and Mertsalov's diagrams of a machine, as data, out of its result."""

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import Listed, _
from cranktrain.questions.evenness.flywheel import FlywheelSize
from cranktrain.questions.evenness.shaft_work import ShaftWork
from cranktrain.saying.wording import once_each
from cranktrain.texts.flywheel_diagrams import Mertsalov, Wittenbauer, mertsalov, wittenbauer


def wittenbauer_diagram(result: Result) -> Wittenbauer:
    """Give the energy–mass curve of a machine and the tangents that meet in its origin.

    Parameters
    ----------
    result : Result
        Of a machine that says how evenly it is to run.

    Returns
    -------
    Wittenbauer
        Arrays with the design axis first. [kg·m², J, rad from the first crank angle of the grid]

    Raises
    ------
    InputError
        Where the result has no flywheel wanted, and says what is missing, or where that is NaN.

    Notes
    -----
    docs/theory/evenness, eqs. (17.6) and (17.7).
    """
    work, size = _sized(result)
    return wittenbauer(work.excess, work.inertia, size.exact)


def mertsalov_diagram(result: Result) -> Mertsalov:
    """Give the energy that the flywheel has to take up, by Mertsalov; as `wittenbauer_diagram`.

    Notes
    -----
    The mean speed is half the sum of the extremes. docs/theory/evenness, eq. (17.9).
    """
    work, size = _sized(result)
    return mertsalov(work.excess, work.inertia, (size.exact.largest_speed + size.exact.smallest_speed) / 2)


def _sized(result: Result) -> tuple[ShaftWork, FlywheelSize]:
    """Find work and flywheel in a result."""
    size = result.get(FlywheelSize)
    if size is None:
        needs = Listed(once_each(result.needs_of("flywheel_inertia")))
        allowed = _("a diagram of the flywheel needs {needs}", needs=needs)
        raise InputError([Problem("evenness", None, allowed)])
    if not np.all(np.isfinite(size.exact.inertia)):
        allowed = _("gives no flywheel to draw: the torque is not known all round")
        raise InputError([Problem("evenness.coefficient", None, allowed)])
    return result[ShaftWork], size
