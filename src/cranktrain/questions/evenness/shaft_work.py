"""Work that the torque of a machine stores within a cycle."""

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.numerics.periodic import PeriodicCurve, fourier_curve
from cranktrain.questions.evenness.applied_torque import AppliedTorque
from cranktrain.questions.evenness.between_events import applied_work, nodes_at, work_of_loads
from cranktrain.questions.evenness.excess_work import ExcessWork, excess_against, excess_of
from cranktrain.questions.evenness.load_torque import LoadTorque
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.mechanism_torques import MechanismTorques
from cranktrain.questions.torque.sources import TorqueSources
from cranktrain.record import record
from cranktrain.references import THEORY_OF_EVENNESS as _THEORY
from cranktrain.wording import Names, number


@record
class ShaftWork:
    """Work of the torque without inertia, less that of the loads on the shaft.

    Attributes
    ----------
    excess : ExcessWork
        Its curve from the first point of the grid. [rad, J]
    inertia : PeriodicCurve
        J of the moving parts. [kg·m²]
    """

    excess: ExcessWork
    inertia: PeriodicCurve
    excess_work: Array = quantity(
        "A", "J", ("crank_angle",), N_("Work of that torque, less that of loads on the shaft, less its mean"), _THEORY
    )
    largest_excess_work: Array = quantity(
        "ΔA", "J", (), N_("Largest excess work: from the least to the most that is stored within a cycle"), _THEORY
    )

    def answer(self, _names: Names, design: int) -> str:
        """Say the largest excess work."""
        return _("Largest excess work {work} within a cycle.").format(
            work=number(float(self.largest_excess_work[design]), "J")
        )


def shaft_work(
    applied: AppliedTorque,
    sources: TorqueSources,
    given: LoadTorque | None,
    events: ForceEvents,
    torques: MechanismTorques,
    speed: Speed,
    crank_angle: CrankAngle,
) -> ShaftWork:
    """Work of what drives the shaft less what its loads take, over the cycle.

    Notes
    -----
    By quadrature between events, with a node at each; by Fourier series where there is none.
    docs/theory/evenness, eqs. (17.2) and (17.17).
    """
    mean, taken = np.sum(sources.mean(crank_angle.cycle), axis=-1), None if given is None else given.work
    if applied.is_smooth and taken is None:
        work = fourier_curve(sources.applied_work(crank_angle.shown, crank_angle.cycle), crank_angle.cycle)
        inertia = fourier_curve(torques.reduced_inertia, crank_angle.cycle)
    else:
        corners = () if given is None else given.corners
        nodes = nodes_at(np.concatenate([events.whole - crank_angle.zero[:, 0], *corners], axis=-1), crank_angle)
        work, inertia = applied_work(nodes, sources, torques, speed, crank_angle)
        taken = None if taken is None else work_of_loads(nodes, taken)
    excess = excess_of(work, mean)
    if given is not None:
        excess = excess_against(excess, taken, given.mean)
    return ShaftWork(
        excess=excess,
        inertia=inertia,
        excess_work=excess.work.samples,
        largest_excess_work=excess.difference,
    )
