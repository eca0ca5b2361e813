"""What every kind of gas model brings: a folder with its parts, pages, a valid example, a pressure for every state."""

import tomllib
from pathlib import Path

import numpy as np
import pytest
from pydantic import TypeAdapter
from tests.gas_engines import FOUR_STROKE, TWO_STROKE, Engine, csv

import cranktrain.gas as gas
from cranktrain.io.schema import described
from cranktrain.spec import validated

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "src/cranktrain/gas"
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
    assert {kind.name for kind in gas.KINDS} == folders
    assert len(gas.KINDS) == len(folders)
    assert all(gas.kind_named(kind.name) is kind for kind in gas.KINDS)


@every_kind
def test_folder_and_pages(kind):
    for part in ("README.md", "spec.py"):
        assert (FOLDER / kind.name / part).is_file(), part
    assert (ROOT / f"docs/gas/{kind.name}.md").is_file()
    assert f'`kind = "{kind.name}"`' in (FOLDER / kind.name / "README.md").read_text(encoding="utf-8")


@every_kind
def test_union_takes_the_example(kind):
    spec = example_of(kind, kind.example)
    assert kind.spec.model_fields["kind"].annotation.__args__ == (kind.name,)
    again = TypeAdapter(gas.AnyGas).validate_python(spec.model_dump())
    assert type(again) is kind.spec
    assert gas.kind_of(again) is kind


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
        assert described(kind.spec, name).endswith(".")


@every_kind
def test_readme_names_every_key(kind):
    text = (FOLDER / kind.name / "README.md").read_text(encoding="utf-8")
    assert [name for name in kind.spec.model_fields if f"`{name}" not in text] == []


@every_kind
@pytest.mark.parametrize("cycle", [TWO_STROKE, FOUR_STROKE])
def test_pressure_of_the_states_shape(kind, cycle):
    spec = example_of(kind, kind.example)
    if kind.name == "indicator" and cycle == TWO_STROKE:
        spec = spec.model_copy(update={"text": "\n".join(FILE.splitlines()[:361])})
    model = kind.model(spec, ENGINE.chamber(cycle))
    angle = np.stack([ANGLE, ANGLE + cycle])
    state = gas.chamber_state(ENGINE.volume(angle), ENGINE.limits, angle, cycle)
    pressure = kind.pressure(state, model)
    assert pressure.shape == angle.shape
    assert np.all(pressure > 0)
    np.testing.assert_allclose(pressure[1], pressure[0], rtol=1e-9)
    for sentence in kind.flags(spec, model):
        assert sentence[0].isupper()
        assert sentence[-1] in ".?"


@every_kind
def test_breaks_are_where_the_model_is_not_smooth(kind):
    """Rising within the cycle; only what goes through samples has them."""
    assert (kind.breaks is None) == (kind.work is None)
    if kind.breaks is None:
        return
    model = kind.model(example_of(kind, kind.example), ENGINE.chamber())
    breaks = kind.breaks(model)
    assert breaks.ndim == 1
    assert np.all(np.diff(breaks) > 0)
    assert breaks[0] >= 0
    assert breaks[-1] < FOUR_STROKE
