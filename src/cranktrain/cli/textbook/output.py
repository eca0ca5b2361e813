"""A drive or a throw: shown, or by how the name behind `-o` ends its table, its curves or its figures written."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import PurePath
from typing import TYPE_CHECKING

from cranktrain.cli.quiet_pictures import save_quietly
from cranktrain.cli.screen.sections import show_page
from cranktrain.cli.textbook.typed import TextbookRequest
from cranktrain.errors import Problem
from cranktrain.extras import lacking_for
from cranktrain.io.output import write_whole
from cranktrain.language import Words
from cranktrain.language import said as _
from cranktrain.one_line import one_line
from cranktrain.saying.sections import PagePart
from cranktrain.viz.output import FORMATS

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TABLE, CURVES = ".toml", (".csv", ".json", ".xlsx", ".nc")


def output_problems(asked: TextbookRequest, *kinds: str) -> Iterator[Problem]:
    """Refuse a name that says nothing of what is to be written: one of `kinds`, or a picture; `--force` without one."""
    if asked.output is None and asked.force:
        yield Problem("--force", None, _("is for a file that is written: ask for -o FILE, too"))
    known = (*kinds, *FORMATS)
    suffix = PurePath(asked.output or "").suffix.lower()
    yield from lacking_for(suffix)
    if asked.output is not None and suffix not in known:
        yield Problem("-o", asked.output, _("must end in one of: {suffixes}", suffixes=", ".join(known)))


def show_or_write(
    asked: TextbookRequest,
    head: Words,
    sections: Iterable[PagePart],
    texts: Mapping[str, Callable[[], str | Iterable[str | bytes]]],
    draw: "Callable[[], Figure]",
) -> None:
    """Show sections below their head; or write a text by how the name ends, or the figures, and say so."""
    if asked.output is None:
        show_page(head, sections)
        return
    make = texts.get(PurePath(asked.output).suffix.lower())
    if make is None:
        save_quietly(draw, asked.output, force=asked.force)
    else:
        write_whole(asked.output, make(), force=asked.force)
    print(_("written: {name}", name=one_line(asked.output)))
