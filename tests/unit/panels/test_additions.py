"""Parts that are added to a chain by clicks: they lie where it was clicked, at the crank angle that was shown."""

import tomllib

import numpy as np
import pytest
from tests.clicked_chains import ANGLES, LIE, PIVOT, Lying, added, away, length_of, machine_of, pins_of, text_of
from tests.sentences import NO_DIRECTION, NOWHERE_HERE

import cranktrain as ct
from cranktrain.errors import InputError
from cranktrain.io.examples import example_text
from cranktrain.panels.additions import drawn_additions
from cranktrain.panels.handles import drawn_handles
from cranktrain.plans.placement import first_throw

COUPLED = """\
[mechanism]
kind = "chain"
output = "slider"
fixed.D = ["300 mm", "0 mm"]
crank.main.radius = "50 mm"
part = [
  { type = "slide", rod = { name = "rod", from = "main.pin", length = "200 mm" }, slider = "slider", guide = ALONG },
]
""".replace("ALONG", '{ through = "O", direction = "0 deg" }')


@pytest.mark.parametrize("lie", LIE)
@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("place", [(0.3, 0.4), (0.3, -0.1), (0.1, 0.2)])
def test_two_links_meet_where_it_was_clicked(lie, angle, place):
    """Links of the distances between pins, to half a step; their joint is on the side of the click."""
    text, lying = text_of(*lie), Lying(*lie)
    at = lying.at(*place)
    after = added(text, "pair", angle, ("main.pin", (9.0, 9.0)), ("", at), ("C", (0.0, 0.0)))
    part = tomllib.loads(after)["mechanism"]["part"][-1]
    rod, rocker = away(at, lying.crank(angle)), away(at, lying.at(*PIVOT))
    assert (part["rod"]["name"], part["rod"]["from"], part["rocker"]["from"]) == ("rod", "main.pin", "C")
    assert length_of(part["rod"]["length"]) == pytest.approx(rod, abs=0.5001 * lying.step)
    assert length_of(part["rocker"]["length"]) == pytest.approx(rocker, abs=0.5001 * lying.step)
    # Half a step of either length moves the joint by that, over the sine of the angle between the links.
    one, other = at - lying.crank(angle), at - lying.at(*PIVOT)
    sine = abs(one[0] * other[1] - one[1] * other[0]) / (rod * rocker)
    assert away(pins_of(after, angle)["B"], at) < 1.5 * lying.step / sine


@pytest.mark.parametrize("lie", LIE)
@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("degrees", [90.0, 37.4, -116.0, 178.0])
def test_a_slider_s_pin_is_where_it_was_clicked_and_its_guide_runs_as_it_was(lie, angle, degrees):
    text, lying = text_of(*lie), Lying(*lie)
    at, way = lying.at(0.7, 0.1), lying.at(np.cos(np.radians(degrees)), np.sin(np.radians(degrees)))
    knee = pins_of(text, angle)["knee"]
    after = added(text, "slider", angle, ("knee", (0.0, 0.0)), ("", at), ("", at + 0.2 * way))
    part = tomllib.loads(after)["mechanism"]["part"][-1]
    assert float(part["guide"]["direction"].split()[0]) == {37.4: 37.0, 178.0: 180.0}.get(degrees, degrees)
    assert part["side"] == ("ahead" if way @ (at - knee) > 0.0 else "behind")
    along = abs(way @ (at - knee)) / away(at, knee)
    # The guide's direction is rounded about the slider's pin, its offset and the rod's length are to half a step.
    assert away(pins_of(after, angle)["slider.pin"], at) < 2.0 * lying.step / along
    offset = length_of(part["guide"]["offset"])
    own = np.radians(float(part["guide"]["direction"].split()[0]))
    across = np.cos(own) * lying.y - np.sin(own) * lying.x
    through = {"O": np.zeros(2), "C": lying.at(*PIVOT)}
    expected = {name: across @ (at - fixed) for name, fixed in through.items()}
    assert offset == pytest.approx(expected[part["guide"]["through"]], abs=0.5001 * lying.step)
    assert abs(expected[part["guide"]["through"]]) == min(map(abs, expected.values()))


def test_a_guide_that_nearly_goes_through_a_fixed_point_goes_through_it():
    """Clicks miss by a pixel or two."""
    lying = Lying(*LIE[0])
    for beside, offset in ((0.003, "0 mm"), (0.006, "-6 mm")):
        after = added(
            text_of(), "slider", 10.0, ("main.pin", (0, 0)), ("", lying.at(0.3, -beside)), ("", lying.at(0.5, 0))
        )
        guide = tomllib.loads(after)["mechanism"]["part"][-1]["guide"]
        assert guide == {"through": "O", "direction": "0 deg", "offset": offset}


@pytest.mark.parametrize("lie", LIE)
@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize(("name", "pin"), [("point", "G"), ("pin", "P")])
def test_a_point_on_a_link_is_where_it_was_clicked(lie, angle, name, pin):
    """At the middle of the upper link, and 30 mm beside it; the same distances from its pins at another angle."""
    text, lying = text_of(*lie), Lying(*lie)
    start, end = lying.at(*PIVOT), pins_of(text, angle)["knee"]
    along = (end - start) / away(start, end)
    for beside in (0.0, 0.03):
        at = (start + end) / 2 + beside * np.array([-along[1], along[0]])
        after = added(text, name, angle, ("upper", at))
        assert away(pins_of(after, angle)[pin], at) < 1.001 * lying.step
        later = pins_of(after, angle + 100.0)
        assert away(later[pin], later["C"]) == pytest.approx(np.hypot(0.125, beside), abs=1.001 * lying.step)


@pytest.mark.parametrize("lie", LIE)
def test_a_fixed_point_is_where_it_was_clicked(lie):
    text, lying = text_of(*lie), Lying(*lie)
    after = added(text, "pin", 30.0, ("", lying.at(0.2, -0.3)))
    typed = [length_of(one) for one in tomllib.loads(after)["mechanism"]["fixed"]["D"]]
    assert typed == pytest.approx([0.2, -0.3], abs=0.5001 * lying.step)
    hung = added(after, "pair", 30.0, ("knee", (0, 0)), ("", lying.at(0.1, -0.1)), ("D", (0, 0)))
    np.testing.assert_allclose(pins_of(hung, 200.0)["D"], lying.at(0.2, -0.3), atol=0.75 * lying.step)


ALL = (
    ("point", ("lower", (0.4, -0.1))),
    ("pin", ("upper", (0.4, 0.1))),
    ("pin", ("", (0.2, -0.3))),
    ("pair", ("knee", (0, 0)), ("", (0.3, 0.3)), ("C", (0, 0))),
    ("slider", ("knee", (0, 0)), ("", (0.7, 0.0)), ("", (0.9, 0.0))),
    ("slider_pin", ("ram.pin", (0, 0)), ("", (0.5, 0.1))),
    ("eccentric", ("", (0.02, 0.03))),
    ("swivel", ("main.pin", (0, 0)), ("C", (0, 0)), ("C", (0, 0))),
    ("yoke", ("main.pin", (0, 0)), ("", (0.1, 0.3)), ("", (0.3, 0.3))),
    ("trammel", ("upper", (0, 0)), ("", (0.3, 0.1)), ("", (0.3, 0.3))),
    (
        "triad",
        ("main.pin", (0, 0)),
        ("", (0.33, -0.04)),
        ("C", (0, 0)),
        ("", (0.4, 0.0)),
        ("", (0.56, 0.01)),
        ("", (0.66, 0.03)),
    ),
)


@pytest.mark.parametrize("addition", ALL, ids=[f"{name} {clicks[0][0]}" for name, *clicks in ALL])
def test_all_else_of_the_file_stays(addition):
    """Every line in its place, comments too; parts stand together; twice is another of another name."""
    text = text_of()
    once = added(text, addition[0], 60.0, *addition[1:])
    twice = added(once, addition[0], 60.0, *addition[1:])
    lines = iter(twice.splitlines())
    assert all(any(line == other for other in lines) for line in text.splitlines())
    assert text.splitlines()[-3:] == (text if addition[0] in ("point", "eccentric") else once).splitlines()[-3:]
    before, after = tomllib.loads(text)["mechanism"], tomllib.loads(twice)["mechanism"]
    assert (after["output"], after["crank"]["main"]) == (before["output"], before["crank"]["main"])
    assert after["part"][: len(before["part"])] == before["part"]
    new = len(pins_of(twice, 60.0)) - len(pins_of(text, 60.0))
    # A yoke's slot has two ends in the drawing.
    assert new == 2 * (3 if addition[0] in ("triad", "yoke") else 1)
    assert machine_of(twice).name == machine_of(text).name


def test_a_pin_on_a_lever_that_swings_about_a_pivot():
    """The shaper's: halfway from the pivot to its end, 250 mm of 500."""
    text = example_text("shaper")
    pins = pins_of(text, 40.0)
    at = (pins["C"] + pins["D"]) / 2
    after = added(text, "pin", 40.0, ("lever", at))
    part = tomllib.loads(after)["mechanism"]["part"][-1]
    assert (part["along"], part["across"]) == ("250 mm", "0 mm")
    later = pins_of(after, 200.0)
    np.testing.assert_allclose(later["P"], (later["C"] + later["D"]) / 2, atol=1e-9)


FILES = {
    "keys with dots": COUPLED,
    "no fixed point": COUPLED.replace('fixed.D = ["300 mm", "0 mm"]\n', ""),
    "in a bank": COUPLED.replace("[mechanism]", "[bank.A.mechanism]"),
    "lines ended by two": COUPLED.replace("\n", "\r\n"),
    "all in a line": "mechanism = { "
    + ", ".join(COUPLED.replace("[\n  ", "[").replace(",\n]", "]").splitlines()[1:])
    + " }\n",
}


@pytest.mark.parametrize("layout", FILES)
def test_however_the_file_is_laid_out(layout):
    text = FILES[layout]
    machine = machine_of(text)
    for name, *clicks in (
        ("pin", ("", (0.1, 0.2))),
        ("pin", ("rod", (0.1, 0.0))),
        ("point", ("rod", (0.1, 0.0))),
        ("pair", ("main.pin", (0.0, 0.0)), ("", (0.1, 0.2)), ("slider.pin", (0.0, 0.0))),
    ):
        text = added(text, name, 60.0, *clicks)
    before, after = machine.places[0].spec, machine_of(text).places[0].spec
    assert after.part[0] == before.part[0]
    assert [part.type for part in after.part] == ["slide", "point", "pin"]
    assert len(after.fixed) == len(before.fixed) + 1
    assert list(after.points) == ["G"]


def test_new_numbers_are_moved_by_hand():
    text = text_of()
    for name, *clicks in ALL:
        text = added(text, name, 60.0, *clicks)
    machine = machine_of(text)
    assert ct.run(machine).stroke[0] == pytest.approx(ct.run(machine_of(text_of())).stroke[0], rel=1e-12)
    paths = [path for path, _value in leaves(tomllib.loads(text))]
    handled = {
        path
        for handle in drawn_handles(machine, first_throw(machine), paths)
        for number in handle.numbers
        for path in number.paths
    }
    assert {
        "mechanism.points.G.along", "mechanism.points.G.across", "mechanism.part[2].along", "mechanism.fixed.D[1]",
        "mechanism.part[3].rod.length", "mechanism.part[3].rocker.length", "mechanism.part[4].rod.length",
        "mechanism.part[4].guide.offset",
    } <= handled  # fmt: skip


def leaves(table, above=""):
    items = table.items() if isinstance(table, dict) else enumerate(table)
    for key, value in items:
        path = f"{above}[{key}]" if isinstance(key, int) else f"{above}.{key}".removeprefix(".")
        if isinstance(value, dict | list):
            yield from leaves(value, path)
        else:
            yield path, value


@pytest.mark.parametrize("is_crossed", [False, True])
@pytest.mark.parametrize("degrees", [50.0, 130.0, 290.0])
def test_of_a_parallelogram_s_lengths_it_is_the_one_that_was_clicked(is_crossed, degrees):
    """The crossed one's joint mirrors the other's in the line from the crank pin to the pivot."""
    crank = 0.05 * np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
    pivot = np.array([0.3, 0.0])
    joint = pivot + crank
    if is_crossed:
        along = (pivot - crank) / away(pivot, crank)
        joint = crank + 2 * along * (along @ (joint - crank)) - (joint - crank)
    text = 'rotation = "anticlockwise"\nangle = "-90 deg"\n' + COUPLED
    after = added(text, "pair", degrees, ("main.pin", (0, 0)), ("", joint), ("D", (0, 0)))
    (_slide, part) = tomllib.loads(after)["mechanism"]["part"]
    assert (part["rod"]["length"], part["rocker"]["length"]) == ("300 mm", "50 mm")
    assert part["rod"]["name"] == "rod2"
    assert part.get("crossed", False) is is_crossed
    np.testing.assert_allclose(pins_of(after, degrees)["B"], joint, atol=1e-9)


@pytest.mark.parametrize(
    ("name", "clicks", "said"),
    [
        ("pair", [("E", (0, 0)), ("", (0.3, 0.4)), ("C", (0, 0))], "must be one of: O, C, main.pin, knee, ram.pin"),
        ("pair", [("upper", (0, 0)), ("", (0.3, 0.4)), ("C", (0, 0))], "must be one of: O, C"),
        ("pair", [("", (0, 0)), ("", (0.3, 0.4)), ("C", (0, 0))], "must be one of: O, C"),
        ("pair", [("C", (0, 0)), ("", (0.3, 0.4)), ("C", (0, 0))], "take another pin"),
        ("pair", [("C", (0, 0))], "must be as many as it asks for: 3"),
        ("point", [("knee", (0, 0))], "must be one of: pitman, upper, lower"),
        ("point", [("", (0, 0))], "must be one of: pitman, upper, lower"),
        ("pin", [("ram", (0, 0))], "must be one of: pitman, upper, lower"),
        ("pair", [("C", (0, 0)), ("", (0.4, 0.25)), ("knee", (0, 0))], "is where both links would meet"),
        ("pair", [("knee", (0, 0)), ("", (0.4, 0.25)), ("C", (0, 0))], "is where both links would meet"),
        ("slider", [("C", (0, 0)), ("", (0.4, 0.25)), ("", (0.5, 0.25))], "is where the slider would be"),
        ("slider", [("knee", (0, 0)), ("", (0.3, 0.4)), ("", (0.301, 0.4))], NO_DIRECTION),
        ("wheel", [], "must be one of: point, pin, slider_pin, eccentric, pair"),
    ],
)
def test_what_no_part_can_be_made_of_is_refused(name, clicks, said):
    with pytest.raises(InputError, match="addition") as caught:
        added(text_of(), name, 0.0, *clicks)
    assert said in str(caught.value)


def test_where_links_cannot_close_nothing_hangs_on_them():
    """The pitman is too short beyond some angle: its knee is nowhere there, and its links are not either."""
    text = text_of().replace('"320 mm"', '"260 mm"')
    assert np.isnan(pins_of(text, 180.0)["knee"]).all()
    for name, *clicks in (("point", ("lower", (0.4, 0.0))), ("slider", *ALL[4][1:])):
        with pytest.raises(InputError, match=NOWHERE_HERE):
            added(text, name, 180.0, *clicks)


def test_links_that_nothing_drives_are_refused_by_the_machine():
    text = added(
        added(text_of(), "pin", 0.0, ("", (0.1, 0.4))), "pair", 0.0, ("C", (0, 0)), ("", (0.3, 0.5)), ("D", (0, 0))
    )
    with pytest.raises(InputError, match=r"mechanism\.part\[2\].*is not driven"):
        machine_of(text)


def test_a_click_takes_what_is_drawn():
    machine = machine_of(text_of())
    additions = {one.name: one for one in drawn_additions(machine, first_throw(machine))}
    assert list(additions) == [
        "point", "pin", "slider_pin", "eccentric", "pair", "swivel", "slider", "yoke", "trammel", "triad",
    ]  # fmt: skip
    assert {one.mechanism for one in additions.values()} == {"1"}
    (where,) = additions["pin"].clicks
    assert [(one.name, one.pins) for one in where.targets] == [
        ("pitman", ("main.pin", "knee")), ("upper", ("C", "knee")), ("lower", ("knee", "ram.pin")), ("", ()),
    ]  # fmt: skip
    assert [str(one.words) for one in where.targets] == [
        "pin on pitman", "pin on upper", "pin on lower", "fixed point",
    ]  # fmt: skip
    start, joint, _end = additions["pair"].clicks
    assert [one.pins for one in start.targets] == [(name,) for name in ("O", "C", "main.pin", "knee", "ram.pin")]
    assert [one.pins for one in joint.targets] == [()]
    other = ct.Machine(mechanism={"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "130 mm"})
    assert drawn_additions(other, first_throw(other)) == ()


@pytest.mark.parametrize("lie", LIE)
@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("part", [0.13, 0.37, 0.5, 0.8, -0.3, 1.4])
def test_links_that_are_clicked_in_line_meet_there_when_they_are_typed(lie, angle, part):
    """Both lengths are rounded, and still reach; by a step or two in line, the joint lies off it by their root."""
    text, lying = text_of(*lie), Lying(*lie)
    start, end = np.array(lying.crank(angle)), np.array(lying.at(*PIVOT))
    at = start + part * (end - start)
    after = added(text, "pair", angle, ("main.pin", (9.0, 9.0)), ("", tuple(at)), ("C", (0.0, 0.0)))
    off = np.sqrt(4.0 * lying.step * away(start, end)) + 4.0 * lying.step
    assert away(pins_of(after, angle)["B"], at) < off
