"""Running: what is asked for, the grid, designs, and machines whose links do not close all round."""

import copy

import numpy as np
import pytest
from tests.machines import RADIUS, ROCKER, V12, banks, curve, of, slider, throws
from tests.sentences import STEP_FROM_TO
from tests.told import line_of, problems_told

import cranktrain as ct
from cranktrain.analysis import every_stage, ordered
from cranktrain.questions.cylinders.travel import CylinderTravel
from cranktrain.questions.cylinders.volumes import SweptVolumes
from cranktrain.questions.motion.dead_centres import DeadCentres, PistonTurn


def test_only_what_is_asked_for_is_computed():
    result = ct.run(ct.Machine(**V12), quantities=["displacement"])
    computed = {PistonTurn, DeadCentres, CylinderTravel, SweptVolumes}
    # what is said of unlikely numbers takes what there is
    known = {type(outcome) for outcome in result.outcomes}
    assert {one for one in known if not one.__name__.startswith("Unlikely")} == computed
    assert result.displacement == ct.run(ct.Machine(**V12)).displacement
    assert "closing_margin" not in result.catalogue


def test_one_quantity_may_be_named_alone():
    result = ct.run(ct.Machine(mechanism=slider()), quantities="stroke")
    assert result.stroke[0] == pytest.approx(2 * RADIUS)
    assert "piston_displacement" not in result.catalogue


def test_unknown_quantities_are_refused_together():
    with pytest.raises(ct.InputError) as caught:
        ct.run(ct.Machine(mechanism=slider()), quantities=["stroke", "strokes", "nonsense"])
    assert [(problem.given, problem.repair) for problem in problems_told(caught.value.problems)] == [
        ("strokes", "did you mean stroke?"),
        ("nonsense", None),
    ]


def test_what_was_asked_for_and_is_lacking_is_said():
    result = ct.run(ct.Machine(mechanism=slider()), quantities=["piston_velocity"])
    with pytest.raises(AttributeError, match=r"no piston_velocity, which needs \[shaft.main\] speed"):
        _ = result.piston_velocity


@pytest.mark.parametrize(("step", "n_angles"), [(1.0, 360), (0.5, 720), (360 / 7, 7), (90, 4), (0.01, 36000)])
def test_steps(step, n_angles):
    result = ct.run(ct.Machine(mechanism=slider()), step_degrees=step, quantities="piston_displacement")
    assert result.crank_angle.shape == (n_angles,)
    np.testing.assert_allclose(result.crank_angle, np.arange(n_angles) * 360 / n_angles, rtol=1e-15)
    assert result.piston_displacement.shape == (1, n_angles)


def test_degrees_of_the_grid_are_round():
    result = ct.run(ct.Machine(mechanism=slider()), step_degrees=0.1, quantities="piston_displacement")
    assert [f"{angle!r}" for angle in result.crank_angle[[1, 3, 7, 1234]].tolist()] == ["0.1", "0.3", "0.7", "123.4"]


@pytest.mark.parametrize("step", [0, -1, 0.001, 7, 91, 360, float("nan")])
def test_steps_that_make_no_turn(step):
    with pytest.raises(ct.InputError, match=rf"step = .* deg: {STEP_FROM_TO} degrees"):
        ct.run(ct.Machine(mechanism=slider()), step_degrees=step)


def test_no_machine():
    with pytest.raises(ct.InputError, match="at least one machine"):
        ct.run([])


@pytest.mark.parametrize(
    ("change", "path"),
    [
        ({"running": "astern"}, "running"),
        ({"shaft": throws(0, 90, speed="10 rpm")}, "shaft.main.throws[1]"),
        ({"shaft": throws(0)}, "shaft.main.speed"),
        ({"bank": banks(A=0, B=90)}, "bank.B.angle[0]"),
        (
            {"bank": {"A": {"mechanism": slider(points={"p": {"link": "rod", "along": "1 m", "across": "0 m"}})}}},
            "link",
        ),
        (
            {"bank": {"A": {"mechanism": {"kind": "slider_crank", "stroke": "1 m", "rod_length": "3 m"}}}},
            "crank_radius",
        ),
        ({"cylinder": {"bore": "80 mm", "chambers": ["head", "crank"]}}, "cylinder.chambers"),
        ({"cylinder": {"bore": "80 mm", "cycle": "four-stroke"}}, "cylinder.cycle"),
        ({"cylinder": {}}, "cylinder.bore"),
    ],
)
def test_designs_differ_in_numbers_alone(change, path):
    base = {"shaft": throws(0, speed="10 rpm"), "bank": banks(A=0), "cylinder": {"bore": "80 mm"}}
    other = base | change
    with pytest.raises(ct.InputError) as caught:
        ct.run([ct.Machine(**base), ct.Machine(**base), ct.Machine(**other)])
    (problem,) = caught.value.problems
    assert path in problem.path
    assert "in design 3" in str(problem.allowed)


def test_names_of_designs_may_differ():
    result = ct.run([ct.Machine(name=name, mechanism=slider()) for name in ("a", "b")])
    assert result.labels["design"] == ("1", "2")


def test_what_is_wrong_with_any_design_is_told():
    machines = [ct.Machine(mechanism=slider(rod_length=f"{length} mm")) for length in (180, 40, 30)]
    with pytest.raises(ct.InputError) as caught:
        ct.run(machines)
    assert [problem.given for problem in caught.value.problems] == ["40 mm", "30 mm"]


def test_extremes_do_not_depend_on_the_grid():
    coarse, fine = (ct.run(ct.Machine(**V12), step_degrees=step) for step in (90, 1))
    for name, fact in fine.facts.items():
        np.testing.assert_array_equal(getattr(coarse, name), fact.value, err_msg=name)


def test_every_quantity_comes_from_an_ordered_stage():
    gives = [stage.gives for stage in ordered(every_stage())]
    assert len(set(gives)) == len(every_stage())


class TestPartial:
    """Links that do not close all round: what exists stays, what does not is NaN, and nothing warns."""

    def short_slave(self):
        data = copy.deepcopy(V12)
        data["bank"]["R"]["mechanism"]["rod_length"] = "60 mm"
        return ct.Machine(**data)

    def test_is_refused_unless_asked_for(self):
        with pytest.raises(ct.InputError, match=r"bank\.R\.mechanism\.rod_length = 60 mm: the links cannot close"):
            ct.run(self.short_slave())

    def test_pistons_that_close_are_untouched(self):
        whole, partial = ct.run(ct.Machine(**V12)), ct.run(self.short_slave(), partial=True)
        for name in ("stroke", "bottom_dead_centre", "largest_piston_speed", "closing_margin", "swept_volume"):
            np.testing.assert_array_equal(getattr(partial, name)[:6], getattr(whole, name)[:6], err_msg=name)
            assert np.isnan(getattr(partial, name)[6:]).all(), name
        np.testing.assert_array_equal(partial.chamber_volume[:6], whole.chamber_volume[:6])
        np.testing.assert_array_equal(partial.displacement_error[2, :6], whole.displacement_error[2, :6])

    def test_curves_end_where_the_links_part(self):
        result = ct.run(ct.Machine(mechanism=slider(rod_length="40 mm")), partial=True)
        phi = np.radians(result.crank_angle)
        closes = np.abs(RADIUS * np.sin(phi)) < 0.04
        assert np.array_equal(~np.isnan(result.piston_displacement[0]), closes)
        expected = 0.09 - RADIUS * np.cos(phi[closes]) - np.sqrt(0.04**2 - (RADIUS * np.sin(phi[closes])) ** 2)
        np.testing.assert_allclose(curve(result, "1")[closes], expected, atol=1e-15)

    def test_facts_that_exist_stay(self):
        """The top exists, R + L from the shaft; at the bottom the crank stands within the rod's reach no more."""
        result = ct.run(ct.Machine(mechanism=slider(rod_length="40 mm"), shaft=throws(0, speed="9 rpm")), partial=True)
        assert result.top_dead_centre[0] == 0
        assert result.top_position[0] == pytest.approx(0.09)
        assert np.isnan([result.stroke[0], result.largest_piston_speed[0], result.closing_margin[0]]).all()

    def test_checks_say_that_they_need_a_full_turn(self):
        result = ct.run(self.short_slave(), partial=True)
        assert {check.name: str(check.verdict()) for check in result.checks} == {
            "piston_derivatives": "needs a full turn",
            "zero_shift": "holds",
        }
        derivatives = next(check for check in result.checks if check.name == "piston_derivatives")
        assert not derivatives.judged[0]
        assert not derivatives.passed[0]

    @pytest.mark.parametrize(
        "mechanism",
        [
            slider(rod_length="40 mm"),
            slider(rod_length="40 mm", offset="200 mm"),
            ROCKER | {"crank_radius": "300 mm", "load_radius": "1 m"},
            ROCKER | {"rod_length": "1 mm", "load_radius": "1 m"},
            ROCKER | {"points": {"p": {"link": "rocker", "along": "1 m", "across": "1 m"}}, "crank_radius": "380 mm"},
        ],
    )
    def test_nothing_warns(self, mechanism):
        """Warnings are errors in these tests; the sentences are said too."""
        machine = ct.Machine(mechanism=mechanism, shaft=throws(0, speed="100 rpm"))
        result = ct.run([machine, machine], partial=True)
        assert result.summary(1)
        assert "nan" not in result.summary()
        assert result.dataset.sizes["design"] == 2

    def test_answers_leave_out_what_is_not(self):
        result = ct.run(self.short_slave(), partial=True)
        assert line_of(result, "Motion", "stroke") == "180.0 mm (L)"
        assert np.isnan(result.stroke[6:]).all()
        assert np.nanmin(result.closing_margin) == pytest.approx(0.7188, abs=5e-5)

    def test_a_rocker_that_only_swings_a_part_of_a_turn(self):
        """A triple rocker: no link can turn; where its crank is folded on the rod the rocker does turn back."""
        result = ct.run(ct.Machine(mechanism=ROCKER | {"crank_radius": "300 mm"}), partial=True)
        joint = 0.3 * np.exp(1j * np.radians(result.crank_angle)) + 0.36 * np.exp(1j * result.coupler_angle[0])
        closes = ~np.isnan(result.rocker_angle[0])
        assert 0 < np.sum(closes) < 360
        np.testing.assert_allclose(joint[closes], 0.4 + 0.28 * np.exp(1j * result.rocker_angle[0][closes]), atol=1e-14)
        reach = 0.3 + 0.36
        stretched = np.arccos((0.4**2 + reach**2 - 0.28**2) / (2 * 0.4 * reach))
        assert result.smallest_rocker_angle_at[0] == pytest.approx(np.degrees(stretched))
        assert np.isnan(result.largest_rocker_angle[0])


def test_mixed_machine_of_designs():
    def machine(k):
        rocker = ROCKER | {"rod_length": f"{360 + k} mm"}
        return ct.Machine(
            shaft=throws(0, 100 + k, speed=f"{60 + k} rpm", spacing=f"{100 + k} mm"),
            bank=banks(A=k, B={"angle": "70 deg", "mechanism": rocker}),
            cylinder={"bore": f"{80 + k} mm"},
        )

    several = ct.run([machine(k) for k in range(3)])
    for k in range(3):
        alone = ct.run(machine(k))
        for name in several.catalogue:
            np.testing.assert_allclose(
                getattr(several, name)[k], getattr(alone, name), rtol=1e-12, atol=1e-12, err_msg=name
            )
    assert of(several, "2A", several.stroke).shape == (3,)
