"""Every quantity says by which equation of the theory it is found: the number stands on the page that it names."""

import re
from dataclasses import replace
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from tests.example_runs import ran
from tests.stages import EVERY_STAGE

import cranktrain as ct
from cranktrain.saying.catalogue import DEFINITION, entries

ROOT = Path(__file__).parents[2]
ENTRIES = [entry for stage in EVERY_STAGE for entry in entries(stage.gives)]
ONE = r"\d+\.\d+( to \d+\.\d+)?"
WRITTEN = re.compile(rf"{ONE}(, {ONE})*")


@cache
def labels(page):
    """Numbers of a page's equations."""
    text = (ROOT / f"{page}.md").read_text(encoding="utf-8")
    return frozenset(re.findall(r"^\$\$ \((\d+\.\d+)\)$", text, re.MULTILINE))


def wrong(entry):
    """What is wrong with the equation of a quantity; nothing where it is right."""
    if entry.equation == DEFINITION:
        return ""
    if not WRITTEN.fullmatch(entry.equation):
        return f"{entry.equation!r} is written in another way than '13.35, 13.36', '1.4 to 1.6' or 'definition'"
    ranges = [one.split(" to ") for one in entry.equation.split(", ")]
    lost = [number for one in ranges for number in one if number not in labels(entry.source)]
    if lost:
        return f"{entry.source} has no equation {', '.join(lost)}"
    rising = [tuple(map(int, number.split("."))) for one in ranges for number in one]
    return "" if all(a < b for a, b in pairwise(rising)) else f"{entry.equation!r}: numbers rise"


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.name)
def test_every_quantity_has_an_equation_that_its_page_has(entry):
    assert wrong(entry) == "", "write the number that the equation has on the page of `source`, or `definition`"


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"equation": "2.99"}, "docs/theory/slider-crank has no equation 2.99"),
        ({"equation": "2.6, 13.35"}, "docs/theory/slider-crank has no equation 13.35"),
        ({"equation": "2.6 to 2.99"}, "docs/theory/slider-crank has no equation 2.99"),
        ({"source": "docs/theory/forces"}, "docs/theory/forces has no equation 2.7"),
        ({"source": "docs/conventions"}, "docs/conventions has no equation 2.7"),
        ({"equation": "2.7, 2.6"}, "'2.7, 2.6': numbers rise"),
        ({"equation": "2.9 to 2.10"}, ""),
        ({"equation": "(2.7)"}, "'(2.7)' is written in another way"),
        ({"equation": ""}, "'' is written in another way"),
    ],
)
def test_a_wrong_equation_is_found(changed, said):
    (stroke,) = (entry for entry in ENTRIES if entry.name == "stroke")
    assert (stroke.source, stroke.equation) == ("docs/theory/slider-crank", "2.7")
    found = wrong(replace(stroke, **changed))
    assert found.startswith(said) if said else found == ""


EVERY = {entry.name: entry for entry in ENTRIES}
LINES = {name: entry for name, entry in EVERY.items() if entry.line}


def of_line(entry, result):
    """What a line gives with the values of its quantities."""
    written = entry.line.replace("−", "-").replace("·", "*")
    written = re.sub(r"Σ \{(\w+)\}", r"\1.sum(axis=-1)", written)
    values = {name: np.asarray(getattr(result, name)) for name in entry.line_of}
    return eval(re.sub(r"[{}]", "", written), {"__builtins__": {}}, values)


@pytest.mark.parametrize("name", LINES)
def test_a_line_of_symbols_is_the_quantity(name):
    """With the values that it names, in every example that has it: what a report substitutes gives what it says."""
    held = 0
    for example in ct.example_names():
        result = ran(example)
        if name in result.catalogue and all(one in result.catalogue for one in LINES[name].line_of):
            found, line = np.asarray(getattr(result, name)), of_line(LINES[name], result)
            np.testing.assert_allclose(line, found, rtol=1e-9, atol=1e-9 * np.nanmax(np.abs(found), initial=0.0))
            held += 1
    assert held, "no example has it"


def test_a_line_is_written_in_symbols():
    assert EVERY["stroke"].in_symbols(EVERY) == "S = H − h"
    assert EVERY["displacement"].in_symbols(EVERY) == "V_H = Σ V_h"
    assert EVERY["top_position"].in_symbols(EVERY) == ""
