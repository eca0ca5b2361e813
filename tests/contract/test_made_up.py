"""What is added needs its own folder and one line, a question its four: a copy of the package is added to, and asked.

The copies of a kind and of a fluid have other words for all that is their own, so that no list elsewhere can know them.
"""

import csv
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

SOURCE = Path(__file__).parents[2] / "src/cranktrain"

MOTOR = {
    "__init__.py": '''
"""A spring motor, made up."""

from cranktrain.motors.kind import MotorKind
from cranktrain.motors.spring.law import SPRING
from cranktrain.motors.spring.spec import SpringSpec

KIND = MotorKind("spring", "spring motor", SpringSpec, (SPRING,), "")
''',
    "law.py": '''
"""The torque of a spring: it falls in a line."""

from typing import NamedTuple

from cranktrain.motion import Array
from cranktrain.motors.law import BriefLimits, MotorLaw


class Spring(NamedTuple):
    """Torque at standstill, speed without load."""

    torque: Array
    free_speed: Array


def spring_torque(speed, spring):
    return spring.torque * (1 - speed / spring.free_speed)


SPRING = MotorLaw(
    "spring", "wound spring", spring_torque, Spring, "", "",
    lambda _motor, _design: BriefLimits(unknown="largest torque: nobody wound it so far"),
)
''',
    "spec.py": '''
"""Its table."""

from typing import Literal

from cranktrain.motors.declared import DeclaredMotor
from cranktrain.motors.spec import RatedSpec
from cranktrain.motors.spring.law import SPRING, Spring
from cranktrain.quantities import PositiveSpeed, PositiveTorque


class SpringSpec(RatedSpec, frozen=True):
    """A spring."""

    kind: Literal["spring"]
    wound_torque: PositiveTorque
    free_speed: PositiveSpeed

    def declared(self) -> DeclaredMotor:
        numbers = Spring(self.wound_torque.array, self.free_speed.array)
        return DeclaredMotor(SPRING, numbers, self.rating, numbers.free_speed, self.rotor_inertia)
''',
}
QUESTION = {
    "__init__.py": '''
"""How loud it is, made up."""

from cranktrain.layout.question import Question, ResultDimension, Stage, Use
from cranktrain.layout.question import table
from cranktrain.questions.noise import rows
from cranktrain.questions.noise.loudness import Loudness, loudness
from cranktrain.questions.noise.spec import NoiseSpec, noise_parts

QUESTION = Question(
    "noise",
    tables={"noise": NoiseSpec},
    parts=noise_parts,
    stages=(Stage(loudness),),
    dimensions=(ResultDimension("ear", "ear"),),
    headline=("rattle",),
    title="Noise",
    rows=(rows.noise_rows,),
    offers={"rattle": "how it rattles"},
    uses=(Use(table("noise"), (Loudness,)),),
)
''',
    "spec.py": '''
"""Its table, and the part that it declares."""

from typing import ClassVar

from cranktrain.motion import Array
from cranktrain.quantities import PositiveLength
from cranktrain.record import record
from cranktrain.spec import Spec


class NoiseSpec(Spec, frozen=True):
    """Noise."""

    clearance: PositiveLength


@record
class DeclaredNoise:
    """Clearance of the loosest joint. [m]"""

    needs: ClassVar[str] = "[noise]"

    clearance: Array


def noise_parts(designs, _known):
    spec = designs.together.table(NoiseSpec)
    if spec is not None:
        yield DeclaredNoise(designs.by_design([spec.clearance.array])[:, 0])
''',
    "loudness.py": '''
"""Speed with which it rattles."""

from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.questions.noise.spec import DeclaredNoise
from cranktrain.record import record


@record
class Loudness(StageResult):
    """How loud it is."""

    rattle: Array = quantity("v_r", "m/s", ("ear",), "Speed of the loosest joint", "docs/conventions", "definition")


def loudness(noise: DeclaredNoise, speed: Speed) -> Loudness:
    """Clearance by speed; docs/conventions."""
    return Loudness((noise.clearance * abs(speed.value).reshape(-1))[:, None], labels={"ear": ("left",)})
''',
    "rows.py": '''
"""What is said of it."""

from cranktrain.language import _
from cranktrain.questions.noise.loudness import Loudness
from cranktrain.saying.rows import worded


def noise_rows(of, found: Loudness):
    yield worded(_("rattles"), _("with {speed}", speed=of.amount(found, "rattle", 0)))
''',
}


def added(path, mark, line):
    """Put a line before the first one that has the mark."""
    text = path.read_text(encoding="utf-8")
    place = text.rindex("\n", 0, text.index(mark)) + 1
    path.write_text(f"{text[:place]}{line}\n{text[place:]}", encoding="utf-8")


def copied(package, name, words):
    """Copy a folder under another name, all words of its own changed."""
    folder = package / name
    shutil.copytree(package / next(iter(words)), folder, ignore=shutil.ignore_patterns("__pycache__"))
    for path in folder.iterdir():
        text = path.read_text(encoding="utf-8")
        for word, other in words.items():
            text = re.sub(word, other, text)
        path.write_text(text, encoding="utf-8")


def written(folder, files):
    folder.mkdir()
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    """A copy of the package with a kind, a fluid, a motor and a question more."""
    root = tmp_path_factory.mktemp("made_up")
    package = root / "cranktrain"
    shutil.copytree(SOURCE, package, ignore=shutil.ignore_patterns("__pycache__"))
    kinds = package / "mechanisms"
    words = {"slider_crank": "swash_pump", "SliderCrank": "SwashPump", "offset": "skew", "PISTON": "RAM"}
    copied(kinds, "swash_pump", words)
    added(kinds / "__init__.py", '        "crank_rocker",', '        "swash_pump",')
    copied(package / "fluids", "lenoir", {"otto": "lenoir", "Otto": "Lenoir"})
    fluids = package / "fluids/__init__.py"
    text = fluids.read_text(encoding="utf-8")
    fluids.write_text(text.replace('("indicator",', '("lenoir", "indicator",'), encoding="utf-8")
    written(package / "motors/spring", MOTOR)
    motors = package / "motors/__init__.py"
    motors.write_text(motors.read_text(encoding="utf-8").replace('("cage",', '("spring", "cage",'), encoding="utf-8")
    written(package / "questions/noise", QUESTION)
    questions = package / "all_questions.py"
    added(questions, '        "press":', '        "noise": ("noise",),')
    machine = package / "machine.py"
    added(machine, "    drive: DriveSpec", '    noise: NoiseSpec | None = Field(default=None, description="Noise.")')
    text = machine.read_text(encoding="utf-8")
    machine.write_text(text.replace("RodSpec, TorsionSpec\n", "RodSpec, TorsionSpec, NoiseSpec\n"), encoding="utf-8")
    added(questions, "    TorsionSpec = ", '    NoiseSpec = when_given("cranktrain.questions.noise.spec", "NoiseSpec")')
    return root


@pytest.fixture
def typed(package, tmp_path, monkeypatch):
    """What the terminal of the copy prints; a text is the file `machine.toml` then."""
    monkeypatch.chdir(tmp_path)

    def run(*command, text=None, status=0):
        if text is not None:
            Path("machine.toml").write_text(text, encoding="utf-8")
        found = subprocess.run(
            [sys.executable, "-m", "cranktrain", *command],
            env={**os.environ, "PYTHONPATH": str(package), "CRANKTRAIN_TRACEBACK": "1"},
            capture_output=True,
            text=True,
            check=False,
        )
        assert found.returncode == status, found.stderr
        return found.stdout if status == 0 else found.stderr

    return run


class TestKind:
    def test_it_is_listed_begins_a_file_and_has_its_own_words(self, typed):
        assert "swash_pump" in typed("list", "kinds")
        said = typed("run", "machine.toml", text=typed("new", "swash_pump").partition("[cylinder]")[0])
        assert "mean speed" in said, "a ram's, whose words are its own"
        assert "piston" not in said

    def test_astern_it_is_its_mirror_image(self, typed):
        """The slider of a skew crank is at φ astern where it is at −φ ahead; it is no crank of another skew."""
        text = typed("new", "swash_pump").partition("[cylinder]")[0].replace('# skew = "0 mm"', 'skew = "12 mm"')
        moved = []
        for running in ("ahead", "astern"):
            of_way = text.replace('# running = "astern"', f'running = "{running}"')
            typed("run", "machine.toml", "-o", f"{running}.csv", "--step", "30", text=of_way)
            lines = Path(f"{running}.csv").read_text(encoding="utf-8").splitlines()
            rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
            (column,) = (name for name in rows[0] if name.startswith("piston_displacement("))
            moved.append([float(row[column]) for row in rows])
        ahead, astern = moved
        assert len(ahead) >= 12
        assert astern[:12] == pytest.approx([ahead[0], *ahead[11:0:-1]], rel=1e-9)
        assert astern != pytest.approx(ahead, rel=1e-3)

    def test_its_pins_may_be_moved_by_the_numbers_that_it_says(self, package, typed, tmp_path):
        text = typed("new", "swash_pump").partition("[cylinder]")[0].replace('# skew = "0 mm"', 'skew = "12 mm"')
        (tmp_path / "pump.toml").write_text(text, encoding="utf-8")
        found = subprocess.run(
            [sys.executable, "-c", HANDLES],
            env={**os.environ, "PYTHONPATH": str(package)},
            capture_output=True,
            text=True,
            check=False,
        )
        assert found.stdout.splitlines() == ["A mechanism.crank_radius", "B mechanism.rod_length mechanism.skew"], (
            found.stderr
        )


HANDLES = """
from cranktrain.io.machine_file import inputs_of, read_machine
from cranktrain.panels.handles import drawn_handles
from cranktrain.plans.placement import first_throw

file = read_machine("pump.toml")
for one in drawn_handles(file.machine, first_throw(file.machine), [one.path for one in inputs_of(file)]):
    print(one.pin, *(path for number in one.numbers for path in number.paths))
"""

ENGINE = """
[shaft.main]
speed = "1500 rpm"
[mechanism]
kind = "slider_crank"
stroke = "80 mm"
rod_length = "136 mm"
[cylinder]
bore = "80 mm"
compression_ratio = 9.5
cycle = "four-stroke"
firing_order = "1"
[gas]
kind = "KIND"
start_pressure = "95 kPa"
compression_exponent = 1.35
expansion_exponent = 1.28
pressure_ratio = 3.5
"""


def test_fluid(typed):
    """It fills a cylinder as that does of which it is a copy."""
    assert typed("run", "machine.toml", text=ENGINE.replace("KIND", "lenoir")) == typed(
        "run", "machine.toml", text=ENGINE.replace("KIND", "otto")
    )
    assert "lenoir" in typed("run", "machine.toml", text=ENGINE.replace("KIND", "steam"), status=2)


DRIVEN = """
[shaft.main]
speed = "60 rpm"
[mechanism]
kind = "slider_crank"
stroke = "80 mm"
rod_length = "136 mm"
[masses.piston]
mass = "2 kg"
[masses.rod]
big_end = "1 kg"
small_end = "0.5 kg"
[masses.crank]
mass = "3 kg"
along = "10 mm"
inertia = "0.4 kg·m²"
[load.work]
on = "piston"
force = "300 N"
[drive.motor]
kind = "spring"
wound_torque = "60 N·m"
free_speed = "70 rpm"
speed = "60 rpm"
torque = "8 N·m"
"""


def test_motor(typed):
    """Each line of the answer is there that a motor has, and what its limits do not know is said."""
    said = " ".join(typed("run", "machine.toml", text=DRIVEN).split())
    for head in ("motor runs at", "torque of the motor", "power of the motor", "motor is used to effective torque"):
        assert head in said
    assert "not checked of it largest torque: nobody wound it so far" in said
    assert "wound spring" in typed("start", "machine.toml", "--help") + typed(
        "plot", "machine.toml", "--plan", "scheme", "-o", "scheme.svg"
    ) + Path("scheme.svg").read_text(encoding="utf-8")
    assert "spring" in typed("run", "machine.toml", text=DRIVEN.replace('"spring"', '"sprung"'), status=2)


def test_question(typed):
    """Table, part, result, row, catalogue, files: all from its folder and four lines."""
    text = DRIVEN + '[noise]\nclearance = "0.1 mm"\n'
    said = " ".join(typed("run", "machine.toml", text=text).split())
    assert "Noise rattles with 0.0006283 m/s" in said
    assert "rattle" in typed("list", "results")
    assert "noise.clearance" in typed("run", "machine.toml", text=text.replace("0.1 mm", "0.1 kg"), status=2)
    assert "how it rattles" not in said
