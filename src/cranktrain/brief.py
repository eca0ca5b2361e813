"""Values in one line of a representation, however much there is of them."""

from collections.abc import Iterable, Mapping, Sequence, Set
from inspect import Parameter, Signature
from typing import Any, cast

from cranktrain.one_line import short

LONGEST = 160
"""Characters of a representation."""

_LONGEST_VALUE, _FEW = 48, 3


def brief(value: object) -> str:
    """Show a value: an array by its size, a long list by its length, another object by its own representation.

    Parameters
    ----------
    value : object

    Returns
    -------
    str
        One line.

    Examples
    --------
    >>> brief((1, 2)), brief(list(range(100))), brief("a text"), brief({"a": 1, "b": 2, "c": 3, "d": 4})
    ('(1, 2)', '[100 items]', "'a text'", '{4 items}')
    """
    if isinstance(value, str):
        return repr(short(value, _LONGEST_VALUE))
    sizes = getattr(value, "shape", None)
    if isinstance(sizes, tuple) and sizes:
        return f"<{' × '.join(map(str, cast('tuple[int, ...]', sizes)))}>"
    if isinstance(value, Mapping):
        items = cast("Mapping[object, object]", value).items()
        return _listed([f"{brief(key)}: {brief(item)}" for key, item in items] if len(items) <= _FEW else items, "{}")
    if type(value) in (tuple, list, set, frozenset):
        held = cast("Sequence[object] | Set[object]", value)
        return _listed([brief(item) for item in held] if len(held) <= _FEW else held, _BRACKETS[type(value)])
    return short(repr(value), _LONGEST_VALUE)


def brief_fields(name: str, fields: Iterable[tuple[str, object]]) -> str:
    """Show an object by the name of its class and its fields, cut where it is too long for a line.

    Examples
    --------
    >>> brief_fields("Rod", {"length": 0.136, "joints": ("pin",)}.items())
    "Rod(length=0.136, joints=('pin',))"
    """
    shown = f"{name}({', '.join(f'{field}={brief(value)}' for field, value in fields)})"
    return shown if len(shown) <= LONGEST else short(shown, LONGEST - 1) + ")"


class BriefSignature:
    """Signature of a spec: its fields with what they are unless given; their types would fill pages."""

    def __get__(self, instance: object, spec: Any) -> Signature:
        """Give it of the class; an instance has none."""
        if instance is not None:
            raise AttributeError("__signature__")
        fields: Mapping[str, Any] = spec.model_fields
        usual = {name: Parameter.empty if one.is_required() else one.get_default() for name, one in fields.items()}
        return Signature([Parameter(name, Parameter.KEYWORD_ONLY, default=value) for name, value in usual.items()])


_BRACKETS: dict[type[Any], str] = {tuple: "()", list: "[]", set: "{}", frozenset: "{}"}


def _listed(items: "Sequence[object] | Set[object] | Iterable[object]", brackets: str) -> str:
    """Show few items, which are shown already, or how many there are."""
    held = list(items)
    start, end = brackets
    if len(held) > _FEW:
        return f"{start}{len(held)} items{end}"
    inside = ", ".join(map(str, held))
    single = "," if brackets == "()" and len(held) == 1 else ""
    return short(f"{start}{inside}{single}{end}", _LONGEST_VALUE)
