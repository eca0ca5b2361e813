"""Servo: what a motor must give so that the crank follows a wanted motion."""

from cranktrain.language import N_
from cranktrain.layout.question import Question, Stage
from cranktrain.questions.servo import rows
from cranktrain.questions.servo.late import unlikely_motion
from cranktrain.questions.servo.rocking import is_rocking, rocking_course, rocking_drive
from cranktrain.questions.servo.stages import is_wanted, servo_drive, wanted_crank

QUESTION = Question(
    "servo",
    stages=(
        Stage(wanted_crank, applies=is_wanted),
        Stage(servo_drive, applies=is_wanted),
        Stage(rocking_course, applies=is_rocking),
        Stage(rocking_drive, applies=is_rocking),
        Stage(unlikely_motion),
    ),
    title=N_("Drive"),
    curve_tables={
        "drive": (
            *("wanted_time", "wanted_crank_speed", "wanted_crank_acceleration"),
            *("servo_crank_torque", "servo_torque"),
        )
    },
    rows=(rows.wanted_rows, rows.servo_rows, rows.rocking_rows, rows.rocking_drive_rows),
)
