"""Reference cases: machines with results that were computed independently, as stored unchanged in `tests/golden`.

`case.json` holds the machine (units in its keys), the conventions and the tolerances; a CSV file the curves (units in
the column names).
"""

import csv
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

GOLDEN = Path(__file__).parent / "golden"


@dataclass(frozen=True)
class ReferenceCase:
    """A machine, its expected curves and single numbers, and how closely they are to be met."""

    name: str
    machine: dict[str, Any]
    document: dict[str, Any]
    rows: tuple[dict[str, str], ...]

    @classmethod
    def load(cls, name: str) -> "ReferenceCase":
        """Read the case of a folder of `tests/golden`."""
        document = json.loads((GOLDEN / name / "case.json").read_text(encoding="utf-8"))
        expected = document.get("expected")
        rows: list[dict[str, str]] = []
        if expected:
            with (GOLDEN / name / expected["file"]).open(encoding="utf-8", newline="") as file:
                rows = list(csv.DictReader(file))
        return cls(name, document["machine"], document, tuple(rows))

    def selected(self, curve: str) -> "ReferenceCase":
        """The rows of one of several curves in the file, by the column that tells them apart."""
        column = self.document["expected"]["select"]
        rows = tuple(row for row in self.rows if row[column] == curve)
        return ReferenceCase(self.name, self.machine, self.document, rows)

    def column(self, name: str) -> Array:
        return np.array([float(row[name]) for row in self.rows])

    @property
    def crank_angle(self) -> Array:
        """The crank angles of the rows. [rad]"""
        return np.deg2rad(self.column(self.document["expected"]["x"]))

    def deviation(self, column: str, computed: ArrayLike) -> float:
        """Largest difference from the column, modulo a turn where the case says so; in the column's unit."""
        difference = np.asarray(computed) - self.column(column)
        modulo = self.document["tolerance"].get("modulo", {}).get(column)
        if modulo:
            difference = (difference + modulo / 2) % modulo - modulo / 2
        return float(np.max(np.abs(difference)))

    def peak(self, column: str) -> float:
        return float(np.max(np.abs(self.column(column))))

    def tolerance(self, column: str) -> float:
        """The case's own tolerance for a column, in the column's unit."""
        stated = self.document["tolerance"]
        if column in stated.get("abs", {}):
            return float(stated["abs"][column])
        relative = stated["rel_to_peak"]
        if isinstance(relative, dict):
            relative = relative.get(column, relative["default"])
        return float(relative) * self.peak(column)

    def compare(self, computed: dict[str, ArrayLike], rel_to_peak: float | None = None) -> None:
        """Assert that columns agree, as closely as the case states or, if given, to a share of each column's peak."""
        problems: list[str] = []
        for column, values in computed.items():
            allowed = self.tolerance(column)
            if rel_to_peak is not None:
                allowed = min(allowed, rel_to_peak * self.peak(column))
            deviation = self.deviation(column, values)
            # Also where the deviation is NaN.
            if not deviation <= allowed:
                problems.append(f"{self.name}, {column}: off by {deviation:.3g}, allowed {allowed:.3g}")
        assert not problems, "\n".join(problems)

    def compare_value(self, name: str, computed: float) -> None:
        """Assert that a single number agrees as closely as the case states."""
        expected = self.document["expected_values"][name]
        allowed = expected["abs"] if "abs" in expected else expected["rel"] * abs(expected["value"])
        deviation = abs(computed - expected["value"])
        assert deviation <= allowed, f"{self.name}, {name}: off by {deviation:.3g}, allowed {allowed:.3g}"
