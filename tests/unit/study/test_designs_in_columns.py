"""Designs of a sweep as columns of one machine, against each design alone: with_, machine_problems, in_columns."""

import pickle
from dataclasses import replace
from importlib.resources import files
from random import Random

import numpy as np
import pytest
from tests.machines import banks, slave, slider, throws

import cranktrain as ct
from cranktrain.columns import in_columns, numbers_of
from cranktrain.errors import InputError, Problem
from cranktrain.machine import machine_problems
from cranktrain.paths import value_at
from cranktrain.quantities.number import measured
from cranktrain.study.sweep.designs import designs_in_columns
from cranktrain.study.sweep.places import words_of
from cranktrain.study.sweep.refused import UnsaidProblem
from cranktrain.study.sweep.rules import judged_together
from cranktrain.study.sweep.varied import SweptDesigns, Varied, combined_designs, paths_in

MACHINE = ct.Machine(mechanism=slider(crank_radius="40 mm", rod_length="136 mm"), shaft={"main": {"speed": "1500 rpm"}})
EXAMPLES = sorted(path.name[:-5] for path in files("cranktrain.examples").iterdir() if path.name.endswith(".toml"))
N_PATHS = 5
"""Of each example."""


def rows_listed(rows):
    """Take designs by their rows, as `SweptDesigns.rows` gives them."""
    paths = dict.fromkeys(path for row in rows for path in row)
    return SweptDesigns(
        tuple(Varied(path, path, tuple(row.get(path) for row in rows), None, "") for path in paths), is_listed=True
    )


def numbers_typed(machine):
    """Paths of the file at which quantities stand, with their numbers and units."""
    for path in paths_in(machine.declared):
        value = value_at(machine.declared, path)
        value = value.get("value") if isinstance(value, dict) else value
        if isinstance(value, int | float) and not isinstance(value, bool):
            yield path, float(value), ""
        elif isinstance(value, str) and (found := measured(value)) is not None and found.unit:
            yield path, float(found.number), found.unit


def typed(number, unit):
    return f"{number!r} {unit}" if unit else number


def alone(machine, row):
    """A design by itself, and what is wrong with it."""
    try:
        design = machine.with_(row)
    except InputError as error:
        return None, error.problems[0]
    problems = machine_problems(design)
    return (None, problems[0]) if problems else (design, None)


def bits(numbers):
    return np.asarray(numbers, dtype=float).view(np.int64)


def words(machine):
    """All that is no number, but not which fields were given: of tables in columns all are."""
    return [(where, value) for where, value in words_of(machine) if not isinstance(value, tuple)]


def hold_to_each_alone(machine, rows, first=0):
    """What is found of all together is what each design alone gives, to the last bit; give the groups."""
    designs = rows if hasattr(rows, "varied") else rows_listed(rows)
    rows = [designs.row(first + place) for place in range(len(designs) - first)]
    found = designs_in_columns(machine, designs, first, len(designs))
    each = [alone(machine, row) for row in rows]
    assert list(found.refused) == [place for place, (design, _problem) in enumerate(each) if design is None]
    for place, problem in found.refused.items():
        assert problem == each[place][1]
    assert sorted(place for group in found.groups for place in group.places.tolist()) == [
        place for place, (design, _problem) in enumerate(each) if design is not None
    ]
    for group in found.groups:
        own = [each[place][0] for place in group.places.tolist()]
        wanted, numbers = in_columns(own), dict(numbers_of(group.machine))
        assert words(wanted) == words(group.machine)
        for where, given in numbers_of(wanted):
            assert numbers[where] == given
            np.testing.assert_array_equal(bits(numbers[where].column), bits(given.column), err_msg=str(where))
        for by_itself, design in list(zip(group.each, own, strict=True))[:3]:
            assert (words_of(by_itself), list(numbers_of(by_itself))) == (words_of(design), list(numbers_of(design)))
            assert by_itself.declared == design.declared
            assert machine_problems(by_itself) == ()
    return found.groups


@pytest.mark.parametrize("name", EXAMPLES)
def test_numbers_of_each_example_one_by_one(name):
    """Near the file's, far from it, and such as cannot be."""
    machine, random = ct.load(name), Random(name)
    every = list(numbers_typed(machine))
    for path, number, unit in random.sample(every, min(N_PATHS, len(every))):
        size = abs(number) or 1.0
        near = [number + size * random.uniform(-0.02, 0.02) for _ in range(20)]
        far = [number * factor for factor in (0.3, 0.6, 1.7, 3.0)]
        values = [typed(one, unit) for one in (*near, *far, 0.0, -size, 1e40, size * 1e6)]
        values += [f"nan {unit}", f"{number} parsec"] if unit else [float("nan"), float("inf"), "x"]
        random.shuffle(values)
        hold_to_each_alone(machine, [{path: value} for value in values])


@pytest.mark.parametrize("name", EXAMPLES)
def test_numbers_of_each_example_together(name):
    """Rules that look at several of them: most designs are near the file's, some far."""
    machine, random = ct.load(name), Random(name)
    every = list(numbers_typed(machine))
    chosen = random.sample(every, min(3, len(every)))

    def factor():
        return random.choice([1.0, 1.0, 1.0, random.uniform(0.97, 1.03), random.uniform(0.3, 3)])

    rows = [{path: typed(number * factor(), unit) for path, number, unit in chosen} for _ in range(40)]
    hold_to_each_alone(machine, rows)


def test_what_no_crank_can_make():
    """Strokes, rods and offsets of which some close, some have a stroke that no crank makes, and some do not close."""
    machine = ct.Machine(mechanism={"kind": "slider_crank", "stroke": "80 mm", "rod_length": "136 mm"})
    vary = {"stroke": "20..300 mm:15", "rod_length": "30..150 mm:13", "mechanism.offset": "-60..60 mm:5"}
    (group,) = hold_to_each_alone(machine, combined_designs(machine, vary))
    assert group.were_followed
    assert 0 < group.places.size < 15 * 13 * 5


def test_at_the_change_point_itself():
    """A rod just as long as the crank, and one that is longer or shorter by a bit or two."""
    lengths = [0.04]
    for _ in range(6):
        lengths += [np.nextafter(lengths[-1], 1.0)]
    lengths += [0.04 - (one - 0.04) for one in lengths[1:]] + [0.04 * (1 + k * 1e-10) for k in range(-20, 20)]
    hold_to_each_alone(MACHINE, [{"mechanism.rod_length": f"{float(one)!r} m"} for one in lengths])


def test_a_knuckle_that_cannot_close():
    machine = ct.Machine(
        shaft=throws(0.0, 120.0, 240.0),
        bank=banks(L=-30.0, R={"angle": "30 deg", "mechanism": slave("L")}),
    )
    vary = {"bank.R.mechanism.knuckle_radius": "10..130 mm:13", "bank.R.mechanism.rod_length": "20..200 mm:10"}
    (group,) = hold_to_each_alone(machine, combined_designs(machine, vary))
    assert group.were_followed
    assert 0 < group.places.size < 130


def test_words_counts_and_numbers():
    """Motors of other kinds have other tables; a whole number may be a count, or a quantity."""
    tilting = ct.load("tilting_table")
    vary = {
        "drive.motor.kind": "cage, nonsense, wound_rotor",
        "drive.stage[0].ratio": [40, 42.0, "44"],
        "mechanism.rod_length": "2.3..2.5 m:9",
    }
    hold_to_each_alone(tilting, combined_designs(tilting, vary))
    rows = [{"bank.line.throws": [1 + k % 4, 1 + (k + 1) % 4]} for k in range(30)]
    hold_to_each_alone(ct.load("vaz_21213"), [row | {"cylinder.bore": f"{70 + k} mm"} for k, row in enumerate(rows)])


def test_a_star_has_its_number_in_every_mechanism():
    (group,) = hold_to_each_alone(
        ct.load("m_503"), [{"bank.S.mechanism.knuckle_radius": f"{60 + k / 7} mm"} for k in range(30)]
    )
    columns = [given.column for where, given in numbers_of(group.machine) if where[-1] == "knuckle_radius"]
    assert len(columns) > 1
    assert all(column.tolist() == columns[0].tolist() for column in columns)


def test_rules_that_read_units_see_each_unit():
    """A mean pressure is no gauge pressure, which its text alone says."""
    rows = [{"cylinder.friction_pressure": f"{1 + k / 100} {('bar', 'ati', 'kPa')[k % 3]}"} for k in range(90)]
    machine = ct.load("burning_cylinder")
    hold_to_each_alone(machine, rows)
    assert len(designs_in_columns(machine, rows_listed(rows), 0, 90).refused) == 30


def test_designs_of_one_turn_and_of_two_are_apart():
    """A load over two turns makes a cycle of two, which results of one turn cannot stand beside."""
    load = {
        "on": "piston",
        "torque": None,
        "force": ["1 N", "2 N", "3 N"],
        "crank_angles": ["0 deg", "90 deg", "359 deg"],
    }
    load = {key: value for key, value in load.items() if value is not None}
    machine = MACHINE.with_({"load.pressing": load})
    last = {"load.pressing.crank_angles[2]": "80..719 deg:40"}
    groups = hold_to_each_alone(machine, combined_designs(machine, last))
    assert sorted(machine.cycle for group in groups for machine in [group.machine]) == [2 * np.pi, 4 * np.pi]
    assert all(each.cycle == group.machine.cycle for group in groups for each in group.each)


def test_what_some_designs_do_not_name_stays():
    rows = [{"mechanism.rod_length": f"{130 + k} mm"} for k in range(30)]
    rows = [row if k % 3 else {**row, "shaft.main.speed": f"{1000 + k} rpm"} for k, row in enumerate(rows)]
    assert len(hold_to_each_alone(MACHINE, [*rows, {}])) == 3


def test_plain_numbers_as_numpy_has_them():
    """Of a ratio SI is what is typed; a length needs its unit; −0.0 is read as 0.0."""
    ratios = np.concatenate([np.linspace(0.5, 20, 40), [-0.0, np.nan, np.inf, 1e31, 1e-31]])
    machine = ct.load("burning_cylinder")
    designs = combined_designs(machine, {"compression_ratio": ratios[:-5], "form_factor": np.linspace(1, 3, 5)})
    hold_to_each_alone(machine, designs, first=120)
    hold_to_each_alone(machine, [{"cylinder.compression_ratio": one} for one in ratios.tolist()])
    hold_to_each_alone(machine, [{"mechanism.rod_length": one} for one in ratios.tolist()])


def test_a_million_designs_have_no_rows():
    """The last ten thousand of a map of 200 × 5000: closed form of the columns, last value first."""
    machine = ct.load("burning_cylinder")
    designs = combined_designs(machine, {"mechanism.rod_length": "0.111..0.31 m:200", "heat": "1..5000 J:5000"})
    assert len(designs) == 1_000_000
    (group,) = designs_in_columns(machine, designs, 990_000, 1_000_000).groups
    assert group.were_followed
    assert group.machine.gas.heat.column.tolist() == [1.0 + k for k in range(5000)] * 2
    assert group.machine.mechanism.rod_length.column.tolist() == [0.309] * 5000 + [0.31] * 5000


def test_a_sentence_is_found_when_it_is_read():
    """It is equal to the one of the design alone, can be changed, and goes to other processes unsaid."""
    row = {"mechanism.rod_length": "30 mm"}
    _none, wanted = alone(MACHINE, row)
    unsaid = UnsaidProblem(MACHINE, row)
    sent = pickle.loads(pickle.dumps(unsaid))
    assert isinstance(sent, Problem)
    assert "said" not in vars(sent)
    assert sent == wanted == unsaid
    assert str(unsaid) == str(wanted)
    assert replace(unsaid, repair=None) == replace(wanted, repair=None)
    assert {wanted: 1}[unsaid] == 1


def test_blocks_of_refused_designs_alone():
    found = designs_in_columns(MACHINE, rows_listed([{"mechanism.rod_length": "-1 mm"}] * 40), 0, 40)
    assert not found.groups
    assert len(found.refused) == 40


NOT_FOLLOWED = {
    "10d100": "lead place rod_length stroke throws",
    "38d8": "lead place rod_length stroke throws",
    "3d12": "angle throws",
    "3d12_fit_85_235": "angle throws",
    "3d12_quoted_rods": "angle throws",
    "40d": "1R 2L 2R 3L 3R 4L 4R 5L 5R 6L 6R angle throws",
    "compressor_start": "size",
    "deltic": "angle lead place rod_to_crank_ratio stroke throws",
    "eccentric_press": "angle crank_to_rod_ratio force stroke travel",
    "gas_compressor": "angle",
    "great_northern": "angle",
    "high_slip_press": "angle crank_to_rod_ratio force stroke travel",
    "inline_six": "throws",
    "jaw_crusher": "along crank_radius direction force ground_length rocker_length rod_length size travel",
    "jumo_205": "lead place rod_length stroke throws",
    "jumo_205e": "lead place rod_length stroke throws",
    "kamaz_740": "angle throws",
    "lms_class5": (
        "angle drop_y eccentric_advance eccentric_rod_length eccentricity foot_distance foot_setback "
        "full_gear_die lever_length notch offset radius_rod_length rod_length stroke trunnion_x trunnion_y "
        "union_link_length valve_pin_distance"
    ),
    "ls3": "angle throws",
    "m_50": "angle",
    "m_503": "angle",
    "mill_engine": "ambient angle",
    "pumping_unit_c57": "crank_radius direction force force_back ground_length radius rocker_length rod_length travel",
    "r_1340": "angle",
    "servo_press": "angle duration force rod_length stroke to travel",
    "servo_press_rocking": "angle force rod_length stroke travel",
    "shaking_conveyor": "angle size",
    "shaper": "C along angle force length offset radius travel",
    "shears": "angle crank_to_rod_ratio force stroke travel",
    "textbook_78x78": "throws",
    "toggle_press": "C angle direction force length radius travel",
    "traction_engine": (
        "angle angle_of_advance eccentric_rod_length eccentricity lifting_arm_angle lifting_arm_length "
        "lifting_arm_swing lifting_link_length notch pin_setback pin_spacing reverse_shaft_x reverse_shaft_y"
    ),
    "vaz_21213": "throws",
}
"""Numbers of examples by their last names, of which so many different ones cannot be followed through the rules."""


@pytest.mark.parametrize("name", EXAMPLES)
def test_which_numbers_are_followed(name):
    """Where rules look at a machine as arrays, each design is asked by itself: slower, and as right."""
    machine = ct.load(name)
    factors = np.concatenate([[1.0], np.linspace(0.999, 1.001, 40)])
    found = set[str]()
    for where, given in numbers_of(machine):
        if given.si != 0.0 and np.any(judged_together(machine, {where: given.si * factors}, 41).is_unknown):
            found.add(next(part for part in reversed(where) if isinstance(part, str)))
    assert found == set(NOT_FOLLOWED.get(name, "").split())
