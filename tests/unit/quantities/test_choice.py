"""Units that a reader chooses: by name, by the file's own habit, and back to the usual ones."""

import pytest

from cranktrain.errors import InputError
from cranktrain.quantities import Dimension, chosen_unit, own_units, shown_by, units_by_dimension
from cranktrain.scales import scale_for
from cranktrain.wording import number


def test_a_choice_holds_for_a_while():
    assert number(689475.729, "bar") == "6.895 bar"
    with shown_by(units_by_dimension(["psi", "in"])):
        # 1 psi = 6894.757293 Pa
        assert number(689475.729, "bar") == "100.0 psi"
        assert number(0.0254, "mm") == "1.000 in"
        assert number(1000.0, "kW") == "1.00 kW"
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
    assert own_units(["180 mm", "4 in", "320 mm", "1500 rpm", "105 kPa"]) == {}


def test_no_inertia_is_shown_as_a_flywheel_moment():
    """J in kg·m² and GD² in kgf·m² are the same number of two things: a choice of the one must not name the other."""
    assert units_by_dimension(["kg·m²"]) == {Dimension.INERTIA: "kg·m²"}
    with pytest.raises(InputError, match=r"--units = kgf·m²: must be units"):
        units_by_dimension(["kgf·m²"])
