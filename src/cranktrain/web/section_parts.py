"""Sections as the terminal shows them, as parts of a page: sentences, and numbers in tables."""

from collections.abc import Iterable, Iterator, Sequence

from cranktrain.panels.parts import Notes
from cranktrain.saying.section_texts import written_column
from cranktrain.saying.sections import Grid, PagePart, Part, Rows, ShownSection, Unfolded
from cranktrain.saying.typesetting import in_type
from cranktrain.web.parts import PageSection, PageTable


def page_sections(sections: Iterable[PagePart]) -> Iterator[PageSection]:
    """Give sections, each with its heading; sentences that stand alone have none."""
    for one in sections:
        if isinstance(one, ShownSection):
            yield PageSection(_said(one.heading), tuple(_parts(one.parts)))
        else:
            yield PageSection("", (Notes((_said(one),)),))


def _said(words: object) -> str:
    """Say words as they are printed."""
    return in_type(str(words))


def _parts(parts: Sequence[Part]) -> Iterator[PageTable | Notes]:
    """Give tables, and sentences one after the other."""
    sentences: list[str] = []
    for part in parts:
        match part:
            case Grid() | Rows():
                if sentences:
                    yield Notes(tuple(sentences))
                    sentences = []
                yield _grid(part) if isinstance(part, Grid) else _rows(part)
            case Unfolded(words=words):
                sentences.append(_said(words))
            case _:
                sentences.append(_said(part))
    if any(sentences):
        yield Notes(tuple(filter(None, sentences)))


def _grid(grid: Grid) -> PageTable:
    """Write numbers in columns, their units in the heads."""
    columns = [written_column(column) for column in grid.columns]
    heads = (", ".join(filter(None, map(_said, (one.head, one.unit)))) for one in columns)
    labels = list(map(_said, grid.labels)) or [""] * len(columns[0].values)
    return PageTable(
        title="",
        heads=(_said(grid.title), *heads),
        groups=("",) * (1 + len(columns)),
        rows=tuple(zip(labels, *(map(_said, one.values) for one in columns), strict=True)),
        methods=(),
        notes=(),
    )


def _rows(rows: Rows) -> PageTable:
    """Write words in rows."""
    n = len(rows.cells[0])
    return PageTable(
        title="",
        heads=tuple(map(_said, rows.heads)) or ("",) * n,
        groups=("",) * n,
        rows=tuple(tuple(map(_said, row)) for row in rows.cells),
        methods=(),
        notes=(),
        of_words=tuple(place for place in range(1, n) if place not in rows.right),
    )
