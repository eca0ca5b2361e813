"""Torque of a whole machine: on each shaft, through the gear between shafts, and gathered along each shaft."""

from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.shafts import Shafts
from cranktrain.motion import Array
from cranktrain.numerics import Peak
from cranktrain.numerics.gathering import gathered
from cranktrain.questions.forces.forces_times_arms import ForcesTimesArms
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.peaks import ForcePeaks, one_sided, without_rounding
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.questions.forces.torque_curves import TorqueCurves
from cranktrain.questions.torque.sources import TorqueSources
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.references import THEORY_OF_HARMONICS as _HARMONICS
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import Flagged, StageResult

_SHAFT = ("shaft",)
_ROUNDING = 1e-12
"""Torques smaller than this part of the peak may be of either sign."""
_NOTHING = 1e-9
"""A mean torque below this part of the peak is none: a machine without gas gives no work."""


@record
class ShaftTorques(Flagged):
    """Torque of the machine on its shafts, by the reactions: positive in each shaft's own running sense.

    gross, shape (design,), is what all forces would do by their arms; in_journals, shape (design, journal), the largest
    size of the torque in every journal, refined together with the machine's extremes. [N·m]
    """

    shaft_torque: Array = quantity(
        "T",
        "N*m",
        ("shaft", "crank_angle"),
        N_("Torque of the machine on the shaft, in its sense of running"),
        _THEORY,
        "13.38",
    )
    machine_torque: Array = quantity(
        "T_Σ",
        "N*m",
        ("crank_angle",),
        N_("Torque of the machine on all shafts together, at the main shaft"),
        _THEORY,
        "13.38",
    )
    mean_torque: Array = quantity("T_m", "N*m", (), N_("Mean torque of the machine over a cycle"), _THEORY, "13.38")
    largest_torque: Peak = extreme(
        "T_max",
        "N*m",
        (),
        N_("Largest torque of the machine"),
        N_("Crank angle of the largest torque"),
        _THEORY,
        "13.38",
        of="machine_torque",
    )
    smallest_torque: Peak = extreme(
        "T_min",
        "N*m",
        (),
        N_("Smallest torque of the machine"),
        N_("Crank angle of the smallest torque"),
        _THEORY,
        "13.38",
        of="machine_torque",
    )
    gross: Array = field(kw_only=True)
    in_journals: Peak = field(kw_only=True)

    @property
    def is_none(self) -> NDArray[np.bool_]:
        """Whether it is nothing beside what the forces could do, shape (design,)."""
        size = np.maximum(np.abs(self.largest_torque.value), np.abs(self.smallest_torque.value))
        return np.asarray(size <= _NOTHING * self.gross)


def shaft_torques(
    loaded: LoadedMachine,
    solved: SolvedCycle,
    times_arms: ForcesTimesArms,
    shafts: Shafts,
    crank_angle: CrankAngle,
    sources: TorqueSources,
    curves: TorqueCurves,
    peaks: ForcePeaks,
) -> ShaftTorques:
    """Torque on every shaft over the cycle, its mean by quadrature, and extremes refined on the mechanisms.

    Notes
    -----
    A mechanism's crank angle counts in its own shaft's sense and all shafts turn alike fast, so the torques of all
    simply add up to what the main shaft feels. docs/theory/forces, eq. (13.38).
    """
    by_shaft = gathered(-solved.driving_torque, shafts.shaft, len(shafts.names))
    whole = by_shaft.sum(axis=1)
    mean = np.sum(sources.mean, axis=-1)
    gross = times_arms.value.sum(axis=-1)
    largest, opposite, in_journals = (
        Peak(*(part[:, rows] for part in peaks.of(curves))) for rows in (0, 1, slice(2, None))
    )
    most = without_rounding(largest, gross)
    least = without_rounding(opposite._replace(value=-opposite.value), gross)
    return ShaftTorques(
        gross=gross,
        in_journals=in_journals,
        shaft_torque=by_shaft,
        machine_torque=whole,
        mean_torque=np.where(np.abs(mean) <= _ROUNDING * np.maximum(np.max(np.abs(whole), axis=-1), gross), 0.0, mean),
        largest_torque=most,
        smallest_torque=least,
        labels={"shaft": shafts.names},
        flags=tuple(one_sided([(_("largest torque"), most), (_("smallest torque"), least)])),
    )


@record
class JournalTorques(StageResult):
    """Torque that each main journal passes on toward the flywheel, gathered from the free end."""

    journal_torque: Array = quantity(
        "T_J",
        "N*m",
        ("journal", "crank_angle"),
        N_("Torque that the main journal passes on to the flywheel"),
        _HARMONICS,
        "15.13",
    )
    largest_journal_torque: Peak = extreme(
        "T_J,max",
        "N*m",
        ("journal",),
        N_("Largest torque in the journal, of either sense"),
        N_("Crank angle of the largest torque in the journal"),
        _HARMONICS,
        "15.13",
        worst="largest",
        of="journal_torque",
    )


def journal_torques(shafts: Shafts, curves: TorqueCurves, torques: ShaftTorques) -> JournalTorques:
    """Torque along every shaft: journal 1 stands before throw 1 and passes nothing, the last one passes all.

    What a gear takes or brings is reckoned at the flywheel's end. docs/theory/harmonics-and-orders, eq. (15.13).
    """
    return JournalTorques(curves.passed, torques.in_journals, labels={"journal": shafts.journals})


@record
class GearTorques:
    """What the gear passes from every other shaft to the main one, and each shaft's share of the work."""

    gear_torque: Array = quantity(
        "T_g",
        "N*m",
        ("shaft", "crank_angle"),
        N_("Torque that the gear passes from the shaft to the main one"),
        _THEORY,
        "13.39",
    )
    gear_reversals: Array = quantity(
        "n_r", "1", _SHAFT, N_("How often the gear's torque changes its sign over a cycle"), _THEORY, "definition"
    )
    work_share: Array = quantity("W/W_Σ", "1", _SHAFT, N_("Share of the shaft in the work of all"), _THEORY, "13.54")


def are_geared(shafts: Shafts) -> bool:
    """Whether there is more than one shaft."""
    return len(shafts.names) > 1


def gear_torques(shafts: Shafts, torques: ShaftTorques, sources: TorqueSources, crank_angle: CrankAngle) -> GearTorques:
    """What an ideal gear passes from each shaft to the main one; NaN for that one itself.

    At constant speed a balanced shaft takes nothing for itself: the gear passes all. Work shares are NaN where the
    machine does no work. docs/theory/forces, eq. (13.39).
    """
    other = np.arange(len(shafts.names)) != shafts.main
    passed = np.where(other[:, np.newaxis], torques.shaft_torque, np.nan)
    mean = sources.mean
    total = np.sum(mean, axis=-1, keepdims=True)
    peak = np.max(np.abs(torques.shaft_torque), axis=(1, 2))[:, np.newaxis]
    return GearTorques(
        gear_torque=passed,
        gear_reversals=np.where(other, reversals(torques.shaft_torque), np.nan),
        work_share=np.where(np.abs(total) > _NOTHING * peak, mean / total, np.nan),
    )


def reversals(curve: Array) -> Array:
    """How often a periodic curve, shape (..., n), changes its sign round the cycle.

    Neither a zero between two values of one sign is a change, nor what rounding leaves of it; NaN is passed over.
    """
    known = np.nan_to_num(curve)
    is_clear = np.abs(known) > _ROUNDING * np.max(np.abs(known), axis=-1, keepdims=True)
    sign = np.where(is_clear, np.sign(known), 0.0)
    place: NDArray[np.intp] = np.where(sign == 0, 0, np.arange(1, curve.shape[-1] + 1, dtype=np.intp))
    last: NDArray[np.intp] = np.maximum.accumulate(place, axis=-1)
    # What stands before the first sign is the last one of the cycle before.
    last = np.where(last == 0, last[..., -1:], last)
    held: Array = np.take_along_axis(sign, np.maximum(last - 1, 0), axis=-1)
    return np.sum(held != np.roll(held, 1, axis=-1), axis=-1).astype(np.float64)
