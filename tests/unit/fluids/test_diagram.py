"""From a file to a diagram: one cycle in order, placed on firing, pegged, smoothed; what is wrong or odd is told."""

import itertools
import re

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline
from tests.gas_engines import FOUR_STROKE, TWO_STROKE, Engine, csv, wiebe, wiebe_cycle
from tests.sentences import GAP_IN_DIAGRAM, NO_NUMBERS, TWO_PRESSURES
from tests.told import texts_of

from cranktrain.errors import InputError
from cranktrain.fluids.indicator import IndicatorSpec, card_of, diagram_work, indicator_diagram, pressure_at
from cranktrain.fluids.indicator.cycle import Samples
from cranktrain.fluids.indicator.diagram import diagram_through, smoothed
from cranktrain.numerics.spline import periodic_slopes
from cranktrain.spec import validated

CASE = {
    "gamma": 1.33,
    "m": 2.0,
    "a": np.log(1000),
    "start_deg": -15,
    "duration_deg": 50,
    "p_bdc": 1e5,
    "Q": 1000.0,
}
ENGINE = Engine(0.045, 0.15, 0.08, 10.0)
DEGREES = np.arange(720.0)
PRESSURES = wiebe_cycle(ENGINE, CASE, np.radians(DEGREES))


def diagram_of(text, engine=ENGINE, cycle=FOUR_STROKE, **more):
    spec = validated(IndicatorSpec, {"kind": "indicator", "file": "trace.csv", "text": text, **more})
    return indicator_diagram(card_of(spec).card[0], engine.chamber(cycle))


PLAIN = diagram_of(csv(DEGREES, PRESSURES))


@pytest.mark.parametrize("count", [-360.0, 0.0, 180.0, 360.0, 540.0], ids=lambda count: f"firing at {count:g}")
def test_firing_dead_centre_is_found(count):
    """Wherever the file has it, and wherever it begins to count."""
    degrees = np.mod(DEGREES + count, 720) + (count - np.mod(count, 720))
    order = np.argsort(degrees)
    diagram = diagram_of(csv(degrees[order], PRESSURES[order]))
    assert diagram.curve.places == pytest.approx(PLAIN.curve.places, abs=1e-12)
    assert diagram.curve.starts == pytest.approx(PLAIN.curve.starts, rel=1e-12)
    assert diagram.flags == ()
    assert any(f"at the file's {count:g}°" in finding or "180°" in finding for finding in texts_of(diagram.findings))


def test_jumps_of_the_angle_are_taken_out():
    """A file that begins in the middle of a cycle and goes on from 0."""
    degrees = np.roll(DEGREES, -250)
    diagram = diagram_of(csv(degrees, np.roll(PRESSURES, -250)))
    assert diagram.curve.places == pytest.approx(PLAIN.curve.places, abs=1e-12)
    assert diagram.curve.starts == pytest.approx(PLAIN.curve.starts, rel=1e-12)
    twice = np.mod(DEGREES, 360)
    assert diagram_of(csv(twice, PRESSURES)).curve.starts == pytest.approx(PLAIN.curve.starts, rel=1e-12)


def test_noise_reversed_sense_and_wrong_dead_centre_are_recovered_and_told():
    """Firing at the file's 360°, angles against the rotation, noise of 0.2 bar; smoothed by 0.7°."""
    noise = 0.2e5 * np.random.default_rng(1).standard_normal(1440)
    degrees = np.arange(0, 720, 0.5)
    text = csv(degrees, wiebe_cycle(ENGINE, CASE, np.radians(360 - degrees)) + noise)
    doubtful = diagram_of(text)
    assert any('write sense = "backward", or "found"' in flag for flag in texts_of(doubtful.flags))
    diagram = diagram_of(text, sense="found", smoothing="0.7 deg")
    assert any("turned round" in finding for finding in texts_of(diagram.findings))
    assert any("at the file's 360°" in finding for finding in texts_of(diagram.findings))
    assert diagram.flags == ()
    at = np.radians(np.arange(-170, 170, 0.5))
    error = pressure_at(diagram, at) - wiebe(ENGINE, CASE, at)
    # Of white noise the filter leaves √(step/σ · ∫(1 + x²/2)² exp(−x²) dx/2π) = √(0.476 step/σ); 340° hold some 180
    # independent values, so that this is uncertain by 5 %.
    left = 0.2e5 * np.sqrt(27 / 32 / np.sqrt(np.pi) * 0.5 / 0.7)
    assert np.sqrt(np.mean(error**2)) == pytest.approx(left, rel=0.1)
    # Noise in the work: σ √(Σ V′²) Δφ; three times as much.
    uncertain = 3 * 0.2e5 * np.sqrt(np.sum(ENGINE.slope(np.radians(degrees)) ** 2)) * np.radians(0.5)
    assert diagram_work(diagram, ENGINE.slope) == pytest.approx(diagram_work(PLAIN, ENGINE.slope), abs=uncertain)
    same = diagram_of(text, sense="backward", smoothing="0.7 deg")
    np.testing.assert_array_equal(same.curve.starts, diagram.curve.starts)


def test_rows_in_no_order_are_sorted():
    order = np.random.default_rng(5).permutation(len(DEGREES))
    diagram = diagram_of(csv(DEGREES[order], PRESSURES[order]))
    np.testing.assert_array_equal(diagram.curve.starts, PLAIN.curve.starts)


@pytest.mark.parametrize("offset", [-101325.0, 101325.0], ids=["gauge as absolute", "absolute as gauge"])
@pytest.mark.parametrize("boost", [1.0, 2.6])
def test_a_level_that_is_off_by_the_atmosphere_is_doubted(offset, boost):
    """Supercharged, every pressure is one that an engine could have: the exponent of the compression tells."""
    assert diagram_of(csv(DEGREES, boost * PRESSURES)).flags == ()
    off = boost * PRESSURES + offset
    flags = texts_of(diagram_of(csv(DEGREES, np.maximum(off, 1e3))).flags)
    if offset < 0 or boost == 1.0:
        assert any("the level of the pressures (absolute or gauge)" in flag for flag in flags)


def test_noise_is_doubted_until_it_is_smoothed():
    noise = 0.02 * np.max(PRESSURES) * np.random.default_rng(1).standard_normal(len(DEGREES))
    text = csv(DEGREES, np.maximum(PRESSURES + noise, 1e3))
    assert any(
        re.search(r"scatter by (1\.[89]|2\.?[01]?) % of the peak", flag) for flag in texts_of(diagram_of(text).flags)
    )
    assert not any("scatter" in flag for flag in texts_of(diagram_of(text, smoothing="2 deg").flags))


def test_sense_that_is_wrongly_given_is_not_advised_again():
    flags = texts_of(diagram_of(csv(DEGREES, PRESSURES), sense="backward").flags)
    (flag,) = (one for one in flags if "takes work" in one)
    assert "leave sense out" in flag


def test_radians_without_a_word_are_advised():
    rows = csv(np.radians(DEGREES), PRESSURES).split("\n", 1)[1]
    with pytest.raises(InputError) as refusal:
        diagram_of(f"CA,p_abs_Pa\n{rows}")
    assert 'if the file\'s angles are radians, write axis_unit = "rad"' in str(refusal.value)


def test_motored_cycle_is_told():
    """Heat loss puts the peak before the dead centre; nothing burns, so its sense is not known."""
    motored = wiebe_cycle(ENGINE, CASE | {"Q": 1e-9}, np.radians(DEGREES + 1.0))
    diagram = diagram_of(csv(DEGREES, motored))
    assert any("motored" in finding for finding in texts_of(diagram.findings))
    assert diagram.flags == ()
    late = wiebe_cycle(ENGINE, CASE | {"Q": 1e-9}, np.radians(DEGREES - 1.0))
    assert any("is the zero right?" in flag for flag in texts_of(diagram_of(csv(DEGREES, late)).flags))


def test_a_given_dead_centre_that_the_peak_denies_is_doubted():
    flags = texts_of(diagram_of(csv(DEGREES, PRESSURES), firing_angle="-20 deg").flags)
    assert any("is the zero right?" in flag for flag in flags)
    assert diagram_of(csv(DEGREES, PRESSURES), firing_angle="360 deg").flags != ()


@pytest.mark.parametrize(
    ("text", "cycle", "message"),
    [
        (
            csv(DEGREES[:361] - 180, PRESSURES[:361]),
            FOUR_STROKE,
            "file = trace.csv: holds one turn, 361°, and a four-stroke",
        ),
        (csv(DEGREES[:360], PRESSURES[:360]), FOUR_STROKE, "file = trace.csv: holds one turn, 360°, and a four-stroke"),
        (
            csv(DEGREES, PRESSURES),
            TWO_STROKE,
            "file = trace.csv: holds 720° of crank angle, more than one cycle of 360°",
        ),
        (
            csv(np.delete(DEGREES, slice(100, 140)), np.delete(PRESSURES, slice(100, 140))),
            FOUR_STROKE,
            f"trace.csv:101  {GAP_IN_DIAGRAM}",
        ),
        (
            csv(np.repeat(DEGREES, 2), np.repeat(PRESSURES, 2) + np.tile([0.0, 1e4], 720)),
            FOUR_STROKE,
            f"trace.csv:3  {TWO_PRESSURES}, the first in line 2 (720 angles are given twice)",
        ),
        (csv(DEGREES[::180], PRESSURES[::180]), FOUR_STROKE, "file = trace.csv: has 4 samples"),
        (csv(DEGREES + 100.0, PRESSURES), FOUR_STROKE, "firing_angle: the pressure peaks at the file's 116°"),
    ],
    ids=["one turn, closed", "one turn", "two turns", "gap", "two pressures", "too few", "no dead centre"],
)
def test_refused(text, cycle, message):
    with pytest.raises(InputError) as refusal:
        diagram_of(text, cycle=cycle)
    assert message in str(refusal.value)


def test_small_gap_and_repeated_rows_are_told():
    few = csv(np.delete(DEGREES, slice(200, 206)), np.delete(PRESSURES, slice(200, 206)))
    assert any("between 199° and 206°: the curve bridges them" in flag for flag in texts_of(diagram_of(few).flags))
    again = diagram_of(csv(np.insert(DEGREES, 5, 4.0), np.insert(PRESSURES, 5, PRESSURES[4])))
    assert any("1 samples that were given twice" in finding for finding in texts_of(again.findings))
    np.testing.assert_array_equal(again.curve.starts, PLAIN.curve.starts)


def test_many_gaps_are_told_in_one_sentence():
    """Seventy of three rows, and one of five."""
    left_out = np.concatenate([np.add.outer(np.arange(10, 710, 10), np.arange(3)).ravel(), [713, 714, 715, 716, 717]])
    diagram = diagram_of(csv(np.delete(DEGREES, left_out), np.delete(PRESSURES, left_out)))
    (told,) = (flag for flag in texts_of(diagram.flags) if "the curve bridges them" in flag)
    assert told == "Samples are missing at 71 places, most of all between 712° and 718°: the curve bridges them."


def test_a_cycle_that_does_not_close_is_doubted():
    """And jumps there, as the file says: from the last row's pressure to the first one's."""
    diagram = diagram_of(csv(np.arange(721.0), np.append(PRESSURES, PRESSURES[0] * 1.5)))
    assert any("the cycle does not close" in flag for flag in texts_of(diagram.flags))
    assert diagram.curve.jumps.tolist() == [0.0]
    assert pressure_at(diagram, np.array([-1e-12, 0.0])) == pytest.approx([1.5 * PRESSURES[0], PRESSURES[0]], rel=1e-9)


def test_an_endpoint_that_was_rounded_is_no_jump():
    """1e-5 of the peak apart: as the last digits of a computed cycle are."""
    diagram = diagram_of(csv(np.arange(721.0), np.append(PRESSURES, PRESSURES[0] + 1e-5 * np.max(PRESSURES))))
    assert diagram.curve.jumps.size == 0
    assert any("the last is left out" in finding for finding in texts_of(diagram.findings))


STEP = np.where((DEGREES >= 0) & (DEGREES < 400), 20e5, 2e5)
"""Two levels: with 0 and 400° given twice, of both pressures."""
JUMPING = np.sort(np.append(DEGREES, [0.0, 400.0])), np.concatenate([[2e5], STEP[:400], [20e5], STEP[400:]])


@pytest.mark.parametrize("turned", [0, 100, 400, 401, 600], ids=lambda turned: f"from {turned}")
@pytest.mark.parametrize("count", [0.0, 360.0])
@pytest.mark.parametrize("order", [1, -1], ids=["rising", "falling"])
def test_an_angle_with_two_pressures_is_a_jump(turned, count, order):
    """Wherever rows begin, whatever the count, and whether rows rise or fall: the one of lesser angle is before it."""
    degrees, pressures = (np.roll(part, -turned) for part in JUMPING)
    # A file that begins in the middle of a jump has the other half at its end, where a full cycle closes.
    degrees = np.mod(degrees + count, 720)
    diagram = diagram_of(csv(degrees[::order], pressures[::order]), firing_angle=f"{count} deg")
    assert np.degrees(diagram.curve.jumps) == pytest.approx([0.0, 400.0], abs=1e-9)
    found = pressure_at(diagram, np.array([0, 10, 399.9, 400, 500, 719.9]) * (np.pi / 180))
    assert found == pytest.approx([20e5, 20e5, 20e5, 2e5, 2e5, 2e5], rel=1e-12)
    (told,) = (finding for finding in texts_of(diagram.findings) if "jumps where the file gives two" in finding)
    assert "0.00° from 2 to 20.00 bar, at -320.00° from 20.00 to 2 bar" in told


def test_a_jump_of_a_file_against_the_rotation_is_turned_round():
    degrees, pressures = JUMPING
    diagram = diagram_of(csv(degrees, pressures), firing_angle="400 deg", sense="backward")
    assert np.degrees(diagram.curve.jumps) == pytest.approx([0.0, 400.0], abs=1e-9)
    assert pressure_at(diagram, np.radians([-1.0, 0.0, 399.0, 400.0])) == pytest.approx([2e5, 20e5, 20e5, 2e5])


def test_rows_in_no_order_have_no_jumps():
    """Which of two pressures would be before the jump cannot be told."""
    order = np.random.default_rng(5).permutation(len(JUMPING[0]))
    with pytest.raises(InputError, match=TWO_PRESSURES):
        diagram_of(csv(*(part[order] for part in JUMPING)))


def test_work_over_jumps_is_exact():
    """Two levels: the work is that of their volumes, Σ p (V₂ − V₁)."""
    diagram = diagram_of(csv(*JUMPING), firing_angle="0 deg")
    start, cut = ENGINE.volume(np.radians([0.0, 400.0])).value
    assert diagram_work(diagram, ENGINE.slope) == pytest.approx((20e5 - 2e5) * (cut - start), rel=1e-12)


def test_a_step_that_may_hide_a_jump_is_told_with_its_rows():
    (told,) = (flag for flag in texts_of(diagram_of(csv(DEGREES, STEP)).flags) if "in one step" in flag)
    assert told.startswith("Between 399° and 400° the pressure goes from 20 to 2 bar in one step, far steeper than")
    assert "and so in 1 other steps" in told


def test_noise_and_a_coarse_table_hide_no_jump():
    spike = PRESSURES.copy()
    spike[300] += 0.5 * np.max(PRESSURES)
    for degrees, pressures in (
        (DEGREES, spike),
        (DEGREES, PRESSURES + 0.05 * np.max(PRESSURES) * np.random.default_rng(2).uniform(0, 1, 720)),
        (DEGREES[::30], PRESSURES[::30]),
        (DEGREES[3::10], PRESSURES[3::10]),
    ):
        assert not any("in one step" in flag for flag in texts_of(diagram_of(csv(degrees, pressures)).flags))


def test_smoothing_and_spline_say_that_they_round_jumps_off():
    for more in ({"smoothing": "2 deg"}, {"interpolation": "spline"}):
        diagram = diagram_of(csv(*JUMPING), firing_angle="0 deg", **more)
        assert diagram.curve.jumps.size == 0
        assert any("a spline rounds that off, and so does smoothing" in flag for flag in texts_of(diagram.flags))


def test_largest_sample_and_crest_are_told():
    """A parabola's crest midway between two rows, 1/8 of a second difference above the line through them."""
    degrees = np.arange(0.0, 720, 10)
    bars = 20 + 18 * np.cos(np.radians(degrees - 13) / 2)
    diagram = diagram_of(csv(degrees, 1e5 * bars))
    (told,) = (finding for finding in texts_of(diagram.findings) if "largest sample" in finding)
    assert told == "The largest sample is 37.99 bar at 10.00° from firing, the curve's crest 38.00 bar at 13.00°."


STUDENT = """Расчёт индикаторной диаграммы;
Двигатель 4Ч 8/9, вариант 7;
Угол п.к.в., град;Давление газов, МПа
"""


@pytest.mark.parametrize("last", [710, 720])
def test_a_students_table(last):
    """Titles, a header, decimal commas; steps of 10° from 0, at the top of the exchange, to 710 or 720."""
    degrees = np.arange(0, last + 1, 10)
    bars = wiebe_cycle(ENGINE, CASE, np.radians(degrees - 360.0)) / 1e5
    rows = (f"{angle};{bar / 10:.4f}".replace(".", ",") for angle, bar in zip(degrees, bars, strict=True))
    diagram = diagram_of(STUDENT + "\n".join(rows), pressure="absolute")
    assert len(diagram.curve.places) == 72
    assert any("at the file's 360°" in finding for finding in texts_of(diagram.findings))
    assert diagram.flags == ()
    assert pressure_at(diagram, np.radians(20.0)) == pytest.approx(bars[38] * 1e5, rel=1e-4)


def test_a_textbooks_table_in_steps_of_30_degrees():
    """10° about the peak; the table ends at 720°, which is 0°."""
    degrees = np.unique(np.concatenate([np.arange(0.0, 721, 30), [10, 20, 40, 50, 370, 380, 390, 700, 710]]))
    diagram = diagram_of(csv(degrees, wiebe_cycle(ENGINE, CASE, np.radians(degrees))))
    assert len(diagram.curve.places) == len(degrees) - 1
    assert diagram.flags == ()


def test_two_stroke():
    text = csv(DEGREES[:360], wiebe(ENGINE, CASE, np.radians(np.mod(DEGREES[:360] + 180, 360) - 180)))
    diagram = diagram_of(text, cycle=TWO_STROKE)
    assert pressure_at(diagram, np.radians(16.0)) == pytest.approx(
        float(wiebe(ENGINE, CASE, np.radians(np.array(16.0))))
    )


def test_an_offset_machine_takes_the_file_at_its_true_dead_centre():
    engine = Engine(0.045, 0.15, 0.08, 10.0, offset=0.012)
    top = np.arcsin(0.012 / 0.195)
    diagram = diagram_of(csv(DEGREES, PRESSURES), engine)
    assert pressure_at(diagram, top + np.radians(16.0)) == pytest.approx(PRESSURES[16], rel=1e-9)
    assert any(f"{np.degrees(top):.3f}°" in finding for finding in texts_of(diagram.findings))


def test_the_file_must_have_been_read():
    spec = validated(IndicatorSpec, {"kind": "indicator", "file": "trace.csv"})
    with pytest.raises(InputError, match="has not been read"):
        indicator_diagram(card_of(spec).card[0], ENGINE.chamber())


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"pressure_unit": "baar"}, "pressure_unit = baar: must be one of: kPa"),
        ({"axis_unit": "bar"}, "axis_unit = bar: must be one of: deg"),
        ({"peg": {}}, "peg: must have either pressure or exponent"),
        ({"peg": {"exponent": 1.3, "start": "20 deg"}}, "peg: start and end must lie within the compression"),
        ({"text": "x"}, f"file = trace.csv: {NO_NUMBERS}"),
        ({"columns": [1, 7], "text": "a,p [bar]\n0,1\n1,2"}, "columns: must be columns of the file, 1 to 2"),
    ],
)
def test_tables_that_are_refused(more, message):
    with pytest.raises(InputError) as refusal:
        validated(IndicatorSpec, {"kind": "indicator", "file": "trace.csv", **more})
    assert message in str(refusal.value)


@pytest.mark.parametrize("spread", [0.0, 0.3])
def test_spline_is_scipys(spread):
    places = np.arange(50) * (2 * np.pi / 50)
    places = places + spread * np.random.default_rng(2).uniform(0, 2 * np.pi / 50, 50)
    values = np.exp(np.sin(places)) + np.random.default_rng(3).standard_normal(50)
    theirs = CubicSpline(np.append(places, places[0] + 2 * np.pi), np.append(values, values[0]), bc_type="periodic")
    assert periodic_slopes(places, values, 2 * np.pi) == pytest.approx(theirs(places, 1), abs=1e-12)
    diagram = diagram_through(Samples(places, values, (), ()), 2 * np.pi, "spline")
    at = np.linspace(0, 2 * np.pi, 777)
    assert pressure_at(diagram, at + 2 * np.pi * 7) == pytest.approx(theirs(at, extrapolate="periodic"), abs=1e-12)


def test_work_of_the_interpolant_is_exact():
    """Against ∫ p sin φ = [−p cos + p′ sin + p″ cos − p‴ sin], piece by piece."""
    places = np.arange(24) * (2 * np.pi / 24)
    values = 3 + np.sin(places) + 0.2 * np.cos(3 * places)
    diagram = diagram_through(Samples(places, values, (), ()), 2 * np.pi, "spline")
    spline = CubicSpline(np.append(places, 2 * np.pi), np.append(values, values[0]), bc_type="periodic")
    total = 0.0
    for a, b in itertools.pairwise(spline.x):
        for x, sign in ((b, 1), (a, -1)):
            # The third derivative jumps at the points.
            p, q, r = (float(spline(x, order)) for order in (0, 1, 2))
            third = float(spline((a + b) / 2, 3))
            total += sign * (-p * np.cos(x) + q * np.sin(x) + r * np.cos(x) - third * np.sin(x))
    assert diagram_work(diagram, np.sin) == pytest.approx(total, rel=1e-13)


def test_smoothing_keeps_mean_and_parabola():
    """Of a wave of order k the factor (1 + k²σ²/2) exp(−k²σ²/2) is left; it departs from 1 by k⁴σ⁴/8 only."""
    places = np.arange(360) * np.radians(1.0)
    wave = diagram_through(Samples(places, 5 + np.cos(3 * places), (), ()), 2 * np.pi)
    found = smoothed(wave, np.radians(2.0))
    half = (3 * np.radians(2.0)) ** 2 / 2
    assert found.curve.starts == pytest.approx(5 + (1 + half) * np.exp(-half) * np.cos(3 * places), abs=1e-10)
    assert np.mean(found.curve.starts) == pytest.approx(5, rel=1e-14)


PIECES = ["1e30", "-1e30", "1e-320", "0", "nan", "", ";", ",", "\n", "x", " ", "360", "-5", "\ufeff", "1,5", "\0", "−3"]
CHOICES = [{}, {"sense": "found"}, {"pressure": "gauge"}, {"peg": {"exponent": 1.3}}, {"axis": "displacement"}]


@settings(max_examples=100, deadline=None)
@given(
    st.lists(st.tuples(st.floats(0, 1), st.integers(0, 40), st.sampled_from(PIECES)), max_size=5),
    st.sampled_from(CHOICES),
)
@example([(0.5625, 10, "0")], {"peg": {"exponent": 1.3}})
def test_a_spoilt_file_is_read_or_refused(spoilt, more):
    """Whatever stands in it: numbers that are finite, or what is wrong."""
    text = csv(DEGREES[::10], PRESSURES[::10])
    for place, length, piece in spoilt:
        start = round(place * len(text))
        text = text[:start] + piece + text[start + length :]
    try:
        diagram = diagram_of(text, **more)
    except InputError as refusal:
        assert refusal.problems
    else:
        assert np.all(np.isfinite(diagram.curve.starts))
        assert np.all(np.isfinite(diagram.curve.start_slopes))
        assert np.all(np.isfinite(diagram.curve.end_slopes))
        assert np.all(np.diff(diagram.curve.places) > 0)
