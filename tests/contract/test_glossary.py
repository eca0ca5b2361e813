"""The glossary: what it names is there, no word is said twice, and words that are not used name nothing in the code."""

import ast
import pkgutil
import re
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
USED, _head, NOT_USED = (ROOT / "docs/glossary.md").read_text(encoding="utf-8").partition("## Words that are not used")
WORDS = [
    row for row in re.findall(r"^\| ([^|]+) \| ([^|]+) \| (?:`([\w.]+)`)? ?\|$", USED, re.MULTILINE) if row[0] != "word"
]
INSTEAD = dict(re.findall(r"^\| (\w+) \| ([^|]+) \|$", NOT_USED, re.MULTILINE))


def rows(text: str) -> int:
    """Rows of all tables of a text, without their two lines of head."""
    lines = text.splitlines()
    return sum(line.startswith("|") for line in lines) - 2 * sum(line.startswith("|---") for line in lines)


@cache
def names() -> dict[str, list[str]]:
    """Classes and functions of the package, each with the modules that have it, by the words of its name."""
    found: dict[str, list[str]] = {}
    for path in (ROOT / "src").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("__"):
                for word in words_of(node.name):
                    found.setdefault(word, []).append(f"{path.relative_to(ROOT).as_posix()}: {node.name}")
    return found


def words_of(name: str) -> set[str]:
    """Words of a name, as `LoadedMachine` or `loaded_machine` joins them."""
    return {word.lower() for word in re.findall(r"[A-Z]?[a-z0-9]+|[A-Z]+(?![a-z])", name)}


def test_every_row_is_read():
    assert len(WORDS) == rows(USED)
    assert len(INSTEAD) == rows(NOT_USED)


def test_no_word_is_said_twice():
    said = Counter([*(word for word, _meaning, _named in WORDS), *INSTEAD])
    assert [word for word, n in said.items() if n > 1] == [], "a word stands once in docs/glossary.md"


@pytest.mark.parametrize(("word", "named"), [(word, named) for word, _meaning, named in WORDS if named])
def test_what_a_word_names_is_there(word, named):
    *path, last = named.split(".")
    try:
        pkgutil.resolve_name(f"cranktrain.{named}")
    except AttributeError:  # a field without a default is none of its class
        assert last in pkgutil.resolve_name("cranktrain." + ".".join(path)).__dataclass_fields__, word


@pytest.mark.parametrize("word", INSTEAD)
def test_words_that_are_not_used_name_nothing(word):
    assert names().get(word, []) == [], f"docs/glossary.md says which word is used instead of {word}"


def test_one_public_class_has_a_name():
    """Two of one name are two things with one word."""
    named = Counter(
        node.name
        for path in (ROOT / "src").rglob("*.py")
        for node in ast.parse(path.read_text(encoding="utf-8")).body
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_")
    )
    assert [name for name, n in named.items() if n > 1] == [], "two classes have this name: give one of them another"
