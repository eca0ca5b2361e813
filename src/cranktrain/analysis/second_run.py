"""A second run: everything at a speed that varies over the cycle, found by a first run or given."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from cranktrain.analysis.grids import on_grid
from cranktrain.analysis.outcomes import run_stages
from cranktrain.analysis.stages import lacking, leading_to
from cranktrain.errors import InputError, Problem
from cranktrain.language import Listed, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.question import Parts, Stage
from cranktrain.layout.speed import Speed, SpeedCurve, SpeedWanted, SteadySpeed, speed_curve
from cranktrain.motion import Array
from cranktrain.numerics.periodic import spline_curve


def with_speed(parts: Parts, speed: SpeedWanted, stages: Sequence[Stage], step: float) -> Parts:
    """Put the speed that is wanted into the parts.

    Parameters
    ----------
    parts : mapping of type to object
        What the machine declares.
    speed : "running", array-like of shape (n,) or (design, n), or SpeedCurve
        [rad/s]
    stages : sequence of Stage
        Which of them find the running speed.
    step : float
        Of the grid at whose crank angles speeds of one's own are given. [rad]

    Returns
    -------
    mapping of type to object
        With `SpeedCurve`, which `Speed` holds as well.

    Raises
    ------
    InputError
        Where the file does not say what the running speed needs, there is none, or the speeds given are none.
    """
    declared_curve: Any = parts.get(SpeedCurve)
    if not isinstance(speed, SpeedCurve) and declared_curve is not None and declared_curve.moment is not None:
        allowed = _("must be left out: [shaft.main] acceleration says how the shaft turns, at one moment")
        raise InputError([Problem("speed", str(speed) if isinstance(speed, str) else None, allowed)])
    if isinstance(speed, str) and speed == "running" and declared_curve is not None:
        allowed = (
            _("must be left out: [shaft.main.speed_curve] says how the shaft turns")
            if declared_curve.corners is None
            else _("must be left out: [shaft.main.motion] says how the shaft turns")
        )
        raise InputError([Problem("speed", speed, allowed)])
    curve = speed if isinstance(speed, SpeedCurve) else _curve(parts, speed, stages, step)
    declared: Any = parts.get(Speed, Speed(curve.mean))
    return {**parts, Speed: Speed(declared.value, curve), SpeedCurve: curve}


def _curve(parts: Parts, speed: str | ArrayLike, stages: Sequence[Stage], step: float) -> SpeedCurve:
    """Lay a curve through the running speed, or through one's own."""
    grid: Any = (parts if isinstance(speed, str) else on_grid(parts, step))[CrankAngle]
    if isinstance(speed, str):
        if speed != "running":
            allowed = _('must be "constant", "running" or speeds in rad/s at the crank angles of the grid')
            raise InputError([Problem("speed", speed, allowed)])
        found = _found(parts, stages)
        speeds, accelerations, mean = found.speed, found.acceleration, found.mean
    else:
        speeds = _given(speed, grid)
        accelerations = spline_curve(speeds**2, grid.cycle).slope(grid.shown) / 2
        mean = 1 / np.mean(1 / speeds, axis=-1)
    return speed_curve(
        speeds, accelerations, grid.cycle, zero=grid.zero, mean=mean, is_steady_running=isinstance(speed, str)
    )


def _found(parts: Parts, stages: Sequence[Stage]) -> SteadySpeed:
    """Run as far as the running speed, at constant speed."""
    needed = leading_to(stages, [SteadySpeed])
    absent = lacking(needed, parts)
    if SteadySpeed.__name__ in absent:
        allowed = _("needs {needs} in the file", needs=Listed(absent[SteadySpeed.__name__]))
        raise InputError([Problem("speed", "running", allowed)])
    found: Any = run_stages(needed, parts, absent)[SteadySpeed]
    if np.all(np.isnan(found.speed)):
        reasons = Listed(found.reasons, " ") if found.reasons else _("The speed over the cycle is not known all round.")
        raise InputError([Problem("speed", "running", reasons)])
    return found


def _given(speed: ArrayLike, grid: CrankAngle) -> Array:
    """Speeds on the grid, shape (design, n)."""
    speeds = np.atleast_2d(np.asarray(speed, dtype=np.float64))
    n_designs, n_angles = len(grid.zero), grid.shown.size
    if speeds.shape not in ((1, n_angles), (n_designs, n_angles)):
        shown = " × ".join(map(str, np.shape(speed)))
        allowed = _("must be one speed at each of the {n} crank angles of the grid, for all designs or each")
        raise InputError([Problem("speed", shown, allowed.format(n=n_angles))])
    if not np.all(np.isfinite(speeds) & (speeds > 0)):
        raise InputError([Problem("speed", None, _("must be finite and more than 0 all round"))])
    return np.broadcast_to(speeds, (n_designs, n_angles)).copy()
