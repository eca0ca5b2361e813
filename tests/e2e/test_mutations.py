"""Whatever happens to a machine file, the answer is a result or a list of what is wrong, never a crash."""

import contextlib
import io
import re
from importlib.resources import files

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from cranktrain.cli import main

FILES = {
    path.name: path.read_text(encoding="utf-8")
    for path in files("cranktrain.examples").iterdir()
    if path.name.endswith(".toml")
}
TEXTS = [
    '"0 mm"',
    '"-5 mm"',
    '"1e400 mm"',
    '"nan mm"',
    "nan",
    "inf",
    "-1",
    "0",
    "true",
    "[]",
    "{}",
    '""',
    '"1/0 in"',
    '"90"',
]
NUMBERS = ["0", "-1", "1e-9", "1e9", "99999", "1e308", "1e-320", "361", "7", "0.5"]
UNITS = ["mm", "m", "in", "deg", "rad", "rpm", "kg", "parsec", "", "°", "мм"]
WORDS = [
    "L",
    "R",
    "slider_crank",
    "articulated_rod",
    "crank_rocker",
    "clockwise",
    "four-stroke",
    "left",
    "self",
    "",
    "1L-1L",
]
BYTES = ["\0", "\ufeff", "=", '"', "[", "]", "{", "\\", "#", "\n", "\r", ".", "é", "\x1b", "'''"]


@st.composite
def broken(draw: st.DrawFn) -> str:
    """A machine file with one to three faults."""
    lines = [line for line in FILES[draw(st.sampled_from(sorted(FILES)))].splitlines() if not line.startswith("#")]
    for _fault in range(draw(st.integers(1, 3))):
        place = draw(st.integers(0, len(lines) - 1))
        line = lines[place]
        match draw(st.sampled_from(("delete", "double", "swap", "value", "number", "unit", "word", "insert"))):
            case "delete":
                lines[place] = ""
            case "double":
                lines.insert(place, line)
            case "swap":
                other = draw(st.integers(0, len(lines) - 1))
                lines[place], lines[other] = lines[other], line
            case "value":
                lines[place] = re.sub(r"= .*", lambda _m: f"= {draw(st.sampled_from(TEXTS))}", line)
            case "number":
                lines[place] = re.sub(r"\d[\d.]*", lambda _m: draw(st.sampled_from(NUMBERS)), line, count=1)
            case "unit":
                lines[place] = re.sub(r"(?<=\d )(mm|deg|in|rpm)\b", lambda _m: draw(st.sampled_from(UNITS)), line)
            case "word":
                lines[place] = re.sub(r'"[^"\d]*"', lambda _m: f'"{draw(st.sampled_from(WORDS))}"', line, count=1)
            case _:
                at = draw(st.integers(0, len(line)))
                lines[place] = line[:at] + draw(st.sampled_from(BYTES)) + line[at:]
    return "\n".join(lines)


@given(text=broken(), partial=st.booleans())
@settings(
    max_examples=120,
    deadline=None,
    derandomize=True,
    database=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)
def test_broken_files_are_answered(tmp_path, text, partial):
    path = tmp_path / "broken.toml"
    path.write_bytes(text.encode(errors="surrogatepass"))
    output, errors = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
        status = main(["run", str(path), "--step", "10", *(["--partial"] if partial else [])])
    said = errors.getvalue()
    assert status in (0, 2), said
    if status == 0:
        assert said == ""
        assert partial or not re.search(r"\bnan\b(?! mm\b)", output.getvalue())
    else:
        assert output.getvalue() == ""
        for line in said.splitlines():
            assert line.startswith(str(path)), line
