"""Work of the torque over a cycle against the work of the gas."""

import numpy as np

from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.motion import Array
from cranktrain.questions.forces.forces_times_arms import ForcesTimesArms
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.questions.loads.load_work import LoadWork
from cranktrain.questions.torque.sources import TorqueSources
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Check, Checked

_LIMIT = 1e-12
_FAR = 1e-3
"""Of forces times the places where they act: 10⁻¹⁵ of those, a few times what rounding is, are within the limit."""
_SHARE = 0.1
"""Of forces times arms, for 1 rad: work that is less is judged by these; an engine's gas does more."""


@record
class WorkBalance(Checked):
    """Work of the gas over a cycle, without any step of the grid, and whether the torque does it."""

    gas_work: Array = quantity(
        "W",
        "J",
        (),
        N_("Work of the gas in all chambers over a cycle, in closed form or by exact quadrature"),
        _THEORY,
        "13.40",
    )


@record
class LoadBalance(Checked):
    """Whether the torque does the work of gas and loads."""


def load_balance(
    loaded: LoadedMachine,
    times_arms: ForcesTimesArms,
    loads: LoadWork,
    pressures: GasPressures | None,
    sources: TorqueSources,
    crank_angle: CrankAngle,
) -> LoadBalance:
    """Work of the torque by the reactions against that of loads and gas; with friction there is no check."""
    if loaded.masses.has_friction or loads.n_on_links == 0:
        return LoadBalance()
    works = loads.load_work[:, : loads.n_on_links]
    if pressures is not None:
        works = np.concatenate([works, pressures.work_over(crank_angle)], axis=-1)
    sentence = _("Work of the torque by the reactions, by quadrature, against that of loads and gas")
    residual, reasons = loaded.judged(_apart(works, times_arms, sources))
    return LoadBalance(checks=(Check("load_work", sentence, residual, _LIMIT, reasons),))


def _apart(works: Array, times_arms: ForcesTimesArms, sources: TorqueSources) -> Array:
    """By how much the torque's work is off those of what acts, in parts of their size, shape (design,).

    What inertia takes at a moment of acceleration, the shaft does not get.
    """
    done = np.sum(sources.mean, axis=-1) * sources.cycle + sources.spent
    return np.abs(done - works.sum(axis=-1)) / _work_size(works, times_arms)


def _work_size(works: Array, times_arms: ForcesTimesArms) -> Array:
    """What works are to be compared with, shape (design,). [J]

    They may be none, and what works on the shaft may cancel: that leaves rounding of forces times arms. Where links are
    far longer than the stroke their places are rounded, and the way that is left of them.
    """
    on_the_way = times_arms.value.sum(axis=1)
    there = np.sum(times_arms.force * times_arms.reach, axis=1)
    size = np.maximum(np.sum(np.abs(works), axis=-1), np.maximum(_SHARE * on_the_way, _FAR * there))
    return np.where(size > 0, size, 1.0)


def work_balance(
    loaded: LoadedMachine,
    times_arms: ForcesTimesArms,
    pressures: GasPressures,
    sources: TorqueSources,
    crank_angle: CrankAngle,
) -> WorkBalance:
    """Work of gas and torque; with friction in the guides, which takes some, there is no check.

    At one moment's angular acceleration ε the torque also gives the inertia ∮Jε dφ.

    Notes
    -----
    docs/theory/forces, eq. (13.40).
    """
    total = pressures.indicated_work.sum(axis=-1)
    if loaded.jumps:
        return WorkBalance(total)
    sentence = _("Work of the torque by the reactions, by quadrature, against that of the gas")
    works = pressures.work_over(crank_angle)
    residual, reasons = loaded.judged(_apart(works, times_arms, sources))
    return WorkBalance(total, checks=(Check("work", sentence, residual, _LIMIT, reasons),))
