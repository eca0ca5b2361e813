"""Indicator files of many habits say the same; what is wrong is told at its line and column."""

import numpy as np
import pytest
from tests.sentences import BEYOND_ANY_SIZE, NO_NUMBERS, NO_UNIT, NOT_POSITIVE
from tests.told import texts_of

from cranktrain.errors import InputError
from cranktrain.fluids.indicator.flags import level_flags
from cranktrain.fluids.indicator.reading import Columns, read_trace

ANGLES = [0.0, 0.5, 1.0, 1.5]
BARS = [50.5, 51.0, 52.25, 53.0]
SAME = {
    "comma": "Crank angle,Pressure\ndeg,bar\n0,50.5\n0.5,51\n1.0,52.25\n1.5,53",
    "byte-order mark and CRLF": "\ufeffAngle (deg),p [bar]\r\n0,50.5\r\n.5,51.\r\n1,52.25\r\n1.5,5.3e1\r\n\r\n",
    "semicolon and decimal comma": "Угол, град;Давление, бар\n0;50,5\n0,5;51\n1;52,25\n1,5;53\n",
    "tab": "°CA\tp_cyl [MPa]\n0\t5.05\n0.5\t5.1\n1\t5.225\n1.5\t5.3",
    "tab and decimal comma": "CA\tp, кгс/см²\n"
    + "\n".join(f"{a}\t{b / 0.980665!r}".replace(".", ",") for a, b in zip(ANGLES, BARS, strict=True)),
    "blanks and comments": "# measured by night\n# CAD   p_kPa\n  0  5050\n  0.5 5100\n% pause\n 1 5225\n 1.5 5300",
    "quotes": '"crank_angle_deg","p_Pa"\n"0","5050000"\n"0.5","5100000"\n"1","5225000"\n"1.5","5300000"',
    "radians": "phi [rad];p [bar]\n"
    + "\n".join(f"{np.radians(a)!r};{b!r}" for a, b in zip(map(float, ANGLES), BARS, strict=True))
    .replace("np.float64(", "")
    .replace(")", ""),
    "a title that begins with a number": "2021 test bench\nangle, deg;p [bar]\n0;50.5\n0.5;51\n1;52.25\n1.5;53",
    "more columns": "T [K],volume [cm³],p_abs_bar,crank_angle_deg\n9,1,50.5,0\n9,1,51,0.5\n9,1,52.25,1\n9,1,53,1.5",
    "Unicode minus and a separator at the end": "angle [deg];p [bar];\n0;50.5;\n0.5;51;\n1;52.25;\n1.5;53;",
}


@pytest.mark.parametrize("habit", SAME)
def test_same_trace(habit):
    trace = read_trace(SAME[habit], "trace.csv")
    assert trace.axis == "angle"
    assert trace.places == pytest.approx(np.radians(ANGLES), rel=1e-15)
    assert trace.pressures == pytest.approx(np.array(BARS) * 1e5, rel=1e-12)


def test_without_a_header_the_machine_file_says_the_units():
    said = Columns(axis_unit="deg", pressure_unit="bar", is_gauge=False)
    trace = read_trace("0;50,5\n0,5;51", "trace.csv", said)
    assert trace.places == pytest.approx(np.radians([0, 0.5]))
    assert trace.pressures == pytest.approx([50.5e5, 51e5])
    assert trace.findings == ()
    assert trace.lines.tolist() == [1, 2]


@pytest.mark.parametrize(
    ("span", "unit"), [(720, "deg"), (12.56, "rad")], ids=["degrees reach farther than two turns in radians", "radians"]
)
def test_unit_of_angles_by_their_reach(span, unit):
    trace = read_trace(f"0,10\n{span},20", "trace.csv", Columns(pressure_unit="bar"))
    assert f"so {unit} is taken" in str(trace.findings[0])


@pytest.mark.parametrize(
    ("header", "said", "expected"),
    [
        ("angle;p_gauge_bar", Columns(), 2e5 + 101325),
        ("angle;p [barg]", Columns(), 2e5 + 101325),
        ("angle;Давление избыточное, бар", Columns(ambient=1e5), 3e5),
        ("angle;p [bar]", Columns(is_gauge=True, ambient=1e5), 3e5),
        ("angle;p_gauge_bar", Columns(is_gauge=False), 2e5),
        ("angle;p abs, bar", Columns(), 2e5),
        ("angle;p [ати]", Columns(), 2 * 98066.5 + 101325),
    ],
)
def test_gauge_pressures(header, said, expected):
    assert read_trace(f"{header}\n0;2\n1;2", "trace.csv", said).pressures[0] == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("header", "axis"),
    [("V [cm3];p [bar]", "volume"), ("S, mm;p, at", "displacement"), ("ход;p, ат", "displacement")],
)
def test_other_axes(header, axis):
    assert read_trace(f"{header}\n10;2\n20;20", "trace.csv").axis == axis


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", f"file = trace.csv: {NO_NUMBERS}"),
        ("nothing\nhere", f"file = trace.csv: {NO_NUMBERS}"),
        ("angle;p [bar]\n0;1\n1;x\n2;3", "trace.csv:3:3  x: must be a number"),
        ("angle;p [bar]\n0;1\n1;1e999\n2;3", f"trace.csv:3:3  1e999: {BEYOND_ANY_SIZE}"),
        ("angle;p [bar]\n0;1\n1; nan\n2;3", "trace.csv:3:4  nan: must be a number"),
        ("angle;p [bar]\n0;1\n1;\n2;3", "trace.csv:3  1 values: must have 2 values"),
        ("angle,p [bar]\n0,1.234.5\n1,2", "trace.csv:2:3  1.234.5: must be a number"),
        ("angle [deg]\n0\n1\n2", "trace.csv:2  has one column"),
        ("angle;p\n0;1\n1;2", f"pressure_unit: the file {NO_UNIT} pressure"),
        ("V;p [bar]\n10;1\n20;2", f"axis_unit: the file {NO_UNIT} volume"),
        ("0,5,1,02\n1,0,1,03", "trace.csv:1  0,5,1,02: commas may stand here for decimal points or between columns"),
        (
            "angle;p [bar]\n0;1\n1;-0.2\n2;-0.3",
            f"trace.csv:3:3  -0.2: an absolute pressure {NOT_POSITIVE} (2 values",
        ),
    ],
)
def test_refused(text, message):
    with pytest.raises(InputError) as refusal:
        read_trace(text, "trace.csv")
    assert message in str(refusal.value)


def test_all_is_told_at_once_but_not_a_thousand_times():
    with pytest.raises(InputError) as refusal:
        read_trace("angle;p [bar]\n0;1\n" + "1;x\n" * 1000, "trace.csv")
    assert len(refusal.value.problems) == 11
    assert str(refusal.value.problems[-1].allowed).startswith("990 more")


@pytest.mark.parametrize(
    ("lowest", "peak", "flag"),
    [
        (0.9, 120.0, None),
        (0.01, 120.0, "too low for an engine: gauge pressures"),
        (9.0, 900.0, "too high for an engine"),
        (0.6, 2.0, "The peak of 2 bar is too low"),
    ],
)
def test_levels_that_no_engine_has_are_doubted(lowest, peak, flag):
    flags = texts_of(level_flags(read_trace(f"angle;p abs [bar]\n0;{lowest}\n1;{peak}", "trace.csv").pressures))
    assert len(flags) == (flag is not None)
    assert flag is None or flag in flags[0]


def test_more_columns_than_needed_are_told():
    trace = read_trace("angle [deg];p1 [bar];p2 [bar]\n0;1;2\n1;1;2", "trace.csv")
    assert "The file has 3 columns; pressures are taken from column 2, p1 [bar]" in str(trace.findings[0])
    chosen = read_trace("angle [deg];p1 [bar];p2 [bar]\n0;1;2\n1;1;2", "trace.csv", Columns(columns=(1, 3)))
    assert not any("columns" in finding for finding in texts_of(chosen.findings))


def test_one_column_for_both_is_refused():
    with pytest.raises(InputError, match="columns: must be two columns, of the axis and of the pressure"):
        read_trace("angle [deg];p [bar]\n0;1\n1;1", "trace.csv", Columns(columns=(2, 2)))


def test_a_file_of_more_lines_than_any_cycle_is_refused_at_once():
    with pytest.raises(InputError) as refusal:
        read_trace("angle;p [bar]\n" + "0;1\n" * 100_000, "trace.csv")
    message = str(refusal.value)
    assert message.startswith("file = trace.csv: has 100001 lines; 40000 at most are read")
    assert message.endswith("keep one row of 3, or the mean of so many")


def test_a_file_with_one_wrong_number_among_thousands():
    """Its line and column are found although numbers are kept as arrays."""
    rows = [f"{place / 10};  12,5" for place in range(7200)]
    rows[6999] = "699,9; -2,5 "
    with pytest.raises(InputError) as refusal:
        read_trace("angle [deg];p abs [bar]\n" + "\n".join(rows), "trace.csv")
    assert str(refusal.value).startswith(f"trace.csv:7001:8  -2.5: an absolute pressure {NOT_POSITIVE} (1 values")


AT, STANDARD = 98066.5, 101325.0


@pytest.mark.parametrize(
    ("heads", "axis", "step", "first"),
    [
        ("φ, град;р, кгс/см2 изб.", "angle", np.radians(10), 1.5 * AT + STANDARD),
        ("φ,град.;р,кгс/см² (изб.)", "angle", np.radians(10), 1.5 * AT + STANDARD),
        ("угол, гр;р, кг/см2 абс.", "angle", np.radians(10), 1.5 * AT),
        ("град. п.к.в.;р, кГ/см^2", "angle", np.radians(10), 1.5 * AT),
        ("град.;ата", "angle", np.radians(10), 1.5 * AT),
        ("Grad KW;p, atü", "angle", np.radians(10), 1.5 * AT + STANDARD),
        ("Winkel [°KW];p [barg]", "angle", np.radians(10), 1.5e5 + STANDARD),
        ("Grad KW;Druck (bar)", "angle", np.radians(10), 1.5e5),
        ("Grad KW;Zylinderdruck in bar (Überdruck)", "angle", np.radians(10), 1.5e5 + STANDARD),
        ("°CA;bar g", "angle", np.radians(10), 1.5e5 + STANDARD),
        ("alpha (deg);P (psi g)", "angle", np.radians(10), 1.5 * 6894.757293168361 + STANDARD),
        ("crank angle / deg;pressure / bar(a)", "angle", np.radians(10), 1.5e5),
        ("θ [deg];p_cyl [bar abs]", "angle", np.radians(10), 1.5e5),
        ("V, см3;р, МПа", "volume", 1e-5, 1.5e6),
        ("х, мм;р изб., бар", "displacement", 0.01, 1.5e5 + STANDARD),
    ],
)
def test_heads_as_they_are_written(heads, axis, step, first):
    """1 at = 1 kgf/cm² = 98 066.5 Pa and 1 psi = 6894.757… Pa by definition; gauge counts from 101 325 Pa."""
    trace = read_trace(f"{heads}\n0;1,5\n10;2,5\n20;40,0\n", "card.csv")
    assert trace.axis == axis
    assert trace.places[1] == pytest.approx(step, rel=1e-12)
    assert trace.pressures[0] == pytest.approx(first, rel=1e-12)


@pytest.mark.parametrize(
    "text",
    [
        '"φ, град","р, кгс/см2 изб."\n0,1.5\n10,2.5\n',
        "φ, град   р, кгс/см2 изб.\n0  1,5\n10  2,5\n",
        "φ, град\tр, кгс/см2 изб.\n0\t1,5\n10\t2,5\n",
    ],
    ids=["quoted", "blanks", "tabs"],
)
def test_a_comma_or_a_blank_in_a_head_divides_no_columns(text):
    trace = read_trace(text, "card.csv")
    assert trace.pressures == pytest.approx(np.array([1.5, 2.5]) * AT + STANDARD, rel=1e-12)
