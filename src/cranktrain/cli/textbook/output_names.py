"""What `textbook -o` may write, by how the name ends."""

from collections.abc import Iterator
from pathlib import PurePath

from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.viz.output import FORMATS

TABLE, CURVES = ".toml", ".csv"


def output_problems(output: str | None, *kinds: str, force: bool) -> Iterator[Problem]:
    """Refuse a name that says nothing of what is to be written: one of `kinds`, or a picture; `--force` without one."""
    if output is None and force:
        yield Problem("--force", None, _("is for a file that is written: ask for -o FILE, too"))
    known = (*kinds, *FORMATS)
    if output is not None and PurePath(output).suffix.lower() not in known:
        yield Problem("-o", output, _("must end in one of: {suffixes}").format(suffixes=", ".join(known)))
