"""`run --why`: from a printed number to its quantity, equation, stages and inputs."""

import pytest


def test_where_a_side_force_is_from(typed):
    output = typed("run", "3d12", "--why", "side_force").output
    assert "N [N]: Force of the wall on the piston toward +y" in output
    assert "docs/theory/forces, eqs. (13.10), (13.31)" in output
    assert "piston_force_set" in output
    assert "5.572  kN" in output  # as the screen of the machine says it
    assert "largest_side_force" in output
    rests = output[output.index("What this rests on") :]
    assert "masses.piston.mass" in rests
    assert "gas.cut_off_ratio" in rests


def test_a_stroke_rests_on_no_gas(typed):
    output = typed("run", "3d12", "--why", "stroke").output
    rests = output[output.index("What this rests on") :]
    assert "bank.L.mechanism.stroke" in rests
    assert "bank.R.mechanism.knuckle_radius" in rests
    assert "gas." not in rests
    assert "masses." not in rests


@pytest.mark.parametrize(
    ("line", "first", "others"),
    [
        ("side force", "N_max [N]: Largest force of the wall, on either side", "side_force"),
        ("excess work", "ΔA [J]: Largest excess work", "excess_work"),
        ("true  top dead centre ", "Top dead centre after the crank points along the cylinder", ""),
        ("On a crank pin", "R_max [N]: Largest load of the crank pin", "largest_crankpin_load_at"),
        ("speed", "Smallest speed of the crank", "coefficient_of_fluctuation"),
        ("firing order", "From this cylinder's firing to the next one in the order", ""),
        ("major orders", "Sum of the cylinders' phase vectors of the order", ""),
    ],
)
def test_a_line_of_the_answer(typed, line, first, others):
    """By its name: the quantity of its number, and those of the others in it."""
    output = " ".join(typed("run", "3d12", "--why", line).output.split())
    assert first in output
    assert not others or others in output[output.index("fit these, too") :]


def test_all_numbers_of_a_line_are_shown(typed):
    """As the answer has them: 1497.5 to 1502.8 rpm, δ = 0.003562."""
    output = typed("run", "3d12", "--why", "speed").output
    assert [number in output for number in ("1497", "1503", "0.3562")] == [True] * 3
    assert "5.573  5.412" in typed("run", "3d12", "--why", "side force").output


@pytest.mark.parametrize("words", ["largest side force", "force side LARGEST", "largest_side_force", "N_max"])
def test_words_in_any_order_a_name_or_a_symbol(typed, words):
    assert "Largest force of the wall, on either side" in typed("run", "vaz_21213", "--why", words).output


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (
            ("--why", "sid forc"),
            "must be words in the name of a result, or its symbol; `cranktrain list results` names",
        ),
        (("--why", "sid forc"), 'write "side_force"'),
        (("--why", ""), "must be words in the name of a result"),
        (("--why", "stroke", "-o", "stroke.csv"), "--why = stroke: is shown alone; leave -o, --at, --table"),
        (("--why", "stroke", "--full"), "is shown alone"),
        (("--why", "stroke", "--table", "motion"), "is shown alone"),
    ],
)
def test_what_cannot_be(typed, given, said):
    assert said in " ".join(typed("run", "3d12", *given).errors.split())
