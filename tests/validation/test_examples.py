"""The example machines against what is published of them, to the digits printed.

Sources, by machine:

* 3D12: slave stroke 186.7 mm from Bolotin's list of engines and sovavto.net; 38.88 L = 6 · π/4 · 150² · (180 + 186.7)
  mm³ (published: 38.8 L); compression ratios 14.5 and 15 from a German reference page and sovavto.net. Dead centres and
  pin heights of the three sets of rods: closed form in 40 digits, and the reference case articulated_V2.
* M-50 and 40D: slave strokes 209.8 and 304.3 mm from Bolotin's list of engines; 4.9 and 1.4 % = 209.8/200, 304.3/300.
  Pin heights 100 + 356 and 150 + 533 mm, dead centres by 30 digits.
* VAZ-21213: order from vaz2121.ru; 1689.9 cm³ = 4 · π/4 · 82² · 80 mm³; dead centres at asin(e/(L + R)) =
  asin(−1.2/176) and asin(e/(L − R)) = asin(−1.2/96).
* In-line six: discs, shafts and dimensions of openTorsion's example (MIT), after Mendes, Meirelles and Zampieri 2008,
  doi 10.1243/14644193JMBD126; 7.118 L = 6 · π/4 · 105² · 137 mm³. Natural frequencies of these by 40 digits.
* KamAZ-740.10: 10.857 L = 8 · π/4 · 120³ mm³ (published: 10.86 L), 10.4 m/s = 2 · 0.12 m · 2600/min; cross-plane order.
* R-1340: 1343.8 in³ = 9 · π/4 · 5.75³ in³ (published: 1344 in³), 10.95 m/s = 2 · 0.14605 m · 2250/min; order from
  FAA-H-8083-32. What the illustrative rods give: a second code in closed form.
* Pumping unit C-57D-109-48: torque factor 23.3 in at 90° from the maker's list; the rest from the reference case of a
  40-digit solver.
* Kolchin and Demidov's engine: 1.491 L = 4 · π/4 · 78³ mm³; L = 39/0.285 = 136.84 mm.
"""

import tomllib
from importlib.resources import files

import mpmath as mp
import numpy as np
import pytest
from tests.reference_case import ReferenceCase

import cranktrain as ct

INCH = 0.0254
LITRE = 1e-3


def example(name: str) -> dict:
    return tomllib.loads(files("cranktrain.examples").joinpath(f"{name}.toml").read_text(encoding="utf-8"))


def run(name: str, **changes) -> ct.Result:
    return ct.run(ct.Machine(**{**example(name), **changes}))


def printed(number: str):
    """A number to the digits in which it is printed."""
    decimals = len(number.partition(".")[2])
    return pytest.approx(float(number), abs=0.5 * 10.0**-decimals)


def of_bank(result: ct.Result, bank: str, values) -> np.ndarray:
    """The values of one bank's pistons, which must all agree."""
    chosen = values[[name.endswith(bank) for name in result.labels["piston"]]]
    assert np.ptp(chosen) < 1e-9 * np.max(np.abs(values))
    return chosen[0]


def firing_order(result: ct.Result) -> str:
    return "-".join(np.array(result.labels["piston"])[np.argsort(result.firing_angle)])


@pytest.fixture(scope="module")
def v12() -> ct.Result:
    return run("3d12")


def test_3d12_slave_piston(v12):
    assert of_bank(v12, "L", v12.stroke) * 1e3 == printed("180.000")
    assert of_bank(v12, "R", v12.stroke) * 1e3 == printed("186.700")
    assert of_bank(v12, "L", v12.top_position) * 1e3 == printed("410.000")
    assert of_bank(v12, "R", v12.top_position) * 1e3 == printed("410.000")
    assert of_bank(v12, "R", v12.top_shift) == printed("0.82")
    assert of_bank(v12, "R", v12.bottom_shift) == printed("-4.26")


def test_3d12_volumes(v12):
    assert float(v12.displacement) / LITRE == printed("38.88")
    assert of_bank(v12, "L", v12.compression_ratio) == printed("14.5")
    assert of_bank(v12, "R", v12.compression_ratio) == printed("15.0")


def test_3d12_firing(v12):
    assert firing_order(v12) == "1L-6R-5L-2R-3L-4R-6L-1R-2L-5R-4L-3R"
    assert v12.firing_interval == pytest.approx(np.full(12, 60.0), abs=1e-9)


def test_3d12_astern_is_the_mirrored_machine(v12):
    astern = run("3d12", running="astern")
    assert astern.stroke == pytest.approx(v12.stroke, rel=1e-12)
    assert astern.top_position == pytest.approx(v12.top_position, rel=1e-12)
    assert astern.compression_ratio == pytest.approx(v12.compression_ratio, rel=1e-12)
    assert of_bank(astern, "R", astern.top_shift) == printed("-0.82")
    assert of_bank(astern, "R", astern.bottom_shift) == printed("4.26")
    assert firing_order(astern) == "1L-3R-4L-5R-2L-1R-6L-4R-3L-2R-5L-6R"
    assert astern.firing_interval == pytest.approx(np.full(12, 60.0), abs=1e-9)


def test_3d12_quoted_rods_do_not_give_the_published_stroke():
    result = run("3d12_quoted_rods")
    case = ReferenceCase.load("articulated_V2")
    assert of_bank(result, "R", result.stroke) * 1e3 == printed("187.07")
    for name, value in (
        ("stroke_mm", result.stroke * 1e3),
        ("tdc_shift_deg", result.top_shift),
        ("bdc_shift_deg", result.bottom_shift),
        ("H_mm", result.top_position * 1e3),
        ("h_mm", result.bottom_position * 1e3),
    ):
        case.compare_value(f"V2_recalled.{name}", of_bank(result, "R", value))


def test_3d12_other_rods_give_the_published_stroke_too():
    result = run("3d12_fit_85_235")
    assert of_bank(result, "R", result.stroke) * 1e3 == printed("186.70")
    assert of_bank(result, "R", result.top_shift) == printed("1.03")
    assert of_bank(result, "R", result.bottom_shift) == printed("-4.59")


@pytest.mark.parametrize(
    ("name", "stroke", "own", "height", "top", "bottom", "more"),
    [
        ("m_50", "209.8", "200.0", "456.00", "0.51", "-4.70", "4.9"),
        ("40d", "304.3", "300.0", "683.00", "0.56", "-1.78", "1.4"),
    ],
)
def test_other_engines_whose_slave_strokes_are_printed(name, stroke, own, height, top, bottom, more):
    result = run(name)
    found = {bank: of_bank(result, bank, result.stroke) * 1e3 for bank in "LR"}
    assert found["L"] == printed(own)
    assert found["R"] == printed(stroke)
    assert of_bank(result, "R", result.top_position) * 1e3 == printed(height)
    assert of_bank(result, "R", result.top_shift) == printed(top)
    assert of_bank(result, "R", result.bottom_shift) == printed(bottom)
    assert 100 * (found["R"] / found["L"] - 1) == printed(more)


def test_vaz_21213():
    result = run("vaz_21213")
    assert float(result.displacement) * 1e6 == printed("1689.9")
    assert firing_order(result) == "1-3-4-2"
    assert result.firing_interval == pytest.approx(np.full(4, 180.0), abs=1e-9)
    assert of_bank(result, "", result.top_shift) == printed("-0.391")
    assert of_bank(result, "", result.bottom_shift) == printed("-0.716")


INLINE_SIX_DISCS = (0.0170, 0.0090, 0.0467, 0.0327, 0.0467, 0.0467, 0.0327, 0.0487, 2.0750)
INLINE_SIX_SHAFTS = (1.106e6, 1.631e6, 1.253e6, 1.253e6, 1.678e6, 1.253e6, 1.253e6, 1.976e6)


def test_inline_six():
    result = run("inline_six")
    assert result.displacement / LITRE == printed("7.118")
    assert firing_order(result) == "1-5-3-6-2-4"
    assert result.firing_interval == pytest.approx(120)
    np.testing.assert_allclose(result.disc_inertia, INLINE_SIX_DISCS, atol=1e-6)
    np.testing.assert_allclose(result.disc_stiffness[:-1], INLINE_SIX_SHAFTS, rtol=1e-15)
    with mp.workdps(40):
        stiffness = mp.diag([0] * 9)
        for one, shaft in enumerate(INLINE_SIX_SHAFTS):
            stiffness[one, one] += shaft
            stiffness[one + 1, one + 1] += shaft
            stiffness[one, one + 1] = stiffness[one + 1, one] = -shaft
        root = mp.diag([1 / mp.sqrt(disc) for disc in INLINE_SIX_DISCS])
        published = sorted(mp.eigsy(root * stiffness * root, eigvals_only=True))[1:]
    np.testing.assert_allclose(result.natural_frequency, [float(mp.sqrt(one)) for one in published], rtol=1e-5)
    assert [result.natural_frequency[i] / (2 * np.pi) for i in range(3)] == [
        printed("216.58"),
        printed("592.74"),
        printed("984.92"),
    ]


def test_kamaz_740():
    result = run("kamaz_740")
    assert float(result.displacement) / LITRE == printed("10.857")
    assert result.mean_piston_speed == pytest.approx(np.full(8, 10.4), abs=1e-9)
    assert firing_order(result) == "1R-1L-4R-2R-2L-3R-3L-4L"  # 1-5-4-2-6-3-7-8
    assert result.firing_interval == pytest.approx(np.full(8, 90.0), abs=1e-9)


def test_r_1340_swept_volume():
    result = run("r_1340")
    assert 9 * float(result.swept_volume[0]) / INCH**3 == printed("1343.8")
    assert float(result.displacement) / LITRE == printed("22.08")
    assert float(result.mean_piston_speed[0]) == printed("10.95")


def test_r_1340_strokes_and_dead_centres():
    result = run("r_1340")
    assert result.stroke.min() * 1e3 == printed("146.05")
    assert result.stroke.max() * 1e3 == printed("147.08")
    assert result.top_shift.max() == printed("4.46")
    assert result.top_shift.min() == printed("-4.46")


def test_r_1340_firing():
    result = run("r_1340")
    assert firing_order(result) == "1M-2S-4S-6S-8S-1S-3S-5S-7S"  # 1-3-5-7-9-2-4-6-8
    assert result.firing_interval == pytest.approx(np.full(9, 80.0), abs=1e-9)


@pytest.fixture(scope="module")
def pumping_unit() -> ct.Result:
    return ct.run(ct.Machine(**example("pumping_unit_c57")), step_degrees=15)


@pytest.fixture(scope="module")
def case() -> ReferenceCase:
    return ReferenceCase.load("pumping_unit_C-57D-109-48")


def test_pumping_unit_stroke(pumping_unit, case):
    stroke = float(pumping_unit.load_stroke[0]) / INCH
    assert stroke == printed("49.52")
    case.compare_value("stroke_in", stroke)
    assert np.rad2deg(pumping_unit.swing[0]) == printed("44.34")


def test_pumping_unit_dead_centres(pumping_unit):
    # The horsehead is lowest where the beam is farthest clockwise.
    assert pumping_unit.largest_rocker_angle_at[0] == printed("2.06")
    assert pumping_unit.smallest_rocker_angle_at[0] == printed("186.68")


def test_pumping_unit_torque_factor(pumping_unit, case):
    torque_factor = pumping_unit.load_velocity_coefficient[0] / INCH
    at_90 = torque_factor[list(pumping_unit.crank_angle).index(90.0)]
    assert at_90 == printed("23.3")
    assert at_90 == printed("23.3056")
    case.compare_value("TF_at_90deg_in", at_90)
    assert float(pumping_unit.largest_torque_factor[0]) / INCH == printed("25.41")


def test_pumping_unit_table_of_every_15_degrees(pumping_unit, case):
    travel = pumping_unit.load_displacement[0] / float(pumping_unit.load_stroke[0])
    torque_factor = pumping_unit.load_velocity_coefficient[0] / INCH
    case.compare(
        {
            # The table repeats its first row at 360°.
            "TF_in": np.append(torque_factor, torque_factor[0]),
            "position_of_rods": np.append(travel, travel[0]),
        }
    )


def test_textbook_engine():
    result = run("textbook_78x78")
    assert float(result.displacement) / LITRE == printed("1.491")
    assert (result.top_position - 0.039) * 1e3 == pytest.approx(np.full(4, 136.84), abs=0.005)


def test_38d8():
    """The maker publishes 1037 cubic inches, by the strokes; cos(12°/2) of it is swept."""
    result = run("38d8")
    area = np.pi / 4 * (8.125 * INCH) ** 2
    assert area * float(result.nominal_stroke[0]) / INCH**3 == printed("1036.97")
    assert float(result.swept_volume[0]) / INCH**3 == printed("1031.29")
    assert result.firing_interval == pytest.approx(np.full(8, 45.0), abs=1e-9)


def test_10d100():
    result = run("10d100")
    assert float(result.displacement) / LITRE == printed("170.02")
    assert result.inner_volumetric_dead_centre[0] == pytest.approx(6.0, abs=1e-9)
    assert result.outer_volumetric_dead_centre[0] == pytest.approx(186.0, abs=1e-9)
    assert float(result.exhaust_opens_before[0]) == printed("17.8")
    assert float(run("10d100", running="astern").exhaust_opens_before[0]) == printed("-6.2")
    assert float(result.effective_compression_ratio[0]) == printed("10.67")
    assert float(result.mean_piston_speed[0]) == printed("7.20")


def test_jumo_205_with_either_lead():
    assert float(run("jumo_205").displacement) / LITRE == printed("16.549")
    assert float(run("jumo_205e").displacement) / LITRE == printed("16.574")
    assert 6 * np.pi / 4 * 0.105**2 * float(run("jumo_205").nominal_stroke[0]) / LITRE == printed("16.625")


def test_deltic():
    """5384 cubic inches are published, by the strokes; 20° of lead leave cos 10° of them."""
    result = run("deltic")
    assert float(result.displacement) / INCH**3 == printed("5302.4")
    assert result.firing_interval == pytest.approx(np.full(18, 20.0), abs=1e-9)
    clearance = float(result.clearance_volume[0]) * 1e6
    assert clearance == printed("264.4")


def test_m_503_repeats_a_radial_six_times():
    result = run("m_503")
    assert len(result.labels["piston"]) == 42
    np.testing.assert_allclose(result.stroke[6:12], result.stroke[36:42], rtol=1e-13)
    assert 42 * np.pi / 4 * 0.16**2 * 0.17 / LITRE == printed("143.6")
    assert result.compression_ratio == pytest.approx(np.full(42, 13.0), abs=0.006)
