"""Names that are completed: those of the examples from their folder, all others from a list made with the package."""

import json
from functools import cache
from pathlib import Path
from typing import Any

EXAMPLES_FOLDER = Path(__file__).parents[2] / "examples"
LIST = Path(__file__).parent / "names.json"


@cache
def names() -> dict[str, Any]:
    """Read the list: `results`, `kinds`, `units`, and `keys` of the tables of a machine file by their paths."""
    if not LIST.exists():
        from cranktrain.cli.completing.making import made  # the whole program, where it was not built

        return made()
    return json.loads(LIST.read_text(encoding="utf-8"))


def words(which: str) -> list[str]:
    """Give one list of names."""
    return names()[which]


def results() -> list[str]:
    """Name all results."""
    return words("results")


def example_names() -> list[str]:
    """Name the examples."""
    return sorted(path.stem for path in EXAMPLES_FOLDER.glob("*.toml"))
