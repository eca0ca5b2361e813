"""The file of a curve is found beside the machine file, whatever it is encoded in."""

import codecs
import os

import pytest
from tests.sentences import LOOKED_FOR, NO_FILE, NOT_SENT

from cranktrain.fluids.indicator.reading import read_trace
from cranktrain.io.curve_files import LARGEST_FILE, among, beside, curve_text, with_curves

TEXT = "Угол, °;Давление, бар\r\n0;50,5\r\n1;51"
ENCODED = {
    "UTF-8": TEXT.encode(),
    "UTF-8 with a mark": codecs.BOM_UTF8 + TEXT.encode(),
    "UTF-16": codecs.BOM_UTF16_LE + TEXT.encode("utf-16-le"),
    "UTF-16, big end first": codecs.BOM_UTF16_BE + TEXT.encode("utf-16-be"),
    "Windows-1251": TEXT.encode("cp1251"),
}
WHERE = "…"
GAS = {"kind": "indicator", "file": "traces/a.csv"}


def written(folder, content, name="traces/a.csv"):
    path = folder / name
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(content)
    return path


@pytest.mark.parametrize("encoding", ENCODED)
def test_encodings(encoding, tmp_path):
    text = curve_text(written(tmp_path, ENCODED[encoding]), "a.csv", "a curve")
    assert text == TEXT
    assert read_trace(text, "a.csv").pressures.tolist() == [5050000.0, 5100000.0]


def test_degree_sign_of_western_code_pages(tmp_path):
    text = curve_text(written(tmp_path, "angle [°];p [bar]\n0;1\n1;2".encode("cp1252")), "a.csv", "a curve")
    assert "[°]" in text


def test_file_is_relative_to_the_machine_file(tmp_path):
    written(tmp_path, TEXT.encode())
    data = {"name": "x", "gas": GAS, "load": {"saw": {"on": "main", "file": "traces/a.csv"}}}
    filled = {"saw": {"on": "main", "file": "traces/a.csv", "text": TEXT}}
    assert with_curves(data, beside(tmp_path)) == ({"name": "x", "gas": GAS | {"text": TEXT}, "load": filled}, ())


def test_files_of_loads_of_banks_and_pistons(tmp_path):
    written(tmp_path, TEXT.encode())
    load = {"load": {"x": {"file": "traces/a.csv"}, "y": {"force": "1 N"}}}
    filled = {"load": {"x": {"file": "traces/a.csv", "text": TEXT}, "y": {"force": "1 N"}}}
    data = {"bank": {"A": {**load, "exhaust": load}, "B": {"angle": 3, "load": {"on": "rod"}}}}
    expected = {"bank": {"A": {**filled, "exhaust": filled}, "B": data["bank"]["B"]}}
    assert with_curves(data, beside(tmp_path)) == (expected, ())


@pytest.mark.parametrize(
    "data",
    [
        {},
        {"gas": 1},
        {"gas": {"kind": "dual"}},
        {"gas": GAS | {"text": "0;1"}},
        {"gas": GAS | {"file": 3}},
        {"evenness": {}},
        {"load": "constant"},
        {"load": {"x": "constant"}},
        {"load": {"x": {"file": "none.csv", "text": "0;1"}}},
    ],
)
def test_nothing_else_is_read(data, tmp_path):
    assert with_curves(data, beside(tmp_path)) == (data, ())


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (None, f"gas.file = traces/a.csv: {NO_FILE}; is it b.csv? {WHERE}"),
        (b"\x89PNG\r\n\x1a\n\0\0", "gas.file = traces/a.csv: is no text: it has NUL bytes; save it as CSV"),
        (
            b"1" * (LARGEST_FILE + 1),
            "gas.file = traces/a.csv: is larger than 16 MiB, too large for an indicator diagram",
        ),
    ],
)
def test_refused(content, message, tmp_path):
    written(tmp_path, b"", "traces/b.csv")
    if content is not None:
        written(tmp_path, content)
    data, problems = with_curves({"gas": GAS}, beside(tmp_path))
    assert data == {"gas": GAS}
    assert [str(problem) for problem in problems] == [message.replace(WHERE, f"It {LOOKED_FOR} {tmp_path / 'traces'}")]


@pytest.mark.parametrize(
    ("missing", "others", "guess"),
    [
        ("pumping.csv", ("pumping.toml",), None),
        ("pumping.csv", ("pumping.toml", "pumpnig.CSV"), "pumpnig.CSV"),
        ("pumping.txt", ("pumping.toml", "pumping1.csv", "pumping.md"), "pumping1.csv"),
        ("pumping", ("pumping.toml", "pumping.csv"), "pumping.csv"),
    ],
)
def test_a_file_that_is_missing_is_taken_for_no_file_of_another_kind(missing, others, guess, tmp_path):
    for name in others:
        written(tmp_path, b"", name)
    _data, (problem,) = with_curves({"gas": GAS | {"file": missing}}, beside(tmp_path))
    looked = f"t {LOOKED_FOR} {tmp_path}"
    assert problem.repair == (f"i{looked}" if guess is None else f"is it {guess}? I{looked}")


def test_a_folder_is_no_diagram(tmp_path):
    written(tmp_path, b"")
    _data, (problem,) = with_curves({"gas": GAS | {"file": "traces"}}, beside(tmp_path))
    assert "is a folder, not an indicator diagram; name a file in it" in str(problem)


def test_all_files_that_are_missing_are_told(tmp_path):
    data = {"gas": GAS, "load": {"x": {"file": "b.csv"}}}
    assert [problem.path for problem in with_curves(data, beside(tmp_path))[1]] == ["gas.file", "load.x.file"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with names on this system")
@pytest.mark.parametrize(
    ("data", "noun"),
    [
        ({"gas": {"kind": "indicator", "file": "pipe"}}, "an indicator diagram"),
        ({"load": {"x": {"file": "pipe"}}}, "the file of a load"),
    ],
)
def test_a_pipe_into_which_nobody_writes_is_refused_at_once(data, noun, tmp_path):
    os.mkfifo(tmp_path / "pipe")
    _filled, (problem,) = with_curves(data, beside(tmp_path))
    assert problem.given == "pipe"
    assert problem.allowed == f"is a pipe or a device, not {noun}"


def test_what_was_sent_is_found_by_its_name_and_the_disk_not_looked_at(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    path = written(tmp_path, TEXT.encode())
    sent = {"traces/a.csv": f"\ufeff{TEXT} sent"}
    assert with_curves({"gas": GAS}, among(sent)) == ({"gas": GAS | {"text": f"{TEXT} sent"}}, ())
    for name in (str(path), "./traces/a.csv", "traces/../traces/a.csv", "traces\\a.csv", "TRACES/A.CSV", ""):
        data, (problem,) = with_curves({"gas": GAS | {"file": name}}, among(sent))
        assert data == {"gas": GAS | {"file": name}}
        assert problem.path == "gas.file"
        assert problem.given == name
        assert problem.allowed == NOT_SENT
        assert problem.repair == "send an indicator diagram"
    assert "NUL" in str(with_curves({"gas": GAS}, among({"traces/a.csv": "0;1\0"}))[1][0])
