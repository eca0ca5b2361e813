"""An order of more cylinders than there are throws: of an even engine in line the throws are told."""

import tomllib

import pytest

import cranktrain as ct

ENGINE = """
[shaft.main]
speed = "600 rpm"
spacing = "150 mm"
{throws}
[bank.line.mechanism]
kind = "slider_crank"
stroke = "100 mm"
rod_length = "175 mm"
[cylinder]
{cycle}
firing_order = "{order}"
"""


def problems(order, cycle='cycle = "four-stroke"', throws=""):
    with pytest.raises(ct.InputError) as caught:
        ct.run(ct.Machine(**tomllib.loads(ENGINE.format(order=order, cycle=cycle, throws=throws))))
    return caught.value.problems


@pytest.mark.parametrize(
    ("order", "cycle", "throws"),
    [
        ("1-4-5-3-2", "four-stroke", [0, 144, 288, 216, 72]),
        ("1-3-4-2", "four-stroke", [0, 180, 180, 0]),
        ("1-5-3-6-2-4", "four-stroke", [0, 240, 120, 120, 240, 0]),
        ("1-2-3", "four-stroke", [0, 120, 240]),
        ("1-3-2", "two-stroke", [0, 120, 240]),
    ],
)
def test_throws_of_an_even_engine(order, cycle, throws):
    """The told throws are written back, and the engine fires evenly with them."""
    (problem,) = problems(order, f'cycle = "{cycle}"')
    assert problem.path == "shaft.main.throws"
    listed = ", ".join(f'"{throw} deg"' for throw in throws)
    assert f"throws = [{listed}]" in str(problem.repair)
    given = ENGINE.format(order=order, cycle=f'cycle = "{cycle}"', throws=f"throws = [{listed}]")
    result = ct.run(ct.Machine(**tomllib.loads(given)))
    assert result.firing_interval == pytest.approx(
        [(720 if cycle == "four-stroke" else 360) / len(throws)] * len(throws)
    )


def test_without_a_cycle_they_are_asked_for():
    (problem,) = problems("1-4-5-3-2", cycle="")
    assert problem.path == "shaft.main.throws"
    assert "a throw for each cylinder" in str(problem.repair)


def test_an_order_that_is_no_engines_keeps_its_own_message():
    assert {problem.path for problem in problems("1-4-4")} == {"cylinder.firing_order"}
