"""`textbook --harmonics`: a piston's harmonics in closed form beside the texts' series and their two harmonics."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from rich.console import Console
from rich.text import Text

from cranktrain.cli.screen.columns import Column, column_tables
from cranktrain.cli.screen.report import title
from cranktrain.cli.screen.text import INDENT, page, section
from cranktrain.errors import InputError, Position, Problem
from cranktrain.io.machine_file import read_machine
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.motion import single
from cranktrain.quantities import Dimension, Quantity
from cranktrain.questions.torque.rod_harmonics import MOST_RATIO
from cranktrain.textbook.harmonic_series import (
    HarmonicsByMethod,
    acceleration_series,
    torque_series,
    two_harmonic_torque,
    two_harmonics,
)
from cranktrain.wording import ranged

RATIO_OPTION = "--crank-to-rod-ratio"
_DECIMALS = 10
_LEAST = 1e-15
"""A smaller error is rounding."""


@dataclass(frozen=True)
class HarmonicRequest:
    """What is asked of the tables of harmonics, as typed; `others` are options that mean nothing to them."""

    file: str
    ratio: str | None
    settings: tuple[str, ...]
    others: Mapping[str, str | None]


def show_harmonics(request: HarmonicRequest) -> None:
    """Show the tables of a machine, or of a ratio of crank radius and rod.

    Raises
    ------
    InputError
        With everything that is wrong with the request, or with the machine.
    """
    given = _given_ratio(request)
    if given is not None:
        with page() as console:
            console.print(Text(_("Central slider-crank"), style="bold"))
            _show(console, f"λ = {given:g}", given)
            _explain(console)
        return
    machine = read_machine(request.file, request.settings).machine
    with page() as console:
        console.print(Text(title(machine), style="bold"))
        ratios = list(_ratios(machine))
        if not ratios:
            section(console, _("Harmonics"), [_("Only a central slider-crank has them in closed form.")])
            return
        for names, ratio in ratios:
            _show(console, _("{pistons}, λ = {ratio:.4g}").format(pistons=names, ratio=ratio), ratio)
        _explain(console)


def _given_ratio(request: HarmonicRequest) -> float | None:
    """Read the ratio, where one is given, and refuse what does not go with it or with harmonics."""
    allowed = _("is for the motion or its forces: ask for it without harmonics")
    problems = [Problem(name, value or None, allowed) for name, value in request.others.items() if value is not None]
    ratio = None
    if request.ratio is None:
        if not request.file:
            repair = _("such as: {example}").format(example="cranktrain textbook 3d12 --harmonics")
            problems.append(Problem("", None, _("FILE is missing"), repair, Position("cranktrain textbook")))
    else:
        try:
            ratio = Quantity(Dimension.RATIO, above=0.0, at_most=MOST_RATIO).given(request.ratio).si
        except InputError as error:
            problems += [Problem(RATIO_OPTION, one.given, one.allowed, one.repair) for one in error.problems]
        if request.file:
            problems.append(Problem("FILE", request.file, _("has ratios of its own: give one or the other")))
        elif request.settings:
            problems.append(Problem("--set", request.settings[0], _("is for a machine: name FILE")))
    if problems:
        raise InputError(problems)
    return ratio


def _ratios(machine: Machine) -> Iterator[tuple[str, float]]:
    """Pistons of central slider-cranks by their ratio."""
    places = [place for place in machine.places if place.kind.name == "slider_crank" and place.geometry.offset == 0.0]
    ratios = [float(place.geometry.crank_radius / place.geometry.rod_length) for place in places]
    names = [place.name for place in places]
    for ratio in dict.fromkeys(ratios):
        yield ranged(names, [i for i, one in enumerate(ratios) if one == ratio]), ratio


def _show(console: Console, whose: str, ratio: float) -> None:
    """Show the harmonics of acceleration and torque for one ratio."""
    value, width = single(ratio), console.width - INDENT
    for heading, symbol, series, two in (
        (_("Acceleration of {pistons}: x″ = R Σ A_k cos kα"), "A", acceleration_series(value), two_harmonics(value)),
        (
            _("Torque of inertia of {pistons}: T = m R² ω² Σ D_k sin kα"),
            "D",
            torque_series(value),
            two_harmonic_torque(value),
        ),
    ):
        orders = np.flatnonzero(series.exact).tolist()
        columns = [Column(_("exact"), "", tuple(_figure(series.exact[order]) for order in orders))]
        for head, method in ((_("series"), series), (_("two harmonics"), two)):
            columns += _beside(head, method, orders)
        labels = [f"{symbol}_{order}" for order in orders]
        section(console, heading.format(pistons=whose), list(column_tables(columns, labels, width)))


def _beside(head: str, method: HarmonicsByMethod, orders: list[int]) -> tuple[Column, Column]:
    """A form's harmonics and what they are off."""
    errors = [float(method.error[order]) for order in orders]
    return (
        Column(head, "", tuple(_figure(method.textbook[order]) for order in orders)),
        Column("Δ", "", tuple("0" if abs(error) < _LEAST else f"{error:.1e}" for error in errors)),
    )


def _figure(value: float) -> str:
    return f"{value:.{_DECIMALS}f}" if value != 0.0 else "0"


def _explain(console: Console) -> None:
    explained = _(
        "α is the angle of the piston's own crank from the top. The series of the texts go to the seventh power of λ, "
        "of the torque to the sixth; their two harmonics are cos α + λ cos 2α, and the torque is that of these. "
        "Δ is what a form is off. Orders that are not listed are zero, but for exact ones beyond the last."
    )
    section(console, _("What they are"), [explained])
