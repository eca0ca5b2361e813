"""What the examples say of right and left, above and below is so in their drawings, X to the right and Y up."""

from importlib.resources import files

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.plans.placement import placed, shaft_places

TURN = np.radians(np.arange(360.0))


class Drawn:
    """An example's pins over a turn of its crank, from the centre of the main shaft."""

    def __init__(self, name):
        self.machine = ct.load(name)
        self.places = {place.name: place for place in self.machine.places}
        self.drawings = {}

    def pin(self, name, place=None):
        """X and Y of a pin over the turn, and their derivatives by the crank angle."""
        if place is None:
            place = next(iter(self.places))
        if place not in self.drawings:
            angle = TURN + self.machine.zero
            self.drawings[place] = placed(self.machine, self.places[place], angle).pins
        x, y = self.drawings[place][name]
        centre = shaft_places(self.machine).centres[self.places[place].shaft]
        return x.value + centre[0], y.value + centre[1], x.first, y.first

    def x(self, name, place=None):
        return self.pin(name, place)[0]

    def y(self, name, place=None):
        return self.pin(name, place)[1]


def shaper(drawn):
    assert np.all(drawn.y("C") < 0)  # "pivot below the shaft"
    assert np.all(drawn.y("D") > drawn.y("C"))  # "upper end drives the ram"
    assert np.ptp(drawn.y("ram.pin")) < 1e-12  # a line of stroke along X
    assert np.all(drawn.x("ram.pin") > drawn.x("D"))  # to the right of the lever


def toggle_press(drawn):
    assert np.all(drawn.x("C") > 0)  # at +400 mm of the file's x
    assert np.all(drawn.y("C") > 0)  # at +250 mm of its y
    assert np.all(drawn.y("C") > drawn.y("knee"))  # "whose upper link hangs on the frame"
    assert np.all(drawn.y("knee") > drawn.y("ram.pin"))  # "and whose lower link drives the ram"
    lowest = np.argmin(drawn.y("ram.pin"))
    straight = np.argmin(np.abs(drawn.x("knee") - drawn.x("C")))
    assert abs(lowest - straight) < 5 or abs(lowest - straight) > 355  # "near its lowest point, where the knee is ..."


def jaw_crusher(drawn):
    assert np.all(drawn.y("B") < drawn.y("C"))  # the jaw's end, below the toggle's seat
    assert np.all(drawn.y("B") < -0.9)  # and well below the shaft on which the jaw hangs
    assert drawn.x("C")[0] == pytest.approx(45.3e-3, abs=1e-9)
    assert drawn.y("C")[0] == pytest.approx(-815.7e-3, abs=1e-9)


def tilting_table(drawn):
    assert np.all(drawn.x("C") > 0)  # "to the right of the shaft"
    assert np.ptp(drawn.y("C")) < 1e-12
    assert np.all(drawn.y("B") > 0)  # the rocker stands up


def eccentric_press(drawn):
    assert np.all(drawn.y("B") < drawn.y("A"))
    far = np.argmax(np.hypot(drawn.x("B"), drawn.y("B")))
    assert far == np.argmin(drawn.y("B"))  # "top in the words of engines, is the press's lower dead centre"


def pumping_unit(drawn):
    assert drawn.x("C")[0] == pytest.approx(56 * 0.0254, abs=1e-12)  # "56 in to the right"
    assert drawn.y("C")[0] == pytest.approx(68 * 0.0254, abs=1e-12)  # "68 in up"
    assert drawn.y("A")[0] == pytest.approx(21 * 0.0254, abs=1e-12)  # "clockwise from twelve o'clock"
    assert drawn.x("A")[90] == pytest.approx(21 * 0.0254, abs=1e-12)
    line = np.array([drawn.x("C") - drawn.x("A"), drawn.y("C") - drawn.y("A")])
    tail = np.array([drawn.x("B") - drawn.x("A"), drawn.y("B") - drawn.y("A")])
    assert np.all(line[0] * tail[1] - line[1] * tail[0] > 0)  # "to the left of a line from crank pin to saddle"
    assert np.all(drawn.x("B") < drawn.x("C"))  # so the horsehead is on the right, with the well
    swing = np.gradient(np.unwrap(np.arctan2(drawn.x("B") - drawn.x("C"), drawn.y("B") - drawn.y("C"))))
    tail_rises = drawn.pin("B")[3] > 0
    assert np.array_equal(swing[5:-5] > 0, tail_rises[5:-5])  # clockwise: the tail goes up and the horsehead down


def to_the_right(drawn):
    """A cylinder to the right of the shaft; a clockwise crank then goes down from there, and y points down."""
    for place in drawn.places.values():
        if place.kind.name == "slider_crank":
            assert np.all(drawn.x("B", place.name) > 0)
            assert np.ptp(drawn.y("B", place.name)) < 1e-12


def lms_class5(drawn):
    to_the_right(drawn)
    assert drawn.pin("A", "1cylinder")[3][0] < 0  # from the dead centre toward +y: downward
    assert np.all(drawn.y("valve.pin", "1valve") > drawn.y("B", "1cylinder"))  # "steam chest above the cylinder"
    assert drawn.y("return.pin", "1valve")[0] > 0 > drawn.y("main.pin", "1valve")[90]  # the return crank follows
    # Right side and left of an engine that runs to the right: the nearer one, at the free end, is the right one.
    one, two = (np.array([drawn.x("A", place)[0], drawn.y("A", place)[0]]) for place in ("1cylinder", "2cylinder"))
    assert two[0] * one[1] - two[1] * one[0] < 0  # clockwise from throw 2 to throw 1: throw 1 leads
    assert drawn.machine.rotation == "clockwise"


def traction_engine(drawn):
    to_the_right(drawn)
    over = np.argmax(drawn.y("A", "1cylinder"))
    assert drawn.pin("A", "1cylinder")[2][over] > 0  # at the top of its circle the pin goes toward the cylinder
    assert drawn.pin("A", "1cylinder")[3][0] < 0  # "y points down": it leaves the dead centre so
    assert np.all(drawn.y("arm_end", "1valve") > drawn.y("saddle", "1valve"))  # "its arm's end above the link"
    assert drawn.x("arm_end", "1valve")[0] < drawn.x("reverse_shaft", "1valve")[0]  # "toward the crankshaft"


def upright_between_two_shafts(drawn):
    upper = shaft_places(drawn.machine).centres["upper"]
    assert upper[0] == 0.0
    assert upper[1] > 0  # "the lower one" is main
    for name in drawn.places:
        own, other = ("exhaust", "scavenge") if name.endswith("exhaust") else ("scavenge", "exhaust")
        away = drawn.y("B", name) - drawn.y("B", name.replace(own, other))
        assert np.all(away < 0) if own == "exhaust" else np.all(away > 0)  # exhaust pistons below, scavenge above


def deltic(drawn):
    centres = shaft_places(drawn.machine).centres
    assert centres["right"][0] > 0  # main "top left", right
    assert centres["right"][1] == 0
    assert centres["bottom"][1] < 0
    sides = [
        np.hypot(*(centres[a] - centres[b])) for a, b in (("main", "right"), ("right", "bottom"), ("bottom", "main"))
    ]
    assert np.ptp(sides) < 1e-6  # "an equilateral triangle"


def v12(drawn):
    assert np.all(drawn.x("B", "1L") < 0)
    assert np.all(drawn.x("D", "1R") > 0)  # the slave piston's pin


def kamaz(drawn):
    assert np.all(drawn.x("B", "1R") < 0)  # "Seen from the front, the engine's right side is at the left."
    assert np.all(drawn.x("B", "1L") > 0)


def ls3(drawn):
    assert np.all(drawn.x("B", "1L") > 0)  # "the engine's left side is at the right"
    assert np.all(drawn.x("B", "1R") < 0)


STANDING = {
    "shaper": ("x, points to the right", "pivot below the shaft", shaper),
    "toggle_press": ("the file's x points to the right, y up", "whose upper link hangs on the frame", toggle_press),
    "jaw_crusher": ("45.3 mm to the right and 815.7 mm down", "The jaw's lower end", jaw_crusher),
    "shears": ("blade below the shaft", "", eccentric_press),
    "shaking_conveyor": ("the trough lies to the right", "", to_the_right),
    "high_slip_press": ("ram below the shaft", "", eccentric_press),
    "eccentric_press": ("ram below the shaft", "press's lower dead centre", eccentric_press),
    "servo_press": ("ram below the shaft", "press's lower dead centre", eccentric_press),
    "servo_press_rocking": ("ram below the shaft", "press's lower dead centre", eccentric_press),
    "tilting_table": ("the rocker's pivot lies to the right of the shaft", "", tilting_table),
    "pumping_unit_c57": ("56 in to the right and 105 - 37 = 68 in up", "well on the right", pumping_unit),
    "lms_class5": ("to the right; y points down", "throw 1 is on the right side", lms_class5),
    "traction_engine": (
        "goes over toward the cylinder; y points down",
        "its arm's end above the link",
        traction_engine,
    ),
    "great_northern": ("lies ahead of the drivers, to the right", "", to_the_right),
    "mud_pump_12p160": ("the liners lie to the right", "", to_the_right),
    "gas_compressor": ("the cylinder lies to the right", "", to_the_right),
    "10d100": ("upright between two shafts", "lower shaft works the exhaust", upright_between_two_shafts),
    "38d8": ("# the lower one", "", upright_between_two_shafts),
    "jumo_205": ("upright between two shafts", "# the lower one", upright_between_two_shafts),
    "jumo_205e": ("# the lower one", "", upright_between_two_shafts),
    "deltic": ("# top left, seen from the free end", "an equilateral triangle", deltic),
    "3d12": ("The right bank is reached 60 deg after the left one", "", v12),
    "ls3": ("the engine's left side is at the right", "", ls3),
    "mill_engine": ("lies to the right; the crank goes over toward it", "", to_the_right),
    "kamaz_740": ("the engine's right side is at the left", "", kamaz),
}
UPRIGHT = {
    "compressor_start",
    "3d12_fit_85_235",
    "burning_cylinder",
    "3d12_quoted_rods",
    "40d",
    "inline_six",
    "m_50",
    "m_503",
    "r_1340",
    "textbook_78x78",
    "two_throw_compressor",
    "vaz_21213",
}
"""Examples that say nothing of where things are: their first cylinder, or the middle of a V, stands upright."""


@pytest.mark.parametrize("name", STANDING)
def test_an_example_stands_as_its_words_say(name):
    text = files("cranktrain.examples").joinpath(f"{name}.toml").read_text(encoding="utf-8")
    *words, holds = STANDING[name]
    assert [said for said in words if said not in text] == []
    holds(Drawn(name))


@pytest.mark.parametrize("name", sorted(UPRIGHT))
def test_an_example_without_words_stands_upright(name):
    drawn = Drawn(name)
    firsts = {place.bank: place.name for place in reversed(drawn.places.values())}
    heights = [
        np.min(drawn.y("B", place)) for place in firsts.values() if drawn.places[place].kind.name == "slider_crank"
    ]
    assert min(heights) > 0


def test_every_example_is_looked_at():
    names = {
        path.name.removesuffix(".toml")
        for path in files("cranktrain.examples").iterdir()
        if path.name.endswith(".toml")
    }
    assert names == STANDING.keys() | UPRIGHT
