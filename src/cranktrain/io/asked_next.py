"""What a machine's file could say next, and what that would give."""

from collections.abc import Iterator, Mapping, Sequence

from cranktrain.all_questions import QUESTIONS
from cranktrain.analysis import Missing
from cranktrain.analysis.unasked import unasked
from cranktrain.language import Words
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.saying.typesetting import KEPT
from cranktrain.saying.wording import all_of

_MOST_NEEDS, _MOST_OFFERS = 2, 3


def next_words(machine: Machine, missing: Sequence[Missing]) -> Iterator[str]:
    """Say what the file could say next and what that gives: what needs least first, then what a question offers first.

    Where several keys are missing, only of a table that the file has: a press is not asked for a compression ratio.
    What no table can say, as that there be a rod, is not asked for.
    """
    ranked = sorted(
        (len(one.needs), rank, -place if rank else place, tuple(map(str, one.needs)), words)
        for place, name in enumerate(QUESTIONS.names)
        for rank, (quantity, words) in enumerate(_offered(machine, name).items())
        for one in missing
        if quantity in one.results and len(one.needs) <= _MOST_NEEDS and all(map(_is_table, one.needs))
    )
    first: dict[tuple[str, ...], str] = {}
    for n_needs, _rank, _place, needs, words in ranked:
        is_more = any(set(needs) > set(fewer) for fewer in first)
        if n_needs == 1 or (not is_more and all(_has_table(machine, need) for need in needs)):
            first.setdefault(needs, words)
    for needs, words in list(first.items())[:_MOST_OFFERS]:
        yield f"{all_of(list(map(_shortly, needs)))} {_(words)}".replace(" ", KEPT)


def _offered(machine: Machine, question: str) -> Mapping[str, str]:
    """What a question gives to those who ask next, whether this machine's file asks it or not."""
    return (QUESTIONS.named(question) if question in machine.asks else unasked(question)).offers


def _has_table(machine: Machine, need: str) -> bool:
    """Whether the table of a key is in the file; one that is missing as a whole has no key."""
    table, _bracket, key = need.removeprefix("[").partition("]")
    return not key or table.partition(".")[0] in machine.declared


def _is_table(need: Words) -> bool:
    """Whether a need is a table of the file, or keys of one."""
    return str(need).startswith("[")


def _shortly(need: str) -> str:
    """Give a table with its one key; of several keys the table, of alternatives the first."""
    table, key = need.partition("] ")[::2]
    return f"{table.removesuffix(']')}]" if not key or "," in key else f"{table}] {key.partition(' ')[0]}"
