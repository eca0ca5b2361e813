"""A clutch that slips until both its sides turn alike, with a constant torque."""

from typing import NamedTuple

import numpy as np

from cranktrain.motion import Array


class Engagement(NamedTuple):
    """What a clutch joins.

    Attributes
    ----------
    driving_inertia, driven_inertia : Array
        Behind both its sides. [kg·m²]
    torque : Array
        While it slips. [N·m]
    load : Array
        Against the driven side, constant. [N·m]
    driving_speed, driven_speed : Array
        At the beginning, the driving side being the faster. [rad/s]
    """

    driving_inertia: Array
    driven_inertia: Array
    torque: Array
    load: Array
    driving_speed: Array
    driven_speed: Array


class Engaged(NamedTuple):
    """How long it slips [s], what turns to heat in it [J], and the speed with which both go on [rad/s]."""

    slip_time: Array
    heat: Array
    speed: Array


def engaged(clutch: Engagement) -> Engaged:
    """Slip of a clutch, in closed form.

    Parameters
    ----------
    clutch : Engagement, fields of any shapes that broadcast

    Returns
    -------
    Engaged
        NaN where its torque does not bring both sides together.

    Notes
    -----
    docs/theory/drive, eqs. (25.27) and (25.28). It then holds where `held_torque` is within what it bears at rest.

    Examples
    --------
    >>> found = engaged(Engagement(40.0, 6.0, 900.0, 150.0, 40.0, 0.0))
    >>> round(float(found.slip_time), 12), round(float(found.heat), 6), round(float(found.speed), 6)
    (0.271186440678, 4881.355932, 33.898305)
    """
    difference = clutch.driving_speed - clutch.driven_speed
    closing = clutch.torque / clutch.driving_inertia + (clutch.torque - clutch.load) / clutch.driven_inertia
    time = difference / np.where(closing > 0, closing, np.nan)
    speed = clutch.driving_speed - clutch.torque * time / clutch.driving_inertia
    return Engaged(time, 0.5 * clutch.torque * difference * time, speed)


def held_torque(clutch: Engagement, driving_torque: Array) -> Array:
    """Torque through the clutch once both sides turn alike, with a torque on the driving side. [N·m]

    docs/theory/drive, eq. (25.28).
    """
    both = clutch.driving_inertia + clutch.driven_inertia
    return (clutch.driven_inertia * driving_torque + clutch.driving_inertia * clutch.load) / both
