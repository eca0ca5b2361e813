"""Traces as instruments write them: a level that is not known, noise, gaps, times; whatever their files' habits."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from tests.gas_engines import FOUR_STROKE, Engine, csv, wiebe_cycle
from tests.sentences import NOT_POSITIVE
from tests.told import problems_told, texts_of

from cranktrain.errors import InputError
from cranktrain.fluids.indicator import IndicatorSpec, card_of, diagram_work, indicator_diagram, pressure_at
from cranktrain.fluids.indicator.curve import crest
from cranktrain.fluids.indicator.gaps import bridging_errors
from cranktrain.fluids.indicator.noise import noise_of
from cranktrain.fluids.indicator.pegging import offset_scatter
from cranktrain.quantities.heads import is_time
from cranktrain.spec import validated

FILES = Path(__file__).parents[2] / "golden" / "raw_traces"
BAR = 1e5
ENGINE = Engine(0.0675, 0.22, 0.115, 16.5)
"""Of the six in line whose raw trace is among the files."""
WIEBE = {
    "gamma": 1.36,
    "m": 1.6,
    "a": np.log(1000),
    "start_deg": -6,
    "duration_deg": 55,
    "p_bdc": 1.4e5,
    "Q": 2200.0,
}
DEGREES = np.arange(0.0, 720.0, 0.5)
TRUE = wiebe_cycle(ENGINE, WIEBE, np.radians(DEGREES), inlet=1.4e5)


def diagram_of(text, engine=ENGINE, **more):
    spec = validated(IndicatorSpec, {"kind": "indicator", "file": "trace.csv", "text": text, **more})
    return indicator_diagram(card_of(spec).card[0], engine.chamber())


def at(diagram, degrees):
    return float(pressure_at(diagram, np.radians(degrees))) / BAR


def mean_pressure(diagram, engine=ENGINE):
    return diagram_work(diagram, engine.slope) / engine.swept / BAR


RAW = (FILES / "raw.csv").read_text(encoding="utf-8")
BY_PRESSURE = {"pressure": "1.45 bar", "angle": "-180 deg"}
BY_EXPONENT = {"exponent": 1.36, "start": "-100 deg", "end": "-40 deg"}


def test_a_raw_trace_asks_for_its_level_first():
    with pytest.raises(InputError) as refusal:
        diagram_of(RAW)
    assert [str(problem.position) for problem in refusal.value.problems] == ["trace.csv:5:8"]
    (problem,) = problems_told(refusal.value.problems)
    assert problem.allowed == f"an absolute pressure {NOT_POSITIVE} (342 values are not)"
    assert problem.repair.startswith('as a sensor does not know its level, write peg.pressure = "1 bar"')
    with pytest.raises(InputError, match=r"write peg\.pressure"):
        diagram_of(RAW, smoothing="3 deg")


@pytest.mark.parametrize("peg", [BY_PRESSURE, BY_EXPONENT], ids=["pressure", "exponent"])
def test_noise_below_zero_asks_for_smoothing_once_the_level_is_known(peg):
    with pytest.raises(InputError, match=r"absolute pressures that are not more than 0, the lowest -.*write smoothing"):
        diagram_of(RAW, peg=peg)
    with pytest.raises(InputError, match=r"smooth over more than 0\.5 deg"):
        diagram_of(RAW, peg=peg, smoothing="0.5 deg")


def test_a_raw_trace_pegged_by_a_pressure_and_smoothed():
    """σ 1 bar, 1.4 bar too low; without noise the crest is 109.7 bar, and 2.98 bar stand at −90°."""
    diagram = diagram_of(RAW, peg=BY_PRESSURE, smoothing="3 deg")
    assert at(diagram, -90) == pytest.approx(2.98, abs=0.1)
    assert crest(diagram.curve)[1] / BAR == pytest.approx(109.7, abs=1.5)
    (told,) = (finding for finding in texts_of(diagram.findings) if "are moved by" in finding)
    assert told == "All pressures are moved by +149 kPa, to the pressure that is known at -180°; noise leaves ±30 kPa."


def test_a_raw_trace_pegged_by_its_compression_and_smoothed():
    """Between −100° and −40° noise leaves 0.2 bar of the level, and at one angle 0.28 bar of σ 1 bar: 0.35 together.

    No other estimate from these rows has less: the polytrope itself, by least squares, is at 2.89 bar there.
    """
    diagram = diagram_of(RAW, peg=BY_EXPONENT, smoothing="3 deg")
    assert at(diagram, -90) == pytest.approx(2.98, abs=2 * 0.35)
    assert crest(diagram.curve)[1] / BAR == pytest.approx(109.7, abs=1.5)
    (told,) = (finding for finding in texts_of(diagram.findings) if "are moved by" in finding)
    assert told.startswith("All pressures are moved by +119.4 kPa, to the level that is known; noise leaves ±")
    assert float(told.split("±")[1].split(" ")[0]) == pytest.approx(20, rel=0.15)


def test_the_mean_pressure_of_a_raw_trace_is_that_of_its_rows():
    """Neither level nor smoothing moves it: Σ p ΔV over the rows, 2 % below 9.36 bar by the noise that is in them.

    Noise of σ 1 bar in steps of 0.5° leaves σ √(Σ V′²) Δφ/V_h = 0.12 bar of the mean pressure.
    """
    rows = np.array([line.split(";") for line in RAW.splitlines()[4:]], dtype=float)
    volume = ENGINE.volume(np.radians(rows[:, 0])).value
    before, after = rows[:, 1], np.roll(rows[:, 1], -1)
    by_rows = float(np.sum((before + after) / 2 * (np.roll(volume, -1) - volume))) / ENGINE.swept
    assert by_rows == pytest.approx(9.36, abs=2 * 0.12)
    for peg in (BY_PRESSURE, BY_EXPONENT):
        assert mean_pressure(diagram_of(RAW, peg=peg, smoothing="3 deg")) == pytest.approx(by_rows, rel=1e-3)


@pytest.mark.parametrize("sort", ["pressure", "exponent"])
def test_noise_is_neither_loved_nor_hated(sort):
    """Forty raw traces: level and crest are right on the average, and scatter as the noise that is told."""
    peg = {"pressure": "1.4 bar", "angle": "-180 deg"} if sort == "pressure" else BY_EXPONENT
    noise = 0.5 * BAR
    levels, crests, works = [], [], []
    for seed in range(40):
        raw = TRUE - 3 * BAR + noise * np.random.default_rng(seed).standard_normal(TRUE.size)
        diagram = diagram_of(csv(DEGREES, raw), peg=peg, smoothing="2.5 deg")
        levels.append(np.mean(diagram.curve.starts) - np.mean(TRUE))
        crests.append(crest(diagram.curve)[1] - np.max(TRUE))
        works.append(mean_pressure(diagram))
    volumes = ENGINE.volume(np.radians(np.arange(-100, -39.9, 0.5))).value
    # √(0.476 h/σ) of white noise is left by smoothing.
    scatter = noise * (np.sqrt(0.476 * 0.5 / 2.5) if sort == "pressure" else offset_scatter(volumes, 1.36))
    assert np.std(levels) == pytest.approx(scatter, rel=0.35)  # forty of them: ±11 %, three times that
    assert abs(np.mean(levels)) < 3 * scatter / np.sqrt(40)
    assert abs(np.mean(crests)) < 0.01 * np.max(TRUE)
    of_rows = mean_pressure(diagram_of(csv(DEGREES, TRUE)))
    assert np.mean(works) == pytest.approx(of_rows, abs=3 * 0.06 / np.sqrt(40))


def test_noise_is_measured():
    noise = 0.7 * BAR * np.random.default_rng(3).standard_normal(TRUE.size)
    samples = type("Rows", (), {"angles": np.radians(DEGREES), "pressures": TRUE + noise})
    assert noise_of(samples) == pytest.approx(0.7 * BAR, rel=0.1)


def test_smoothing_that_eats_the_crest_is_told():
    """Of a Gaussian crest of width w there is w/√(w² + σ²) · (1 + ½σ²/(w² + σ²)) left, in closed form."""
    width, height = 10.0, 60.0
    from_crest = np.mod(DEGREES - 12.0 + 360, 720) - 360
    text = csv(DEGREES, BAR * (2 + height * np.exp(-((from_crest / width) ** 2) / 2)))
    assert not any("off the crest" in flag for flag in texts_of(diagram_of(text, smoothing="4 deg").flags))
    wide = diagram_of(text, smoothing="5 deg")
    both = width**2 + 5.0**2
    eaten = height * (1 - width / np.sqrt(both) * (1 + 5.0**2 / both / 2))
    assert crest(wide.curve)[1] / BAR == pytest.approx(2 + height - eaten, abs=1e-3)
    (told,) = (flag for flag in texts_of(wide.flags) if "off the crest" in flag)
    assert float(told.split("takes some ")[1].split(" bar")[0]) == pytest.approx(eaten, rel=0.2)


def test_smoothing_of_uneven_rows_keeps_the_crest():
    """Rows each 1° about the crest and each 10° elsewhere: in as many even steps the crest would be gone."""
    rows = np.unique(np.concatenate([np.arange(0, 720, 10), np.arange(0, 60), np.arange(670, 720)])) * 2
    text = csv(DEGREES[rows], TRUE[rows])
    smooth = diagram_of(text, smoothing="1 deg")
    assert crest(smooth.curve)[1] == pytest.approx(np.max(TRUE), rel=0.005)


UNITS = {"bar": 1e5, "MPa": 1e6, "kPa": 1e3, "Pa": 1.0, "psi": 6894.757293168361, "кгс/см²": 98066.5}
HEADS = [
    "CA;PCYL1\n°CA;{unit}",
    "Indicating system export\nDate;2024-05-11\nCA;PCYL1\n°CA;{unit}",
    "Crank angle [deg];Pressure [{unit}]",
    "угол, град;давление, {unit}",
    "KW [°];Druck ({unit})",
]


@settings(max_examples=40, deadline=None)
@given(
    start=st.sampled_from([-360.0, 0.0, -180.0, 180.0, -540.0]),
    unit=st.sampled_from(sorted(UNITS)),
    head=st.sampled_from(HEADS),
    has_commas=st.booleans(),
    is_reversed=st.booleans(),
    level=st.floats(-20.0, 20.0),
    by=st.sampled_from(["pressure", "exponent"]),
)
@example(-360.0, "bar", HEADS[1], True, True, -20.0, "pressure")
def test_habits_of_files_change_nothing(start, unit, head, has_commas, is_reversed, level, by):
    """Whatever the count, the unit, the signs, the order of rows and the level that the sensor made up."""
    # Firing stands at a multiple of a full turn of the file.
    count = np.mod(DEGREES - start, 720) + start
    order = np.argsort(count)[:: -1 if is_reversed else 1]
    numbers = (TRUE[order] + level * BAR) / UNITS[unit]
    rows = [f"{angle:.1f};{number:.9g}" for angle, number in zip(count[order], numbers, strict=True)]
    body = "\n".join(rows)
    text = f"{head.format(unit=unit)}\n{body.replace('.', ',') if has_commas else body}\n"
    peg = {"exponent": 1.36, "start": "-120 deg", "end": "-20 deg"}
    if by == "pressure":
        peg = {"pressure": f"{TRUE[360] / BAR!r} bar".replace("np.float64(", "").replace(")", ""), "angle": "180 deg"}
    diagram = diagram_of(text, peg=peg, pressure="absolute")
    assert diagram.flags == ()
    found = pressure_at(diagram, np.radians(DEGREES))
    assert found == pytest.approx(TRUE, abs=2e-4 * BAR)
    (told,) = (finding for finding in texts_of(diagram.findings) if "are moved by" in finding)
    assert float(told.split("moved by ")[1].split(" kPa")[0]) == pytest.approx(
        -100 * level, abs=0.05 + 1e-3 * abs(100 * level)
    )


def without(first, last, pressures=TRUE):
    """Rows of the cycle but for those between two angles."""
    kept = np.abs(DEGREES - (first + last) / 2) >= (last - first) / 2
    return csv(DEGREES[kept], pressures[kept])


def test_a_digitised_trace_with_a_flat_gap_is_read_and_doubted():
    """72 rows in MPa, dense about the crest, none for 33.5° in the exhaust where nothing happens."""
    text = (FILES / "digitised.csv").read_text(encoding="utf-8")
    diagram = diagram_of(text, Engine(0.0685, 0.207, 0.105, 17.0), pressure_unit="MPa")
    assert any("between 635.9756° and 669.5122°: the curve bridges them" in flag for flag in texts_of(diagram.flags))
    assert at(diagram, np.array(650.0 - 360.0)) == pytest.approx(2.7, abs=0.01)


@pytest.mark.parametrize(
    ("first", "last"), [(400, 440), (480, 530), (550, 590), (600, 620)], ids=lambda angle: f"{angle}"
)
def test_a_wide_gap_that_costs_little_is_read_and_doubted(first, last):
    """In gas exchange and the beginning of the compression."""
    diagram = diagram_of(without(first, last))
    assert any(f"between {first}° and {last}°: the curve bridges them" in flag for flag in texts_of(diagram.flags))
    assert mean_pressure(diagram) == pytest.approx(mean_pressure(diagram_of(csv(DEGREES, TRUE))), rel=0.01)


@pytest.mark.parametrize(("first", "last"), [(2, 17), (0, 30), (690, 719), (20, 60), (400, 461)])
def test_a_gap_that_may_cost_much_is_refused_with_what_it_may_cost(first, last):
    """Over the crest, the fire, the end of compression; and so wide that nothing is known, however flat."""
    with pytest.raises(InputError, match=rf"between {first}° and {last}°, a gap of .* may be .* bar off"):
        diagram_of(without(first, last))


@settings(max_examples=60, deadline=None)
@given(start=st.integers(0, 1439), n_missing=st.integers(4, 118))
def test_no_gap_that_is_read_costs_more_than_is_said(start, n_missing):
    """Anywhere, against the closed form: 3 % of the mean pressure, and a step of the exhaust that falls within."""
    rows = np.mod(start + np.arange(1, n_missing + 1), DEGREES.size)
    text = csv(np.delete(DEGREES, rows), np.delete(TRUE, rows))
    try:
        diagram = diagram_of(text)
    except InputError as refusal:
        assert "a gap of" in str(refusal)
    else:
        whole = mean_pressure(diagram_of(csv(DEGREES, TRUE)))
        assert mean_pressure(diagram) == pytest.approx(whole, rel=0.03)
        assert any("the curve bridges" in flag for flag in texts_of(diagram.flags))


def test_what_bridging_may_cost_is_a_parabolas_height():
    """Of p = 50 − x² a gap from −a to a: its crest is a² above the chord; slopes are taken at a ± a/2 beside it."""
    places = np.linspace(-1.0, 1.0, 2001)
    kept = np.abs(places) >= 0.1
    angles, pressures = places[kept], 50 - places[kept] ** 2
    (found,) = bridging_errors(angles, pressures, np.array([np.flatnonzero(angles < 0)[-1]]), FOUR_STROKE)
    # The slope over the half width beside the gap is that in its middle: 2 · 1.5 a.
    assert found == pytest.approx(1.5 * 0.1**2, rel=0.01)
    flat = np.where(angles < 0, 3.0, 7.0)
    (step,) = bridging_errors(angles, flat, np.array([np.flatnonzero(angles < 0)[-1]]), FOUR_STROKE)
    assert step == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("head", "is_one"),
    [
        ("time [s]", True),
        ("Time (ms)", True),
        ("Zeit, ms", True),
        ("время, с", True),
        ("t [s]", True),
        ("t_ms", True),
        ("CA [deg]", False),
        ("s [mm]", False),
        ("s", False),
        ("S, мм", False),
        ("T [K]", False),
        ("p [bar]", False),
        ("ход", False),
    ],
)
def test_heads_that_mean_a_time(head, is_one):
    assert is_time(head) == is_one


@pytest.mark.parametrize("head", ["time [s];p [bar]", "Zeit, ms;Druck, bar", "t_s;p_bar"])
def test_a_trace_over_time_is_refused_as_such(head):
    with pytest.raises(InputError, match=r"has a time in column 1.*write crank angles instead"):
        diagram_of("\n".join([head, *(f"{row * 1e-4};{pressure / BAR}" for row, pressure in enumerate(TRUE))]))


def test_an_angle_beside_a_time_is_taken():
    rows = (
        f"{row * 1e-4};{angle};{pressure / BAR}"
        for row, (angle, pressure) in enumerate(zip(DEGREES, TRUE, strict=True))
    )
    diagram = diagram_of("\n".join(["time [s];CA [deg];p abs [bar]", *rows]))
    assert crest(diagram.curve)[1] == pytest.approx(np.max(TRUE), rel=1e-4)
