"""Volumes by hand: π/4 D² S, V_c = V_h/(ε − 1), and the pin heights of a shared deck."""

import copy

import numpy as np
import pytest
from tests.machines import RADIUS, ROD, V12, banks, curve, of, slider, throws
from tests.sentences import WITHOUT_PISTONS
from tests.told import problems_told

import cranktrain as ct
from cranktrain.questions.cylinders.volumes import Chambers

AREA = np.pi / 4 * 0.08**2
STROKE = 2 * RADIUS


def run(cylinder, shaft=None, bank=None, **tables):
    return ct.run(ct.Machine(shaft=shaft or throws(0), bank=bank or banks(A=0), cylinder=cylinder, **tables))


def of_chamber(result, name, values):
    return values[result.labels["chamber"].index(name)]


def test_single_acting():
    result = run({"bore": "80 mm", "compression_ratio": 11})
    assert result.labels["chamber"] == ("1",)
    assert result.swept_volume[0] == pytest.approx(AREA * STROKE, rel=1e-15)
    assert result.clearance_volume[0] == pytest.approx(AREA * STROKE / 10, rel=1e-14)
    np.testing.assert_allclose(result.chamber_volume[0], AREA * STROKE / 10 + AREA * curve(result, "1"), rtol=1e-14)
    assert result.compression_ratio[0] == pytest.approx(11, rel=1e-14)
    assert result.displacement.shape == ()


def test_double_acting_with_a_piston_rod():
    """The crank-side chamber is smaller by the rod, and smallest where the piston is at the bottom."""
    given = {"bore": "80 mm", "piston_rod": "30 mm", "chambers": ["head", "crank"], "compression_ratio": 9}
    result = run(given, shaft=throws(0, 90))
    assert result.labels["chamber"] == ("1.head", "1.crank", "2.head", "2.crank")
    ring = AREA - np.pi / 4 * 0.03**2
    head, crank = (of_chamber(result, f"2.{side}", result.chamber_volume) for side in ("head", "crank"))
    displacement = curve(result, "2")
    np.testing.assert_allclose(head, AREA * STROKE / 8 + AREA * displacement, rtol=1e-13)
    np.testing.assert_allclose(crank, ring * STROKE / 8 + ring * (STROKE - displacement), rtol=1e-13)
    np.testing.assert_allclose(result.clearance_volume, np.array([AREA, ring] * 2) * STROKE / 8, rtol=1e-13)
    assert result.displacement == pytest.approx(2 * (AREA + ring) * STROKE)


@pytest.mark.parametrize("chambers", [["crank", "head"], ["crank"]])
def test_sides_in_any_order(chambers):
    result = run({"bore": "80 mm", "chambers": chambers, "compression_ratio": 5}, shaft=throws(0, 180))
    np.testing.assert_allclose(result.compression_ratio, 5.0)
    np.testing.assert_allclose(result.clearance_volume, AREA * STROKE / 4)
    assert result.labels["chamber"][0] == "1.crank"


def test_slaves_share_the_masters_deck():
    """c_s = c_m + H_m − H_s, with the stroke and pin height of the articulated rod from its own closed form."""
    result = ct.run(ct.Machine(**V12))
    phi = np.radians(np.arange(0, 360, 1e-3))
    beta = np.arcsin(90 / 320 * np.sin(phi))
    knuckle = (90 * np.exp(1j * phi) + 85 * np.exp(1j * (np.radians(67) - beta))) * np.exp(-1j * np.pi / 3)
    position = knuckle.real + np.sqrt(235**2 - knuckle.imag**2)
    stroke, top = np.ptp(position), np.max(position)
    clearance = 180 / 13.5 + 410 - top
    np.testing.assert_allclose(result.compression_ratio[:6], 14.5, rtol=1e-13)
    np.testing.assert_allclose(result.compression_ratio[6:], 1 + stroke / clearance, rtol=1e-9)
    np.testing.assert_allclose(
        result.bank_swept_volume, 6 * np.pi / 4 * 0.15**2 * np.array([0.18, stroke / 1e3]), rtol=1e-9
    )


def test_a_bank_may_have_its_own_ratio():
    data = copy.deepcopy(V12)
    data["cylinder"]["R"] = {"compression_ratio": 15.5}
    result = ct.run(ct.Machine(**data))
    np.testing.assert_allclose(result.compression_ratio, [14.5] * 6 + [15.5] * 6, rtol=1e-13)
    np.testing.assert_allclose(
        result.clearance_volume * (result.compression_ratio - 1), result.swept_volume, rtol=1e-13
    )


def test_the_nearest_table_counts():
    """High and low pressure on one shaft: the piston's table before its bank's, and that before the common one."""
    given = {
        "bore": "80 mm",
        "compression_ratio": 10,
        "R": {"bore": "120 mm", "compression_ratio": 8},
        "2R": {"bore": "200 mm"},
    }
    result = run(given, shaft=throws(0, 180), bank=banks(L=-45, R=45))
    swept = STROKE * np.pi / 4 * np.array([0.08, 0.08, 0.12, 0.2]) ** 2
    np.testing.assert_allclose(result.swept_volume, swept)
    np.testing.assert_allclose(result.compression_ratio, [10, 10, 8, 8])
    np.testing.assert_allclose(result.bank_swept_volume, [swept[:2].sum(), swept[2:].sum()])


def test_the_first_master_leads_where_the_slaves_come_first():
    data = copy.deepcopy(V12)
    data["bank"] = {name: data["bank"][name] for name in ("R", "L")}
    result = ct.run(ct.Machine(**data))
    assert of_chamber(result, "1L", result.compression_ratio) == pytest.approx(14.5)
    assert of_chamber(result, "1R", result.compression_ratio) == pytest.approx(14.17, abs=0.005)


def test_offset_master_counts_by_its_true_stroke():
    result = ct.run(ct.Machine(mechanism=slider(offset="20 mm"), cylinder={"bore": "80 mm", "compression_ratio": 11}))
    stroke = np.sqrt((ROD + RADIUS) ** 2 - 0.02**2) - np.sqrt((ROD - RADIUS) ** 2 - 0.02**2)
    assert result.clearance_volume[0] == pytest.approx(AREA * stroke / 10, rel=1e-13)


@pytest.mark.parametrize(
    ("cylinder", "path", "said"),
    [
        ({"X": {"bore": "80 mm"}}, "cylinder.X", "A, 1, 2"),
        ({"1": {"bore": "80 mm"}}, "cylinder.bore", "missing for 2"),
        ({"bore": "80 mm", "piston_rod": "80 mm"}, "cylinder.piston_rod", "less than the bore, 80 mm"),
        ({"bore": "80 mm", "2": {"piston_rod": "9 cm"}}, "cylinder.2.piston_rod", "less than the bore, 80 mm"),
        ({"bore": "80 mm", "piston_rod": "60 mm", "A": {"bore": "5 cm"}}, "cylinder.piston_rod", "the bore, 5 cm"),
        ({"chambers": ["head", "head"]}, "cylinder.chambers", "each side once"),
        ({"compression_ratio": 1}, "cylinder.compression_ratio", "more than 1"),
    ],
)
def test_refused(cylinder, path, said):
    with pytest.raises(ct.InputError) as caught:
        run(cylinder, shaft=throws(0, 180))
    (problem,) = problems_told(caught.value.problems)
    assert problem.path == path
    assert said in problem.allowed


def test_bores_of_single_pistons_make_a_whole():
    result = run({"1": {"bore": "80 mm"}, "2": {"bore": "40 mm"}}, shaft=throws(0, 180))
    np.testing.assert_allclose(result.swept_volume, [AREA * STROKE, AREA * STROKE / 4])


def test_cylinders_need_pistons():
    with pytest.raises(ct.InputError, match=f"cylinder: {WITHOUT_PISTONS}"):
        ct.run(
            ct.Machine(
                mechanism={
                    "kind": "crank_rocker",
                    "crank_radius": "1 m",
                    "rod_length": "4 m",
                    "rocker_length": "3 m",
                    "ground_length": "4 m",
                },
                cylinder={"bore": "80 mm"},
            )
        )


def test_ratio_of_one_piston_only():
    """Its head leads; on a crank side there is no deck to share, so that nothing is known."""
    given = {"bore": "80 mm", "chambers": ["head", "crank"], "1": {"compression_ratio": 6}}
    result = run(given, shaft=throws(0, 180))
    np.testing.assert_allclose(result.compression_ratio, [6, 6, 6, np.nan])
    assert of(result, "1", result.stroke) == pytest.approx(STROKE)


def test_pressures_push_their_own_pistons():
    """A double-acting piston and one of two opposed ones, in whole numbers: forces by hand, and NaN stays at home."""
    areas = np.array([[[3.0, -2.0, 0.0], [0.0, 0.0, 5.0], [0.0, 0.0, 5.0]]])
    chambers = Chambers(
        ("1.head", "1.crank", "2"),
        ("", "", ""),
        np.array([0, 0, 1]),
        np.array([True, False, True]),
        areas,
        np.full((1, 3), 1.0),
    )
    pressure = np.array([[[7.0, 4.0], [1.0, 6.0], [np.nan, 2.0]]])
    np.testing.assert_array_equal(chambers.pushed(pressure), [[[19.0, 0.0], [np.nan, 10.0], [np.nan, 10.0]]])


def compressor_with(**cylinder):
    mechanism = {"kind": "slider_crank", "stroke": "100 mm", "rod_length": "250 mm"}
    return {"mechanism": mechanism, "cylinder": {"bore": "90 mm", **cylinder}}


def test_clearance_is_the_ratio_said_by_compressors():
    """c = 8 %: V₁/V_c = 1 + 1/0.08 = 13.5."""
    result = ct.run(ct.Machine(**compressor_with(clearance="8 %")))
    assert result.compression_ratio[0] == pytest.approx(13.5, rel=1e-15)
    assert (result.clearance_volume / result.swept_volume)[0] == pytest.approx(0.08, rel=1e-14)


def test_the_nearer_of_clearance_and_ratio_counts():
    machine = ct.Machine(**compressor_with(compression_ratio=9, **{"1": {"clearance": 0.25}}))
    assert ct.run(machine).compression_ratio.tolist() == [5.0]


def test_clearance_beside_the_ratio_is_refused():
    with pytest.raises(ct.InputError, match=r"cylinder.clearance = 8 %: must not stand beside compression_ratio"):
        ct.Machine(**compressor_with(compression_ratio=9, clearance="8 %"))
