"""Members that are alike put into columns, and what a column is called."""

from collections.abc import Mapping, Sequence
from string import digits
from typing import NamedTuple

from cranktrain.grouping import grouped
from cranktrain.wording import ranged

_MOST_COLUMNS = 4
_LONGEST_NAME = 12


class MemberColumns(NamedTuple):
    """Columns of a group of rows: their names, and one of the members of each; none where all members are alike."""

    names: tuple[str, ...] = ()
    first: tuple[str, ...] = ()


def member_columns(rows: Sequence[Mapping[str, str]]) -> MemberColumns:
    """Find columns such that members in one have the same text in every row.

    Parameters
    ----------
    rows : sequence of mappings of member to text
        Those that are not alike for all members.

    Returns
    -------
    MemberColumns
        None where rows are of other members, or where there would be more columns than are read.
    """
    if not rows:
        return MemberColumns()
    members = list(max(rows, key=len))
    together = [row for row in rows if set(row) <= set(members)]
    same = grouped((tuple(row.get(member, "") for row in together), member) for member in members)
    if not 1 < len(same) <= _MOST_COLUMNS:
        return MemberColumns()
    lots = list(same.values())
    return MemberColumns(tuple(name_of(lot, members) for lot in lots), tuple(lot[0] for lot in lots))


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
        named = dict.fromkeys(map(common, some))
        if len(named) == 1 and "" not in named and len(members) > 1:
            (name,) = named
            if [member for member in members if common(member) == name] == list(some):
                return name
    said = ranged(members, [members.index(one) for one in some])
    return said if len(said) <= _LONGEST_NAME or len(some) < 2 else f"{some[0]} +{len(some) - 1}"


def _ending(member: str) -> str:
    """What stands behind the number."""
    return member.lstrip(digits).lstrip(".")


def _side(member: str) -> str:
    """What stands behind the last dot."""
    return member.rpartition(".")[2] if "." in member else ""
