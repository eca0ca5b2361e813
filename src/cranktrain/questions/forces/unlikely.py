"""Masses, their centres and friction beyond what was ever built: computed with all the same, and flagged."""

from collections.abc import Iterator, Sequence
from functools import reduce

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, Words, _
from cranktrain.layout.loads import LinkLoad
from cranktrain.layout.part_tables import SLIDER
from cranktrain.motion import Array
from cranktrain.questions.cylinders.volumes import Chambers
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.questions.motion.dead_centres import DeadCentres
from cranktrain.record import record
from cranktrain.saying.checks import Flagged, Limit, flagged

# Ten diameters of solid steel: 7850 kg/m³ · π/4 D² · 10 D over π/4 D² · D. A car's piston is 1000 kg/m³, that of a
# crosshead engine of 960 mm with rod and crosshead, some 15 t, 22000.
_DENSITY = Limit(
    78500.0,
    "kg",
    N_("A piston of {value} is heavier than ten of its diameters of solid steel: is its mass right, and its bore?"),
)
# p = m R ω²/A. By size alone it does not change: 1 MPa in a car's engine, 3 in a slow crosshead engine (15 t,
# R = 1.25 m, 102 rpm, 960 mm), 6 in Top Fuel (1.2 kg, R = 57 mm, 8400 rpm, 106 mm).
_INERTIA_PRESSURE = Limit(
    10e6,
    "MPa",
    N_("The piston's inertia over its area, mRω²/A, is {value}; built ones have 6 MPa at most: is its mass right?"),
)
# Marks' Standard Handbook, coefficients of sliding friction: greasy metals 0.05 to 0.2; dry ones come to 0.4 and
# more.
_FRICTION = Limit(
    0.3, "", N_("A coefficient of friction of {value} is more than lubricated guides have, 0.2: do these run dry?")
)
# A rod is heavier at its crank pin: 0.25 to 0.4 of its length from there, compressors' with two like ends half.
_CENTRE = Limit(
    0.5 * (1 + 1e-9),
    "",
    N_(
        "The rod of {whose} has its centre {value} of its length from its big end, nearer the small one: are its ends"
        " swapped?"
    ),
)
# A pumping unit's horse head is at twice its rear arm; levers of presses and crushers come to twice.
_FAR_LOAD = Limit(
    3.0,
    "mm",
    N_(
        "A load acts {value} from the first pin of its link, over three times as far off as any pin of its mechanism"
        " ever comes from the shaft: are along and across of {whose} right?"
    ),
)


@record
class UnlikelyLoads(Flagged):
    """Masses, their centres and coefficients of friction that hardly any machine has."""


def unlikely_loads(
    loaded: LoadedMachine | None,
    solved: SolvedCycle | None,
    travel: DeadCentres | None,
    chambers: Chambers | None,
    gas: GasPressures | None,
) -> UnlikelyLoads:
    """Flag what is beyond the limits, as far as it is known; of all designs the worst is named."""
    found: list[Words] = []
    if loaded is not None:
        rubbing = [part.reshape(len(part), -1) for batch in loaded.masses.batches for part in batch.friction]
        found += flagged(_FRICTION, np.concatenate([np.empty((len(loaded.speed.value), 0)), *rubbing], axis=-1))
        found += flagged(_CENTRE, _centres_of_rods(loaded), whose=loaded.mechanisms.names)
        if chambers is not None and travel is not None:
            found += _of_pistons(loaded, chambers, travel.stroke, None if gas is None else gas.indicated_work > 0)
        loads = [] if loaded.loads is None else [load for load in loaded.loads.each if not load.is_torque]
        if loads and solved is not None:
            found += _far_loads(loaded, loads, solved)
    return UnlikelyLoads(unlikely=tuple(found), flags=() if loaded is None else tuple(_unheld(loaded)))


def _unheld(loaded: LoadedMachine) -> Iterator[Words]:
    """Flag mechanisms whose links lie in line under a moment that no force of theirs can hold."""
    for mechanism in np.flatnonzero(np.any(loaded.unheld, axis=0)).tolist():
        yield _(
            "The links of {mechanism} lie in line at its change points under a moment that no force along them can"
            " hold: forces in its joints go beyond all bounds there, and none is the largest. Such linkages are built"
            " in pairs, a quarter turn apart.",
            mechanism=loaded.mechanisms.names[mechanism],
        )


def _of_pistons(
    loaded: LoadedMachine, chambers: Chambers, stroke: Array, fired: NDArray[np.bool_] | None
) -> Iterator[Words]:
    """Flag masses of pistons, of engines by the bore, of all by their inertia."""
    mass = _piston_masses(loaded, stroke.shape)
    areas = np.abs(chambers.areas)
    area = np.max(areas, axis=2)
    area = np.where(area > 0, area, np.nan)
    if fired is not None:
        is_engine = np.any((areas > 0) & fired[:, np.newaxis], axis=2)
        density = np.where(is_engine, mass / (area * np.sqrt(4 / np.pi * area)), 0.0)
        yield from flagged(_DENSITY, density, mass)
    yield from flagged(_INERTIA_PRESSURE, mass * stroke / 2 * loaded.speed.value[..., 0] ** 2 / area)


def _centres_of_rods(loaded: LoadedMachine) -> Array:
    """Where the rods of sliders have their centres, from big end to small, shape (design, mechanism); NaN of others."""
    found = np.full((len(loaded.speed.value), len(loaded.mechanisms.names)), np.nan)
    for batch, made in zip(loaded.mechanisms.batches, loaded.masses.batches, strict=True):
        if batch.kind.dynamics.joint("piston_pin") is not None:
            rod, length = batch.kind.dynamics.by_link(made.bodies)["rod"], batch.members.geometry.rod_length
            found[:, batch.index] = np.where(rod.mass > 0, rod.along / length, np.nan)[..., 0]
    return found


def _far_loads(loaded: LoadedMachine, loads: Sequence[LinkLoad], solved: SolvedCycle) -> Iterator[Words]:
    """Flag loads that act far off all pins of their mechanism."""
    farthest: list[Array] = []
    for batch, one in zip(loaded.mechanisms.batches, solved.batches, strict=True):
        pins = [link.origin for link in batch.kind.dynamics.links(one.motion, batch.members.geometry)]
        away = [np.fmax.reduce(np.hypot(pin.x.value, pin.y.value), axis=-1, keepdims=True) for pin in pins]
        farthest.append(reduce(np.fmax, away))
    reach = loaded.in_order(farthest)[:, [load.mechanism for load in loads], 0]
    off = np.concatenate([load.distance[..., 0] + 0.0 * reach[:, :1] for load in loads], axis=-1)
    yield from flagged(_FAR_LOAD, off / reach, off, [load.name for load in loads])


def _piston_masses(loaded: LoadedMachine, shape: tuple[int, ...]) -> Array:
    """Mass of what slides with each piston, shape (design, piston). [kg]"""
    found = np.zeros(shape)
    for batch, made in zip(loaded.mechanisms.batches, loaded.masses.batches, strict=True):
        piston = loaded.carriers.piston[batch.index]
        slider = batch.kind.dynamics.by_link(made.bodies).get(SLIDER)
        if slider is not None and piston[0] >= 0:
            found[:, piston] = slider.mass[..., 0]
    return found
