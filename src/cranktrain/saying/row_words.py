"""A row in words: who has what, or from what to what it goes."""

from collections.abc import Iterable, Iterator, Sequence
from string import digits

from cranktrain.grouping import grouped
from cranktrain.language import Words
from cranktrain.language import said as _
from cranktrain.numerics.ties import first_largest, first_smallest
from cranktrain.saying.amounts import KEPT, Written, filled, written
from cranktrain.saying.rows import AnswerLine
from cranktrain.saying.wording import ABSENT, ranged

_LONGEST_NAME = 12
_NAMED, _LONGEST = 3, 48
"""How many values that differ are named one by one, in how many characters; of more there is a range."""


def row_words(row: AnswerLine) -> str:
    """Say a row in one line.

    Examples
    --------
    >>> from cranktrain.saying.rows import valued
    >>> print(row_words(valued("stroke", [0.18, 0.18, 0.1867], "m", ("1L", "2L", "1R"))))
    stroke: 180.0 mm (L), 186.7 mm (R)
    """
    return f"{row.name}: {_all_words(row)}".replace(KEPT, " ")


def row_sentence(title: Words, rows: Iterable[AnswerLine]) -> str:
    """Say some rows of a title in one sentence; nothing of none.

    Examples
    --------
    >>> from cranktrain.saying.rows import valued
    >>> rows = valued("stroke", [0.18], "m", ("1",)), valued("speed", [9.0], "m/s", ("1",))
    >>> print(row_sentence("Motion", rows).replace(KEPT, " "))
    Motion: stroke 180.0 mm; speed 9.000 m/s
    """
    said = "; ".join(_("{name} {words}", name=row.name, words=_all_words(row)) for row in rows)
    return _("{title}: {rows}", title=title, rows=said) if said else ""


def _all_words(row: AnswerLine) -> str:
    """Say all that a row says behind its name."""
    if not row.values.size:
        return filled(row.words)
    found = written(row.values, row.unit)
    different = dict.fromkeys(found.texts)
    return with_values(row, found.whole(*different) if len(different) == 1 else by_name(row, found))


def with_values(row: AnswerLine, values: str) -> str:
    """Say what a row says with its values; these alone where they say all."""
    return filled(row.words, values) if row.words else values


def row_lines(groups: Iterable[tuple[Words, Iterable[AnswerLine]]]) -> Iterator[str]:
    """Say groups of rows: the title of each, and a line for each of its rows."""
    for title, rows in groups:
        yield str(title)
        for row in rows:
            yield f"  {row_words(row)}"


def name_of(some: Sequence[str], members: Sequence[str]) -> str:
    """Name some of the members by what they have in common: bank L of 1L to 6L, `exhaust` of 1.exhaust to 6.exhaust.

    Examples
    --------
    >>> name_of(["1L", "2L"], ["1L", "2L", "1R", "2R"])
    'L'
    >>> name_of(["1S", "3S"], ["1S", "2S", "3S"])
    '1S, 3S'
    """
    for common in (_side, _ending):
        shared = dict.fromkeys(map(common, some))
        if len(shared) == 1 and "" not in shared and len(members) > 1:
            (name,) = shared
            if [member for member in members if common(member) == name] == list(some):
                return name
    named = ranged(members, [members.index(one) for one in some])
    return named if len(named) <= _LONGEST_NAME or len(some) < 2 else f"{some[0]} +{len(some) - 1}"


def _ending(member: str) -> str:
    """What stands behind the number."""
    return member.lstrip(digits).lstrip(".")


def _side(member: str) -> str:
    """What stands behind the last dot."""
    return member.rpartition(".")[2] if "." in member else ""


def holders(row: AnswerLine, found: Written) -> dict[str, list[str]]:
    """Members by what is written of them."""
    return grouped(zip(found.texts, row.whose, strict=True))


def by_name(row: AnswerLine, found: Written) -> str:
    """Say who has what, or from what to what they go."""
    alike = holders(row, found)
    each = ", ".join(
        _("{value} ({who})", value=found.whole(text), who=name_of(members, row.whose))
        for text, members in alike.items()
        if text != ABSENT
    )
    if len(alike) <= _NAMED and len(each) <= _LONGEST:
        return each
    least, most = (row.whose[pick(row.values)] for pick in (first_smallest, first_largest))
    texts = dict(zip(row.whose, found.texts, strict=True))
    return _(
        "{least} ({one}) to {most} ({other})", least=texts[least], one=least, most=found.whole(texts[most]), other=most
    )
