"""What the five texts state of a machine, beside what is right: `Statements`, each with its number in its text.

>>> import cranktrain as ct
>>> found = ct.textbook.drive("tilting_table")
>>> found
<Statements: Drive of a crank-rocker, (1) to (21) [gandzha]; ... numbers, ... curves>
>>> idle = found.numbered("(21)")[0]
>>> idle.symbol, idle.unit, idle.verdict
('M_xx', 'N*m', 'right')
"""

from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any

from cranktrain.textbook.statements import Statement, StatementCurve, Statements

if TYPE_CHECKING:
    from cranktrain.textbook.drive_statements import drive
    from cranktrain.textbook.errata_statements import errata
    from cranktrain.textbook.motion_statements import motion
    from cranktrain.textbook.synthesis_statements import synthesis
    from cranktrain.textbook.throw_statements import throw

__all__ = ["Statement", "StatementCurve", "Statements", "drive", "errata", "motion", "synthesis", "throw"]

_HOMES = {
    "drive": "drive_statements",
    "errata": "errata_statements",
    "motion": "motion_statements",
    "synthesis": "synthesis_statements",
    "throw": "throw_statements",
}
"""Which module has each of what is called."""


def __getattr__(name: str) -> Callable[..., Any]:
    if name in _HOMES:
        return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
    if name.startswith("_"):
        raise AttributeError(f"cranktrain.textbook has no {name}")
    from cranktrain.quantities import nearest  # only after a mistake

    meant = nearest(name, __all__)
    raise AttributeError(f"cranktrain.textbook has no {name}" + (f"; did you mean {meant}?" if meant else ""))


def __dir__() -> list[str]:
    return sorted({*(name for name in globals() if name.startswith("__")), *__all__})
