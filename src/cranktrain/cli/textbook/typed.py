"""What was typed after `textbook`, and what of it means nothing beside what else was typed."""

from collections.abc import Iterator

from cranktrain.errors import Problem, refuse
from cranktrain.language import said as _
from cranktrain.record import record

_FIELDS = {"FILE": "file", "--set": "settings", "-o": "output"}
"""Of options whose field has another name than they."""

OF_FORCES = ("--step", "--piston")
OF_MOTION = ("--forces", *OF_FORCES, "--harmonics", "--crank-to-rod-ratio")
OF_THROW = ("--throw-number", "--crank-masses")
"""Options that belong together."""


@record
class TextbookRequest:
    """What was typed; None, or False of a switch, for what was not."""

    file: str | None
    settings: tuple[str, ...]
    source: str | None
    equation: str | None
    table: bool
    full: bool
    errata: bool
    forces: str | None
    step: float | None
    piston: str | None
    harmonics: bool
    crank_to_rod_ratio: str | None
    throw: str | None
    throw_number: str | None
    crank_masses: str | None
    drive: str | None
    at: float | None
    output: str | None
    force: bool

    def typed(self, *options: str) -> Iterator[tuple[str, str]]:
        """Give those of some options that were typed, each with what stands behind it; behind a switch nothing."""
        for option in options:
            text = _as_typed(getattr(self, _FIELDS.get(option, option[2:].replace("-", "_"))))
            if text is not None:
                yield option, text

    def beside(self, allowed: str, *options: str) -> Iterator[Problem]:
        """Refuse those of some options that were typed."""
        for option, value in self.typed(*options):
            yield Problem(option, value or None, allowed)


def _as_typed(value: str | float | tuple[str, ...] | None) -> str | None:
    """Write what was typed; None of what was not."""
    match value:
        case str():
            return value
        case float():
            return f"{value:g}"
        case tuple():
            return next(iter(value), None)
        case _:
            return "" if value is True else None


def refuse_without_throw(asked: TextbookRequest) -> None:
    """Refuse to write where nothing can be written, and what is asked of a throw or a drive where there is none."""
    of_both = _("is for a throw or a drive: ask for --throw FILE or --drive FILE, too")
    of_throw = _("is for a machine's throw: ask for --throw FILE, too")
    refuse([*asked.beside(of_both, "-o", "--force", "--at"), *asked.beside(of_throw, *OF_THROW)])
