"""Work and power of the loads of a machine file."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.load_laws import ByTravel
from cranktrain.layout.load_stretch import stretch_flags
from cranktrain.layout.loads import LinkLoad, Loads
from cranktrain.layout.shaft_loads import LoadsOnShafts, TorqueOnShaft
from cranktrain.motion import Array
from cranktrain.numerics import Peak, points_together
from cranktrain.questions.forces.events import ForceEvents, with_rows
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.peaks import largest_of_machine, one_sided
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.questions.gas.declared import DeclaredGas
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import Flagged

_LOAD = ("load",)
_CURVE = ("load", "crank_angle")
_WIDEST = np.pi / 9
"""Of a piece of the quadrature. [rad]"""
_ROUNDING = 1e-12
"""Of what a load does there and back; a work of less is none."""


@record
class LoadWork(Flagged):
    """What the loads do: less than 0 where the machine works against them; n_on_links are first, then on_shafts.

    speed is the declared one, shape (design,). [rad/s]
    """

    n_on_links: int
    on_shafts: tuple[TorqueOnShaft, ...]
    speed: Array
    load_torque_on_crank: Array = quantity(
        "Q_l", "N*m", _CURVE, N_("Torque of the load on the crank, by virtual work"), _THEORY, "13.52"
    )
    load_power: Array = quantity(
        "P_l", "W", _CURVE, N_("Power of the load; less than 0 where it takes it"), _THEORY, "13.52"
    )
    load_work: Array = quantity(
        "W_l", "J", _LOAD, N_("Work of the load over a cycle, by exact quadrature"), _THEORY, "13.52"
    )
    mean_load_power: Array = quantity(
        "P_l,m", "W", _LOAD, N_("Mean power of the load over the cycle"), _THEORY, "13.52"
    )
    largest_load_power: Peak = extreme(
        "P_l,max",
        "W",
        _LOAD,
        N_("Largest power of the load, of either sign"),
        N_("Crank angle of that power"),
        _THEORY,
        "13.52",
        worst="largest",
        of="load_power",
    )
    largest_load_force: Peak = extreme(
        "F_l,max",
        "N",
        _LOAD,
        N_("Largest size of a load that is a force"),
        N_("Crank angle of that force"),
        _THEORY,
        "definition",
        worst="largest",
    )
    largest_load_moment: Peak = extreme(
        "C_l,max",
        "N*m",
        _LOAD,
        N_("Largest size of a load that is a torque"),
        N_("Crank angle of that torque"),
        _THEORY,
        "definition",
        worst="largest",
    )


def are_asked_for(loads: Loads | None, on_shafts: LoadsOnShafts | None, gas: DeclaredGas | None) -> bool | str:
    """Whether there are loads, or may be missed: an engine or compressor works against its gas."""
    if loads is not None or (on_shafts is not None and on_shafts.given):
        return True
    return Loads.needs if gas is None else False


def load_work(
    loaded: LoadedMachine,
    solved: SolvedCycle,
    loads: Loads | None,
    on_shafts: LoadsOnShafts | None,
    events: ForceEvents,
    crank_angle: CrankAngle,
) -> LoadWork:
    """Power over the cycle, and work by quadrature between the events of the loads.

    Notes
    -----
    Q = F u′ of a force along its way u, or of a torque along its link's angle. docs/theory/forces, eq. (13.6).
    """
    links, shafts = () if loads is None else loads.each, () if on_shafts is None else on_shafts.given

    acting = partial(_acting, loaded, links, shafts, crank_angle)

    def size_of_power(angle: Array) -> Array:
        return np.abs(acting(angle)[0] * loaded.speed.drive(angle).speed)

    def size(angle: Array) -> Array:
        return np.abs(acting(angle)[1])

    grid = crank_angle.angle
    closes = _closes(loaded, solved)
    # A shaft's own torque would go on where the machine does not get to.
    torque, sizes = (np.where(closes, part, np.nan) for part in acting(grid))
    power = torque * loaded.speed.drive(grid).speed
    whole = with_rows(events, [load.law for load in shafts], crank_angle)
    work = np.where(np.all(closes, axis=-1), _works(lambda angle: acting(angle)[0], whole, crank_angle), np.nan)
    most = largest_of_machine(size_of_power, np.abs(power), whole, crank_angle)
    largest = largest_of_machine(size, np.abs(sizes), whole, crank_angle)
    is_torque = np.array([*(load.is_torque for load in links), *(True for _load in shafts)])
    names = (*(load.name for load in links), *(load.name for load in shafts))
    return LoadWork(
        n_on_links=len(links),
        on_shafts=shafts,
        speed=loaded.speed.mean[:, 0, 0],
        load_torque_on_crank=torque,
        load_power=power,
        load_work=work,
        mean_load_power=work * loaded.speed.mean[..., 0] / crank_angle.cycle,
        largest_load_power=most,
        largest_load_force=_known(largest, ~is_torque),
        largest_load_moment=_known(largest, is_torque),
        labels={"load": names},
        flags=(
            *stretch_flags({load.name: load.stretch for load in links if load.stretch is not None}),
            *one_sided([(_("largest power"), most), (_("largest size"), largest)], names),
        ),
        unlikely=tuple(_acting_nowhere(links, largest)),
    )


def _acting_nowhere(links: Sequence[LinkLoad], largest: Peak) -> Iterator[Words]:
    """Say of which loads the machine meets nothing, although their lists have something."""
    for place, load in enumerate(links):
        is_listed = isinstance(load.law, ByTravel) and load.law.most > 0
        if is_listed and np.any(largest.value[:, place] == 0):
            yield _(
                "{load} acts nowhere: over the travel of what it acts on its list has 0 alone. Are the unit of the"
                " travel, and where it counts from, right?",
                load=load.name,
            )


def _closes(loaded: LoadedMachine, solved: SolvedCycle) -> NDArray[np.bool_]:
    """Where on the grid the links of all mechanisms close, shape (design, 1, n)."""
    found = np.ones((1, 1, 1), dtype=np.bool_)
    for batch, one in zip(loaded.mechanisms.batches, solved.batches, strict=True):
        shape = one.forces.driving_torque.shape
        for link in batch.kind.dynamics.links(one.motion, batch.members.geometry):
            for series in (link.origin.x, link.origin.y, link.angle):
                each = np.broadcast_to(np.isfinite(series.first), shape)
                found = found & np.all(each, axis=1, keepdims=True)
    return found


def _acting(
    loaded: LoadedMachine,
    links: Sequence[LinkLoad],
    shafts: Sequence[TorqueOnShaft],
    crank_angle: CrankAngle,
    angle: Array,
) -> tuple[Array, Array]:
    """Torque on the crank [N·m] and size [N or N·m] of every load at φ, each of shape (design, load, n)."""
    own = angle if angle.ndim == 3 else angle[np.newaxis, np.newaxis]
    speed = loaded.speed.drive(own).speed
    ways = loaded.load_ways(links, own)
    sizes = [loaded.load_value(load, way, own, speed) for load, way in zip(links, ways, strict=True)]
    on_crank = [size * way.rate for size, way in zip(sizes, ways, strict=True)]
    at_shafts = [load.value(own - crank_angle.zero, speed) for load in shafts]
    return np.concatenate([*on_crank, *at_shafts], axis=1), np.concatenate([*sizes, *at_shafts], axis=1)


def _known(peak: Peak, is_one: NDArray[np.bool_]) -> Peak:
    """Peaks of those that are of a sort; of the others there is none."""
    value, angle = (np.where(is_one, part, np.nan) for part in (peak.value, peak.angle))
    return Peak(angle, value, np.where(is_one, peak.side, 0.0))


def _works(on_crank: Callable[[Array], Array], events: ForceEvents, crank_angle: CrankAngle) -> Array:
    """Work of every load over a cycle, shape (design, load). [J]"""
    angle, weight = points_together(events.whole - crank_angle.zero[:, 0], _WIDEST, crank_angle.cycle)
    done = on_crank(angle + crank_angle.zero) * weight
    work, gross = np.sum(done, axis=-1), np.sum(np.abs(done), axis=-1)
    return np.where(np.abs(work) <= _ROUNDING * gross, 0.0, work)
