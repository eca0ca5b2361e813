"""Astern is the same metal at −φ: for every kind, from a file, as long as each handed number of its geometry is marked.

Nothing here knows which numbers are handed: each mark is taken away in turn, and then a curve must differ.
"""

import inspect
import re
from importlib import import_module
from itertools import count
from pkgutil import walk_packages

import numpy as np
import pytest

import cranktrain as ct
import cranktrain.linkage
import cranktrain.mechanisms
from cranktrain.mechanisms import KINDS
from cranktrain.mechanisms import kind as kind_module

STEP = 5.0
CURVES = ("piston_displacement", "slider_position", "point_x", "point_y")
ANGLES = ("rod_angle", "rocker_angle", "link_angle")

CHAINS = {
    "a slide, a trammel on its rod, a yoke, a rocker with a swivel, out of line": """
[mechanism]
kind = "chain"
output = "block"

[mechanism.fixed]
C = ["100 mm", "12 mm"]
D = ["-30 mm", "250 mm"]
E = ["-320 mm", "40 mm"]

[mechanism.crank.main]
radius = "50 mm"

[mechanism.crank.valve]
radius = "20 mm"
angle = "110 deg"

[[mechanism.part]]
type = "slide"
rod = { name = "rod", from = "main.pin", length = "180 mm" }
slider = "piston"
guide = { through = "C", direction = "10 deg", offset = "7 mm" }

[[mechanism.part]]
type = "trammel"
link = "rod"
shift = "4 mm"
slider = "block"
guide = { through = "C", direction = "80 deg", offset = "5 mm" }

[[mechanism.part]]
type = "yoke"
pin = "valve.pin"
slider = "yoke"
slot_angle = "75 deg"
guide = { through = "O", direction = "30 deg", offset = "6 mm" }

[[mechanism.part]]
type = "pin"
rod = { name = "pitman", from = "main.pin", length = "300 mm" }
rocker = { name = "lever", from = "D", length = "160 mm" }
joint = "B"
side = "left"

[[mechanism.part]]
type = "point"
link = "pitman"
name = "F"
along = "70 mm"
across = "20 mm"

[[mechanism.part]]
type = "swivel"
pin = "F"
guide = { name = "slotted", from = "E", offset = "8 mm" }
slider = "stone"
""",
    "a triad on two rods and a guide": """
[mechanism]
kind = "chain"
output = "block"

[mechanism.fixed]
A = ["1500 mm", "200 mm"]
B = ["-30 mm", "800 mm"]

[mechanism.crank.main]
radius = "100 mm"

[[mechanism.part]]
type = "triad"
link = "plate"

[[mechanism.part.leg]]
joint = "P"
rod = { name = "first", from = "main.pin", length = "1200 mm" }
near = ["1216 mm", "441 mm"]

[[mechanism.part.leg]]
joint = "Q"
along = "800 mm"
across = "15 mm"
rod = { name = "second", from = "A", length = "1100 mm" }

[[mechanism.part.leg]]
slider = "block"
along = "500 mm"
across = "1200 mm"
guide = { through = "B", direction = "-30 deg", offset = "-7 mm" }
""",
}


def uneven(kind):
    """The example of a kind with what it leaves out; no length is 0, no angle right, and no two banks are parallel."""
    lines = kind.example.splitlines()
    text = "\n".join(line.removeprefix("# ") if line.startswith("# ") and " = " in line else line for line in lines)
    angles = count(80, 3)
    text = re.sub(r'"90 deg"', lambda _found: f'"{next(angles)} deg"', text)
    return text.replace('"0 mm"', '"7 mm"').replace("# [", "[")


FILES = {kind.name: uneven(kind) for kind in KINDS} | CHAINS


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """A file of each that runs ahead, and one astern, by name."""
    folder = tmp_path_factory.mktemp("handed")
    found = {}
    for place, (name, text) in enumerate(FILES.items()):
        for running in ("ahead", "astern"):
            path = folder / f"{place}_{running}.toml"
            path.write_text(f'running = "{running}"\n{text}', encoding="utf-8")
            found[name, running] = str(path)
    return found


def curves(path):
    """Where everything is over the turn: [m], angles as complex numbers."""
    result = ct.run(path, step_degrees=STEP, quantities=[*CURVES, *ANGLES])
    found = {name: getattr(result, name) for name in CURVES if name in result.catalogue}
    turned = {name: np.exp(1j * np.radians(getattr(result, name))) for name in ANGLES if name in result.catalogue}
    return found | turned


def backwards(values):
    """Curves at −φ."""
    return np.roll(values[..., ::-1], 1, axis=-1)


def differ(ahead, astern):
    """Curves that are not those of the same metal at −φ, seen from behind."""
    for name, values in astern.items():
        wanted = backwards(ahead[name])
        seen = np.conj(wanted) if np.iscomplexobj(wanted) else -wanted if name == "point_y" else wanted
        if not np.allclose(values, seen, atol=1e-12, rtol=0.0, equal_nan=True):
            yield name


def reached(parts, found):
    """Types of a geometry and of all that is in it."""
    found.add(type(parts))
    for part in parts:
        if isinstance(part, tuple):
            reached(part, found)
    return found


def types_of(path):
    return {found for place in ct.load(path).places for found in reached(place.geometry, set())}


def marks():
    """Every field that is marked, of whatever is declared for linkages and mechanisms."""
    for package in (cranktrain.linkage, cranktrain.mechanisms):
        for module in walk_packages(package.__path__, f"{package.__name__}."):
            for found in vars(import_module(module.name)).values():
                if inspect.isclass(found) and found.__module__ == module.name and hasattr(found, "_fields"):
                    yield from ((found, field) for field in sorted(kind_module.handed_fields(found)))


@pytest.mark.parametrize("name", FILES)
def test_astern_is_the_same_metal(files, name):
    ahead, astern = (curves(files[name, running]) for running in ("ahead", "astern"))
    assert ahead
    assert list(differ(ahead, astern)) == [], (
        "mark what of its geometry counts toward +y or in the sense of rotation as `Handed`, in its kinematics.py"
    )


@pytest.mark.parametrize(
    ("kind", "field"), list(marks()), ids=lambda one: one if isinstance(one, str) else one.__name__
)
def test_without_a_mark_a_curve_differs(files, monkeypatch, kind, field):
    """And what is marked is geometry that a kind has: of no other class is there a file."""
    own = [name for name in FILES if kind in types_of(files[name, "ahead"])]
    assert own, "no mechanism's geometry has this class: take the mark away, or add a chain above"
    marked = kind_module.handed_fields
    monkeypatch.setattr(kind_module, "handed_fields", lambda of: marked(of) - ({field} if of is kind else set()))
    for name in own:
        ahead = curves(files[name, "ahead"])
        try:
            if any(differ(ahead, curves(files[name, "astern"]))):
                return
        except ct.InputError:
            return  # other metal, which cannot close
    pytest.fail(f"{kind.__name__}.{field} makes no difference astern: is it handed? Or is it 0 in every file above?")
