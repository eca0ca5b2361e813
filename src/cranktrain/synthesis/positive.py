"""Requirements that must be more than 0."""

from collections.abc import Callable, Mapping

from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.wording import precise


def not_positive(requirements: Mapping[str, float | None], written: Callable[[float], str] = precise) -> list[Problem]:
    """Problems of requirements that are not more than 0, each written as a length unless said; None is none."""
    return [
        Problem(name, written(value), _("must be more than 0"))
        for name, value in requirements.items()
        if value is not None and not value > 0
    ]


def plain(value: float) -> str:
    """A number without its unit."""
    return f"{value:g}"
