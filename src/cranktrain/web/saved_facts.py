"""Facts of a machine beside those of a saved case, and by how much they differ."""

from cranktrain.analysis import Result
from cranktrain.analysis.answer import rows_under
from cranktrain.analysis.comparison import Comparison
from cranktrain.analysis.figures import compared_texts
from cranktrain.language import _
from cranktrain.saying.sections import Compared
from cranktrain.web.parts import PageTable

_SAVED, _NOW = "saved", "now"
"""Names of the two, by which they are told apart here alone."""


def facts_beside(result: Result, saved: Result, title: str) -> PageTable | None:
    """Put the facts of a tab side by side with those of a saved case.

    Parameters
    ----------
    result, saved : Result
        Each of one machine.
    title : str
        Name of the tab.

    Returns
    -------
    PageTable or None
        A row of each fact of which the tab's rows tell, of either; None where there is none.
    """
    both = (saved, result)
    told = dict.fromkeys(name for one in both for row in rows_under(one, title) for name in row.quantities)
    names = tuple(name for name in told if any(_is_fact(one, name) for one in both))
    facts = [
        fact
        for part in (Comparison(both, (_SAVED, _NOW), names).sections() if names else ())
        if isinstance(part, Compared)
        for _title, facts in part.groups
        for fact in facts
    ]
    if not facts:
        return None
    heads = ("", _("saved"), _("now"), "", _("difference"), "%")
    rows = tuple((str(fact.name), *compared_texts(fact)) for fact in facts)
    return PageTable("", heads, ("",) * len(heads), rows, (), ())


def _is_fact(result: Result, name: str) -> bool:
    """Whether a result has a fact of that name."""
    return name in result.catalogue and result.catalogue[name].is_fact
