"""Parts: what machines declare, as SI arrays with a leading design axis; stages ask for them by type."""

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import cast

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.layout.axial import axial_places_of
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.frames import frames_of
from cranktrain.layout.masses import GivenBodies, masses_of
from cranktrain.layout.mechanisms import Mechanisms, PistonRods, Pistons, RockerRods, Rockers, has_rods, mechanisms_of
from cranktrain.layout.places import Place
from cranktrain.layout.shafts import GearedShafts, shafts_of
from cranktrain.layout.speed import Speed
from cranktrain.layout.speed_curve import SteadyRunning, speed_at_moment
from cranktrain.layout.speed_table import tabled_speed
from cranktrain.layout.throws import shaft_centres_of, throws_of
from cranktrain.machine import Machine, machine_problems
from cranktrain.quantities import Given
from cranktrain.questions.balance.weights import declared_balance
from cranktrain.questions.cylinders.declared import (
    CYCLES,
    chambers_of,
    compression_ratios_of,
    cylinder_pistons_of,
    ports_of,
)
from cranktrain.questions.cylinders.firing import Cycle, FiringOrder, common_order
from cranktrain.questions.cylinders.opposed import OpposedCylinders
from cranktrain.questions.cylinders.ports import TwoStroke
from cranktrain.questions.cylinders.volumes import Chambers, CompressionRatios
from cranktrain.questions.evenness.spec import evenness_parts
from cranktrain.questions.forces.crank_pins import crank_pins_of
from cranktrain.questions.forces.guides import guides_with_length, moment_guides_of
from cranktrain.questions.forces.loaded import carriers_of
from cranktrain.questions.forces.piston_forces import direct_pistons_of
from cranktrain.questions.gas.chambers import DeclaredGas
from cranktrain.questions.gas.powers import losses_of
from cranktrain.questions.motion.followed import FollowedLinks, FollowedSliders, followed_of
from cranktrain.questions.motion.points import link_points_of
from cranktrain.questions.motion.rocker_load import load_radius_of
from cranktrain.questions.torsion.parts import declared_train
from cranktrain.spec import Spec

_GAS = (DeclaredGas, Chambers, CompressionRatios, Cycle, FiringOrder)
"""What it takes for gas to press on pistons: then there are forces, whether anything has a mass or not."""

Parts = dict[type, object]
"""What a machine declares, in SI: one object of each type."""


def parts_of(machines: Sequence[Machine], *, step: float, partial: bool = False) -> Parts:
    """Lay out designs of one machine.

    Parameters
    ----------
    machines : sequence of Machine
        The same mechanisms in the same places; only numbers differ.
    step : float
        Of the crank-angle grid, a whole part of the cycle. [rad]
    partial : bool
        Accept links that cannot close over the whole turn: NaN there.

    Returns
    -------
    Parts
        By type: `CrankAngle`, `Mechanisms`, `Pistons`, `Rockers`, each kind's members, `Speed`, `Chambers`, …; what the
        machines do not declare is left out.

    Raises
    ------
    InputError
    """
    designs = _designs(machines, partial=partial)
    first = machines[0]
    cycle = CYCLES[first.cylinder.cycle] if first.cylinder.cycle else None
    turn = cycle or 2 * np.pi
    n_angles = round(turn / step)
    mechanisms = mechanisms_of(Mechanisms, designs)
    grid = CrankAngle(
        shown=np.arange(n_angles, dtype=np.float64) * turn / n_angles,
        zero=np.array([[[machine.zero]] for machine in machines]),
        cycle=turn,
    )
    parts: list[object | None] = [
        grid,
        mechanisms,
        *(group.members for group in mechanisms.groups),
        axial_places_of([machine.shafts for machine in machines], designs),
        link_points_of(designs),
        followed_of(FollowedLinks, designs[0]),
        followed_of(FollowedSliders, designs[0]),
        carriers_of(designs[0]),
        moment_guides_of(designs[0]),
        frames_of(designs, [machine.orientation for machine in machines]),
        throws_of(designs[0]),
        shaft_centres_of([machine.shafts for machine in machines], designs),
        declared_balance([machine.balance for machine in machines], [machine.shafts for machine in machines]),
        crank_pins_of(mechanisms),
        (shafts := shafts_of(first.shafts, designs[0])),
        GearedShafts(shafts) if len(shafts.names) > 1 else None,
    ]
    pistons = [machine.pistons for machine in machines]
    rockers = [[place for place in design if place.kind.output == "rocker"] for design in designs]
    if pistons[0]:
        cylinders = [machine.cylinders for machine in machines]
        drivers = mechanisms_of(Pistons, pistons)
        sharing = cylinder_pistons_of(cylinders[0])
        parts += [
            drivers,
            PistonRods(rods) if (rods := has_rods(drivers)) is not None else None,
            sharing,
            direct_pistons_of(drivers),
            OpposedCylinders(sharing) if sharing is not None and np.any(sharing.is_opposed) else None,
            chambers_of(cylinders, len(pistons[0])),
            compression_ratios_of(cylinders),
            (ports := ports_of(cylinders)),
            TwoStroke() if ports is not None or first.cylinder.cycle == "two-stroke" else None,
            Cycle(cycle) if cycle else None,
            _declared_gas(machines),
            losses_of([machine.cylinder for machine in machines]),
            common_order([machine.firing[0] for machine in machines]),
        ]
    if rockers[0]:
        swinging = mechanisms_of(Rockers, rockers)
        parts += [
            swinging,
            RockerRods(rods) if (rods := has_rods(swinging)) is not None else None,
            load_radius_of(rockers),
        ]
    if first.evenness is not None:
        parts += evenness_parts([machine.evenness for machine in machines if machine.evenness is not None])
    if first.torsion is not None:
        trains = [machine.torsion for machine in machines if machine.torsion is not None]
        parts.append(declared_train(trains, len(first.main_shaft.throws)))
    parts += _speed_parts(machines, grid)
    has_bodies = bool(first.weighed.bodies)
    if has_bodies or all(any(isinstance(part, need) for part in parts) for need in _GAS):
        masses = masses_of(designs, [machine.weighed for machine in machines])
        parts += [masses, guides_with_length(masses), GivenBodies() if has_bodies else None]
    return {type(part): part for part in parts if part is not None}


def _speed_parts(machines: Sequence[Machine], grid: CrankAngle) -> Iterator[object]:
    """Give what the file says of how the main shaft turns."""
    shafts = [machine.main_shaft for machine in machines]
    speeds = np.array([shaft.speed.si for shaft in shafts if shaft.speed is not None])
    accelerations = np.array([shaft.acceleration.si for shaft in shafts if shaft.acceleration is not None])
    curves = [shaft.speed_curve for shaft in shafts if shaft.speed_curve is not None]
    curve = None
    if accelerations.size:
        curve = speed_at_moment(speeds, accelerations, grid.cycle, zero=grid.zero)
    else:
        yield SteadyRunning()
        if curves:
            curve = tabled_speed(curves, grid.shown.size, grid.cycle, zero=grid.zero)
    if speeds.size:
        yield Speed(speeds[:, np.newaxis, np.newaxis], curve)
    elif curve is not None:
        yield Speed(curve.mean, curve)
    if curve is not None:
        yield curve


def _designs(machines: Sequence[Machine], *, partial: bool) -> list[tuple[Place, ...]]:
    """Arrange every design; everything that is wrong with any of them is told at once."""
    found: list[Problem] = list(_differences(machines))
    designs: list[tuple[Place, ...]] = []
    for machine in machines:
        found += machine_problems(machine, partial=partial)
        designs.append(machine.places)
    if found:
        raise InputError(dict.fromkeys(found))
    return designs


def _differences(machines: Sequence[Machine]) -> Iterator[Problem]:
    """Find where designs differ in more than numbers."""
    first = dict(_structure(machines[0])) if len(machines) > 1 else {}
    allowed = _("must be the same in all designs, which may differ in numbers alone; in design {n} it is another")
    for n, machine in enumerate(machines[1:], start=2):
        other = dict(_structure(machine))
        paths = [path for path in dict.fromkeys((*first, *other)) if first.get(path) != other.get(path)]
        if paths:
            yield Problem(re.sub(r"\.mechanism\[\d+\]", ".mechanism", paths[0]), None, allowed.format(n=n))


def _structure(declared: object, path: str = "") -> Iterator[tuple[str, object]]:
    """Give what is no number in a spec, by path; of a number, that there is one."""
    if isinstance(declared, Given):
        yield path, Given
    elif isinstance(declared, Spec):
        for name, field in type(declared).model_fields.items():
            if name in declared.of_file:
                if field.is_required():
                    yield f"{path}.{name}", Given
            elif name != "name":
                yield from _structure(getattr(declared, name), f"{path}.{name}".removeprefix("."))
    elif isinstance(declared, Mapping):
        for name, value in cast(Mapping[str, object], declared).items():
            yield from _structure(value, f"{path}.{name}")
    elif isinstance(declared, tuple):
        for place, value in enumerate(cast(tuple[object, ...], declared)):
            yield from _structure(value, f"{path}[{place}]")
    elif declared is not None:
        yield path, declared


def _declared_gas(machines: Sequence[Machine]) -> DeclaredGas | None:
    """Collect the gas models; None where the file has none."""
    specs = tuple(machine.gas for machine in machines if machine.gas is not None)
    return DeclaredGas(specs) if specs else None
