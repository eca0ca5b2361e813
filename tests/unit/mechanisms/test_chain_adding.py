"""Sliders in slots, rocking guides, links on three legs and pins, added to a chain by clicks, against closed forms.

All closed forms are in the axes of the file, of lengths as they were clicked: typed ones differ by half a step.
"""

import tomllib

import numpy as np
import pytest
from tests.clicked_chains import (
    ANGLES,
    LIE,
    PIVOT,
    RADIUS,
    Lying,
    added,
    away,
    length_of,
    machine_of,
    pins_of,
    text_of,
    turning_pins,
)
from tests.sentences import NO_DIRECTION, NOWHERE_HERE

from cranktrain.errors import InputError
from cranktrain.panels.additions import drawn_additions
from cranktrain.plans.placement import first_throw

PIVOT = np.array(PIVOT)
D = (0.5, 0.22)
"""A fixed point that is added, no farther than the press reaches. [m]"""
LATER = (0.0, 97.0, 211.0)
"""Angles behind the one at which it was clicked. [deg]"""


def unit(degrees):
    return np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])


def left(way):
    return np.array([-way[1], way[0]])


def crank_pin(lying, angle):
    return RADIUS * np.array([np.cos(lying.phi(angle)), np.sin(lying.phi(angle))])


def knee(lying, angle):
    """Where circles about the crank pin and the pivot meet, to the right of the line from one to the other."""
    pin = crank_pin(lying, angle)
    apart = away(PIVOT, pin)
    way = (PIVOT - pin) / apart
    along = (0.32**2 - 0.25**2 + apart**2) / (2.0 * apart)
    return pin + along * way - np.sqrt(0.32**2 - along**2) * left(way)


def ram(lying, angle):
    """Below the knee on the vertical through the pivot."""
    x, y = knee(lying, angle)
    return np.array([PIVOT[0], y - np.sqrt(0.25**2 - (x - PIVOT[0]) ** 2)])


def crossing(one, way, other, other_way):
    """Where lines through two places cross, and the sine of the angle between them."""
    sine = way[0] * other_way[1] - way[1] * other_way[0]
    beside = other - one
    return one + way * (beside[0] * other_way[1] - beside[1] * other_way[0]) / sine, abs(sine)


class Press:
    """The press as it lies and is shown, and what it is after clicks, given in the axes of the file."""

    def __init__(self, lie, angle, *fixed):
        self.lying, self.angle, self.text = Lying(*lie), angle, text_of(*lie)
        for place in fixed:
            self.add("pin", place)

    def add(self, name, *clicks):
        """Add a part; a click is the name of what it takes, or a place, or both."""
        named = [(one, (9.0, 9.0)) if isinstance(one, str) else ("", self.lying.at(*one)) for one in clicks]
        self.text = added(self.text, name, self.angle, *named)
        return tomllib.loads(self.text)["mechanism"]

    def pin(self, name, angle):
        return self.lying.own(pins_of(self.text, angle)[name])


@pytest.fixture(
    params=[(lie, angle) for lie in LIE for angle in ANGLES], ids=lambda one: f"{'-'.join(one[0])}-{one[1]}"
)
def press(request):
    return Press(*request.param)


def test_a_pin_on_a_slider_goes_along_with_it(press):
    lying = press.lying
    beside = np.array([0.06, -0.11])
    part = press.add("slider_pin", "ram.pin", ram(lying, press.angle) + beside)["part"][-1]
    assert (part["type"], part["link"]) == ("point", "ram")
    for later in LATER:
        at = press.angle + later
        assert away(press.pin("P", at), ram(lying, at) + beside) < 0.7072 * lying.step


def test_an_eccentric_is_ahead_of_the_crank(press):
    lying = press.lying
    place = np.array([-0.03, 0.045])
    press.add("eccentric", place)
    for later in LATER:
        turned = lying.phi(press.angle + later) - lying.phi(press.angle)
        expected = np.exp(1j * turned) * complex(*place)
        # Its angle is typed to whole degrees.
        off = 0.5 * lying.step + np.radians(0.5) * abs(expected)
        assert away(press.pin("eccentric.pin", press.angle + later), (expected.real, expected.imag)) < off


def line_of(press, angle, offset):
    """From the pivot's foot on a rocking guide to the guide's end, in the drawing."""
    return press.pin("lever.end", angle) - (press.pin("lever.foot", angle) if offset else PIVOT)


@pytest.mark.parametrize("degrees", [40.0, 75.0, 165.0])
def test_a_rocking_guide_s_line_goes_through_block_and_click(press, degrees):
    """From the pivot it is as far at all crank angles; its end, in the drawing, says where it points."""
    lying = press.lying
    block = crank_pin(lying, press.angle)
    part = press.add("swivel", "main.pin", "C", block + 0.1 * unit(degrees))["part"][-1]
    assert (part["pin"], part["guide"]["from"]) == ("main.pin", "C")
    arm, way = block - PIVOT, unit(degrees)
    way = way if way @ arm > 0.0 else -way
    offset = left(way) @ arm
    typed = length_of(part["guide"]["offset"])
    assert typed == pytest.approx(offset if abs(offset) > 4.0 * lying.step else 0.0, abs=0.5001 * lying.step)
    for later in LATER:
        arm = crank_pin(lying, press.angle + later) - PIVOT
        points = line_of(press, press.angle + later, typed)
        expected = np.arctan2(arm[1], arm[0]) - np.arcsin(typed / np.hypot(*arm))
        assert np.remainder(np.arctan2(points[1], points[0]) - expected + 1.0, 2.0 * np.pi) == pytest.approx(1.0)
    points = line_of(press, press.angle, typed)
    slack = abs(typed - offset) / np.sqrt(np.hypot(*(block - PIVOT)) ** 2 - max(abs(typed), abs(offset)) ** 2)
    assert abs(left(way) @ points) / np.hypot(*points) < slack + 1e-9


def test_a_rocking_guide_through_its_pivot(press):
    part = press.add("swivel", "main.pin", "C", "C")["part"][-1]
    assert length_of(part["guide"]["offset"]) == 0.0
    for later in LATER:
        arm = crank_pin(press.lying, press.angle + later) - PIVOT
        points = press.pin("lever.end", press.angle + later) - PIVOT
        assert arm @ points == pytest.approx(np.hypot(*arm) * np.hypot(*points))


@pytest.mark.parametrize(("degrees", "slot"), [(0.0, 90.0), (20.0, 70.0), (-110.0, 135.0), (90.0, 40.0)])
@pytest.mark.parametrize("beside", [0.15, -0.15])
def test_a_slotted_slider_is_where_its_slot_through_the_block_meets_its_guide(press, degrees, slot, beside):
    lying = press.lying
    way, across = unit(degrees), unit(degrees + slot)
    place = crank_pin(lying, press.angle) + beside * across
    part = press.add("yoke", "main.pin", place, place + 0.2 * way)["part"][-1]
    assert (part["guide"]["direction"], part["slot_angle"]) == (f"{degrees:.0f} deg", f"{slot:.0f} deg")
    for later in LATER:
        pin = crank_pin(lying, press.angle + later)
        expected, sine = crossing(place, way, pin, across)
        assert away(press.pin(f"{part['slider']}.pin", press.angle + later), expected) < 0.5001 * lying.step / sine


def test_a_slotted_slider_clicked_on_its_block_is_a_scotch_yoke(press):
    """Which, at dead centres of the slot, no other place says."""
    place = crank_pin(press.lying, press.angle)
    part = press.add("yoke", "main.pin", place, place + 0.2 * unit(30.0))["part"][-1]
    assert (part["guide"]["direction"], part["slot_angle"]) == ("30 deg", "90 deg")
    assert machine_of(press.text).closing_problems == ()


@pytest.mark.parametrize("place", [(0.3, 0.1), (0.33, -0.05), (0.3, 0.3)])
@pytest.mark.parametrize("degrees", [90.0, -65.0])
def test_a_slider_is_where_the_slot_of_a_link_crosses_its_guide(press, place, degrees):
    """The slot goes through the slider's pin along the line from the pivot to the knee, or beside that line."""
    lying = press.lying
    link = knee(lying, press.angle) - PIVOT
    shift = left(link / np.hypot(*link)) @ (np.array(place) - PIVOT)
    part = press.add("trammel", "upper", place, np.array(place) + 0.2 * unit(degrees))["part"][-1]
    assert part["link"] == "upper"
    shift = shift if abs(shift) > 4.0 * lying.step else 0.0
    # Of the slider's pin on the guide as that is typed.
    assert length_of(part["shift"]) == pytest.approx(shift, abs=1.0001 * lying.step)
    for later in LATER:
        link = knee(lying, press.angle + later) - PIVOT
        link /= np.hypot(*link)
        expected, sine = crossing(np.array(place), unit(degrees), PIVOT + shift * left(link), link)
        if sine > 0.2:
            assert away(press.pin("slider.pin", press.angle + later), expected) < 1.5001 * lying.step / sine


LEGS = {
    "driven": ("main.pin", (0.33, -0.04)),
    "above": ("main.pin", (0.45, 0.2)),
    "first": ("C", (0.4, 0.0)),
    "second": ("D", (0.52, 0.02)),
    "level": ((0.56, 0.01), 10.0),
    "upright": ((0.4, 0.0), 80.0),
}
"""A rod's pin and its joint, or a slider's pin and the direction of its guide. [m, deg]"""
TRIADS = (
    ("driven", "first", "second"),
    ("second", "driven", "first"),
    ("driven", "first", "level"),
    ("level", "driven", "first"),
    ("upright", "level", "above"),
    ("above", "level", "upright"),
)


@pytest.mark.parametrize("legs", TRIADS, ids="-".join)
@pytest.mark.parametrize("lie", LIE[1:])
@pytest.mark.parametrize("angle", ANGLES)
def test_a_link_on_three_legs_keeps_all_distances_and_goes_on_from_where_it_was_clicked(lie, angle, legs):
    press = Press(lie, angle, D)
    lying, step = press.lying, press.lying.step
    own = [LEGS[leg] for leg in legs]
    joints = [np.array(one if isinstance(one, tuple) else then) for one, then in own]
    clicks = [(one, then if isinstance(one, str) else one + 0.1 * unit(then)) for one, then in own]
    part = press.add("triad", *(click for pair in clicks for click in pair))["part"][-1]
    assert machine_of(press.text).closing_problems == ()
    names = [leg.get("joint") or f"{leg['slider']}.pin" for leg in part["leg"]]
    pins = turning_pins(press.text, angle + np.arange(0.0, 361.0, 7.5))
    found = {name: np.array([lying.own(at) for at in pins[name].T]) for name in (*names, "main.pin")}
    for name, joint, (one, then) in zip(names, joints, own, strict=True):
        # Half a step of each of five numbers, and of a lever by some two more.
        assert away(found[name][0], joint) < 5.0 * step
        assert away(found[name][-1], found[name][0]) < 1e-6
        assert np.max(np.hypot(*np.diff(found[name], axis=0).T)) < 0.03, "the link does not jump"
        if isinstance(one, tuple):
            assert np.max(np.abs((found[name] - joint) @ left(unit(then)))) < 0.5001 * step
        else:
            start = found["main.pin"] if one == "main.pin" else {"C": PIVOT, "D": np.array(D)}[one]
            length = away(joint, crank_pin(lying, angle) if one == "main.pin" else start)
            assert np.hypot(*(found[name] - start).T) == pytest.approx(length, abs=1.2 * step)
    for k, name in enumerate(names):
        other = names[k - 1]
        between = np.hypot(*(found[name] - found[other]).T)
        assert between == pytest.approx(away(joints[k], joints[k - 1]), abs=1.3 * step)


def test_a_triad_says_where_it_lies_only_where_it_fits_in_several_ways():
    press = Press(LIE[0], 73.0, D)
    clicks = [click for leg in TRIADS[0] for click in LEGS[leg]]
    part = press.add("triad", *clicks)["part"][-1]
    assert [sorted(leg) for leg in part["leg"]].count(["joint", "near", "rod"]) <= 1
    assert sum("near" in leg for leg in part["leg"]) == 1
    assert [("along" in leg, "across" in leg) for leg in part["leg"]] == [
        (False, False),
        (True, False),
        (True, True),
    ]


@pytest.mark.parametrize(
    ("name", "clicks", "said"),
    [
        ("slider_pin", [("knee", (0, 0)), ("", (0.1, 0.1))], "must be one of: ram.pin"),
        ("eccentric", [("", (0.001, 0.002))], "would be at the shaft's centre"),
        ("swivel", [("C", (0, 0)), ("C", (0, 0)), ("", (0.1, 0.1))], "is where the block is"),
        ("swivel", [("main.pin", (0, 0)), ("C", (0, 0)), ("main.pin", (0, 0))], NO_DIRECTION),
        ("swivel", [("main.pin", (0, 0)), ("upper", (0, 0)), ("", (0.1, 0.1))], "must be one of: O, C, main.pin"),
        ("yoke", [("ram", (0, 0)), ("", (0.1, 0.1)), ("", (0.2, 0.1))], "must be one of: O, C, main.pin"),
        ("yoke", [("main.pin", (0, 0)), ("", (0.1, 0.1)), ("", (0.101, 0.1))], NO_DIRECTION),
        ("trammel", [("knee", (0, 0)), ("", (0.1, 0.1)), ("", (0.2, 0.1))], "must be one of: pitman, upper, lower"),
        ("trammel", [("upper", (0, 0)), ("", (0.1, 0.1)), ("", (0.1, 0.101))], NO_DIRECTION),
        ("triad", [("C", (0, 0)), ("", (0.4, 0.251))] + 2 * [("O", (0, 0)), ("", (0.1, 0.1))], "is where its rod"),
        ("triad", [("C", (0, 0)), ("", (0.2, 0.2))] + 2 * [("O", (0, 0)), ("", (0.1, 0.1))], "are in one place"),
        ("triad", [("", (0.2, 0.2)), ("", (0.2, 0.201))] + 2 * [("O", (0, 0)), ("", (0.1, 0.1))], NO_DIRECTION),
    ],
)
def test_what_no_part_can_be_made_of_is_refused(name, clicks, said):
    lying = Lying(*LIE[0])
    with pytest.raises(InputError, match="addition") as caught:
        added(text_of(), name, 0.0, *((own, lying.at(*at)) for own, at in clicks))
    assert said in str(caught.value)


def test_what_cannot_close_is_refused_in_the_machine_s_words():
    """A slot along its guide; a guide's line that the block would have to leave; a link's slot along the guide."""
    press = Press(LIE[0], 0.0)
    press.add("yoke", "main.pin", (0.3, 0.0), (0.5, 0.0))
    with pytest.raises(InputError, match="slot_angle = 0 deg: must not lie along the guide"):
        machine_of(press.text)
    for name, *clicks in (
        ("swivel", "main.pin", "C", unit(-60.0)),
        ("trammel", "pitman", (0.2, 0.1), np.array([0.2, 0.1]) + 0.2 * (knee(press.lying, 0.0) - (RADIUS, 0.0))),
        ("triad", "main.pin", (0.25, 0.05), "C", (0.3, 0.0), "D", (0.27, -0.1)),
    ):
        press = Press(LIE[0], 0.0, (0.4, -0.2))
        press.add(name, *clicks)
        (problem,) = machine_of(press.text).closing_problems
        assert "cannot close" in str(problem.allowed), name


def test_a_link_that_cannot_turn_from_where_it_is_clicked_is_refused():
    """The lever on the shaft's centre, 36 mm long, goes round with a crank of 50 mm, but not all the way to 0°."""
    press = Press(LIE[0], 180.0)
    with pytest.raises(InputError, match="cannot go from where it is clicked"):
        press.add("triad", "main.pin", (0.08, 0.13), "C", (-0.02, 0.1), "O", (0.02, 0.03))


def test_where_links_cannot_close_nothing_slides_on_them():
    text = text_of().replace('"320 mm"', '"260 mm"')
    for name, first in (("yoke", "knee"), ("trammel", "lower"), ("slider_pin", "ram.pin"), ("swivel", "knee")):
        rest = [("C", (0, 0))] if name == "swivel" else []
        clicks = [(first, (0, 0)), *rest, ("", (0.2, 0.2)), ("", (0.3, 0.2))]
        with pytest.raises(InputError, match=NOWHERE_HERE):
            added(text, name, 180.0, *clicks[: 2 if name == "slider_pin" else 3])


def test_what_a_click_took_says_which_follows():
    machine = machine_of(text_of())
    additions = {one.name: one for one in drawn_additions(machine, first_throw(machine))}
    clicks = additions["triad"].clicks
    assert [click.begins for click in clicks] == [False, False, False, True, False, False, True, False, False]
    asked = []
    for names in (("C", "", "", "", "O", ""), ("", "", "C", "", "C", "")):
        now = 0
        for name in names:
            asked.append(now)
            now = next(target.then for target in clicks[now].targets if target.name == name)
        assert now == len(clicks)
    assert asked == [0, 1, 3, 5, 6, 7, 0, 2, 3, 4, 6, 7]
    assert [[one.pins for one in click.targets] for click in additions["slider_pin"].clicks] == [[("ram.pin",)], [()]]
    for one in additions.values():
        assert {target.then for click in one.clicks for target in click.targets} == set(range(1, len(one.clicks) + 1))
