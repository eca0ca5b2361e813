"""`textbook --drive`: (1) to (21) of a crank-rocker's drive, as printed, right and refuted, over a turn."""

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from cranktrain.language import N_, Listed, Words, _
from cranktrain.references import REFERENCES
from cranktrain.saying.sections import Column, Command, Grid, Part, Rows, ShownSection, Unfolded
from cranktrain.saying.wording import FigureOf, number
from cranktrain.textbook.drive_statements import FACTS, PEAKS, SOURCE, drive_statements
from cranktrain.textbook.shown.tables import listed
from cranktrain.textbook.statements import Statement, Statements
from cranktrain.texts.drive_curves import AT_MOTOR
from cranktrain.texts.drive_table import CrankRockerDrive

_LEADING = ("(1)", "(2)", "(3) (4)", "(16) (17)")
"""What leads from the load to the motor's shaft, on the first screen."""
ALL, FIGURE = "--full", "-o fig2.svg"
_SHOWS = {
    ALL: N_("all, with what is refuted, and pin friction"),
    FIGURE: N_("fig. 2, redrawn; as .csv its curves"),
}
_ROUNDING = 1e-12
"""What is less is 0."""
_VERDICTS = {"right": N_("right"), "printed": N_("printed"), "refuted": N_("refuted")}
_HEADS = (N_("at α"), N_("advancing"), N_("going back"), N_("mean"), N_("rms"), N_("a turn, J"))


def drive_sections(
    drive: CrankRockerDrive, angle: float, *, commands: Mapping[str, str] | None
) -> Iterator[ShownSection]:
    """Give the linkage, forces at one angle, all curves, what is absurd, and pin friction.

    Parameters
    ----------
    drive : CrankRockerDrive
    angle : float
        Crank angle from the line of the fixed pivots, at which forces are given. [deg]
    commands : mapping of str to str, or None
        Of the first screen alone, what leads to the motor: the commands that show the rest, by what they add, `ALL`
        and `FIGURE`. None for all.
    """
    found = drive_statements(drive, angle)
    (linkage, of_linkage), *others = found.sentences.items()
    shown = found if commands is None else _first(found)
    yield ShownSection(linkage, of_linkage)
    heading = _("At α = {angle:g}° from the line of the pivots", angle=angle)
    yield ShownSection(heading, (_forces(shown),))
    yield ShownSection(_("Over a turn"), tuple(_curves(shown)))
    if commands is not None:
        yield ShownSection(_("To go on"), [_further(*one) for one in commands.items()])
        return
    for subject, sentences in others:
        yield ShownSection(subject, listed(sentences))
    yield ShownSection(_("Source"), (REFERENCES[SOURCE].text,))


def _first(found: Statements) -> Statements:
    """Take what leads to the motor's shaft, right and printed."""
    numbers = (*_LEADING, *AT_MOTOR)
    return replace(
        found,
        each=tuple(one for one in found if one.equation in numbers and one.verdict != "refuted"),
        over_turn=tuple(one for one in found.over_turn if one.equation in AT_MOTOR and one.verdict != "refuted"),
    )


def _further(added: str, command: str) -> Command:
    """Say what a command shows; where it has no room in a line, by what is to be added to the typed one."""
    return Command(command, _(_SHOWS[added]), _("the same with {option}", option=added))


def _forces(found: Statements) -> Rows:
    """Directions, forces, the instant centre, the weights: (1) to (11), (15) to (17)."""
    curves = {one.words for one in found.over_turn}
    rows = [
        (
            Listed((f"{one.equation} " if one.equation else "", one.words, f", {one.symbol}"), ""),
            _amount(one),
            "" if one.verdict == "right" else _(one.verdict),
        )
        for one in found
        if one.words not in curves
    ]
    return Rows(rows, right=(1,))


def _amount(one: Statement) -> Words:
    """A number with its unit."""
    if one.unit == "rad":
        return f"{np.degrees(one.value):.4f}°"
    return f"{one.value:.6f}" if one.unit == "1" else number(one.value, "mm" if one.unit == "m" else one.unit)


def _curves(found: Statements) -> Iterator[Part]:
    """Every curve with its value at the angle, its peaks in both half-periods, means and work."""
    for unit, title in {"1": "", "N*m": "N·m", "kg": "kg", "kg*m^2": ""}.items():
        curves = [one for one in found.over_turn if one.unit == unit and one.verdict in _VERDICTS]
        if not curves:
            continue
        facts = [
            {one.at: _fact(one) for one in found if (one.equation, one.words) == (curve.equation, curve.words)}
            for curve in curves
        ]
        texts = {head: [own.get(at, "") for own in facts] for head, at in zip(_HEADS, FACTS, strict=True)}
        columns = [Column(_(head), each) for head, each in texts.items() if any(each)]
        if unit == "kg*m^2":
            yield Unfolded("GD², kg·m² (kgf·m²)", is_head=True)
        names = [Listed((_(_VERDICTS[one.verdict]), one.words), ": ") for one in curves]
        yield Grid(columns, [one.equation for one in curves], title, names)


def _fact(one: Statement) -> Words:
    """A value, of a peak with its angle; five figures, and what is but rounding is 0."""
    if one.at == "turn":
        return FigureOf(one.value, "J")
    plain = "0" if abs(one.value) < _ROUNDING else f"{one.value:.5g}"
    return f"{plain} {one.crank_angle:.1f}°" if one.at in PEAKS and np.isfinite(one.crank_angle) else plain
