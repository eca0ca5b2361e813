"""Numbers beyond what was ever built: computed with all the same, and doubted."""

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, _
from cranktrain.layout.masses import Masses
from cranktrain.layout.part_tables import SLIDER
from cranktrain.linkage.forces import Body
from cranktrain.motion import Array
from cranktrain.quantities import shown
from cranktrain.questions.cylinders.volumes import Chambers, ChamberVolumes
from cranktrain.questions.forces.loaded import LoadedMachine
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.questions.motion.closing import Closing
from cranktrain.questions.motion.dead_centres import DeadCentres
from cranktrain.questions.motion.pistons import PistonSpeeds
from cranktrain.questions.motion.rockers import DeadPositions
from cranktrain.record import record


class Limit(NamedTuple):
    """The most that is not doubted, in SI; the unit of what is told; and the sentence."""

    most: float
    unit: str
    sentence: str


LIMITS: Mapping[str, Limit] = {
    # Formula 1 of 2007: 300 cm³ on 98 mm are a stroke of 39.8 mm, at 19000 rpm 25.2 m/s. Top Fuel: 4.5 in at 8400 rpm
    # are 32 m/s, for four seconds.
    "mean_piston_speed": Limit(
        30.0, "m/s", N_("A mean piston speed of {value} is more than any piston bears: are speed and stroke right?")
    ),
    # Heywood, Internal Combustion Engine Fundamentals, ch. 2.2: 8 to 12 with spark ignition, 12 to 24 in diesels.
    "compression_ratio_of_engine": Limit(
        30.0,
        "",
        N_("A compression ratio of {value} is more than any engine has, 24 in diesels: is its decimal point right?"),
    ),
    # Compressors have a clearance of 3 % of the swept volume and more: 1 + 1/0.03 = 34.
    "compression_ratio": Limit(
        40.0,
        "",
        N_("A compression ratio of {value} is more than engines or compressors have: is its decimal point right?"),
    ),
    # The largest firing pressures of production engines, of large diesels, are 25 to 30 MPa.
    "peak_pressure": Limit(
        40e6,
        "MPa",
        N_("A pressure of {value} is more than engines bear: are charge, compression ratio and pressure unit right?"),
    ),
    # Ten diameters of solid steel: 7850 kg/m³ · π/4 D² · 10 D over π/4 D² · D. A car's piston is 1000 kg/m³, that of a
    # crosshead engine of 960 mm with rod and crosshead, some 15 t, 22000.
    "reciprocating_mass": Limit(
        78500.0,
        "kg",
        N_("A piston of {value} is heavier than ten of its diameters of solid steel: is its mass right, and its bore?"),
    ),
    # p = m R ω²/A. By size alone it does not change: 1 MPa in a car's engine, 3 in a slow crosshead engine (15 t,
    # R = 1.25 m, 102 rpm, 960 mm), 6 in Top Fuel (1.2 kg, R = 57 mm, 8400 rpm, 106 mm).
    "inertia_pressure": Limit(
        10e6,
        "MPa",
        N_("The piston's inertia over its area, mRω²/A, is {value}; built ones have 6 MPa at most: is its mass right?"),
    ),
    # Near locking the slopes of all curves are its inverse square root, and their digits are those of the margin.
    "closeness": Limit(
        1e6,
        "",
        N_("The links close by {value} of a length alone: results near there rest on its last digits."),
    ),
    # The position has 16 digits, and its part that moves so many fewer. Rods that stand for none are given 10⁴ cranks.
    "distance": Limit(
        1e5,
        "",
        N_(
            "A slider's stroke is {value} of its distance from the shaft:"
            " its curves lose as many digits as that has zeros."
        ),
    ),
    "swing": Limit(
        1e5, "deg", N_("A rocker swings {value}: what there is of its motion is in the last digits of its position.")
    ),
    # Marks' Standard Handbook, coefficients of sliding friction: greasy metals 0.05 to 0.2; dry ones come to 0.4 and
    # more.
    "friction": Limit(
        0.3, "", N_("A coefficient of friction of {value} is more than lubricated guides have, 0.2: do these run dry?")
    ),
}
"""What is doubted, each with its source."""


@record
class Doubts:
    """What is beyond the limits."""

    flags: tuple[str, ...]


def doubts(
    speeds: PistonSpeeds | None,
    travel: DeadCentres | None,
    chambers: Chambers | None,
    volumes: ChamberVolumes | None,
    gas: GasPressures | None,
    loaded: LoadedMachine | None,
    closes: Closing | None,
    rockers: DeadPositions | None,
) -> Doubts:
    """Doubt what is beyond the limits; of all designs the worst is told."""
    found: list[str] = []
    if closes is not None:
        found += doubted("closeness", 1 / closes.closing_margin, closes.closing_margin)
    if travel is not None:
        distance = np.abs(travel.top_position)
        found += doubted("distance", distance / travel.stroke, travel.stroke / distance)
    if rockers is not None:
        found += doubted("swing", 1 / rockers.swing, rockers.swing)
    if speeds is not None:
        found += doubted("mean_piston_speed", speeds.mean_piston_speed[:, ~speeds.is_valve])
    fired = None if gas is None else gas.indicated_work > 0
    if volumes is not None:
        ratios = volumes.compression_ratio
        found += doubted("compression_ratio", ratios if fired is None else ratios[~fired])
        found += [] if fired is None else doubted("compression_ratio_of_engine", ratios[fired])
    if gas is not None and fired is not None:
        found += doubted("peak_pressure", gas.peak_pressure[fired])
    if loaded is not None:
        found += doubted("friction", np.array(list(_coefficients(loaded.masses))))
        if chambers is not None and travel is not None:
            found += _of_pistons(loaded, chambers, travel.stroke, fired)
    return Doubts(tuple(found))


def doubted(name: str, values: Array, told: Array | None = None) -> Iterator[str]:
    """Doubt the largest of some values if it is beyond its limit, NaN never; tell it, or what stands for it."""
    limit = LIMITS[name]
    beyond = np.where(values > limit.most, values, -np.inf)
    if np.any(values > limit.most):
        worst = float(np.ravel(values if told is None else told)[np.argmax(beyond)])
        yield _(limit.sentence).format(value=_written(worst, limit.unit))


def _written(value: float, unit: str) -> str:
    """Write a number with four figures at most."""
    return f"{shown(value, unit):.4g} {unit}" if unit else f"{value:.4g}"


def _of_pistons(
    loaded: LoadedMachine, chambers: Chambers, stroke: Array, fired: NDArray[np.bool_] | None
) -> Iterator[str]:
    """Doubt masses of pistons, of engines by the bore, of all by their inertia."""
    mass = _piston_masses(loaded, stroke.shape)
    areas = np.abs(chambers.areas)
    area = np.max(areas, axis=2)
    area = np.where(area > 0, area, np.nan)
    if fired is not None:
        is_engine = np.any((areas > 0) & fired[:, np.newaxis], axis=2)
        density = np.where(is_engine, mass / (area * np.sqrt(4 / np.pi * area)), 0.0)
        yield from doubted("reciprocating_mass", density, mass)
    yield from doubted("inertia_pressure", mass * stroke / 2 * loaded.speed.value[..., 0] ** 2 / area)


def _piston_masses(loaded: LoadedMachine, shape: tuple[int, ...]) -> Array:
    """Mass of what slides with each piston, shape (design, piston). [kg]"""
    found = np.zeros(shape)
    for group, made in zip(loaded.mechanisms.groups, loaded.masses.groups, strict=True):
        piston = loaded.carriers.piston[group.index]
        slider: Body | None = getattr(made.bodies, SLIDER, None)
        if slider is not None and piston[0] >= 0:
            found[:, piston] = slider.mass[..., 0]
    return found


def _coefficients(masses: Masses) -> Iterable[float]:
    """Coefficients of friction of all that slides."""
    return (float(one) for group in masses.groups for part in group.friction for one in np.ravel(part))
