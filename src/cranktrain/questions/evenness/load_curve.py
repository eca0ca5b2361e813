"""The load that a machine file gives as a curve: its torque on the shaft, its scale, and what is left to balance."""

from collections.abc import Iterator

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.checks import StageResult
from cranktrain.errors import InputError, Problem
from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.motion import Array
from cranktrain.numerics.periodic import PeriodicCurve, side_by_side
from cranktrain.numerics.polyline import polyline_integral, polyline_mean, polyline_value
from cranktrain.questions.evenness.applied_torque import AppliedTorque
from cranktrain.questions.evenness.spec import LoadCurve, ShaftLoad
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.questions.torque.sources import TorqueSources
from cranktrain.record import record
from cranktrain.references import THEORY_OF_EVENNESS as _THEORY
from cranktrain.wording import Names, number

_NOTHING = 1e-9
"""A mean torque below this part of the peak is none."""


@record
class LoadTorque(StageResult):
    """Torque of the load that is given as a curve.

    Attributes
    ----------
    work : PeriodicCurve
        Of the file's curve less its mean, from the first point of the grid, exact, shape (n,), or (design, n) of
        several. [J]
    mean : Array, shape (design,)
        Of the load. [N·m]
    balance : "factor", "constant", "quadratic" or "motor"
        What balances the mean torque of machine and curve.
    """

    work: PeriodicCurve
    mean: Array
    balance: str
    load_torque: Array = quantity(
        "M_r",
        "N*m",
        ("crank_angle",),
        N_("Torque of the load that is given as a curve, positive where it resists"),
        _THEORY,
    )
    load_factor: Array = quantity(
        "c_r", "1", (), N_("What the torques of the given load curve are multiplied by"), _THEORY
    )
    largest_load_torque: Array = quantity("M_r,max", "N*m", (), N_("Largest torque of the given load"), _THEORY)
    remaining_torque: Array = quantity(
        "M_0",
        "N*m",
        (),
        N_("Mean of the machine's torque that the load curve leaves; less than 0 where the shaft is driven besides"),
        _THEORY,
    )

    def answer(self, _names: Names, design: int) -> str:
        """Say the load's mean and peak, and its factor or what balances the rest."""
        factor, largest = float(self.load_factor[design]), float(self.largest_load_torque[design])
        if not np.isfinite(factor):
            return ""
        peak = number(largest, "N*m")
        mean = number(float(self.mean[design]), "N*m")
        if self.balance == "factor":
            return _(
                "The given load curve times {factor} takes the machine's mean torque {mean}, at most {peak}."
            ).format(factor=f"{factor:.5g}", mean=mean, peak=peak)
        said = _("The given load takes {mean} on the mean, at most {peak}.").format(mean=mean, peak=peak)
        rest = float(self.remaining_torque[design])
        if self.balance == "motor" or abs(rest) <= _NOTHING * abs(largest):
            return said
        if rest < 0:
            left = _("A constant torque of {rest} drives the shaft besides.")
        elif self.balance == "quadratic":
            left = _("The rest, {rest} on the mean, goes into a load that rises with the speed squared.")
        else:
            left = _("The rest goes into a constant load of {rest}.")
        return f"{said} {left.format(rest=number(abs(rest), 'N*m'))}"


def load_torque(
    curve: LoadCurve,
    load: ShaftLoad,
    applied: AppliedTorque,
    sources: TorqueSources,
    torques: MechanismTorques,
    crank_angle: CrankAngle,
) -> LoadTorque:
    """Load torque on the grid and its exact work, as given or scaled to the machine's mean.

    Notes
    -----
    docs/theory/evenness, eqs. (17.17) and (17.18).
    """
    if any(polyline.period > crank_angle.cycle * 1.5 for polyline in curve.polylines):
        allowed = _("goes on over two turns, and the cycle of this machine is one")
        raise InputError([Problem("evenness.load_curve.file", None, allowed)])
    own = np.array([polyline_mean(polyline) for polyline in curve.polylines])
    mean = np.sum(sources.mean(crank_angle.cycle), axis=-1)
    factor = np.ones_like(mean)
    if curve.is_scaled:
        # A machine that nothing but inertia acts on has a mean torque of rounding.
        peak = np.maximum(np.abs(applied.applied_torque), np.abs(torques.driving_torque))
        gives_work = mean > _NOTHING * np.max(peak, axis=-1)
        factor = np.where(gives_work, mean / own, np.nan)
    samples = np.stack([polyline_value(polyline, crank_angle.shown) for polyline in curve.polylines])
    works = [polyline_integral(polyline, samples.shape[-1], crank_angle.cycle) for polyline in curve.polylines]
    return LoadTorque(
        work=side_by_side(works),
        mean=factor * own,
        balance=_balance(curve, load),
        load_torque=factor[:, np.newaxis] * samples,
        load_factor=factor,
        largest_load_torque=factor * np.array([np.max(polyline.values) for polyline in curve.polylines]),
        remaining_torque=mean - factor * own,
        flags=tuple(_flags(factor, applied.applied_torque)),
    )


def _balance(curve: LoadCurve, load: ShaftLoad) -> str:
    """What balances the mean torque that the curve leaves."""
    if load.motor is not None:
        return "motor"
    return "factor" if curve.is_scaled else "quadratic" if load.is_quadratic else "constant"


def _flags(factor: Array, applied: Array) -> Iterator[str]:
    """Flag a machine to which no load can be scaled."""
    if np.any(np.isnan(factor) & np.all(np.isfinite(applied), axis=-1)):
        yield _(
            'No steady running: a load curve with scale = "balanced" is for a machine that gives work;'
            ' "given" takes the torques as they are.'
        )
