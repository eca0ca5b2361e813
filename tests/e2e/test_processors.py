"""What is printed is the same on another kind of processor: as `benchmarks/processors.py` compares it."""

import pytest
from tests.unit.test_dumps import script

processors = script("processors")
HERE, OTHER = processors.Setting("", 1), processors.Setting("Haswell", 2)
NAMES = ("3d12", "deltic", "compressor_start", "shears")
"""With ties of bearings and journals, a torque that changes its sign at 0°, loads that come to nothing."""


def test_texts_are_the_same():
    texts, other = (processors.texts_of(setting, NAMES, ("run {} --full",)) for setting in (HERE, OTHER))
    assert all(text.endswith("status 0\n") for text in texts.values())
    assert list(processors.differences(texts, other, HERE, OTHER)) == []


@pytest.mark.parametrize(
    ("text", "other", "n_found"),
    [
        ("in bearing 3\n", "in bearing 3\n", 0),
        ("in bearing 3\n", "in bearing 5\n", 1),
        ("✓ holds (residual 2.4e-12, limit 1e-09)\n", "✓ holds (residual 1.9e-13, limit 1e-09)\n", 0),
        ("✓ holds (residual 2.4e-12, limit 1e-09)\n", "✗ fails (residual 1.9e-08, limit 1e-09)\n", 1),
        ("5.000e-12\n", "6.000e-12\n", 1),
    ],
)
def test_what_differs(text, other, n_found):
    assert len(list(processors.differences({"run": text}, {"run": other}, HERE, OTHER))) == n_found
