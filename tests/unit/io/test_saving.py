"""A machine that is saved is the same when it is read, and its file keeps what was written around the numbers."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.io.examples import EXAMPLES_FOLDER, example_names
from cranktrain.io.saving import machine_text
from cranktrain.quantities import Given

FILE = """\
# A pump of the workshop.
name = "a pump"          # as it is called

[shaft.main]
speed = { value = "120 rpm", status = "published", note = "plate" }

[mechanism]
kind = "slider_crank"
stroke = "12 in"         # measured
rod_length = "30 in"

[gravity]
acceleration = "9.8 m/s^2"

[[balance.weight]]
throw = 1
mass = "1 kg"
radius = "100 mm"
angle = "180 deg"

[[balance.weight]]
throw = 1
mass = "2 kg"
radius = "100 mm"
angle = "180 deg"
"""


@pytest.fixture
def pump(tmp_path):
    path = tmp_path / "pump.toml"
    path.write_text(FILE, encoding="utf-8")
    return ct.load(path)


@pytest.mark.parametrize("name", example_names())
def test_an_example_is_saved_as_it_was_typed_and_can_be_written_from_python(name, tmp_path):
    machine = ct.load(name)
    typed = (EXAMPLES_FOLDER / f"{name}.toml").read_text(encoding="utf-8")
    assert machine_text(machine, EXAMPLES_FOLDER) == typed
    machine.save(tmp_path / "elsewhere.toml")
    assert ct.load(tmp_path / "elsewhere.toml") == machine
    ct.Machine(**machine.declared).save(tmp_path / "python.toml")
    assert ct.load(tmp_path / "python.toml") == machine


def test_what_is_changed_is_changed_and_all_else_stays(pump, tmp_path):
    changed = pump.with_({"mechanism.stroke": "300 mm", "shaft.main.speed": "20 rad/s", "mechanism.offset": "5 mm"})
    changed.save(tmp_path / "best.toml")
    text = (tmp_path / "best.toml").read_text(encoding="utf-8")
    assert ct.load(tmp_path / "best.toml") == changed
    assert "# A pump of the workshop.\n" in text
    assert 'stroke = "300 mm"         # measured\n' in text
    assert 'speed = "20 rad/s"\n' in text, "what was said of the old number went with it"
    assert 'offset = "5 mm"' in text


@pytest.mark.parametrize(
    "values",
    [
        {"gravity": True},
        {"balance.weight": [{"throw": 1, "mass": "3 kg", "radius": "90 mm", "angle": "180 deg"}]},
        {"balance": {"weight": [{"throw": 1, "mass": "3 kg", "radius": "9 cm", "angle": "0 deg"}]}},
        {"masses": {"piston": {"mass": "2 kg"}}},
        {"mechanism": {"kind": "scotch_yoke", "crank_radius": "50 mm"}},
        {"mechanism.rod_length": Given(0.8, "800 mm", "assumed", "a guess")},
        {"name": 'with "quotes", a \\ and a\ttab'},
    ],
    ids=lambda values: next(iter(values)),
)
def test_whatever_is_changed_is_read_again(pump, tmp_path, values):
    changed = pump.with_(values)
    changed.save(tmp_path / "changed.toml")
    assert ct.load(tmp_path / "changed.toml") == changed
    again = ct.load(tmp_path / "changed.toml")
    again.save(tmp_path / "again.toml")
    assert (tmp_path / "again.toml").read_bytes() == (tmp_path / "changed.toml").read_bytes()


def test_a_curve_stays_in_its_file(tmp_path):
    (tmp_path / "one").mkdir()
    (tmp_path / "one/card.csv").write_text(
        "angle [deg],force [N]\n0,0\n90,100\n180,0\n270,50\n360,0\n", encoding="utf-8"
    )
    text = FILE.partition("[gravity]")[0] + '[load.card]\nfile = "card.csv"\non = "piston"\n'
    (tmp_path / "one/pump.toml").write_text(text, encoding="utf-8")
    machine = ct.load(tmp_path / "one/pump.toml")
    machine.save(tmp_path / "beside.toml")
    saved = (tmp_path / "beside.toml").read_text(encoding="utf-8")
    assert 'file = "one/card.csv"' in saved
    assert "270" not in saved
    assert ct.run(tmp_path / "beside.toml").load_work == pytest.approx(ct.run(machine).load_work, rel=1e-15)


def test_nothing_is_lost(pump, tmp_path):
    kept = tmp_path / "kept.toml"
    kept.write_text("mine", encoding="utf-8")
    with pytest.raises(InputError, match=r"kept\.toml"):
        pump.save(kept)
    assert kept.read_text(encoding="utf-8") == "mine"
    pump.save(kept, force=True)
    assert ct.load(kept) == pump
    with pytest.raises(InputError, match="must end in"):
        pump.save(tmp_path / "pump.csv")
    with pytest.raises(InputError, match="folder"):
        pump.save(tmp_path / "no/pump.toml")


@pytest.mark.parametrize(
    ("name", "changed"),
    [
        ("great_northern", lambda tables: {"bank": {"cylinder": tables["bank"]["cylinder"]}}),
        (
            "jaw_crusher",
            lambda tables: {"drive": {key: item for key, item in tables["drive"].items() if key != "part"}},
        ),
        ("vaz_21213", lambda _tables: {"torsion": {"stiffness": "1 MN*m/rad", "throw_inertia": "0.1 kg*m^2"}}),
        ("vaz_21213", lambda _tables: {"cylinder.compression_ratio": np.linspace(9.0, 10.0, 3)[1]}),
        ("3d12", lambda tables: {"bank": {"R": tables["bank"]["R"], "L": tables["bank"]["L"]}}),
    ],
    ids=["a bank", "parts", "torsion", "a number of NumPy", "the order of banks"],
)
def test_what_holds_others_may_be_taken_away(tmp_path, name, changed):
    """Where no change of the text would be read as the same machine, all of it is written anew."""
    machine = ct.load(name)
    machine = machine.with_(changed(machine.declared))
    machine.save(tmp_path / "changed.toml")
    again = ct.load(tmp_path / "changed.toml")
    assert again == machine
    assert list(again.bank) == list(machine.bank)


def test_half_a_character_is_refused(pump, tmp_path):
    with pytest.raises(InputError, match="half a character"):
        pump.with_({"name": "a \ud800"}).save(tmp_path / "half.toml")
    assert not (tmp_path / "half.toml").exists()
