"""Half-periods of the static torque at the motor: from one change of its sign to the next."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle, within
from cranktrain.layout.drive.declared import DeclaredDrive
from cranktrain.motion import ONE, Array
from cranktrain.numerics import Extreme, largest_between
from cranktrain.questions.reduction.at_angles import reduced_at
from cranktrain.questions.reduction.cycle_pieces import mesh_of
from cranktrain.questions.reduction.gear_train import torque_through
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.questions.reduction.static_torques import ASIDE, sign_changes
from cranktrain.record import record
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import StageResult
from cranktrain.transient.gearing import overall_ratio

_THEORY = "docs/theory/reduced-machine"
_OF_EACH = ("half_period",)


@record
class HalfPeriods(StageResult):
    """Between two changes of sign of the static torque at the motor; in general they are not equal."""

    half_period_start: Array = quantity(
        "φ_h",
        "deg",
        _OF_EACH,
        N_("Crank angle at which the static torque at the motor changes its sign"),
        _THEORY,
        "31.9",
    )
    half_period_length: Array = quantity(
        "Δφ_h",
        "deg",
        _OF_EACH,
        N_("Crank angle over which the static torque at the motor keeps its sign"),
        _THEORY,
        "31.9",
    )
    half_period_work: Array = quantity(
        "W_h", "J", _OF_EACH, N_("Work of the static torque at the motor while it keeps its sign"), _THEORY, "31.12"
    )
    half_period_peak: Extreme = extreme(
        "M_h",
        "N*m",
        _OF_EACH,
        N_("Peak of the static torque at the motor while it keeps its sign"),
        N_("Crank angle of that peak"),
        _THEORY,
        "31.9",
        worst="largest",
    )


class _Halves(NamedTuple):
    """Half-periods of one design, each of shape (half period,); angles as shown. [rad, J, N·m]"""

    start: Array
    length: Array
    work: Array
    peak_at: Array
    peak: Array


def half_periods(drive: DeclaredDrive, machines: ReducedMachines, crank_angle: CrankAngle) -> HalfPeriods:
    """Find where the static torque at the motor changes its sign, and what lies between.

    Notes
    -----
    docs/theory/reduced-machine, eq. (31.9), and what stands below it.
    """
    each = [_halves(drive, machines, crank_angle, design) for design in range(len(machines.each))]
    most = max(len(one.start) for one in each)
    start, length, work, peak_at, peak = np.stack(
        [np.pad(np.stack(one), ((0, 0), (0, most - len(one.start))), constant_values=np.nan) for one in each], axis=1
    )
    return HalfPeriods(
        start, length, work, Extreme(peak_at, peak), labels={"half_period": tuple(str(i + 1) for i in range(most))}
    )


def _halves(drive: DeclaredDrive, machines: ReducedMachines, crank_angle: CrankAngle, design: int) -> _Halves:
    """Half-periods of one design."""
    machine, gearing, cycle = machines.each[design], drive.gearings[design], machines.cycle
    corners = machines.corners[design]
    zero = float(crank_angle.zero[min(design, len(crank_angle.zero) - 1), 0, 0])

    def torque(angle: Array) -> Array:
        still = reduced_at(machine, np.ravel(angle)).by_load(np.zeros(angle.size))
        return torque_through(still, ONE, gearing)[0].reshape(angle.shape)

    crossings = sign_changes(torque, mesh_of(cycle, corners))
    starts = crossings if crossings.size else np.array([zero])
    starts = np.sort(within(starts - zero, cycle, ASIDE)) + zero
    lengths = np.diff(np.append(starts, starts[0] + cycle))
    all_corners = np.concatenate([corners, crossings])

    def after(angle: Array) -> NDArray[np.intp]:
        """Which half-period an angle is in."""
        return np.sum(np.mod(angle - starts[0], cycle)[..., np.newaxis] >= starts[1:] - starts[0], axis=-1)

    mesh = mesh_of(cycle, all_corners)
    of_piece = mesh.of_each(torque(mesh.nodes))
    halves = np.arange(len(starts))
    works = np.array([np.sum(of_piece[after(mesh.start + mesh.width / 2) == half]) for half in halves])

    def heights(which: NDArray[np.intp], shown: Array) -> Array:
        """Torque toward the peak of a half-period, and nothing beyond it."""
        return np.where(after(shown + zero) == which.reshape(-1, 1), np.abs(torque(shown + zero)), 0.0)

    shown = np.broadcast_to(crank_angle.shown, (len(halves), crank_angle.shown.size))
    found = largest_between(heights, crank_angle.shown, heights(halves, shown), all_corners - zero)
    signs = np.where(works < 0, -1.0, 1.0)
    if np.any(np.isnan(works)):  # links that do not close all round: there is no cycle to divide
        starts, lengths = np.full((2, len(starts)), np.nan)
    return _Halves(
        starts - zero, lengths, works * overall_ratio(gearing), within(found.angle, cycle), signs * found.value
    )
