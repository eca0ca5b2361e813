"""Compressor with clearance and its stages: Frenkel; Bloch and Hoefner; numbers confirmed by quadrature to 7e-16."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.fluids import Rooms, VolumeLimits
from cranktrain.fluids.compressor import Compressor, capacity, compressor_work, suction_heating
from cranktrain.fluids.compressor.chamber import CompressorNumbers
from cranktrain.fluids.compressor.pressure import corners
from cranktrain.fluids.compressor.stages import CompressorStage, interstage_pressures

R, L, BORE, ROD = 0.08, 0.4, 0.25, 0.05
HEAD = np.pi / 4 * BORE**2
CRANK = HEAD - np.pi / 4 * ROD**2
CLOSED = 1e-13


def limits(area, clearance):
    return VolumeLimits(clearance * area * 2 * R, (1 + clearance) * area * 2 * R)


def between(suction, discharge, compression=1.35, expansion=1.28):
    return Compressor(suction, discharge, compression, expansion, suction, 293.15, discharge)


@pytest.mark.parametrize(
    ("room", "part", "work"),
    [
        (limits(HEAD, 0.08), 0.8209329001553256, 1197.9096026067791),
        (limits(CRANK, 0.09), 0.7985495126747414, 1120.3758997150794),
    ],
    ids=["head", "crank"],
)
def test_capacity_and_work(room, part, work):
    machine = between(1e5, 4.5e5)
    assert capacity(machine, room) == pytest.approx(part, rel=CLOSED)
    assert -compressor_work(machine, room) == pytest.approx(work, rel=CLOSED)


def test_suction_is_warmed_so_that_the_masses_close():
    room = limits(HEAD, 0.08)
    machine = between(1e5, 4.5e5)
    warmer = suction_heating(machine, room)
    assert warmer == pytest.approx(1.01865, abs=5e-6)
    found = corners(machine, room)
    taken = 1e5 * (room.largest - found.suction_opens)
    inside = 1e5 * room.largest / warmer
    delivered = inside * (found.discharge_opens - room.smallest) / found.discharge_opens
    assert delivered == pytest.approx(taken, rel=1e-14)
    assert suction_heating(between(1e5, 4.5e5, 1.3, 1.3), room) == pytest.approx(1.0, rel=1e-14)


def test_beyond_the_ratio_of_delivery_one_polytrope_goes_both_ways():
    """c = 0.08, π from 13.5^n on: no flow, no work; n_e does not matter."""
    room = limits(HEAD, 0.08)
    for machine in (between(1e5, 34e5), between(1e5, 18.4e5, 1.1, 1.1)):
        assert capacity(machine, room) == 0.0
        assert compressor_work(machine, room) == pytest.approx(0.0, abs=1e-12 * 1e5 * HEAD * 2 * R)


def test_where_no_cycle_is_steady_the_exponents_are_one():
    """Between 13.5^1.28 = 27.98 and 13.5^1.35 = 33.57."""
    room = limits(HEAD, 0.08)
    assert capacity(between(1e5, 30e5), room) == capacity(between(1e5, 30e5, 1.35, 1.35), room) > 0


def stage(volume, clearance, temperature):
    """A stage of one chamber, its numbers and its room of one design."""
    shape = (1, 1, 1)
    numbers = CompressorNumbers(
        *(np.full(shape, value) for value in (np.nan, np.nan, 1.3, 1.3, 0.0, 0.0, temperature)),
        None,
        *(np.full(shape, value) for value in (0.0289647, 101325.0, 273.15)),
    )
    room = VolumeLimits(np.full(shape, clearance * volume), np.full(shape, (1 + clearance) * volume))
    nothing = np.zeros(shape)
    return CompressorStage(numbers, Rooms("gas", 2 * np.pi, room, nothing, nothing, nothing, None, None))


def test_pressure_between_two_stages():
    """1 to 9 bar, volumes 1 and 0.36, cooled to 40 °C between; found there by bisection, twice."""
    stages = [stage(1.0, 0.06, 293.15), stage(0.36, 0.08, 313.15)]
    low, high = np.array([[1e5]]), np.array([[9e5]])
    (pressure,) = interstage_pressures(stages, low, high)
    assert pressure[0, 0] == pytest.approx(304336.997180, rel=2e-12)
    for one, lines, part in zip(
        stages, ((low, pressure), (pressure, high)), (0.918758410139, 0.895790790244), strict=True
    ):
        assert capacity(one.between(*lines), one.rooms.limits)[0, 0, 0] == pytest.approx(part, rel=2e-12)
    assert stages[0].flow(low, pressure) == pytest.approx(stages[1].flow(pressure, high), rel=1e-14)


def test_three_stages_share_one_flow():
    stages = [stage(1.0, 0.06, 293.15), stage(0.36, 0.08, 313.15), stage(0.13, 0.09, 318.15)]
    low, high = np.array([[1e5]]), np.array([[27e5]])
    first, second = interstage_pressures(stages, low, high)
    flows = [
        one.flow(*lines) for one, lines in zip(stages, ((low, first), (first, second), (second, high)), strict=True)
    ]
    assert low < first < second < high
    assert flows[1] == pytest.approx(flows[0], rel=1e-13)
    assert flows[2] == pytest.approx(flows[0], rel=1e-13)


MECHANISM = {"kind": "slider_crank", "stroke": "160 mm", "rod_length": "400 mm", "offset": "12 mm"}
MASSES = {
    "piston": {"mass": "9 kg"},
    "rod": {"mass": "7 kg", "along": "120 mm", "inertia": "0.15 kg·m²"},
}


def machine(bores, throws, gas, shown):
    """Cylinders in one line on throws of their own; `shown` names the banks that are there."""
    ratios = dict(zip(bores, (17.6, 13.5), strict=True))
    throw = {name: i + 1 for i, name in enumerate(bores)}
    return ct.Machine(
        shaft={"main": {"speed": "720 rpm", "throws": throws}},
        bank={name: {"angle": "0 deg", "throws": [throw[name]], "mechanism": MECHANISM} for name in shown},
        cylinder={name: {"bore": bores[name], "compression_ratio": ratios[name]} for name in shown},
        masses=MASSES,
        gas=gas,
    )


def test_two_stages_in_one_file_are_two_machines_put_together():
    """Unequal bores on offset cranks; alone, each stage works between the lines that they find together."""
    bores, throws = {"low": "250 mm", "high": "150 mm"}, ["0 deg", "100 deg"]
    common = {"kind": "compressor", "compression_exponent": 1.3, "suction_loss": 0.03, "discharge_loss": 0.02}
    first, last = {"suction_pressure": "1 bar"}, {"discharge_pressure": "9 bar", "suction_temperature": "40 °C"}
    gas = {"low": common | first, "high": common | last | {"takes_from": "low"}}
    both = ct.run(machine(bores, throws, gas, bores))
    line = f"{float(both.discharge_line_pressure[0])!r} Pa"
    assert both.suction_line_pressure[1] == both.discharge_line_pressure[0]
    low = ct.run(machine(bores, throws[:1], common | first | {"discharge_pressure": line}, ["low"]))
    high = ct.run(machine(bores, throws, common | last | {"suction_pressure": line}, ["high"]))
    alone = (low, high)
    for name in (
        "indicated_work",
        "gas_pressure",
        "gas_force",
        "piston_force",
        "side_force",
        "rod_force_at_crank_pin",
        "joint_force_x",
        "joint_force_y",
    ):
        parts = [getattr(one, name) for one in alone]
        put_together = np.concatenate(parts, axis=max(-2, -parts[0].ndim))
        np.testing.assert_allclose(getattr(both, name), put_together, rtol=0, atol=1e-12 * np.max(np.abs(put_together)))
    for name in ("indicated_power", "shaft_torque"):
        summed = sum(getattr(one, name) for one in alone)
        np.testing.assert_allclose(getattr(both, name), summed, rtol=0, atol=1e-12 * np.max(np.abs(summed)))
    # Each stage brings the other what it takes: pV/T behind the cooler is that before it.
    flow = both.inlet_flow * both.suction_line_pressure / np.array([293.15, 313.15])
    assert flow[1] == pytest.approx(flow[0], rel=1e-12)
