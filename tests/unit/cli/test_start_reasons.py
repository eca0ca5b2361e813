"""How starts end, and what is refused, at the terminal."""

import pytest
from tests.sentences import NOT_A_KEY, NOT_POSITIVE

DRY = ("--set", "load.table.sense=resisting")


@pytest.mark.parametrize(
    ("settings", "reason"),
    [
        (("drive.start.duration=0.5 s",), "the time asked for is over"),
        ((), "it has run up"),
        (("drive.start.speed=38 rpm",), "it has run up"),
        (("drive.start.until_speed=30 rpm",), "the speed asked for is reached"),
        (("drive.start.until_speed=500 rpm",), "60 s are over, the most without a duration"),
        (("drive.start.overspeed=30 rpm",), "it turns faster than overspeed allows"),
        (("load.table.sense=resisting", "drive.start.motor_off=3 s"), "it stands still and nothing pulls"),
        (("load.table.sense=resisting", "drive.motor.breakdown_torque=25 N*m"), "it stands still: the motor's torque"),
        (("drive.motor.breakdown_torque=25 N*m",), "it stands still: the motor's torque"),
    ],
)
def test_a_start_says_why_it_ended(typed, settings, reason):
    given = [part for one in settings for part in ("--set", one)]
    answer = typed("start", "tilting_table", *given)
    assert (answer.status, answer.errors) == (0, "")
    assert reason in " ".join(answer.output.split())
    assert "nan" not in answer.output
    assert "0.00000000" not in answer.output


def test_coming_to_a_stand_is_no_reversal(typed):
    answer = typed("start", "tilting_table", *DRY, "--set", "drive.start.motor_off=3 s")
    assert "reversals: 0; at the end it turns at 0 rpm" in " ".join(answer.output.split())


def test_plugging_turns_round(typed):
    """Eight seconds of it."""
    asked = ("--set", "drive.start.motor_reversed=3 s", "--set", "drive.start.duration=8 s")
    answer = typed("start", "tilting_table", *asked)
    assert "reversals: 1" in answer.output


def test_rows_do_not_depend_on_the_interval(typed):
    whole = typed("start", "tilting_table").output
    assert typed("start", "tilting_table", "--set", "drive.start.interval=100 s").output == whole


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("drive.start.interval=0 s", f"{NOT_POSITIVE} s"),
        ("drive.start.interval=1e-9 s", "must be at least"),
        ("drive.start.until_speed=-5 rpm", f"{NOT_POSITIVE} rpm"),
        ("drive.start.overspeed=0 rpm", f"{NOT_POSITIVE} rpm"),
        ("drive.start.motor_off=3 m", "m measures a length; must be a time"),
        ("drive.start.motor_off=-3 s", "must be at least 0 s"),
        ("drive.start.duration=-1 s", f"{NOT_POSITIVE} s"),
        ("drive.start.tolerance=1", "must be at most 0.001"),
        ("drive.start.angle=1 m", "must be an angle"),
        ("drive.start.speed=nan rpm", "must be finite"),
        ("drive.start.motor_of=1 s", NOT_A_KEY),
        ("drive.start.unloaded_until=1 s", "compressor"),
    ],
)
def test_refused(typed, setting, said):
    answer = typed("start", "tilting_table", "--set", setting)
    assert answer.status == 2
    assert said in answer.errors


def test_a_machine_without_a_drive_does_not_start(typed):
    answer = typed("start", "shaper")
    assert answer.status == 2
    assert "drive: is missing" in answer.errors
