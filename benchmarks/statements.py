"""How much code there is, in statements of the syntax tree: here, and at other commits.

    python benchmarks/statements.py
    python benchmarks/statements.py main HEAD --without questions/torsion

Imports, with what only guards them, and docstrings do not count. Nodes of the same trees stand beside: statements that
were only joined leave as many of them as before. Without commits it is the code that is here, saved or not.
"""

import argparse
import ast
import io
import subprocess
import tarfile
from collections import Counter
from pathlib import Path
from statistics import median
from typing import NamedTuple

ROOT = Path(__file__).parents[1]
SOURCE = "src/cranktrain"
MOST_LINES = 400
"""More are too many for a module."""


class Size(NamedTuple):
    """Of a module."""

    statements: int
    nodes: int
    lines: int


def size(text):
    """Size of a module's text."""
    counted = [node for node in counted_nodes(ast.parse(text)) if not isinstance(node, ast.expr_context)]
    return Size(sum(isinstance(node, ast.stmt) for node in counted), len(counted), len(text.splitlines()))


def counted_nodes(tree):
    """Go through all of a tree but imports and docstrings."""
    for child in ast.iter_child_nodes(tree):
        if not is_apart(child):
            yield child
            yield from counted_nodes(child)


def is_apart(node):
    """Whether it is an import, an `if` around imports alone, or a string that is only written, not used."""
    match node:
        case ast.Import() | ast.ImportFrom() | ast.Expr(ast.Constant(str())):
            return True
        case ast.If(body=body, orelse=[]):
            return all(is_apart(one) for one in body)
        case _:
            return False


def sizes(commit=None, without=()):
    """Sizes of modules by path below the source folder."""
    texts = texts_here() if commit is None else texts_at(commit)
    kept = {path: text for path, text in texts.items() if not any(is_in(path, folder) for folder in without)}
    return {path: size(text) for path, text in sorted(kept.items())}


def is_in(path, folder):
    return path == folder or path.startswith(f"{folder.rstrip('/')}/")


def texts_here():
    folder = ROOT / SOURCE
    return {path.relative_to(folder).as_posix(): path.read_text(encoding="utf-8") for path in folder.rglob("*.py")}


def texts_at(commit):
    command = ["git", "-C", str(ROOT), "archive", "--format=tar", commit, SOURCE]
    packed = subprocess.run(command, check=True, capture_output=True).stdout
    with tarfile.open(fileobj=io.BytesIO(packed)) as archive:
        files = [member for member in archive if member.name.endswith(".py")]
        return {one.name.removeprefix(f"{SOURCE}/"): archive.extractfile(one).read().decode() for one in files}


def top(path):
    """Top folder of a module; its own name, where it is in none."""
    return path.partition("/")[0]


def table(columns):
    """Lines of statements by top folder, their sum and what else is told of modules; a column of each commit."""
    by_folder = {name: Counter() for name in columns}
    for name, modules in columns.items():
        for path, one in modules.items():
            by_folder[name][top(path)] += one.statements
    yield row("statements", columns)
    for folder in sorted(set().union(*by_folder.values())):
        yield row(f"  {folder}", [by_folder[name][folder] or "–" for name in columns])
    yield row("  all", [sum(counter.values()) for counter in by_folder.values()])
    if len(columns) > 1:
        first, *_ = totals = [sum(counter.values()) for counter in by_folder.values()]
        yield row("  of the first", [f"{100 * (total / first - 1):+.1f} %" for total in totals])
    yield row("nodes", [sum(one.nodes for one in modules.values()) for modules in columns.values()])
    yield row("modules", [len(modules) for modules in columns.values()])
    yield row("median of lines", [f"{median(one.lines for one in modules.values()):g}" for modules in columns.values()])
    for name, modules in columns.items():
        for path, one in modules.items():
            if one.lines > MOST_LINES:
                yield f"{one.lines} lines, more than {MOST_LINES}: {path} ({name})"


def row(head, cells):
    return f"{head:<24}" + "".join(f"{cell:>14}" for cell in cells)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("commit", nargs="*", help="each a column; none is the code that is here")
    parser.add_argument(
        "--without", action="append", default=[], metavar="PATH", help="below the source folder, in no column"
    )
    given = parser.parse_args()
    columns = {name: sizes(name, given.without) for name in given.commit} or {"here": sizes(without=given.without)}
    print("\n".join(table(columns)))


if __name__ == "__main__":
    main()
