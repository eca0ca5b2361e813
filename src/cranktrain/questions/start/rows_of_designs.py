"""Designs in rows, as a compiled loop takes them, and the room in which it runs one after the other."""

from typing import Any, NamedTuple

from cranktrain.motion import Array
from cranktrain.transient.course import Course

MOST_PARTS = 32
"""Parts of a run; those of more go alone."""


class DesignNumbers(NamedTuple):
    """Numbers of a design, in a row; see `StartCase`, `StartOrders` and `OneStage`.

    `angle` is the crank's own at the beginning. [rad] `has_stage`, `settles`: 1 for true. `machine`: which row of
    `Together.machines`; `n_corners`, `n_rows`: how many of its own.
    """

    angle: float
    speed: float
    off: float
    back: float
    braked: float
    overspeed: float
    gas_pressure: float
    interval: float
    tolerance: float
    brake_torque: float
    rise_time: float
    on_crank: float
    holds: float
    settles: float
    steady_speed: float
    cycle_time: float
    turning: float
    has_stage: float
    ratio: float
    forward: float
    backward: float
    drag: float
    stage_inertia: float
    motor: float
    machine: float
    n_corners: float
    n_rows: float


(
    ANGLE, FIRST_SPEED, OFF, BACK, BRAKED, OVERSPEED, GAS_PRESSURE, INTERVAL, TOLERANCE, BRAKE_TORQUE, RISE_TIME,
    ON_CRANK, HOLDS, SETTLES, STEADY_SPEED, CYCLE_TIME, TURNING, HAS_STAGE, RATIO, FORWARD, BACKWARD, DRAG,
    STAGE_INERTIA, MOTOR, MACHINE, N_CORNERS, N_ROWS,
) = range(len(DesignNumbers._fields))  # fmt: skip
"""Where these stand in the row of a design."""
ENDS_AT, TARGET, WHICH, TO_REST = range(4)
"""Of a planned part of a run: until when at most; the speed to reach; which machine, −1 for no part."""
(
    PART_BEGAN,
    PART_ENDS,
    PART_TARGET,
    PART_TO_REST,
    PART_LASTED,
    FIRST_STEP,
    AFTER_STEP,
    FIRST_SAMPLE,
    AFTER_SAMPLE,
    HELD_ON,
    N_PART,
) = range(11)
"""Of a part that was run; whether the crank was held in it, when steps do not tell its states."""
REASON, N_STEPS, LEFT_OVER, SUPPLIED, END_TIME, END_SPEED, N_SAMPLES, N_MARKS = range(8)
"""Of a design that was run: those of `RanFacts`, and how many samples and events it has."""
MOST_MARKS = 2000
"""Events of a part that are written down."""


class Together(NamedTuple):
    """What designs have in common, and the numbers of each.

    Attributes
    ----------
    machines : Array, shape (machine, number)
        Of each once, and as it is with its valves held open where it begins so.
    motors : tuple of NamedTuples of floats
        Of each, filled up to `AT_ONCE`: their number is part of their type, and a loop is compiled for one.
    corners, rows : Array, shape (design, n)
        As of `StartCase`, filled up. [rad]
    cycle : float
        [rad]
    designs : Array, shape (design, number)
        Of `DesignNumbers`.
    lines : Array, shape (design, pattern, column)
        Of several stages.
    spans : Array, shape (design, part, 4)
        Planned parts of a run.
    breaks : Array, shape (design, n)
        Rising. [s]
    """

    machines: Array
    motors: tuple[Any, ...]
    corners: Array
    rows: Array
    cycle: float
    designs: Array
    lines: Array
    spans: Array
    breaks: Array


class StartRoom(NamedTuple):
    """Where a design is computed: a course, numbers of a machine, and what one run and its samples need."""

    course: Course
    machine: Array
    start: Array
    breaks: Array
    steps: Array
    parts: Array
    starts: Array
    ends: Array
    samples: Array
    close: Array
    within: Array
    table: Array


class StartRows(NamedTuple):
    """What is told of designs: a row of each; samples and events one behind the other."""

    designs: Array
    time: Array
    state: Array
    torque: Array
    inertia: Array
    marks: Array
