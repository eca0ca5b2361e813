"""Counterbalance proposed for a pumping unit: that the file does what was promised, and what is refused."""

import pytest

import cranktrain as ct
from cranktrain.cli.synthesis.proposals import give_proposal
from cranktrain.synthesis.counterbalance import counterbalance

UNIT = "pumping_unit_c57"


@pytest.mark.parametrize("start", ["3000 lbf", "9 kN", "0 N"])
@pytest.mark.parametrize("aim", ["equal_peaks", "least_rms"])
def test_the_file_does_what_was_promised(aim, start):
    unit = ct.load(UNIT, set={"load.counterbalance.force": start})
    proposal = counterbalance(unit, aim)
    changed = ct.load(UNIT, set={path: ct_text(value) for path, value in proposal.values.items()})
    result = ct.run(changed)
    for name, found in (
        ("upstroke_peak", "upstroke_peak"),
        ("rms", "rms_gearbox_torque"),
        ("mean", "mean_gearbox_torque"),
    ):
        assert proposal.value(name) == pytest.approx(float(getattr(result, found)), rel=1e-12)
    if aim == "equal_peaks":
        assert proposal.value("upstroke_peak") == pytest.approx(proposal.value("downstroke_peak"), rel=1e-12)
    else:
        assert proposal.value("rms") == pytest.approx(float(result.least_rms_torque), rel=1e-12)
    before = {one.name: one.value for one in proposal.alternatives[0].numbers}
    assert before["force"] == pytest.approx(unit.load["counterbalance"].force[0].si, rel=1e-12)


def ct_text(value):
    """The quantity of a table in one line of TOML."""
    return str(value).partition('value = "')[2].partition('"')[0]


def test_terminal_writes_the_force_alone(tmp_path):
    given = ct.load(UNIT).declared
    path = tmp_path / "unit.toml"
    give_proposal("counterbalance", {"aim": "least-rms"}, str(path), force=False, source=UNIT)
    written = ct.load(str(path)).declared
    assert written["load"]["counterbalance"]["force"]["value"].startswith("4944.0526")
    assert {**written["load"], "counterbalance": 0} == {**given["load"], "counterbalance": 0}
    assert written["pumping"] == given["pumping"]


@pytest.mark.parametrize(
    ("machine", "path"),
    [
        (lambda: ct.load("vaz_21213"), "pumping"),
        (lambda: ct.load(UNIT, set={"pumping": {"card": "invented_card"}}), "pumping.counterbalance"),
    ],
)
def test_refused(machine, path):
    with pytest.raises(ct.InputError) as caught:
        counterbalance(machine())
    assert [problem.path for problem in caught.value.problems] == [path]
