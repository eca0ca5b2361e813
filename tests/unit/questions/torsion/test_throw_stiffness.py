"""Torsion by the sizes of the crankshaft: which method counts, what is said, what is refused."""

import numpy as np
import pytest
from tests.crankshaft_i4 import RADIUS, SIZES
from tests.sentences import KEEP_ONE
from tests.told import line_of, problems_told, texts_of

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.questions.crankshaft.bending.throw_stiffness import THROW_METHODS
from cranktrain.questions.torsion.spec import TorsionSpec

NAMES = [method.name for method in THROW_METHODS]
KILO = {"frame": 379.467, "frame_clamped": 436.044, "carter": 428.717, "ker_wilson": 408.817, "zimanenko": 390.771}
"""Of the in-line four by test_crankshaft_i4 and formulas by hand. [kN·m/rad]"""
FLYWHEEL = {"inertia": "2 kg·m²", "beside": 4, "stiffness": "2000 kN·m/rad"}
CRANKSHAFT = {
    "journal_diameter": "50 mm",
    "pin_diameter": "48 mm",
    "pin_length": "28 mm",
    "web_thickness": "18 mm",
    "web_width": "76 mm",
    "web_length": "whole",
}
assert (RADIUS, SIZES["span"]) == (0.039, 0.092)


def four(torsion=None, crankshaft=CRANKSHAFT, **tables):
    """The in-line four of the reference."""
    both = {"throw_inertia": "0.01 kg·m²", "disc": {"flywheel": FLYWHEEL}} | (torsion or {})
    shaft = {"throws": ["0 deg", "180 deg", "180 deg", "0 deg"], "speed": "5600 rpm", "spacing": "92 mm"}
    data = {
        "shaft": {"main": shaft},
        "bank": {"line": {"mechanism": {"kind": "slider_crank", "crank_radius": "39 mm", "rod_length": "136 mm"}}},
        "torsion": both,
    }
    return ct.Machine(**data | ({"crankshaft": crankshaft} if crankshaft else {}) | tables)


def run(machine):
    return ct.run(machine, step_degrees=90)


def refused(machine):
    with pytest.raises(InputError) as raised:
        run(machine())
    told = problems_told(raised.value.problems)
    return {problem.path: f"{problem.given}: {problem.allowed}; {problem.repair}" for problem in told}


def test_methods_of_the_table_are_those_there_are():
    (choice, _none) = TorsionSpec.model_fields["stiffness_method"].annotation.__args__
    assert list(choice.__args__) == NAMES


@pytest.mark.parametrize("method", [None, *NAMES])
def test_vibrates_with_the_method_that_is_named(method):
    found = run(four({"stiffness_method": method} if method else {}))
    wanted = [[KILO[name] * 1e3] * 3 for name in NAMES]
    np.testing.assert_allclose(found.throw_stiffness, wanted, rtol=2e-6)
    np.testing.assert_allclose(found.disc_stiffness[:3], KILO[method or "frame"] * 1e3, rtol=2e-6)
    np.testing.assert_allclose(found.throw_stiffness_spread, 436.044 / 379.467 - 1, rtol=1e-4)
    given = run(four({"stiffness": f"{float(found.disc_stiffness[0])!r} N·m/rad"}, crankshaft=None))
    np.testing.assert_allclose(found.natural_frequency, given.natural_frequency, rtol=1e-12)


def test_what_is_given_goes_before_what_sizes_say():
    found, plain = run(four({"stiffness": "400 kN·m/rad"})), run(four({"stiffness": "400 kN·m/rad"}, crankshaft=None))
    assert found.labels["throw_method"] == ("given", *NAMES)
    assert found.labels["throw_gap"] == ("1-2", "2-3", "3-4")
    np.testing.assert_array_equal(found.natural_frequency, plain.natural_frequency)
    np.testing.assert_array_equal(found.throw_stiffness[0], [4e5] * 3)
    np.testing.assert_allclose(found.throw_stiffness[1], KILO["frame"] * 1e3, rtol=2e-6)
    assert "throw_stiffness" not in plain.catalogue


def test_is_said():
    """The crank frame is 5.1 % below what is given, the clamped one 9.0 % above; the others are between them."""
    found = run(four({"stiffness": "400 kN·m/rad"}))
    assert line_of(found, "Torsion", "stiffness of throws") == "400.0 kN·m/rad, given; others −5 to +9 %"


def test_sizes_that_stand_in_the_shafts_own_table():
    found = run(four(crankshaft={"main": CRANKSHAFT}))
    np.testing.assert_array_equal(found.throw_stiffness, run(four()).throw_stiffness)


def test_each_gap_has_its_own():
    """A thinner pin on throw 4 softens the last gap, half of whose pins it is."""
    found = run(four(crankshaft=CRANKSHAFT | {"pin_diameter": ["48 mm", "48 mm", "48 mm", "40 mm"]}))
    frame = found.throw_stiffness[0] * 1e-3
    np.testing.assert_allclose(frame[:2], KILO["frame"], rtol=2e-6)
    shear, length = 206e6 / 2.6, 0.046
    softer = length / 2 * 32 / np.pi / shear * (0.040**-4 - 0.048**-4)
    np.testing.assert_allclose(1 / frame[2], 1 / KILO["frame"] + softer, rtol=2e-6)
    np.testing.assert_array_equal(found.disc_stiffness[:3], found.throw_stiffness[0])


def test_a_disc_in_the_middle_of_the_shaft():
    """Throws behind it lead toward it, and each gap keeps its stiffness."""
    table = {"disc": {"flywheel": FLYWHEEL | {"beside": 2}}}
    crankshaft = CRANKSHAFT | {"pin_diameter": ["48 mm", "48 mm", "48 mm", "40 mm"]}
    found = run(four(table, crankshaft=crankshaft))
    given = [f"{one!r} N·m/rad" for one in found.throw_stiffness[0].tolist()]
    plain = run(four(table | {"stiffness": given}, crankshaft=None))
    np.testing.assert_array_equal(found.disc_stiffness, plain.disc_stiffness)


def test_several_designs_at_once():
    sizes = [("76 mm", "0 mm"), ("90 mm", "20 mm")]
    machines = [four(crankshaft=CRANKSHAFT | {"web_width": width, "pin_bore": bore}) for width, bore in sizes]
    together = ct.run(machines, step_degrees=90)
    for design, machine in enumerate(machines):
        alone = run(machine)
        np.testing.assert_array_equal(together.throw_stiffness[design], alone.throw_stiffness)
        np.testing.assert_array_equal(together.natural_frequency[design], alone.natural_frequency)


class TestMinded:
    def test_webs_that_ker_wilson_does_not_know(self):
        thick = CRANKSHAFT | {"journal_diameter": "110 mm", "pin_diameter": "90 mm"}
        assert any("out of its range" in flag for flag in texts_of(run(four(crankshaft=thick)).flags))
        assert not any("out of its range" in flag for flag in texts_of(run(four()).flags))

    def test_a_stiffness_in_another_unit(self):
        flags = texts_of(run(four({"stiffness": "400 N·m/rad"})).flags)
        assert any(flag.endswith("is 0.00105 times what the crankshaft's sizes give.") for flag in flags)

    def test_no_journal_between_two_throws(self):
        """The frame knows a web from pin to pin, rules do not."""
        crankshaft = CRANKSHAFT | {"journals": [1, 2, 4, 5]}
        found = run(four(crankshaft=crankshaft))
        assert np.all(np.isfinite(found.throw_stiffness[:2]))
        np.testing.assert_array_equal(np.isnan(found.throw_stiffness[2:]), [[False, True, False]] * 3)
        assert np.all(found.natural_frequency > 0)
        found = run(four({"stiffness_method": "carter"}, crankshaft=crankshaft))
        assert np.all(np.isnan(found.natural_frequency))
        assert "Carter gives no stiffness between throws that one web joins." in texts_of(found.flags)
        assert {check.name: texts_of(check.reasons) for check in found.checks}["holzer"] == ("needs every stiffness",)


class TestRefused:
    def test_neither_a_stiffness_nor_sizes(self):
        words = refused(lambda: four(crankshaft=None))
        assert "is missing; give one value, or one for each of the 3 gaps" in words["torsion.stiffness"]

    def test_a_method_without_sizes(self):
        words = refused(lambda: four({"stiffness_method": "carter"}, crankshaft=None))
        assert words == {"torsion.stiffness_method": "carter: needs [crankshaft], whose sizes give the stiffness; None"}

    def test_a_method_beside_a_stiffness(self):
        words = refused(lambda: four({"stiffness": "400 kN·m/rad", "stiffness_method": "carter"}))
        assert KEEP_ONE in words["torsion.stiffness_method"]

    def test_no_such_method(self):
        assert "zimanenko" in refused(lambda: four({"stiffness_method": "tuplin"}))["torsion.stiffness_method"]

    def test_a_method_with_one_throw(self):
        disc = {"flywheel": FLYWHEEL | {"beside": 1}}
        main = {"throws": ["0 deg"], "speed": "900 rpm"}
        words = refused(
            lambda: four(
                {"disc": disc, "stiffness_method": "frame"},
                crankshaft=CRANKSHAFT | {"bearing_distance": "50 mm"},
                shaft={"main": main},
            )
        )
        assert "this crankshaft has one throw" in words["torsion.stiffness_method"]

    def test_throws_that_stand_nowhere(self):
        main = {"throws": ["0 deg", "180 deg", "180 deg", "0 deg"], "speed": "900 rpm"}
        assert "`spacing` of the shaft" in refused(lambda: four(shaft={"main": main}))["torsion.stiffness"]

    @pytest.mark.parametrize(
        ("sizes", "path"),
        [
            ({"web_width": "0 mm"}, "crankshaft.web_width"),
            ({"web_thickness": "40 mm"}, "crankshaft"),
            ({"pin_bore": "50 mm"}, "crankshaft.pin_bore"),
        ],
    )
    def test_sizes_of_no_shaft(self, sizes, path):
        assert any(where.startswith(path) for where in refused(lambda: four(crankshaft=CRANKSHAFT | sizes)))
