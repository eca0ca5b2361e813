"""What is shown of a proposal, as sections: its numbers, what else was considered, remarks."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from cranktrain.grouping import grouped
from cranktrain.language import Listed, Said, Words, _
from cranktrain.saying.sections import Column, Grid, Part, Rows, ShownSection, section
from cranktrain.saying.wording import FigureOf, UnitOf, number
from cranktrain.synthesis.proposal import Number, Proposal

_ROUNDING = 1e-12
"""Of the largest number of a column: below it is nothing but rounding."""


def proposal_sections(proposal: Proposal) -> Iterator[ShownSection]:
    """Give numbers, alternatives and remarks.

    Parameters
    ----------
    proposal : Proposal
    """
    yield from section(_("Proposed"), _numbers(proposal.numbers))
    yield from section(_("Also considered"), _alternatives(proposal))
    yield from section(_("Mind"), proposal.remarks)


def _numbers(numbers: Sequence[Number]) -> Iterator[Part]:
    """Numbers one in a line; those of several members, such as the strokes of cylinders, in columns."""
    single = [one for one in numbers if not one.member]
    if single:
        cells = [(one.sentence, one.symbol, FigureOf(one.value, one.unit), UnitOf(one.unit)) for one in single]
        yield Rows(cells, right=(2,), is_folded=False)
    several = grouped((one.name, one) for one in numbers if one.member)
    members = grouped((tuple(one.member for one in each), each) for each in several.values())
    for i, (labels, columns) in enumerate(members.items()):
        if i or single:
            yield ""
        yield Grid([_column(each[0], each) for each in columns], labels)
        yield ""
        yield _legend([each[0] for each in columns])


def _alternatives(proposal: Proposal) -> Iterator[Part]:
    """Tables of alternatives, one for each set of numbers; those that the proposal has too stand beside its own."""
    own = {one.key: one for one in proposal.numbers}
    others = [(label, {one.key: one for one in numbers}) for label, numbers in proposal.alternatives]
    families = grouped((tuple(own if set(other) <= set(own) else other), (label, other)) for label, other in others)
    for i, (names, rows) in enumerate(families.items()):
        if i:
            yield ""
        if names == tuple(own):
            rows.insert(0, (_("as proposed"), own))
        shown = {name: next(numbers[name] for _label, numbers in rows if name in numbers) for name in names}
        columns = {name: _column(one, [numbers.get(name) for _label, numbers in rows]) for name, one in shown.items()}
        kept = [name for name, column in columns.items() if _differs(column)] or list(columns)
        yield Grid([columns[name] for name in kept], words=[label for label, _numbers in rows])
        yield ""
        yield _legend([shown[name] for name in kept])


def _column(like: Number, numbers: Sequence[Number | None]) -> Column:
    """A column of one kind of number; empty where a row has none."""
    least = _ROUNDING * max((abs(one.value) for one in numbers if one is not None), default=0.0)
    values = ["" if one is None else one.value if abs(one.value) > least else 0.0 for one in numbers]
    return Column(like.symbol, values, like.unit)


def _differs(column: Column) -> bool:
    """Whether two numbers of a column are written in different ways."""
    return len({number(value, column.unit) for value in column.values if isinstance(value, float)}) > 1


def _legend(numbers: Sequence[Number]) -> Words:
    """Say what the symbols are."""
    return Listed([Listed((one.symbol, _Following(one.sentence)), " ") for one in numbers], "; ")


@dataclass(frozen=True, slots=True, repr=False)
class _Following(Said):
    """Words with a small letter before."""

    words: Words

    def said(self, say: Callable[[object], object]) -> str:
        """Say them."""
        text = str(say(self.words))
        return text[:1].lower() + text[1:]
