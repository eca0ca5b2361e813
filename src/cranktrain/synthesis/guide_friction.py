"""Friction of a slider on its guide, by the pressure angle: what it adds to the load, and where it locks the slider.

The crank drives the slider by the rod, against a load along the guide; docs/theory/synthesis.
"""

from collections.abc import Iterator
from math import atan, pi, tan

from cranktrain.errors import Problem
from cranktrain.language import Words, _
from cranktrain.saying.wording import number, precise
from cranktrain.synthesis.proposal import Number, plain

_USUAL = 0.1
"""A coefficient of friction to speak of where none is given."""


def locking_angle_of(friction: float) -> float:
    """Pressure angle from which no force in the rod moves the slider, 90° − arctan μ. [rad]"""
    return pi / 2 - atan(friction)


def side_force_share_of(pressure_angle: float, friction: float) -> float:
    """Side force of a slider with friction on its guide, in parts of the load.

    Parameters
    ----------
    pressure_angle : float
        β, less than the locking angle. [rad]
    friction : float
        μ [1]

    Returns
    -------
    float
        N/P = tan β/(1 − μ tan β). Times μ it is the friction.

    Examples
    --------
    >>> from math import radians
    >>> round(side_force_share_of(radians(45), 0.1), 4)
    1.1111
    """
    return tan(pressure_angle) / (1 - friction * tan(pressure_angle))


def friction_numbers(pressure_angle: float, friction: float | None) -> tuple[Number, ...]:
    """Give what friction does at the largest pressure angle of the working stroke [rad]; nothing without friction."""
    if friction is None:
        return ()
    share = side_force_share_of(pressure_angle, friction)
    return (
        Number("side_force_with_friction", "N_μ/P", share, "1", _("Largest side force with friction on the guide")),
        Number(
            "friction_share",
            "F/P",
            friction * share,
            "1",
            _("Largest friction on the guide, of the load"),
        ),
        Number(
            "locking_angle",
            "β_l",
            locking_angle_of(friction),
            "deg",
            _("Pressure angle at which friction locks the slider"),
        ),
    )


def friction_remark(pressure_angle: float, friction: float | None) -> Words:
    """Say what friction does: with a usual coefficient, where none is given."""
    if friction is not None:
        return _("Friction is that of a slider which the crank drives against its load; a slider that drives has less.")
    remark = _(
        "Friction on the guide adds μ tan β/(1 − μ tan β) of the load, {share} for μ = {friction}, and locks the "
        "slider at a pressure angle of 90° − arctan μ, {angle}."
    )
    locking = locking_angle_of(_USUAL)
    share = _USUAL * side_force_share_of(pressure_angle, _USUAL) if pressure_angle < locking else float("nan")
    return remark.format(share=number(share, "%"), friction=plain(_USUAL), angle=number(locking, "deg"))


def locking_problems(pressure_angle: float, friction: float) -> Iterator[Problem]:
    """Find a slider that friction locks at its largest pressure angle [rad]."""
    locking = locking_angle_of(friction)
    if pressure_angle >= locking:
        yield Problem(
            "friction",
            plain(friction),
            _(
                "locks the slider at a pressure angle of {locking}, and this slider-crank has {angle}",
                locking=precise(locking, "deg"),
                angle=precise(pressure_angle, "deg"),
            ),
            _("give smaller pressure angles, or a longer rod_length"),
        )
