"""What is wrong with a machine is said in the units in which its file is typed."""

import json
import re

import pytest

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.io.curve_files import beside
from cranktrain.io.document import Document
from cranktrain.io.machine_file import with_set
from cranktrain.quantities import shown_by, units_by_dimension
from cranktrain.web.refusals import refused as replied

SPEED = '[shaft.main]\nspeed = "100 rpm"\n'
SLIDER = SPEED + ('[mechanism]\nkind = "slider_crank"\ncrank_radius = "4 in"\nrod_length = "3 in"\noffset = "1/2 in"\n')
ROCKER = SPEED + (
    '[mechanism]\nkind = "crank_rocker"\ncrank_radius = "4 in"\nrod_length = "5 in"\n'
    'rocker_length = "10 in"\nground_length = "20 in"\n'
)
STROKE = SPEED + '[mechanism]\nkind = "slider_crank"\nstroke = "8 in"\nrod_length = "4 in"\noffset = "3 in"\n'
TRIAD = (
    SPEED
    + """\
[mechanism]
kind = "chain"
output = "frame"
[mechanism.fixed]
C = ["12 in", "0 in"]
D = ["6 in", "-8 in"]
[mechanism.crank.main]
radius = "1 in"
[[mechanism.part]]
type = "triad"
link = "frame"
leg = [
    { along = "0 in", joint = "P", rod = { name = "a", from = "main.pin", length = "6 in" } },
    { along = "5 in", joint = "Q", rod = { name = "b", from = "C", length = "6 in" } },
    { along = "2 in", across = "-3 in", joint = "R", rod = { name = "c", from = "D", length = "5 in" } },
]
"""
)
METRIC = SLIDER.replace("4 in", "100 mm").replace("3 in", "70 mm").replace("1/2 in", "1 cm")


def refused(text, folder):
    with pytest.raises(InputError) as caught:
        with_set(Document.from_text(text, "inches.toml"), (), beside(folder), folder, partial=False)
    return caught.value


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (SLIDER, ["short by 1.500 in", "crank_radius + |offset| = 4.5 in"]),
        (ROCKER, ["short by 9.000 in", "between 14 in and 26 in"]),
        (STROKE, ["2√(L(L − |e|)) = 4 in"]),
        (METRIC, ["short by 40.00 mm", "= 110 mm"]),
    ],
)
def test_closing_is_advised_in_the_unit_of_the_file(text, said, tmp_path):
    error = refused(text, tmp_path)
    other = " in" if " mm" in said[0] else " mm"
    for words in said:
        assert words in str(error)
    assert other not in str(error)
    told = json.loads(replied(error.problems).content)
    assert all(words in json.dumps(told, ensure_ascii=False) for words in said)


def test_ways_in_which_a_link_fits_are_listed_in_the_unit_of_the_file(tmp_path):
    error = str(refused(TRIAD, tmp_path))
    places = re.findall(r"P \((\S+) (\S+), (\S+) (\S+)\)", error)
    assert len(places) > 1
    for x, unit, y, other in places:
        assert (unit, other) == ("in", "in")
        assert abs((float(x) - 1.0) ** 2 + float(y) ** 2 - 36.0) < 1e-4, "so far is it from the crank pin"


def test_a_reader_s_own_unit_comes_first(tmp_path):
    error = refused(SLIDER, tmp_path)
    with shown_by(units_by_dimension(["mm"])):
        assert "= 114.3 mm" in str(error)


def test_what_is_wrong_with_tables_of_python_is_said_in_their_unit():
    machine = ct.Machine(
        mechanism={"kind": "slider_crank", "crank_radius": "4 in", "rod_length": "3 in"},
        shaft={"main": {"speed": "100 rpm"}},
    )
    with pytest.raises(InputError, match=r"crank_radius \+ \|offset\| = 4 in"):
        ct.run(machine)
