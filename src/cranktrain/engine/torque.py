"""Torque of a whole machine: on each shaft, through the gear between shafts, and gathered along each shaft."""

from collections.abc import Mapping
from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from cranktrain.catalogue import quantity
from cranktrain.engine.force_events import ForceEvents
from cranktrain.engine.force_peaks import extremes_of_machine, largest_of_machine, one_sided
from cranktrain.engine.forces import LoadedMachine, SolvedCycle, driving_torques
from cranktrain.engine.layout import CrankAngle
from cranktrain.engine.shafts import GearedShafts, Shafts
from cranktrain.engine.torque_sources import TorqueSources
from cranktrain.language import N_, _
from cranktrain.loads import torque as along_shaft
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.wording import Names, number

_SHAFT = ("shaft",)
_THEORY = "docs/theory/forces"
_ROUNDING = 1e-12
"""Torques smaller than this part of the peak may be of either sign."""
_NOTHING = 1e-9
"""A mean torque below this part of the peak is none: a machine without gas gives no work."""


@record
class ShaftTorques:
    """Torque of the machine on its shafts, by the reactions: positive in each shaft's own running sense."""

    shaft_torque: Array = quantity(
        "T", "N*m", ("shaft", "crank_angle"), N_("Torque of the machine on the shaft, in its sense of running"), _THEORY
    )
    machine_torque: Array = quantity(
        "T_Σ", "N*m", ("crank_angle",), N_("Torque of the machine on all shafts together, at the main shaft"), _THEORY
    )
    mean_torque: Array = quantity("T_m", "N*m", (), N_("Mean torque of the machine over a cycle"), _THEORY)
    largest_torque: Array = quantity("T_max", "N*m", (), N_("Largest torque of the machine"), _THEORY)
    largest_torque_at: Array = quantity("φ(T_max)", "deg", (), N_("Crank angle of the largest torque"), _THEORY)
    smallest_torque: Array = quantity("T_min", "N*m", (), N_("Smallest torque of the machine"), _THEORY)
    smallest_torque_at: Array = quantity("φ(T_min)", "deg", (), N_("Crank angle of the smallest torque"), _THEORY)
    labels: Mapping[str, tuple[str, ...]] = field(default_factory=lambda: {"shaft": ()})
    flags: tuple[str, ...] = ()

    def answer(self, names: Names, design: int) -> str:
        """Say mean, largest and smallest torque."""
        del names
        return _("Torque on the shaft: mean {mean}, from {least} at {low} to {most} at {high}.").format(
            mean=number(float(self.mean_torque[design]), "N*m"),
            least=number(float(self.smallest_torque[design]), "N*m"),
            low=number(float(self.smallest_torque_at[design]), "deg"),
            most=number(float(self.largest_torque[design]), "N*m"),
            high=number(float(self.largest_torque_at[design]), "deg"),
        )


def shaft_torques(
    loaded: LoadedMachine,
    solved: SolvedCycle,
    shafts: Shafts,
    crank_angle: CrankAngle,
    events: ForceEvents,
    sources: TorqueSources,
) -> ShaftTorques:
    """Torque on every shaft over the cycle, its mean by quadrature, and extremes refined on the mechanisms.

    Notes
    -----
    A mechanism's crank angle counts in its own shaft's sense and all shafts turn alike fast, so the torques of all
    simply add up to what the main shaft feels. docs/theory/forces, eq. (13.38).
    """
    by_mechanism = -driving_torques(loaded, solved.groups)
    by_shaft = along_shaft.throw_torque(by_mechanism, shafts.shaft, len(shafts.names))
    whole = np.sum(by_shaft, axis=1)

    def torque(angle: Array) -> Array:
        return -np.sum(driving_torques(loaded, loaded.solved(angle)), axis=1, keepdims=True)

    mean = np.sum(sources.mean(crank_angle.cycle), axis=-1)
    least, most = extremes_of_machine(torque, whole[:, np.newaxis], events, crank_angle)
    return ShaftTorques(
        shaft_torque=by_shaft,
        machine_torque=whole,
        mean_torque=np.where(np.abs(mean) <= _ROUNDING * np.max(np.abs(whole), axis=-1), 0.0, mean),
        largest_torque=most.value[:, 0],
        largest_torque_at=most.angle[:, 0],
        smallest_torque=least.value[:, 0],
        smallest_torque_at=least.angle[:, 0],
        labels={"shaft": shafts.names},
        flags=tuple(one_sided([(_("largest torque"), most), (_("smallest torque"), least)])),
    )


@record
class JournalTorques:
    """Torque that each main journal passes on toward the flywheel, gathered from the free end."""

    journal_torque: Array = quantity(
        "T_J", "N*m", ("journal", "crank_angle"), N_("Torque that the main journal passes on to the flywheel"), _THEORY
    )
    largest_journal_torque: Array = quantity(
        "T_J,max", "N*m", ("journal",), N_("Largest torque in the journal, of either sense"), _THEORY
    )
    largest_journal_torque_at: Array = quantity(
        "φ(T_J,max)", "deg", ("journal",), N_("Crank angle of the largest torque in the journal"), _THEORY
    )
    labels: Mapping[str, tuple[str, ...]] = field(default_factory=lambda: {"journal": ()})


def journal_torques(
    loaded: LoadedMachine, solved: SolvedCycle, shafts: Shafts, events: ForceEvents, crank_angle: CrankAngle
) -> JournalTorques:
    """Torque along every shaft: journal 1 stands before throw 1 and passes nothing, the last one passes all.

    What a gear takes or brings is reckoned at the flywheel's end. docs/theory/harmonics-and-orders, eq. (15.13).
    """
    passed = _passed(driving_torques(loaded, solved.groups), shafts)

    def size(angle: Array) -> Array:
        return np.abs(_passed(driving_torques(loaded, loaded.solved(angle)), shafts))

    largest = largest_of_machine(size, np.abs(passed), events, crank_angle)
    return JournalTorques(passed, largest.value, largest.angle, {"journal": shafts.journals})


def _passed(driving: Array, shafts: Shafts) -> Array:
    """Torque that every journal passes on, from what must drive each mechanism, shape (design, journal, n)."""
    rows: list[Array] = []
    for shaft, n_throws in enumerate(shafts.n_throws):
        own = shafts.shaft == shaft
        by_throw = along_shaft.throw_torque(-driving[:, own], shafts.throw[own], n_throws)
        rows.append(along_shaft.journal_torque(by_throw))
    return np.concatenate(rows, axis=1)


@record
class GearTorques:
    """What the gear passes from every other shaft to the main one, and each shaft's share of the work."""

    gear_torque: Array = quantity(
        "T_g",
        "N*m",
        ("shaft", "crank_angle"),
        N_("Torque that the gear passes from the shaft to the main one"),
        _THEORY,
    )
    gear_reversals: Array = quantity(
        "n_r", "1", _SHAFT, N_("How often the gear's torque changes its sign over a cycle"), _THEORY
    )
    work_share: Array = quantity("W/W_Σ", "1", _SHAFT, N_("Share of the shaft in the work of all"), _THEORY)

    def answer(self, names: Names, design: int) -> str:
        """Say what the gear passes, how often it reverses, and who does the work."""
        said = [
            _("{shaft} passes {least} to {most} to the main shaft, reversing {n} times a cycle").format(
                shaft=shaft,
                least=number(float(np.min(self.gear_torque[design, i])), "N*m"),
                most=number(float(np.max(self.gear_torque[design, i])), "N*m"),
                n=f"{self.gear_reversals[design, i]:.0f}",
            )
            for i, shaft in enumerate(names["shaft"])
            if not np.isnan(self.gear_reversals[design, i])
        ]
        share = self.work_share[design]
        if np.any(np.isnan(share)):
            return _("Gear: {shafts}.").format(shafts="; ".join(said))
        return _("Gear: {shafts}. Shares of the work: {shares}.").format(
            shafts="; ".join(said),
            shares=", ".join(
                f"{number(float(part), '%')} ({name})" for part, name in zip(share, names["shaft"], strict=True)
            ),
        )


def gear_torques(
    geared: GearedShafts, torques: ShaftTorques, sources: TorqueSources, crank_angle: CrankAngle
) -> GearTorques:
    """What an ideal gear passes from each shaft to the main one; NaN for that one itself.

    At constant speed a balanced shaft takes nothing for itself: the gear passes all. Work shares are NaN where the
    machine does no work. docs/theory/forces, eq. (13.39).
    """
    other = np.arange(len(geared.shafts.names)) != geared.shafts.main
    passed = np.where(other[:, np.newaxis], torques.shaft_torque, np.nan)
    mean = sources.mean(crank_angle.cycle)
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
    felt = np.abs(known) > _ROUNDING * np.max(np.abs(known), axis=-1, keepdims=True)
    sign = np.where(felt, np.sign(known), 0.0)
    place: NDArray[np.intp] = np.where(sign == 0, 0, np.arange(1, curve.shape[-1] + 1, dtype=np.intp))
    last: NDArray[np.intp] = np.maximum.accumulate(place, axis=-1)
    # What stands before the first sign is the last one of the cycle before.
    last = np.where(last == 0, last[..., -1:], last)
    held: Array = np.take_along_axis(sign, np.maximum(last - 1, 0), axis=-1)
    return np.sum(held != np.roll(held, 1, axis=-1), axis=-1).astype(np.float64)
