"""Names that are completed: those of the examples from their folder, all others from a list that was made once.

`python -m cranktrain.cli.completing.making` makes the list anew; a test says when it has to be.
"""

import json
from functools import cache
from pathlib import Path
from typing import Any

EXAMPLES_FOLDER = Path(__file__).parents[2] / "examples"
LIST = Path(__file__).parent / "names.json"


@cache
def names() -> dict[str, Any]:
    """Read the list: `results`, `kinds`, `units`, and `keys` of the tables of a machine file by their paths."""
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
