"""Tables of the machine file that hold, under names of the user's own, what one member has otherwise."""

from collections.abc import Mapping
from typing import Any, ClassVar, cast

from cranktrain.spec import Spec

_OTHERS = "overrides"


class OverriddenSpec(Spec, frozen=True):
    """A table for all, in which tables of other names than its keys are `overrides`: of a bank, a cylinder, a shaft."""

    others: ClassVar = _OTHERS

    @classmethod
    def as_fields(cls, data: object) -> object:
        """Take `[cylinder.R]` and `[cylinder.2L]` as what bank R and piston 2L have of their own."""
        data = super().as_fields(data)
        if not isinstance(data, Mapping):
            return data
        table = cast(Mapping[str, Any], data)
        keys = [name for name in cls.model_fields if name != _OTHERS]
        own = {
            name: cast(object, value)
            for name, value in table.items()
            if isinstance(value, Mapping) and name not in keys
        }
        common = {name: value for name, value in table.items() if name not in own}
        return common | {cls.model_fields[_OTHERS].alias: own} if own else common
