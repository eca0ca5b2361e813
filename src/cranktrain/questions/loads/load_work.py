"""Work and power of the loads of a machine file."""

from collections.abc import Callable

import numpy as np

from cranktrain.catalogue import extreme, quantity
from cranktrain.checks import StageResult
from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.load_laws import ByAngle
from cranktrain.layout.loads import LinkLoad, Loads
from cranktrain.layout.shaft_loads import ShaftLoads
from cranktrain.motion import Array
from cranktrain.numerics import Peak, subintervals
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.peaks import largest_of_machine, one_sided
from cranktrain.questions.gas.declared import DeclaredGas
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.wording import Names, shared

_LOAD = ("load",)
_CURVE = ("load", "crank_angle")
_WIDEST = np.pi / 9
"""Of a piece of the quadrature. [rad]"""


@record
class LoadWork(StageResult):
    """What the loads do: less than 0 where the machine works against them; n_on_links are first, on the mechanisms."""

    n_on_links: int
    load_torque_on_crank: Array = quantity(
        "Q_l", "N*m", _CURVE, N_("Torque of the load on the crank, by virtual work"), _THEORY
    )
    load_power: Array = quantity("P_l", "W", _CURVE, N_("Power of the load; less than 0 where it takes it"), _THEORY)
    load_work: Array = quantity("W_l", "J", _LOAD, N_("Work of the load over a cycle, by exact quadrature"), _THEORY)
    largest_load_power: Peak = extreme(
        "P_l,max", "W", _LOAD, N_("Largest power of the load, of either sign"), N_("Crank angle of that power"), _THEORY
    )

    def answer(self, names: Names, design: int) -> str:
        """Say the work of a cycle and the largest power."""
        works = shared(names["load"], self.load_work[design], "J")
        most = shared(names["load"], self.largest_load_power.value[design], "kW")
        return _("Work of the loads in a cycle {works}; largest power {most}.").format(works=works, most=most)


def are_asked_for(loads: Loads | None, on_shafts: ShaftLoads | None, gas: DeclaredGas | None) -> bool | str:
    """Whether there are loads, or may be missed: an engine or compressor works against its gas."""
    if loads is not None or (on_shafts is not None and on_shafts.given):
        return True
    return Loads.needs if gas is None else False


def load_work(
    loaded: LoadedMachine,
    loads: Loads | None,
    on_shafts: ShaftLoads | None,
    events: ForceEvents,
    crank_angle: CrankAngle,
) -> LoadWork:
    """Power over the cycle, and work by quadrature between the events of the loads.

    Notes
    -----
    Q = F u′ of a force along its way u, or of a torque along its link's angle. docs/theory/forces, eq. (13.6).
    """
    links, shafts = () if loads is None else loads.each, () if on_shafts is None else on_shafts.given

    def on_crank(angle: Array) -> Array:
        own = angle if angle.ndim == 3 else angle[np.newaxis, np.newaxis]
        speed = loaded.speed.drive(own).speed
        at_shafts = (load.value(own - crank_angle.zero, speed) for load in shafts)
        return np.concatenate([*(_on_crank(loaded, load, own, speed) for load in links), *at_shafts], axis=1)

    def size_of_power(angle: Array) -> Array:
        return np.abs(on_crank(angle) * loaded.speed.drive(angle).speed)

    grid = crank_angle.angle
    torque = on_crank(grid)
    power = torque * loaded.speed.drive(grid).speed
    corners = (load.law.kinks(crank_angle.cycle) for load in shafts if isinstance(load.law, ByAngle))
    at_shafts = [own + crank_angle.zero[:, 0] for own in corners]
    whole = ForceEvents(events.angle, np.concatenate([events.whole, *at_shafts], axis=-1))
    most = largest_of_machine(size_of_power, np.abs(power), whole, crank_angle)
    names = (*(load.name for load in links), *(load.name for load in shafts))
    return LoadWork(
        n_on_links=len(links),
        load_torque_on_crank=torque,
        load_power=power,
        load_work=_works(on_crank, whole, crank_angle),
        largest_load_power=most,
        labels={"load": names},
        flags=tuple(one_sided([(_("largest power"), most)], names)),
    )


def _on_crank(loaded: LoadedMachine, load: LinkLoad, angle: Array, speed: Array) -> Array:
    """Torque of one load on the crank at φ and its speed, shape (design, 1, n). [N·m]"""
    way = loaded.load_way(load, angle)
    return loaded.load_value(load, way, angle, speed) * way.rate


def _works(on_crank: Callable[[Array], Array], events: ForceEvents, crank_angle: CrankAngle) -> Array:
    """Work of every load over a cycle, shape (design, load). [J]"""
    breaks = events.whole - crank_angle.zero[:, 0]
    cuts = [subintervals(own, _WIDEST, crank_angle.cycle) for own in breaks]
    longest = max(cut.angle.size for cut in cuts)
    angle, weight = np.zeros((2, len(cuts), 1, longest))
    for design, cut in enumerate(cuts):
        angle[design, 0, : cut.angle.size], weight[design, 0, : cut.angle.size] = cut.angle, cut.weight
    return np.sum(on_crank(angle + crank_angle.zero) * weight, axis=-1)
