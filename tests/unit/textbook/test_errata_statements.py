"""What is wrong in the texts, as records: each once, in SI, with its reason."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.texts.contents import TEXTS

STEPS = {
    "steam-engine": 3,
    "gandzha": 14,
    "slider-crank-synthesis": 16,
    "bolotin": 5,
    "crankshaft-reactions": 10,
}
"""How many the digest of the sources names."""


def test_every_wrong_step_is_a_statement_with_its_reason():
    found = ct.textbook.errata()
    assert {one.source for one in found} == {text.name for text in TEXTS}
    assert len({one.name for one in found}) == len(found) == len(found.notes)
    for one in found:
        assert one.verdict == "printed"
        assert one.symbol
        assert all(found.notes[one.name])
        assert one.unit in {"1", "m", "rad", "s", "rad/s", "m/s", "N", "N*m", "J", "kg*m^2"}


@pytest.mark.parametrize(("name", "n"), STEPS.items())
def test_of_one_text(name, n):
    assert len(ct.textbook.errata(name)) >= n


def test_numbers_in_si_by_hand():
    rod, angle = ct.textbook.errata("synthesis").each[:2]
    assert (rod.value, rod.exact, rod.unit) == (pytest.approx(0.08 * 3**0.5), pytest.approx(0.16), "m")
    assert np.degrees(angle.value) == pytest.approx(35.2643897, abs=1e-6)
    projection = ct.textbook.errata("steam-engine").each[1]
    # L − √(L² − R²) of the stroke 2R, λ = 0.1
    assert projection.value == pytest.approx((10 - 99**0.5) / 2, rel=1e-9)
    assert (projection.unit, projection.at) == ("1", "largest error")
    stroke = ct.textbook.errata("bolotin").each[4]
    assert stroke.exact == pytest.approx(0.1867)
    assert next(one.name for one in ct.textbook.errata("gandzha").numbered("20")).startswith(
        "Flywheel moment at the motor"
    )


def test_an_unknown_text_is_refused():
    with pytest.raises(ct.InputError, match="must be the name of a text"):
        ct.textbook.errata("Z")
