"""Regular expressions of quantities: what editors check while one types."""

import re
from collections.abc import Iterator

from cranktrain.quantities.dimensions import Dimension, spellings
from cranktrain.quantities.number import PATTERN

_DIGITS = {"²": "2", "³": "3", "2": "²", "3": "³"}


def pattern(dimension: Dimension, *, is_signed: bool) -> str:
    """Regular expression of a number and a unit of its dimension, in each of its spellings.

    Parameters
    ----------
    dimension : Dimension
    is_signed : bool
        Whether a minus may stand before it.

    Returns
    -------
    str
    """
    units = "|".join(dict.fromkeys(_unit_patterns(dimension)))
    signed = PATTERN if is_signed else PATTERN.replace("^", r"^(?!\s*-)", 1)
    optional = "" if dimension.needs_unit else "?"
    return rf"{signed}\s*(?:{units}){optional}\s*$"


def _unit_patterns(dimension: Dimension) -> Iterator[str]:
    """Spell each unit in the ways in which it is read: m² also m^2, N·m also N*m."""
    for key, (_unit, form) in spellings(dimension).items():
        for text in (form, key):
            pattern = re.sub(
                r"[²³]|(?<=[a-zа-я])[23]", lambda found: rf"(?:\^|\*\*)?[{found[0]}{_DIGITS[found[0]]}]", text
            )
            yield pattern.replace("·", r"[\s.*·⋅∙×]*").replace("/", r"\s*/\s*")
