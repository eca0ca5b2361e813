"""Facts of many designs of one machine by the compiled cycle: the same stages, but for those that look at a grid.

What those give, largest torques, pressures, forces, how evenly it runs, is found in the loop; all else the stages of
`run` make of that, on a grid without angles.
"""

import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis.grids import FACTS_STEP
from cranktrain.analysis.outcomes import StageRun
from cranktrain.analysis.parts import designs_of, parts_together
from cranktrain.analysis.stages import homes, lacking, stages_of
from cranktrain.extras import installing, is_there
from cranktrain.language import Words, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.loads import Loads
from cranktrain.layout.masses import Masses
from cranktrain.layout.mechanisms import Mechanisms, Pistons
from cranktrain.layout.question import Parts, Stage
from cranktrain.layout.shaft_loads import LoadsOnShafts
from cranktrain.layout.speed import Speed
from cranktrain.linkage.compile import uncollected
from cranktrain.machine import Machine
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import Extreme, turn_grid
from cranktrain.quantities import shown
from cranktrain.questions.crankshaft.loads.gears import DeclaredGears
from cranktrain.questions.crankshaft.parts import DeclaredCrankshafts
from cranktrain.questions.cylinders.travel import CylinderTravel
from cranktrain.questions.cylinders.volumes import SweptVolumes
from cranktrain.questions.evenness.spec import Balancing, DrivenByMotor, GivenFlywheel, WantedCoefficient
from cranktrain.questions.forces.carriers import Carriers
from cranktrain.questions.forces.joint_forces import joints_of
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.gas.chambers import GasInChambers
from cranktrain.questions.gas.declared import DeclaredGas
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.questions.motion.dead_centres import DeadCentres, dead_centres_at
from cranktrain.questions.motion.outputs import InCylinders
from cranktrain.questions.motion.pistons import PistonMotion
from cranktrain.saying.catalogue import Entry, entries, values
from cranktrain.study.cycle.compiling import called
from cranktrain.study.cycle.disk import loaded_loops
from cranktrain.study.cycle.given import EvennessAsked, TurningDesigns
from cranktrain.study.cycle.likeness import of_repeats
from cranktrain.study.cycle.loops import tell_vectors
from cranktrain.study.cycle.nodes import nodes
from cranktrain.study.cycle.numbers import NumbersOfKinds, nothing_found, of_gas, of_kinds, room_to_work
from cranktrain.study.cycle.outcomes import ASKS, GRIDLESS, Cycles, bare
from cranktrain.study.cycle.panels import panel_room
from cranktrain.study.cycle.source import written_cycle, written_turning
from cranktrain.study.cycle.structure import OF_EVENNESS, CycleStructure

_LOOKED_AT = 16
"""Points of the turn of which the best is where a dead centre is looked for."""
_OF_PEAKS = frozenset({"peak_pressure_at", "peak_pressure_after"})


class CompiledWay(NamedTuple):
    """How the compiled cycle of a machine gives some facts.

    Attributes
    ----------
    homes : mapping of str to type
        Result that holds each fact.
    from_loop : tuple of type
        Results that the loop gives, those on which others rest first.
    asks : frozenset of str
        What is asked of the loop.
    """

    homes: Mapping[str, type]
    from_loop: tuple[type, ...]
    asks: frozenset[str]

    @property
    def keeps_points(self) -> bool:
        """Whether points of the cycle are kept, of which others make more: that takes milliseconds a design."""
        return "points" in self.asks


class FactsOfCycles(NamedTuple):
    """Facts of designs by the compiled cycle.

    Attributes
    ----------
    is_known : array of bool, shape (design,)
        Of which they are found; of others `run` has to be asked.
    entries : mapping of str to Entry
    labels : mapping of str to tuple of str
        Members along their dimensions.
    values : mapping of str to Array, shape (design, …)
        In the unit of the entry.
    """

    is_known: NDArray[np.bool_]
    entries: Mapping[str, Entry]
    labels: Mapping[str, tuple[str, ...]]
    values: Mapping[str, Array]


def way_to(machine: Machine, wanted: Sequence[str]) -> CompiledWay | Words:
    """Find how the compiled cycle of a machine gives some facts; or say why it does not.

    Parameters
    ----------
    machine : Machine
        One design.
    wanted : sequence of str
        Names of facts.
    """
    if not is_there("numba"):
        return _("Numba is not installed: {install}", install=installing("numba"))
    stages = stages_of(machine.asks, machine.kinds)
    parts = parts_together(machine, [machine.design], step=FACTS_STEP)
    if (reason := _out_of_reach(parts)) is not None:
        return reason
    absent = lacking(stages, parts)
    by_outcome = {one.gives: one for one in stages if one.outcome not in absent}
    home = homes(tuple(by_outcome.values()))
    rests: set[type] = set()
    for name in wanted:
        if name not in home:
            return _("{name} is a fact of other machines", name=name)
        own = _rests_on(name, home[name].gives, by_outcome)
        if own is None or (name in _OF_PEAKS and _is_level(parts)):
            return _("{name} is no fact of the compiled cycle", name=name)
        rests |= own
    rests |= {GasPressures} & by_outcome.keys()
    asks = {ask for kind in rests if (ask := ASKS[kind].ask) is not None}
    if "flywheel_fluctuation" in wanted:
        asks.add("given")
    if "points" in asks and (reason := _no_bearings(parts)) is not None:
        return reason
    if asks & OF_EVENNESS and (reason := _no_evenness(parts)) is not None:
        return reason
    return CompiledWay(
        {name: home[name].gives for name in wanted}, tuple(kind for kind in ASKS if kind in rests), frozenset(asks)
    )


def _rests_on(name: str, home: type, by_outcome: Mapping[type, Stage]) -> set[type] | None:
    """Find the results of the loop on which a fact rests; None where it rests on what needs a grid."""
    if home in ASKS and name not in ASKS[home].names:
        return None
    found: set[type] = set()
    # dead centres are found before all stages
    open_ends, seen = [home], {DeadCentres, PistonMotion}
    while open_ends:
        kind = open_ends.pop()
        if kind in seen or kind not in by_outcome:
            continue
        seen.add(kind)
        if kind in ASKS:
            found.add(kind)
        elif kind in GRIDLESS:
            open_ends += by_outcome[kind].needs.values()
        else:
            return None
    return found


def _out_of_reach(parts: Parts) -> Words | None:
    """Why the cycle of a machine is not compiled."""
    mechanisms, masses, speed, gas = (parts.get(kind) for kind in (Mechanisms, Masses, Speed, DeclaredGas))
    if not isinstance(mechanisms, Mechanisms) or not isinstance(masses, Masses):
        return _("it has neither gas nor masses")
    kinds = [batch.kind for batch in mechanisms.batches]
    if not all(_can_be_imported(kind.motion) and kind.change_points is None for kind in kinds):
        return _("its mechanism is a chain of links, or comes through change points")
    if not isinstance(speed, Speed) or speed.curve is not None:
        return _("it has no speed, or one that varies")
    if masses.has_friction:
        return _("something rubs")
    if Loads in parts:
        return _("loads act on its parts")
    if isinstance(gas, DeclaredGas) and any(table.fluid.breaks is not None for table in gas.tables):
        return _("its gas is a curve over the cycle")
    return None


def _can_be_imported(kernel: Callable[..., object]) -> bool:
    """Whether a written file can name a kernel; one that was joined of others for a chain has no name of its own."""
    return "<locals>" not in kernel.__qualname__


def _is_level(parts: Parts) -> bool:
    """Whether the largest pressure may stand for a while, as that of what is delivered does: then it has no angle."""
    gas = parts.get(DeclaredGas)
    return isinstance(gas, DeclaredGas) and any(not table.fluid.fires for table in gas.tables)


def _no_evenness(parts: Parts) -> Words | None:
    """Why the compiled cycle does not say how evenly a machine runs."""
    balancing = parts.get(Balancing)
    if LoadsOnShafts in parts or DrivenByMotor in parts:
        return _("loads on its shaft, or a motor, say how it runs")
    if not isinstance(balancing, Balancing) or balancing.mean != "time":
        return _("its mean speed is not that over time")
    return None


def _no_bearings(parts: Parts) -> Words | None:
    """Why the compiled cycle does not say what main bearings carry."""
    shafts = parts.get(DeclaredCrankshafts)
    if not isinstance(shafts, DeclaredCrankshafts) or shafts.has_clearance:
        return _("its bearings have clearance")
    if any(one.pulls.over_angle for one in shafts.each):
        return _("a pull over the crank angle acts on its shaft")
    if DeclaredGears in parts and LoadsOnShafts in parts:
        return _("gears hand loads on")
    return None


def facts_of_cycles(together: Machine, n_designs: int, way: CompiledWay) -> FactsOfCycles:
    """Find facts of designs that stand together in the columns of one machine.

    Parameters
    ----------
    together : Machine
        With which nothing is wrong, in any design.
    n_designs : int
    way : CompiledWay
        Of one of them, by `way_to`.
    """
    with np.errstate(all="ignore"):
        parts: Any = parts_together(together, designs_of(together, n_designs), step=FACTS_STEP)
        cycles = _cycles(together, parts, n_designs, way)
    cycles.stages.find(way.homes.values())
    told = {name: _entry(kind, name) for name, kind in way.homes.items()}
    found = {name: values(cycles.stages[kind], told[name]) for name, kind in way.homes.items()}
    in_units = {name: shown(found[name], "deg") if one.unit == "deg" else found[name] for name, one in told.items()}
    return FactsOfCycles(cycles.found.is_known, told, {"design": (), **cycles.stages.labels}, in_units)


def _entry(kind: type, name: str) -> Entry:
    return next(entry for entry in entries(kind) if entry.name == name)


def _cycles(together: Machine, parts: Any, n_designs: int, way: CompiledWay) -> Cycles:
    """Find the cycles of all designs."""
    grid: CrankAngle = parts[CrankAngle]
    crank_angle = replace(grid, shown=np.empty(0))
    mechanisms, carriers, speed, masses = (parts.get(kind) for kind in (Mechanisms, Carriers, Speed, Masses))
    joints = joints_of(LoadedMachine(mechanisms, carriers, masses, None, None, speed))
    kinds = of_kinds(mechanisms, masses, carriers, joints)
    known: Parts = {**parts, CrankAngle: crank_angle}
    if Pistons in parts:
        centres = _dead_centres(kinds, parts, n_designs)
        nothing = np.empty((*centres.stroke.shape, 0))
        known |= {
            DeadCentres: centres,
            PistonMotion: bare(PistonMotion, piston_displacement=Coefficient(nothing, nothing, nothing)),
        }
    stages = stages_of(together.asks, together.kinds)
    absent = lacking(stages, parts)
    run = StageRun([one for one in stages if one.outcome not in absent], known)
    has_gas = GasPressures in way.from_loop
    run.find([GasInChambers, CylinderTravel, SweptVolumes] if has_gas else [])
    gas = of_gas(run[GasInChambers] if has_gas else None, run[CylinderTravel] if has_gas else None, n_designs)
    structure = CycleStructure(kinds.sources, gas.sources, way.asks, has_several=len(mechanisms.names) > 1)
    work = room_to_work(structure, gas.room, len(mechanisms.names), carriers.driven.size, len(joints))
    found = nothing_found(structure, work, n_designs)
    tables = nodes()
    turning = TurningDesigns(
        _each(speed.value, n_designs), _each(crank_angle.zero, n_designs), float(crank_angle.cycle)
    )
    if way.asks:
        alike = of_repeats(kinds.numbers, gas.room, gas.numbers)
        given = {
            **_by_kind(kinds),
            **{f"f{place}": one for place, one in enumerate(gas.numbers)},
            "room": gas.room,
            "turning": turning,
            "wanted": _wanted(parts, way, n_designs),
            "alike": alike,
            "nodes": tables,
            "panels": panel_room(tables),
            "work": work,
            "found": found,
        }
        written = written_cycle(structure)
        with uncollected():
            loaded_loops(written).cycle(0, n_designs, *_taken(written.takes, given))
    else:
        found.is_known[:] = True

    def over_grid() -> StageRun:
        return StageRun([one for one in stages if one.outcome not in absent], parts)

    def of_vectors(loads: Array) -> Array:
        told = np.full((*loads.shape[:2], 3), np.nan)
        with uncollected():
            called(tell_vectors, within=False)(
                0, n_designs, tables, panel_room(tables), turning, found, loads, told, work.tops
            )
        return told

    names = tuple(joint.name for joint in joints)
    cycles = Cycles(found, crank_angle, speed, mechanisms, run, names, over_grid, of_vectors)
    for kind in way.from_loop:
        run.know(ASKS[kind].made(cycles))
    return cycles


def _by_kind(kinds: NumbersOfKinds) -> dict[str, object]:
    """Numbers of each kind by its name in the source."""
    return {f"k{place}": one for place, one in enumerate(kinds.numbers)}


def _taken(takes: Sequence[str], given: Mapping[str, object]) -> Sequence[object]:
    """What a written loop takes of what is given, parts of tuples each by itself."""
    return operator.attrgetter(*takes)(SimpleNamespace(**given))


def _each(value: Array, n_designs: int) -> Array:
    """One number of each design, shape (design, 1, 1) or (1, 1, 1), as an array of shape (design,)."""
    found = np.empty(n_designs)
    found[:] = value[:, 0, 0]
    return found


def _wanted(parts: Any, way: CompiledWay, n_designs: int) -> EvennessAsked:
    """What is asked of how evenly designs run."""
    nothing = np.empty((n_designs, 0))
    inertia, coefficient = nothing, nothing
    if "running" in way.asks:
        inertia = _each(parts[GivenFlywheel].inertia[:, np.newaxis, np.newaxis], n_designs)[:, np.newaxis]
    if "flywheel" in way.asks:
        coefficient = _each(parts[WantedCoefficient].value[:, np.newaxis, np.newaxis], n_designs)[:, np.newaxis]
    return EvennessAsked(inertia, coefficient)


def _dead_centres(kinds: NumbersOfKinds, parts: Any, n_designs: int) -> DeadCentres:
    """True dead centres of every piston, by Newton's method from the best of some points of the turn."""
    pistons: Pistons = parts[Pistons]
    angle = turn_grid(_LOOKED_AT)
    around = np.stack([angle, np.cos(angle), np.sin(angle)])
    found = np.full((n_designs, len(pistons.names), 2, 2), np.nan)
    written, given = written_turning(kinds.sources), {**_by_kind(kinds), "around": around, "found": found}
    with uncollected():
        loaded_loops(written).turning_points(0, n_designs, *_taken(written.takes, given))
    top, bottom = (Extreme(found[:, :, end, :1] - pistons.nominal_top, found[:, :, end, 1:]) for end in range(2))
    return dead_centres_at(top, bottom, pistons, parts[CrankAngle], parts.get(InCylinders))
