"""Cards as recorders write them: their pounds, their strokes that are a little off; set in place of lists."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from tests.machines import ROCKER
from tests.sentences import LOOKED_FOR, NO_FILE
from tests.told import texts_of

import cranktrain as ct
from cranktrain.cli import main
from cranktrain.quantities import Dimension
from cranktrain.quantities.heads import unit_in

FILES = Path(__file__).parents[2] / "golden" / "load_cards"
INCH, POUND_FORCE = 0.0254, 4.4482216152605


def swing():
    """Of the pumping unit's beam: between crank and pitman in line, one after the other and one over the other."""
    rocker, ground = 56.05, 88.09086218218096
    at_ends = [(rocker**2 + ground**2 - reach**2) / (2 * rocker * ground) for reach in (65.63 + 21, 65.63 - 21)]
    return np.arccos(at_ends[0]) - np.arccos(at_ends[1])


STROKE = 64 * INCH * swing()
"""Of the horsehead's arc. [m]"""


def area_of(places, sizes):
    """Of a closed polygon, by Gauss's formula."""
    return abs(np.sum(places * np.roll(sizes, -1) - np.roll(places, -1) * sizes)) / 2


def pumping(text):
    rod = {"on": "rocker", "sense": "active", "radius": "64 in", "direction": "140.53 deg", "counts": "against"}
    rod |= {"file": "card.csv", "text": text}
    mechanism = {
        "kind": "crank_rocker",
        "crank_radius": "21 in",
        "rod_length": "65.63 in",
        "rocker_length": "56.05 in",
        "ground_length": "88.09086218218096 in",
        "side": "right",
        "load_direction": "against",
        "load_radius": "64 in",
    }
    main_shaft = {"main": {"speed": "10 rpm"}}
    return ct.Machine(mechanism=mechanism, shaft=main_shaft, load={"rod": rod}, pumping={"card": "rod"})


@pytest.mark.parametrize(("name", "percent"), [("lbs", "+0.0085"), ("short", "+0.0085"), ("long", "−0.15")])
def test_a_recorded_card_is_stretched_to_the_stroke(name, percent):
    """Of 49.52 in and 49.60 in, over 49.52421 in: its work is the polygon's area, stretched alike."""
    text = (FILES / f"{name}.csv").read_text(encoding="utf-8")
    inches, pounds = np.array([line.split(",") for line in text.splitlines()[1:]], dtype=float).T
    area = area_of(inches * INCH, pounds * POUND_FORCE)
    result = ct.run(pumping(text))
    assert abs(result.load_work[0]) == pytest.approx(area * STROKE / (np.max(inches) * INCH), rel=1e-11)
    (told,) = (flag for flag in texts_of(result.flags) if "stretched" in flag)
    assert told.replace("-", "−") == (
        f"The card of rod goes over {np.max(inches):g} in and the part over 49.52421 in: it is stretched"
        f" by {percent} %."
    )


CRANK = {"kind": "slider_crank", "stroke": "80 mm", "rod_length": "140 mm"}
HABITS = {
    "round": lambda rows: "travel [mm];force [N]\n" + "\n".join(f"{s!r};{f!r}" for s, f in rows),
    "commas": lambda rows: "Weg, mm;Kraft, N\n" + "\n".join(f"{s!r};{f!r}".replace(".", ",") for s, f in rows),
    "reversed": lambda rows: "ход, мм\tсила, Н\n" + "\n".join(f"{s!r}\t{f!r}" for s, f in rows[::-1]),
    "titles": lambda rows: "Recorder 7\nWell;12\n#\nposition;load\nmm;N\n" + "\n".join(f"{s!r};{f!r}" for s, f in rows),
}


@settings(max_examples=40, deadline=None)
@given(
    seed=st.integers(0, 10**6),
    n_points=st.integers(2, 60),
    percent=st.floats(-1.99, 1.99),
    habit=st.sampled_from(sorted(HABITS)),
    begin=st.integers(0, 200),
)
@example(1, 40, 0.0, "round", 0)
@example(1, 40, -1.99, "commas", 7)
def test_work_is_the_area_of_any_card_stretched(seed, n_points, percent, habit, begin):
    """Random loops, 80 mm and up to 2 % less or more, begun anywhere; their areas against the work of a turn."""
    rng = np.random.default_rng(seed)
    whole = 80.0 * (1 + percent / 100)
    out, back = (
        np.concatenate([[0.0], np.sort(rng.uniform(0.5, whole - 0.5, n_points)), [whole]]) for _way in range(2)
    )
    if min(np.min(np.diff(out)), np.min(np.diff(back))) < 1e-3:
        return
    places = np.concatenate([out, back[::-1]])
    sizes = np.concatenate([rng.uniform(500, 900, len(out)), rng.uniform(10, 400, len(back))])
    rows = np.roll(np.stack([places, sizes], axis=1), -(begin % len(places)), axis=0).tolist()
    load = {"on": "piston", "file": "a.csv", "text": HABITS[habit]([*rows, rows[0]])}
    result = ct.run(ct.Machine(mechanism=CRANK, shaft={"main": {"speed": "100 rpm"}}, load={"x": load}))
    # What resists takes work on both ways, so that the areas below both add up.
    work = np.trapezoid(sizes[: len(out)], out) + np.trapezoid(sizes[len(out) :][::-1], back)
    assert result.load_work[0] == pytest.approx(-work * 1e-3 * 80.0 / whole, rel=1e-9)
    assert any("stretched" in flag for flag in texts_of(result.flags)) == (abs(80.0 / whole - 1) > 1e-6)


@pytest.mark.parametrize("whole", [78.3, 81.7, 60.0, 160.0])
def test_a_card_of_another_machine_is_refused(whole):
    load = {"on": "piston", "file": "a.csv", "text": f"travel [mm];force [N]\n0;9\n{whole};9\n0;9"}
    with pytest.raises(ct.InputError, match=r"must go as far as the part goes, 80 mm, or within 2 % of that"):
        ct.run(ct.Machine(mechanism=CRANK, shaft={"main": {"speed": "100 rpm"}}, load={"x": load}))


def test_a_list_that_was_typed_may_go_beyond_and_is_not_stretched():
    load = {"on": "piston", "travel": ["0 mm", "81 mm"], "force": ["0 N", "810 N"]}
    result = ct.run(ct.Machine(mechanism=CRANK, shaft={"main": {"speed": "100 rpm"}}, load={"x": load}))
    assert result.load_work[0] == pytest.approx(-2 * 0.5 * 0.08 * 800, rel=1e-12)
    assert not any("stretched" in flag for flag in texts_of(result.flags))


def test_a_swing_is_stretched_like_a_travel():
    """Of 42.8136°: 0 to 42.5° at 2 N·m, both ways."""
    text = "swing [deg];torque [N*m]\n0;2\n42.5;2\n0;2"
    load = {"on": "rocker", "file": "a.csv", "text": text}
    result = ct.run(ct.Machine(mechanism=ROCKER, shaft={"main": {"speed": "100 rpm"}}, load={"x": load}))
    assert result.load_work[0] == pytest.approx(-2 * 2 * np.radians(42.8136), rel=1e-6)
    assert any("the part over 42.81" in flag and "+0.74 %" in flag for flag in texts_of(result.flags))


def test_designs_have_strokes_and_cards_of_their_own():
    """Each stretched to its own stroke, together as alone."""

    def machine(stroke, whole):
        text = f"travel [mm];force [N]\n0;9\n{whole / 2};20\n{whole};9\n0;5\n0;9"
        load = {"on": "piston", "file": "a.csv", "text": text}
        crank = {**CRANK, "stroke": f"{stroke} mm"}
        return ct.Machine(mechanism=crank, shaft={"main": {"speed": "100 rpm"}}, load={"x": load})

    machines = [machine(80, 79.5), machine(100, 101), machine(60, 60)]
    together = ct.run(machines)
    for design, (own, stroke) in enumerate(zip(map(ct.run, machines), (0.08, 0.1, 0.06), strict=True)):
        assert together.load_work[design] == pytest.approx(own.load_work, rel=1e-13)
        assert own.load_work[0] == pytest.approx(-stroke * ((9 + 20) / 2 + (9 + 5) / 2), rel=1e-12)
    assert sum("stretched" in flag for flag in texts_of(together.flags)) == 1


def test_one_sentence_for_all_cylinders():
    text = "travel [mm];force [N]\n0;9\n79.5;9\n0;9"
    bank = {"A": {"mechanism": CRANK, "load": {"x": {"on": "piston", "file": "a.csv", "text": text}}}}
    main_shaft = {"main": {"speed": "100 rpm", "throws": ["0 deg", "180 deg"], "spacing": "100 mm"}}
    result = ct.run(ct.Machine(bank=bank, shaft=main_shaft))
    (told,) = (flag for flag in texts_of(result.flags) if "stretched" in flag)
    assert told.startswith("The card of 1.x, 2.x goes over 79.5 mm and the part over 80 mm: ")


@pytest.mark.parametrize(
    ("head", "dimension", "unit"),
    [
        ("Load (lbs)", Dimension.FORCE, "lbf"),
        ("load, lb", Dimension.FORCE, "lbf"),
        ("Load [LBS]", Dimension.FORCE, "lbf"),
        ("load_lbs", Dimension.FORCE, "lbf"),
        ("Load pounds", Dimension.FORCE, "lbf"),
        ("Torque (in-lbs)", Dimension.TORQUE, "lbf·in"),
        ("torque [ft-lb]", Dimension.TORQUE, "lbf·ft"),
        ("torque, lb ft", Dimension.TORQUE, "lbf·ft"),
        ("Load (lbs)", Dimension.TORQUE, None),
        ("Load (kg)", Dimension.FORCE, None),
    ],
)
def test_units_of_instruments(head, dimension, unit):
    assert unit_in(head, dimension) == unit


def test_a_card_over_time_is_refused_as_such():
    load = {"on": "piston", "file": "a.csv", "text": "time [s];load [lbs]\n0;1\n1;2\n2;1"}
    with pytest.raises(ct.InputError, match=r"has a time in column 1, “time \[s\]”, and a load is over crank angle"):
        ct.Machine(mechanism=CRANK, load={"x": load})


CARD = "travel [mm];force [N]\n0;9\n80;9\n0;9\n"
LISTED = """
[mechanism]
kind = "slider_crank"
stroke = "80 mm"
rod_length = "140 mm"
[shaft.main]
speed = "100 rpm"
[load.x]
on = "piston"
travel = ["0 mm", "80 mm"]
force = ["100 N", "300 N"]
force_back = ["10 N", "10 N"]
"""


class TestInPlaceOfLists:
    """A file that is set stands for the lists of the table, wherever it is set."""

    @pytest.fixture
    def file(self, tmp_path):
        (tmp_path / "card.csv").write_text(CARD, encoding="utf-8")
        (tmp_path / "press.toml").write_text(LISTED, encoding="utf-8")
        return tmp_path / "press.toml"

    def test_in_python(self, file):
        expected = pytest.approx(-2 * 9 * 0.08, rel=1e-12)
        assert ct.run(file, set={"load.x.file": "card.csv"}).load_work[0] == expected
        loaded = ct.load(file)
        assert loaded.with_({"load.x.file": "card.csv"}).load["x"].force is None
        assert ct.run(loaded.with_({"load.x.file": "card.csv"})).load_work[0] == expected

    def test_of_tables(self, file, monkeypatch):
        monkeypatch.chdir(file.parent)
        tables = {
            "mechanism": CRANK,
            "shaft": {"main": {"speed": "100 rpm"}},
            "load": {"x": {"on": "piston", "crank_angles": ["0 deg", "90 deg"], "force": ["1 N", "2 N"]}},
        }
        assert ct.run(tables, set={"load.x.file": "card.csv"}).load_work[0] == pytest.approx(-2 * 9 * 0.08)

    def test_in_the_terminal(self, file, capsys):
        assert main(["run", str(file), "--set", "load.x.file=card.csv"]) == 0
        assert "1.440 J" in capsys.readouterr().out.replace("−", "-")

    def test_lists_that_are_set_beside_it_do_not_go(self, file):
        with pytest.raises(ct.InputError, match=r"load\.x\.travel: must not stand beside file"):
            ct.run(file, set={"load.x.file": "card.csv", "load.x.travel": ["0 mm", "80 mm"]})

    def test_a_file_of_another_table_takes_no_lists(self, file):
        with pytest.raises(ct.InputError, match="gas"):
            ct.run(file, set={"gas.file": "card.csv"})

    def test_where_it_was_looked_for_is_said(self, file, capsys):
        assert main(["run", str(file), "--set", "load.x.file=other.csv"]) == 2
        assert f"load.x.file = other.csv: {NO_FILE}; it {LOOKED_FOR} {file.parent.resolve()}" in capsys.readouterr().err

    def test_beside_an_example_is_the_working_folder(self, file, monkeypatch, capsys):
        monkeypatch.chdir(file.parent)
        text = (FILES / "lbs.csv").read_text(encoding="utf-8")
        (file.parent / "well.csv").write_text(text, encoding="utf-8")
        assert main(["run", "pumping_unit_c57", "--set", "load.invented_card.file=well.csv"]) == 0
        assert "The card of invented_card goes over 49.52 in" in " ".join(capsys.readouterr().out.split())
        assert main(["run", "pumping_unit_c57", "--set", "load.invented_card.file=april_1998.csv"]) == 2
        assert f"{NO_FILE}; it {LOOKED_FOR} {file.parent.resolve()}" in capsys.readouterr().err
