"""Pressure over volume or stroke, listed in the ways that files do it, gives the crank angles that it was made from."""

import itertools

import numpy as np
import pytest
from tests.gas_engines import FOUR_STROKE, TWO_STROKE, Engine, csv
from tests.told import texts_of

from cranktrain.errors import InputError
from cranktrain.fluids import VolumeLimits
from cranktrain.fluids.indicator import IndicatorSpec, card_of, indicator_diagram, pressure_at
from cranktrain.fluids.indicator.chamber import central_ratio
from cranktrain.fluids.indicator.unrolling import dead_centres_of
from cranktrain.spec import validated
from cranktrain.texts.steam_engine import brix

R, L, BORE = 0.045, 0.15, 0.08
ENGINE = Engine(R, L, BORE, 10.0)
OFFSET = Engine(R, L, BORE, 10.0, offset=0.012)
ANGLE = np.radians(np.arange(0, 720, 1.0))


def pressure(angle):
    """Smooth and different in each of the four strokes; highest after firing, second in compression."""
    return 1e5 * (12 + 9 * np.cos(angle / 2) + 4 * np.sin(angle / 2) + np.cos(angle) + 0.5 * np.sin(angle))


def two_stroke_pressure(angle):
    return 1e5 * (12 + 9 * np.cos(angle) + 3 * np.sin(angle))


def diagram_of(text, engine=ENGINE, cycle=FOUR_STROKE, chamber=None, **more):
    spec = validated(IndicatorSpec, {"kind": "indicator", "file": "card.csv", "text": text, **more})
    return indicator_diagram(card_of(spec).card[0], chamber or engine.chamber(cycle))


def strokes_of(engine, angle):
    """Sense of each angle's stroke, as V′ says."""
    return np.where(engine.slope(angle + 1e-6) > 0, 1, -1)


LISTINGS = {
    "round the cycle": np.arange(720),
    "beginning within a stroke": np.roll(np.arange(720), 100),
    "backwards": np.arange(720)[::-1],
    "backwards, beginning within a stroke": np.roll(np.arange(720), 300)[::-1],
    "every branch from the smallest volume on": np.concatenate(
        [np.arange(0, 180), np.arange(180, 360)[::-1], np.arange(360, 540), np.arange(540, 720)[::-1]]
    ),
}


@pytest.mark.parametrize("engine", [ENGINE, OFFSET], ids=["central", "offset"])
@pytest.mark.parametrize("listing", LISTINGS)
def test_listings(listing, engine):
    """Each point comes back to its own angle: exactly, as the inverse of V is exact."""
    ends = dead_centres_of(engine.chamber().volume)
    # Strokes of the offset engine are not of 180°; the listing goes by strokes.
    edges = [ends.top, ends.bottom, ends.top + 2 * np.pi, ends.bottom + 2 * np.pi, ends.top + 4 * np.pi]
    angle = np.concatenate([np.linspace(a, b, 180, endpoint=False) for a, b in itertools.pairwise(edges)])
    listed = angle[LISTINGS[listing]]
    text = csv(engine.volume(listed).value * 1e3, pressure(listed), header="volume [L],p abs [Pa]")
    diagram = diagram_of(text, engine)
    assert pressure_at(diagram, angle) == pytest.approx(pressure(angle), rel=2e-6)


@pytest.mark.parametrize("order", [1, -1])
def test_two_stroke(order):
    angle = ANGLE[:360][::order]
    text = csv(ENGINE.volume(angle).value, two_stroke_pressure(angle), header="V [m³],p abs [Pa]")
    diagram = diagram_of(text, cycle=TWO_STROKE)
    assert pressure_at(diagram, ANGLE[:360]) == pytest.approx(two_stroke_pressure(ANGLE[:360]), rel=2e-6)


def test_card_with_the_scale_of_paper_counted_from_the_bottom():
    """An indicator card's length stands for the stroke, whatever its scale."""
    part = (ENGINE.volume(ANGLE).value - ENGINE.limits.smallest) / ENGINE.swept
    diagram = diagram_of(csv(7.0 + 120 * (1 - part), pressure(ANGLE), header="s [mm],p abs [Pa]"))
    assert pressure_at(diagram, ANGLE) == pytest.approx(pressure(ANGLE), rel=2e-6)
    assert any("count from the bottom dead centre" in finding for finding in texts_of(diagram.findings))


def test_brix_as_schools_unroll():
    """A card drawn by Brix's construction is read by it without error; exactly read, it is off by his error."""
    card = csv(brix(ANGLE, R, R / L).value * 1e3, pressure(ANGLE), header="s [mm],p abs [Pa]")
    by_brix = diagram_of(card, unrolling="brix")
    # The points that are put between the card's own bridge steps of 1° and less.
    own = pressure_at(by_brix, ANGLE)
    assert own == pytest.approx(pressure(ANGLE), rel=2e-6)
    exactly = pressure_at(diagram_of(card), ANGLE)
    assert 1e-4 < np.max(np.abs(exactly / pressure(ANGLE) - 1)) < 2e-2


def test_the_ratio_of_a_central_slider_crank_is_seen_in_its_volume():
    """On the crank's side the piston begins at the bottom, and the finite rod works the other way."""
    crank_side = ENGINE.chamber()._replace(volume=lambda angle: sum(ENGINE.limits) - ENGINE.volume(angle + np.pi).value)
    assert central_ratio(ENGINE.chamber()) == pytest.approx(R / L, rel=1e-13)
    assert central_ratio(crank_side) == pytest.approx(-R / L, rel=1e-13)
    assert central_ratio(OFFSET.chamber()) is None
    harmonic = ENGINE.chamber()._replace(volume=lambda angle: 8.5e-4 - 7.5e-4 * np.cos(angle))
    assert central_ratio(harmonic._replace(limits=VolumeLimits(1e-4, 1.6e-3))) is None


def test_where_strokes_meet_the_one_that_begins_counts():
    """A jump at the dead centre, as of an ideal cycle: both branches list it."""
    outward, back = np.radians(np.arange(0, 181.0)), np.radians(np.arange(180, 361.0))
    levels = np.concatenate([np.full(181, 20e5), np.full(181, 2e5)])
    text = csv(ENGINE.volume(np.concatenate([outward, back])).value, levels, header="V [m³],p abs [Pa]")
    diagram = diagram_of(text, cycle=TWO_STROKE)
    assert pressure_at(diagram, np.radians([0.0, 180.0])) == pytest.approx([20e5, 2e5])


def test_a_line_at_one_place_is_a_jump_within_the_stroke():
    """A card that falls from 9 to 4 bar at 80 % of the outward stroke, and rises at 30 % of the way back."""
    part = np.concatenate([np.linspace(0, 0.8, 81), np.linspace(0.8, 1, 21)])
    back = np.concatenate([np.linspace(1, 0.3, 71), np.linspace(0.3, 0, 31)])
    levels = 1e5 * np.repeat([9.0, 4.0, 2.0, 6.0], [81, 21, 71, 31])
    places = np.concatenate([part, back])
    levels[0] += 1.0  # the peak tells which end is the top
    for order in (1, -1):
        text = csv(100 * places[::order], levels[::order], header="s [mm],p abs [Pa]")
        diagram = diagram_of(text, cycle=TWO_STROKE)
        volumes = ENGINE.limits.smallest + np.array([0.8, 0.3]) * ENGINE.swept
        jumps = diagram.curve.jumps
        assert len(jumps) == 4
        assert ENGINE.volume(jumps[[1, 3]]).value == pytest.approx(volumes, rel=1e-9)
        after = pressure_at(diagram, jumps)
        before = pressure_at(diagram, jumps - 1e-12)
        assert after == pytest.approx([9e5, 4e5, 2e5, 6e5], rel=1e-5)
        assert before == pytest.approx([6e5, 9e5, 4e5, 2e5], rel=1e-9)


def test_rounded_volumes_are_no_jumps():
    """Steps of 0.5° and volumes to 1 cm³: many rows have one volume, near the dead centres above all."""
    angle = np.radians(np.arange(0.25, 360, 0.5))
    volume = np.rint(ENGINE.volume(angle).value * 1e6)
    text = csv(volume, two_stroke_pressure(angle), header="V [cm³],p abs [Pa]")
    diagram = diagram_of(text, cycle=TWO_STROKE)
    assert np.all(np.abs(np.sin(diagram.curve.jumps)) < 1e-9)
    assert not any("in one step" in flag for flag in texts_of(diagram.flags))


@pytest.mark.parametrize(
    ("text", "more", "message"),
    [
        (
            csv(ENGINE.volume(ANGLE[:360]).value, two_stroke_pressure(ANGLE[:360]), header="V [m³],p abs [Pa]"),
            {},
            "has 2 strokes",
        ),
        (csv(2 * ENGINE.volume(ANGLE).value, pressure(ANGLE), header="V [m³],p abs [Pa]"), {}, "has volumes of"),
        (csv(0 * ANGLE + 1, pressure(ANGLE), header="s [mm],p abs [Pa]"), {}, "has one volume only"),
        (
            csv(
                ENGINE.volume(ANGLE).value,
                np.array([9e5, 1e5, 8e5, 2e5])[(np.arange(720) // 180)],
                header="V [m³],p abs [Pa]",
            ),
            {},
            "in no order in which an engine makes them",
        ),
        (
            csv(OFFSET.volume(ANGLE).value, pressure(ANGLE), header="V [m³],p abs [Pa]"),
            {"unrolling": "brix", "engine": OFFSET},
            "for a central slider-crank only",
        ),
        (
            csv(ENGINE.volume(ANGLE).value, pressure(ANGLE), header="V [m³],p abs [Pa]"),
            {"sense": "found", "firing_angle": "0 deg"},
            "firing_angle: is for a file over the crank angle; this one is over volume\nsense: is for",
        ),
        (csv(np.degrees(ANGLE), pressure(ANGLE)), {"unrolling": "brix"}, "is for a file over volume or displacement"),
    ],
    ids=["two strokes", "another machine", "one place", "no order", "no rod", "angles", "no strokes"],
)
def test_refused(text, more, message):
    with pytest.raises(InputError, match=message):
        diagram_of(text, **more)
