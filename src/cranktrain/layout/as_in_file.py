"""Paths of problems as the machine file has them."""

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from cranktrain.errors import Problem
from cranktrain.mechanisms.spec import LISTS
from cranktrain.paths import value_at


def as_in_file(problem: Problem, data: Mapping[str, Any]) -> Problem:
    """Give a problem the path that the file has: one value where a list was made of it, overrides as tables."""
    path = re.sub(r'^(\w+)\."?NAME \([^)]*\)"?\.', r"\1.", problem.path)
    found = re.fullmatch(r"(bank\.[^.]+\.mechanism)\[(\d+)\](?:\.([^.\[]+)(.*))?", path)
    if found is not None:
        table, index, field, rest = found.groups(default="")
        value = value_at(data, f"{table}.{field}") if field else None
        item = f"[{index}]" if isinstance(value, list | tuple) and field not in LISTS else ""
        path = f"{table}.{field}{item}{rest}" if field else table
    elif (single := re.fullmatch(r"(.*)\[0\](.*)", path)) is not None and not isinstance(
        value_at(data, single[1]), list | tuple
    ):
        path = f"{single[1]}{single[2]}"
    return replace(problem, path=path)
