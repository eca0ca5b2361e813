"""The table [torsion]: what it refuses, and the train that several designs of it make."""

import numpy as np
import pytest

from cranktrain.columns import in_columns
from cranktrain.errors import InputError
from cranktrain.questions.torsion.parts import declared_train
from cranktrain.questions.torsion.spec import TorsionSpec
from cranktrain.spec import validated


def disc(beside, stiffness=None, **more):
    return {"inertia": "2 kg·m²", "beside": beside, **({"stiffness": stiffness} if stiffness else {}), **more}


def train(n_throws=2, **table):
    return declared_train(validated(TorsionSpec, table), n_throws)


SOFT, STIFF = "1 kN·m/rad", "1 MN·m/rad"


@pytest.mark.parametrize(
    ("table", "path", "words"),
    [
        ({"disc": {"a": disc("b")}}, "disc.a.beside", "the number of a throw; there is no other disc"),
        ({"disc": {"wheel": disc(1), "a": disc("weel")}}, "disc.a.beside", 'write "wheel"'),
        ({"disc": {"a": disc("a")}}, "disc.a.beside", "stand in a ring"),
        ({"disc": {"a": disc("b"), "b": disc("c"), "c": disc("a")}}, "disc.b.beside", "stand in a ring"),
        ({"disc": {"a": disc(0)}}, "disc.a.beside", "at least 1"),
        ({"disc": {"2": disc(1)}}, "disc.2", "a letter first"),
        ({"disc": {"a": disc(1, ratio=0)}}, "disc.a.ratio", "more than 0"),
        ({"disc": {"a": disc(1, "0 N·m/rad")}}, "disc.a.stiffness", "more than 0"),
        ({"disc": {"a": disc(1, "5 N/mm")}}, "disc.a.stiffness", "torsional stiffness in"),
        ({"disc": {"a": disc(1) | {"inertia": "0 kg·m²"}}}, "disc.a.inertia", "more than 0"),
        (
            {"disc": {"a": disc(1)}, "free_end": "a"},
            "free_end",
            "must be left out: no disc has a stiffness",
        ),
        ({"disc": {"a": disc(1, SOFT)}, "free_end": "b"}, "free_end", "a disc with a stiffness: a"),
        ({"throw_inertia": "-1 kg·m²"}, "throw_inertia[0]", "at least 0"),
    ],
)
def test_refused(table, path, words):
    with pytest.raises(InputError) as refused:
        validated(TorsionSpec, table)
    said = {problem.path: f"{problem.allowed}; {problem.repair}" for problem in refused.value.problems}
    assert words in said[path]


def test_all_errors_at_once():
    with pytest.raises(InputError) as refused:
        validated(TorsionSpec, {"disc": {"a": disc("x"), "b": disc("b"), "c d": disc(1)}, "free_end": "f"})
    assert [problem.path for problem in refused.value.problems] == [
        'disc."c d"',
        "disc.a.beside",
        "disc.b.beside",
        "free_end",
    ]


def test_a_disc_that_leads_into_a_ring_is_not_blamed_for_it():
    with pytest.raises(InputError) as refused:
        validated(TorsionSpec, {"disc": {"a": disc("b"), "b": disc("c"), "c": disc("b"), "d": disc("a")}})
    assert [problem.path for problem in refused.value.problems] == ["disc.b.beside", "disc.c.beside"]


class TestOrder:
    """Rows of Holzer's table: from the free end to the output, each branch before what it stands on."""

    def test_as_the_shaft_runs(self):
        found = train(
            3,
            stiffness=STIFF,
            disc={"gears": disc(1, STIFF), "pulley": disc("gears", STIFF), "flywheel": disc(3, STIFF)},
        )
        assert found.names == ("pulley", "gears", "1", "2", "3", "flywheel")
        assert found.following.tolist() == [1, 2, 3, 4, 5]
        assert found.throws.tolist() == [2, 3, 4]
        assert found.free_end == 2

    def test_flywheel_side_ends_it_wherever_it_stands_in_the_file(self):
        found = train(2, stiffness=STIFF, disc={"flywheel": disc(2, STIFF), "pulley": disc(1, STIFF)})
        assert found.names == ("pulley", "1", "2", "flywheel")

    def test_no_disc_on_the_flywheels_side(self):
        assert train(2, stiffness=STIFF, disc={"pulley": disc(1, STIFF)}).names == ("pulley", "1", "2")

    def test_single_throw(self):
        found = train(1, disc={"pulley": disc(1, STIFF), "rotor": disc(1, STIFF)})
        assert found.names == ("pulley", "1", "rotor")

    def test_branches(self):
        found = train(
            2,
            stiffness=STIFF,
            disc={
                "pump": disc(2, SOFT),
                "flywheel": disc(2, STIFF),
                "generator": disc("flywheel", SOFT),
                "propeller": disc("flywheel", SOFT),
            },
            free_end="flywheel",
        )
        assert found.names == ("1", "pump", "2", "generator", "flywheel", "propeller")
        assert found.following.tolist() == [2, 2, 4, 4, 5]
        assert found.free_end == 4


def test_one_value_stands_for_all():
    found = train(4, stiffness="3 kN·m/rad", throw_inertia="0.5 kg·m²")
    np.testing.assert_array_equal(found.stiffness, [[3000.0] * 3])
    np.testing.assert_array_equal(found.inertia, [[0.5] * 4])


def test_lists_stand_for_each():
    found = train(3, stiffness=["3 kN·m/rad", "4 kN·m/rad"], throw_inertia=["1 kg·m²", "2 kg·m²", "3 kg·m²"])
    np.testing.assert_array_equal(found.stiffness, [[3000.0, 4000.0]])
    np.testing.assert_array_equal(found.inertia, [[1.0, 2.0, 3.0]])


def test_ratios_count_with_their_squares_all_the_way():
    """A pinion on the flywheel, a wheel that turns a third as fast, and a rotor geared up again by 6."""
    found = train(
        1,
        throw_inertia="1 kg·m²",
        disc={
            "flywheel": disc(1, STIFF),
            "wheel": disc("flywheel", SOFT, ratio="1/3"),
            "rotor": disc("wheel", SOFT, ratio=6),
        },
    )
    assert found.names == ("1", "flywheel", "wheel", "rotor")
    np.testing.assert_allclose(found.ratio, [[1.0, 1.0, 1 / 3, 2.0]])
    np.testing.assert_allclose(found.inertia, [[1.0, 2.0, 2 / 9, 8.0]])
    np.testing.assert_allclose(found.stiffness, [[1e6, 1e3 / 9, 4e3]])


def test_what_sits_on_a_disc_rigidly_is_part_of_it():
    found = train(
        1,
        disc={
            "flywheel": disc(1, STIFF),
            "shafts": disc("flywheel", ratio=2),
            "pump": disc("shafts", ratio=0.5),
            "rotor": disc("pump", SOFT, ratio=3),
            "chain": disc(1, ratio=2),
        },
    )
    assert found.names == ("1", "flywheel", "rotor")
    np.testing.assert_allclose(found.inertia, [[2 * 4, 2 + 2 * 4 + 2, 2 * 9]])
    np.testing.assert_allclose(found.stiffness, [[1e6, 9e3]])


def test_designs_differ_in_numbers():
    specs = [
        validated(TorsionSpec, {"disc": {"flywheel": disc(1, stiffness)}, "throw_inertia": "1 kg·m²"})
        for stiffness in (SOFT, STIFF)
    ]
    np.testing.assert_array_equal(declared_train(in_columns(specs), 1, 2).stiffness, [[1e3], [1e6]])
