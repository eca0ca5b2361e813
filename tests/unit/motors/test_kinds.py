"""Every kind of motor from its table: the motor that arrays give, in other words too, its heat and its current."""

import numpy as np
import pytest
from tests.motors import CAGE, CIRCUIT, EXAMPLES, ROTOR, SYNCHRONOUS
from tests.sentences import NOT_POSITIVE
from tests.told import texts_of
from tests.unit.motors.test_tables import PLATE, SHUNT, motor, problems, spec_of

from cranktrain.columns import in_columns
from cranktrain.linkage import compiled
from cranktrain.motors import KINDS, motor_of
from cranktrain.numerics.nested import mapped

SPEEDS = np.array([-60.0, 0.0, 31.0, 95.0, 140.0, 156.0, SYNCHRONOUS, 170.0, 192.0])
TIMES = (0.0, 0.7, 1.05, 5.0)

KLOSS = {
    "kind": "cage",
    "curve": "kloss",
    "breakdown_torque": "95 N·m",
    "breakdown_slip": 0.2,
    "synchronous_speed": "1500 rpm",
}
BY_CIRCUIT = {
    "kind": "circuit",
    "phase_voltage": "230 V",
    "stator_resistance": "0.9 Ω",
    "rotor_resistance": "0.7 Ω",
    "reactance": "2.6 Ω",
    "poles": 4,
}
SLIP_RINGS = {
    "kind": "wound_rotor",
    "breakdown_torque": "95 N·m",
    "breakdown_slip": 0.2,
    "frequency": "50 Hz",
    "poles": 4,
}
FULL_LOAD = {
    "speeds": ["60 rad/s", "90 rad/s", "130 rad/s", "190 rad/s"],
    "torques": ["0 N·m", "700 N·m", "800 N·m", "650 N·m"],
}
ENGINE = {
    "kind": "prime_mover",
    "torque": "655 N·m",
    "speed": "188 rad/s",
    "no_load_speed": "196 rad/s",
    "full_load": FULL_LOAD,
}
# At 24 rad/s R + cω is 2.2 Ω, which takes 100 A at 220 V; cI² is 500 N·m.
SERIES = {"kind": "series", "voltage": "220 V", "rated_current": "100 A", "torque": "500 N·m", "speed": "24 rad/s"}
SERVO = {"kind": "servo", "peak_torque": "20 N·m", "peak_power": "2 kW", "command": "30 N·m"}

TABLES = {
    "cage": PLATE,
    "circuit": BY_CIRCUIT,
    "star_delta": {**PLATE, "starter": {"kind": "star_delta", "change_time": "1 s", "pause": "100 ms"}},
    "soft_start": {
        **PLATE,
        "starting_current_ratio": 7.2,
        "starter": {"kind": "soft_start", "first_voltage": 0.4, "ramp_time": "2 s", "current_limit": 3},
    },
    "inverter": {
        **BY_CIRCUIT,
        "starter": {"kind": "inverter", "ramp_time": "2 s", "boost": "10 %", "torque_limit": "90 N·m"},
    },
    "flux_inverter": {**KLOSS, "starter": {"kind": "inverter", "ramp_time": "2 s", "torque_limit": "90 N·m"}},
    "wound_rotor": SLIP_RINGS,
    "stepped_rotor": {**SLIP_RINGS, "rheostat": {"steps": 3, "step_ratio": 2.5}},
    "timed_rotor": {**SLIP_RINGS, "rheostat": {"steps": 3, "step_ratio": 2.5, "interval": "0.5 s"}},
    "shunt": {"kind": "shunt", "torque": "200 N·m", "speed": "80 rad/s", "no_load_speed": "160 rad/s"},
    "series": SERIES,
    "servo": SERVO,
    "table": {"kind": "table", **FULL_LOAD},
    "prime_mover": ENGINE,
}
every_table = pytest.mark.parametrize("name", TABLES)


def test_every_law_has_a_table():
    assert {law.name for kind in KINDS for law in kind.laws} == set(TABLES)
    assert {kind.name for kind in KINDS} == {table["kind"] for table in TABLES.values()}


@every_table
@pytest.mark.parametrize("time", TIMES)
def test_a_table_gives_the_torque_of_the_arrays(name, time):
    found = motor(**TABLES[name])
    assert found.law.name == name
    expected = found.law.torque(SPEEDS, time, EXAMPLES[name])
    np.testing.assert_allclose(found.torque(SPEEDS, time)[0], expected, rtol=1e-12, atol=1e-11)


@every_table
def test_row_and_heat_compile(name):
    found = motor(**TABLES[name])
    torque = compiled(found.law.kernel)
    for time in TIMES:
        row = found.row(0)
        alone = [torque(w, time, row) if found.law.is_timed else torque(w, row) for w in SPEEDS.tolist()]
        np.testing.assert_allclose(alone, found.torque(SPEEDS, time)[0], rtol=1e-14, atol=1e-12)
        if found.heat is not None:
            heat = compiled(found.heat)
            alone = [heat(speed, time, row) for speed in SPEEDS.tolist()]
            np.testing.assert_allclose(alone, found.heating(SPEEDS, time)[0], rtol=1e-13, atol=1e-9)


def scaled(table, factor):
    """The same table with some of its torques changed."""
    changes = {"power": "11 kW", "torque": "210 N·m", "peak_torque": "30 N·m", "phase_voltage": "240 V"}
    own = {key: changes[key] for key in changes if key in table and key != "kind"}
    return {**table, **own, **({"breakdown_torque": f"{95 * factor} N·m"} if "breakdown_torque" in table else {})}


@pytest.mark.parametrize("name", sorted(TABLES.keys() - {"table", "prime_mover", "series"}))
def test_designs_together_give_what_each_gives_alone(name):
    specs = [spec_of(**TABLES[name]), spec_of(**scaled(TABLES[name], 1.1))]
    together = motor_of(in_columns(specs), 2)
    for time in TIMES:
        alone = [motor_of(spec) for spec in specs]
        for ask in ("torque", "heating", "current_ratio"):
            each = np.concatenate([np.broadcast_to(getattr(one, ask)(SPEEDS, time), (1, 9)) for one in alone])
            np.testing.assert_array_equal(getattr(together, ask)(SPEEDS, time), each, ask)


@pytest.mark.parametrize("name", ["star_delta", "soft_start", "flux_inverter", "timed_rotor"])
def test_unless_a_time_is_given_it_is_long_since_on(name):
    found = motor(**TABLES[name])
    np.testing.assert_array_equal(found.torque(SPEEDS), found.torque(SPEEDS, 1e6))
    np.testing.assert_array_equal(found.heating(SPEEDS), found.heating(SPEEDS, 1e6))


class TestHeatAndCurrent:
    def test_of_slip_rings_the_rotor_has_its_part(self):
        found = motor(**SLIP_RINGS, resistance_ratio=2.5)
        all_heat = found.torque(SPEEDS) * (SYNCHRONOUS - SPEEDS)
        np.testing.assert_allclose(found.heating(SPEEDS), all_heat / 2.5, rtol=1e-13)

    def test_circuit_takes_what_it_gives_and_heats(self):
        """The line's power by phasors: current in phase with the voltage."""
        found, speeds = motor(**BY_CIRCUIT), SPEEDS[:4]
        slip = 1 - speeds / SYNCHRONOUS
        current = 230.0 / (0.9 + 0.7 / slip + 2.6j)
        taken = 3 * 230.0 * np.real(current)
        given = found.torque(speeds)[0] * speeds
        np.testing.assert_allclose(found.heating(speeds)[0], taken - given, rtol=1e-12)

    def test_current_of_a_circuit_is_one_at_its_rated_speed(self):
        found = motor(**BY_CIRCUIT, torque="60 N·m", speed="1420 rpm")
        assert found.current_ratio(np.array([1420 * np.pi / 30]))[0, 0] == pytest.approx(1.0, rel=1e-14)

    def test_shunt_takes_what_it_gives_and_heats(self):
        """Armature of 0.5 Ω at 220 V, with k = U/ω₀: current by Ohm's law."""
        k = 220.0 / 160.0
        stall = k * 220.0 / 0.5
        table = {"kind": "shunt", "torque": f"{stall / 16!r} N·m", "speed": "150 rad/s", "no_load_speed": "160 rad/s"}
        found, speeds = motor(**table), np.array([0.0, 80.0, 150.0])
        current = (220.0 - k * speeds) / 0.5
        np.testing.assert_allclose(found.heating(speeds)[0], 0.5 * current**2, rtol=1e-12)
        np.testing.assert_allclose(found.current_ratio(speeds)[0], current / current[2], rtol=1e-12)

    def test_series(self):
        found, speeds = motor(**SERIES), np.array([0.0, 24.0, 100.0])
        current = 220.0 / (1.0 + 0.05 * speeds)
        np.testing.assert_allclose(found.heating(speeds)[0], current**2, rtol=1e-12)
        np.testing.assert_allclose(found.current_ratio(speeds)[0], current / 100.0, rtol=1e-12)
        assert found.top_speed[0] == np.inf

    def test_current_in_star_is_a_third(self):
        found = motor(**TABLES["star_delta"], starting_current_ratio=7.2)
        ratios = [found.current_ratio(np.zeros(1), time)[0, 0] for time in (0.5, 1.05, 2.0)]
        assert ratios == pytest.approx([2.4, 0.0, 7.2], rel=1e-14)

    def test_current_behind_a_soft_starter_is_at_its_limit(self):
        assert motor(**TABLES["soft_start"]).current_ratio(np.zeros(1), 5.0)[0, 0] == pytest.approx(3.0, rel=1e-14)

    def test_inverter_at_its_limit_has_the_slip_of_that_torque(self):
        """90 of 95 N·m at a standing shaft under full frequency: s/s_b + s_b/s = 2·95/90."""
        found = motor(**TABLES["flux_inverter"])
        slip = 0.2 * np.min(np.real(np.roots([1.0, -2 * 95 / 90, 1.0])))
        limited = SYNCHRONOUS * (1 - 0.19)
        assert found.torque(np.array([limited]), 5.0)[0, 0] == 90.0
        assert found.heating(np.array([limited]), 5.0)[0, 0] == pytest.approx(90 * slip * SYNCHRONOUS, rel=1e-12)

    def test_servo_current_is_in_proportion_to_its_torque(self):
        found = motor(**SERVO, torque="8 N·m", speed="100 rad/s")
        assert found.current_ratio(np.array([0.0, 200.0]))[0] == pytest.approx([2.5, 1.25], rel=1e-14)


class TestOtherWords:
    def test_slip_rings_by_plate(self):
        """Through the rated point by a breakdown ratio: s_b = s_n (m_b + √(m_b² − 1))."""
        plate = {"kind": "wound_rotor", "power": "7.5 kW", "speed": "1425 rpm", "breakdown_ratio": 2.5}
        found = motor(**plate)
        assert found.numbers.breakdown_slip[0] == pytest.approx(0.05 * (2.5 + np.sqrt(5.25)), rel=1e-12)
        assert found.torque(found.rating.speed[:, np.newaxis])[0, 0] == pytest.approx(found.rating.torque[0], rel=1e-12)

    def test_rheostat_by_its_peak_is_that_of_the_reference(self):
        plate = {"kind": "wound_rotor", "power": "7.5 kW", "speed": "1455 rpm", "breakdown_ratio": 2.5}
        found = motor(**plate, rheostat={"steps": 3, "peak_ratio": 2})
        assert found.numbers.rheostat.step_ratio[0] == pytest.approx(2.554364774645177, rel=1e-12)
        (flag,) = texts_of(found.flags)
        assert "0.783 times the rated torque" in flag

    def test_engine_by_power(self):
        by_power = {**{key: ENGINE[key] for key in ENGINE if key != "torque"}, "power": f"{655 * 188} W"}
        np.testing.assert_allclose(motor(**by_power).torque(SPEEDS), motor(**ENGINE).torque(SPEEDS), rtol=1e-13)

    def test_inverter_to_another_speed(self):
        starter = {"kind": "inverter", "ramp_time": "2 s", "first_speed": "300 rpm", "last_speed": "900 rpm"}
        found = motor(**KLOSS, starter=starter)
        assert found.torque(np.array([30 * np.pi]), 9.0)[0, 0] == pytest.approx(0.0, abs=1e-11)
        assert found.top_speed[0] == pytest.approx(30 * np.pi, rel=1e-15)


@pytest.mark.parametrize(
    ("table", "path", "said"),
    [
        ({**PLATE, "starter": {"kind": "star"}}, "motor.starter.kind", "must be one of: star_delta"),
        (
            {**PLATE, "starter": {"kind": "star_delta", "change_time": "-1 s"}},
            "motor.starter.change_time",
            NOT_POSITIVE,
        ),
        ({**PLATE, "starter": {"kind": "star_delta"}}, "motor.starter.change_time", "must be a time in s, ms, min, h"),
        ({**PLATE, "starter": {"kind": "soft_start"}}, "motor.starter.current_limit", "or first_voltage and ramp_time"),
        (
            {**PLATE, "starter": {"kind": "soft_start", "ramp_time": "2 s"}},
            "motor.starter.first_voltage",
            "ramp_time needs it",
        ),
        (
            {**PLATE, "starter": {"kind": "soft_start", "current_limit": 3}},
            "motor.starting_current_ratio",
            "current_limit needs it",
        ),
        ({**BY_CIRCUIT, "reactance": "2.6 N"}, "motor.reactance", "must be an electric resistance in Ω"),
        ({key: BY_CIRCUIT[key] for key in BY_CIRCUIT if key != "poles"}, "motor.synchronous_speed", "is missing"),
        ({"kind": "wound_rotor"}, "motor.breakdown_ratio", "is missing"),
        ({**SLIP_RINGS, "rheostat": {"steps": 3}}, "motor.rheostat.peak_ratio", "give peak_ratio or step_ratio"),
        ({**SLIP_RINGS, "rheostat": {"steps": 3, "peak_ratio": 2}}, "motor.rheostat.peak_ratio", "rated point"),
        ({**SLIP_RINGS, "rheostat": {"steps": 0, "step_ratio": 2}}, "motor.rheostat.steps", "must be at least 1"),
        ({**SHUNT, "power": "1 kW"}, "motor.torque", "must not stand beside power"),
        ({"kind": "shunt", "no_load_speed": "1500 rpm"}, "motor.torque", "is missing; must be a torque"),
        ({**SERIES, "rated_current": "50 A"}, "motor.rated_current", "11 kW is not above 12 kW"),
        ({**SERVO, "torque": "25 N·m", "speed": "50 rad/s"}, "motor.peak_torque", "not be below the rated torque"),
        ({**SERVO, "torque": "5 N·m", "speed": "500 rad/s"}, "motor.peak_power", "not be below the rated power"),
        (
            {**SERVO, "torque": "5 N·m", "speed": "50 rad/s", "top_speed": "300 rpm"},
            "motor.top_speed",
            "not be below speed = 50 rad/s",
        ),
        ({**ENGINE, "no_load_speed": "180 rad/s"}, "motor.no_load_speed", "the governor's droop"),
        ({**ENGINE, "torque": "700 N·m"}, "motor.full_load.torques", "655 N·m there, for 700 N·m"),
        (
            {**ENGINE, "full_load": {"speeds": ["90 rad/s", "60 rad/s"], "torques": ["1 N·m", "900 N·m"]}},
            "motor.full_load.speeds[1]",
            "more than the speed before it",
        ),
    ],
)
def test_what_is_wrong_is_told_by_its_path(table, path, said):
    assert said in problems(**table)[path]


def test_numbers_of_a_row_are_plain():
    rows = [motor(**TABLES[name]).row(0) for name in ("soft_start", "flux_inverter", "timed_rotor")]
    for row in rows:
        mapped(lambda _name, value: pytest.fail() if type(value) is not float else value, row)
    assert motor(**BY_CIRCUIT).row(0) == pytest.approx(CIRCUIT, rel=1e-15)
    assert motor(**SLIP_RINGS).row(0) == pytest.approx(ROTOR, rel=1e-15)
    assert motor(**PLATE).row(0) == pytest.approx(CAGE, rel=1e-13)
