"""`new`: a file of a kind, or a copy of an example."""

import re

import pytest

from cranktrain.io.examples import example_text
from cranktrain.io.schema import machine_schema
from cranktrain.mechanisms import KINDS


def test_an_example_is_copied_as_it_is(typed, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert typed("new", "3D12", "-o", "mine.toml").status == 0
    assert (tmp_path / "mine.toml").read_text(encoding="utf-8") == example_text("3d12")
    assert typed("new", "r-1340").output == example_text("r_1340")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["new", "3d13"], "did you mean the example 3d12?"),
        (["new", "slidr_crank"], 'write "slider_crank"'),
        (["new", "3d12", "--full"], "--full: must be left out: example 3d12 is copied as it is"),
    ],
)
def test_what_is_neither_is_refused(typed, arguments, said):
    answer = typed(*arguments)
    assert (answer.status, answer.output) == (2, "")
    assert said in answer.errors


NOT_FOR = {
    "articulated_rod": {"rod_load", "pumping"},
    "chain": {"cylinder", "gas", "crankshaft", "rod_load", "pumping"},
    "crank_rocker": {"cylinder", "gas", "friction", "guide", "rod_load"},
    "eccentric": {"cylinder", "gas", "rod_load", "pumping"},
    "oscillating_cylinder": {"gas", "rod_load", "pumping"},
    "scotch_yoke": {"rod_load", "pumping"},
    "slider_crank": {"pumping"},
    "slotted_lever": {"cylinder", "gas", "rod_load", "pumping"},
    "stephenson": {"cylinder", "gas", "crankshaft", "torsion", "rod_load", "pumping"},
    "walschaerts": {"gas", "rod_load", "pumping"},
}
"""Tables that no machine of a kind has, or none that is usual."""
ASKED = {
    *("masses", "friction", "guide", "load", "cylinder", "gas", "balance", "evenness"),
    *("crankshaft", "torsion", "drive", "rod_load", "pumping"),
}


@pytest.mark.parametrize("kind", [kind.name for kind in KINDS])
def test_a_full_file_has_every_table_that_suits_its_kind(typed, kind):
    text = typed("new", kind, "--full").output
    heads = re.findall(r"^(?:# )?\[+(?:bank\.\w+\.)?(\w+)", text, flags=re.MULTILINE)
    assert ASKED - set(heads) == NOT_FOR[kind]


def test_every_table_of_the_schema_is_asked_of_some_kind_or_lays_a_machine_out():
    """Gears join shafts, of which a kind has one; units and gravity stand at the head."""
    laid_out = {"name", "rotation", "running", "crank_zero", "angle", "shaft", "mechanism", "bank"}
    assert set(machine_schema()["properties"]) == ASKED | laid_out | {"gravity", "units", "gear"}
