import json
import re
import tomllib

import jsonschema
import pytest
from tests.smallest_files import without_marks

from cranktrain.mechanisms import KINDS


@pytest.mark.parametrize("kind", [kind.name for kind in KINDS])
def test_new_file_runs_as_it_is(typed, kind):
    assert typed("new", kind, "-o", "mine.toml") == (0, "", "")
    assert typed("check", "mine.toml").status == 0
    answer = typed("run", "mine.toml", "--step", "10")
    assert (answer.status, answer.errors) == (0, "")
    assert "[shaft.main] speed" not in answer.output


def test_new_file_is_on_stdout_unless_named(typed, tmp_path):
    answer = typed("new", "Slider-Crank")
    assert answer.output.startswith("#:schema ./cranktrain.schema.json\n")
    assert tomllib.loads(answer.output)["mechanism"]["kind"] == "slider_crank"
    assert list(tmp_path.iterdir()) == []


def test_optional_lines_of_a_new_file_work(typed, tmp_path):
    """What stands behind `# ` before a key may be uncommented."""
    text = typed("new", "articulated_rod").output
    text = text.replace("# offset", "offset").replace("# running", "running")
    text = text.replace("# cycle", "cycle").replace("# firing_order", "firing_order")
    (tmp_path / "mine.toml").write_text(text, encoding="utf-8")
    assert typed("check", "mine.toml").errors == ""


def test_unknown_kind(typed):
    answer = typed("new", "slider_crnk")
    assert answer.status == 2
    assert answer.errors.startswith("KIND = slider_crnk: must be one of: slider_crank")
    assert 'write "slider_crank"' in answer.errors


def test_new_keeps_what_is_there(typed, written):
    path = written("mine\n")
    answer = typed("new", "crank_rocker", "-o", path.name)
    assert answer.status == 2
    assert answer.errors.startswith("machine.toml  is there already")
    assert path.read_text(encoding="utf-8") == "mine\n"
    assert typed("new", "crank_rocker", "-o", path.name, "--force").status == 0
    assert "crank_rocker" in path.read_text(encoding="utf-8")


def test_schema(typed, tmp_path):
    shown = typed("schema")
    assert typed("schema", "-o", "cranktrain.schema.json").status == 0
    assert (tmp_path / "cranktrain.schema.json").read_text(encoding="utf-8") == shown.output
    schema = json.loads(shown.output)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    for kind in KINDS:
        validator.validate(tomllib.loads(typed("new", kind.name).output))


@pytest.mark.parametrize("kind", [kind.name for kind in KINDS])
def test_full_file_runs_as_it_is_and_without_its_comment_marks(typed, written, kind):
    text = typed("new", kind, "--full").output
    assert tomllib.loads(text) == tomllib.loads(typed("new", kind).output)
    bare = without_marks(text)
    assert not re.search(r"^# ?(\[|[\w.]+ = )", bare, flags=re.MULTILINE)
    path = written(bare)
    answer = typed("check", path.name)
    assert (answer.status, answer.errors) == (0, "")
    assert not re.search("^!", answer.output, flags=re.MULTILINE), "a table that nothing rests on"
    answer = typed("run", path.name, "--step", "10")
    assert (answer.status, answer.errors) == (0, "")
    assert "NOT" not in answer.output


BESIDE = {
    r"\[pumping\]": r"\[load\.well\]",
    r"\[drive\.(part\.\w+|clutch)\]": r"\[\[drive\.stage\]\]",
    r"\[drive\.start\]": r"\[gas\]",
    r"\[drive\.stroke\]": r"\[+drive\.(motor|stage|clutch|brake)\]",
}
"""What a table names or needs stands above it: the load of a pumping unit, a stage, a compressor's gas, all that makes
a stroke."""


@pytest.mark.parametrize("kind", [kind.name for kind in KINDS])
def test_every_table_of_a_full_file_works_alone(typed, written, kind):
    """But for a rim, whose flywheel the table above it wants, the two of torsion, which need each other, and what
    names or needs others."""
    text = typed("new", kind, "--full").output
    heads = re.findall(r"^# (\[+.*?\]+)", text, flags=re.MULTILINE)
    assert heads
    for head in heads:
        if head != "[evenness.rim]" and not head.startswith("[torsion"):
            wanted = "|".join([re.escape(head), *(others for one, others in BESIDE.items() if re.fullmatch(one, head))])
            one = re.sub(rf"^# (?:{wanted})(?:.*\n# .*)*", lambda found: without_marks(found[0]), text, flags=re.M)
            assert tomllib.loads(one) != tomllib.loads(text), head
            answer = typed("check", written(one).name)
            assert (answer.status, answer.errors) == (0, ""), head


@pytest.mark.parametrize(
    ("kind", "speed"),
    [("walschaerts", "280 rpm"), ("crank_rocker", "10 rpm"), ("chain", "40 rpm"), ("slotted_lever", "30 rpm")],
)
def test_numbers_suit_the_kind(typed, kind, speed):
    """A locomotive, a pumping unit, a press and a shaper: none compresses."""
    text = typed("new", kind, "--full").output
    assert tomllib.loads(text)["shaft"]["main"]["speed"] == speed
    assert "compression_ratio" not in text
    assert "[gas]" not in text
