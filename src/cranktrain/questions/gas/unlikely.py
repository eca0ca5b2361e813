"""Numbers of gas and of its chambers that hardly any machine has: computed with all the same, and flagged."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import N_, Words
from cranktrain.questions.gas.chambers import GasInChambers
from cranktrain.questions.gas.heat import HeatBalance
from cranktrain.questions.gas.powers import Losses
from cranktrain.record import record
from cranktrain.saying.checks import Flagged, Limit, flagged

_NO_LIMIT = np.inf

# Engines and compressors have 0.2 to 0.36, models up to 0.4: beyond it the rod meets the cylinder's foot.
_LAMBDA = Limit(
    0.45,
    "",
    N_("Crank radius over rod length of {whose} is {value}; with gas over the piston 0.36 is much: are both right?"),
)
# A fuel of 43 MJ/kg with 14.7 kg of air for one of it. (Heywood, Internal Combustion Engine Fundamentals, table D.4.)
_HEAT_OF_CHARGE = 43e6 / (1 + 14.7)
"""What a kilogram of mixture gives that has just enough air. [J/kg]"""
_GAS_CONSTANT, _WARM = 287.0, 300.0
"""Of air [J/(kg·K)]; of a charge of which nothing is said [K]."""
_LEAST_HEAT = Limit(
    _NO_LIMIT,
    "%",
    N_("[gas] heat is {value} of what the charge of {whose} could burn, idling a tenth: is its unit right?"),
    0.01,
)
_LEAST_SHARE = Limit(
    _NO_LIMIT,
    "%",
    N_("Of the heat in {whose} {value} becomes work: are heat_start, heat and heat_transfer right?"),
    0.0,
)
_COLDEST_WALL = Limit(
    _NO_LIMIT,
    "K",
    N_("Walls at {value} are colder than those of any engine: is the unit of wall_temperature right?"),
    250.0,
)
# An engine that idles needs some 150°, one that is turned by hand, once a second, 10°.
_FASTEST_COOLING = Limit(
    _NO_LIMIT,
    "deg",
    N_(
        "At this speed the gas in {whose} becomes as warm as its walls within {value} of the crank angle, which leaves"
        " few digits to its pressure: are heat_transfer and the speed right?"
    ),
    np.deg2rad(2.0),
)
# Air has 1.3 to 1.4, well cooled 1.1 to 1.3; heavy refrigerants 1.08 and more. 1 is isothermal, and no machine.
_LEAST_EXPONENT = Limit(
    _NO_LIMIT,
    "",
    N_("An exponent of {value} is that of a compressor which stays as cold as it was; built ones have 1.1 and more."),
    np.nextafter(1.05, 2.0),
)
_LEAST_EFFICIENCY = Limit(
    _NO_LIMIT,
    "",
    N_("A mechanical_efficiency of {value} leaves next to nothing; engines have 0.7 to 0.95: is its unit right?"),
    0.15,
)
_LONG, _OF_LONG = 2.0, 0.45 / 0.55
"""Strokes in bores from which a rod is on a crosshead, outside the cylinder, and the part of λ that then counts: slow
marine engines with strokes of 2.5 to 5 bores have rods of a stroke, λ 0.4 to 0.5."""


@record
class UnlikelyGas(Flagged):
    """Gas, heat and friction that hardly any machine has."""


def unlikely_gas(gas: GasInChambers | None, heat: HeatBalance | None, losses: Losses | None) -> UnlikelyGas:
    """Flag what is beyond the limits, as far as it is known."""
    found: list[Words] = []
    if gas is not None:
        found += [*_ratios_of_cranks(gas), *_burning(gas), *_compressing(gas)]
    if heat is not None and gas is not None:
        found += flagged(_LEAST_SHARE, heat.working_turn_efficiency, whose=gas.chambers.names)
    if losses is not None:
        found += flagged(_LEAST_EFFICIENCY, losses.efficiency)
    return UnlikelyGas(unlikely=tuple(found))


def _ratios_of_cranks(gas: GasInChambers) -> Iterator[Words]:
    """Flag λ of pistons with gas whose rods hang on a crank themselves."""
    areas = np.max(np.abs(gas.chambers.areas), axis=2)
    ratio, stroke = np.full((2, *gas.tops.shape[:2]), np.nan)
    for batch in gas.pistons.batches:
        if batch.kind.is_direct:
            size = batch.members.geometry
            ratio[:, batch.index] = (size.crank_radius / size.rod_length)[..., 0]
            stroke[:, batch.index] = 2 * size.crank_radius[..., 0]
    counted = np.where(stroke > _LONG * np.sqrt(4 / np.pi * areas), _OF_LONG, 1.0) * ratio
    yield from flagged(_LAMBDA, np.where(areas > 0, counted, np.nan), ratio, gas.pistons.names)


def _burning(gas: GasInChambers) -> Iterator[Words]:
    """Flag heat that is nothing beside what the charge could burn, and walls that are too cold."""
    for filling in gas.filled_with("wiebe"):
        from cranktrain.fluids.wiebe.chamber import walls  # for machines that burn so

        law, gas_mass = filling.ready.curve.law, filling.ready.curve.mass
        # Without heat to the walls nothing is said of temperatures.
        is_known = law.transfer != 0
        charge = gas_mass * np.where(is_known, 1.0, law.start_temperature / _WARM) / _GAS_CONSTANT
        places: list[int] = filling.places.tolist()
        names = [gas.chambers.names[place] for place in places]
        yield from flagged(_LEAST_HEAT, (law.heat / (charge * _HEAT_OF_CHARGE))[..., 0], whose=names)
        yield from flagged(_COLDEST_WALL, np.where(is_known, law.wall_temperature, np.nan))
        largest = gas_mass * law.start_temperature / law.start_pressure
        cooled = (law.heat_ratio - 1) * law.transfer * walls(filling.ready.area[..., np.newaxis], largest)
        with np.errstate(divide="ignore"):
            yield from flagged(_FASTEST_COOLING, (gas_mass / cooled)[..., 0], whose=names)


def _compressing(gas: GasInChambers) -> Iterator[Words]:
    """Flag exponents of compressors."""
    for filling in gas.filled_with("compressor"):
        ready = filling.ready
        each = np.broadcast_arrays(ready.compression_exponent, ready.expansion_exponent)
        yield from flagged(_LEAST_EXPONENT, np.concatenate(each, axis=-1))
