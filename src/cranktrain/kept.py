"""What a changed file keeps of one that was checked: a table that stands as it stood is the spec that it was.

That a table is the same is told by the object that holds it, never by its values: 1 is equal to true.
"""

from collections.abc import Collection, Mapping
from typing import Any, cast

from cranktrain.errors import InputError
from cranktrain.spec import Spec, SpecType


def read_like(
    checked: SpecType,
    data: Mapping[str, Any],
    before: Mapping[str, Any],
    found: Mapping[str, Mapping[str, Collection[str]]],
) -> SpecType:
    """Read the tables of a file of which another was read before, and are the same but in some places.

    Parameters
    ----------
    checked : Spec
        What was read before.
    data : mapping
        The tables; all that was not changed is shared with `before`.
    before : mapping
    found : mapping of str to mapping of str
        What a spec finds when it is asked, and the tables on which that rests, nothing else; of tables by name, which
        of their keys say nothing of it.

    Returns
    -------
    Spec
        No table is read that is the same object as before; nor, of tables by name, one of these. What was found from
        tables that are all the same is not found again.

    Raises
    ------
    InputError
        With everything that is wrong, as if all were read.
    """
    try:
        changed = type(checked)(**_with_kept(checked, data, before))
    except InputError:  # of which more is told where tables are read than where specs stand in their place
        changed = type(checked)(**data)
    for name, tables in found.items():
        same = (_is_same(data.get(table), before.get(table), beside) for table, beside in tables.items())
        if name in vars(checked) and all(same):
            vars(changed)[name] = vars(checked)[name]
    return changed


def _is_same(value: object, before: object, beside: Collection[str]) -> bool:
    """Whether a value is the same object as before, or tables by name differ in some keys of theirs at most."""
    if value is before:
        return True
    if not (beside and isinstance(value, dict) and isinstance(before, dict)):
        return False
    tables, old = cast("tuple[dict[str, dict[str, object]], ...]", (value, before))
    return tables.keys() == old.keys() and all(
        table.get(key) is old[name].get(key)
        for name, table in tables.items()
        for key in {*table, *old[name]} - set(beside)
    )


def _with_kept(checked: Spec, data: Mapping[str, Any], before: Mapping[str, Any]) -> dict[str, Any]:
    """Put specs in place of those tables that are the same as before."""
    return {
        key: _kept(value, getattr(checked, key), before[key]) if key in before else value for key, value in data.items()
    }


def _kept(value: object, held: object, before: object) -> object:
    """Give what was read, where the value is what it was read from."""
    if value is before:
        return held
    if isinstance(value, dict) and isinstance(before, dict) and isinstance(held, dict):
        tables, specs, old = cast("tuple[dict[str, object], ...]", (value, held, before))
        return {name: specs[name] if name in old and table is old[name] else table for name, table in tables.items()}
    return cast("object", value)
