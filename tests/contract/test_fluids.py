"""What every fluid brings: a folder with its parts, pages, a valid example, a pressure for every state."""

import tomllib
from pathlib import Path

import numpy as np
import pytest
from pydantic import TypeAdapter
from scipy.optimize import brentq
from tests.gas_engines import FOUR_STROKE, TWO_STROKE, Engine, csv

import cranktrain.fluids as gas
from cranktrain.io.schema import described
from cranktrain.numerics.nested import mapped
from cranktrain.spec import validated

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "src/cranktrain/fluids"
ENGINE = Engine(0.045, 0.15, 0.08, 16.0, offset=-0.004)
ANGLE = np.radians(np.arange(0.0, 720.0, 1.0))
FILE = csv(np.degrees(ANGLE), 1e5 * (20 + 18 * np.cos(ANGLE / 2 - 0.1)))

every_kind = pytest.mark.parametrize("kind", gas.KINDS, ids=lambda kind: kind.name)


def example_of(kind, text):
    """The table of an example; the diagram's file as its loader would give it."""
    table = tomllib.loads(text)["gas"]
    return validated(kind.spec, table | ({"text": FILE} if "file" in table else {}))


def test_kinds_are_the_folders():
    folders = {path.name for path in FOLDER.iterdir() if (path / "__init__.py").exists()}
    assert {kind.name for kind in gas.KINDS} == folders, (
        "a folder of fluids/ is a line in KINDS of its __init__.py, and its kind has the folder's name"
    )
    assert len(gas.KINDS) == len(folders), "a kind stands in KINDS once"
    assert all(gas.KINDS.named(kind.name) is kind for kind in gas.KINDS)


@every_kind
def test_folder_and_pages(kind):
    for part in ("README.md", "spec.py"):
        assert (FOLDER / kind.name / part).is_file(), f"write fluids/{kind.name}/{part}"
    assert (ROOT / f"docs/gas/{kind.name}.md").is_file(), "write the page, which includes the folder's README"
    assert f'`kind = "{kind.name}"`' in (FOLDER / kind.name / "README.md").read_text(encoding="utf-8"), (
        "the README names its kind"
    )


@every_kind
def test_union_takes_the_example(kind):
    spec = example_of(kind, kind.example)
    assert kind.spec.model_fields["kind"].annotation.__args__ == (kind.name,), (
        "the spec's `kind` is a Literal of the folder's name"
    )
    again = TypeAdapter(gas.AnyGas).validate_python(spec.model_dump())
    assert type(again) is kind.spec, "add the spec to the union AnyGas of fluids/__init__.py"
    assert gas.fluid_of(again) is kind


@every_kind
def test_what_the_example_leaves_out_is_valid_too(kind):
    """Lines that begin with `# ` and hold a key or a table are part of the example, only commented out."""
    lines = [
        line.removeprefix("# ") if line.startswith("# ") and ("=" in line or "[" in line) else line
        for line in kind.example.splitlines()
    ]
    example_of(kind, "\n".join(lines))


@every_kind
def test_every_key_is_described(kind):
    for name in kind.spec.model_fields:
        assert described(kind.spec, name).endswith("."), f"describe {name} in a sentence, with Field(description=N_(…))"


@every_kind
def test_readme_names_every_key(kind):
    text = (FOLDER / kind.name / "README.md").read_text(encoding="utf-8")
    assert [name for name in kind.spec.model_fields if f"`{name}" not in text] == [], (
        "tell these keys in the folder's README"
    )


@every_kind
@pytest.mark.parametrize("cycle", [TWO_STROKE, FOUR_STROKE])
def test_pressure_of_the_states_shape(kind, cycle):
    spec = example_of(kind, kind.example)
    if kind.name == "indicator" and cycle == TWO_STROKE:
        spec = spec.model_copy(update={"text": "\n".join(FILE.splitlines()[:361])})
    _kind, ready = ENGINE.filled(spec, cycle)
    angle = np.stack([ANGLE, ANGLE + cycle])[:, np.newaxis]
    state = gas.chamber_state(ENGINE.volume(angle), ENGINE.limits, angle, cycle)
    pressure = np.stack([kind.pressure(gas.ChamberState(*map(row_of(i), state)), ready) for i in range(2)])
    assert pressure.shape == (2, 1, 1, len(ANGLE))
    assert np.all(pressure > 0)
    np.testing.assert_allclose(pressure[1], pressure[0], rtol=1e-9)
    alone = mapped(lambda _name, part: part[0, 0], ready)
    of_one = gas.chamber_state(ENGINE.volume(ANGLE), ENGINE.limits, ANGLE, cycle)
    np.testing.assert_array_equal(kind.pressure(of_one, alone), pressure[0, 0, 0])
    for sentence in map(str, (*kind.flags(spec), *kind.notes(ready))):
        assert sentence[0].isupper(), f"flags and notes are sentences: {sentence}"
        assert sentence[-1] in ".?", f"flags and notes are sentences: {sentence}"


def row_of(i):
    return lambda part: part[i : i + 1] if np.ndim(part) == 3 else part


@every_kind
@pytest.mark.parametrize("cycle", [TWO_STROKE, FOUR_STROKE])
def test_work_is_the_pressures_over_the_volume(kind, cycle):
    """By Gauss's quadrature between what the fluid itself says are its breaks and kinks."""
    spec = example_of(kind, kind.example)
    if kind.name == "indicator" and cycle == TWO_STROKE:
        spec = spec.model_copy(update={"text": "\n".join(FILE.splitlines()[:361])})
    rooms = ENGINE.rooms(cycle)
    _kind, ready = ENGINE.filled(spec, cycle)
    breaks = [np.arange(0, cycle, np.pi / 18), ENGINE.bottom + np.arange(0, cycle, 2 * np.pi)]
    if kind.breaks is not None:
        breaks.append(kind.breaks(ready)[0, 0])
    for kink in kind.kinks(ready, rooms.limits):
        side = (ENGINE.top_angle, ENGINE.bottom - (0.0 if kink.sense > 0 else 2 * np.pi))
        root = brentq(lambda angle, kink=kink: ENGINE.volume(angle).value - kink.volume[0, 0, 0], *side, xtol=1e-14)
        breaks.append(root + 2 * np.pi * np.arange(2))
    breaks.append(ENGINE.top_angle + np.arange(0, cycle, 2 * np.pi))
    edges = np.append(np.unique(np.mod(np.concatenate(breaks), cycle)), cycle)
    node, weight = np.polynomial.legendre.leggauss(20)
    half = np.diff(edges)[:, np.newaxis] / 2
    angle = (edges[:-1, np.newaxis] + half * (1 + node)).ravel()
    volume = ENGINE.volume(angle)
    state = gas.chamber_state(volume, ENGINE.limits, angle, cycle)
    pressure = kind.pressure(state, mapped(lambda _name, part: part[0, 0], ready))
    work = float(np.sum(pressure * volume.first * (half * weight).ravel()))
    assert kind.work(ready, rooms)[0, 0] == pytest.approx(work, rel=1e-11, abs=1e-9)


@every_kind
def test_slope_is_the_pressures(kind):
    """By a central difference of the pressure, wherever that stays on one piece of its curve."""
    rooms = ENGINE.rooms()
    _kind, ready = ENGINE.filled(example_of(kind, kind.example))
    own = mapped(lambda _name, part: part[0, 0], ready)
    angle = np.radians(np.arange(0.37, 720.0, 1.0))
    step = np.radians(0.02) * np.array([-2, -1, 1, 2])

    def at(angle):
        volume = ENGINE.volume(angle)
        state = gas.chamber_state(volume, ENGINE.limits, angle, FOUR_STROKE)
        return state, volume.first

    state, volume_slope = at(angle)
    found = kind.slope(state, kind.pressure(state, own), volume_slope, own)
    assert found.shape == angle.shape
    near = np.array([kind.pressure(at(angle + one)[0], own) for one in step])
    expected = np.array([1.0, -8.0, 8.0, -1.0]) @ near / (12 * np.radians(0.02))
    off = np.abs(found - expected) > 1e-6 * np.max(np.abs(found))
    # where pieces meet: dead centres, valves, where heat ends, samples of a card
    assert np.count_nonzero(off) <= 4 * (1 + len(kind.kinks(ready, rooms.limits)))
    ends = angle[off]
    others = {0: ENGINE.top_angle, 1: ENGINE.bottom}
    edges = [place + turn for place in others.values() for turn in 2 * np.pi * np.arange(-1, 3)]
    if kind.breaks is not None:
        edges += list(kind.breaks(ready)[0, 0])
    for kink in kind.kinks(ready, rooms.limits):
        edges += list(angle[np.argsort(np.abs(state.volume - kink.volume[0, 0, 0]))[:8]])
    assert all(np.min(np.abs(np.array(edges) - end)) < np.radians(1.0) for end in ends)
    assert np.ptp(found) > 0


@every_kind
def test_breaks_rise_within_the_cycle(kind):
    if kind.breaks is None:
        return
    _kind, ready = ENGINE.filled(example_of(kind, kind.example))
    breaks = kind.breaks(ready)
    assert breaks.shape[:2] == (1, 1)
    own = breaks[0, 0]
    assert np.all(np.diff(own) > 0)
    assert own[0] >= 0
    assert own[-1] < FOUR_STROKE
