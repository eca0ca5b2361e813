"""What a store of a sweep is of, and in what it differs from what is asked."""

import json
from collections.abc import Iterator, Mapping
from hashlib import sha256
from typing import Any, cast

from cranktrain.errors import Position, Problem
from cranktrain.io.saving import plain_tables
from cranktrain.language import said as _
from cranktrain.one_line import short
from cranktrain.paths import PathParts, is_table, path_text
from cranktrain.study.sweep.kept import Plan
from cranktrain.version import VERSION

_NAMED = 3
"""Values of the file that a sentence names."""


def identity(plan: Plan) -> dict[str, Any]:
    """Say what a sweep is of, as JSON has it: of values that are many what tells them apart from others."""
    varied = {one.path: [len(one.values), sha256(repr(one.values).encode()).hexdigest()] for one in plan.designs.varied}
    return {
        "version": VERSION,
        "machine": plain_tables(plan.machine.declared),
        "varied": varied,
        "is_listed": plan.designs.is_listed,
        "wanted": list(plan.wanted),
        "over_time": plan.over_time,
    }


def differences(there: Mapping[str, Any], here: Mapping[str, Any], name: str) -> Iterator[Problem]:
    """Say in what a store is of another sweep.

    Parameters
    ----------
    there, here : mapping
        Identities: of the store, and of what is asked.
    name : str
        Of the store.
    """
    own = json.loads(json.dumps(here))
    for said in _differences(there, own):
        yield Problem("", None, said, _("choose another name for the store"), Position(name))


def _differences(there: Mapping[str, Any], here: Mapping[str, Any]) -> Iterator[str]:
    if there["version"] != here["version"]:
        yield _("was begun with cranktrain {there}, and this is {here}", there=there["version"], here=here["version"])
    if different := list(_values(there["machine"], here["machine"])):
        named = ", ".join(different[:_NAMED]) + (", …" if len(different) > _NAMED else "")
        yield _("is of another machine file: {values}", values=named)
    if list(there["varied"]) != list(here["varied"]) or there["is_listed"] != here["is_listed"]:
        yield _("varies {there}, and not {here}", there=", ".join(there["varied"]), here=", ".join(here["varied"]))
    else:
        others = [path for path, values in there["varied"].items() if values != here["varied"][path]]
        if others:
            yield _("has other values of {paths}", paths=", ".join(others))
    if there["over_time"] != here["over_time"]:
        yield _("is of starts") if there["over_time"] else _("is of the cycle, and not of starts")
    elif there["wanted"] != here["wanted"]:
        both = {"there": ", ".join(there["wanted"]), "here": ", ".join(here["wanted"])}
        yield _("has the facts {there}, and not {here}", **both)


def _values(there: object, here: object, path: PathParts = ()) -> Iterator[str]:
    """Values of the file that differ; where they are from makes no other numbers."""
    there, here = _alone(there), _alone(here)
    if is_table(there) and is_table(here):
        for key in dict.fromkeys([*there, *here]):
            yield from _values(there.get(key), here.get(key), (*path, key))
    elif there != here:
        yield _("{path} is {there} there and {here} here", path=path_text(path), there=_said(there), here=_said(here))


def _alone(value: object) -> object:
    """A value without its status, note and source."""
    if is_table(value) or not isinstance(value, Mapping):
        return value
    told = cast("Mapping[str, object]", value)
    return told["value"]


def _said(value: object) -> str:
    """A value as the file has it."""
    if value is None:
        return _("missing")
    return short(value if isinstance(value, str) else json.dumps(value, ensure_ascii=False))
