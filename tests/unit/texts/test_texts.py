"""What the texts hold: every number of theirs is there, and what is said of a formula follows from its closed form."""

import re

import mpmath as mp
import numpy as np
import pytest
from tests.told import problems_told

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.references import REFERENCES
from cranktrain.texts.contents import TEXTS, text_called, with_equation

NUMBERED = {
    "steam-engine": [*(f"({n})" for n in range(333, 338)), "fig. 146", "fig. 147"],
    "gandzha": [*(f"({n})" for n in range(1, 22)), "fig. 1", "fig. 2"],
    "slider-crank-synthesis": [],
    "bolotin": ["(I.11)", "(I.12)", "(I.13)", "fig. 1.3", "fig. 1.4"],
    "crankshaft-reactions": [*(f"({n})" for n in range(44, 54)), "fig. 35"],
}
"""Formulas and figures that the texts number themselves."""
WRONG = {"slider-crank-synthesis": 5, "gandzha": 6, "bolotin": 2, "steam-engine": 0, "crankshaft-reactions": 0}


def formulas(name):
    return {one.number: one for one in text_called(name).formulas}


def test_every_text_is_a_source():
    assert {text.name for text in TEXTS} == set(NUMBERED) <= set(REFERENCES)


@pytest.mark.parametrize("name", NUMBERED)
def test_every_numbered_formula_and_figure_is_there(name):
    assert set(NUMBERED[name]) <= set(formulas(name))
    assert sum(one.verdict == "wrong" for one in text_called(name).formulas) == WRONG[name]


def test_all_of_the_drive_is_computed():
    assert all(one.command for one in text_called("gandzha").formulas)


@pytest.mark.parametrize("text", TEXTS, ids=lambda text: text.name)
def test_what_is_wrong_or_right_in_a_range_says_how(text):
    for one in text.formulas:
        assert one.subject
        assert one.verdict == "right" or one.valid or one.note
        assert ("not computed" in one.said_verdict) == (one.command == "")


def largest(error, ratio):
    """Largest size of an error over half a turn, on a grid of 40-digit numbers."""
    with mp.workdps(20):
        return max(abs(error(mp.pi * step / 720, mp.mpf(ratio))) for step in range(721))


def displacement(phi, ratio):
    """Exact, of R = 1."""
    return 1 - mp.cos(phi) + (1 - mp.sqrt(1 - (ratio * mp.sin(phi)) ** 2)) / ratio


def harmonics(phi, ratio):
    return 1 - mp.cos(phi) + ratio / 2 * mp.sin(phi) ** 2


def brix(phi, ratio):
    return 1 - mp.cos(phi + mp.asin(ratio / 2 * mp.sin(phi)))


def test_errors_that_are_said_of_the_steam_engines_forms():
    """The digest's table, in 20 digits: displacement of the stroke, the others of their peaks."""
    said = " ".join(one.note for one in text_called("steam-engine").formulas)
    for ratio, shown in (("0.25", "0.10"), ("0.3", "0.18")):
        error = largest(lambda phi, lam: (harmonics(phi, lam) - displacement(phi, lam)) / 2, ratio)
        assert f"{100 * float(error):.2f}" == shown
        assert f"{shown} %" in said
    backward = largest(lambda phi, lam: (brix(phi, lam) - displacement(phi, lam)) / 2, "0.25")
    assert f"{100 * float(backward):.2f} % of the stroke at λ = 0.25" in said
    # (334) and (335): closed forms at 90°
    assert f"{50 * (1 - (1 - 0.01) ** 0.5) / 0.1:.1f} % of the stroke" in said
    assert f"{100 * (4 - 15**0.5 - 0.125) / 0.125:.1f} % more at λ = 0.25" in said


@pytest.mark.parametrize(
    ("order", "shown"), [(1, {"0.25": "0.26", "0.3": "0.44"}), (2, {"0.25": "0.66", "0.3": "1.1"})]
)
def test_errors_that_are_said_of_velocity_and_acceleration(order, shown):
    said = formulas("steam-engine")["(336)" if order == 1 else "(337)"].note
    assert all(text in said for text in shown.values())
    for ratio, text in shown.items():
        with mp.workdps(25):
            angles = [mp.pi * step / 180 for step in range(181)]
            lam = mp.mpf(ratio)
            exact = [mp.diff(lambda phi, lam=lam: displacement(phi, lam), angle, order) for angle in angles]
            form = [mp.diff(lambda phi, lam=lam: harmonics(phi, lam), angle, order) for angle in angles]
        error = max(abs(a - b) for a, b in zip(exact, form, strict=True)) / max(map(abs, exact))
        assert f"{100 * float(error):.{len(text.partition('.')[2])}f}" == text


@pytest.mark.parametrize(
    ("asked", "name"),
    [
        ("bolotin", "bolotin"),
        ("Bolotin", "bolotin"),
        ("steam engine", "steam-engine"),
        ("crankshaft", "crankshaft-reactions"),
    ],
)
def test_a_text_by_its_name_or_part_of_it(asked, name):
    assert text_called(asked).name == name


@pytest.mark.parametrize(
    ("asked", "meant"), [("bolotni", "bolotin"), ("gandza", "gandzha"), ("xyz", None), ("-", None)]
)
def test_an_unknown_text_is_refused_with_the_nearest(asked, meant):
    with pytest.raises(InputError) as refused:
        text_called(asked)
    (problem,) = problems_told(refused.value.problems)
    assert problem.path == "--source"
    assert problem.repair == (f'write "{meant}"' if meant else None)


def slave_by_integers(alpha):
    """Distance of the slave's pin of 3d12 from the shaft, in numbers of the example. [mm]"""
    bank, joint = mp.pi / 3, mp.radians(mp.mpf("67.458"))
    turn = joint - bank - mp.asin(90 * mp.sin(alpha) / 320)
    along = 90 * mp.cos(alpha - bank) + mp.mpf("78.256") * mp.cos(turn)
    across = 90 * mp.sin(alpha - bank) + mp.mpf("78.256") * mp.sin(turn)
    return along + mp.sqrt(mp.mpf("242.426") ** 2 - across**2)


def slave_by_reconstructed_form(alpha):
    """R[E cos(α_l + Φ) + ¼F cos(2α_l − Θ)] of 3d12, with the constants as the digest writes them. [mm]"""
    bank, psi = mp.pi / 3, mp.radians(mp.mpf("7.458"))
    crank, master, knuckle, rod = 90, 320, mp.mpf("78.256"), mp.mpf("242.426")
    rho, reach = knuckle / master, 1 + knuckle / rod
    own = alpha - bank
    first = (1 + reach * rho * mp.sin(bank) * mp.sin(psi), (knuckle / rod - rho * reach * mp.cos(bank)) * mp.sin(psi))
    second = (
        crank / rod * (1 - 2 * rho * mp.cos(bank)) + mp.mpf(crank) / master * rho * reach * mp.cos(2 * bank),
        2 * rho * crank / rod * mp.sin(bank) * (1 - reach * rod / master * mp.cos(bank)),
    )
    return crank * (
        first[0] * mp.cos(own)
        - first[1] * mp.sin(own)
        + (second[0] * mp.cos(2 * own) + second[1] * mp.sin(2 * own)) / 4
    )


@pytest.mark.parametrize("order", [0, 1, 2])
def test_how_far_the_form_of_articulated_rods_is_off(order):
    """Of the example 3d12 that the page names, in 30 digits on a grid of half degrees."""
    (said,) = (one.note for one in text_called("bolotin").formulas if "example 3d12" in one.note)
    with mp.workdps(30):
        angles = [mp.pi * step / 360 for step in range(720)]
        exact = [mp.diff(slave_by_integers, angle, order) for angle in angles]
        form = [mp.diff(slave_by_reconstructed_form, angle, order) for angle in angles]
        if order == 0:  # each from its own top
            exact, form = ([max(curve) - value for value in curve] for curve in (exact, form))
        error = max(abs(a - b) for a, b in zip(exact, form, strict=True)) / max(map(abs, exact))
    assert re.findall(r"([\d.]+) %", said)[order] == f"{100 * float(error):.2f}"


def test_both_opposed_pistons_together_are_as_far_off_as_the_page_says():
    (said,) = (one.note for one in text_called("bolotin").formulas if one.number == "(I.12)")
    with mp.workdps(20):
        ratio, lead = mp.mpf("0.25"), mp.pi / 15
        angles = [mp.pi * step / 360 for step in range(720)]
        off = [sum(harmonics(at, ratio) - displacement(at, ratio) for at in (one, one - lead)) for one in angles]
    assert f"{100 * float(max(map(abs, off)) / (4 * mp.cos(lead / 2))):.2f} % of the travel" in said


@pytest.mark.parametrize(("name", "more"), [("m_50", "4.9"), ("40d", "1.4"), ("3d12", "3.7")])
def test_power_by_bank_is_said_with_what_the_printed_strokes_give(name, more):
    strokes = {"m_50": (200, 209.8), "40d": (300, 304.3), "3d12": (180, 186.7)}[name]
    assert f"{100 * (strokes[1] / strokes[0] - 1):.1f}" == more
    (said,) = (one.note for one in text_called("bolotin").formulas if "power" in one.subject)
    assert more in said
    result = ct.run(name, step_degrees=5.0)
    own = {bank: one for one, bank in zip(result.stroke, (name[-1] for name in result.labels["piston"]), strict=True)}
    assert own["R"] / own["L"] == pytest.approx(strokes[1] / strokes[0], abs=1e-5)


@pytest.mark.parametrize(
    ("number", "wanted"),
    [
        ("337", [("steam-engine", "(337)")]),
        ("(i.13)", [("bolotin", "(I.13)"), ("bolotin", "(I.13)")]),
        ("І.12", [("bolotin", "(I.12)")]),  # the Cyrillic letter
        ("fig. 2", [("gandzha", "fig. 2")]),
        ("20", [("gandzha", "(20)"), ("gandzha", "after (20)"), ("gandzha", "after (20)")]),
        ("2000", []),
    ],
)
def test_formulas_are_found_by_their_numbers(number, wanted):
    assert [(text.name, one.number) for text, one in with_equation(number)] == wanted


def test_every_number_finds_its_formula():
    for text in TEXTS:
        for one in text.formulas:
            assert (text, one) in with_equation(one.number)


@pytest.mark.parametrize(("asked", "name"), [("a", "steam-engine"), ("Ганджа", "gandzha"), ("БОЛОТИН", "bolotin")])
def test_texts_are_called_by_letter_and_author(asked, name):
    assert text_called(asked).name == name


def said_of(name):
    return " ".join(f"{one.valid} {one.note}" for one in text_called(name).formulas)


def test_what_is_said_of_brixs_construction_backwards():
    """φ by S = R(1 − cos φ_O), φ_O = φ + asin((λ/2) sin φ), against S exact: bisection in 25 digits, λ = 0.25."""
    with mp.workdps(25):
        ratio = mp.mpf("0.25")
        errors = []
        for step in range(1, 180):
            phi = mp.pi * step / 180
            on_circle = mp.acos(1 - displacement(phi, ratio))
            read = mp.findroot(lambda a, on=on_circle: a + mp.asin(ratio / 2 * mp.sin(a)) - on, phi)
            errors.append(abs(read - phi))
    assert f"the angle is off by {float(mp.degrees(max(errors))):.2f}° at λ = 0.25" in said_of("steam-engine")


def test_brix_is_twice_as_far_off_as_two_harmonics():
    found = [
        largest(lambda phi, lam, form=form: form(phi, lam) - displacement(phi, lam), "0.25")
        for form in (brix, harmonics)
    ]
    assert round(float(found[0] / found[1])) == 2
    assert "twice as much as (333)" in said_of("steam-engine")


def test_numbers_that_are_said_of_the_synthesis():
    said = said_of("slider-crank-synthesis")
    with mp.workdps(20):
        assert f"tan 30° is {float(mp.tan(mp.pi / 6)):.3f}" in said
        assert f"at most {float(mp.degrees(mp.asin(mp.mpf(80) / 270))):.1f}°" in said
        # the pressure angle of the rod r/tan[α] is where crank and rod stand square: φ = 90° − [α]
        assert "the text says 60°" in said
        period = mp.mpf(2) * mp.mpf("0.16") / mp.mpf("6.3")
        assert f"{float(100 * (mp.mpf('125.6') * period / (2 * mp.pi) - 1)):.1f} % too large" in said
        rounded = ct.textbook.errata("synthesis").notes["Period of a turn"][0]
        assert f"rounded by {float(100 * (1 - mp.mpf('0.05') / period)):.1f} %" in rounded
        assert f"r/2l is {float(mp.mpf(80) / 540):.3f}" in said
    table = {60: 9.99, 300: -9.99}
    for angle, printed in table.items():
        phi = np.radians(angle)
        assert abs(printed - 10.048 * (np.sin(phi) + 0.15 * np.sin(2 * phi))) > 0.005
        assert f"{angle}°" in said
    slips = {150: 0.9, 210: -0.9}
    for angle, printed in slips.items():
        assert np.sin(2 * np.radians(angle)) * printed < 0
        assert f"{angle}°" in said


def test_a_balance_by_the_inner_counterweight_alone_leaves_a_reaction():
    """C1 = C4, all else 0: (44) by hand is −C4(2l2 + 2l3 + hL)/2l."""
    sizes = {"l1": 30, "l2": 20, "l3": 7, "l4": 9, "l5": 22, "l6": 31, "hL": 24, "hP": 26}
    length = sum(sizes.values())
    others = {f"C{number}": "0 N" for number in (2, 3, 5, 6, 7, 8, 9)} | {"C10": "0 N", "C11": "0 N"}
    given = {name: f"{size} mm" for name, size in sizes.items()} | {"C1": "1 kN", "C4": "1 kN"} | others
    found = ct.textbook.throw(set=given)
    right = next(one for one in found.numbered("(44)") if one.symbol == "R_KP" and one.name == "rotating masses")
    by_hand = -1000 * (2 * sizes["l2"] + 2 * sizes["l3"] + sizes["hL"]) / (2 * length)
    assert right.value == pytest.approx(by_hand)
    assert "R_KCP = −C4(2l2 + 2l3 + hL)/2l" in said_of("crankshaft-reactions")
