"""What may be done with a machine on a page: tables that its file may have, too, and facts that may be asked for."""

from collections.abc import Iterator

from cranktrain.analysis import Result
from cranktrain.io.machine_file import MachineFile
from cranktrain.io.offers import offered_tables
from cranktrain.language import Words
from cranktrain.record import record
from cranktrain.saying.names import said_name
from cranktrain.web.exporting import ExportForm, export_forms
from cranktrain.web.page import PageTrust, page_trust


@record
class PageOffer:
    """A table that a machine file may have, too: its name in the file, and what is there with it."""

    key: str
    words: Words


@record
class OfferedFact:
    """A fact that may be asked for over values of the file: its name in results, and what people call it."""

    name: str
    title: Words


@record
class PageGoingOn:
    """How far a machine can be trusted, and how one may go on with it: its facts, the headlines first; files of it."""

    trust: PageTrust
    offers: tuple[PageOffer, ...]
    facts: tuple[OfferedFact, ...]
    exports: tuple[ExportForm, ...]


def page_going_on(file: MachineFile, result: Result) -> PageGoingOn:
    """Collect all of it."""
    offers = tuple(PageOffer(table.key, table.words) for table in offered_tables(file))
    return PageGoingOn(page_trust(result), offers, tuple(_facts(result)), export_forms())


def _facts(result: Result) -> Iterator[OfferedFact]:
    """Name the facts of a machine, those that its questions begin with first."""
    headlines = [name for question in result.machines[0].questions for name in question.headline]
    for name in dict.fromkeys((*headlines, *result.catalogue)):
        if name in result.catalogue and result.catalogue[name].is_fact:
            yield OfferedFact(name, said_name(name))
