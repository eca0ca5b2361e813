"""The sheet of torsion: modes along the shaft, Campbell's diagram, the critical speeds that matter most."""

from collections.abc import Sequence

import numpy as np

from cranktrain.analysis import Result
from cranktrain.errors import InputError, Problem
from cranktrain.language import Words, _
from cranktrain.numerics.ties import largest_first
from cranktrain.one_line import short
from cranktrain.panels.parts import (
    CurveCard,
    Notes,
    Part,
    ShaftShapes,
    Sheet,
    SheetColumn,
    Table,
    TableColumn,
    sheet_of,
)
from cranktrain.panels.shapes import Curve, Mark, Panel, PanelLine, ShaftShape
from cranktrain.panels.sheets.torsion.panels import (
    Campbell,
    Crossing,
    ModeShape,
    TrialShape,
    campbell,
    mode_shapes,
    trial_shapes,
)
from cranktrain.saying.amounts import Amount, UnitLabel

_MODES = 4
"""Modes that have a drawing."""
_TRIALS = 2
"""Frequencies of the file's own that have one."""
_LONGEST = 16
"""Letters of a disc's name that are written."""
_ROWS = 8
"""Critical speeds in the table."""
_UNKNOWN = 1.0 / 9.0
"""Size of the marks where no firing order says how much they weigh."""


def sheet_torsion(result: Result, *, design: int = 0) -> Sheet:
    """Collect what a machine's shaft does in torsion.

    Parameters
    ----------
    result : Result
        Of a machine with [torsion].
    design : int
        Which of the result's machines.

    Returns
    -------
    Sheet

    Raises
    ------
    InputError
        If the machine has no natural frequencies.
    """
    shapes = mode_shapes(result, design)
    if not all(np.isfinite(shape.frequency) for shape in shapes):
        raise InputError([Problem("torsion", None, _("gives no natural frequencies, so there is no sheet of them"))])
    names = tuple(short(name, _LONGEST) for name in result.labels["disc"])
    tried = trial_shapes(result, design)[:_TRIALS]
    drawn = (*map(_shape, shapes[:_MODES]), *map(_tried_shape, tried))
    title = _("Modes, what was asked for, and nodes") if tried else _("Modes, and their nodes")
    modes = ShaftShapes(title, drawn, names)
    of = campbell(result, design)
    n_cylinders = max(len(result.labels.get("cylinder", ())), 1)
    right: tuple[Part, ...] = (CurveCard((campbell_panel(of, n_cylinders),), height=0.62), *_critical_speeds(of))
    return sheet_of(result, design, _("Torsional vibration"), SheetColumn(0.5, (modes,)), SheetColumn(0.5, right))


def _shape(one: ModeShape) -> ShaftShape:
    """A mode with its words."""
    disc: Words = short(one.unit, _LONGEST)
    words = _(
        "mode {n}, {frequency}; amplitude 1 at {disc}",
        n=one.mode,
        frequency=Amount(one.frequency, "Hz"),
        disc=_("throw {n}", n=disc) if one.unit.isdigit() else disc,
    )
    return ShaftShape(words, one.amplitude, one.following, one.nodes)


def _tried_shape(one: TrialShape) -> ShaftShape:
    """Amplitudes at a frequency of the file's own, with what is left over."""
    words = _(
        "{frequency}: {torque} left over",
        frequency=Amount(one.frequency, "Hz"),
        torque=Amount(one.residual, "N*m/rad"),
    )
    return ShaftShape(words, one.amplitude, one.following, one.nodes)


def campbell_panel(of: Campbell, n_cylinders: int) -> Panel:
    """Frequencies over the speed: rays of orders, natural frequencies, the declared speed, crossings by their weight.

    Parameters
    ----------
    of : Campbell
    n_cylinders : int
        To which the marks are scaled: the sum of vectors of length 1.
    """
    rays: list[Curve] = []
    for order in of.order.tolist():
        ends = np.array([0.0, min(of.largest_speed, of.highest_frequency / order)])
        is_whole = order == int(order)
        name = f"{order:g}" if is_whole else ""
        rays.append(Curve(order * ends, "ray" if is_whole else "half_ray", "", name=name, across=ends))
    seen = [frequency for frequency in of.frequency.tolist() if frequency <= of.highest_frequency]
    levels = [PanelLine(frequency, "natural", f"f_{{{mode}}}") for mode, frequency in enumerate(seen, start=1)]
    if of.speed is not None:
        levels.append(PanelLine(of.speed, "declared", is_upright=True))
    title = _(
        "Campbell's diagram: frequency in {frequency} over speed in {unit}",
        frequency=UnitLabel("Hz", of.highest_frequency),
        unit=UnitLabel("rpm", of.largest_speed),
    )
    return Panel(
        title,
        "Hz",
        np.array([0.0, of.largest_speed]),
        tuple(rays),
        across_unit="rpm",
        marks=tuple(
            Mark(one.speed, one.frequency, "dot", size=_UNKNOWN if np.isnan(one.weight) else one.weight / n_cylinders)
            for one in of.crossings
        ),
        levels=tuple(levels),
        limits=(0.0, of.highest_frequency),
        reach=(0.0, of.largest_speed),
    )


def _critical_speeds(of: Campbell) -> tuple[Part, ...]:
    """The critical speeds in sight that have the largest marks, by their speed."""
    if not of.crossings:
        words = _("No order up to {order:g} has a natural frequency at the speeds of the diagram.")
        return (Notes((words.format(order=float(of.order[-1])),)),)
    has_sums = bool(np.isfinite(of.crossings[0].weight))
    largest = largest_first(of.crossings, lambda one: one.weight if has_sums else -one.order)[:_ROWS]
    chosen = sorted(largest, key=lambda one: one.speed)
    speeds = np.array([one.speed for one in chosen])
    columns = [
        TableColumn(_("mode"), [f"{one.mode}" for one in chosen]),
        TableColumn(_("order"), [f"{one.order:g}" for one in chosen]),
        TableColumn(
            _("speed, {unit}", unit=UnitLabel("rpm", of.largest_speed)), speeds, "rpm", beside=of.largest_speed
        ),
    ]
    if not has_sums:
        return (Table(tuple(columns), (0.3, 0.65), title=_("Critical speeds")),)
    return (_with_sums(columns, chosen),)


def _with_sums(columns: Sequence[TableColumn], chosen: Sequence[Crossing]) -> Table:
    """The table with the vector sums."""
    sums = TableColumn(_("vector sum"), np.array([one.vector_sum for one in chosen]))
    notes = (
        _(
            "Vector sums are those of amplitude 1 at the free end; the marks' areas are as those of amplitude 1 where"
            " the mode has its largest."
        ),
    )
    return Table((*columns, sums), (0.3, 0.65, 1.0), title=_("Critical speeds with the largest marks"), notes=notes)
