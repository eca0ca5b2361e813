"""Chambers to test gas models with, and the Wiebe trace in closed form."""

import numpy as np

from cranktrain.fluids import Rooms, VolumeLimits, fluid_of
from cranktrain.fluids.indicator.chamber import Chamber
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank
from cranktrain.motion import Coefficient
from cranktrain.numerics import extremes
from cranktrain.numerics.designs import by_design

FOUR_STROKE, TWO_STROKE = 4 * np.pi, 2 * np.pi
DUAL_CYCLE = {
    "kind": "dual",
    "start_pressure": "100 kPa",
    "compression_exponent": 1.36,
    "expansion_exponent": 1.25,
    "pressure_ratio": 1.55,
    "cut_off_ratio": 1.45,
}
"""A [gas] table."""


class Engine:
    """One cylinder: central or offset slider-crank, bore and compression ratio."""

    def __init__(self, crank_radius, rod_length, bore, ratio, offset=0.0):
        self.geometry = SliderCrank(crank_radius, rod_length, offset)
        self.area = np.pi / 4 * bore**2
        self.ratio = ratio
        found = extremes(
            lambda angle: slider_crank(angle, self.geometry).slider.value,
            lambda angle: slider_crank(angle, self.geometry).slider.first,
        )
        self.top = float(found.largest.value[0])
        self.top_angle = float(np.mod(found.largest.angle[0] + np.pi, 2 * np.pi) - np.pi)
        self.bottom = float(np.mod(found.smallest.angle[0], 2 * np.pi))
        self.swept = self.area * (self.top - float(found.smallest.value[0]))
        self.limits = VolumeLimits(self.swept / (ratio - 1), self.swept * ratio / (ratio - 1))

    def volume(self, angle):
        slider = slider_crank(angle, self.geometry).slider
        value = self.limits.smallest + self.area * (self.top - slider.value)
        return Coefficient(value, -self.area * slider.first, -self.area * slider.second)

    def slope(self, angle):
        return self.volume(angle).first

    def chamber(self, cycle=FOUR_STROKE):
        return Chamber(cycle, self.limits, lambda angle: self.volume(angle).value)

    def rooms(self, cycle=FOUR_STROKE, speed=None):
        """The cylinder as the one chamber of one design."""
        return Rooms(
            path="gas",
            cycle=cycle,
            limits=VolumeLimits(*(np.full((1, 1, 1), volume) for volume in self.limits)),
            area=np.full((1, 1, 1), self.area),
            bottoms=np.array([[[self.bottom - 2 * np.pi, self.bottom]]]),
            alike=lambda: np.zeros((1, 1), dtype=np.intp),
            speed=None if speed is None else np.full((1, 1, 1), speed),
            volume_of=lambda design, place, angle: self.volume(angle),
        )

    def filled(self, spec, cycle=FOUR_STROKE, speed=None):
        """The fluid of a table, and what its pressure takes in this cylinder."""
        fluid = fluid_of(spec)
        return fluid, fluid.prepared(by_design([fluid.numbers(spec)], 1), self.rooms(cycle, speed))


def indicated_work(pressure, volume_slope, cycle):
    """∮ p dV by samples at equal steps over the cycle, the endpoint excluded: Σ p V′ Δφ."""
    return np.sum(pressure * volume_slope, axis=-1) * (cycle / pressure.shape[-1])


def wiebe(engine, case, angle):
    """Pressure over one turn about firing: p Vᵞ = p₀V₀ᵞ + (γ − 1) Q ∫ x_b′ Vᵞ⁻¹ dφ, by Gauss's quadrature."""
    gamma, shape, factor = case["gamma"], case["m"], case["a"]
    start, duration = np.radians(case["start_deg"]), np.radians(case["duration_deg"])
    nodes, weights = np.polynomial.legendre.leggauss(60)
    end = np.clip(angle, start, start + duration)[..., np.newaxis]
    at = start + (end - start) * (1 + nodes) / 2
    share = (at - start) / duration
    rate = factor * (shape + 1) / duration * share**shape * np.exp(-factor * share ** (shape + 1))
    heat = np.sum(weights * rate * engine.volume(at).value ** (gamma - 1), axis=-1) * (end[..., 0] - start) / 2
    constant = case["p_bdc"] * engine.limits.largest**gamma
    return (constant + (gamma - 1) * case["Q"] * heat) / engine.volume(angle).value ** gamma


def wiebe_cycle(engine, case, angle, exhaust=1.05e5, inlet=0.97e5):
    """The same with gas exchange at constant pressure, over a four-stroke's cycle from firing."""
    from_firing = np.mod(angle + 2 * np.pi, 4 * np.pi) - 2 * np.pi
    working = wiebe(engine, case, np.clip(from_firing, -np.pi, np.pi))
    exchange = np.where(from_firing > 0, exhaust, inlet)
    # Both dead centres belong to the working turn, as in the reference; rounding must not choose.
    return np.where(np.abs(from_firing) < np.pi + 1e-12, working, exchange)


def csv(angles, pressures, header="crank_angle_deg,p_abs_Pa"):
    """A file of angles in degrees and pressures."""
    rows = (f"{angle!r},{pressure!r}" for angle, pressure in zip(angles.tolist(), pressures.tolist(), strict=True))
    return "\n".join([header, *rows])
