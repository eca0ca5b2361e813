"""Whoever has the largest or the smallest of some values is chosen by one rule, that of `numerics/ties.py`."""

import ast

import numpy as np
import pytest
from tests.contract.test_code import MODULES, SOURCE

from cranktrain.numerics.ties import (
    falling,
    first_largest,
    first_largest_along,
    first_smallest,
    largest_of,
    smallest_of,
    without_residue,
)

PACKAGE = SOURCE / "cranktrain"
RULE = PACKAGE / "numerics" / "ties.py"
PLACES = {"argmax", "argmin", "nanargmax", "nanargmin"}
EXTREMES = {"max", "min", "nanmax", "nanmin"}

EXEMPT = {
    "cli/screen/facts.py": "the longest list of members",
    "numerics/pieces.py": "has the rule for angles: of alike peaks the first in the period",
    "quantities/choice.py": "how often a unit is used, and which unit",
    "questions/reduction/at_angles.py": "the value alone, about the largest sample",
    "transient/clutched/passings.py": "the value alone, about the least sample",
    "questions/drive/steady_cycle.py": "the value alone, about the largest sample",
    "questions/pumping/turn_pieces.py": "the sample of a piece about which its top is looked for",
    "synthesis/four_bars.py": "the sample about which a root is looked for",
    "texts/drive_errata.py": "the value alone",
    "texts/drive_verdicts.py": "the value alone",
    "viz/plans/force_rooms.py": "the scale alone",
    "panels/throw_scene.py": "numbers of throws",
}
"""Modules that choose otherwise, and what they choose."""


def is_of_truths(node):
    """Whether places are those of truths, of which the first is meant: a comparison, or a name that says so."""
    match node:
        case ast.Compare():
            # What is compared with the largest is a rule of ties of one's own.
            return not any(getattr(part, "attr", "") in EXTREMES for part in ast.walk(node))
        case ast.BinOp(left=left, op=ast.BitAnd() | ast.BitOr()):
            return is_of_truths(left)
        case ast.Call(func=ast.Attribute(attr="any" | "all")):
            return True
        case ast.Name(id=name):
            return name.startswith(("is_", "has_"))
    return False


def past_the_rule(tree):
    """Calls that take the largest or smallest of some values as rounding has it."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        by_place = name in PLACES and not (node.args and is_of_truths(node.args[0]))
        by_key = name in ("max", "min") and any(word.arg == "key" for word in node.keywords)
        falls = name == "argsort" and node.args and isinstance(node.args[0], ast.UnaryOp)
        if by_place or by_key or (falls and isinstance(node.args[0].op, ast.USub)):
            yield f"line {node.lineno}: {ast.unparse(node)}"


def test_all_go_by_the_rule():
    found = {
        path.relative_to(PACKAGE).as_posix(): list(past_the_rule(ast.parse(path.read_text(encoding="utf-8"))))
        for path in MODULES
        if path != RULE
    }
    assert {name: calls for name, calls in found.items() if calls and name not in EXEMPT} == {}
    assert [name for name in EXEMPT if not found[name]] == []


@pytest.mark.parametrize(
    ("text", "n_found"),
    [
        ("np.argmax(np.abs(values))", 1),
        ("values.argmin()", 1),
        ("max(rows, key=len)", 1),
        ("np.argsort(-size)", 1),
        ("np.argmax(values >= 0.99 * np.max(values))", 1),
        ("np.argmax(values > 0)", 0),
        ("np.argmax(is_open, axis=1)", 0),
        ("np.argsort(angle)", 0),
    ],
)
def test_what_is_found(text, n_found):
    assert len(list(past_the_rule(ast.parse(text)))) == n_found


@pytest.mark.parametrize("noise", [0.0, 1e-10, -1e-10])
def test_rounding_chooses_nobody(noise):
    values = [1.0, 5.0 + noise, 5.0, np.nan, 5.0 - noise]
    assert first_largest(values) == 1
    assert first_smallest([-one for one in values]) == 1
    assert falling(values) == [1, 2, 4, 0, 3]
    assert largest_of("abcde", dict(zip("abcde", values, strict=True)).__getitem__) == "b"
    assert smallest_of("abc", {"a": 2.0, "b": 1.0 + abs(noise), "c": 1.0}.__getitem__) == "b"


def test_places_without_values():
    with np.errstate(all="raise"):
        assert first_largest([np.nan, np.nan]) == 0
        assert first_largest([np.nan, -np.inf]) == 1
        assert first_largest([0.0, np.inf, np.inf]) == 1
        assert first_largest_along(np.array([[np.nan, 1.0], [0.0, 0.0]])).tolist() == [1, 0]
        assert without_residue(np.array([np.nan, 1e-10, 1e-3]), 1.0).tolist()[1:] == [0.0, 1e-3]
