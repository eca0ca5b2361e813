"""Every key of the machine file has an example that may stand there."""

from typing import Annotated, get_args

import pytest
from tests.sentences import A_NUMBER

from cranktrain.errors import InputError
from cranktrain.machine import Machine
from cranktrain.quantities import Quantity
from cranktrain.quantities.examples import EXAMPLES
from cranktrain.spec import Spec, validated

SLIDER = {"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "136 mm"}


def parts(annotation):
    yield annotation
    for part in get_args(annotation):
        yield from parts(part)


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
    assert of_key.expected.endswith(f"such as {example}")


def test_every_number_without_a_unit_has_an_example_of_its_own():
    ratios = {key for key, quantity in FIELDS if not quantity.dimension.needs_unit}
    assert ratios <= set(EXAMPLES)
    assert set(EXAMPLES) <= {key for key, _quantity in FIELDS}


def refused(**tables):
    with pytest.raises(InputError) as caught:
        validated(Machine, tables)
    return {problem.path: problem for problem in caught.value.problems}


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
    allowed = {problem.path: problem.allowed for problem in machine.table_problems}
    assert allowed == {"masses.rod.along": "is missing; give it, or big_end and small_end"}
