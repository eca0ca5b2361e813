"""`textbook --harmonics`: a piston's harmonics in closed form beside the texts' series and their two harmonics."""

from collections.abc import Mapping, Sequence

import numpy as np
from rich.console import Console

from cranktrain.cli.screen.columns import Column, section_of_columns
from cranktrain.cli.screen.text import page, section
from cranktrain.cli.screen.title import title
from cranktrain.cli.textbook.source import file_missing, machine_file
from cranktrain.cli.textbook.speaking import speaking
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.grouping import places_of_equal
from cranktrain.language import said as _
from cranktrain.motion import single
from cranktrain.quantities import Dimension, Quantity
from cranktrain.questions.torque.rod_harmonics import MOST_RATIO
from cranktrain.saying.wording import ranged, signless
from cranktrain.texts.harmonic_series import (
    HarmonicsByMethod,
    acceleration_series,
    torque_series,
    two_harmonic_torque,
    two_harmonics,
)
from cranktrain.texts.plain_cranks import PLAIN

RATIO_OPTION = "--crank-to-rod-ratio"
_EXAMPLE = "cranktrain textbook 3d12 --harmonics"
_DECIMALS = 10
_LEAST = 1e-15
"""A smaller error is rounding."""


def show_harmonics(
    source: str, settings: Sequence[str], *, ratio: str | None, others: Mapping[str, str | None]
) -> None:
    """Show the tables of a machine, or of a ratio of crank radius and rod.

    Parameters
    ----------
    source : str
        A machine file or an example; none where a ratio is given.
    settings : sequence of str
        `PATH=VALUE`
    ratio : str or None
        As typed.
    others : mapping of str
        Options that mean nothing for harmonics, as typed.

    Raises
    ------
    InputError
        With everything that is wrong with the request, or with the machine.
    """
    given = _given_ratio(source, settings, ratio, others)
    if given is not None:
        with page(_("Central slider-crank")) as console:
            _show(console, f"λ = {given:g}", given)
            _explain(console)
        return
    machine = machine_file(source, settings, _EXAMPLE).machine
    places = [place for place in machine.places if place.kind.name in PLAIN and place.geometry.offset == 0.0]
    ratios = places_of_equal([float(place.geometry.crank_radius / place.geometry.rod_length) for place in places])
    with page(title(machine)) as console:
        if not ratios:
            none = _("Only a central slider-crank or eccentric has them in closed form.")
            other = _("`{command}` has something for this machine")
            commands = speaking(machine, source, settings)
            section(console, _("Harmonics"), [none, *(other.format(command=one) for one in commands)])
            return
        for own, members in ratios.items():
            pistons = ranged([place.name for place in places], members)
            _show(console, _("{pistons}, λ = {ratio:.4g}", pistons=pistons, ratio=own), own)
        _explain(console)


def _given_ratio(
    source: str, settings: Sequence[str], typed: str | None, others: Mapping[str, str | None]
) -> float | None:
    """Read the ratio, where one is given, and refuse what does not go with it or with harmonics."""
    allowed = _("is for the motion or its forces: ask for it without harmonics")
    problems = [Problem(name, value or None, allowed) for name, value in others.items() if value is not None]
    ratio = None
    if typed is None:
        if not source:
            problems.append(file_missing(_EXAMPLE))
    else:
        try:
            ratio = Quantity(Dimension.RATIO, above=0.0, at_most=MOST_RATIO).given(typed).si
        except InputError as error:
            problems += [Problem(RATIO_OPTION, one.given, one.allowed, one.repair) for one in error.problems]
        if source:
            problems.append(Problem("FILE", source, _("has ratios of its own: give one or the other")))
        elif settings:
            problems.append(Problem("--set", settings[0], _("is for a machine: name FILE")))
    refuse(problems)
    return ratio


def _show(console: Console, whose: str, ratio: float) -> None:
    """Show the harmonics of acceleration and torque for one ratio."""
    value = single(ratio)
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
        section_of_columns(console, heading.format(pistons=whose), columns, labels)


def _beside(head: str, method: HarmonicsByMethod, orders: list[int]) -> tuple[Column, Column]:
    """A form's harmonics and what they are off."""
    errors = [float(method.error[order]) for order in orders]
    return (
        Column(head, "", tuple(_figure(method.textbook[order]) for order in orders)),
        Column("Δ", "", tuple("0" if abs(error) < _LEAST else f"{error:.1e}" for error in errors)),
    )


def _figure(value: float) -> str:
    return signless(f"{value:.{_DECIMALS}f}") if value != 0.0 else "0"


def _explain(console: Console) -> None:
    explained = _(
        "α is the angle of the piston's own crank, or of the valve's eccentric, from the top. The series of the texts "
        "go to the seventh power of λ, of the torque to the sixth; their two harmonics are cos α + λ cos 2α, and the "
        "torque is that of these. Δ is what a form is off. Orders that are not listed are zero, but for exact ones "
        "beyond the last."
    )
    section(console, _("What they are"), [explained])
