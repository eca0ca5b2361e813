"""Diagrams of evenness: Wittenbauer's energy over inertia, Mertsalov's energy over the crank angle."""

from collections.abc import Iterator, Sequence

from cranktrain.analysis import Result
from cranktrain.language import Message, Words, _
from cranktrain.panels.design import OneDesign
from cranktrain.panels.parts import CurveCard, Sheet, SheetColumn, Stack, Table, TableColumn, facts_table, sheet_of
from cranktrain.panels.sheets.evenness.panels import mertsalov_panels, tangents_of, wittenbauer_panels
from cranktrain.quantities import shown as in_unit
from cranktrain.questions.evenness.flywheel import FlywheelSize
from cranktrain.saying.amounts import ApartAmount, BareAmount, UnitLabel
from cranktrain.saying.wording import ABSENT, plain, true_minus
from cranktrain.texts.flywheel_diagrams import Tangent

_LEFT = 0.66
"""Share of the diagrams in the width."""


def plan_wittenbauer(result: Result, *, design: int = 0) -> Sheet:
    """Collect Wittenbauer's diagram of the flywheel that a machine is to have.

    Parameters
    ----------
    result : Result
        Of a machine with [evenness] coefficient.
    design : int
        Which of the result's machines.

    Returns
    -------
    Sheet
    """
    tangents = tangents_of(result, design)
    drawn, whole = wittenbauer_panels(result, tangents, design)
    title = _("Wittenbauer's diagram: excess work over inertia of the moving parts")
    shown = OneDesign(result, design)
    tables = _tables(shown, tangents)
    columns = (
        SheetColumn(_LEFT, (CurveCard((drawn,), height=1.0),)),
        SheetColumn(1 - _LEFT, (*tables, CurveCard((whole,), height=0.4))),
    )
    return sheet_of(result, design, title, *columns)


def plan_mertsalov(result: Result, *, design: int = 0) -> Sheet:
    """Collect Mertsalov's diagram of the flywheel; parameters as `plan_wittenbauer` takes them."""
    title = _("Mertsalov's diagram: the energy that the flywheel takes up")
    left = Stack(mertsalov_panels(result, design), is_tall=True)
    tables = _tables(OneDesign(result, design), ())
    return sheet_of(result, design, title, SheetColumn(_LEFT, (left,)), SheetColumn(1 - _LEFT, tables))


def _tables(shown: OneDesign, tangents: Sequence[Tangent]) -> tuple[Table, Table]:
    """Speeds and flywheels beside a diagram."""
    return facts_table(_("Wanted"), list(_speeds(shown, tangents))), _flywheels(shown)


def _speeds(shown: OneDesign, tangents: Sequence[Tangent]) -> Iterator[tuple[Message, Words]]:
    """What is wanted, the speeds, where they are, and energies."""
    size = shown.result[FlywheelSize]
    fastest, slowest, energy = (
        float(part[shown.design])
        for part in (size.exact.largest_speed, size.exact.smallest_speed, size.exact.initial_energy)
    )
    yield _("Coefficient of fluctuation δ"), plain(float(size.wanted[shown.design]))
    for place, words in enumerate((_("Largest speed, {unit}"), _("Smallest speed, {unit}"))):
        yield words.format(unit=UnitLabel("rpm", fastest)), ApartAmount((fastest, slowest), "rpm", place)
    works = (
        (_("Largest excess work, {unit}"), float(shown("largest_excess_work"))),
        (_("Energy at φ = 0, E₀, {unit}"), energy),
    )
    for words, work in works:
        yield words.format(unit=UnitLabel("J", abs(work))), BareAmount(work, "J")
    for words, one in zip((_("Largest speed at φ, °"), _("Smallest speed at φ, °")), tangents, strict=False):
        yield words, f"{float(in_unit(one.angle, 'deg')) % shown.cycle[-1]:.2f}"


def _flywheels(shown: OneDesign) -> Table:
    """Flywheel by each method, and the error of that; the exact one comes first."""
    titles = {"exact": _("exact"), "mertsalov": _("Mertsalov"), "textbook": _("textbook, ΔA/(δω²)")}
    inertias, errors = (shown(name) for name in ("flywheel_inertia", "flywheel_inertia_error"))
    each = inertias.tolist()
    are_told = [one > 0 and each[0] > 0 for one in each]
    shares = [
        true_minus(f"{100 * error:+.2f} %") if is_told else ABSENT
        for error, is_told in zip(errors.tolist(), are_told, strict=True)
    ]
    return Table(
        (
            TableColumn(_("Flywheel"), [titles[name] for name in shown.result.labels["flywheel_method"]]),
            TableColumn("J, kg·m²", [BareAmount(one, "kg*m^2") if one > 0 else _("not needed") for one in each]),
            TableColumn("GD², kg·m²", [BareAmount(4 * one, "kg*m^2") if one > 0 else ABSENT for one in each]),
            TableColumn(_("error"), ["", *shares[1:]]),
        ),
        (0.52, 0.77, 1.0),
    )
