"""The table of a throw's symbols: what it is read as, and everything wrong with it at once."""

import tomllib

import numpy as np
import pytest
from tests.reference_case import ReferenceCase
from tests.sentences import NOT_A_KEY

from cranktrain.errors import InputError
from cranktrain.texts.example_tables import example_table
from cranktrain.texts.throw_table import read_throw

CASE = ReferenceCase.load("formulas_44_53")
PLAIN = {"l1": "14 mm", "hL": "22 mm", "l2": "15 mm", "l5": "15 mm", "hP": "24 mm", "l6": "14 mm"}


def refused(**more):
    """Paths and sentences of what is wrong with a plain throw with other values; None leaves one out."""
    data = {key: value for key, value in (PLAIN | more).items() if value is not None}
    with pytest.raises(InputError) as error:
        read_throw(data)
    return [(problem.path, str(problem.allowed)) for problem in error.value.problems]


def test_example_is_the_reference_case():
    text = example_table("throw")
    throw = read_throw(tomllib.loads(text))
    given = {key.lower().rpartition("_")[0]: value for key, value in CASE.machine.items()}
    for name, value in throw.lengths._asdict().items():
        assert float(value) == pytest.approx(1e-3 * given[name], rel=1e-15)
    assert {name: float(value) for name, value in throw.forces._asdict().items()} == {
        name: given[name] for name in throw.forces._fields
    }


def test_what_is_left_out_is_0_and_units_are_read():
    throw = read_throw(PLAIN | {"K1": "2 tf", "C2": "1.5 kN", "l1": "1.4 cm"})
    assert float(throw.forces.k1) == pytest.approx(2000 * 9.80665, rel=1e-15)
    assert float(throw.forces.c2) == 1500.0
    assert float(throw.lengths.l1) == pytest.approx(0.014, rel=1e-15)
    assert not np.any([throw.lengths.l3, throw.lengths.l4, throw.lengths.l_p1, throw.forces.t1])
    assert throw.rods == "one"


@pytest.mark.parametrize(
    ("more", "path", "said"),
    [
        ({"l": "131 mm"}, "l", "is no input: it is l1 + hL + l2 + l3 + l4 + l5 + hP + l6"),
        ({"l7": "5 mm"}, "l7", "occurs in none of (44) to (53)"),
        ({"l1": "-14 mm"}, "l1", "must be at least 0 mm"),
        (dict.fromkeys(PLAIN, "0 mm"), "", "must have a length: l = l1 + hL + l2 + l3 + l4 + l5 + hP + l6 is 0"),
        ({"hL": None}, "hL", "is missing"),
        ({"K1": "20 mm"}, "K1", "mm measures a length; must be a force"),
        ({"K1": 20}, "K1", "must be a force"),
        ({"K1": "nan N"}, "K1", ""),
        ({"h_p": "24 mm"}, "h_p", NOT_A_KEY),
        ({"С9": "1 N"}, '"С9"', NOT_A_KEY),
        ({"rods": "three"}, "rods", "must be one of"),
        ({"K2": "1 N"}, "K2", "must be left out: there is one rod"),
        ({"rods": "articulated", "T2": "1 N"}, "T2", "by one resultant, K1 and T1 on the master's axis"),
        ({"rods": "two", "l3": "13 mm"}, "l4", "is missing: of two rods side by side"),
        ({"C11": "100 N"}, "lP1", "is missing: from the support to the external counterweight of C10, C11"),
        ({"C12": "100 N"}, "lP2", "is missing: from the support to the external counterweight of C12, C13"),
    ],
)
def test_refused(more, path, said):
    (problem,) = refused(**more)
    assert problem[0] == path
    assert said in problem[1]


def test_everything_at_once():
    found = refused(l="1 mm", l7="1 mm", l1="-1 mm", hP=None, K1="3 m", C16="1 N")
    assert [path for path, _said in found] == ["l", "l7", "l1", "hP", "K1", "C16"]
