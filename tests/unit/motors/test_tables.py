"""Motors as the machine file has them: what their tables say, and what is wrong with them."""

import json
from pathlib import Path

import numpy as np
import pytest
from pydantic import Field
from tests.sentences import NOT_POSITIVE
from tests.told import texts_of

from cranktrain.columns import in_columns
from cranktrain.errors import InputError
from cranktrain.motors import AnyMotor, motor_of
from cranktrain.spec import Spec, validated

REFERENCE = json.loads((Path(__file__).parents[2] / "golden/drive/motor.json").read_text(encoding="utf-8"))
SYNCHRONOUS = 50 * np.pi
PLATE = {
    "kind": "cage",
    "power": "7.5 kW",
    "speed": "1465 rpm",
    "breakdown_ratio": 3.0,
    "starting_ratio": 2.3,
    "pull_up_ratio": 1.8,
}
SHUNT = {"kind": "shunt", "torque": "50 N·m", "speed": "150 rad/s", "no_load_speed": "160 rad/s"}
TABLE = {"kind": "table", "speeds": ["0 rpm", "1000 rpm", "1500 rpm"], "torques": ["30 N·m", "60 N·m", "-60 N·m"]}
NO_PULL_UP = {key: value for key, value in PLATE.items() if key != "pull_up_ratio"}
SLIPS = np.array([0.01, 0.05, 0.1, 0.3, 0.5, 0.9])
BY_SLIP = [0.4388147912, 1.9432639354, 2.8635809349, 2.8165447558, 2.3135175579, 1.95625]
"""Torques at these slips over the rated one, by the reference."""
SPEEDS = np.linspace(-50.0, 200.0, 26)


class OneMotor(Spec, frozen=True):
    """A table that has a motor."""

    motor: AnyMotor = Field(description="What is tried.")


def spec_of(**table):
    return validated(OneMotor, {"motor": table}).motor


def motor(**table):
    return motor_of(spec_of(**table))


def problems(**table):
    with pytest.raises(InputError) as refused:
        spec_of(**table)
    return {problem.path: str(problem) for problem in refused.value.problems}


def without(key, **other):
    return {name: value for name, value in {**PLATE, **other}.items() if name != key}


class TestCage:
    def test_catalogue_values_of_the_reference(self):
        found = motor(**PLATE)
        torque = found.torque(SYNCHRONOUS * (1 - SLIPS))[0] / found.rating.torque
        np.testing.assert_allclose(torque, BY_SLIP, rtol=2e-10)
        assert found.rating.torque[0] == pytest.approx(REFERENCE["catalogue_fit"]["Tn"], rel=1e-14)
        assert found.numbers.breakdown_slip[0] == pytest.approx(
            REFERENCE["catalogue_fit"]["kloss_from_rated"]["sb"], rel=1e-13
        )

    def test_kloss_by_two_numbers_has_the_start_of_the_reference(self):
        found = motor(
            kind="cage", curve="kloss", breakdown_torque="95 N·m", breakdown_slip=0.2, synchronous_speed="1500 rpm"
        )
        star = REFERENCE["star_delta"]["start_torque_star"]
        assert found.torque(np.zeros(1))[0, 0] / 3 == pytest.approx(star, rel=1e-14)
        assert np.isnan(found.rating.torque[0])

    def test_kloss_in_full_has_the_generating_peak_of_the_circuit(self):
        case = REFERENCE["kloss_full_vs_circuit"]
        found = motor(
            kind="cage",
            curve="kloss_full",
            synchronous_speed="1500 rpm",
            breakdown_torque=f"{case['Tb']!r} N·m",
            breakdown_slip=case["sb"],
            asymmetry=case["eps"],
        )
        slips = np.array([1.0, -case["sb"]])
        expected = [case["T_start"], case["T_at_minus_sb"]]
        np.testing.assert_allclose(found.torque(SYNCHRONOUS * (1 - slips))[0], expected, rtol=1e-13)

    def test_kloss_through_rated_point_and_start(self):
        plate = {
            **NO_PULL_UP,
            "speed": "1350 rpm",
            "starting_ratio": 1.5,
            "curve": "kloss_full",
            "breakdown_ratio": 2.0,
        }
        found = motor(**plate)
        ratios = found.torque(np.array([0.0, 45 * np.pi]))[0] / found.rating.torque
        np.testing.assert_allclose(ratios, [1.5, 1.0], rtol=1e-12)

    @pytest.mark.parametrize(
        "other",
        [
            without("power", torque=f"{7500 / (1465 * np.pi / 30)!r} N·m"),
            {**PLATE, "power": "7500 W"},
            {**PLATE, "speed": f"{1465 * np.pi / 30!r} rad/s"},
            {**PLATE, "frequency": "50 Hz"},
            {**PLATE, "poles": 4},
            {**PLATE, "frequency": "50 Hz", "poles": 4},
            {**PLATE, "synchronous_speed": "1500 rpm"},
            {**PLATE, "breakdown_ratio": "300 %"},
        ],
    )
    def test_one_motor_in_other_words(self, other):
        np.testing.assert_allclose(motor(**other).torque(SPEEDS), motor(**PLATE).torque(SPEEDS), rtol=1e-12)

    def test_sixty_hertz_by_poles_or_by_the_nearest(self):
        plate = {**PLATE, "speed": "1750 rpm", "frequency": "60 Hz"}
        assert motor(**plate).top_speed[0] == pytest.approx(60 * np.pi, rel=1e-15)
        assert motor(**plate, poles=4).top_speed[0] == pytest.approx(60 * np.pi, rel=1e-15)

    def test_a_guessed_synchronous_speed_is_told(self):
        assert texts_of(motor(**PLATE).notes) == (
            "The synchronous speed is 1500 rpm, the nearest above the rated one.",
        )
        assert motor(**PLATE, poles=4).notes == ()

    def test_size_is_a_typical_motor_that_the_maker_s_numbers_replace(self):
        typical = motor(kind="cage", size="4 kW")
        assert typical.rating.torque[0] == pytest.approx(26.1625, abs=5e-5)
        assert "typical" in str(typical.notes[0])
        own = motor(kind="cage", size="4 kW", starting_ratio=1.9, pull_up_ratio=1.7, inertia="0.02 kg·m²")
        assert own.torque(np.zeros(1))[0, 0] == pytest.approx(1.9 * own.rating.torque[0], rel=1e-15)
        assert own.inertia[0] == 0.02
        assert typical.inertia[0] != 0.02

    def test_voltage_acts_by_its_square_at_every_slip(self):
        low = motor(**PLATE, voltage_ratio=0.9)
        np.testing.assert_allclose(low.torque(SPEEDS), 0.81 * motor(**PLATE).torque(SPEEDS), rtol=1e-14)
        assert low.rating.torque[0] == motor(**PLATE).rating.torque[0]

    def test_flywheel_moment_is_four_inertias(self):
        by_moment, by_inertia = motor(**PLATE, flywheel_moment="0.12 kgf·m²"), motor(**PLATE, inertia="0.03 kg·m²")
        assert by_moment.inertia[0] == pytest.approx(by_inertia.inertia[0], rel=1e-15)

    def test_heat_of_the_cage_is_torque_times_slip_speed(self):
        found = motor(**PLATE)
        np.testing.assert_allclose(found.heating(SPEEDS), found.torque(SPEEDS) * (SYNCHRONOUS - SPEEDS), rtol=1e-14)

    def test_current_falls_from_that_at_standstill(self):
        found = motor(**PLATE, starting_current_ratio=7.2)
        assert found.current_ratio(np.zeros(1))[0, 0] == pytest.approx(7.2, rel=1e-15)
        assert np.isnan(motor(**PLATE).current_ratio(SPEEDS)).all()

    def test_contradiction_of_the_reference_is_told(self):
        (flag,) = texts_of(motor(**NO_PULL_UP, curve="kloss").flags)
        assert "0.80 times the rated torque at standstill, where the plate says 2.3" in flag

    def test_formula_that_misses_the_rated_point_is_told(self):
        plate = {"kind": "cage", "power": "7.5 kW", "speed": "1465 rpm", "curve": "kloss", "breakdown_torque": "95 N·m"}
        (flag,) = texts_of(motor(**plate, breakdown_slip=0.2).flags)
        assert "at the rated speed" in flag


class TestShunt:
    def test_line_through_both_points(self):
        np.testing.assert_allclose(
            motor(**SHUNT).torque(np.array([0.0, 150.0, 160.0, 170.0]))[0], [800.0, 50.0, 0.0, -50.0], atol=1e-11
        )

    def test_by_power(self):
        by_power = {**{key: SHUNT[key] for key in ("kind", "speed", "no_load_speed")}, "power": "7.5 kW"}
        np.testing.assert_allclose(motor(**by_power).torque(SPEEDS), motor(**SHUNT).torque(SPEEDS), rtol=1e-13)


class TestTable:
    def test_straight_lines_and_where_it_drives_no_more(self):
        found = motor(**TABLE)
        speeds = np.array([-10.0, 0.0, 500.0, 1000.0, 1250.0, 1400.0, 1600.0]) * np.pi / 30
        np.testing.assert_allclose(found.torque(speeds)[0], [30, 30, 45, 60, 0, -36, -60], atol=1e-12)
        assert found.top_speed[0] == pytest.approx(1250 * np.pi / 30, rel=1e-14)

    def test_no_top_speed_where_it_still_drives(self):
        assert motor(**{**TABLE, "torques": ["30 N·m", "60 N·m", "1 N·m"]}).top_speed[0] == np.inf


VARIED = [
    (PLATE, {"power": "11 kW", "speed": "980 rpm", "breakdown_ratio": 2.5}),
    ({"kind": "cage", "size": "4 kW"}, {"size": "15 kW"}),
    (SHUNT, {"torque": "60 N·m", "no_load_speed": "170 rad/s"}),
    (TABLE, {"speeds": ["0 rpm", "900 rpm", "1600 rpm"]}),
]


@pytest.mark.parametrize(("table", "change"), VARIED)
def test_designs_together_give_what_each_gives_alone(table, change):
    specs = [spec_of(**table), spec_of(**{**table, **change})]
    alone = [motor_of(spec) for spec in specs]
    together = motor_of(in_columns(specs), 2)
    np.testing.assert_array_equal(
        together.torque(SPEEDS), np.concatenate([each.torque(SPEEDS) for each in alone]), strict=True
    )
    np.testing.assert_array_equal(together.rating.power, [each.rating.power[0] for each in alone])
    np.testing.assert_array_equal(together.top_speed, [each.top_speed[0] for each in alone])


@pytest.mark.parametrize(("table", "change"), VARIED)
def test_row_gives_the_kernel_s_numbers_of_one_design(table, change):
    together = motor_of(in_columns([spec_of(**table), spec_of(**{**table, **change})]), 2)
    for design in (0, 1):
        alone = [together.law.torque(speed, 0.0, together.row(design)) for speed in SPEEDS]
        np.testing.assert_allclose(alone, together.torque(SPEEDS)[design], rtol=1e-14)


@pytest.mark.parametrize(
    ("table", "path", "said"),
    [
        ({**PLATE, "kind": "gace"}, "motor.kind", "must be one of: cage"),
        (without("kind"), "motor.kind", "is missing; must be one of: cage"),
        ({"kind": "cage"}, "motor.power", "give power and speed of the plate, or size"),
        (without("speed"), "motor.speed", "is missing; must be a speed of rotation"),
        ({**PLATE, "torque": "48 N·m"}, "motor.torque", "must not stand beside power"),
        ({**PLATE, "breakdown_ratio": 0.9}, "motor.breakdown_ratio", "must be more than 1"),
        ({**PLATE, "efficiency": 1.2}, "motor.efficiency", "must be at most 1"),
        ({**PLATE, "efficiency": 0}, "motor.efficiency", NOT_POSITIVE),
        ({**PLATE, "pull_up_slip": 0.1}, "motor.pull_up_slip", "more than the breakdown slip 0.136"),
        ({**PLATE, "synchronous_speed": "1400 rpm"}, "motor.synchronous_speed", "above speed = 1465 rpm"),
        ({**PLATE, "poles": 6}, "motor.poles", "above speed = 1465 rpm, not 1000 rpm"),
        ({**PLATE, "poles": 3}, "motor.poles", "must be a multiple of 2"),
        ({**PLATE, "speed": "1750 rpm"}, "motor.synchronous_speed", "not within 10 %"),
        ({**PLATE, "asymmetry": 2}, "motor.asymmetry", "must be less than 2"),
        ({**PLATE, "asymmetry": 1}, "motor.asymmetry", 'is for curve = "kloss"'),
        ({**NO_PULL_UP, "curve": "kloss_full"}, "motor.curve", 'write curve = "catalogue"'),
        ({**PLATE, "starting_ratio": 3.5}, "motor.starting_ratio", "at most breakdown_ratio = 3"),
        ({**PLATE, "pull_up_ratio": 2.5}, "motor.pull_up_ratio", "at most starting_ratio = 2.3"),
        (
            {**PLATE, "inertia": "1 kg·m²", "flywheel_moment": "4 kgf·m²"},
            "motor.flywheel_moment",
            "must not stand beside inertia",
        ),
        ({"kind": "cage", "size": "8 kW"}, "motor.size", 'write "7.5 kW"'),
        ({"kind": "cage", "size": "4 kW", "speed": "1400 rpm"}, "motor.speed", "must not stand beside size"),
        ({**SHUNT, "no_load_speed": "140 rad/s"}, "motor.no_load_speed", "must be more than speed"),
        (
            {**TABLE, "speeds": ["0 rpm", "900 rpm", "900 rpm"]},
            "motor.speeds[2]",
            "more than the speed before it, 900 rpm",
        ),
        ({**TABLE, "torques": ["1 N·m", "2 N·m"]}, "motor.torques", "must be as many as speeds, 3"),
    ],
)
def test_what_is_wrong_is_told_by_its_path(table, path, said):
    assert said in problems(**table)[path]


def test_everything_at_once():
    found = problems(**{**PLATE, "starting_ratio": 3.5, "poles": 6, "torque": "1 N·m", "breakdown_slip": 0.2})
    assert found.keys() == {f"motor.{key}" for key in ("starting_ratio", "poles", "torque", "breakdown_slip")}
