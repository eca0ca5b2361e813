import copy
import re
import tomllib
from importlib.resources import files

import jsonschema
import pytest

from cranktrain.io.schema import machine_schema
from cranktrain.machine import Machine
from cranktrain.mechanisms import KINDS
from cranktrain.quantities import Dimension
from cranktrain.quantities.dimensions import spellings

SCHEMA = machine_schema()
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
EXAMPLES = {
    path.name: tomllib.loads(path.read_text(encoding="utf-8"))
    for path in files("cranktrain.examples").iterdir()
    if path.name.endswith(".toml")
}


def parts(schema: object):
    """Every schema within a schema."""
    if isinstance(schema, dict):
        yield schema
        for inner in schema.values():
            yield from parts(inner)
    elif isinstance(schema, list):
        for inner in schema:
            yield from parts(inner)


def test_schema_is_one():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    assert SCHEMA["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    references = {part["$ref"] for part in parts(SCHEMA) if "$ref" in part}
    assert references == {f"#/$defs/{name}" for name in SCHEMA["$defs"]}


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_are_right(name):
    VALIDATOR.validate(EXAMPLES[name])


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("rotation", "backwards"),
        ("nam", "x"),
        ("shaft.main.speed", 1500),
        ("shaft.main.speed", "1500 mm"),
        ("shaft.main.speed", "-1500 rpm"),
        ("shaft.main.speed", {"value": "1500 rpm", "status": "guessed"}),
        ("shaft.main.throws", "0 deg"),
        ("shaft.main.throws", []),
        ("shaft.main.spacing", ["180 mm", "30 deg"]),
        ("bank.L.angel", "0 deg"),
        ("bank.L.throws", ["1"]),
        ("bank.L.mechanism.kind", "slidercrank"),
        ("bank.L.mechanism.strok", "180 mm"),
        ("bank.L.mechanism.stroke", "180"),
        ("bank.L.mechanism.stroke", "180,5 mm"),
        ("bank.R.mechanism.master", 1),
        ("cylinder.bor", "150 mm"),
        ("cylinder.R.bor", "150 mm"),
        ("cylinder.overrides", {"R": {"bore": "150 mm"}}),
        ("cylinder.compression_ratio", "14.5 mm"),
        ("cylinder.cycle", "4-stroke"),
        ("cylinder.chambers", ["top"]),
    ],
)
def test_mistakes_are_found(path, value):
    data = copy.deepcopy(EXAMPLES["3d12.toml"])
    *tables, key = path.split(".")
    table = data
    for name in tables:
        table = table.setdefault(name, {})
    table[key] = value
    assert not VALIDATOR.is_valid(data)


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("shaft.main.spacing", "180 mm"),
        ("shaft.main.spacing", ["180 mm", "0 mm", "7 1/16 in", "180 mm", "180 mm"]),
        ("bank.L.angle", ["-30 deg"]),
        ("bank.L.mechanism.stroke", ["180 mm"]),
        ("bank.L.mechanism.points", {"p": {"link": "rod", "along": "1 mm", "across": "-1 mm"}}),
        ("cylinder.R", {"bore": "150 mm", "compression_ratio": 15}),
        ("cylinder.numbers", {"1": "1L"}),
        ("cylinder.chambers", ["head", "crank"]),
    ],
)
def test_other_ways_to_write_are_right(path, value):
    data = copy.deepcopy(EXAMPLES["3d12.toml"])
    *tables, key = path.split(".")
    table = data
    for name in tables:
        table = table.setdefault(name, {})
    table[key] = value
    VALIDATOR.validate(data)
    Machine(**data)


def test_every_key_says_what_it_is():
    tables = [part for part in parts(SCHEMA) if "properties" in part and "status" not in part["properties"]]
    assert len(tables) > len(KINDS)
    for table in tables:
        for name, field in table["properties"].items():
            assert "const" in field or re.fullmatch(r"\S.*[.)}]", field["description"]), name


def test_quantities_have_examples_that_fit():
    found = [part for name, part in SCHEMA["$defs"].items() if re.match(r"(angle|length|speed|ratio)", name)]
    assert len(found) >= 4
    for part in found:
        for example in part["examples"]:
            assert jsonschema.Draft202012Validator(part).is_valid(example)


@pytest.mark.parametrize("dimension", [Dimension.LENGTH, Dimension.ANGLE, Dimension.SPEED], ids=lambda one: one.name)
def test_every_spelling_of_a_unit_fits_and_no_other_dimension(dimension):
    name = {Dimension.LENGTH: "length", Dimension.ANGLE: "angle", Dimension.SPEED: "speed-above-0"}[dimension]
    validator = jsonschema.Draft202012Validator(SCHEMA["$defs"][name])
    for _unit, form in spellings(dimension).values():
        for text in (f"3 {form}", f"2.5{form}", f" 1/2  {form} "):
            assert validator.is_valid(text), text
    for other in Dimension:
        for unit in other.units if other is not dimension else ():
            assert not validator.is_valid(f"3 {unit.name}"), unit.name


GAS = {"kind": "otto", "start_pressure": "95 kPa", "compression_exponent": 1.35, "expansion_exponent": 1.28}
CHAIN = tomllib.loads(next(kind.example for kind in KINDS if kind.name == "chain"))["mechanism"]


def chain(**part):
    """A right chain but for one key of its first part."""
    return {**CHAIN, "part": [{**CHAIN["part"][0], **part}, *CHAIN["part"][1:]]}


def with_slip(path, value):
    """A right machine with one slip."""
    data = copy.deepcopy(EXAMPLES["3d12.toml"])
    data["gas"] = {**GAS, "pressure_ratio": 3.5}
    *above, key = path.split(".")
    table = data
    for name in above:
        table = table.setdefault(name, {})
    table[key] = value
    return data


SLIPS = [
    ("rotation", "backwards", "rotation"),
    ("shaft.main.speed", 1500, "shaft.main.speed"),
    ("shaft.main.speed", "1500 mm", "shaft.main.speed"),
    ("shaft.main.speed", {"value": "1500 mm"}, "shaft.main.speed.value"),
    ("shaft.main.speed", {"value": "1500 rpm", "status": "guessed"}, "shaft.main.speed.status"),
    ("shaft.main.throws", ["0 deg", 120], "shaft.main.throws.1"),
    ("shaft.main.spacing", ["180 mm", "30 deg"], "shaft.main.spacing.1"),
    ("shaft.main.spacing", 180, "shaft.main.spacing"),
    ("crank_zero", "Z", "crank_zero"),
    ("crank_zero", {"value": "3 mm"}, "crank_zero.value"),
    ("gravity", "yes", "gravity"),
    ("gravity", {"acceleration": "9.81 m"}, "gravity.acceleration"),
    ("bank.L.mechanism.kind", "slidercrank", "bank.L.mechanism.kind"),
    ("bank.L.mechanism.strok", "180 mm", "bank.L.mechanism"),
    ("bank.L.mechanism.stroke", "180", "bank.L.mechanism.stroke"),
    ("bank.L.mechanism.rod_length", ["180,5 mm"], "bank.L.mechanism.rod_length.0"),
    ("bank.L.angle", ["-30"], "bank.L.angle.0"),
    ("bank.R.mechanism.master", 1, "bank.R.mechanism.master"),
    ("gas.kind", "oto", "gas.kind"),
    ("gas.start_pressure", "95", "gas.start_pressure"),
    ("gas.start_pressur", "95 kPa", "gas"),
    ("gas.compression_exponent", True, "gas.compression_exponent"),
    ("gas", {"A": GAS | {"kind": "oto"}}, "gas.A.kind"),
    ("gas", {"A": {**GAS, "pressure_ratio": "3,5"}}, "gas.A.pressure_ratio"),
    ("gas", GAS, "gas"),
    ("gas", {name: value for name, value in GAS.items() if name != "kind"}, "gas"),
    ("cylinder.firing_angles", ["0"], "cylinder.firing_angles.0"),
    ("cylinder.firing_angles", {"1L": 0}, "cylinder.firing_angles.1L"),
    ("cylinder.R.bor", "150 mm", "cylinder.R"),
    ("cylinder.clearance", "8 mm", "cylinder.clearance"),
    ("mechanism", chain(type="slid"), "mechanism.part.0.type"),
    ("mechanism", chain(side=1), "mechanism.part.0.side"),
    ("bank.L.opposed", 1, "bank.L"),
]


@pytest.mark.parametrize(
    ("path", "value", "where"), SLIPS, ids=[f"{path} {number}" for number, (path, *_) in enumerate(SLIPS)]
)
def test_one_slip_is_one_error_where_it_was_made(path, value, where):
    errors = list(VALIDATOR.iter_errors(with_slip(path, value)))
    assert [".".join(map(str, error.absolute_path)) for error in errors] == [where]
    assert errors[0].context == []  # nothing is said of other alternatives
