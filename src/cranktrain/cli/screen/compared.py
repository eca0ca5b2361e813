"""Facts of two side by side on the screen, with their difference."""

from collections.abc import Iterator

from rich.text import Text

from cranktrain.analysis.figures import compared_texts
from cranktrain.language import said as _
from cranktrain.saying.sections import Compared

_LEAST_WORDS = 12
"""Columns of the screen for the names of rows."""

_GAP = "  "
_UNIT = 2
"""Which of a fact's texts is its unit."""


def compared_lines(compared: Compared, width: int) -> Iterator[Text]:
    """Lay out facts in a width of columns; a name that has no room stands above its values."""
    groups = [(title, [(f"  {one.name}", compared_texts(one)) for one in facts]) for title, facts in compared.groups]
    rows = [row for _title, each in groups for row in each]
    first, second = map(str, compared.heads)
    widths = [max(map(len, column)) for column in zip(*(texts for _name, texts in rows), strict=True)]
    widths[:2] = max(widths[0], len(first)), max(widths[1], len(second))
    said = _("difference")
    widths[3] = max(widths[3], len(said) - widths[2] - 1)  # it stands over the unit, too
    room = width - sum(widths) - len(_GAP) * (len(widths) - 1) - 1
    room = max(_LEAST_WORDS, min(max(len(name) for name, _texts in rows), room))
    heads = first.rjust(widths[0]), second.rjust(widths[1]), said.rjust(widths[2] + widths[3] + 1)
    yield Text(_GAP.join(("".ljust(room), *heads, "%".rjust(widths[4]))).rstrip())
    for title, each in groups:
        yield Text(str(title))
        for name, texts in each:
            if len(name) > room:
                yield Text(name)
            yield Text(_line((name if len(name) <= room else "").ljust(room), texts, widths))


def _line(name: str, texts: tuple[str, ...], widths: list[int]) -> str:
    """Put a fact in a line: units close behind their values, numbers to the right."""
    first, second, unit, *rest = (
        text.ljust(width) if number == _UNIT else text.rjust(width)
        for number, (text, width) in enumerate(zip(texts, widths, strict=True))
    )
    return _GAP.join((name, first, f"{second} {unit}", *rest)).rstrip()
