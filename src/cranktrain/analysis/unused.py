"""Tables of a machine file that are written and not used, with what is missing for them, so that no result misleads."""

from collections.abc import Iterator, Mapping, Sequence

from cranktrain.grouping import grouped
from cranktrain.language import N_, Listed, Words, _
from cranktrain.machine import Machine
from cranktrain.record import record
from cranktrain.saying.wording import in_words


@record
class Unused:
    """A table of the machine file that no result rests on.

    Attributes
    ----------
    table : str
        As the file has it: "[gas]".
    needs : tuple of Words
        What the file would have to say, too.
    consequence : Words
        What the results are without it, as a clause; empty where none speaks of it.
    """

    table: str
    needs: tuple[Words, ...]
    consequence: Words


def sentences(found: Sequence[Unused]) -> list[Words]:
    """Say what is not used, and why; tables that lack the same in one sentence."""
    alike = grouped(((one.needs, one.consequence), one.table) for one in found)
    return [_sentence(tables, needs, consequence) for (needs, consequence), tables in alike.items()]


def _sentence(tables: Sequence[str], needs: Sequence[Words], consequence: Words) -> Words:
    """Say that some tables are not used, what they all lack, and what the results are without them."""
    one, more = N_("{tables} is not used: {missing}"), N_("{tables} are not used: {missing}")
    is_one, are_more = N_("{needs} is missing"), N_("{needs} are missing")
    missing = _(is_one if len(needs) == 1 else are_more, needs=in_words(needs))
    said = _(one if len(tables) == 1 else more, tables=in_words(tables), missing=missing)
    return _("{said}; {consequence}.", said=said, consequence=consequence) if consequence else Listed((said, "."), "")


def unused(machine: Machine, lacking: Mapping[str, tuple[Words, ...]]) -> tuple[Unused, ...]:
    """Find the tables that are written and that no result could rest on.

    Parameters
    ----------
    machine : Machine
    lacking : mapping of str to tuple of Words
        Names of results that cannot be had, and what is missing for them.

    Returns
    -------
    tuple of Unused
        A table that is not used at all, and of one that is, its parts that are not.
    """
    found: list[Unused] = []
    every = list(_found(machine, lacking))
    used = {one.table for one in every if not one.needs}
    for one in every:
        # A table that several questions read is used where one of them can.
        if one.table not in used and not any(
            one.table != other.table and one.table.startswith(other.table.rstrip("]")) for other in found
        ):
            found.append(one)
    return tuple(found)


def _found(machine: Machine, lacking: Mapping[str, tuple[Words, ...]]) -> Iterator[Unused]:
    """Go through all that may stand in a file, what nothing is missing for too."""
    for use in (use for question in machine.questions for use in question.uses):
        tables = use.tables(machine.design)
        if not tables:
            continue
        needs = dict.fromkeys(need for result in use.results for need in lacking.get(result.__name__, ()))
        for table in tables:
            # What a table holds is there, though nothing could be made of it.
            others = tuple(need for need in needs if need != _(table))
            has_consequence = use.instead is not None and use.instead.__name__ not in lacking
            yield Unused(table, others, _(use.consequence) if has_consequence else "")
