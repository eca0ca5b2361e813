"""The rule for leads: 10–15° in engines that turn one way, 5–10° in those that reverse."""

import numpy as np
import pytest
from tests.machines import slider
from tests.told import texts_of

import cranktrain as ct
from cranktrain.texts.leads import is_unsuited, lead_flags, reasons, verdict


@pytest.mark.parametrize(
    ("degrees", "one_way", "reversing"),
    [(12, "suits", "too much"), (10, "suits", "suits"), (7, "too little", "suits"), (20, "too much", "too much"),
     (4, "too little", "too little"), (15, "suits", "too much"), (5, "too little", "suits")],
)  # fmt: skip
def test_verdict(degrees, one_way, reversing):
    first, second = str(verdict(np.radians(degrees))).split("), ")
    assert first.startswith(one_way)
    assert "one way (10–15°" in first
    assert second.startswith(reversing)
    assert second.endswith("reverse (5–10°)")
    assert is_unsuited(np.radians(degrees)) == (degrees in (4, 20))


def test_an_engine_that_runs_astern_reverses():
    said = str(verdict(np.radians(-12.0)))
    assert said.startswith("behind, as only astern: too much for engines that reverse")
    assert "one way" not in said
    assert is_unsuited(np.radians(-12.0))
    assert not is_unsuited(np.radians(-7.0))


def test_flags_name_cylinders_and_reason():
    leads = np.radians([[12.0, 20.0, 20.0, np.nan]])
    (flag,) = texts_of(lead_flags(("1", "2", "3", "4"), leads))
    assert flag.startswith("the lead of 2, 3, 20.00 deg, is outside its source's range: too much for engines that turn")
    assert flag.endswith("[bolotin]")


def opposed(lead, **changes):
    pistons = {"exhaust": {"mechanism": slider()}, "scavenge": {"mechanism": slider(), "shaft": "upper"}}
    return ct.Machine(shaft={"upper": {}}, bank={"A": {**pistons, "lead": lead}}, **changes)


@pytest.mark.parametrize(
    ("machine", "n_flags"), [(opposed("12 deg"), 0), (opposed("25 deg"), 1), (opposed("12 deg", running="astern"), 1)]
)
def test_run_flags_a_lead_that_suits_no_engine(machine, n_flags):
    assert sum("lead" in flag and "[bolotin]" in flag for flag in texts_of(ct.run(machine).flags)) == n_flags


def test_reason_is_the_one_that_holds():
    """An offset mechanism of λ = 0.2 is outside for its offset; one of λ = 0.4 for its λ; one with both for both."""
    said = {}
    for name, changes in {"offset": {"offset": "4 mm", "rod_length": "250 mm"}, "long": {"rod_length": "125 mm"},
                          "both": {"offset": "4 mm", "rod_length": "125 mm"}}.items():  # fmt: skip
        flags = texts_of(ct.run(ct.Machine(mechanism=slider(**changes))).flags)
        (said[name],) = (flag for flag in flags if flag.startswith("two harmonics"))
    assert "for 1, as the line of stroke is offset by 4.00 mm [" in said["offset"]
    assert "for 1, as λ = 0.4 [" in said["long"]
    assert "for 1, as λ = 0.4 and the line of stroke is offset by 4.00 mm [" in said["both"]


def said_of(*degrees):
    return " ".join(texts_of(reasons(*np.radians(np.array(degrees, dtype=float)).tolist())))


@pytest.mark.parametrize(("lead", "sense"), [(12.0, 1), (5.0, 1), (5.81, 1), (-12.0, -1), (-5.0, -1)])
def test_reason_is_what_the_ports_do(lead, sense):
    """Heights give s = 5.81°: s + Δ as it turns, s − Δ the other way; blown back exactly where that is negative."""
    head = 5.81
    said = said_of(lead, head + lead, lead - head)
    as_it_turns, other_way = head + lead, head - lead
    assert ("scavenge ports: gas blows back" in said) == (as_it_turns < 0)
    assert ("them: gas blows back" in said) == (other_way < 0)
    assert f"{abs(other_way):.2f} deg {'before' if other_way >= 0 else 'after'} them" in said
    assert "give the exhaust ports 5.81 deg: a lead of more than that blows back astern" in said
    assert f"the lead is {-lead:.2f} deg" in said
    assert sense * lead > 0


def test_ports_of_one_height_blow_back_with_any_lead():
    said = said_of(8.0, 8.0, 8.0)
    assert "8.00 deg after them: gas blows back" in said
    assert "do not open the exhaust ports sooner: any lead blows back astern" in said


def test_no_lead_has_no_other_way():
    """Of Δ = 0 nothing changes with the sense of rotation."""
    said = said_of(0.0, np.nan, np.nan)
    assert "With the same metal" not in said
    assert "the pressure has fallen" in said
    assert "the lead is -8.00 deg: it opens them by as much later" in said_of(8.0, np.nan, np.nan)
