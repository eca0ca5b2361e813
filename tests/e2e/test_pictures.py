"""Pictures as a person makes them: another process, a file that other programs can read."""

import resource
import subprocess
import sys
import xml.etree.ElementTree as ET

import ezdxf
import numpy as np
import pytest
from PIL import Image

DOTS_PER_MILLIMETRE = 150 / 25.4


@pytest.mark.parametrize(("size", "millimetres"), [("A4", (297, 210)), ("A3", (420, 297))])
def test_sheet(cranktrain, typed, tmp_path, size, millimetres):
    done = (cranktrain if size == "A4" else typed)("plot", "3d12", "-o", "sheet.png", "--size", size, "--at", "137")
    assert (done.returncode, done.stdout, done.stderr) == (0, "written: sheet.png\n", "")
    with Image.open(tmp_path / "sheet.png") as picture:
        assert np.allclose(picture.size, np.multiply(millimetres, DOTS_PER_MILLIMETRE), atol=1)
        assert len(picture.convert("L").getcolors()) > 16
    assert [path.name for path in tmp_path.iterdir()] == ["sheet.png"]


def test_plan(cranktrain, typed, tmp_path):
    """Another process gives the same bytes."""
    arguments = ("plot", "r_1340", "--plan", "velocities", "--at", "30,60", "--mechanism", "3S")
    for start, name in ((cranktrain, "one.svg"), (typed, "other.svg"), (typed, "plan.pdf")):
        done = start(*arguments, "-o", name)
        assert (done.returncode, done.stdout, done.stderr) == (0, f"written: {name}\n", "")
    svg = (tmp_path / "one.svg").read_bytes()
    width = ET.fromstring(svg).attrib["width"].removesuffix("pt")  # points of 1/72 inch
    assert float(width) == pytest.approx(297 / 25.4 * 72, abs=1e-3)
    assert svg == (tmp_path / "other.svg").read_bytes()
    assert (tmp_path / "plan.pdf").read_bytes().startswith(b"%PDF-")


@pytest.mark.parametrize("plan", ["arc", "projection", "brix", "brix-backward", "centres"])
def test_constructions_and_centres(typed, tmp_path, plan):
    done = typed("plot", "mud_pump_12p160", "--plan", plan, "-o", "plan.png")
    assert (done.returncode, done.stdout, done.stderr) == (0, "written: plan.png\n", "")
    with Image.open(tmp_path / "plan.png") as picture:
        assert np.allclose(picture.size, np.multiply((297, 210), DOTS_PER_MILLIMETRE), atol=1)


def test_twelve_positions_of_the_source(typed, tmp_path):
    """Across the line of stroke and at the pressure angle asin λ of the 78 × 78 engine: λ = 39/128."""
    done = typed("plot", "textbook_78x78", "--plan", "positions", "--at", "source", "-o", "plan.svg")
    assert (done.returncode, done.stdout, done.stderr) == (0, "written: plan.svg\n", "")
    done = typed("plot", "3d12", "--plan", "velocities", "--at", "source", "-o", "other.svg")
    assert done.returncode == 2 and "--at = source: must be crank angles" in done.stderr
    done = typed("plot", "pumping_unit_c57", "--plan", "positions", "--at", "source", "-o", "other.svg")
    assert done.returncode == 2 and "is no slider-crank" in done.stderr


def test_animation(typed, tmp_path):
    done = typed("plot", "pumping_unit_c57", "-o", "unit.gif")
    assert (done.returncode, done.stdout, done.stderr) == (0, "written: unit.gif\n", "")
    with Image.open(tmp_path / "unit.gif") as picture:
        assert picture.n_frames == 36


def test_dxf_is_in_true_millimetres(typed, tmp_path):
    """The crank pin's path about the shaft centre is a circle of the crank's radius: 80 mm of stroke, no offset."""
    (tmp_path / "pump.toml").write_text(
        '[mechanism]\nkind = "slider_crank"\nstroke = "80 mm"\nrod_length = "136 mm"\n', encoding="utf-8"
    )
    done = typed("plot", "pump.toml", "-o", "pump.dxf", "--count", "0")
    assert (done.returncode, done.stdout) == (2, "")
    done = typed("plot", "pump.toml", "-o", "pump.dxf", "--at", "0 deg,90")
    assert (done.returncode, done.stdout, done.stderr) == (0, "written: pump.dxf\n", "")
    paths = ezdxf.readfile(tmp_path / "pump.dxf").modelspace().query('LWPOLYLINE[layer=="PATHS"]')
    radii = [np.hypot(*np.array(path.get_points("xy")).T) for path in paths]
    assert any(np.allclose(radius, 40, rtol=0, atol=1e-9) for radius in radii)


def test_full_disk_leaves_nothing_behind(cranktrain, tmp_path):
    def limited() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (10_000, 10_000))

    done = cranktrain("plot", "vaz_21213", "-o", "sheet.png", preexec_fn=limited)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("sheet.png  does not fit")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "others"),
    # Options of a synthesis are the signature of its function, which stands with the arrays that it computes.
    [(["plot"], ["numpy", "rich"]), (["synthesise", "knuckle"], []), (["textbook"], ["numpy", "rich"])],
    ids=["plot", "synthesise knuckle", "textbook"],
)
def test_help_loads_nothing_that_draws(arguments, others):
    unwanted = {*others, "matplotlib", "cranktrain.viz.paper", "cranktrain.plans"}
    script = (
        "import sys\n"
        "from cranktrain.cli import main\n"
        f"assert main({[*arguments, '--help']!r}) == 0\n"
        f"assert {unwanted!r}.isdisjoint(sys.modules)\n"
    )
    environment = {"PYTHONPATH": ":".join(filter(None, sys.path)), "PYTHONUTF8": "1"}
    subprocess.run([sys.executable, "-c", script], env=environment, stdout=subprocess.DEVNULL, check=True)
