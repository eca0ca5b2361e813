"""Where the file's angles stand on the machine: firing dead centre and sense, found by the pressures themselves."""

from collections.abc import Iterator
from typing import Literal, NamedTuple, TypeAlias

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.fluids.indicator.cycle import Samples
from cranktrain.language import Words, _
from cranktrain.motion import Array, single
from cranktrain.numerics import around_zero
from cranktrain.numerics.ties import first_largest
from cranktrain.quantities import shown

Sense: TypeAlias = Literal["forward", "backward", "found"]

_NEAR = np.radians(60.0)
"""No pressure peaks farther from the firing dead centre."""
_EARLIEST, _LATEST = np.radians(2.0), np.radians(25.0)
"""The peak of a fired cycle stands 5° to 20° after the dead centre; with some reserve."""
_MOTORED_PEAK = np.radians(2.5)
"""A motored cycle peaks 0° to 2° before the dead centre; with some reserve."""
_MOTORED = 0.04
"""|Asymmetry| below which nothing burns: full load gives 0.4 to 0.6, a twentieth of its heat still 0.07."""


class _Found(NamedTuple):
    """Dead centre, how far after it the peak stands [rad], and how much more the gas gives than it takes [1].

    And whether the pressure jumps to its peak, as where heat comes at constant volume.
    """

    dead_centre: float
    peak: float
    asymmetry: float
    is_jump: bool

    @property
    def is_motored(self) -> bool:
        """Whether nothing burns: no more is given than taken, and the peak is at the dead centre."""
        return abs(self.asymmetry) <= _MOTORED and abs(self.peak) <= _MOTORED_PEAK


def placed(samples: Samples, cycle: float, firing_angle: float | None, sense: Sense) -> Samples:
    """Count a cycle from the firing dead centre, in the sense of rotation.

    Parameters
    ----------
    samples : Samples
        In the file's own counting.
    cycle : float
        2π or 4π. [rad]
    firing_angle : float or None
        The file's angle of the firing dead centre [rad]; None to find it: the multiple of 180° by the peak.
    sense : "forward", "backward" or "found"
        Whether the file's angles count with the rotation, against it, or as the pressures say.

    Returns
    -------
    Samples
        Angles in [0, cycle), rising; with what was found, what was changed and what is doubtful.

    Raises
    ------
    InputError
        If no dead centre is near the peak.

    Notes
    -----
    A fired cycle peaks *after* the dead centre and gives more in expansion than compression took: the mean of p sin φ
    over the turn about it, in parts of the mean of p |sin φ|, is positive, p above its lowest. Read backwards it is
    negative. Motored, it is nearly 0 and the peak stands slightly *before* the dead centre.
    docs/theory/gas, eq. (14.9).
    """
    own = _found(samples, cycle, firing_angle)
    is_backward = sense == "backward" or (sense == "found" and own.asymmetry < -_MOTORED)
    if is_backward:
        mirrored = -samples.angles[::-1]
        samples = samples._replace(angles=mirrored, pressures=samples.pressures[::-1])
        firing_angle = None if firing_angle is None else -firing_angle
        own = _found(samples, cycle, firing_angle)
    angles = _within_cycle(samples.angles - own.dead_centre, cycle)
    order = np.argsort(angles, kind="stable")  # of a jump the value before comes first
    count = -own.dead_centre if is_backward else own.dead_centre
    return Samples(
        angles=angles[order],
        pressures=samples.pressures[order],
        findings=(*samples.findings, *_findings(own, count, is_backward, sense, firing_angle is not None)),
        flags=(*samples.flags, *_flags(own, is_backward=is_backward)),
    )


def _within_cycle(angles: Array, cycle: float) -> Array:
    """Bring angles into [0, cycle); what rounding put just below a cycle stands at 0."""
    turned = np.mod(angles, cycle)
    return np.where(turned > cycle - 1e-12, 0.0, turned)


def _found(samples: Samples, cycle: float, firing_angle: float | None) -> _Found:
    """Find the dead centre by the peak, unless it is given, and judge the turn about it."""
    at = float(samples.angles[first_largest(samples.pressures)])
    dead_centre = _dead_centre_by(at) if firing_angle is None else firing_angle
    peak = float(around_zero(single(at - dead_centre), cycle))
    from_it = around_zero(samples.angles - dead_centre, cycle)
    width = _widths(samples.angles, cycle)
    above = samples.pressures - np.min(samples.pressures)  # a raw trace's level says nothing
    about = np.where(np.abs(from_it) < np.pi, width * above, 0.0)
    given, both = np.sum(about * np.sin(from_it)), np.sum(about * np.abs(np.sin(from_it)))
    asymmetry = given / both if both > 0 else 0.0
    is_jump = bool(np.count_nonzero(samples.angles == at) > 1)
    return _Found(dead_centre, peak, float(asymmetry), is_jump)


def _dead_centre_by(peak: float) -> float:
    """Give the dead centre by the peak: full turns of the file's angle first, else half ones."""
    for half_turns in (2, 1):
        nearest = float(np.rint(peak / (half_turns * np.pi)) * half_turns * np.pi)
        if abs(peak - nearest) <= _NEAR:
            return nearest
    allowed = _("the pressure peaks at the file's {angle}, far from any dead centre if its zero is at one")
    repair = _('write firing_angle = "… deg", the file\'s angle of the firing dead centre')
    raise InputError([Problem("firing_angle", None, allowed.format(angle=_degrees(peak)), repair)])


def _widths(angles: Array, cycle: float) -> Array:
    """How much of the cycle each sample stands for. [rad]"""
    steps = np.diff(angles, append=angles[0] + cycle)
    return (steps + np.roll(steps, 1)) / 2


def _findings(own: _Found, count: float, is_backward: bool, sense: Sense, is_given: bool) -> Iterator[Words]:
    """Say where firing stands in the file, and how the sense was taken."""
    place = _("The firing dead centre is at the file's {angle}, by the peak {peak} after it.")
    if is_given:
        place = _("The firing dead centre is at the file's {angle}, as given; the peak stands {peak} after it.")
    elif own.peak < 0:
        place = _("The firing dead centre is at the file's {angle}, by the peak {peak} before it.")
    yield place.format(angle=_degrees(count), peak=_degrees(abs(own.peak) if not is_given else own.peak))
    if is_backward and sense == "found":
        yield _("The file's angles count against the rotation, as the gas would take work: they are turned round.")
    elif is_backward:
        yield _("The file's angles are turned round, as given.")
    if own.is_motored:
        yield _("Nothing burns in this cycle: it is motored, and its sense cannot be told from it.")


def _flags(own: _Found, *, is_backward: bool) -> tuple[Words, ...]:
    """Flag the sense and the dead centre where the pressures say otherwise."""
    peak = _degrees(own.peak)
    if own.asymmetry < -_MOTORED:
        counted = _(
            "Counted like this, the gas takes work and peaks at {peak} from firing: if the file's angles count against"
            ' the rotation, write sense = "backward", or "found".'
        )
        if is_backward:
            counted = _(
                "Turned round, the gas takes work and peaks at {peak} from firing: if the file's angles count with the"
                " rotation, leave sense out."
            )
        return (counted.format(peak=peak),)
    if own.is_motored:
        misplaced = _(
            "Motored, a cycle peaks up to 2° before the dead centre, and this one at {peak}: is the zero right?"
        )
        return () if own.peak <= 0 else (misplaced.format(peak=peak),)
    late = _("The peak stands {peak} after the firing dead centre; 5° to 20° are usual: is the zero right?")
    is_usual = own.is_jump or _EARLIEST <= own.peak <= _LATEST
    return () if is_usual else (late.format(peak=peak),)


def _degrees(angle: float) -> str:
    """Write an angle in degrees; no −0."""
    return f"{shown(angle, 'deg') + 0.0:.6g}°"
