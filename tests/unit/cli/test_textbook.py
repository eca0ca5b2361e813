"""`textbook` as typed; the errors themselves are held against tables in tests/validation."""

import re

import numpy as np
import pytest
from tests.sentences import IS_IT_THE_EXAMPLE, NO_FILE, TEXTBOOK_WITHOUT_FILE

from cranktrain.texts.errata import ERRATA

CENTRAL = """
[mechanism]
kind = "slider_crank"
crank_radius = "50 mm"
rod_length = "200 mm"
"""


def parts(output: str) -> dict[str, list[str]]:
    """Lines of the page below each heading."""
    heads = re.split(r"\n\n(?=\S)", output.rstrip("\n"))
    return {lines[0]: lines[1:] for lines in (head.splitlines() for head in heads)}


def errors(lines: list[str], piston: str) -> list[float]:
    (row,) = (line.split()[1:] for line in lines if re.match(rf"  {re.escape(piston)}  +−?\d", line))
    return [float(cell.replace("−", "-")) for cell in row]


def test_methods_of_a_central_slider_crank(typed, written):
    """λ = 0.25: docs/theory/textbook-forms has the errors of each method."""
    written(CENTRAL)
    answer = typed("textbook", "machine.toml", "--full")
    assert (answer.status, answer.errors) == (0, "")
    found = parts(answer.output)
    harmonics = found["Two harmonics: (333), (336), (337) [steam-engine]"]
    assert harmonics[:2] == ["  range: central mechanism, λ ≤ 0.3", "  1: inside, λ = 0.25"]
    displacement, _at, velocity, _at, acceleration, _at = errors(harmonics, "1")
    assert (displacement, velocity, acceleration) == (0.10, 0.25 if velocity < 0.255 else 0.26, 0.66)
    brix = found["Brix's construction: fig. 147 [steam-engine]"]
    assert errors(brix, "1")[0] == 0.20
    infinite = next(lines for head, lines in found.items() if head.startswith("Infinitely long rod"))
    assert errors(infinite, "1")[0] == 6.35
    assert any(line == "  1: outside, as λ = 0.25" for line in infinite)
    assert "articulated" not in answer.output
    assert "Кривошипно-шатунный механизм" in answer.output


def test_distinct_pistons_together(typed):
    answer = typed("textbook", "3d12", "--full")
    assert all(len(line) <= 80 for line in answer.output.splitlines())
    found = parts(answer.output)
    assert len(errors(found["Two harmonics: (333), (336), (337) [steam-engine]"], "1L–6L")) == 6
    reconstructed = found["Two harmonics of an articulated rod, reconstructed: (I.13) [bolotin]"]
    # as `run` says of this example
    assert errors(reconstructed, "1R–6R")[::2] == [0.35, 0.94, 2.40]
    assert not any("side" in line for line in reconstructed)


def test_angles_count_from_where_the_crank_points_along_the_cylinder(typed, written):
    """Wherever the axis lies and whatever the sense: (333) is off most at 90° or, as it is symmetric, at 270°."""
    for more in ("", 'crank_zero = "70 deg"\n', 'rotation = "anticlockwise"\n', 'running = "astern"\n'):
        written(more + CENTRAL)
        found = parts(typed("textbook", "machine.toml", "--full").output)
        assert errors(found["Two harmonics: (333), (336), (337) [steam-engine]"], "1")[1] in (90.0, 270.0)


def test_table(typed, written):
    """Exact and (333) at 90°: R + L − √(L² − R²), R(1 + λ/2)."""
    written(CENTRAL)
    output = typed("textbook", "machine.toml", "--full", "--table").output
    assert all(len(line) <= 80 for line in output.splitlines())
    exact = f"{250 - np.sqrt(200**2 - 50**2):.2f}"
    forms = {
        "two harmonics": ("(333)", "56.25"),
        "infinitely long rod": ("(334)", "50.00"),
        "exact root": ("fig. 146", exact),
    }
    for form, (number, by_form) in forms.items():
        lines = parts(output)[_heading(parts(output), f"S, c/ω, j/ω² of 1 by {form}")]
        units = lines.index(next(line for line in lines if line.split()[0] == "mm"))
        assert lines[units - 1].strip().startswith(f"{number}  ")
        assert lines[units].split() == ["mm", "mm", "mm/rad", "mm/rad", "mm/rad²", "mm/rad²"]
        rows = {line.split()[0]: line.split()[1:] for line in lines[units + 1 :]}
        assert list(rows) == [f"{angle}°" for angle in range(0, 360, 30)]
        assert rows["90°"][:2] == [by_form, exact]


def test_table_once_for_pistons_that_move_alike(typed):
    output = typed("textbook", "3d12", "--full", "--table").output
    assert re.findall(r"^S, c/ω, j/ω² of (\S+) by", output, re.MULTILINE) == ["1L–6L"] * 4
    assert re.findall(r"^S, v/ω, j/ω² of (\S+) by", output, re.MULTILINE) == ["1R–6R"] * 2


def test_a_mechanism_of_which_no_source_speaks(typed):
    answer = typed("textbook", "shaper")
    assert answer.status == 0
    assert "None of the texts has a form of its own for the motion of: chain." in answer.output


@pytest.mark.parametrize("arguments", [["errata"], ["--errata"]])
def test_errata(typed, arguments):
    output = typed("textbook", *arguments, "--full").output
    assert all(len(line) <= 80 for line in output.splitlines())
    assert len(re.findall(r"^\d+\. ", output, re.MULTILINE)) == sum(len(errors()) for errors in ERRATA.values())
    # r/tan 30° for r = 80 mm, with its true pressure angle asin(tan 30°)
    assert re.search(r"printed +l = r/tg \[α\]\n +gives +138\.56 mm\n +right +160 mm\n +because +the pressure", output)
    assert f"gives    {np.degrees(np.arcsin(np.tan(np.pi / 6))):.2f}°" in output


def test_errata_beside_a_machine(typed):
    output = typed("textbook", "vaz_21213", "--errata").output
    assert output.index("Brix") < output.index("Errors of the sources")


def test_a_file_called_errata_is_a_file(typed, written):
    written(CENTRAL, "errata")
    assert "Two harmonics" in typed("textbook", "errata", "--full").output


def test_set(typed, written):
    written(CENTRAL)
    output = typed("textbook", "machine.toml", "--full", "--set", "mechanism.rod_length=500 mm").output
    assert "λ = 0.1\n" in output


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], f"{TEXTBOOK_WITHOUT_FILE}; such as: cranktrain textbook 3d12, or cranktrain textbook --source\n"),
        (["3d12", "--set", "x"], "--set  x: must be PATH=VALUE, such as shaft.main.speed=1500rpm\n"),
        (["3d13"], f"3d13  {NO_FILE}{IS_IT_THE_EXAMPLE} `cranktrain list` names all\n"),
    ],
)
def test_refused(typed, arguments, said):
    assert typed("textbook", *arguments) == (2, "", said)


def test_brix_backwards_beside_exact(typed, written):
    """λ = 0.25: 0.32° at most, docs/theory/textbook-forms; OP = λR/2; half the stroke at cos φ = (R² + L² − L²)/2RL."""
    written(CENTRAL)
    found = parts(typed("textbook", "machine.toml", "--full", "--table").output)
    distance, error, _place = errors(found["Brix's construction backwards: fig. 147 [steam-engine]"], "1")
    assert (distance, abs(error)) == (6.25, 0.32)
    rows = {line.split()[0]: line.split()[2:] for line in found[_heading(found, "φ of ram 1")][2:]}
    middle = np.degrees(np.arccos(50 / (2 * 200)))  # triangle of 50, 200 and 200 mm
    assert rows["50.00"] == [f"{np.degrees(np.arctan2(1, 0.125)):.2f}", f"{middle:.2f}", "0.06"]


def _heading(found, start):
    return next(heading for heading in found if heading.startswith(start))


def test_constructions_are_of_slider_cranks(typed):
    assert "Arcs of" not in typed("textbook", "pumping_unit_c57").output


ECC2 = """
name = "valve"
rotation = "clockwise"
[shaft.main]
speed = "120 rpm"
[bank.cylinder.mechanism]
kind = "slider_crank"
crank_radius = "300 mm"
rod_length = "1200 mm"
[bank.valve.mechanism]
kind = "eccentric"
eccentricity = "60 mm"
rod_length = "1200 mm"
angle_of_advance = "30 deg"
"""


def test_an_eccentric_beside_its_crank(typed, written):
    """λ = 0.05: (334) is off by (L − √(L² − R²))/2R = 1.2508 %, (333) by λ³/16 = 7.8e-6; Z = 1.5 mm."""
    written(ECC2)
    answer = typed("textbook", "machine.toml", "--full")
    assert (answer.status, answer.errors) == (0, "")
    assert all(len(line) <= 80 for line in answer.output.splitlines())
    found = parts(answer.output)
    harmonics = found["Two harmonics: (333), (336), (337) [steam-engine]"]
    assert harmonics[1] == "  1cylinder: inside, λ = 0.25; 1valve: inside, λ = 0.05"
    assert errors(harmonics, "1valve")[0] == 0.00078
    infinite = next(lines for head, lines in found.items() if head.startswith("Infinitely long rod"))
    assert errors(infinite, "1valve")[:2] == [1.25, 90.0]
    assert "  1cylinder: outside, as λ = 0.25; 1valve: inside, λ = 0.05" in infinite
    assert errors(found["Z = λR/2: (335) [steam-engine]"], "1valve") == [1.50, 1.50, -0.063]
    assert errors(found["Brix's construction backwards: fig. 147 [steam-engine]"], "1valve")[0] == 1.50
    root = found["Exact root: fig. 146 [steam-engine]"]
    assert [line.split() for line in root if "1cylinder, 1valve  " in line] == [["1cylinder,", "1valve"] + ["0.00"] * 3]
    assert any("exact: off by 0" in line for line in root)


def test_tables_of_an_eccentric_are_of_a_valve(typed, written):
    """From where the eccentric points along its line: of 60 mm on a rod of 1200 mm, by hand."""
    written(ECC2)
    found = parts(typed("textbook", "machine.toml", "--full", "--table").output)
    form = found["S, c/ω, j/ω² of 1valve by two harmonics"]
    rows = {line.split()[0]: line.split()[1:] for line in form[2:]}
    assert rows["0°"][:4] == ["0.00"] * 4
    assert rows["90°"][:2] == ["61.50", f"{1260 - np.sqrt(1200**2 - 60**2):.2f}"]
    assert rows["180°"][:2] == ["120.00"] * 2
    minus = found["S, v/ω and j/ω² of valve 1valve from the crank-side dead centre"]
    # R(1 − 0 − λ/2) and L − … of the triangle: 60 − 1.5, 60 − (1200 − √(1200² − 60²))
    assert next(line.split()[1:3] for line in minus if line.startswith("  90°")) == ["58.50", "58.50"]


def test_harmonics_of_an_eccentric(typed, written):
    """A_2 = λ by two harmonics."""
    written(ECC2)
    output = typed("textbook", "machine.toml", "--harmonics").output
    heading = "Acceleration of 1valve, λ = 0.05: x″ = R Σ A_k cos kα"
    (row,) = (line.split() for line in parts(output)[heading] if line.startswith("  A_2 "))
    assert row[4] == "0.0500000000"


def test_an_eccentric_of_the_examples(typed):
    """λ = 3.5e-5: (333) is off by λ³/16 = 2.7e-15 of the stroke, which is shown as none, however long the rod is."""
    found = parts(typed("textbook", "great_northern", "--full").output)
    assert errors(found["Two harmonics: (333), (336), (337) [steam-engine]"], "1valve") == [0.0, 0.0, 0.0]
    infinite = next(lines for head, lines in found.items() if head.startswith("Infinitely long rod"))
    assert errors(infinite, "1valve")[0] == 0.00088  # λ/4
