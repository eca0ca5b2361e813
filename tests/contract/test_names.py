"""Names from a file stand in CSV: in no table can one be given that a spreadsheet takes for a formula."""

from collections.abc import Mapping
from typing import Annotated, get_args, get_origin

import pytest

import cranktrain as ct
from cranktrain.allowed import Name
from cranktrain.errors import InputError
from cranktrain.machine import Machine
from cranktrain.spec import Spec
from cranktrain.when_given import Deferred

ELSEWHERE = {"units": "what is measured", "overrides": "banks and cylinders, which have names of letters and digits"}
"""Fields whose keys are no new names, and what they are."""

NAME_METADATA = get_args(Name)[1]


def tables_of(annotation):
    """Specs and mappings that a declared type is made of."""
    if (isinstance(annotation, type) and issubclass(annotation, Spec)) or get_origin(annotation) is Mapping:
        yield annotation
    for part in get_args(annotation):
        yield from tables_of(part.annotation if isinstance(part, Deferred) else part)


def every_mapping():
    """Every field of a machine's tables whose keys are names, with the declared type of a key."""
    waiting, seen, found = [Machine], set(), {}
    while waiting:
        spec = waiting.pop()
        if spec in seen:
            continue
        seen.add(spec)
        for name, field in spec.model_fields.items():
            for one in tables_of(Annotated[field.annotation, *field.metadata, None]):
                if get_origin(one) is Mapping:
                    found[spec.__name__, name] = get_args(one)[0]
                else:
                    waiting.append(one)
    return found


MAPPINGS = every_mapping()


def test_every_table_is_found():
    named = {name for _spec, name in MAPPINGS}
    assert {"shaft", "bank", "load", "masses", "points", "gear", "bearing", "pull", "part", "disc", "gas"} <= named
    assert {"fixed", "crank", "guide", "friction", "numbers", "firing_angles"} <= named


@pytest.mark.parametrize("spec_and_field", MAPPINGS, ids=".".join)
def test_keys_are_names(spec_and_field):
    key = MAPPINGS[spec_and_field]
    if spec_and_field[1] in ELSEWHERE:
        assert key is str
    else:
        assert get_origin(key) is Annotated
        assert NAME_METADATA in get_args(key)


ENGINE = {
    "shaft": {"main": {"throws": ["0 deg", "180 deg"], "spacing": "90 mm", "speed": "1000 rpm"}},
    "bank": {"A": {"mechanism": {"kind": "slider_crank", "crank_radius": "40 mm", "rod_length": "140 mm"}}},
    "masses": {"piston": {"mass": "1 kg"}},
}
FORCE = {"on": "piston", "force": "1 N", "sense": "resisting"}
GIVEN = {
    "load": FORCE,
    "bank.A.load": FORCE,
    "bank": {"mechanism": {"kind": "scotch_yoke", "crank_radius": "40 mm"}},
    "bank.A.mechanism.points": {"link": "rod", "along": "70 mm", "across": "0 mm"},
    "drive.part": {"inertia": "1 kg*m^2"},
    "torsion.disc": {"inertia": "1 kg*m^2", "beside": 2},
    "crankshaft.pull": {"force": "1 N", "direction": "0 deg", "z": "-50 mm"},
    "shaft": {"throws": ["0 deg"]},
}


@pytest.mark.parametrize("first", ["=", "+", "-", "@", "\t", "\r"])
@pytest.mark.parametrize("table", GIVEN)
def test_refused(table, first):
    name = f'{first}HYPERLINK("x")'
    data = {**ENGINE, **{key: dict(one) for key, one in ENGINE.items()}}
    place = data
    for key in table.split("."):
        place[key] = dict(place.get(key, {}))
        place = place[key]
    place[name] = GIVEN[table]
    with pytest.raises(InputError, match=r"must not begin with =, \+, - or @"):
        ct.Machine(**data)


def test_other_names_stay():
    """Inside a name all of these may stand."""
    machine = ct.Machine(**ENGINE, load={"a=b-c+d@e": FORCE})
    assert "a=b-c+d@e" in machine.load
