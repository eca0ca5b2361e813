"""Makes the list of names that are completed, when the package is built: `hatch_build.py`."""

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Annotated, Any, get_args, get_origin

from cranktrain import fluids, mechanisms
from cranktrain.analysis import every_stage
from cranktrain.declared_types import bare
from cranktrain.machine import Machine
from cranktrain.quantities import SHOWN, unit_names
from cranktrain.spec import Spec


def made() -> dict[str, Any]:
    """Give the list: names of results, kinds and units, and the keys of tables by the patterns of their paths."""
    keys = dict(_tables(Machine, ()))
    for home in (("mechanism",), ("bank", "*", "mechanism")):
        for kind in mechanisms.KINDS:
            keys |= dict(_tables(kind.spec, (*home, f":{kind.name}")))
    for home in (("gas",), ("gas", "*")):
        for fluid in fluids.KINDS:
            keys |= dict(_tables(fluid.spec, (*home, f":{fluid.name}")))
    keys["shaft", "main"] = [key for key in keys["shaft", "*"] if key not in ("ratio", "phase", "place")]
    return {
        "results": list(dict.fromkeys(name for stage in every_stage() for name in stage.results)),
        "kinds": list(mechanisms.KINDS.names),
        "units": list(dict.fromkeys(unit for dimension in SHOWN for unit in unit_names(dimension))),
        "keys": {".".join(pattern): names for pattern, names in keys.items() if names},
    }


def _tables(spec: type[Spec], above: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], list[str]]]:
    """Give the keys of a table that have values, and those of the tables in it."""
    values: list[str] = []
    for name, field in spec.model_fields.items():
        annotation = bare(Annotated[field.annotation, field])
        kinds = annotation.alternatives or (annotation.annotation,)
        tables = [kind for each in kinds if isinstance(kind := bare(each).annotation, type) and issubclass(kind, Spec)]
        named = _named(annotation.annotation)
        if name == spec.others:
            continue
        if len(tables) == 1:
            yield from _tables(tables[0], (*above, name))
        if named is not None:
            yield from _tables(named, (*above, name, "*"))
        if not tables and named is None and "Spec" not in str(field.annotation):
            values.append(field.alias or name)
    yield above, values


def _named(annotation: object) -> type[Spec] | None:
    """Give the table that a mapping holds by names; None for anything else."""
    origin, arguments = get_origin(annotation), get_args(annotation)
    if isinstance(origin, type) and issubclass(origin, Mapping):
        inner = bare(arguments[1]).annotation
        return inner if isinstance(inner, type) and issubclass(inner, Spec) else None
    return None


def write_names(path: Path) -> None:
    """Write the list to a file, unless it stands there."""
    text = json.dumps(made(), indent=1) + "\n"
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")
