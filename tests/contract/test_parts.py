"""Parts are SI arrays and names: no table of the machine file stands in them, so that no stage knows pydantic."""

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass

import numpy as np
import pytest
from pydantic import BaseModel
from tests.contract.test_catalogue import EVERYTHING

import cranktrain as ct
from cranktrain.analysis.parts import parts_of
from cranktrain.io.examples import example_names
from cranktrain.quantities import Given

TABLES = (BaseModel, Given)
"""What a machine file is read into: its tables, and the numbers in them with their texts."""


DO_INSTEAD = "take its numbers where the part is made: `given.array` by designs.by_design, a choice by its word"


def tables_in(value: object, path: str) -> Iterator[str]:
    """Where tables of a file stand in a part, by the path of its fields."""
    if isinstance(value, TABLES):
        yield path
    elif is_dataclass(value) and not isinstance(value, type):
        for field in fields(value):
            yield from tables_in(getattr(value, field.name), f"{path}.{field.name}")
    elif isinstance(value, Mapping):
        for item in value.values():
            yield from tables_in(item, path)
    elif isinstance(value, tuple | list):
        names = getattr(value, "_fields", None)
        for i, item in enumerate(value):
            yield from tables_in(item, f"{path}.{names[i]}" if names else path)


def held(machine):
    parts = parts_of((machine,), step=np.radians(10))
    return {path for kind, part in parts.items() for path in tables_in(part, kind.__name__)}


@pytest.mark.parametrize("name", ["everything", *example_names()])
def test_no_part_holds_a_table(name):
    machine = ct.Machine(**EVERYTHING) if name == "everything" else ct.load(name)
    assert held(machine) == set(), DO_INSTEAD


def test_a_table_is_found_wherever_it_stands():
    machine = ct.load("3d12")
    (place, *_others) = machine.places
    assert list(tables_in({"1L": (place,)}, "Made")) == ["Made.spec"]
    assert list(tables_in((machine.main_shaft.speed,), "Made")) == ["Made"]
