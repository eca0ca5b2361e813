"""A sweep against each design alone, and against closed forms of a central slider-crank."""

import numpy as np
import pytest
from tests.machines import slider

import cranktrain as ct

MACHINE = ct.Machine(mechanism=slider(crank_radius="40 mm", rod_length="136 mm"), shaft={"main": {"speed": "1500 rpm"}})
OMEGA = 1500 * np.pi / 30
FACTS = ["largest_piston_acceleration", "largest_side_force", "largest_torque", "fluctuation", "wanted_flywheel"]


def test_closed_forms_over_a_rod_and_a_speed():
    """Rω²(1 + λ) at the top, 2S n, and what a rod shorter than its crank cannot be."""
    wanted = ["largest_piston_acceleration", "mean_piston_speed"]
    found = ct.sweep(MACHINE, {"rod_length": "30..150 mm:13", "speed": "1000, 1500 rpm"}, wanted)
    rods = found.axis.values / 1e3
    assert (found.axis.name, found.axis.unit) == ("rod_length", "mm")
    assert found.labels["speed"] == ("1000 rpm", "1500 rpm")
    exact = 0.04 * (np.array([[1000.0], [1500.0]]) * np.pi / 30) ** 2 * (1 + 0.04 / rods)
    closes = rods > 0.04
    assert found.largest_piston_acceleration.shape == (2, 1, 13)
    np.testing.assert_allclose(found.largest_piston_acceleration[:, 0, closes], exact[:, closes], rtol=1e-12)
    assert np.all(np.isnan(found.largest_piston_acceleration[:, 0, ~closes]))
    np.testing.assert_allclose(found.mean_piston_speed[1, 0, closes], 4.0, rtol=1e-14)
    assert sorted(found.refused) == [0, 1, 2, 3]
    assert all("mechanism" in problem.path for problem in found.refused.values())


@pytest.mark.parametrize(
    ("name", "vary"),
    [
        ("vaz_21213", {"bank.line.mechanism.rod_length": "115..170 mm:6"}),
        ("3d12", {"shaft.main.speed": "900..1700 rpm:3", "bank.R.masses.piston.mass": "3, 4 kg"}),
        ("burning_cylinder", {"mechanism.rod_length": "0.2..0.3 m:70"}),
        ("shaper", {"shaft.main.speed": "20..60 rpm:3"}),
    ],
)
def test_every_design_is_as_it_is_alone(name, vary):
    """More than one block, two numbers, words for dimensions."""
    machine = ct.load(name)
    wanted = [fact for fact in FACTS if fact in ct.run(machine).catalogue]
    found = ct.sweep(machine, vary, wanted)
    assert found.refused == {}
    rows = list(found.designs.rows)
    for place in {0, 1, len(rows) // 2, len(rows) - 1}:
        alone = ct.run(machine, set=rows[place], quantities=wanted)
        for fact in wanted:
            np.testing.assert_array_equal(found.found.values[fact][place], getattr(alone, fact), err_msg=fact)


def test_words_and_numbers_together():
    """Motors of other kinds have other rows; a fact is NaN where a design has none of it."""
    tilting = ct.load("tilting_table")
    found = ct.sweep(tilting, {"drive.motor.kind": "cage, nonsense", "drive.stage[0].ratio": [40, 42.0]}, "cycle_time")
    assert found.shape == (2, 2)
    alone = ct.run(tilting, set={"drive.stage[0].ratio": 42.0}).cycle_time
    assert found.cycle_time[0, 1] == alone
    assert np.all(np.isnan(found.cycle_time[1]))
    assert "cage" in str(found.refused[2])


def test_throws_of_an_in_line_five():
    """The first order's couple, by the vectors of its throws: 1-2-4-5-3 leaves a tenth of that of throws in a row."""
    orders = ((0, 144, 216, 288, 72), (0, 72, 144, 216, 288))
    throws = [[f"{angle} deg" for angle in angles] for angles in orders]
    five = ct.Machine(
        shaft={"main": {"speed": "1500 rpm", "throws": throws[0], "spacing": "100 mm"}},
        bank={"line": {"mechanism": slider(crank_radius="40 mm", rod_length="140 mm")}},
        masses={"piston": {"mass": "1 kg"}},
    )
    found = ct.sweep(five, {"shaft.main.throws": throws}, "shaking_couple_largest")
    assert found.axis is None
    arms = (np.arange(5) - 2) * 0.1
    exact = [abs(np.sum(arms * np.exp(1j * np.radians(order)))) * 0.04 * OMEGA**2 for order in orders]
    first = found.found.labels["order"].index("1")
    np.testing.assert_allclose(found.shaking_couple_largest[:, 0, first], exact, rtol=1e-12)
    assert "0 deg, 144 deg, 216 deg, 288 deg, 72 deg" in str(found)


def test_an_engine_that_cannot_be_has_no_numbers():
    """Whatever is asked of it: a ratio that leaves no room is refused by `run`, too."""
    wanted = ["compression_ratio", "stroke"]
    found = ct.sweep("3d12", {"bank.R.mechanism.rod_length": "235.7, 290 mm"}, wanted)
    assert "leaves no room" in str(found.refused[1].allowed)
    assert np.all(np.isnan(found.compression_ratio[..., 1]))
    assert np.all(found.compression_ratio[..., 0] > 1)


def test_starts_are_as_they_are_alone():
    """And of a gear that the motor cannot turn there is a start, too: that it stalls is said."""
    found = ct.sweep("tilting_table", {"drive.stage[0].ratio": "30, 40"}, over_time=True)
    stalled = ct.sweep("tilting_table", {"drive.stage[0].ratio": "10, 40"}, over_time=True)
    assert "1 of 2 starts: it stands still" in str(stalled)
    assert found.axis.name == "ratio"
    for place, ratio in enumerate((30, 40)):
        alone = ct.start("tilting_table", set={"drive.stage[0].ratio": ratio})
        for fact in ("start_duration", "largest_motor_torque", "final_motor_heat"):
            assert getattr(found, fact)[place] == getattr(alone, fact), fact
    with pytest.raises(ct.InputError, match="is no result of its start"):
        ct.sweep("tilting_table", {"drive.stage[0].ratio": "30, 40"}, "stroke", over_time=True)
    with pytest.raises(ct.InputError, match="a start needs what drives the crank"):
        ct.sweep(MACHINE, {"rod_length": "130, 140 mm"}, over_time=True)


def test_a_list_of_cases():
    cases = [{"rod_length": "120 mm"}, {"speed": "3000 rpm"}, {"rod_length": "20 mm"}]
    found = ct.sweep(MACHINE, cases, "mean_piston_speed")
    assert found.axis is None
    assert found.labels["case"] == ("1: rod_length 120 mm", "2: speed 3000 rpm", "3: rod_length 20 mm")
    np.testing.assert_allclose(found.mean_piston_speed[:, 0], [4.0, 8.0, np.nan], rtol=1e-14)


def test_the_best_design():
    found = ct.sweep("vaz_21213", {"rod_length": "120..170 mm:51"}, "largest_side_force")
    best = found.best(least="largest_side_force")
    force = found.largest_side_force.max(axis=0)
    assert best.bank["line"].mechanism[0].rod_length.text == f"{120 + int(np.flatnonzero(force == force.min())[0])} mm"
    assert found.values_at(found.place_of_best(most="largest_side_force")) == {
        "bank.line.mechanism.rod_length": "120 mm"
    }
    with pytest.raises(ct.InputError, match="did you mean largest_side_force"):
        found.best(least="largest_side_forc")


def test_processes_give_the_same_bytes():
    vary = {"rod_length": "100..150 mm:150"}
    from cranktrain.study.sweep import computed, swept

    one = swept(MACHINE, vary, ["largest_piston_acceleration"], processes=1)
    monkey = pytest.MonkeyPatch()
    with monkey.context() as patched:
        patched.setattr(computed, "_WORTH", 0.0)
        two = swept(MACHINE, vary, ["largest_piston_acceleration"], processes=2)
    assert one.largest_piston_acceleration.tobytes() == two.largest_piston_acceleration.tobytes()


def test_files_and_frames_have_the_axis():
    found = ct.sweep(MACHINE, {"rod_length": "100..150 mm:6", "speed": "1000, 1500 rpm"}, "mean_piston_speed")
    dataset = found.dataset
    assert dataset.mean_piston_speed.dims == ("speed", "piston", "rod_length")
    np.testing.assert_array_equal(dataset.rod_length, [100, 110, 120, 130, 140, 150])
    np.testing.assert_array_equal(dataset.speed, [1000, 1500])
    assert dataset.speed.attrs["units"] == "rpm"
    assert dataset.rod_length.attrs["units"] == "mm"
    frame = found.curves("mean_piston_speed")
    assert list(frame.index) == [100, 110, 120, 130, 140, 150]


@pytest.mark.parametrize(
    ("name", "vary", "places", "unit"),
    [
        ("vaz_21213", {"speed": "1000..2000 rpm:3"}, [1000, 1500, 2000], "rpm"),
        ("gas_compressor", {"clearance": "10..20 %:3"}, [10, 15, 20], "%"),
        ("10d100", {"lead": "0..20 deg:3"}, [0, 10, 20], "deg"),
    ],
)
def test_a_picture_is_over_what_was_typed(name, vary, places, unit):
    found = ct.sweep(name, vary, "largest_piston_speed")
    axes = found.plot().axes[0]
    np.testing.assert_array_equal(axes.lines[-1].get_xdata(), places)
    assert axes.get_xlabel().endswith(f", {unit}")


def test_a_map_says_its_units_once():
    found = ct.sweep(MACHINE, {"rod_length": "100..160 mm:7", "speed": "1000..2000 rpm:8"}, "largest_piston_speed")
    axes = found.plot().axes[0]
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("Rod length, mm", "Speed, rpm")


def test_what_cannot_be_is_hatched_along_a_curve():
    """A rod of 30 or 35 mm is shorter than the crank of 40 mm; from there to the next rod there is no curve either."""
    found = ct.sweep(MACHINE, {"rod_length": "30..150 mm:25"}, "largest_piston_speed")
    figure = found.plot()
    hatched = [patch.get_extents() for patch in figure.axes[0].patches if patch.get_hatch()]
    ends = figure.axes[0].transData.inverted().transform([[hatched[0].x0, 0.0], [hatched[-1].x1, 0.0]])[:, 0]
    np.testing.assert_allclose(ends, [30.0, 45.0], rtol=1e-12)
    assert figure.axes[0].get_xlabel().endswith("hatched: designs that cannot be")
    whole = ct.sweep(MACHINE, {"rod_length": "50..150 mm:21"}, "largest_piston_speed").plot().axes[0]
    assert not whole.patches
    assert whole.get_xlabel() == "Rod length, mm"


def test_designs_of_a_list_are_points():
    """Over the one number that differs; else one fact over the other: c = 2 S n over S is a line through 0."""
    rods = ct.sweep(MACHINE, [{"rod_length": f"{rod} mm"} for rod in (120, 20, 140)], "largest_piston_speed")
    axes = rods.plot().axes[0]
    np.testing.assert_array_equal(axes.lines[-1].get_xdata(), [120, 20, 140])
    assert axes.lines[-1].get_linestyle() == "None"
    assert axes.get_xlabel() == "Rod length, mm\n1 of 3 designs cannot be"
    cases = [{"crank_radius": f"{radius} mm", "rod_length": f"{4 * radius} mm"} for radius in (30, 50, 40)]
    both = ct.sweep(MACHINE, cases, ["stroke", "mean_piston_speed"]).plot().axes[0]
    np.testing.assert_allclose(both.lines[-1].get_xdata(), [60, 100, 80], rtol=1e-14)
    np.testing.assert_allclose(both.lines[-1].get_ydata(), [3, 5, 4], rtol=1e-14)  # at 1500 rpm
    assert both.get_xlabel() == "Stroke, between the true dead centres, mm"
    with pytest.raises(ct.InputError, match="needs a number that differs"):
        ct.sweep(MACHINE, [{"name": "A"}, {"name": "B"}], ["stroke", "mean_piston_speed"]).plot()


def test_few_designs_are_marked_along_a_curve():
    few = ct.sweep(MACHINE, {"rod_length": "110..150 mm:5"}, "largest_piston_speed").plot().axes[0]
    many = ct.sweep(MACHINE, {"rod_length": "110..150 mm:41"}, "largest_piston_speed").plot().axes[0]
    assert (few.lines[-1].get_marker(), many.lines[-1].get_marker()) == ("o", "None")


def test_a_list_has_its_values_beside_the_facts():
    """In datasets as coordinates, in data frames as columns."""
    cases = [{"rod_length": "120 mm", "rotation": "clockwise"}, {"rod_length": "14 cm", "rotation": "anticlockwise"}]
    found = ct.sweep(MACHINE, cases, "mean_piston_speed")
    dataset = found.dataset
    np.testing.assert_array_equal(dataset.rod_length, [120, 140])
    assert dataset.rod_length.attrs["units"] == "mm"
    assert list(dataset.rotation.values) == ["clockwise", "anticlockwise"]
    assert dataset.rotation.dims == ("case",)
    frame = found.curves()
    assert list(frame.columns) == ["rod_length [mm]", "rotation", "mean_piston_speed(1) [m/s]"]
    np.testing.assert_allclose(frame["mean_piston_speed(1) [m/s]"], [4.0, 4.0], rtol=1e-14)


def test_mistakes_in_python():
    with pytest.raises(ct.InputError, match=r'must be values by path.*write like \{"rod_length": "130..160 mm:31"\}'):
        ct.sweep(MACHINE, "rod_length=1..2 mm", "stroke")  # pyright: ignore[reportArgumentType]
    found = ct.sweep(MACHINE, {"rod_length": "120, 140 mm"}, "stroke")
    with pytest.raises(ct.InputError, match=r'needs one fact: least or most; write like best\(least="stroke"\)'):
        found.best()
    with pytest.raises(AttributeError, match=r"a sweep has no strok; did you mean stroke\?"):
        _ = found.strok
