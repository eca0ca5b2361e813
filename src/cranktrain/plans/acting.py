"""What acts on every link of a mechanism but its joints: gas, loads, weight, inertia; and how the link moves.

All axes are the machine's, X right and Y up, seen from the free end.
"""

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property

import numpy as np

from cranktrain.analysis import Result, SpeedWanted, run, speed_over_cycle
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import Listed, _
from cranktrain.layout.frames import in_machine_axes
from cranktrain.layout.places import PlacedMechanism
from cranktrain.linkage.forces import WEIGHTLESS, Body, Wrench, applied, weight
from cranktrain.machine import Machine
from cranktrain.mechanisms.dynamics import FRAME, AnyDynamics
from cranktrain.mechanisms.kind import AnyGeometry, rows
from cranktrain.motion import Array, Link
from cranktrain.numerics.nested import each_changed
from cranktrain.numerics.series import around_zero
from cranktrain.plans.acting_loads import ActingLoad, acting_loads, load_symbols
from cranktrain.plans.force_sides import Cause, PolygonForce
from cranktrain.plans.placement import frame
from cranktrain.plans.vectors import pair
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.record import record

_STEP = 10.0
"""Of the grid on which a machine is made ready; the forces themselves are asked for at any angle. [deg]"""
_IN_LINE = 1e-6
"""Angles nearer than so to a change point are at it. [rad]"""

MASTER_ROD = "master_rod"
"""What a slave calls its master's rod."""


@record
class LoadedMechanism:
    """One mechanism of a loaded machine at one crank angle φ; all arrays have shape (1,).

    Attributes
    ----------
    machine : Machine
    loaded : LoadedMachine
    place : PlacedMechanism
    angle : Array
        φ. [rad]
    size : AnyGeometry
    bodies : tuple of Body
        Of its links, as its dynamics have them.
    solved : SolvedBatch
        Its own motion, loads, conditions and forces.
    """

    machine: Machine
    loaded: LoadedMachine
    place: PlacedMechanism
    angle: Array
    size: AnyGeometry
    bodies: tuple[Body, ...]
    solved: SolvedBatch

    @property
    def dynamics(self) -> AnyDynamics:
        """What forces its kind gives."""
        return self.place.kind.dynamics

    @property
    def links(self) -> tuple[Link, ...]:
        """How its links move, in its own axes."""
        return self.dynamics.links(self.solved.motion, self.size)

    @cached_property
    def file_loads(self) -> tuple[ActingLoad, ...]:
        """Loads of the file on it."""
        return acting_loads(self.machine, self.loaded, self.place, self.angle)

    def in_machine_axes(self, x: Array, y: Array) -> Array:
        """Give a vector of its own axes in the machine's, shape (2,)."""
        return np.ravel(in_machine_axes(x, y, frame(self.machine, self.place)))


def made_ready(machine: Machine, speed: SpeedWanted) -> LoadedMachine:
    """Put masses and gas to a machine's mechanisms, at a speed as `run` takes it.

    Raises
    ------
    InputError
        If its file says of nothing that acts, or no speed, or of gas less than its pressure needs.
    """
    refuse_idle(machine)
    curve = speed_over_cycle(machine, speed)  # not on the coarse grid
    return ready_in(run(machine, speed=curve or "constant", step_degrees=_STEP, quantities=("driving_torque",)))


def ready_in(result: Result) -> LoadedMachine:
    """Give the mechanisms of a result's machine with masses and gas, as `made_ready` does of a machine."""
    refuse_idle(result.machines[0])
    refuse_absent(result, ("driving_torque",))
    return result[LoadedMachine]


def refuse_idle(machine: Machine) -> None:
    """Refuse a machine on whose links nothing acts, or of which no speed is known."""
    refuse(idle_problems(machine))


def refuse_absent(result: Result, quantities: Iterable[str]) -> None:
    """Refuse a machine whose tables do not go together to the forces that are wanted, with what they need."""
    absent = [name for name in quantities if name not in result.catalogue]
    if absent:
        needs = Listed(result.needs_of(*absent))
        raise InputError([Problem("", None, _("nothing acts on the links yet: forces need {needs}", needs=needs))])


def idle_problems(machine: Machine) -> Iterator[Problem]:
    """What a machine lacks for forces."""
    main = machine.main_shaft
    if main.speed is None and main.speed_curve is None and not main.makes_motion:
        yield Problem("shaft.main.speed", None, _("is missing: forces of inertia need it"))
    if machine.gas is None and not machine.masses and not machine.weighed.bodies and not machine.loads:
        yield Problem("masses", None, _("is missing, and [gas] too: nothing acts on the links"))


def member_of(machine: Machine, loaded: LoadedMachine, place: PlacedMechanism, angle: Array) -> LoadedMechanism:
    """Find a mechanism in a loaded machine, at φ of shape (1,). [rad]"""
    index = loaded.mechanisms.names.index(place.name)
    at, batch = next((i, batch) for i, batch in enumerate(loaded.mechanisms.batches) if index in batch.index)
    member = batch.index.tolist().index(index)
    if batch.kind.change_points is not None:
        off = around_zero(angle + batch.members.phase[0, member] - batch.kind.change_points.angle(place.geometry))
        if np.any(np.abs(off) < _IN_LINE):
            there = f"φ = {np.rad2deg(angle[0] - float(np.ravel(machine.zero)[0])):g}°"
            allowed = _("the links of {name} lie in line there, where forces are limits: take an angle beside")
            raise InputError([Problem("", there, allowed.format(name=place.name))])
    shape = (1, batch.index.size, angle.size)
    solved = each_changed(lambda part: np.broadcast_to(part, shape)[0, member], loaded.solved(angle)[at])
    size = rows(batch.members.geometry, np.array(member))
    bodies = rows(loaded.masses.batches[at].bodies, np.array(member))
    return LoadedMechanism(machine, loaded, place, angle, size, bodies, solved)


def link_numbers(place: PlacedMechanism, after: int = 1) -> dict[str, int]:
    """Number bodies: 1 the frame; after a number crank, a slave's master rod, what else moves."""
    dynamics = place.kind.dynamics
    joined = [body for reaction in dynamics.reactions for body in (reaction.on, reaction.by)]
    first = (name for name in ("crank", MASTER_ROD) if name in joined)
    moving = [name for name in dict.fromkeys((*first, *dynamics.moving, *joined)) if name != FRAME]
    return {FRAME: 1} | {name: after + 1 + i for i, name in enumerate(moving)}


def pair_symbol(letter: str, by: int, on: int) -> str:
    """Symbol of a force of one body on another."""
    return f"{letter}_{by}{on}" if max(by, on) < 10 else f"{letter}_{by},{on}"


def known_forces(one: LoadedMechanism, i: int, number: int) -> Iterator[PolygonForce]:
    """Gas, loads of the file, weight and inertia of one link."""
    name = one.dynamics.moving[i]
    yield _of_wrench(one, i, f"P_{number}", "gas", one.solved.pressed[i])
    yield from (force for force, _load in forces_of_file(one, name, number))
    for letter, cause, wrench in own_wrenches(one, i):
        yield _of_wrench(one, i, f"{letter}_{number}", cause, wrench)


def own_wrenches(one: LoadedMechanism, i: int) -> Iterator[tuple[str, Cause, Wrench]]:
    """Weight and inertia of one link, about its first pin, with their letters."""
    link, body, conditions = one.links[i], one.bodies[i], one.solved.conditions
    yield "G", "weight", weight(link, body, conditions.gravity)
    yield "Φ", "inertia", applied(link, body, conditions.drive, WEIGHTLESS)


def forces_of_file(one: LoadedMechanism, link: str, number: int) -> Iterator[tuple[PolygonForce, ActingLoad]]:
    """Forces that the file lets act on one link; torques are none."""
    own = [load for load in one.file_loads if load.link == link]
    for load, symbol in zip(own, load_symbols(own, {link: number}), strict=True):
        if not load.is_torque:
            yield PolygonForce(symbol, "load", "", link, pair(load.force[:, 0]), name=load.name), load


def torques_of_file(one: LoadedMechanism, link: str, number: int) -> Iterator[tuple[str, ActingLoad]]:
    """Torques that the file lets act on one link, by their symbols."""
    own = [load for load in one.file_loads if load.link == link]
    symbols = load_symbols(own, {link: number})
    return ((symbol, load) for load, symbol in zip(own, symbols, strict=True) if load.is_torque)


def symbols_together(loads: Sequence[ActingLoad], places: Sequence[PlacedMechanism]) -> dict[tuple[str, str], str]:
    """Symbols of loads on mechanisms that are drawn together, by mechanism and name."""
    found: dict[tuple[str, str], str] = {}
    after = 1
    for place in places:
        numbers = link_numbers(place, after)
        own = [load for load in loads if load.mechanism == place.name]
        symbols = load_symbols(own, numbers)
        found |= {(load.mechanism, load.name): symbol for load, symbol in zip(own, symbols, strict=True)}
        after = max(numbers.values())
    return found


def _of_wrench(one: LoadedMechanism, i: int, symbol: str, cause: Cause, wrench: Wrench) -> PolygonForce:
    """Force of a wrench on one link."""
    return PolygonForce(symbol, cause, "", one.dynamics.moving[i], pair(one.in_machine_axes(wrench.x, wrench.y)))
