"""Every unit that may be chosen, for every result: the number that is shown is that of [pint], wherever it is shown."""

import numpy as np
import pint
import pytest
from tests.stages import EVERY_STAGE

from cranktrain.panels.shapes import Curve, Panel, as_shown
from cranktrain.quantities import SHOWN, counted_from, shown_by, unit_names, units_by_dimension
from cranktrain.saying.amounts import figures
from cranktrain.saying.catalogue import entries
from cranktrain.saying.scales import SCALES, in_asked_unit, scale_for
from cranktrain.saying.wording import number

OF_PINT = {
    **{name: name for name in ("mm", "cm", "m", "ft", "rad", "rad/s", "m/s", "mm/s", "ft/s", "N", "kN", "kgf")},
    **{name: name for name in ("kPa", "Pa", "MPa", "GPa", "bar", "atm", "psi", "kg", "g", "t", "lb", "kW", "W")},
    **{name: name for name in ("N/mm", "kN/mm", "N/m", "J", "kJ", "MJ", "K", "s", "ms", "min", "h", "A", "kA")},
    **{name: name for name in ("V", "kV", "W/m²/K", "kW/m²/K", "kg/m³", "g/cm³", "m/s²", "cm/s²", "ft/s²", "rad/s²")},
    "%": "0.01",
    "in": "inch",
    "cm²": "cm²",
    "mm²": "mm²",
    "m²": "m²",
    "in²": "inch²",
    "L": "L",
    "cm³": "cm³",
    "in³": "inch³",
    "m³": "m³",
    "deg": "degree",
    "rev": "turn",
    "rpm": "turn/min",
    "deg/s²": "degree/s²",
    "rpm/s": "turn/min/s",
    "tf": "1000 kgf",
    "lbf": "lbf",
    "N·m": "N*m",
    "kN·m": "kN*m",
    "kgf·m": "kgf*m",
    "lbf·ft": "lbf*ft",
    "lbf·in": "lbf*inch",
    "ft·lbf": "ft*lbf",
    "at": "kgf/cm²",
    "kg·m²": "kg*m²",
    "lb·ft²": "lb*ft²",
    "hp": "550 ft*lbf/s",
    "PS": "75 kgf*m/s",
    "MN·m/rad": "MN*m/rad",
    "kN·m/rad": "kN*m/rad",
    "MN·m²": "MN*m²",
    "kN·m²": "kN*m²",
    "lbf·in²": "lbf*inch²",
    "Pa·m⁴": "Pa*m**4",
    "N·m/rad": "N*m/rad",
    "N·m/deg": "N*m/degree",
    "kgf·m/rad": "kgf*m/rad",
    "lbf·in/rad": "lbf*inch/rad",
    "°C": "degC",
    "Hz": "turn/s",
    "kHz": "1000 turn/s",
    "1/min": "turn/min",
    "1/h": "turn/h",
    "Ω": "ohm",
    "mΩ": "mohm",
    **{name: name for name in ("m³/h", "m³/min", "m³/s", "L/min", "L/s", "kg/h", "kg/min", "kg/s", "lb/h", "lb/min")},
    "cfm": "ft³/min",
    "gpm": "gallon/min",
    "t/h": "1000 kg/h",
    "g/mol": "g",
    "kg/mol": "kg",
}
"""What each unit of the list is to pint. A frequency among results is that of a vibration, in rad/s: turns of it."""

MEASURES = {
    "m": "mm",
    "m/s": "m/s",
    "m/s^2": "m/s²",
    "m^3": "L",
    "rad": "deg",
    "rpm": "rpm",
    "rad/s": "rpm",
    "rad/s^2": "rad/s²",
    "Hz": "Hz",
    "N": "N",
    "N*m": "N·m",
    "N*m/rad": "N·m/rad",
    "Pa": "bar",
    "W": "W",
    "J": "J",
    "kg": "kg",
    "kg*m^2": "kg·m²",
    "K": "K",
    "m^3/s": "m³/h",
    "kg/s": "kg/h",
    "s": "s",
    "m^2": "cm²",
    "%": "%",
    "error": "%",
    "off": "%",
    "m/rad": "mm",
    "m/rad^2": "mm",
    "Pa/rad": "bar",
    "kg*m^2/rad": "kg·m²",
}
"""By a unit of the catalogue or of rows: a unit of the dimension that it is of, or of what is derived by an angle."""

OF_NONE = {"deg", "position", "1", "number", "J/m^3", "kg*m", "N*m^2", "rad/rad", "rad/rad^2"}
"""Crank angles, numbers, and what no machine file has: in no unit but their own."""

EVERY = {one.name: one for stage in EVERY_STAGE for one in entries(stage.gives)}

NAMES = {one.shown for one in EVERY.values()} | set(SCALES)
"""By which a unit is found for people."""

UNITS = list(dict.fromkeys(name for one in SHOWN for name in unit_names(one) if counted_from(name) is None))

SIZE = 17000.0
"""A value in SI, for which no unit of the list is too large."""

DERIVED = ("m/rad", "m/rad^2", "Pa/rad", "kg*m^2/rad")
"""By an angle: in the unit of what they are of."""


@pytest.fixture(scope="module")
def si_of():
    registry = pint.UnitRegistry()

    def si_of_one(unit):
        """What one of a unit is in SI and radians."""
        return float(registry.Quantity(registry.parse_expression(OF_PINT[unit])).to_base_units().magnitude)

    return si_of_one


def expected(si_of, unit, value):
    """What an SI value is in a unit; a temperature counts from where ice melts."""
    return value - 273.15 if unit == "°C" else value / si_of(unit)


def unit_of(chosen, name):
    """Unit that is chosen for what is shown by a name, of the catalogue or of rows; None for what has its own alone.

    One of two quantities has for each its own name: ft·lbf of a torque is lbf·ft.
    """
    of = None if name in OF_NONE else next(one for one in SHOWN if MEASURES[name] in unit_names(one))
    return chosen.get(of)


def test_every_unit_and_every_name_is_asked_about():
    assert set(UNITS) == OF_PINT.keys(), "add the unit to OF_PINT above, as pint spells it"
    assert MEASURES.keys() | OF_NONE == NAMES, (
        "say in MEASURES above in which unit the quantity is measured, or that it is OF_NONE"
    )


@pytest.mark.parametrize("name", sorted(NAMES))
@pytest.mark.parametrize("unit", UNITS)
def test_every_result_in_it(si_of, unit, name):
    """In pictures, in rows and tables of the screen: one number, and the unit behind it."""
    chosen = units_by_dimension([unit])
    usual = scale_for(name, SIZE)
    with shown_by(chosen):
        scale = scale_for(name, SIZE)
        panel = as_shown(Panel("", name, np.zeros(1), (Curve(np.full(1, SIZE), "", "exact"),)))
        table = figures(np.array([SIZE]), name)
    if unit_of(chosen, name) is None:
        assert scale == usual
    else:
        in_it = expected(si_of, unit, SIZE)
        assert scale.label == unit_of(chosen, name) + end_of(name).replace("^2", "²")
        assert float(scale.of(SIZE)) == pytest.approx(in_it, rel=1e-14)
        assert number_of(table.texts[0]) == pytest.approx(in_it, rel=6e-4)
    assert panel.values.item() == float(scale.of(SIZE))
    assert panel.unit == table.unit == scale.label


@pytest.mark.parametrize("unit", UNITS)
def test_every_result_written_in_it(si_of, unit):
    chosen = units_by_dimension([unit])
    for name, entry in EVERY.items():
        with shown_by(chosen):
            label, value = in_asked_unit(entry.unit, np.array([SIZE]), entry.shown)
        if own := unit_of(chosen, entry.shown) or unit_of(chosen, entry.unit):
            assert label == own + end_of(entry.unit), name
            assert value.item() == pytest.approx(expected(si_of, unit, SIZE), rel=1e-14), name
        else:
            assert (label, value.item()) == (entry.unit, SIZE), name


@pytest.mark.parametrize("usual", sorted(set(MEASURES.values())))
@pytest.mark.parametrize("unit", UNITS)
def test_every_sentence_in_it(si_of, unit, usual):
    """Sentences name units by their usual names."""
    own = next((name for of, name in units_by_dimension([unit]).items() if usual in unit_names(of)), None)
    if own:
        with shown_by(units_by_dimension([unit])):
            said, label = str(number(SIZE, usual)).rsplit(" ", 1)
        assert label == own
        assert number_of(said) == pytest.approx(expected(si_of, unit, SIZE), rel=6e-4)


def end_of(name):
    """What a derivative has behind the unit of what it is of."""
    return "".join(name.partition("/rad")[1:]) if name in DERIVED else ""


def number_of(text):
    """A number as it is printed."""
    return float(text.replace("−", "-"))
