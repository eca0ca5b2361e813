"""`textbook --forces`: a piston's forces at round crank angles, exact and by the textbook's formula, with errors."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from cranktrain.language import Words, _
from cranktrain.motion import Array
from cranktrain.numerics.ties import largest_of
from cranktrain.plans.force_table import ForceColumn, ForceTable
from cranktrain.saying.sections import Column, Decimals, Grid, ShownSection
from cranktrain.saying.wording import decimals_for
from cranktrain.textbook.shown.tables import degrees

_FIGURES = 5
"""Of the largest number in a column."""
_ROUNDING = 1e-9
"""Of the largest number; what is less is nothing beside it."""
_SAID = 5e-5
"""An error that is shown, in parts of the peak."""

_ByMethod = tuple[ForceColumn, Array, Array]
"""A column with its values and errors by a method."""


def force_sections(table: ForceTable, *, whole: str | None) -> Iterator[ShownSection]:
    """Give forces by the reactions, and what the textbook makes of them.

    Parameters
    ----------
    table : ForceTable
    whole : str or None
        The command for forces and errors at every angle, where only by how much they are off at most is to be given.
    """
    heading = _("Forces of {piston} by the reactions in the joints", piston=table.called)
    if table.area is not None:
        heading = _("{heading}, over its area of {area:.2f} cm²", heading=heading, area=1e4 * table.area)
    yield _section(heading, table, [_forces(one, one.exact) for one in table.columns])
    methods = _methods(table)
    if whole is None:
        for method, columns in methods.items():
            yield from _by_method(_("The same by {method}", method=method), columns, table)
    elif methods:
        yield _largest(methods)
    yield ShownSection(_("What they are"), tuple(_explained(table)))
    if whole is not None and methods:
        yield ShownSection(_("To go on"), (_("`{command}`: at every angle", command=whole),))


def _section(heading: Words, table: ForceTable, columns: Sequence[Column]) -> ShownSection:
    """Give columns at the angles of a table."""
    return ShownSection(heading, (Grid(columns, degrees(table.angle)),))


def _methods(table: ForceTable) -> dict[Words, list[_ByMethod]]:
    """Give every column by each method that there is for the piston."""
    found: dict[Words, list[_ByMethod]] = {
        _("the textbook's P·f(β)"): [(one, one.textbook, one.textbook_error) for one in table.columns],
        _("two harmonics of inertia"): [(one, one.two_harmonics, one.two_harmonics_error) for one in table.columns],
    }
    return {
        method: columns
        for method, columns in found.items()
        if any(np.any(np.isfinite(values)) for _one, values, _error in columns)
    }


def _largest(methods: Mapping[Words, Sequence[_ByMethod]]) -> ShownSection:
    """By how much each method is off where it is off most, at the angles of the table."""
    columns = [
        Column(f"Δ{of[0][0].symbol}", [float(largest_of(error.tolist(), abs)) for *_of, error in of], "%", "percent")
        for of in zip(*methods.values(), strict=True)
    ]
    return ShownSection(_("Largest errors at these angles, of the exact peaks"), (Grid(columns, list(methods)),))


def _by_method(heading: Words, columns: Sequence[_ByMethod], table: ForceTable) -> Iterator[ShownSection]:
    """The forces by a method, and their errors; of P·f(β) that it is the same, where it is."""
    if columns[0][1] is columns[0][0].textbook and all(np.all(np.abs(error) < _SAID) for *_of, error in columns):
        yield ShownSection(heading, (_("The same: this rod is as two masses, and nothing hangs on it."),))
        return
    yield _section(heading, table, [_forces(one, values) for one, values, _error in columns])
    errors = [Column(f"Δ{one.symbol}", error.tolist(), "%", "percent") for one, _values, error in columns]
    yield _section(_("Their errors, of the exact peaks"), table, errors)


def _forces(one: ForceColumn, values: Array) -> Column:
    """Numbers with as many decimals as give the largest of the exact curve its figures, or as show what is less."""
    peak = float(np.max(np.abs(one.exact)))
    how = Decimals(max(0, decimals_for(peak, _FIGURES)), _ROUNDING * peak)
    return Column(one.symbol, values.tolist(), one.unit, how)


def _explained(table: ForceTable) -> Iterator[Words]:
    """Say what the letters stand for."""
    if table.sort == "slave":
        yield _(
            "P along the cylinder toward the shaft, N of the wall toward +y, S along the rod (+ compression); K_i (Z) "
            "toward the shaft, T_i with the rotation and M_i = T_i R: its share of what its master's crank pin bears."
        )
        yield _("Of the rod one share goes with the piston, the other with the knuckle pin; P·f(β) is for no slave.")
        return
    yield _(
        "P along the cylinder toward the shaft, N of the wall toward +y, S along the rod (+ compression), K (or Z) "
        "toward the shaft, T with the rotation, M = TR. The rod's rotating share is in none of them."
    )
    if table.sort == "master":
        yield _("S is at the piston pin; S_A, K, T, M, at the crank pin, hold what slaves do.")
