"""The table of a machine file that names a speed curve, and the file read: speed over the crank angle."""

from collections.abc import Iterator, Sequence
from typing import ClassVar

import numpy as np
from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.layout.cycle_table import CycleFileSpec, Words, given_curve
from cranktrain.layout.speed import SpeedCurve
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.knotted import knotted_curve, spline_through
from cranktrain.numerics.periodic import PeriodicCurve, curves_by_design
from cranktrain.numerics.polyline import Polyline
from cranktrain.quantities import Dimension

_FEWEST = 3
_LOOKED_AT = 16
"""Places between two points of the file at which a speed that would fall to 0 is looked for."""
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(12)
"""Of the time from point to point: ∫dφ/ω of a smooth ω."""


class SpeedCurveSpec(CycleFileSpec, frozen=True):
    """Speed of the main shaft over the crank angle from a file of two columns, at which everything is then computed.

    Whoever loads a machine file also reads the file that `file` names, and puts what it holds into `text`.
    """

    of_file: ClassVar[frozenset[str]] = CycleFileSpec.of_file | {"speed_unit"}
    words: ClassVar[Words] = Words(
        N_("a speed curve"),
        N_("speed"),
        Dimension.SPEED,
        "speed_unit",
        (N_("the file names no unit of speed"), N_('write speed_unit = "rpm" (or {units})')),
    )

    speed_unit: str | None = Field(
        default=None, description=N_("Unit of the speeds, where the header does not say it.")
    )

    @property
    def cycle(self) -> float:
        """Crank angle after which it repeats: a turn, or two; a turn where nobody has read the file. [rad]"""
        return TURN if self.text is None else given_curve(self).period

    def _curve_problems(self, curve: Polyline) -> Iterator[Problem]:
        """Find too few points, speeds that are none, and a curve through them that falls to 0."""
        steps = np.diff(curve.angles, append=curve.angles[0] + curve.period)
        between = curve.angles[:, np.newaxis] + steps[:, np.newaxis] * np.arange(_LOOKED_AT) / _LOOKED_AT
        if len(curve.angles) < _FEWEST:
            yield Problem("file", self.file, _("must have at least {n} angles of a turn", n=_FEWEST))
        elif not np.all(curve.values > 0):
            yield Problem("file", self.file, _("must have speeds of more than 0 all round"))
        elif not np.all(_square(curve, len(curve.angles), curve.period).value(between.ravel()) > 0):
            allowed = _("must have more angles: the smooth curve through these falls to 0 between them")
            yield Problem("file", self.file, allowed)


def _square(speeds: Polyline, n_points: int, cycle: float) -> PeriodicCurve:
    """ω² over the crank angle as it is shown: the spline through that of the file. [rad²/s²]"""
    return knotted_curve(spline_through(speeds.angles, speeds.values**2, speeds.period), n_points, cycle)


def tabled_speed(specs: Sequence[SpeedCurveSpec], n_points: int, cycle: float, *, zero: Array) -> SpeedCurve:
    """Lay a curve through the speeds of every design's file.

    Parameters
    ----------
    specs : sequence of SpeedCurveSpec
    n_points : int
        Of the grid.
    cycle : float
        [rad]
    zero : Array, shape (design, 1, 1)
        φ of the grid's first point. [rad]

    Returns
    -------
    SpeedCurve

    Notes
    -----
    ω² is the periodic cubic spline through the file's, wherever its angles are. docs/theory/evenness, eq. (17.19).
    """
    files = [given_curve(spec) for spec in specs]
    squares = [_square(speeds, n_points, cycle) for speeds in files]
    together = curves_by_design(squares)
    square = together._replace(samples=np.stack([one.samples for one in squares]))
    mean = np.array([_mean_over_time(speeds, one) for speeds, one in zip(files, squares, strict=True)])
    return SpeedCurve(square, zero, mean[:, np.newaxis, np.newaxis], is_steady_running=False)


def _mean_over_time(speeds: Polyline, square: PeriodicCurve) -> float:
    """Angle of a period over the time that it takes. [rad/s]"""
    half = np.diff(speeds.angles, append=speeds.angles[0] + speeds.period)[:, np.newaxis] / 2
    angle = speeds.angles[:, np.newaxis] + half * (1 + _NODES)
    time = np.sum(half * _WEIGHTS / np.sqrt(square.value(angle.ravel()).reshape(angle.shape)))
    return float(speeds.period / time)
