"""Every key of the machine file has an example that may stand there."""

from typing import Annotated, get_args

import pytest
from tests.sentences import A_NUMBER
from tests.told import problems_told

from cranktrain import fluids
from cranktrain.declared_types import quantity_of
from cranktrain.errors import InputError
from cranktrain.layout.load_tables import LoadSpec
from cranktrain.machine import Machine
from cranktrain.quantities import Quantity
from cranktrain.quantities.examples import EXAMPLES
from cranktrain.spec import Spec, validated
from cranktrain.when_given import Deferred

SLIDER = {"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "136 mm"}


def parts(annotation):
    yield annotation
    for part in get_args(annotation):
        yield from parts(part.annotation if isinstance(part, Deferred) else part)


def quantities(spec=Machine, seen=None):
    """Key and quantity of every field, of every table that may stand in a machine file."""
    seen = set() if seen is None else seen
    seen.add(spec)
    for name, field in spec.model_fields.items():
        declared = list(parts(Annotated[field.annotation, *field.metadata] if field.metadata else field.annotation))
        for part in declared:
            if isinstance(part, Quantity):
                yield field.alias or name, part
            elif isinstance(part, type) and issubclass(part, Spec) and part not in seen:
                yield from quantities(part, seen)


FIELDS = sorted(set(quantities()), key=repr)


@pytest.mark.parametrize(("key", "quantity"), FIELDS)
def test_example_may_stand_where_it_is_offered(key, quantity):
    of_key = quantity.of_field(key)
    example = of_key.example or quantity.dimension.example
    assert of_key.given(example).text == example
    assert str(of_key.expected).endswith(f"such as {example}")


def test_every_number_without_a_unit_has_an_example_of_its_own():
    ratios = {key for key, quantity in FIELDS if not quantity.dimension.needs_unit}
    assert ratios <= set(EXAMPLES)
    assert set(EXAMPLES) <= {key for key, _quantity in FIELDS}


GENERAL = (
    *(
        "acceleration",
        "angle",
        "backward",
        "bore",
        "change_time",
        "crank_zero",
        "density",
    ),
    *(
        "first_speed",
        "fixed",
        "flywheel",
        "flywheel_moment",
        "forward",
        "frequency",
        "inertia",
    ),
    *(
        "last_speed",
        "length",
        "mass",
        "molar_mass",
        "near",
        "no_load_speed",
    ),
    *("permissible_pressure_angle", "phase", "place", "planes", "ramp_time", "rated_current", "rotor_resistance"),
    *("shift", "speed", "stiffness", "stroke", "synchronous_speed", "voltage", "z"),
)
"""Keys that the example of their dimension suits: 90 mm for a bore, 1500 rpm for a speed."""


def test_no_key_has_an_example_that_only_its_dimension_explains():
    """A new key gets an example of its own in EXAMPLES, or is looked at and named here."""
    assert {key for key, quantity in FIELDS if quantity.of_field(key).example is None} == set(GENERAL)


def from_examples(spec, *keys):
    """A table in which every number that it may have, or each of some, is the example that messages give."""
    found = dict(quantities(spec, set()))
    return {key: found[key].of_field(key).example or found[key].dimension.example for key in keys or found}


@pytest.mark.parametrize("fluid", fluids.KINDS, ids=lambda fluid: fluid.name)
def test_examples_of_a_fluid_make_one(fluid):
    """Together they are a table that may stand in a file, of a machine as they are built."""
    told = from_examples(fluid.spec)
    text = {"file": "card.csv"} if fluid.name == "indicator" else {}
    own = {key for key, field in fluid.spec.model_fields.items() if quantity_of(Annotated[field.annotation, field])}
    table = {key: value for key, value in told.items() if key in own}
    made = validated(fluid.spec, {"kind": fluid.name, **table, **text})
    exponents = [getattr(made, key).si for key in table if key.endswith("exponent")]
    assert all(1.2 < exponent < 1.4 for exponent in exponents)
    if fluid.name == "compressor":
        assert made.discharge_pressure.si > made.suction_pressure.si
    elif fluid.name != "indicator":
        assert made.exhaust_pressure.si > made.inlet_pressure.si


@pytest.mark.parametrize(
    ("tables", "keys"),
    [
        ({"on": "piston"}, ("force", "at_speed", "exponent")),
        ({"on": "rod", "sense": "active"}, ("force", "along", "across", "direction")),
        ({"on": "crank"}, ("torque", "at_turning", "exponent")),
    ],
)
def test_examples_of_a_load_make_one(tables, keys):
    told = from_examples(LoadSpec, *keys)
    assert told.get("exponent", "2") == "2"  # a fan's, no gas's
    validated(LoadSpec, tables | told)


def test_a_list_is_shown_how_it_is_written():
    found = refused(mechanism=SLIDER, load={"die": {"on": "piston", "force": ["1 kN"], "force_back": "1 kN"}})
    assert found["load.die.force_back"].allowed == 'must be a list in [ ], such as ["500 N", …]'
    found = refused(mechanism=SLIDER, shaft={"main": {"throws": "120"}})
    assert found["shaft.main.throws"].allowed == 'must be a list in [ ], such as ["120 deg", …]'


def refused(**tables):
    with pytest.raises(InputError) as caught:
        validated(Machine, tables)
    return {problem.path: problem for problem in problems_told(caught.value.problems)}


@pytest.mark.parametrize(
    ("given", "repair"),
    [
        (0.28, 'write "0.28 m" or "0.28 mm"'),
        ("1/4", 'write "1/4 m" or "1/4 mm"'),
        ("1,5", 'write "1.5 m" or "1.5 mm"'),
        (280, 'write "280 mm"'),
    ],
)
def test_a_length_without_its_unit_is_offered_in_metres_where_it_may_be(given, repair):
    found = refused(mechanism={**SLIDER, "crank_radius": given})
    assert found["mechanism.crank_radius"].repair == repair


def test_examples_suit_the_key():
    found = refused(mechanism=SLIDER, gas={"kind": "otto", "start_pressure": "x", "compression_exponent": "x"})
    assert found["gas.compression_exponent"].allowed == f"{A_NUMBER}, such as 1.35"
    assert found["gas.expansion_exponent"].allowed == f"is missing; {A_NUMBER}, such as 1.28"
    assert found["gas.start_pressure"].allowed.endswith("such as 95 kPa")
    found = refused(mechanism=SLIDER, friction={"piston": "x"}, cylinder={"clearance": {"value": "x"}})
    assert found["friction.piston"].allowed == f"{A_NUMBER}, such as 0.08"
    assert found["cylinder.clearance.value"].allowed == f"{A_NUMBER}, such as 8 %"


def test_the_other_way_to_weigh_a_rod_is_named():
    machine = Machine(mechanism=SLIDER, masses={"rod": {"mass": "1 kg"}})
    allowed = {problem.path: problem.allowed for problem in problems_told(machine.table_problems)}
    assert allowed == {"masses.rod.along": "is missing; give it, or big_end and small_end"}
