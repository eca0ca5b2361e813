"""`textbook --forces`: a piston's forces at round crank angles, exact and by the textbook's formula, with errors."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from rich.console import Console

from cranktrain.cli.screen.columns import Column, section_of_columns
from cranktrain.cli.screen.text import page, section
from cranktrain.cli.screen.title import title
from cranktrain.cli.textbook.source import machine_file
from cranktrain.errors import Problem, problems_as, refuse
from cranktrain.language import _
from cranktrain.motion import Array
from cranktrain.plans.force_table import ForceColumn, ForceTable, force_table
from cranktrain.texts.percents import percent
from cranktrain.wording import decimals_for, seen, signless

_FIGURES = 5
"""Of the largest number in a column."""

_ROUNDING = 1e-9
"""Of the largest number; what is less is nothing beside it."""

_SAID = 5e-5
"""An error that is shown, in parts of the peak."""


def show_force_tables(source: str, settings: Sequence[str], *, unit: str, step: float, piston: str | None) -> None:
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

    Raises
    ------
    InputError
        With everything that is wrong with the machine, or with the request.
    """
    file = machine_file(source, settings, f"cranktrain textbook 3d12 --forces {unit}")
    with problems_as(lambda problem: problem if problem.path.startswith("-") else file.document.located(problem)):
        table = force_table(file.machine, step=step, unit=unit, piston=piston)
    with page(title(file.machine)) as console:
        _show(console, table)


def refuse_without_forces(given: Mapping[str, str | None]) -> None:
    """Refuse options that mean nothing but for tables of forces."""
    allowed = _("is for tables of forces: ask for --forces UNIT, too")
    refuse(Problem(name, value, allowed) for name, value in given.items() if value is not None)


def refuse_with_forces(given: Mapping[str, str | None]) -> None:
    """Refuse options that mean nothing for tables of forces."""
    allowed = _("is for the motion: ask for it without forces")
    refuse(Problem(name, value or None, allowed) for name, value in given.items() if value is not None)


def _show(console: Console, table: ForceTable) -> None:
    """Show forces by the reactions, and what the textbook makes of them."""
    labels = [f"{angle:g}°" for angle in table.angle]
    exact = [Column(one.symbol, one.unit, _written(one.exact, one.exact)) for one in table.columns]
    heading = _("Forces of piston {piston} by the reactions in the joints").format(piston=table.piston)
    if table.area is not None:
        heading = _("{heading}, over its area of {area:.2f} cm²").format(heading=heading, area=1e4 * table.area)
    section_of_columns(console, heading, exact, labels)
    by_formula = [(one, one.textbook, one.textbook_error) for one in table.columns]
    by_harmonics = [(one, one.two_harmonics, one.two_harmonics_error) for one in table.columns]
    heading = _("The same by the textbook's P·f(β)")
    if all(np.all(np.abs(one.textbook_error) < _SAID) for one in table.columns):
        section(console, heading, [_("The same: this rod is as two masses, and nothing hangs on it.")])
    else:
        _show_method(console, heading, by_formula, labels)
    _show_method(console, _("The same with two harmonics of inertia"), by_harmonics, labels)
    section(console, _("What they are"), _explained(table))


def _show_method(
    console: Console, heading: str, columns: Sequence[tuple[ForceColumn, Array, Array]], labels: Sequence[str]
) -> None:
    """Show the forces by a method, and their errors; nothing where there are none."""
    if all(np.all(np.isnan(values)) for _one, values, _error in columns):
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
        yield _("S at the piston pin, S_A at the crank pin: slaves hang between them. K, T and M hold what they do.")


def _written(values: Array, like: Array) -> tuple[str, ...]:
    """Write numbers with as many decimals as give the largest of a curve its figures, or as show what is less."""
    peak = float(np.max(np.abs(like)))
    usual = max(0, decimals_for(peak, _FIGURES))
    decimals = [seen(abs(value), usual) if abs(value) > _ROUNDING * peak else usual for value in values.tolist()]
    return tuple(signless(f"{value:.{own}f}") for value, own in zip(values, decimals, strict=True))
