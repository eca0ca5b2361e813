"""What a changed file keeps of one that was checked: a table that stands as it stood is the spec that it was."""

from collections.abc import Mapping
from typing import Any, cast

from cranktrain.spec import Spec


def with_kept(data: Mapping[str, Any], checked: Spec, before: Mapping[str, Any]) -> dict[str, Any]:
    """Put specs in place of those tables of a file that are the same as before.

    Parameters
    ----------
    data : mapping
        The tables, changed in some places; all that is elsewhere is shared with `before`.
    checked : Spec
        What was read from the tables before.
    before : mapping

    Returns
    -------
    dict
        In which no table has to be read that is the same object as before; nor, of tables by name, one of these.

    Examples
    --------
    >>> from cranktrain.layout.specs import BankSpec
    >>> before = {"masses": {"rod": {"mass": "2 kg"}}, "stagger": "0 mm", "throws": (1,)}
    >>> checked = BankSpec.model_construct(**before)
    >>> changed = {**before, "throws": [1]}
    >>> with_kept(changed, checked, before)["masses"] is checked.masses
    True
    """
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
