"""The examples that come with the package, by name."""

import re
from pathlib import Path

from cranktrain.io.document import Document
from cranktrain.language import said as _

EXAMPLES_FOLDER = Path(__file__).parents[1] / "examples"


def example_names() -> tuple[str, ...]:
    """Name the examples that come with the program, in alphabetical order.

    Returns
    -------
    tuple of str

    Examples
    --------
    >>> "3d12" in example_names()
    True
    """
    return tuple(sorted(path.stem for path in EXAMPLES_FOLDER.glob("*.toml")))


def example_text(name: str) -> str:
    """Read the file of the example of that very name."""
    return (EXAMPLES_FOLDER / f"{name}.toml").read_text(encoding="utf-8")


def example_document(name: str) -> Document:
    """Read the example of that very name."""
    return Document.from_text(example_text(name), _("example {name}", name=name))


def example_called(name: str) -> str | None:
    """Find the example that a name means: capitals do not matter, nor `-` for `_`; None where none is meant."""
    return next((example for example in example_names() if plain_name(example) == plain_name(name)), None)


def example_near(name: str) -> str | None:
    """Find the example that a name may mean; None for what looks like a file, or is like none."""
    import difflib  # only needed after a mistake

    close = difflib.get_close_matches(plain_name(name), example_names(), n=1)
    return close[0] if close and re.fullmatch(r"[\w-]+", name) else None


def plain_name(name: str) -> str:
    """Spell the name of an example or a kind one way: capitals do not matter, nor `-` for `_`."""
    return name.casefold().replace("-", "_")
