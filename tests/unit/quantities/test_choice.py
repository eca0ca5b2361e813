"""Units that a reader chooses: by name, by the file's own habit, and back to the usual ones."""

import numpy as np
import pytest

from cranktrain.errors import InputError
from cranktrain.quantities import (
    Dimension,
    FileUnits,
    asked_unit,
    chosen_unit,
    own_units,
    shown_as_in,
    shown_by,
    units_by_dimension,
)
from cranktrain.quantities.dimensions import plain, spellings
from cranktrain.saying.scales import SCALES, in_asked_unit, scale_for
from cranktrain.saying.wording import number


def test_a_choice_holds_for_a_while():
    assert str(number(689475.729, "bar")) == "6.895 bar"
    with shown_by(units_by_dimension(["psi", "in"])):
        # 1 psi = 6894.757293 Pa
        assert str(number(689475.729, "bar")) == "100.0 psi"
        assert str(number(0.0254, "mm")) == "1.000 in"
        assert str(number(1000.0, "kW")) == "1.00 kW"
        with shown_by({Dimension.LENGTH: "ft"}):
            assert (chosen_unit("mm"), chosen_unit("bar")) == ("ft", "psi")
    assert chosen_unit("mm") is None


@pytest.mark.parametrize(
    ("unit", "size", "label", "value"),
    [("N", 9.80665, "kgf", 1.0), ("Pa", 98066.5, "at", 1.0), ("W", 735.49875, "PS", 1.0), ("kg", 1.0, "kg", 1.0)],
)
def test_scales_follow(unit, size, label, value):
    with shown_by(units_by_dimension(["kgf", "at", "PS"])):
        scale = scale_for(unit, size)
        assert (scale.label, float(scale.of(size))) == (label, pytest.approx(value, rel=1e-15))


def test_a_unit_of_two_quantities_stands_for_both():
    assert set(units_by_dimension(["kgf·m"])) == {Dimension.TORQUE, Dimension.ENERGY}


@pytest.mark.parametrize(
    ("names", "said"),
    [
        (["bqr"], "--units = bqr: must be units with commas between, such as bar,kW,in; did you mean bar?"),
        (["psi", "bar"], "--units = bar: must not stand beside psi, of the same"),
        ([""], "--units"),
    ],
)
def test_refused(names, said):
    with pytest.raises(InputError) as caught:
        units_by_dimension(names)
    assert said in str(caught.value)


def test_a_file_in_inches_is_shown_in_inches():
    """A maker's unit of 49.524 in of stroke; gauge pressures are shown absolute, in the same unit."""
    assert own_units(["60 psig", "1 bar", "75 psig"]) == {Dimension.PRESSURE: "psi"}
    assert own_units(["60 psig", "2 bar", "2 bar", "70 psi", "80 psig"]) == {Dimension.PRESSURE: "psi"}
    assert own_units(["180 mm", "4 in", "320 mm", "1500 rpm", "2 barg"]) == {}


@pytest.mark.parametrize(
    ("texts", "own"),
    [
        (["90 kPa", "106 kPa", "2 bar"], {Dimension.PRESSURE: "kPa"}),
        (["0.9 bar", "106 kPa", "2 bar"], {}),
        (["0.9 bar", "106 kPa"], {}),
        (["18 cm", "32 cm", "5 mm"], {Dimension.LENGTH: "cm"}),
        (["157 rad/s"], {Dimension.SPEED: "rad/s"}),
        (["1600 kN", "20 MJ", "3 kW", "250 cm³"], {}),
        (["3 tf", "20 kN", "2 tf"], {Dimension.FORCE: "tf"}),
        (["0 rev", "1/3 rev", "2/3 rev", "5 %"], {}),
    ],
)
def test_a_file_is_shown_in_the_units_in_which_most_of_it_stands(texts, own):
    """What goes by its size, N or kN, goes on to; angles stay in degrees; the usual unit wins a tie."""
    assert own_units(texts) == own


def test_a_reader_is_before_the_table_and_that_before_the_habit_of_a_file():
    file = FileUnits(units_by_dimension(["cm", "psi"]), own_units(["4 in", "2 lb"]))
    with shown_as_in(file), shown_by(units_by_dimension(["at"])):
        assert [chosen_unit(usual) for usual in ("mm", "bar", "kg")] == ["cm", "at", "lb"]
        assert [asked_unit(usual) for usual in ("m", "Pa", "kg")] == ["cm", "at", None]
    assert chosen_unit("mm") is None


def test_derivatives_by_the_crank_angle_are_in_the_unit_of_what_they_are_of():
    """0.0254 m is one inch; crank angles stay in degrees."""
    with shown_by(units_by_dimension(["in", "rad"])):
        assert scale_for("m/rad^2", 1.0).label == "in/rad²"
        assert float(scale_for("m/rad", 1.0).of(0.0254)) == pytest.approx(1.0, rel=1e-15)
        assert [scale_for(unit, 1.0).label for unit in ("rad", "position", "deg")] == ["rad", "°", "°"]
        assert in_asked_unit("m/rad^2", np.array([0.0254])) == ("in/rad^2", pytest.approx([1.0], rel=1e-15))


def test_what_an_answer_shows_can_be_typed():
    """But for capacities, which no file has."""
    known = {spelling for dimension in Dimension for spelling in spellings(dimension)}
    shown_in = {scale.label for scales in SCALES.values() for scale in scales if scale.label}
    assert {label for label in shown_in if plain(label) not in known} == {"kW/(m³/min)"}


@pytest.mark.parametrize("unit", ["psig", "ati", "barg"])
def test_no_pressure_is_shown_from_the_atmosphere(unit):
    """A mean pressure of 5 bar is no 4 bar gauge."""
    with pytest.raises(InputError, match=f"--units = {unit}: counts from the atmosphere, which mean pressures do not"):
        units_by_dimension([unit])


def test_no_inertia_is_shown_as_a_flywheel_moment():
    """J in kg·m² and GD² in kgf·m² are the same number of two things: a choice of the one must not name the other."""
    assert units_by_dimension(["kg·m²"]) == {Dimension.INERTIA: "kg·m²"}
    with pytest.raises(InputError, match=r"--units = kgf·m²: must be units"):
        units_by_dimension(["kgf·m²"])


def test_of_units_as_frequent_as_each_other_one_is_taken_whatever_their_order():
    """As the tables of a file may stand in any order."""
    one, other = (own_units(texts) for texts in (["4 in", "2 ft"], ["2 ft", "4 in"]))
    assert one == other != {}
