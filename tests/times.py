"""Which tests are quick: measured times decide, those of `times.txt` beside this file.

`pytest --measure` writes them anew. A function whose cases take less than a tenth of a second together is quick with
all of them; of any other the quickest case stands for it, if that takes as little. The blocks of a document go
together, as later ones rest on those before. What was never measured is quick.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

TABLE = Path(__file__).parent / "times.txt"
LONG = 0.1
"""What takes longer is not quick. [s]"""


class Times(NamedTuple):
    """What the cases of a function take together [s], the quickest one, and what that takes [s]."""

    together: float
    alone: float
    quickest: str


def owner_of(case: str) -> str:
    """The function that a case is of, or the document."""
    file, _colons, function = case.partition("::")
    return file if file.endswith(".md") else f"{file}::{function.partition('[')[0]}"


def read_times() -> dict[str, Times]:
    """Times of the functions and documents that take long enough to be told of."""
    rows = (line.split(maxsplit=2) for line in TABLE.read_text(encoding="utf-8").splitlines())
    return {owner_of(case): Times(float(together), float(alone), case) for together, alone, case in rows}


def is_quick(case: str, times: Mapping[str, Times]) -> bool:
    """Whether a case belongs to those that are run while working."""
    of = times.get(owner_of(case))
    return of is None or of.together < LONG or (case == of.quickest and of.alone < LONG)


def write_times(measured: Mapping[str, float], prepared: Mapping[str, float], known: Mapping[str, Times]) -> None:
    """Write what cases took [s], with what is known of those that were not run.

    A case that is run without others may take longer than among them: what they share, another had found for it. So
    what a case of a file was prepared for [s], which others of the file may need, counts for all that the file has.
    """
    cases: dict[str, dict[str, float]] = {}
    for case, seconds in measured.items():
        cases.setdefault(owner_of(case), {})[case] = seconds
    found = dict(known)
    for owner, own in cases.items():
        quickest, before = min(own, key=lambda case: (own[case], case)), known.get(owner)
        is_part = before is not None and set(own) == {before.quickest}
        ready = prepared.get(owner.partition("::")[0], 0.0)
        together = max(before.together, own[quickest]) if is_part else max(sum(own.values()), ready)
        found[owner] = Times(together, together if owner.endswith(".md") else max(own[quickest], ready), quickest)
    rows = (f"{of.together:8.2f} {of.alone:7.2f} {of.quickest}\n" for of in found.values() if of.together >= LONG)
    TABLE.write_text("".join(sorted(rows, key=lambda row: row.split(maxsplit=2)[2])), encoding="utf-8")
