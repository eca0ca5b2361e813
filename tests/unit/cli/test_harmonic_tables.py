"""`textbook --harmonics` as typed, against quadrature in 40 digits."""

import mpmath
import pytest
from tests.sentences import A_RATIO, FOR_MOTION_OR_FORCES, TEXTBOOK_WITHOUT_FILE

CENTRAL = """
[mechanism]
kind = "slider_crank"
crank_radius = "45 mm"
rod_length = "150 mm"
"""


def harmonic(ratio, order, *, is_torque):
    """Fourier coefficient of x″/R or of −x′x″/R², by the periodic trapezoid, which leaves λ¹⁰⁰ of it."""
    with mpmath.workdps(40):
        lam, total, n_points = mpmath.mpf(ratio), mpmath.mpf(0), 200
        for i in range(n_points):
            phi = 2 * mpmath.pi * i / n_points
            sin, cos = mpmath.sin(phi), mpmath.cos(phi)
            root = mpmath.sqrt(1 - (lam * sin) ** 2)
            acceleration = cos + lam * (cos**2 - sin**2) / root + lam**3 * (sin * cos) ** 2 / root**3
            velocity = sin + lam * sin * cos / root
            total += (
                -velocity * acceleration * mpmath.sin(order * phi)
                if is_torque
                else acceleration * mpmath.cos(order * phi)
            )
        return float(2 * total / n_points)


def tables(output: str) -> dict[str, list[str]]:
    """Cells by the label of their row."""
    rows = (line.split() for line in output.replace("−", "-").splitlines() if line.startswith(("  A_", "  D_")))
    return {row[0]: row[1:] for row in rows}


@pytest.mark.parametrize("is_file", [True, False])
def test_exact_harmonics_and_what_the_texts_leave(typed, written, is_file):
    written(CENTRAL)
    answer = typed("textbook", *(["machine.toml", "--harmonics"] if is_file else ["--crank-to-rod-ratio", "0.3"]))
    assert (answer.status, answer.errors) == (0, "")
    assert all(len(line) <= 80 for line in answer.output.splitlines())
    whose = "1, λ = 0.3" if is_file else "λ = 0.3"
    assert f"Acceleration of {whose}: x″ = R Σ A_k cos kα" in answer.output.splitlines()
    found = tables(answer.output)
    assert list(found) == ["A_1", "A_2", "A_4", "A_6", "A_8", *(f"D_{order}" for order in range(1, 7))]
    for label, (exact, series, off_by_series, two, off_by_two) in found.items():
        expected = harmonic("0.3", int(label[2:]), is_torque=label.startswith("D"))
        assert float(exact) == pytest.approx(expected, rel=0, abs=0.51e-10), label
        for form, error in ((series, off_by_series), (two, off_by_two)):
            assert float(error) == pytest.approx(float(form) - expected, rel=0.06, abs=1e-10), label
    assert [found[label][3] for label in ("A_2", "A_4", "D_3", "D_5")] == ["0.3000000000", "0", "-0.2250000000", "0"]


def test_pistons_of_one_ratio_share_a_table(typed):
    heads = [line for line in typed("textbook", "3d12", "--harmonics").output.splitlines() if line.startswith("Acc")]
    assert heads == ["Acceleration of 1L–6L, λ = 0.2812: x″ = R Σ A_k cos kα"]


def test_an_offset_mechanism_has_none(typed):
    assert (
        "  Only a central slider-crank or eccentric has them in closed form."
        in typed("textbook", "vaz_21213", "--harmonics").output.splitlines()
    )


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--harmonics"], [f"{TEXTBOOK_WITHOUT_FILE}; such as: cranktrain textbook 3d12 --harmonics"]),
        (["--crank-to-rod-ratio", "1"], ["--crank-to-rod-ratio = 1: must be at most 0.9999"]),
        (["--crank-to-rod-ratio", "0.2", "--set", "a=b"], ["--set = a=b: is for a machine: name FILE"]),
        (
            ["3d12", "--crank-to-rod-ratio", "1,2", "--forces", "N", "--table"],
            [
                f"--table: {FOR_MOTION_OR_FORCES}",
                f"--forces = N: {FOR_MOTION_OR_FORCES}",
                f'--crank-to-rod-ratio = 1,2: {A_RATIO}; write "1.2"',
                "FILE = 3d12: has ratios of its own: give one or the other",
            ],
        ),
    ],
)
def test_what_is_refused(typed, arguments, said):
    answer = typed("textbook", *arguments)
    assert (answer.status, answer.output) == (2, "")
    assert answer.errors.splitlines() == said
