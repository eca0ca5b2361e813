"""Tables of a piston's forces: closed forms at round angles, units, masters and slaves, errors of two harmonics."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.plans.force_table import force_table

PUMP = {
    "shaft": {"main": {"speed": "100 rad/s"}},
    "mechanism": {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "130 mm"},
    "masses": {"piston": {"mass": "2 kg"}},
}
YOKE = {"kind": "scotch_yoke", "crank_radius": "50 mm"}


def column(table, symbol):
    return next(one for one in table.columns if one.symbol == symbol)


def test_closed_forms_of_inertia():
    """−m s″ω² at 0°, 90° and 180°: mRω²(1 + λ) away, mRω² tan β toward, mRω²(1 − λ) toward the shaft."""
    table = force_table(ct.Machine(**PUMP), step=30.0)
    assert table.angle.tolist() == list(range(0, 360, 30))
    unit = 2.0 * 0.05 * 1e4
    ratio = 5.0 / 13.0
    exact, textbook = column(table, "P").exact, column(table, "P").two_harmonics
    assert exact[[0, 3, 6]] == pytest.approx([-unit * (1 + ratio), unit * 5 / 12, unit * (1 - ratio)])
    assert textbook[[0, 3, 6]] == pytest.approx([-unit * (1 + ratio), unit * ratio, unit * (1 - ratio)])
    error = column(table, "P").two_harmonics_error[3]
    assert error == pytest.approx((ratio - 5 / 12) / (1 + ratio))
    assert column(table, "N").exact[3] == pytest.approx(unit * 5 / 12 * 5 / 12)
    assert column(table, "S").exact[3] == pytest.approx(unit * 5 / 12 * 13 / 12)
    assert column(table, "T").exact[3] == pytest.approx(unit * 5 / 12)
    assert column(table, "K").exact[3] == pytest.approx(-unit * (5 / 12) ** 2)
    assert column(table, "M").exact[3] == pytest.approx(unit * 5 / 12 * 0.05)
    for one in table.columns:
        assert one.textbook == pytest.approx(one.exact, abs=1e-9)
    assert (column(table, "P").unit, column(table, "M").unit) == ("N", "N·m")


@pytest.mark.parametrize("step", [10.0, 15.0, 30.0])
def test_over_the_pistons_area(step):
    """9.80665 N on 1 cm² are 1 kgf/cm², and 0.0980665 MPa."""
    engine = ct.load("vaz_21213")
    newtons, pressures, kilograms = (force_table(engine, step=step, unit=unit) for unit in ("N", "MPa", "kgf/cm2"))
    area = np.pi / 4 * 0.082**2
    assert len(newtons.angle) == 720 / step
    assert newtons.area is None
    assert pressures.area == pytest.approx(area)
    for symbol in "PNSKT":
        force = column(newtons, symbol).exact
        assert column(pressures, symbol).exact == pytest.approx(force / area / 1e6)
        assert column(kilograms, symbol).exact == pytest.approx(force / 9.80665 / (area * 1e4))
        assert column(pressures, symbol).textbook_error == pytest.approx(column(newtons, symbol).textbook_error)
    assert column(kilograms, "M").exact == pytest.approx(column(newtons, "M").exact / 9.80665)
    assert (kilograms.unit, column(kilograms, "M").unit) == ("kgf/cm²", "kgf·m")


def test_each_piston():
    engine = ct.load("3d12")
    first, third = (force_table(engine, piston=name) for name in ("1L", "3L"))
    shift = round(float(ct.run(engine, quantities="firing_angle").firing_angle[2]) / 30.0)
    assert np.roll(column(first, "P").exact, shift) == pytest.approx(column(third, "P").exact, rel=1e-9)


def test_a_master_and_its_slave():
    """At 438° the pin bears 63.0 and 27.0 kN, where the formula has −0.04 and 0.63 for the master alone."""
    engine = ct.load("3d12")
    master, slave = (force_table(engine, piston=name, step=10.0, unit="kN") for name in ("1L", "1R"))
    assert "".join(one.symbol for one in master.columns) == "PNSS_AKTM"
    assert [one.symbol for one in slave.columns] == ["P", "N", "S", "K_i", "T_i", "M_i"]
    assert (master.sort, slave.sort) == ("master", "slave")
    result = ct.run(engine)
    at = result.labels["mechanism"].index
    kept = np.arange(0, 720, 10)
    assert column(master, "K").exact == pytest.approx(result.crankpin_radial_without_rod[at("1L"), kept] / 1e3)
    assert column(master, "T").exact == pytest.approx(result.crankpin_load_tangential[at("1L"), kept] / 1e3)
    assert column(slave, "T_i").exact == pytest.approx(result.crankpin_share_tangential[at("1R"), kept] / 1e3)
    # Torque of the throw: that of the master's pin, of which the slave's share is a part.
    torque = result.mechanism_torque[[at("1L"), at("1R")]][:, kept]
    assert column(master, "M").exact == pytest.approx(np.sum(torque, axis=0))
    assert column(master, "M").textbook + column(slave, "M_i").exact == pytest.approx(np.sum(torque, axis=0))
    assert np.max(np.abs(column(master, "T").textbook_error)) > 0.75
    assert np.all(np.isnan(column(slave, "N").textbook_error))


def test_what_is_refused():
    engine, pump = ct.load("3d12"), ct.Machine(**PUMP)
    for machine, options, said in (
        (engine, {"unit": "ati"}, "--forces = ati: must be one of: N, kN, kgf"),
        (engine, {"step": 7.0}, "--step = 7: must be one of: 10, 15, 30"),
        (engine, {"piston": "1X"}, "--piston = 1X: must be one of: 1L"),
        (ct.Machine(**PUMP | {"mechanism": YOKE}), {}, "this machine has no piston with a rod"),
        (pump, {"unit": "MPa"}, "cylinder.bore: is missing"),
        (ct.load("jaw_crusher"), {}, "this machine has no piston with a rod"),
    ):
        with pytest.raises(InputError, match=said):
            force_table(machine, **options)
