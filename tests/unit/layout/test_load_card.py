"""Loads from files: what a file says, what a machine makes of it, and all that is wrong with one at its line."""

import math

import numpy as np
import pytest
from tests.machines import ROCKER
from tests.sentences import AS_AT_THE_START, FOUR_COLUMNS, NO_FILE, NO_NUMBERS, NO_UNIT

import cranktrain as ct
from cranktrain.cli import main
from cranktrain.layout.load_card import load_card

CRANK = {"kind": "slider_crank", "stroke": "80 mm", "rod_length": "140 mm"}
CARD = "travel [mm];force [kN]\n0;0\n60;0\n80;4\n80;0,5\n0;0,5\n0;0\n"
"""Out 0 to 60 mm free, then rising to 4 kN; back at 0.5 kN."""
WORK = 0.5 * 0.020 * 4000 + 0.080 * 500


def machine(text=CARD, mechanism=CRANK, on="piston", table=None, **more):
    load = {"on": on, "file": "card.csv", "text": text, **more}
    return ct.Machine(mechanism=mechanism, shaft={"main": {"speed": "100 rpm"}}, load={"x": load}, **(table or {}))


def lists(card):
    return [[] if part is None else [one.si for one in part] for part in (card.places, card.out, card.back)]


class TestReading:
    @pytest.mark.parametrize(
        "rows",
        [
            "0;0 60;0 80;4 80;0.5 0;0.5 0;0",
            "0;0.5 0;0 60;0 80;4 80;0.5 0;0.5",  # begins on the vertical side
            "60;0 80;4 80;0.5 0;0.5 0;0 60;0",  # begins on the way out
            "80;0.5 0;0.5 0;0 60;0 80;4 80;0.5",  # begins at the top
            "80;4 80;0.5 0;0.5 0;0 60;0 80;4",
        ],
    )
    def test_a_loop_may_begin_anywhere(self, rows):
        card = load_card("card.csv", "travel [mm];force [kN]\n" + rows.replace(" ", "\n"), None)
        assert lists(card) == [[0.0, 0.06, 0.08], [0.0, 0.0, 4000.0], [500.0, 500.0, 500.0]]
        assert (card.sort, card.over) == ("force", "travel")

    def test_both_ways_side_by_side(self):
        card = load_card("card.csv", "position, in | up, lbf | down, lbf\n".replace(" | ", ";") + "0;1;2\n10;3;4", None)
        assert lists(card) == [[0.0, 0.254], *([[n * 4.4482216152605 for n in pair] for pair in ((1, 3), (2, 4))])]

    def test_chosen_columns(self):
        text = "no;travel [mm];x;out [N];back [N]\n1;0;9;10;20\n2;50;9;30;40"
        assert lists(load_card("card.csv", text, (2, 4, 5))) == [[0, 0.05], [10, 30], [20, 40]]

    def test_a_torque_over_the_swing_of_a_link(self):
        card = load_card("card.csv", "swing [deg];torque [N m]\n0;1\n90;3\n0;1", None)
        assert (card.sort, card.over) == ("torque", "swing")
        assert lists(card) == [[0, math.pi / 2], [1, 3], [1, 3]]

    @pytest.mark.parametrize(("head", "unit"), [("kgf*m", 9.80665), ("N*m", 1.0)])
    def test_a_torque_over_the_crank_angle(self, head, unit):
        card = load_card("card.csv", f"crank angle [deg];torque [{head}]\n0;1\n90;3\n360;1", None)
        assert (card.sort, card.over, card.back) == ("torque", "crank_angles", None)
        np.testing.assert_allclose(lists(card)[0], [0, math.pi / 2, 2 * math.pi], rtol=1e-15)
        np.testing.assert_allclose(lists(card)[1], [unit, 3 * unit, unit], rtol=1e-15)


class TestMachine:
    def test_work_is_the_area_of_the_card(self):
        result = ct.run(machine())
        assert result.load_work[0] == pytest.approx(-WORK, rel=1e-12)
        assert result.mean_load_power[0] == pytest.approx(-WORK * 100 / 60, rel=1e-12)
        assert result.largest_load_force[0] == pytest.approx(4000, rel=1e-12)

    def test_as_the_same_lists(self):
        listed = {
            "on": "piston",
            "travel": ["0 mm", "60 mm", "80 mm"],
            "force": ["0 kN", "0 kN", "4 kN"],
            "force_back": ["0.5 kN", "0.5 kN", "0.5 kN"],
        }
        one = ct.run(machine())
        other = ct.run(ct.Machine(mechanism=CRANK, shaft={"main": {"speed": "100 rpm"}}, load={"x": listed}))
        np.testing.assert_allclose(one.driving_torque, other.driving_torque, rtol=0, atol=1e-12)

    def test_over_two_turns(self):
        """A torque on the crank in the second turn alone: half a triangle's work of one turn."""
        text = "angle [deg];torque [N*m]\n0;0\n360;0\n540;80\n720;0"
        table = {"cylinder": {"bore": "80 mm", "cycle": "four-stroke"}}
        result = ct.run(machine(text, on="crank", table=table))
        assert result.load_work[0] == pytest.approx(-0.5 * 80 * 2 * math.pi, rel=1e-12)
        of_itself = ct.run(machine(text, on="crank"))
        assert of_itself.load_work[0] == pytest.approx(-0.5 * 80 * 2 * math.pi, rel=1e-12)
        two_stroke = {"cylinder": {"bore": "80 mm", "cycle": "two-stroke"}}
        of_two_strokes = ct.run(machine(text, on="crank", table=two_stroke))
        assert of_two_strokes.load_work[0] == pytest.approx(-0.5 * 80 * 2 * math.pi, rel=1e-12)

    def test_kinks_of_every_turn_of_a_longer_cycle(self):
        """A peak of 0.2° a turn, twice in a cycle of two turns: two triangles."""
        text = "angle [deg];torque [N*m]\n0;0\n100;0\n100.1;500\n100.2;0\n360;0"
        table = {"cylinder": {"bore": "80 mm", "cycle": "four-stroke"}}
        result = ct.run(machine(text, on="crank", table=table))
        assert result.load_work[0] == pytest.approx(-2 * 0.5 * 500 * math.radians(0.2), rel=1e-9)

    def test_designs_with_files_of_their_own(self):
        steep = "travel [mm];force [kN]\n0;0\n70;0\n80;4\n70;0.25\n0;0.5\n0;0\n"
        alone = [ct.run(machine(text)) for text in (CARD, steep)]
        together = ct.run([machine(CARD), machine(steep)])
        for design, own in enumerate(alone):
            scale = np.max(np.abs(own.driving_torque))
            assert np.max(np.abs(together.driving_torque[design] - own.driving_torque)) < 1e-12 * scale
            assert together.load_work[design] == pytest.approx(own.load_work, rel=1e-12)

    def test_designs_whose_files_go_over_different_angles_of_two_turns(self):
        texts = [f"angle [deg];torque [N*m]\n{at};0\n{at + 40};9\n{at + 720};0" for at in (10, -75)]
        table = {"cylinder": {"bore": "80 mm", "cycle": "four-stroke"}}
        machines = [machine(text, on="crank", table=table) for text in texts]
        together = ct.run(machines)
        for design, own in enumerate(map(ct.run, machines)):
            assert np.max(np.abs(together.driving_torque[design] - own.driving_torque)) < 1e-12 * 9
            assert own.load_work[0] == pytest.approx(-0.5 * 9 * 4 * math.pi, rel=1e-12)

    def test_designs_whose_files_go_over_different_angles(self):
        texts = [f"angle [deg];torque [N*m]\n{at};0\n{at + 40};9\n{at + 360};0" for at in (10, -75)]
        alone = [ct.run(machine(text, on="crank")) for text in texts]
        together = ct.run([machine(text, on="crank") for text in texts])
        for design, own in enumerate(alone):
            assert np.max(np.abs(together.driving_torque[design] - own.driving_torque)) < 1e-12 * 9

    def test_designs_whose_files_go_over_one_turn_and_over_two(self):
        table = {"cylinder": {"bore": "80 mm", "cycle": "four-stroke"}}
        texts = [f"angle [deg];torque [N*m]\n0;0\n40;9\n{turn};0" for turn in (360, 720)]
        machines = [machine(text, on="crank", table=table) for text in texts]
        for order in (machines, machines[::-1]):
            together = ct.run(order)
            for design, own in enumerate(map(ct.run, order)):
                assert np.max(np.abs(together.driving_torque[design] - own.driving_torque)) < 1e-12 * 9

    def test_designs_hold_the_same(self):
        other = machine("angle [deg];force [N]\n0;1\n360;1")
        with pytest.raises(ct.InputError, match=r"load\.x\.file = card\.csv: must hold the same in all designs"):
            ct.run([machine(), other])


class TestFiles:
    def test_beside_the_machine_file_and_set(self, tmp_path, capsys):
        (tmp_path / "cards").mkdir()
        (tmp_path / "cards/one.csv").write_text(CARD, encoding="utf-8")
        (tmp_path / "cards/twice.csv").write_text(CARD.replace("4\n", "8\n"), encoding="utf-8")
        file = tmp_path / "press.toml"
        tables = "[mechanism]\nkind = 'slider_crank'\nstroke = '80 mm'\nrod_length = '140 mm'\n"
        tables += "[shaft.main]\nspeed = '100 rpm'\n"
        file.write_text(tables + "[load.x]\non = 'piston'\nfile = 'cards/one.csv'\n", encoding="utf-8")
        loaded = ct.load(file)
        assert ct.run(loaded).load_work[0] == pytest.approx(-WORK, rel=1e-12)
        twice = loaded.with_({"load.x.file": "cards/twice.csv"})
        assert ct.run(twice).load_work[0] == pytest.approx(-WORK - 0.5 * 0.020 * 4000, rel=1e-12)
        assert main(["run", str(file), "--set", "load.x.file=cards/none.csv"]) == 2
        assert f"--set  load.x.file = cards/none.csv: {NO_FILE}" in capsys.readouterr().err

    def test_in_a_bank_and_of_a_dict(self, tmp_path, monkeypatch):
        monkeypatch.chdir(tmp_path)
        (tmp_path / "card.csv").write_text(CARD, encoding="utf-8")
        load = {"x": {"on": "piston", "file": "card.csv"}}
        bank = {"A": {"mechanism": CRANK, "load": load}}
        loaded = ct.load({"bank": bank, "shaft": {"main": {"speed": "100 rpm"}}})
        assert ct.run(loaded).load_work[0] == pytest.approx(-WORK, rel=1e-12)

    def test_that_nobody_has_read(self):
        unread = ct.Machine(
            mechanism=CRANK, shaft={"main": {"speed": "1 rpm"}}, load={"x": {"on": "rod", "file": "a.csv"}}
        )
        with pytest.raises(ct.InputError, match=rf"load\.x\.file = a\.csv: {NO_FILE}"):
            ct.run(unread)


HEAD = "travel [mm];force [N]\n"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", f"load.x.file = card.csv: {NO_NUMBERS}"),
        ("travel;force\n", f"load.x.file = card.csv: {NO_NUMBERS}"),
        (HEAD + "0;1\n80;lots\n0;1", "card.csv:3:4  load.x = lots: must be a number"),
        (HEAD + "0;1\n80\n0;1", "card.csv:3  load.x = 1 values: must have 2 values"),
        (
            "0,5,1,5\n80,5,2,5",
            "card.csv:1  load.x = 0,5,1,5: commas may stand here for decimal points or between columns",
        ),
        ("travel [mm]\n0\n80", "card.csv:2  load.x: has one column; a load needs two"),
        ("0;1\n80;2\n0;1", f"load.x.file = card.csv: {NO_UNIT} travel or angle; write it in the head"),
        ("0;1\n80;2\n0;1", f"load.x.file = card.csv: {NO_UNIT} force or torque; write it in the head"),
        (
            "travel [mm];force [bar]\n0;1\n80;2\n0;1",
            f"load.x.file = card.csv: {NO_UNIT} force or torque, in the head “force [bar]”;",
        ),
        (
            "travel [mm];a [N];b [N*m]\n0;1;1\n80;2;2",
            "load.x.file = card.csv: must have forces on both ways, or torques",
        ),
        ("travel [mm];t [N*m]\n0;1\n80;2\n0;1", "load.x.file = card.csv: must have forces over the travel of a point"),
        ("angle [deg];a [N];b [N]\n0;1;1\n360;1;1", "load.x.file = card.csv: has two sizes for a crank angle"),
        ("a;b;c;d\n0;1;1;1\n80;1;1;1", f"load.x.columns: {FOUR_COLUMNS} are place and size"),
        (HEAD + "0;1\n80;2", "card.csv:3:1  load.x.file = card.csv: goes one way only, and a load over its travel"),
        (HEAD + "0;1\n80;2\n30;1", "card.csv:4:1  load.x = 30: must come back to where it began, 0"),
        (HEAD + "40;1\n80;2\n0;1\n40;3", "card.csv:5:4  load.x = 3: must be as in the first row, 1"),
        (
            HEAD + "0;1\n50;2\n40;3\n80;1\n0;1",
            "card.csv:4:1  load.x = 40: must be more than in line 3, 50: on the way out",
        ),
        (
            HEAD + "0;1\n50;2\n50;3\n80;1\n0;1",
            "card.csv:4:1  load.x = 50: must be more than in line 3, 50: on the way out",
        ),
        (
            HEAD + "0;1\n80;2\n40;3\n60;1\n0;1",
            "card.csv:5:1  load.x = 60: must be less than in line 4, 40: on the way back",
        ),
        (
            "travel [mm];a [N];b [N]\n0;1;1\n80;2;2\n80;1;1",
            "card.csv:4:1  load.x = 80: must be more than in line 3, 80",
        ),
        (HEAD + "0;1\n70;2\n0;1", "card.csv:3:1  load.x = 70 mm: must go as far as the part goes, 80 mm"),
        (HEAD + "5;1\n80;2\n5;1", "card.csv:2:1  load.x = 5 mm: must be 0, where the travel begins"),
        (HEAD + "0;1\n80;-2\n0;1", "card.csv:3:4  load.x = -2: must be at least 0 of a load that resists"),
        ("angle [deg];f [N]\n0;1\n90;2\n300;1", "card.csv:4:1  load.x.file = card.csv: reaches from 0° to 300°"),
        ("angle [deg];f [N]\n0;1\n90;2\n360;7", f"card.csv:4:1  load.x = 7: {AS_AT_THE_START}"),
        (
            "angle [deg];f [N]\n0;1\n90;2\n80;3\n360;1",
            "card.csv:4:1  load.x = 80: must be more than the angle in line 3",
        ),
    ],
)
def test_refused(text, said):
    with pytest.raises(ct.InputError) as caught:
        ct.run(machine(text))
    assert said in str(caught.value)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"force": "1 N"}, "load.x.force = 1 N: must not stand beside file, which says how large the load is"),
        ({"travel": ["0 mm", "80 mm"]}, "load.x.travel: must not stand beside file"),
        ({"exponent": 2}, "load.x.exponent = 2: must not stand beside file"),
        ({"columns": [1, 3]}, "load.x.columns: must be columns of the file, 1 to 2, each once"),
        ({"columns": [1, 1]}, "load.x.columns: must be columns of the file, 1 to 2, each once"),
        ({"on": "rod"}, "load.x.file = card.csv: needs a direction or a radius, along which it is counted"),
        ({"on": "piston", "radius": "3 mm"}, "load.x.radius: is for what turns, and this slides"),
    ],
)
def test_what_does_not_stand_beside_a_file(more, said):
    with pytest.raises(ct.InputError) as caught:
        ct.run(machine(**more))
    assert said in str(caught.value)


def test_what_does_not_suit_what_the_file_holds():
    over_angle = "angle [deg];torque [N*m]\n0;1\n360;1"
    for more, said in (
        ({"on": "piston"}, "load.x.file = card.csv: is for what turns, and this slides"),
        ({"on": "rod", "along": "3 mm"}, "load.x.along = 3 mm: is for a force"),
        ({"on": "rod", "counts": "against"}, "load.x.counts = against: is for sizes over the travel"),
    ):
        with pytest.raises(ct.InputError) as caught:
            ct.run(machine(over_angle, **more))
        assert said in str(caught.value)


def test_a_swing_is_covered():
    with pytest.raises(ct.InputError) as caught:
        ct.run(machine("swing [deg];torque [N*m]\n0;1\n30;2\n0;1", mechanism=ROCKER, on="rocker"))
    assert "card.csv:3:1  load.x = 30 deg: must go as far as the part goes, 42.8136" in str(caught.value)


def test_all_at_once():
    """Two files and a load on what is not there: every problem, each at its place."""
    wrong = {
        "a": {"on": "piston", "file": "a.csv", "text": HEAD + "0;1\n80;2\n0;1", "columns": [1, 3]},
        "b": {"on": "piston", "file": "b.csv", "text": HEAD + "0;1\n50;2\n40;3\n90;1\n95;1\n20;1\n30;1\n0;1"},
    }
    with pytest.raises(ct.InputError) as caught:
        ct.Machine(mechanism=CRANK, load=wrong)
    found = [(str(problem.position), problem.path) for problem in caught.value.problems]
    assert found == [("None", "load.a.columns"), ("b.csv:4:1", "load.b"), ("b.csv:8:1", "load.b")]
    wrong["a"] = {"on": "piston", "file": "a.csv", "text": HEAD + "5;1\n70;-2\n5;1"}
    wrong["b"] = {"on": "pistom", "force": "1 N"}
    with pytest.raises(ct.InputError) as caught:
        ct.run(ct.Machine(mechanism=CRANK, load=wrong))
    found = [(str(problem.position), problem.path) for problem in caught.value.problems]
    first, last, size = "a.csv:2:1", "a.csv:3:1", "a.csv:3:4"
    assert found == [(size, "load.a"), (first, "load.a"), (last, "load.a"), ("None", "load.b.on")]
    assert "did you mean piston?" in str(caught.value)


def test_without_a_file():
    with pytest.raises(ct.InputError, match=r"load\.x\.file: is missing; text and columns are of a file"):
        ct.Machine(mechanism=CRANK, load={"x": {"on": "rod", "force": "1 N", "text": "0;1"}})
