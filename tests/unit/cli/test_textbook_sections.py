"""What `textbook FILE` has beside errors of the forms: minus signs, Z, opposed pistons, constants, crank-rockers."""

import re

import numpy as np
import pytest

CENTRAL = """
[mechanism]
kind = "slider_crank"
crank_radius = "50 mm"
rod_length = "200 mm"
"""

CRANK_ROCKER = """
[mechanism]
kind = "crank_rocker"
crank_radius = "100 mm"
rod_length = "360 mm"
rocker_length = "280 mm"
ground_length = "400 mm"
"""

OPPOSED = """
[shaft.upper]

[bank.A]
lead = "12 deg"
[bank.A.exhaust.mechanism]
kind = "slider_crank"
crank_radius = "100 mm"
rod_length = "500 mm"
[bank.A.scavenge]
shaft = "upper"
[bank.A.scavenge.mechanism]
kind = "slider_crank"
crank_radius = "100 mm"
rod_length = "333.33333333333 mm"
"""


def parts(output):
    heads = re.split(r"\n\n(?=\S)", output.rstrip("\n"))
    return {lines[0]: lines[1:] for lines in (head.splitlines() for head in heads)}


def rows(lines):
    """Numbers of the rows of a table by their labels of one word."""
    return {
        cells[0]: [float(cell) for cell in cells[1:]]
        for cells in (line.replace("−", "-").split() for line in lines)
        if len(cells) > 1 and all(re.fullmatch(r"-?\d+(\.\d+)?", cell) for cell in cells[1:])
    }


def test_minus_signs(typed, written):
    """R = 50, L = 200 mm: R(1 − cos φ ∓ (λ/2) sin²φ) and its derivatives by hand; from the crank side λ is −1/4."""
    written(CENTRAL)
    found = parts(typed("textbook", "machine.toml", "--full", "--table").output)
    table = rows(found["S, v/ω and j/ω² of ram 1 from the crank-side dead centre"])
    assert list(table) == [f"{angle}°" for angle in range(0, 360, 30)]
    for label, values in table.items():
        phi = np.radians(float(label.rstrip("°")))
        forms = (
            50 * (1 - np.cos(phi) - np.sin(phi) ** 2 / 8),
            50 * (np.sin(phi) - np.sin(2 * phi) / 8),
            50 * (np.cos(phi) - np.cos(2 * phi) / 4),
        )
        assert values[::2] == [pytest.approx(value, abs=0.0051) for value in forms]
        along = np.sqrt(200**2 - (50 * np.sin(phi)) ** 2)
        assert values[1] == pytest.approx(along - 50 * np.cos(phi) - 150, abs=0.0051)
    errors = rows(found["(333), (336), (337) from the crank-side dead centre [steam-engine]"])["1"]
    assert errors[::2] == [0.10, 0.26, 0.66]


def test_largest_difference(typed, written):
    """(335): λR/2 = 6.25 mm; L − √(L² − R²) = 6.351 mm."""
    written(CENTRAL)
    (values,) = rows(
        parts(typed("textbook", "machine.toml", "--full").output)["Z = λR/2: (335) [steam-engine]"]
    ).values()
    by_hand = 200 - np.sqrt(200**2 - 50**2)
    assert values == [6.25, round(by_hand, 2), round(100 * (6.25 / by_hand - 1), 2)]


def test_reason_for_which_a_machine_is_outside(typed, written):
    written(CENTRAL + 'offset = "5 mm"\n')
    output = typed("textbook", "machine.toml", "--full").output
    assert "1: outside, as the line of stroke is offset by 5.00 mm" in output
    assert "outside, as λ = 0.25 and the line of stroke is offset by 5.00 mm" in output


def test_opposed_pistons_of_unequal_rods(typed, written):
    """λ = 0.20 and 0.30, Δ = 12°: dead centres +0.24° and −0.40° off half the lead; travel by (I.11), (I.12)."""
    written(OPPOSED)
    answer = typed("textbook", "machine.toml", "--full", "--table")
    assert (answer.status, answer.errors) == (0, "")
    assert all(len(line) <= 80 for line in answer.output.splitlines())
    found = parts(answer.output)
    centres = rows(found["Volumetric dead centres [bolotin]"])
    assert centres["inner"] == [6.0, pytest.approx(6.24, abs=0.006), 6.24]
    assert centres["outer"] == [186.0, pytest.approx(185.6, abs=0.006), 185.6]
    assert "fig. 1.3 а: two shafts that turn alike." in answer.output
    assert "Cranks or rods differ: half the lead is no dead centre." in " ".join(answer.output.split())
    table = rows(found["Travel S of the pistons of 1 by the exhaust crank's angle"])
    for label, values in table.items():
        alpha = np.radians(float(label.rstrip("°")))
        exhaust, scavenge = (
            100 * (1 + lam / 4 - np.cos(theta) - lam / 4 * np.cos(2 * theta))
            for lam, theta in ((0.2, alpha), (0.3, alpha - np.radians(12)))
        )
        assert values[::2] == [pytest.approx(value, abs=0.0051) for value in (exhaust, scavenge, exhaust + scavenge)]
    # j/ω² at α = 0: R(1 + λ) of the exhaust, R(cos Δ + λ cos 2Δ) of the scavenge piston, by (337)
    second = 100 * (np.cos(np.radians(12)) + 0.3 * np.cos(np.radians(24)))
    assert rows(found["Their j/ω²"])["0°"][::2] == pytest.approx([120, second, 120 + second], abs=0.0051)


def test_lead_of_the_10d100_ahead_and_astern(typed):
    """The digest: 60/50 mm ports, Δ = 12°: exhaust 17.8° before the scavenge ports ahead, 6.2° after them astern."""
    said = " ".join(typed("textbook", "10d100", "--full").output.split())
    assert "12.00°: suits engines that turn one way (10–15°), too much for engines that reverse (5–10°)" in said
    assert "the exhaust ports open 17.81° before the scavenge ports" in said
    assert "the lead is −12.00°, and they open 6.19° after them: gas blows back into the receiver" in said


def test_a_lead_that_suits_a_reversing_engine(typed):
    """The digest: Δ = 5° opens exhaust 10.8° before ahead, and 0.8° before astern."""
    said = " ".join(typed("textbook", "10d100", "--full", "--set", "bank.A.lead=5 deg").output.split())
    assert "too little for engines that turn one way (10–15°), suits engines that reverse (5–10°)" in said
    assert re.search(r"open 10\.8\d° before the scavenge ports", said)
    assert re.search(r"they open 0\.8\d° before them\.", said)


ONE_SHAFT = """
name = "one shaft"
rotation = "clockwise"
[shaft.main]
throws = ["0 deg", "170 deg"]
speed = "300 rpm"
[bank.A.exhaust]
throws = [1]
[bank.A.exhaust.mechanism]
kind = "slider_crank"
crank_radius = "450 mm"
rod_length = "1800 mm"
[bank.A.scavenge]
side_rods = true
throws = [2]
[bank.A.scavenge.mechanism]
kind = "slider_crank"
crank_radius = "350 mm"
rod_length = "3000 mm"
[cylinder]
bore = "600 mm"
cycle = "two-stroke"
"""


def test_opposed_pistons_on_one_shaft(typed, written):
    """The far piston by hand: R(1 − cos θ − (λ/2) sin²θ) from where its crank points away, 10° behind the exhaust's."""
    written(ONE_SHAFT)
    answer = typed("textbook", "machine.toml", "--source", "bolotin", "--table", "--full")
    assert (answer.status, answer.errors) == (0, "")
    assert all(len(line) <= 80 for line in answer.output.splitlines())
    said, found = " ".join(answer.output.split()), parts(answer.output)
    assert "10.00°: suits engines that turn one way (10–15°), suits engines that reverse (5–10°)" in said
    assert "The scavenge piston is the far one, on side rods" in said
    first_order = 10 * 350 * (1 - 350 / 3000) / (450 * 1.25 + 350 * (1 - 350 / 3000))
    centres = rows(found["Volumetric dead centres [bolotin]"])
    assert centres["inner"] == [5.0, pytest.approx(first_order, abs=0.0051), 3.55]
    for label, values in rows(found["Travel S of the pistons of 1 by the exhaust crank's angle"]).items():
        alpha = np.radians(float(label.rstrip("°")))
        theta = alpha - np.radians(10)
        near = 450 * (1 - np.cos(alpha) + 0.125 * np.sin(alpha) ** 2)
        far = 350 * (1 - np.cos(theta) - 350 / 6000 * np.sin(theta) ** 2)
        assert values[::2] == [pytest.approx(value, abs=0.0051) for value in (near, far, near + far)]


def test_constants_of_an_articulated_rod(typed):
    """docs/theory/textbook-forms has those of the rods often quoted, to six digits."""
    found = parts(typed("textbook", "3d12_quoted_rods", "--full").output)
    lines = found["Constants of (I.13) for 1R–6R [bolotin]"]
    second = lines.index("")
    tables = [lines[:second], lines[second + 1 :]]
    assert [table[0].split() for table in tables] == [["E", "Φ", "F", "Θ"], ["K", "H"]]
    cells: dict[str, list[float]] = {}
    for line in (line for table in tables for line in table[2:]):
        label, *numbers = re.split(r" {2,}", line.strip())
        cells.setdefault(label, []).extend(map(float, numbers))
    assert cells["first two harmonics of the exact motion"][:5] == [1.038943, 1.2938, 0.257358, 20.929, 310.325]
    assert cells["derived anew"][:5] == [1.038345, 1.2207, 0.248843, 20.810, 310.514]
    assert cells["reconstructed"][:5] == [1.038409, 1.2162, 0.246656, 20.927, 310.749]
    assert cells["exact motion"] == [pytest.approx(409.1306827999, abs=5e-4)]  # of the reference case articulated_V2


def rocker_directions(alpha):
    """Directions of crank, rod and rocker of 100, 360, 280 and 400 mm, by the cosine rule; joint on the left."""
    pin = 100 * np.exp(1j * alpha)
    diagonal = 400 - pin
    along = (360**2 - 280**2 + abs(diagonal) ** 2) / (2 * abs(diagonal))
    joint = pin + diagonal / abs(diagonal) * (along + 1j * np.sqrt(360**2 - along**2))
    return alpha, np.angle(joint - pin), np.angle(joint - 400)


def test_pins_of_a_crank_rocker(typed, written):
    """(10) by hand, its exactness by a difference of the rocker's angle over 2·10⁻⁶ rad."""
    written(CRANK_ROCKER)
    answer = typed("textbook", "machine.toml", "--full", "--table")
    assert (answer.status, answer.errors) == (0, "")
    assert all(len(line) <= 80 for line in answer.output.splitlines())
    table = rows(parts(answer.output)["v_A/v_B by the crank's angle α from the line of the fixed pivots"])
    for label, (exact, by_sines, refuted, square, torque) in table.items():
        alpha, beta, rocker = rocker_directions(np.radians(float(label.rstrip("°"))))
        ratio = np.sin(alpha - beta) / np.sin(rocker - beta)
        turned = rocker_directions(alpha + 1e-6)[2] - rocker_directions(alpha - 1e-6)[2]
        assert exact == pytest.approx(turned / 2e-6 * 280 / 100, abs=6e-5)
        assert by_sines == pytest.approx(ratio, abs=6e-5)
        assert refuted == pytest.approx(np.sin(alpha - beta) * np.sin(rocker - beta), abs=6e-5)
        assert square == pytest.approx(ratio**2, abs=6e-5)
        assert torque == pytest.approx(100 * ratio, abs=6e-3)
    grid = np.radians(np.arange(0, 360, 0.1))
    _crank, beta, rocker = rocker_directions(grid)
    ratio = np.sin(grid - beta) / np.sin(rocker - beta)
    said = " ".join(answer.output.split())
    assert f"from −{-ratio.min():.4f} to {ratio.max():.4f}, where" in said
    assert "(13) prints r₁ = 280.00 mm where by (12) and (4) it must be r = 100.00 mm" in said
    assert "Largest errors over the turn" not in said


def test_small_errors_have_two_figures(typed, written):
    """λ = 0.1: (333) is off by 6.3e-5 of the stroke."""
    written(CENTRAL.replace("200 mm", "500 mm"))
    found = parts(typed("textbook", "machine.toml", "--full").output)
    assert rows(found["Two harmonics: (333), (336), (337) [steam-engine]"])["1"][::2] == [0.0063, 0.016, 0.046]
