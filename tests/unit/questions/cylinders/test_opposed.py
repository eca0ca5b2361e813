"""Opposed pistons by closed forms: 4R cos(Δ/2), Δ/2, port angles, and phases that close round shafts."""

import re

import numpy as np
import pytest
from tests.machines import slider, turned
from tests.sentences import ONE_OF_SHAFTS
from tests.told import line_of, problems_told, texts_of

import cranktrain as ct

CRANK = {"kind": "slider_crank", "crank_radius": "127 mm", "rod_length": "508 mm"}


def machine(lead=12.0, exhaust=CRANK, scavenge=CRANK, upper=None, cylinder=None, **tables):
    return ct.Machine(
        shaft={"main": {"speed": "850 rpm"}, "upper": upper or {}},
        bank={
            "A": {
                "lead": f"{lead!r} deg",
                "exhaust": {"mechanism": exhaust},
                "scavenge": {"mechanism": scavenge, "shaft": "upper"},
            }
        },
        cylinder=cylinder or {},
        **tables,
    )


def travel(alpha, radius=0.127, rod=0.508):
    return radius * (1 - np.cos(alpha)) + rod - np.sqrt(rod**2 - radius**2 * np.sin(alpha) ** 2)


@pytest.mark.parametrize("ratio", [1, -1])
@pytest.mark.parametrize("lead", [0.0, 5.0, 12.0, 20.0, -12.0])
def test_equal_cranks_and_rods(lead, ratio):
    result = ct.run(machine(lead, upper={"ratio": ratio}))
    assert result.lead[0] == pytest.approx(lead, abs=1e-12)
    assert result.combined_stroke[0] == pytest.approx(4 * 0.127 * np.cos(np.deg2rad(lead / 2)), rel=1e-15)
    assert result.nominal_stroke[0] == pytest.approx(4 * 0.127, rel=1e-15)
    assert turned(result.inner_volumetric_dead_centre[0] - lead / 2) == pytest.approx(0, abs=1e-10)
    assert turned(result.outer_volumetric_dead_centre[0] - 180 - lead / 2) == pytest.approx(0, abs=1e-10)
    assert result.inner_volumetric_shift[0] == pytest.approx(lead / 2, abs=1e-10)
    assert result.least_combined_travel[0] == pytest.approx(2 * travel(np.deg2rad(lead / 2)), abs=1e-15)


@pytest.mark.parametrize("running", ["ahead", "astern"])
def test_combined_travel_is_the_sum_of_both(running):
    sense = 1 if running == "ahead" else -1
    result = ct.run(machine(running=running))
    phi = np.deg2rad(result.crank_angle)
    both = travel(phi) + travel(phi - sense * np.deg2rad(12))
    np.testing.assert_allclose(result.combined_displacement[0], both - 2 * travel(np.deg2rad(6)), rtol=0, atol=1e-15)
    assert result.lead[0] == pytest.approx(sense * 12, abs=1e-12)


@pytest.mark.parametrize(
    ("exhaust", "scavenge", "inner", "outer"), [(0.22, 0.26, 0.0970, -0.1570), (0.20, 0.30, 0.2405, -0.3976)]
)
def test_unequal_rods_are_off_half_the_lead(exhaust, scavenge, inner, outer):
    """Numbers found by two other programs; half the lead is 6°."""
    rods = [{"kind": "slider_crank", "crank_radius": "127 mm", "crank_to_rod_ratio": x} for x in (exhaust, scavenge)]
    result = ct.run(machine(12.0, *rods))
    assert result.inner_volumetric_shift[0] == pytest.approx(6 + inner, abs=6e-5)
    assert result.outer_volumetric_shift[0] == pytest.approx(6 + outer, abs=6e-5)
    said = f"12.00°, least volume {6 + inner:.2f}° after its dead centre"
    assert line_of(result, "Cylinders", "exhaust crank ahead by") == said


def test_an_offset_counts_toward_the_side_to_which_the_own_shaft_turns():
    """With the shafts opposite, mirror images that start together stay mirror images; with the same sense not."""
    offset = CRANK | {"offset": "20 mm"}
    same, opposite = (ct.run(machine(0.0, offset, offset, upper={"ratio": ratio})) for ratio in (1, -1))
    np.testing.assert_allclose(same.piston_displacement[1], same.piston_displacement[0], rtol=0, atol=1e-15)
    back = opposite.piston_displacement[1]
    np.testing.assert_allclose(back, np.roll(same.piston_displacement[1][::-1], 1), rtol=0, atol=1e-15)
    assert np.max(np.abs(back - opposite.piston_displacement[0])) > 1e-3


def port_angle(height):
    """Angle of the crank from its inner dead centre at which a central slider is `height` from the outer one."""
    x = 0.508 - 0.127 + height
    return np.degrees(np.arccos((x**2 + 0.127**2 - 0.508**2) / (2 * x * 0.127)))


@pytest.mark.parametrize(
    ("lead", "running", "before"),
    [(12.0, "ahead", 17.8), (12.0, "astern", -6.2), (5.0, "ahead", 10.8), (5.0, "astern", 0.8)],
)
def test_ports_of_a_10d100(lead, running, before):
    cylinder = {"bore": "207 mm", "compression_ratio": 13.7, "exhaust_port": "60 mm", "scavenge_port": "50 mm"}
    result = ct.run(machine(lead, cylinder=cylinder, running=running))
    sense = 1 if running == "ahead" else -1
    exhaust, scavenge = port_angle(0.06), port_angle(0.05)
    assert result.exhaust_opens[0] == pytest.approx(exhaust, abs=1e-10)
    assert result.exhaust_closes[0] == pytest.approx(360 - exhaust, abs=1e-10)
    assert result.scavenge_opens[0] == pytest.approx(scavenge + sense * lead, abs=1e-10)
    assert result.scavenge_closes[0] == pytest.approx(360 - scavenge + sense * lead, abs=1e-10)
    assert result.exhaust_opens_before[0] == pytest.approx(before, abs=0.05)
    assert any("blows back" in flag for flag in texts_of(result.flags)) == (before < 0)
    if (lead, running) == (12.0, "ahead"):
        assert result.effective_compression_ratio[0] == pytest.approx(10.67, abs=5e-3)


def test_ports_of_one_piston():
    """A loop-scavenged cylinder: both ports on its only piston, symmetric about the bottom."""
    cylinder = {"cycle": "two-stroke", "exhaust_port": "60 mm", "scavenge_port": "50 mm"}
    result = ct.run(ct.Machine(mechanism=CRANK, cylinder=cylinder))
    assert result.exhaust_opens[0] == pytest.approx(port_angle(0.06), abs=1e-10)
    assert result.scavenge_closes[0] == pytest.approx(360 - port_angle(0.05), abs=1e-10)
    assert result.exhaust_closes_before[0] == pytest.approx(-result.exhaust_opens_before[0], abs=1e-10)


def test_a_port_higher_than_the_stroke_is_never_shut():
    result = ct.run(machine(cylinder={"exhaust_port": "260 mm", "scavenge_port": "50 mm"}))
    assert np.isnan(result.exhaust_opens[0])
    assert any("never shut" in flag for flag in texts_of(result.flags))


def triangle(*leads, ratios=(1, 1, -1)):
    """Three shafts at the corners of a triangle and cylinders along its sides, each with a different exhaust shaft."""
    shafts = dict(zip(("main", "b", "c"), ({"ratio": ratio} for ratio in ratios), strict=True))
    del shafts["main"]["ratio"]
    ends = (("main", "b", 90.0), ("b", "c", 210.0), ("c", "main", 330.0))
    return ct.Machine(
        shaft=shafts,
        bank={
            name: {
                "angle": f"{angle!r} deg",
                "lead": f"{lead!r} deg",
                "exhaust": {"mechanism": slider(), "shaft": exhaust},
                "scavenge": {"mechanism": slider(), "shaft": scavenge},
            }
            for name, (exhaust, scavenge, angle), lead in zip("ABC", ends, leads, strict=True)
        },
    )


def test_a_triangle_with_one_shaft_reversed_closes_at_20_degrees():
    """3Δ + 60°·Σr ≡ 0 gives Δ = ±20° for one reversed shaft, the sign as the triangle is run round."""
    with pytest.raises(ct.InputError) as caught:
        ct.run(triangle(15.0, 15.0, 15.0))
    (problem,) = problems_told(caught.value.problems)
    assert problem.path.startswith("bank.")
    wanted = float(re.search(r"; or (\S+) deg for each of the 3 banks", problem.allowed)[1])
    assert abs(wanted) == pytest.approx(20, abs=1e-9)
    result = ct.run(triangle(wanted, wanted, wanted))
    np.testing.assert_allclose(result.lead, wanted, atol=1e-12)
    # Bank phases 0, −40°, −80° (or the other way round): with six throws at 60° one firing every 20°.
    assert np.sort(np.mod(result.inner_volumetric_dead_centre, 60)) == pytest.approx(
        np.sort(np.mod(result.inner_volumetric_dead_centre[0] + np.array([0, 20, 40]), 60)), abs=1e-9
    )


def test_a_triangle_with_all_shafts_alike_wants_60_degrees():
    with pytest.raises(ct.InputError, match=r"or -?(60|180) deg for each of the 3 banks"):
        ct.run(triangle(20.0, 20.0, 20.0, ratios=(1, 1, 1)))
    ct.run(triangle(60.0, 60.0, 60.0, ratios=(1, 1, 1)))


def test_a_lead_and_a_phase_must_agree():
    ct.run(machine(12.0, upper={"phase": "168 deg"}))
    with pytest.raises(ct.InputError, match=r"bank.A.lead = 12.0 deg: must be 20 deg"):
        ct.run(machine(12.0, upper={"phase": "160 deg"}))


@pytest.mark.parametrize(
    ("bank", "path", "words"),
    [
        ({"exhaust": {"mechanism": CRANK}}, "bank.A.scavenge", "opposed pistons are two"),
        ({}, "bank.A.mechanism", "is missing"),
        ({"mechanism": CRANK, "lead": "5 deg"}, "bank.A.lead", "is for opposed pistons"),
        (
            {"exhaust": {"mechanism": CRANK}, "scavenge": {"mechanism": CRANK}},
            "bank.A.scavenge.side_rods",
            "must be true for just one of the two",
        ),
        (
            {"exhaust": {"mechanism": CRANK, "shaft": "upper"}, "scavenge": {"mechanism": CRANK, "side_rods": True}},
            "bank.A.scavenge.side_rods",
            "face each other",
        ),
        (
            {"mechanism": CRANK, "exhaust": {"mechanism": CRANK}, "scavenge": {"mechanism": CRANK, "shaft": "upper"}},
            "bank.A.mechanism",
            "must not stand beside",
        ),
        (
            {"exhaust": {"mechanism": CRANK}, "scavenge": {"mechanism": CRANK, "shaft": "lower"}},
            "bank.A.scavenge.shaft",
            ONE_OF_SHAFTS,
        ),
        (
            {"exhaust": {"mechanism": CRANK, "throws": [1]}, "scavenge": {"mechanism": CRANK, "shaft": "upper"}},
            "bank.A.scavenge.throws",
            "as many as the exhaust pistons have, 1",
        ),
        (
            {"exhaust": {"mechanism": CRANK}, "scavenge": {"mechanism": CRANK, "side_rods": True}, "lead": "5 deg"},
            "bank.A.lead",
            "on one shaft its throws say",
        ),
        (
            {
                "angle": ["0 deg", "90 deg"],
                "exhaust": {"mechanism": CRANK},
                "scavenge": {"mechanism": CRANK, "shaft": "upper"},
            },
            "bank.A.angle",
            "must be one angle",
        ),
    ],
)
def test_what_cannot_be(bank, path, words):
    with pytest.raises(ct.InputError) as caught:
        ct.run(
            ct.Machine(
                shaft={"upper": {"throws": ["0 deg", "90 deg"]}},
                bank={"A": bank, "B": {"mechanism": CRANK, "shaft": "upper"}},
            )
        )
    problems = {problem.path: problem.allowed for problem in problems_told(caught.value.problems)}
    assert words in problems[path]


@pytest.mark.parametrize(
    ("x", "y", "words"),
    [
        (0, 1300, None),
        (1, 1300, None),
        (20, 1300, "of which this is 20 mm beside"),
        (0, 1200, "must be more than 1268"),
        (0, -1300, "must be more than 1268"),
    ],
)
def test_where_the_other_shaft_may_stand(x, y, words):
    """Both pistons reach 2(R + L) cos-wise into the cylinder: 1268.3 mm at a lead of 12°."""
    declared = {"upper": {"place": [f"{x} mm", f"{y} mm"]}}
    if words is None:
        ct.run(machine(**declared))
        return
    with pytest.raises(ct.InputError, match=words) as caught:
        ct.run(machine(**declared))
    assert [problem.path for problem in caught.value.problems] == ["shaft.upper.place"]


@pytest.mark.parametrize(("rotation", "side"), [("clockwise", 1), ("anticlockwise", -1)])
def test_offset_pistons_lie_in_one_line_where_the_shaft_is_moved(rotation, side):
    """With the same sense their own +y point to opposite sides: the upper shaft stands off by both offsets."""
    crank = CRANK | {"offset": "30 mm"}
    declared = {"exhaust": crank, "scavenge": crank, "rotation": rotation}
    ct.run(machine(upper={"place": [f"{60 * side} mm", "1300 mm"]}, **declared))
    with pytest.raises(ct.InputError, match="of which this is 120 mm beside"):
        ct.run(machine(upper={"place": [f"{-60 * side} mm", "1300 mm"]}, **declared))


def test_a_chamber_between_two_pistons_is_one():
    with pytest.raises(ct.InputError, match=r"cylinder.chambers.*opposed pistons"):
        ct.run(machine(cylinder={"bore": "100 mm", "chambers": ["head", "crank"]}))


def two_rows(upper, own=None, **bank):
    """Three cylinders between two shafts, the lower one with throws at 0, 240 and 120°."""
    lower = ["0 deg", "240 deg", "120 deg"]
    return ct.Machine(
        shaft={"main": {"throws": lower}, "upper": upper},
        bank={
            "A": {
                "lead": "12 deg",
                "exhaust": {"mechanism": CRANK},
                "scavenge": {"mechanism": CRANK, "shaft": "upper", **(own or {})},
                **bank,
            }
        },
    )


def refusal(machine):
    with pytest.raises(ct.InputError) as caught:
        ct.run(machine)
    (problem,) = problems_told(caught.value.problems)
    assert problem.path == "bank.A.lead"
    return problem


def proposed_throws(problem):
    return re.findall(r'"([^"]+ deg)"', re.search(r"shaft\.upper\.throws = \[(.*?)\]", problem.repair)[1])


def test_a_lead_that_only_one_cylinder_has_is_refused():
    """An upper shaft that turns back brings its throws in the other order: leads 12 + 2·θ_i."""
    problem = refusal(two_rows({"ratio": -1, "throws": ["0 deg", "240 deg", "120 deg"]}))
    assert "12.00 deg (1), 132.00 deg (2), -108.00 deg (3)" in problem.allowed
    assert problem.repair.endswith("or with shaft.upper.ratio = 1")
    assert proposed_throws(problem) == ["0 deg", "120 deg", "240 deg"]
    result = ct.run(two_rows({"ratio": -1, "throws": proposed_throws(problem)}))
    np.testing.assert_allclose(result.lead, 12, atol=1e-9)


def test_throws_that_give_one_lead_are_told_among_those_of_the_shaft():
    """The bank works on throws 4, 2 and 1 of an upper shaft of four; throw 3 stays. No ratio would help."""
    throws = ["10 deg", "20 deg", "30 deg", "40 deg"]
    problem = refusal(two_rows({"throws": throws}, {"throws": [4, 2, 1]}))
    assert "12.00 deg (1), -88.00 deg (2), 162.00 deg (3)" in problem.allowed
    assert "ratio" not in problem.repair
    assert proposed_throws(problem) == ["160 deg", "280 deg", "30 deg", "40 deg"]
    result = ct.run(two_rows({"throws": proposed_throws(problem)}, {"throws": [4, 2, 1]}))
    np.testing.assert_allclose(result.lead, 12, atol=1e-9)


def test_leads_that_differ_by_rounded_throws_are_one():
    ct.run(two_rows({"throws": ["0 deg", "240.01 deg", "119.99 deg"]}))


def test_leads_that_differ_are_told_where_none_is_declared():
    """A phase places the shafts, and every cylinder has the lead that comes out."""
    throws = ["0 deg", "240 deg", "120 deg"]
    result = ct.run(two_rows({"ratio": -1, "throws": throws, "phase": "0 deg"}, lead=None))
    leads = result.lead - result.lead[0]
    assert turned(leads[1] - 120) == pytest.approx(0, abs=1e-9)
    assert turned(leads[2] + 120) == pytest.approx(0, abs=1e-9)


def test_a_10d100_whose_upper_shaft_turns_back_needs_other_throws():
    problem = refusal(ct.load("10d100").with_({"shaft.upper.ratio": -1}))
    for lead, cylinders in ((12, "1, 6"), (-60, "2, 7"), (-132, "3, 8"), (156, "4, 9"), (84, "5, 10")):
        assert f"{lead:.2f} deg ({cylinders})" in problem.allowed
