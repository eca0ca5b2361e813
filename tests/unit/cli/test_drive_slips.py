"""Slips in the tables of a drive, as typed: what is refused, and what an answer says that it leaves out."""

from pathlib import Path

import pytest
from tests.sentences import CANNOT_CLOSE

from cranktrain import examples
from cranktrain.questions.start import starting

EXAMPLES = Path(examples.__file__).parent
PRESS = "high_slip_press"
SERVO = "servo_press_rocking"
UNIT = "pumping_unit_c57"
TABLE = 'drive.motor={{kind="table", speeds=["0 rpm", "1500 rpm"], torques=["{}", "{}"]}}'


def settings(*each):
    return [part for one in each for part in ("--set", one)]


@pytest.mark.parametrize(
    ("machine", "setting", "said"),
    [
        (SERVO, TABLE.format("-90 N*m", "-50 N*m"), "or it never drives"),
        (SERVO, TABLE.format("0 N*m", "0 N*m"), "or it never drives"),
        ("tilting_table", "drive.part.coupling.on=crank", 'on = crank: must be "motor" or the number of a stage'),
        ("tilting_table", "drive.part.coupling.on=0", 'on = 0: must be "motor" or the number of a stage'),
        (SERVO, "shaft.main.motion.piece[0].to=60 mm", "60.00 mm: must go to and fro"),
        (UNIT, "mechanism.load_radius=50 in", "hangs off an arc of 64 in, and load_radius = 50 in"),
    ],
)
def test_refused(typed, machine, setting, said):
    answer = typed("run", machine, *settings(setting))
    assert answer.status == 2
    assert said in answer.errors


def test_a_travel_too_short_is_told_in_its_own_unit(typed):
    """docs: the stroke of 49.5242099 in."""
    short = settings("load.invented_card.travel[3]=49.4 in", "load.invented_card.travel[4]=49.51 in")
    assert "49.51 in: must go as far as the part goes, 49.52421 in" in typed("run", UNIT, *short).errors


def test_links_that_stay_open_are_told_alone(typed):
    answer = typed("run", UNIT, *settings("mechanism.crank_radius=60 in"))
    assert CANNOT_CLOSE in answer.errors
    assert "must go as far" not in answer.errors


def test_a_piece_that_is_too_short_to_be_followed(typed):
    """A part in 100000 of 2 s is 20 µs."""
    answer = typed("run", "servo_press", *settings("shaft.main.motion.piece[2].duration=1 us"))
    assert answer.status == 2
    answer = typed("run", "servo_press", *settings("shaft.main.motion.piece[2].duration=0.01 ms"))
    assert "piece[2].duration = 0.01 ms: must be at least 1.85e-05 s" in answer.errors


def test_a_number_of_starts_without_a_unit_is_an_hour_s(typed):
    answer = typed("run", "tilting_table", *settings("drive.duty={starts_per_hour=30}"))
    assert 'write "30 1/h"' in answer.errors


def test_peaks_below_the_rated_point_are_told_with_it(typed):
    """100 N·m at 2000 rpm are 20.94 kW."""
    plate = 'kind="servo", torque="100 N*m", speed="2000 rpm", peak_torque="50 N*m", peak_power="10 kW"'
    answer = typed("run", SERVO, *settings(f"drive.motor={{{plate}}}"))
    assert "peak_torque = 50 N*m: must not be below the rated torque, 100 N·m" in answer.errors
    assert "peak_power = 10 kW: must not be below the rated power, 20.94395 kW" in answer.errors


def test_a_motor_that_is_off_is_not_reversed(typed):
    answer = typed("start", "tilting_table", *settings("drive.start.motor_off=1 s", "drive.start.motor_reversed=2 s"))
    assert "motor_reversed = 2 s: must be before motor_off = 1 s" in answer.errors


@pytest.mark.parametrize(
    ("machine", "given", "said"),
    [
        ("servo_press", (), "[drive.motor] is missing: what acts is loads and weights alone."),
        ("servo_press", (), "[shaft.main.motion] is not followed"),
        ("tilting_table", ('drive.brake={torque="100 N*m"}',), "[drive.brake] stays off"),
        ("tilting_table", ('drive.clutch={on="motor", torque="100 N*m"}',), "[drive.clutch] stays locked"),
        (
            "tilting_table",
            ("drive.start.duration=1 s", "drive.start.motor_off=10 s"),
            "motor_off = 10 s is not reached.",
        ),
        ("tilting_table", ("drive.start.duration=1 s", "drive.start.until_speed=100 rpm"), "until_speed = 100 rpm is"),
        (
            "shaking_conveyor",
            ('drive.motor.starter={kind="star_delta", change_time="50 s"}',),
            "Its starter is not through yet",
        ),
        (PRESS, ('drive.motor.starter={kind="star_delta", change_time="1 s"}',), "Its starter is left out"),
        (
            "servo_press",
            (TABLE.format("90 N*m", "40 N*m"), "drive.start.duration=8 s"),
            "The motor runs beyond its table",
        ),
    ],
)
def test_a_start_says_what_it_leaves_out(typed, machine, given, said):
    answer = typed("start", machine, *settings(*given))
    assert answer.status == 0, answer.errors
    assert said in " ".join(answer.output.split())


@pytest.mark.parametrize("machine", ["tilting_table", PRESS, "jaw_crusher"])
def test_a_start_that_leaves_nothing_out_says_nothing(typed, machine):
    assert "\n  mind " not in typed("start", machine).output


def test_a_start_without_a_drive_is_told_with_the_file(typed):
    assert "pumping_unit_c57:1:1  drive: is missing" in typed("start", UNIT).errors


def test_a_start_ends_after_so_many_steps(typed, monkeypatch):
    monkeypatch.setattr(starting, "MOST_STEPS", 50)
    answer = typed("start", "tilting_table")
    assert "60000 steps are over, the most of a start" in " ".join(answer.output.split())
    assert "in 50 steps" in answer.output


def test_what_is_left_over_is_judged_by_what_moved(typed, written):
    """A crank that swings under its load alone takes as much as it gives: what was given is no measure."""
    table = (EXAMPLES / "tilting_table.toml").read_text(encoding="utf-8").partition("# From the motor")[0]
    answer = typed("start", str(written(f"{table}[drive.start]\nduration = '3 s'\nangle = '90 deg'\n")))
    output = " ".join(answer.output.split())
    assert float(output.partition("energy left over: ")[2].split()[0]) < 1e-6


def test_a_stroke_without_a_command_says_so(typed):
    answer = typed("start", PRESS, *settings("drive.stroke.strokes_per_minute=5000"))
    assert "No strokes at 5000 a minute" in " ".join(answer.output.split())
    assert "brake                is not commanded" in answer.output


def test_another_pace_than_the_declared_one_is_said(typed):
    answer = typed("run", "shaking_conveyor", "--full", *settings("drive.stage[0].ratio=20"))
    assert "rpm, not at the declared 60.0 rpm." in " ".join(answer.output.split())
    assert "not at the declared" not in typed("run", "shaking_conveyor", "--full").output


def test_running_beyond_a_table_is_said(typed):
    """A motor that drives at the end of its table runs on behind it."""
    motor = TABLE.format("90 N*m", "40 N*m")
    answer = typed("run", SERVO, "--full", *settings(motor, "drive.stage[0].ratio=60"))
    assert "The motor runs beyond its table, 0.0 rpm to 1500.0 rpm" in " ".join(answer.output.split())


def test_power_that_only_swings_is_none(typed):
    """Without losses and without a load that takes anything, the motor gives as much as it takes back."""
    lossless = settings("drive.stage[0].efficiency=1", "drive.stage[1].efficiency=1")
    assert "0 W; to loads 0 W, lost 0 W" in typed("run", "tilting_table", *lossless).output


def test_a_card_the_wrong_way_round_is_said(typed):
    answer = typed("run", UNIT, *settings("load.invented_card.counts=with"))
    assert "as if the well drove the machine" in " ".join(answer.output.split())
    assert "as if the well drove" not in typed("run", UNIT).output


def test_a_press_is_started_with_its_clutch_let_go(typed):
    output = typed("synthesise", "drive", PRESS).output
    assert "Used: start, clutch let go" in output
    assert "worst angle" not in output
    assert "[drive.stroke] is not counted: it runs through, stroke after stroke." in " ".join(output.split())
    said = " ".join(typed("run", PRESS).output.split())
    assert "start, clutch let go 0 %" in said
    assert "worst angle" not in said


def test_rounding_in_a_column_is_0(typed):
    output = typed("synthesise", "counterbalance", UNIT, *()).output
    assert "0.0000000000" not in output
