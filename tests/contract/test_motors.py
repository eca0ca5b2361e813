"""Every kind of motor brings a folder with its parts, page, a valid example; the laws of its torque compile.

What is compiled gives what NumPy gives, and its breaks are all that there are.
"""

import re
import tomllib
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from pydantic import TypeAdapter
from tests.motors import EXAMPLES, SYNCHRONOUS

from cranktrain.linkage import compiled
from cranktrain.motors import KINDS, AnyMotor, motor_of
from cranktrain.numerics.nested import mapped
from cranktrain.spec import validated

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "src/cranktrain/motors"
SPEEDS = np.array([-60.0, -1.0, 0.0, 10.0, 31.0, 60.0, 95.0, 140.0, 156.0, SYNCHRONOUS, 170.0, 192.0, 240.0])
TIMES = (0.0, 0.1, 0.7, 1.05, 1.6, 5.0)
OTHER_LIBRARY = 8 * np.finfo(float).eps

LAWS = [law for kind in KINDS for law in kind.laws]
every_motor = pytest.mark.parametrize("motor", LAWS, ids=lambda motor: motor.name)


def in_time(geometry, time):
    """An inverter on its ramp without its limit of torque: where that begins to hold moves with time."""
    ramp = getattr(geometry, "ramp", None)
    return geometry if ramp is None or time > ramp.ramp_time else geometry._replace(torque_limit=np.inf)


every_kind = pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)


def uncommented(example):
    """Lines of a key or a table that are only commented out taken for what they hold."""
    return "\n".join(
        line.removeprefix("# ") if line.startswith("# ") and ("=" in line or "[" in line) else line
        for line in example.splitlines()
    )


def spec_of(kind, example):
    return validated(kind.spec, tomllib.loads(example)["drive"]["motor"])


def test_kinds_are_the_folders_with_a_readme():
    folders = {path.parent.name for path in FOLDER.glob("*/README.md")}
    assert {kind.name for kind in KINDS} == folders, "a folder of a motor needs a line in KINDS, and a kind its README"


@every_kind
def test_page_and_readme(kind):
    text = (FOLDER / kind.name / "README.md").read_text(encoding="utf-8")
    assert f'`kind = "{kind.name}"`' in text
    assert kind.example in text
    assert [name for name in kind.spec.model_fields if name != "kind" and f"`{name}`" not in text] == []
    assert (ROOT / f"docs/motors/{kind.name}.md").is_file(), "docs/motors needs its page, which includes the README"
    assert f"\n{kind.name}\n" in (ROOT / "docs/motors/index.md").read_text(encoding="utf-8")


@every_kind
@pytest.mark.parametrize("read", [str, uncommented])
def test_the_example_is_a_motor_of_one_of_its_laws(kind, read):
    if kind.name == "wound_rotor" and read is uncommented:  # a rheostat stands instead of a constant resistance
        example = kind.example.replace("# resistance_ratio", "## resistance_ratio")
    else:
        example = kind.example
    spec = spec_of(kind, read(example))
    again = TypeAdapter(AnyMotor).validate_python(spec.model_dump())
    assert type(again) is kind.spec
    found = motor_of(again)
    assert found.law in kind.laws
    assert found.law.limits(found, 0)._fields == ("peak", "start", "unknown")
    torque = found.torque(np.array([[0.5 * float(min(found.top_speed[0], 100.0))]]))
    assert torque.shape == (1, 1)
    assert torque[0, 0] > 0


@every_kind
def test_what_limits_do_not_know_is_said(kind):
    found = motor_of(spec_of(kind, kind.example))
    limits = found.law.limits(found, 0)
    assert np.isnan([limits.peak, limits.start]).any() == (limits.unknown != "")


def test_every_motor_has_an_example_and_a_name_of_its_own():
    assert {motor.name for motor in LAWS} == set(EXAMPLES)
    assert len(LAWS) == len(EXAMPLES)


@every_motor
def test_what_it_says_of_itself(motor):
    assert type(EXAMPLES[motor.name]) is motor.numbers
    assert re.match(r"docs/theory/drive, eqs?\. \(25\.\d+\)", motor.source)
    assert motor.title
    assert motor.range
    assert re.search(
        rf'^    "{motor.name}",$', "".join(p.read_text("utf-8") for p in FOLDER.rglob("*.py")), re.MULTILINE
    )


@every_motor
@pytest.mark.parametrize("time", TIMES)
def test_compiled(motor, time):
    """To the last bits, for numbers a number."""
    geometry = EXAMPLES[motor.name]
    kernel = compiled(motor.kernel)
    found = [kernel(speed, time, geometry) if motor.is_timed else kernel(speed, geometry) for speed in SPEEDS.tolist()]
    assert {type(torque) for torque in found} == {float}
    np.testing.assert_allclose(found, motor.torque(SPEEDS, time, geometry), rtol=OTHER_LIBRARY, atol=1e-12)


@every_motor
def test_designs(motor):
    """Each is what it is alone; points of tables stand along the first axis."""
    factors = np.array([1.0, 0.7, 1.1])
    geometry = EXAMPLES[motor.name]
    many = mapped(
        lambda _name, value: np.asarray(value)[..., np.newaxis, np.newaxis] * factors[:, np.newaxis], geometry
    )
    together = motor.torque(SPEEDS, 0.7, many)
    assert together.shape == (3, SPEEDS.size)
    for torque, factor in zip(together, factors, strict=True):
        alone = mapped(lambda _name, value, by=factor: value * by, geometry)
        np.testing.assert_array_equal(torque, motor.torque(SPEEDS, 0.7, alone))


@every_motor
@pytest.mark.parametrize("time", TIMES)
def test_between_breaks_it_is_smooth(motor, time):
    """Slopes from both sides agree everywhere else, and there are no jumps."""
    geometry = in_time(EXAMPLES[motor.name], time)
    # A series motor is its own generator below −R/c.
    speeds = np.linspace(-15.0 if motor.name == "series" else -80.0, 240.0, 2001)
    step = 1e-4
    breaks = [float(speed) for speed in motor.breaks(geometry).speeds if np.isfinite(speed)]
    far = np.min([np.abs(speeds - at) for at in [*breaks, 1e9]], axis=0) > 2 * step
    before, here, after = (motor.torque(speeds + shift, time, geometry) for shift in (-step, 0.0, step))
    bend = np.abs(after - 2 * here + before)[far]
    assert np.max(bend) <= 1e-6 * np.max(np.abs(here))


@every_motor
def test_long_since_it_was_switched_on_breaks_are_all_corners(motor):
    """A corner or jump between two speeds, wherever it is, makes the torque another one than slopes at both make it."""
    geometry, step = EXAMPLES[motor.name], 1e-4
    speeds = np.linspace(-15.0 if motor.name == "series" else -80.0, 240.0, 4001)
    apart = speeds[1] - speeds[0]
    before, here, after = (motor.torque(speeds + shift, np.inf, geometry) for shift in (-step, 0.0, step))
    slopes = (after - before) / (2 * step)
    bends = np.abs(np.diff(here) / apart - (slopes[1:] + slopes[:-1]) / 2)
    breaks = [float(speed) for speed in motor.breaks(geometry).speeds if np.isfinite(speed)]
    beside = [any(low - 2 * step <= at <= low + apart + 2 * step for at in breaks) for low in speeds[:-1].tolist()]
    assert np.max(bends[~np.array(beside)]) <= 1e-3 * np.max(np.abs(slopes[1:-1]))


@every_motor
def test_jumps_in_time_are_breaks(motor):
    """Between them a ten-thousandth of a second changes little; a step, a change or a brake changes more."""
    geometry = EXAMPLES[motor.name]
    times = sorted({0.0, *(float(time) for time in motor.breaks(geometry).times), 9.0})
    for speed in (20.0, 120.0):
        for one, other in pairwise(times):
            at = np.arange(one + 1e-9, other - 1e-9, 1e-4)
            torque = np.broadcast_to(motor.torque(speed, at, geometry), at.shape)
            assert np.max(np.abs(np.diff(torque))) < 1.0


def test_breaks_of_kloss_alone_are_none():
    kloss = EXAMPLES["cage"]._replace(kloss_until=np.inf)
    assert np.all(np.isnan(LAWS[0].breaks(kloss).speeds))
