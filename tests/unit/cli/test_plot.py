"""What `plot` takes and refuses; what is in the pictures is tested where they are drawn, and in tests/e2e."""

import pytest
from tests.sentences import (
    ALREADY_THERE,
    AT_MOST_TO_A_SHEET,
    BETWEEN_COMMAS,
    CANNOT_CLOSE_THERE,
    ENDS_IN,
    FOLDER_NOT_THERE,
    GIF_OF_ONE_TURN,
    IS_IT_THE_EXAMPLE,
    MISSING_FOR_DIAGRAM,
    NO_FILE,
    NOT_ITS_MECHANISM,
    RUNNING_SPEED_NEEDS,
    STEADY_RUNNING,
    WHOLE_MACHINE,
    WITHOUT_ROD,
)

import cranktrain as ct
from cranktrain.cli.plot import PlotRequest, understood
from cranktrain.panels.sheets import PICTURES
from cranktrain.plans.positions import source_angles
from cranktrain.quantities import units_by_dimension

NAMES = {kind: ", ".join(one.name for one in PICTURES if one.kind == kind) for kind in ("plan", "sheet")}


@pytest.mark.parametrize(
    ("plan", "at", "output", "angles"),
    [
        ("positions", "12", "a.svg", [12.0]),
        ("positions", "30,60", "a.svg", [30.0, 60.0]),
        ("positions", " 30 , 0.5 rad, -1°", "a.svg", [30.0, 28.647889757, -1.0]),  # 0.5 · 180/π
        ("klein", "60 deg", "a.PDF", [60.0]),
        ("velocities", None, "a.png", None),
        ("positions", "source", "a.png", "source"),
        (None, "8", "a.dxf", [8.0]),
        (None, "7.5,90", "a.dxf", [7.5, 90.0]),
        (None, "137", "a.png", [137.0]),
    ],
)
def test_crank_angles_as_typed(plan, at, output, angles):
    assert understood(PlotRequest("3d12", plan=plan, at=at, output=output)).angles == angles


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (
            ["3d12"],
            ["-o: is missing: the name of the picture, which ends in one of: .png, .svg, .pdf, .gif, .dxf; "
             "such as: cranktrain plot 3d12 -o 3d12.png"],
        ),
        (
            ["3d12", "-o", "a.txt", "--plan", "positons", "--at", "3,b", "--size", "A5"],
            [
                f"-o = a.txt: {ENDS_IN}.png, .svg, .pdf, .gif, .dxf",
                f'--plan = positons: must be one of: {NAMES["plan"]}; write "positions"',
                "--size = A5: must be one of: A4, A3",
                f"--at = 3,b: {BETWEEN_COMMAS}, such as 30,60",
            ],
        ),
        (
            ["3d12", "-o", "a.gif", "--plan", "positions", "--size", "A3"],
            [
                f"--plan = positions: {GIF_OF_ONE_TURN}",
                f"--size = A3: {GIF_OF_ONE_TURN}",
            ],
        ),
        (
            ["3d12", "-o", "a.png", "--mechanism", "1R", "--at", "30,60"],
            [
                "--at = 30,60: must be one crank angle; for several, ask for a --plan",
            ],
        ),
        (
            ["3d12", "-o", "a.svg", "--plan", "polar", "--sheet", "force"],
            [
                "--sheet = force: must be left out: a picture is a plan or a sheet",
                f'--sheet = force: must be one of: {NAMES["sheet"]}; write "forces"',
            ],
        ),
        (
            ["3d12", "-o", "a.svg", "--sheet", "forces", "--at", "30"],
            ["--at = 30: must be left out: the sheet of forces has the whole cycle"],
        ),
        (
            ["3d12", "-o", "a.svg", "--plan", "forces", "--at", "30,60,90"],
            ["--at  3 crank angles: must be at most 2 for polygons of forces"],
        ),
        (
            ["3d12", "-o", "a.svg", "--plan", "polar", "--mechanism", "1R"],
            [f"--mechanism = 1R: {WITHOUT_ROD}"],
        ),
        (
            ["3d12", "-o", "a.dxf", "--plan", "klein"],
            ["--plan = klein: must be left out: a .dxf holds all plans, in true millimetres"],
        ),
        (
            ["3d12", "-o", "a.svg", "--plan", "mertsalov", "--at", "30", "--mechanism", "1L"],
            [
                f"--at = 30: must be left out: {WHOLE_MACHINE}",
                f"--mechanism = 1L: must be left out: {WHOLE_MACHINE}",
            ],
        ),
        (
            ["vaz_21213", "-o", "a.dxf", "--mechanism", "9R"],
            [f"--mechanism = 9R: {NOT_ITS_MECHANISM}: 1, 2, 3, 4"],
        ),
        (
            ["3d12", "-o", "a.svg", "--plan", "positions", "--count", "60"],
            [f"--count  60 crank angles: must be {AT_MOST_TO_A_SHEET}"],
        ),
        (
            ["3d12", "-o", "a.svg", "--plan", "positions", "--count", "12", "--at", "30", "--scale", "4"],
            ["--count = 12: must be left out beside --at", "--scale = 4: must be a scale, such as 1:4"],
        ),
        (
            ["3d12", "-o", "a.svg", "--count", "12"],
            ["--count = 12: must be left out: only a plan or a .dxf is at several"],
        ),
        (
            ["3d12", "-o", "a.svg", "--plan", "klein", "--scale", "1:4", "--at", "source"],
            [
                "--scale = 1:4: must be left out: only for sheet machine, plan positions, plan arc, plan projection, "
                "plan brix, plan brix-backward",
                f"--at = source: {BETWEEN_COMMAS}, such as 30,60",
            ],
        ),
        (
            ["vaz_21213", "-o", "a.svg", "--plan", "positions", "--scale", "1:1"],
            ["--scale = 1:1: is too large for the paper: at most 1:2"],
        ),
        (
            ["3d12", "-o", "a.svg", "--plan", "scheme", "--letters", "gandzha"],
            ["--letters = gandzha: has no figure of such a mechanism as 1R"],
        ),
        (
            ["3d12", "-o", "a.svg", "--plan", "scheme", "--letters", "bolotin", "--at", "30,60"],
            ["--at  2 crank angles: must be one for a scheme"],
        ),
        (
            ["textbook_78x78", "-o", "a.svg", "--plan", "positions", "--at", "source 95"],
            ["--at = source 95: must be `source` with one angle from 0 to 90°: source 30"],
        ),
        (["3d12", "-o", "a.svg", "--at", ""], [f"--at = \"\": {BETWEEN_COMMAS}, "
                                               "such as 30,60"]),
        (
            ["mud_pump_12p160", "-o", "a.svg", "--running-speed"],
            [RUNNING_SPEED_NEEDS],
        ),
        (
            ["mud_pump_12p160", "-o", "a.svg", "--plan", "accelerations", "--running-speed"],
            [RUNNING_SPEED_NEEDS],
        ),
        (
            ["3d12", "-o", "a.svg", "--plan", "wittenbauer", "--running-speed"],
            ["--running-speed: must be left out: this diagram is what the running speed is found from"],
        ),
        (
            ["3d12", "-o", "a.svg", "--plan", "Klein", "--running-speed"],
            ["--running-speed: must be left out: Klein's construction is for a crank that turns evenly; "
             "ask for accelerations"],
        ),
        (
            ["3d12", "-o", "a.svg", "--plan", "brix", "--running-speed"],
            ["--running-speed: must be left out: this plan is the same at every speed"],
        ),
        (
            ["3d12", "-o", "a.gif", "--running-speed"],
            ["--running-speed: must be left out: a .gif shows positions in even steps of the crank angle"],
        ),
        (["3d13", "-o", "a.svg"], [f"3d13  {NO_FILE}{IS_IT_THE_EXAMPLE} "
                                   "`cranktrain list` names all"]),
        (["3d12", "-o", "no/a.svg"], [f"no/a.svg  {FOLDER_NOT_THERE}; make it first, or name another"]),
    ],
)  # fmt: skip
def test_refused_with_everything_that_is_wrong(typed, tmp_path, arguments, said):
    answer = typed("plot", *arguments)
    assert (answer.status, answer.output) == (2, "")
    assert answer.errors.splitlines() == said
    assert list(tmp_path.iterdir()) == []


def test_klein_of_another_mechanism(typed):
    answer = typed("plot", "pumping_unit_c57", "-o", "a.svg", "--plan", "klein")
    assert answer.status == 2
    assert "is no slider-crank" in answer.errors


def test_links_that_never_close_where_asked(typed, written):
    """A rod of 30 mm does not reach from a pin 40 mm from the line of stroke: none is drawn at 90°."""
    written('[mechanism]\nkind = "slider_crank"\nstroke = "80 mm"\nrod_length = "30 mm"\n')
    arguments = ("plot", "machine.toml", "-o", "a.svg", "--plan", "positions")
    assert typed(*arguments).errors.startswith("machine.toml:4:14  mechanism.rod_length = 30 mm")
    answer = typed(*arguments, "--partial", "--at", "90 deg")
    assert answer.errors == f"--at  φ = 90°: the links of 1 {CANNOT_CLOSE_THERE}\n"
    assert typed(*arguments, "--partial", "--at", "0,180").output == "written: a.svg\n"


def test_a_picture_is_kept_unless_forced(typed, tmp_path):
    path = tmp_path / "a.svg"
    path.write_text("old\n", encoding="utf-8")
    arguments = ("plot", "vaz_21213", "--plan", "klein", "-o", "a.svg")
    answer = typed(*arguments)
    assert answer == (2, "", f"a.svg  {ALREADY_THERE}, or replace it with --force\n")
    assert path.read_text(encoding="utf-8") == "old\n"
    assert typed(*arguments, "--force") == (0, "written: a.svg\n", "")
    assert path.read_text(encoding="utf-8").startswith("<?xml")


@pytest.mark.parametrize(
    "kind",
    [
        ("a.svg",),
        ("a.svg", "--sheet", "forces"),
        ("a.svg", "--plan", "forces"),
        ("a.svg", "--plan", "accelerations"),
        ("a.dxf",),
    ],
)
def test_at_the_running_speed(typed, tmp_path, kind):
    assert typed("plot", "vaz_21213", "--running-speed", "-o", *kind) == (0, f"written: {kind[0]}\n", "")
    drawn = (tmp_path / kind[0]).read_text(encoding="utf-8")
    assert STEADY_RUNNING in drawn


def test_diagram_of_the_flywheel(typed, tmp_path):
    engine = tmp_path / "engine.toml"
    engine.write_text(
        """[shaft.main]
speed = "900 rpm"
[mechanism]
kind = "slider_crank"
crank_radius = "50 mm"
rod_length = "180 mm"
[masses]
piston = { mass = "1.2 kg" }
[evenness]
mean = "extremes"
""",
        encoding="utf-8",
    )
    arguments = ("plot", str(engine), "--plan", "wittenbauer", "-o", str(tmp_path / "a.svg"))
    answer = typed(*arguments)
    assert answer.status == 2
    assert "evenness" in answer.errors
    assert f"{MISSING_FOR_DIAGRAM}[evenness] coefficient" in answer.errors
    assert typed(*arguments, "--set", "evenness.coefficient=0.001").status == 0
    assert (tmp_path / "a.svg").read_text(encoding="utf-8").startswith("<?xml")


def test_how_many_angles_a_scale_and_the_permissible_angle_as_typed():
    """Of 160 mm stroke and a rod of 160 mm at the permissible 30°: steps of 30°, as the source draws them."""
    found = understood(PlotRequest("3d12", plan="positions", count="12", scale="2:1", output="a.svg"))
    assert (found.angles, found.scale) == (12, 0.5)
    found = understood(PlotRequest("3d12", plan="brix", at="source 30", output="a.svg"))
    assert (found.angles, found.permissible) == ("source", 30.0)
    press = {"kind": "slider_crank", "stroke": "160 mm", "rod_length": "270 mm"}
    angles = source_angles(ct.Machine(mechanism=press), permissible=30.0)
    assert angles == (0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330)


@pytest.mark.parametrize(
    ("units", "said"),
    [
        ("bqr", "--units = bqr: must be units with commas between, such as bar,kW,in; did you mean bar?"),
        ("psi,bar", "--units = bar: must not stand beside psi, of the same"),
        ("psig", "--units = psig: counts from the atmosphere, which mean pressures do not; write psi"),
    ],
)
def test_units_as_run_takes_them(typed, units, said):
    for command in (("plot", "3d12", "-o", "a.svg"), ("run", "3d12")):
        assert said in typed(*command, "--units", units).errors
    assert "--plan = positons" in typed("plot", "3d12", "-o", "a.svg", "--plan", "positons", "--units", units).errors


def test_units_asked_for_are_understood():
    assert understood(PlotRequest("3d12", output="a.svg", units="psi, in")).units == units_by_dimension(["psi", "in"])
