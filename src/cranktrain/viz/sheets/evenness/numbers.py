"""Speeds and flywheels as tables beside a diagram of evenness."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.language import _
from cranktrain.quantities import shown as in_unit
from cranktrain.questions.evenness.flywheel import FlywheelSize
from cranktrain.scales import scale_for
from cranktrain.texts.flywheel_diagrams import Tangent
from cranktrain.viz.figures import figure, plain, written_apart
from cranktrain.viz.panel import OneDesign
from cranktrain.viz.paper.page import Page
from cranktrain.viz.paper.style import INK, MUTED
from cranktrain.viz.paper.tables import write_table

TABLE = 86.0
"""Width of the tables. [mm]"""

UPPER, LOWER = (9.0, 3.0), (3.0, 2.0)
"""Dashes of the tangents at the largest and the smallest speed."""


def write_numbers(page: Page, shown: OneDesign, left: float, top: float, tangents: Sequence[Tangent]) -> float:
    """Write speeds and flywheels beside a diagram, and what its tangents are; give where the tables end. [mm]"""
    y = write_table(page, _speeds(shown, tangents), (left, top, TABLE))
    y = write_table(page, list(_flywheels(shown)), (left, y - 3.0, TABLE), (0.52, 0.77, 1.0))
    if tangents:
        for words, dashes in ((_("tangent at the largest speed"), UPPER), (_("tangent at the smallest"), LOWER)):
            page.sample(left, left + 10.0, y - 1.0, color=INK, lw=0.9, dashes=dashes)
            page.text(left + 12.0, y - 2.0, words, color=MUTED)
            y -= 4.6
    return y


def _speeds(shown: OneDesign, tangents: Sequence[Tangent]) -> list[tuple[str, str]]:
    """What is wanted, the speeds, where they are, and energies."""
    size = shown.result[FlywheelSize]
    fastest, slowest, energy = (
        float(part[shown.design])
        for part in (size.exact.largest_speed, size.exact.smallest_speed, size.exact.initial_energy)
    )
    speed = scale_for("rpm", fastest)
    speeds = written_apart(speed.of(np.array([fastest, slowest])))
    largest = float(shown("largest_excess_work"))
    works = [(one, scale_for("J", abs(one))) for one in (largest, energy)]
    excess, start = ((scale.label, figure(float(scale.of(one)))) for one, scale in works)
    angles = (f"{float(in_unit(tangent.angle, 'deg')) % shown.cycle[-1]:.2f}" for tangent in tangents)
    return [
        (_("Wanted"), ""),
        (_("Coefficient of fluctuation δ"), plain(float(size.wanted[shown.design]))),
        (_("Largest speed, {unit}").format(unit=speed.label), speeds[0]),
        (_("Smallest speed, {unit}").format(unit=speed.label), speeds[1]),
        (_("Largest excess work, {unit}").format(unit=excess[0]), excess[1]),
        (_("Energy at φ = 0, E₀, {unit}").format(unit=start[0]), start[1]),
        *zip((_("Largest speed at φ, °"), _("Smallest speed at φ, °")), angles, strict=False),
    ]


def _flywheels(shown: OneDesign) -> Iterator[tuple[str, str, str, str]]:
    """Flywheel by each method, and the error of that; the exact one comes first."""
    titles = {"exact": _("exact"), "mertsalov": _("Mertsalov"), "textbook": _("textbook, ΔA/(δω²)")}
    inertias, errors = (shown(name).tolist() for name in ("flywheel_inertia", "flywheel_inertia_error"))
    yield _("Flywheel"), "J, kg·m²", "GD², kg·m²", _("error")
    for name, inertia, error in zip(shown.result.labels["flywheel_method"], inertias, errors, strict=True):
        is_told = inertia > 0 and inertias[0] > 0
        share = f"{100 * error:+.2f} %".replace("-", "−") if is_told else "–"
        moment, doubled = (figure(inertia), figure(4 * inertia)) if inertia > 0 else (_("not needed"), "–")
        yield titles[name], moment, doubled, "" if name == "exact" else share
