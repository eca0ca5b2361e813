"""When pistons fire: even and uneven engines, and orders that cannot be."""

import itertools
import tomllib

import numpy as np
import pytest
from tests.machines import V12, banks, slave, slider, throws
from tests.told import line_of, problems_told, texts_of

import cranktrain as ct
from cranktrain.questions.cylinders.firing import firing_angles, firing_choices, within_turn
from cranktrain.questions.cylinders.possible_orders import likest_orders

RATIOS = np.radians(15.0)


def fired(shaft, bank, **cylinder):
    """Firing angles and intervals by piston."""
    result = ct.run(ct.Machine(shaft=shaft, bank=bank, cylinder=cylinder))
    pistons = result.labels["piston"]
    return (
        dict(zip(pistons, result.firing_angle.tolist(), strict=True)),
        dict(zip(pistons, result.firing_interval.tolist(), strict=True)),
        result,
    )


def refusal(shaft, bank, **cylinder):
    with pytest.raises(ct.InputError) as caught:
        ct.run(ct.Machine(shaft=shaft, bank=bank, cylinder=cylinder))
    (problem,) = problems_told(caught.value.problems)
    return problem


@pytest.mark.parametrize(
    ("tops", "turns", "expected"),
    [
        ([0, 180, 180, 0], 2, None),  # 1-2-3-4 of an in-line four: the fourth would have to fire before the third
        ([0, 180, 180, 0], 1, None),  # nor can it in a two-stroke, where pairs fire together
        ([0, 0, 180, 180], 1, [0, 0, 180, 180]),
        ([0, 180, 0, 180], 2, [0, 180, 360, 540]),
        ([0, 45], 2, [0, 405]),  # a 45° V-twin: 405 and 315, not 45 and 675
        ([0, 0], 2, [0, 360]),  # pins together: a turn apart
        ([0, 180], 2, [0, 180]),  # a flat twin on one pin: 180 and 540, whichever turn it is
        ([0, 180], 1, [0, 180]),
        ([0, 0], 1, [0, 0]),  # two-stroke, pins together: at the same time
        ([300, 60], 1, [300, 420]),
        ([300, 60], 2, [300, 780]),  # 480 and 240, not 120 and 600
        ([0, 240, 120], 1, None),
        ([0, 240, 120], 2, [0, 240, 480]),
        ([10], 2, [10]),
    ],
)
def test_firing_angles(tops, turns, expected):
    found = firing_angles(np.radians(tops), 2 * np.pi * turns)
    if expected is None:
        assert found is None
    else:
        np.testing.assert_allclose(np.degrees(found), expected, atol=1e-9)


@pytest.mark.parametrize("seed", range(12))
def test_firing_angles_are_the_most_even_of_all(seed):
    """Against every choice of turns, tried one by one."""
    random = np.random.default_rng(seed)
    tops = np.sort(random.choice(24, 5)) * RATIOS
    tops = np.roll(random.permutation(tops) if seed % 3 else tops, seed)
    possible = [
        angles
        for turns in itertools.product((0, 1), repeat=4)
        if np.all(
            np.diff(angles := np.array([0, *(np.mod(tops[1:] - tops[0], 2 * np.pi) + 2 * np.pi * np.array(turns))]))
            > 1e-9
        )
    ]
    found = firing_angles(tops, 4 * np.pi)
    if not possible:
        n_together = max(np.sum(np.isclose(tops, top)) for top in tops)
        assert found is None or n_together > 2
        return

    def unevenness(angles):
        return np.sum(np.diff([*angles, angles[0] + 4 * np.pi]) ** 2)

    assert found is not None
    assert unevenness(found) == pytest.approx(min(map(unevenness, possible)))


def test_rounding_does_not_move_a_top_by_a_turn():
    np.testing.assert_array_equal(within_turn(np.array([-1e-15, 0.0, 2 * np.pi, -4 * np.pi, 1.0])), [0, 0, 0, 0, 1.0])


def test_uneven_v_twin():
    angles, intervals, result = fired(throws(0), banks(F=0, R=45), cycle="four-stroke", firing_order="1F-1R")
    assert angles == pytest.approx({"1F": 0, "1R": 405})
    assert intervals == pytest.approx({"1F": 405, "1R": 315})
    assert line_of(result, "Cylinders", "firing order").startswith("1F-1R, by turns after 405°, 315°; ")


def test_parallel_twin_on_one_pin():
    angles, intervals, _result = fired(throws(0, 0), banks(A=0), cycle="four-stroke", firing_order="1 2")
    assert angles == pytest.approx({"1": 0, "2": 360})
    assert intervals == pytest.approx({"1": 360, "2": 360})


@pytest.mark.parametrize(("cycle", "last"), [("two-stroke", 180), ("four-stroke", 540)])
def test_flat_twin_on_one_pin(cycle, last):
    angles, intervals, _result = fired(throws(0), banks(L=-90, R=90), cycle=cycle, firing_order="1L, 1R")
    assert angles == pytest.approx({"1L": 0, "1R": 180})
    assert intervals == pytest.approx({"1L": 180, "1R": last})


def test_first_of_the_order_fires_in_the_first_turn():
    angles, _intervals, _result = fired(throws(0, 180, 180, 0), banks(A=0), cycle="four-stroke", firing_order="4-2-1-3")
    assert angles == pytest.approx({"4": 0, "2": 180, "1": 360, "3": 540})


def test_true_dead_centre_stands_beside_the_nominal_one():
    result = ct.run(ct.Machine(**V12))
    shift = np.where([name.endswith("R") for name in result.labels["piston"]], 0.9818045317, 0.0)
    np.testing.assert_allclose(result.firing_dead_centre - result.firing_angle, shift, atol=1e-10)


def test_radial_by_a_makers_numbers():
    """Nine cylinders fire every other one, 1-3-5-7-9-2-4-6-8, every 80°."""
    star = {
        "M": {"mechanism": slider()},
        "S": {
            "angle": [f"{40 * k} deg" for k in range(1, 9)],
            "mechanism": slave("M", articulation_angle=[f"{40 * k} deg" for k in range(1, 9)]),
        },
    }
    numbers = {"1": "1M"} | {str(k + 1): f"{k}S" for k in range(1, 9)}
    angles, _intervals, result = fired(
        throws(0), star, cycle="four-stroke", firing_order="1-3-5-7-9-2-4-6-8", numbers=numbers
    )
    for place, number in enumerate((1, 3, 5, 7, 9, 2, 4, 6, 8)):
        assert angles[numbers[str(number)]] == pytest.approx(80 * place)
    assert line_of(result, "Cylinders", "firing order") == "1-3-5-7-9-2-4-6-8, every 80°"


def test_order_that_the_pins_do_not_allow():
    problem = refusal(throws(0, 180, 180, 0), banks(A=0), cycle="four-stroke", firing_order="1-4-2-3")
    assert problem.path == "cylinder.firing_order"
    assert problem.given == "1-4-2-3"
    assert "1 0.00 deg or 360.00 deg, 4 0.00 deg or 360.00 deg, 2 180.00 deg or 540.00 deg" in problem.allowed


@pytest.mark.parametrize(
    ("order", "said"),
    [
        ("1-3-4", "left out: 2"),
        ("1-3-4-2-2", "twice: 2"),
        ("1-3-4-5-2", "unknown: 5"),
        ("1-3-4-4-7", "unknown: 7; twice: 4; left out: 2"),
    ],
)
@pytest.mark.parametrize("cycle", ["four-stroke", None])
def test_order_that_is_no_permutation(order, said, cycle):
    """It is refused whether or not the cycle is known."""
    given = {"cycle": cycle} if cycle else {}
    problem = refusal(throws(0, 180, 180, 0), banks(A=0), firing_order=order, **given)
    assert problem.path == "cylinder.firing_order"
    assert problem.allowed.endswith(said)


def test_order_without_a_cycle_is_said_to_lack_it():
    result = ct.run(ct.Machine(mechanism=slider(), cylinder={"firing_order": "1"}))
    assert "firing_angle" not in result.catalogue
    (needs,) = (missing.needs for missing in result.missing if "firing_angle" in missing.results)
    assert texts_of(needs) == ("[cylinder] cycle",)


@pytest.mark.parametrize(
    ("numbers", "path", "said"),
    [
        ({"1": "3"}, "cylinder.numbers.1", "must be a cylinder of this machine: 1, 2"),
        ({"1": "1", "2": "1"}, "cylinder.numbers.2", "this one is number 1"),
    ],
)
def test_numbers_of_no_piston_or_of_one_piston_twice(numbers, path, said):
    problem = refusal(throws(0, 180), banks(A=0), cycle="four-stroke", firing_order="1-2", numbers=numbers)
    assert problem.path == path
    assert said in problem.allowed


PAIR = banks(L=0, R=60)
"""Two cylinders 60° apart on one pin: their tops are at 0 and 60° of every turn."""


def of_pair(firing_angles, **fields):
    cylinder = {"cycle": "four-stroke", "firing_angles": firing_angles}
    return ct.run(ct.Machine(shaft=throws(0), bank=PAIR, cylinder=cylinder, **fields))


@pytest.mark.parametrize(
    ("given", "angles", "intervals"),
    [
        (["0 deg", "60 deg"], [0, 60], [60, 660]),
        (["0 deg", "420 deg"], [0, 420], [420, 300]),
        (["360 deg", "60 deg"], [360, 60], [420, 300]),
        ({"1R": "60 deg", "1L": "0 deg"}, [0, 60], [60, 660]),
        (["-720 deg", "59.99 deg"], [0, 60], [60, 660]),
    ],
)
def test_firing_angles_of_the_file(given, angles, intervals):
    result = of_pair(given)
    np.testing.assert_allclose(result.firing_angle, angles, atol=1e-9)
    np.testing.assert_allclose(result.firing_interval, intervals, atol=1e-9)
    assert "choices" not in result.summary()


def test_firing_angles_count_as_crank_angles_are_shown():
    """With 20° as zero the tops are shown at 340° and 40°; astern the same metal is seen at −φ."""
    result = of_pair(["340 deg", "400 deg"], crank_zero="20 deg")
    np.testing.assert_allclose(result.firing_angle, [340, 400], atol=1e-9)
    result = of_pair(["340 deg", "400 deg"], crank_zero="20 deg", running="astern")
    np.testing.assert_allclose(result.firing_angle, [380, 320], atol=1e-9)
    np.testing.assert_allclose(np.sort(result.firing_interval), [60, 660], atol=1e-9)


def test_firing_angles_by_the_makers_numbers():
    cylinder = {
        "cycle": "four-stroke",
        "numbers": {"1": "1R", "2": "1L"},
        "firing_angles": {"1": "60 deg", "2": "0 deg"},
    }
    result = ct.run(ct.Machine(shaft=throws(0), bank=PAIR, cylinder=cylinder))
    np.testing.assert_allclose(result.firing_angle, [0, 60], atol=1e-9)
    assert line_of(result, "Cylinders", "firing order") == "2-1, by turns after 60°, 660°"


OTTO = {
    "kind": "otto",
    "start_pressure": "95 kPa",
    "compression_exponent": 1.35,
    "expansion_exponent": 1.28,
    "pressure_ratio": 3.5,
}


def test_gas_and_orders_are_at_the_angles_that_are_given():
    """Each cylinder peaks after its own firing; the torque of the pair is that of one, twice 60° apart."""
    fuel = {"gas": OTTO, "cylinder": {"bore": "80 mm", "compression_ratio": 9, "cycle": "four-stroke"}}
    alone = ct.run(ct.Machine(shaft={"main": {"speed": "1500 rpm"}}, mechanism=slider(), **fuel))
    fuel["cylinder"] |= {"firing_angles": ["0 deg", "60 deg"]}
    pair = ct.run(ct.Machine(shaft=throws(0, speed="1500 rpm"), bank=PAIR, **fuel))
    np.testing.assert_allclose(pair.gas_pressure[1], np.roll(alone.gas_pressure[0], 60), rtol=1e-9)
    both = alone.machine_torque + np.roll(alone.machine_torque, 60)
    np.testing.assert_allclose(pair.machine_torque, both, atol=1e-9 * np.max(np.abs(both)))


def test_several_designs_each_have_their_angles():
    def design(angle, first=0):
        cylinder = {"cycle": "four-stroke", "firing_angles": [f"{first} deg", f"{angle} deg"]}
        return ct.Machine(shaft=throws(0), bank=banks(L=0, R=angle), cylinder=cylinder)

    result = ct.run([design(60), design(72)])
    np.testing.assert_allclose(result.firing_angle, [[0, 60], [0, 72]], atol=1e-9)
    with pytest.raises(ct.InputError, match="must make the same order in all designs"):
        ct.run([design(60), design(60, first=360)])


@pytest.mark.parametrize(
    ("cylinder", "path", "said"),
    [
        ({"firing_angles": ["0 deg", "50 deg"]}, "cylinder.firing_angles[1]", "60.00 deg or 420.00 deg"),
        ({"firing_angles": {"1L": "10 deg", "1R": "60 deg"}}, "cylinder.firing_angles.1L", "0.00 deg or 360.00 deg"),
        ({"firing_angles": ["0 deg"]}, "cylinder.firing_angles", "one angle for each cylinder: 1L, 1R"),
        ({"firing_angles": {"1L": "0 deg"}}, "cylinder.firing_angles", "left out: 1R"),
        ({"firing_angles": {"2L": "0 deg"}}, "cylinder.firing_angles.2L", "each once: 1L, 1R"),
        ({"firing_angles": ["0 deg", "5 mm"]}, "cylinder.firing_angles[1]", "mm measures a length"),
        ({"firing_angles": ["0 deg", "60 deg"], "firing_order": "1L 1R"}, "cylinder.firing_order", "must not stand"),
        ({"firing_angles": ["0 deg", "60 deg"], "cycle": None}, "cylinder.cycle", "is missing"),
    ],
)
def test_firing_angles_that_cannot_be(cylinder, path, said):
    problem = refusal(throws(0), PAIR, **({"cycle": "four-stroke"} | cylinder))
    assert problem.path == path
    assert said in problem.allowed


@pytest.mark.parametrize("seed", range(12))
def test_choices_of_turns_are_counted(seed):
    """Against every choice of turns, tried one by one."""
    random = np.random.default_rng(seed)
    tops = np.sort(random.choice(24, 5, replace=False)) * RATIOS
    tops = np.roll(tops, seed)
    rest = np.mod(tops[1:] - tops[0], 2 * np.pi)
    rises = [
        np.all(np.diff([0, *(rest + 2 * np.pi * np.array(turns))]) > 1e-9)
        for turns in itertools.product((0, 1), repeat=4)
    ]
    assert firing_choices(tops, 4 * np.pi) == sum(rises) > 1


def test_that_the_most_even_turns_are_taken_is_said():
    result = ct.run(ct.Machine(shaft=throws(0), bank=PAIR, cylinder={"cycle": "four-stroke", "firing_order": "1L 1R"}))
    np.testing.assert_allclose(result.firing_angle, [0, 420], atol=1e-9)
    said = "1L-1R, by turns after 420°, 300°; the most even of 2 choices"
    assert line_of(result, "Cylinders", "firing order") == said
    four = ct.Machine(
        shaft=throws(0, 180, 180, 0), bank=banks(A=0), cylinder={"cycle": "four-stroke", "firing_order": "1-3-4-2"}
    )
    assert line_of(ct.run(four), "Cylinders", "firing order") == "1-3-4-2, every 180°"


IN_LINE_FOUR = throws(0, 180, 180, 0), banks(A=0)


@pytest.mark.parametrize("running", ["ahead", "astern"])
@pytest.mark.parametrize(
    ("order", "possible"),
    [
        ("1-2-3-4", 'write "1-2-4-3" or "1-3-4-2"'),
        ("1-3-4", 'write "1-3-4-2" or "1-2-4-3"'),
        ("4-2-1-2", 'write "4-2-1-3" or "4-3-1-2"'),
        ("", 'write "1-2-4-3" or "1-3-4-2"'),
        ("1-x-y-z", None),
        ("1.3.4.2", 'write "1-3-4-2"'),
        ("1342", 'write "1-3-4-2"'),
    ],
)
def test_wrong_orders_are_answered_with_the_two_that_a_flat_shaft_allows(order, possible, running):
    """1-3-4-2 and 1-2-4-3 are the two of every in-line four; read backwards the one is the other."""
    with pytest.raises(ct.InputError) as caught:
        shaft, bank = IN_LINE_FOUR
        cylinder = {"cycle": "four-stroke", "firing_order": order}
        ct.run(ct.Machine(shaft=shaft, bank=bank, cylinder=cylinder, running=running))
    (problem,) = problems_told(caught.value.problems)
    if running == "ahead":
        assert problem.repair == possible
    else:
        assert (problem.repair is None) == (possible is None)
        assert possible is None or set(problem.repair.split('"')[1::2]) == set(possible.split('"')[1::2])


@pytest.mark.parametrize("seed", range(6))
def test_likest_orders_are_even_and_can_be(seed):
    """Each is taken by `firing_angles`, at equal steps, of every order of a six by the pins of pairs."""
    random = np.random.default_rng(seed)
    tops = np.radians(random.permutation([0, 120, 240, 240, 120, 0]))
    wanted = random.permutation(6).tolist()
    found = likest_orders(tops, 4 * np.pi, wanted)
    even = [
        order
        for order in itertools.permutations(range(6))
        if order[0] == wanted[0]
        and (angles := firing_angles(tops[list(order)], 4 * np.pi)) is not None
        and np.ptp(np.diff(angles)) < 1e-9
    ]
    agree = sorted((sum(a == b for a, b in zip(order, wanted, strict=True)) for order in even), reverse=True)
    assert set(found) <= set(even)
    assert [sum(a == b for a, b in zip(order, wanted, strict=True)) for order in found] == agree[:3]


def test_the_makers_numbers_of_a_v8_are_offered_as_the_line_to_paste():
    """KamAZ counts 1 to 4 on the right, 5 to 8 on the left: with the left first its order could not be."""
    bank = {"L": {"angle": "45 deg", "mechanism": slider()}, "R": {"angle": "-45 deg", "mechanism": slider()}}
    given = {"cycle": "four-stroke", "firing_order": "1-5-4-2-6-3-7-8"}
    shaft = throws(0, 90, 270, 180)
    problem = refusal(shaft, bank, **given)
    line = 'numbers = { 1 = "1R", 2 = "2R", 3 = "3R", 4 = "4R", 5 = "1L", 6 = "2L", 7 = "3L", 8 = "4L" }'
    assert problem.repair == f"where these are the maker's numbers, write in [cylinder]: {line}"
    numbers = tomllib.loads(line)["numbers"]
    result = fired(shaft, bank, **given, numbers=numbers)[2]
    assert line_of(result, "Cylinders", "firing order") == "1-5-4-2-6-3-7-8, every 90°"
