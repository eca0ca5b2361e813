"""`textbook --forces`: a piston's forces at round crank angles, exact and by the textbook's formula, with errors."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from rich.console import Console

from cranktrain.cli.screen.columns import Column, section_of_columns
from cranktrain.cli.screen.text import page, section
from cranktrain.cli.screen.title import title
from cranktrain.cli.textbook.source import machine_file
from cranktrain.cli.textbook.speaking import with_speaking
from cranktrain.cli.to_type import textbook_command
from cranktrain.errors import Problem, problems_as, refuse
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.numerics.ties import largest_of
from cranktrain.plans.force_table import ForceColumn, ForceTable, force_table
from cranktrain.saying.wording import decimals_for, seen, signless
from cranktrain.texts.percents import percent

STEP = 30.0
"""Of the crank angle unless given. [deg]"""
_FIGURES = 5
"""Of the largest number in a column."""

_ROUNDING = 1e-9
"""Of the largest number; what is less is nothing beside it."""

_SAID = 5e-5
"""An error that is shown, in parts of the peak."""

_ByMethod = tuple[ForceColumn, Array, Array]
"""A column with its values and errors by a method."""


def show_force_tables(
    source: str, settings: Sequence[str], *, unit: str, step: float, piston: str | None, full: bool
) -> None:
    """Show the tables.

    Parameters
    ----------
    source : str
        A machine file or an example.
    settings : sequence of str
        `PATH=VALUE`
    unit : str
        Of the forces.
    step : float
        Of the crank angle. [deg]
    piston : str or None
        Whose forces; the first's unless given.
    full : bool
        Whether to show the forces by each method, too, with their errors at every angle.

    Raises
    ------
    InputError
        With everything that is wrong with the machine, or with the request.
    """
    file = machine_file(source, settings, f"cranktrain textbook 3d12 --forces {unit}")
    with (
        problems_as(lambda problem: problem if problem.path.startswith("-") else file.document.located(problem)),
        problems_as(with_speaking(file.machine, source, settings, ("mechanism",))),
    ):
        table = force_table(file.machine, step=step, unit=unit, piston=piston)
    with page(title(file.machine)) as console:
        _show(console, table, full=full)
        if not full and _methods(table):
            options = [] if step == STEP else ["--step", f"{step:g}"]
            options += [] if piston is None else ["--piston", piston]
            whole = textbook_command(source, "--forces", unit, *options, "--full", settings=settings)
            section(console, _("To go on"), [_("`{command}`: at every angle", command=whole)])


def refuse_without_forces(given: Mapping[str, str | None]) -> None:
    """Refuse options that mean nothing but for tables of forces."""
    allowed = _("is for tables of forces: ask for --forces UNIT, too")
    refuse(Problem(name, value, allowed) for name, value in given.items() if value is not None)


def refuse_with_forces(given: Mapping[str, str | None]) -> None:
    """Refuse options that mean nothing for tables of forces."""
    allowed = _("is for the motion: ask for it without forces")
    refuse(Problem(name, value or None, allowed) for name, value in given.items() if value is not None)


def _show(console: Console, table: ForceTable, *, full: bool) -> None:
    """Show forces by the reactions, and what the textbook makes of them: all, or how far that is off at most."""
    labels = [f"{angle:g}°" for angle in table.angle]
    exact = [Column(one.symbol, one.unit, _written(one.exact, one.exact)) for one in table.columns]
    heading = _("Forces of piston {piston} by the reactions in the joints", piston=table.piston)
    if table.area is not None:
        heading = _("{heading}, over its area of {area:.2f} cm²", heading=heading, area=1e4 * table.area)
    section_of_columns(console, heading, exact, labels)
    methods = _methods(table)
    if full:
        for method, columns in methods.items():
            _show_method(console, _("The same by {method}", method=method), columns, labels)
    elif methods:
        _show_largest(console, methods)
    section(console, _("What they are"), _explained(table))


def _methods(table: ForceTable) -> dict[str, list[_ByMethod]]:
    """Give every column by each method that there is for the piston."""
    found = {
        _("the textbook's P·f(β)"): [(one, one.textbook, one.textbook_error) for one in table.columns],
        _("two harmonics of inertia"): [(one, one.two_harmonics, one.two_harmonics_error) for one in table.columns],
    }
    return {
        method: columns
        for method, columns in found.items()
        if any(np.any(np.isfinite(values)) for _one, values, _error in columns)
    }


def _show_largest(console: Console, methods: Mapping[str, Sequence[_ByMethod]]) -> None:
    """Show by how much each method is off where it is off most, at the angles of the table."""
    columns = [
        Column(f"Δ{one.symbol}", "%", tuple(percent(_largest(each[place][2])) for each in methods.values()))
        for place, (one, _values, _error) in enumerate(next(iter(methods.values())))
    ]
    heading = _("Largest errors at these angles, of the exact peaks")
    section_of_columns(console, heading, columns, list(methods))


def _largest(error: Array) -> float:
    """The largest error with its sign."""
    return float(largest_of(error.tolist(), abs))


def _show_method(console: Console, heading: str, columns: Sequence[_ByMethod], labels: Sequence[str]) -> None:
    """Show the forces by a method, and their errors; of P·f(β) that it is the same, where it is."""
    if columns[0][1] is columns[0][0].textbook and all(np.all(np.abs(error) < _SAID) for *_by, error in columns):
        section(console, heading, [_("The same: this rod is as two masses, and nothing hangs on it.")])
        return
    forces = [Column(one.symbol, one.unit, _written(values, one.exact)) for one, values, _error in columns]
    section_of_columns(console, heading, forces, labels)
    errors = [Column(f"Δ{one.symbol}", "%", tuple(map(percent, error.tolist()))) for one, _values, error in columns]
    section_of_columns(console, _("Their errors, of the exact peaks"), errors, labels)


def _explained(table: ForceTable) -> Iterator[str]:
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


def _written(values: Array, like: Array) -> tuple[str, ...]:
    """Write numbers with as many decimals as give the largest of a curve its figures, or as show what is less."""
    peak = float(np.max(np.abs(like)))
    usual = max(0, decimals_for(peak, _FIGURES))
    decimals = [seen(abs(value), usual) if abs(value) > _ROUNDING * peak else usual for value in values.tolist()]
    return tuple(signless(f"{value:.{own}f}") for value, own in zip(values, decimals, strict=True))
