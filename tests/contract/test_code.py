"""What holds for every file: linters, layers, docstrings and their examples, length, what a file mentions."""

import ast
import doctest
import importlib
import re
import subprocess
import sys
from pathlib import Path

import pytest
from tests import sentences
from tests.times import read_times

ROOT = Path(__file__).parents[2]
SOURCE = ROOT / "src"
MODULES = sorted(SOURCE.rglob("*.py"))
DOCUMENTS = sorted(path for folder in ("src", "docs") for path in (ROOT / folder).rglob("*.md")) + list(
    ROOT.glob("*.md")
)
SCRIPTS = [path for folder in ("tests", "benchmarks", "docs") for path in (ROOT / folder).rglob("*.py")]
SETTINGS = [ROOT / name for name in (".ci/run", ".gitignore", "CITATION.cff", "conftest.py", "pyproject.toml")]
MOST_LINES = 400

PYTHON = sys.executable
TOOLS = {
    "ruff check": [PYTHON, "-m", "ruff", "check", "."],
    "ruff format": [PYTHON, "-m", "ruff", "format", "--check", "."],
    "lint-imports": [str(Path(PYTHON).with_name("lint-imports")), "--no-logo"],
}


def name_of(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def module_name(path: Path) -> str:
    parts = path.relative_to(SOURCE).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def undocumented(tree: ast.Module) -> list[str]:
    """Public functions and classes without a docstring, and public methods of public classes."""
    kinds = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
    found: list[str] = []
    for node in tree.body:
        members = node.body if isinstance(node, ast.ClassDef) and not node.name.startswith("_") else []
        found += [
            f"{part.name} (line {part.lineno})"
            for part in (node, *members)
            if isinstance(part, kinds) and not part.name.startswith("_") and not ast.get_docstring(part)
            if "overload" not in map(ast.unparse, part.decorator_list)
        ]
    return found


@pytest.mark.parametrize("tool", TOOLS)
def test_tool_finds_nothing(tool):
    done = subprocess.run(TOOLS[tool], cwd=ROOT, capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_modules_are_short():
    lengths = {name_of(path): len(path.read_text(encoding="utf-8").splitlines()) for path in MODULES}
    assert {name: length for name, length in lengths.items() if length > MOST_LINES} == {}, (
        "part these modules by their subjects"
    )


def test_public_names_have_docstrings():
    found = {name_of(path): undocumented(ast.parse(path.read_text(encoding="utf-8"))) for path in MODULES}
    assert {name: names for name, names in found.items() if names} == {}, "write a docstring for these"


@pytest.mark.parametrize("path", [path for path in MODULES if path.name != "__main__.py"], ids=name_of)
def test_examples_in_docstrings(path):
    outcome = doctest.testmod(importlib.import_module(module_name(path)), optionflags=doctest.ELLIPSIS)
    assert outcome.failed == 0, "an example in a docstring gives something else than it says: see the output"


def test_files_know_no_machine_but_the_users():
    """A folder of the machine on which a line was written means nothing on another."""
    folder = re.compile(r"(?<![\w.:/])/(?:home|mnt|root|tmp|work)\b")
    files = [*MODULES, *DOCUMENTS, *SCRIPTS, *SETTINGS]
    assert [name_of(path) for path in files if folder.search(path.read_text(encoding="utf-8"))] == []


def test_no_file_is_a_link():
    """A link leads to where its maker had something, and takes all that lies there into what is built."""
    own = [ROOT / name for name in ("benchmarks", "docs", "src", "tests", "client/src", "client/test", ".ci")]
    found = [*ROOT.iterdir(), *(path for folder in own for path in folder.rglob("*"))]
    assert [name_of(path) for path in found if path.is_symlink()] == []


def test_documents_named_in_a_file_exist():
    present = {path.name for path in DOCUMENTS}
    named = {
        name: name_of(path)
        for path in [*MODULES, *DOCUMENTS, *SCRIPTS, *SETTINGS]
        for name in re.findall(r"\b[\w-]+\.md\b", path.read_text(encoding="utf-8"))
    }
    assert {name: path for name, path in named.items() if name not in present} == {}, (
        "there is no such document: name one that there is"
    )


def test_sentences_of_the_table_stand_nowhere_else():
    pinned = [text for name, text in vars(sentences).items() if name.isupper()]
    files = [path for path in (ROOT / "tests").rglob("*.py") if path.name != "sentences.py"]
    again = {name_of(path): [text for text in pinned if text in path.read_text(encoding="utf-8")] for path in files}
    assert {name: texts for name, texts in again.items() if texts} == {}, "take the sentence from tests/sentences.py"


def test_tests_whose_times_are_known_exist():
    """Lines of `tests/times.txt` for others can be struck out."""
    known = (one.partition("::") for one in read_times())
    gone = [(path, function) for path, _colons, function in known if not has_test(path, function)]
    assert gone == [], "strike these lines out of tests/times.txt"


def has_test(path, function):
    return (ROOT / path).exists() and function.rpartition("::")[2] in (ROOT / path).read_text(encoding="utf-8")


@pytest.mark.parametrize("path", sorted((ROOT / "benchmarks").glob("*.py")), ids=name_of)
def test_what_benchmarks_import_is_there(path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("cranktrain"):
            module = importlib.import_module(str(node.module))
            missing = [name.name for name in node.names if not hasattr(module, name.name)]
            assert missing == [], node.module
