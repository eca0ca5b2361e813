"""`textbook --drive`: (1) to (21) of a crank-rocker's drive, as printed, right and refuted, over a turn."""

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path, PurePath
from typing import Any, NamedTuple

import numpy as np
from rich.console import Console
from rich.text import Text

from cranktrain import texts
from cranktrain.cli.screen.text import INDENT, page, section, table
from cranktrain.cli.textbook.drive_output import drive_output_problems, write_drive
from cranktrain.errors import InputError, Position, Problem, problems_as, refuse
from cranktrain.io.document import Document
from cranktrain.io.examples import example_names
from cranktrain.io.machine_file import read_machine
from cranktrain.io.syntax import parsed
from cranktrain.language import _
from cranktrain.one_line import one_line
from cranktrain.plans.machine_drive import machine_drive
from cranktrain.references import REFERENCES
from cranktrain.texts.crank_rocker_drive import (
    centre_distances,
    crank_pin_force,
    directions,
    refuted_rod_force,
    rod_force,
    weight_at_rocker_pin,
)
from cranktrain.texts.drive_curves import CurvePeak, curve_facts, dead_positions, drive_curves, values_at
from cranktrain.texts.drive_table import DRIVE_KEYS, CrankRockerDrive, read_drive
from cranktrain.texts.drive_verdicts import absurdities, pin_friction, swing
from cranktrain.wording import figure, number

EXAMPLE = "example"
_SOURCE = "gandzha"
_SETTING = Position("--set")
_ANGLE = 60.0
"""At which forces and distances are shown. [deg]"""


class _DriveFile(NamedTuple):
    """A drive and the text that declares it; none of a machine's."""

    drive: CrankRockerDrive
    text: str | None


def show_drive(
    source: str,
    settings: Sequence[str],
    output: str | None,
    *,
    angle: float | None = None,
    force: bool,
    others: Mapping[str, str | None],
) -> None:
    """Show a crank-rocker's drive, or write its table, its curves or its figures.

    Parameters
    ----------
    source : str
        A file with its table, or a machine file or an example with a crank-rocker, or `example`.
    settings : sequence of str
        `SYMBOL=VALUE`; of a machine `PATH=VALUE`, too.
    output : str or None
        File to write instead: .toml, .csv, .png, .svg, .pdf.
    angle : float, optional
        Crank angle from the line of the fixed pivots at which forces are shown. [deg]
    force : bool
        Replace a file that is there.
    others : mapping of options to str or None
        What else was typed and means nothing here.

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    allowed = _("must be left out beside --drive")
    found = [Problem(name, value or None, allowed) for name, value in others.items() if value is not None]
    refuse([*found, *drive_output_problems(output)])
    file = read_drive_file(source, settings)
    at = _ANGLE if angle is None else angle
    if output is not None:
        write_drive(file.drive, file.text, one_line(PurePath(source).name), output, angle=at, force=force)
        return
    with page(_("Drive of a crank-rocker, (1) to (21) [{source}]").format(source=_SOURCE)) as console:
        _show(console, file.drive, at)


def read_drive_file(source: str, settings: Sequence[str]) -> _DriveFile:
    """Read a drive's table, or a machine; some values set anew. What is wrong stands at its line, or at `--set`."""
    if not source.strip():
        allowed = _("must be a file with a drive's table, a machine file, or `{example}`").format(example=EXAMPLE)
        raise InputError([Problem("--drive", '""', allowed)])
    own = [one for one in settings if one.partition("=")[0].strip() in DRIVE_KEYS]
    others = [one for one in settings if one not in own]
    if _is_machine(source):
        return _of_machine(source, own, others)
    typed = document = _document(source)
    for setting in settings:
        key, equals, value = (part.strip() for part in setting.partition("="))
        if not equals or not key.isidentifier():
            raise InputError([Problem("", setting, _('must be SYMBOL=VALUE, such as "Q=4 kN"'), position=_SETTING)])
        with problems_as(lambda problem: replace(problem, position=_SETTING)):
            document = document.with_value(key, value)
    keys = [one.partition("=")[0].strip() for one in settings]
    with problems_as(lambda one: replace(one, position=_SETTING) if one.path in keys else typed.located(one)):
        return _DriveFile(read_drive(parsed(document.text, document.name)), document.text)


def _is_machine(source: str) -> bool:
    """Whether a name is that of a machine: an example, or a file with mechanisms in it."""
    if not os.path.isfile(source):  # noqa: PTH113 - takes a NUL byte
        return source.casefold().replace("-", "_") in example_names()
    document = Document.read(source)
    return bool({"mechanism", "bank"} & set(parsed(document.text, document.name)))


def _of_machine(source: str, own: Sequence[str], settings: Sequence[str]) -> _DriveFile:
    """Take a machine's crank-rocker; what it does not say is asked for as settings."""
    machine = read_machine(source, settings).machine
    typed = {key.strip(): value.strip() for key, _equals, value in (one.partition("=") for one in own)}
    repair = _('such as --set i=40 --set eta_p=0.94 --set "Q=4 kN" --set "GD2_0=2 kg*m^2"')
    with problems_as(lambda one: replace(one, position=_SETTING, repair=one.repair or repair)):
        return _DriveFile(machine_drive(machine, typed), None)


def _document(source: str) -> Document:
    """Read the text of a drive's table; a file that says nothing is refused."""
    is_file = os.path.isfile(source)  # noqa: PTH113 - takes a NUL byte
    if source.strip().casefold() == EXAMPLE and not is_file:
        path = Path(texts.__file__).parent / "drive_example.toml"
        return Document.from_text(path.read_text(encoding="utf-8"), EXAMPLE)
    repair = _("start with: {command}").format(command="cranktrain textbook --drive example -o drive.toml")
    with problems_as(lambda problem: replace(problem, repair=problem.repair or repair)):
        document = Document.read(source)
    if not parsed(document.text, document.name):
        raise InputError([Problem("", None, _("no drive in it"), repair, Position(document.name))])
    return document


def _show(console: Console, drive: CrankRockerDrive, angle: float) -> None:
    """Show the linkage, forces at one angle, all curves, what is absurd, and pin friction."""
    width = console.width - INDENT
    section(console, _("The linkage"), _linkage_lines(drive))
    heading = _("At α = {angle:g}° from the line of the pivots").format(angle=angle)
    section(console, heading, _force_lines(drive, np.deg2rad(angle), width))
    section(console, _("Over a turn"), _curve_lines(drive, np.deg2rad(angle), width))
    section(console, _("What is absurd about it"), table(("", ""), list(_verdicts(drive)), fold=width))
    section(console, _("Friction in the pins instead of η_ш, at the crank"), _friction_lines(drive))
    section(console, _("Source"), [REFERENCES[_SOURCE].text])


def _linkage_lines(drive: CrankRockerDrive) -> Iterator[str]:
    """Say where the rocker turns round, and how far it swings."""
    dead = dead_positions(drive.geometry)
    yield _(
        "Dead positions at {extended:.4f}° (rod and crank extended) and {folded:.4f}° (folded): there every torque of "
        "the load is 0, and changes its sign if the load is active. Swing {swing:.4f}°; the rocker advances during "
        "{advance:.2f}° of a turn and goes back during {back:.2f}°."
    ).format(
        extended=np.degrees(dead.extended),
        folded=np.degrees(dead.folded),
        swing=np.degrees(swing(drive)),
        advance=np.degrees(dead.advance.end - dead.advance.start),
        back=np.degrees(dead.back.end - dead.back.start),
    )


def _force_lines(drive: CrankRockerDrive, angle: float, width: int) -> Iterator[Text]:
    """Directions, forces, the instant centre, the weights: (1) to (11), (15) to (17)."""
    at = directions(np.array(angle), drive.geometry)
    distances = centre_distances(drive.geometry.rod_length, at)
    turn, load = 360.0, drive.load

    def degrees(value: Any) -> str:
        return f"{np.degrees(float(value)) % turn:.4f}°"

    weight = weight_at_rocker_pin(drive.driven_moment, drive.geometry.rocker_length)
    rows = [
        ("β, α₁", f"{degrees(at.rod)}, {degrees(at.rocker)}", ""),
        (_("(1) torque on the rocker, Q r₁"), number(float(load * drive.geometry.rocker_length), "N*m"), ""),
        (_("(2) force in the rod, Q′"), number(float(rod_force(load, at)), "N"), ""),
        (_("    by Kunitsky and Popov"), number(float(refuted_rod_force(load, at)), "N"), _("refuted")),
        (_("(3), (4) at the crank pin, T"), number(float(crank_pin_force(load, at)), "N"), ""),
        (_("(8), (9) the same as Q AC/BC"), number(float(load * distances[0] / distances[1]), "N"), ""),
        (_("(5), (10) AC"), number(float(distances[0]), "mm"), _("by the sine rule in ABC")),
        (_("(5), (10) BC"), number(float(distances[1]), "mm"), ""),
        (_("(11) sin ∠BAC"), f"{abs(float(np.sin(at.rocker - at.rod))):.6f}", ""),
        (_("(15) weight at A, G_A"), number(float(weight), "kg"), ""),
        (_("(16), (17) weight at B, G_B"), number(float(weight * (distances[0] / distances[1]) ** 2), "kg"), ""),
    ]
    yield from table(("", "", ""), rows, right=(1,), fold=width)


def _curve_lines(drive: CrankRockerDrive, angle: float, width: int) -> Iterator[Text]:
    """Every curve with its value at the angle, its peaks in both half-periods, means and work."""
    words = {"right": _("right"), "source": _("printed"), "refuted": _("refuted")}
    heads = ("", "", _("at α"), _("advancing"), _("going back"), _("mean"), _("rms"), _("a turn"))
    for unit in ("1", "N*m", "kg", "kg*m^2"):
        rows: list[tuple[str, ...]] = []
        for one in (curve for curve in drive_curves(drive) if curve.unit == unit):
            facts = curve_facts(drive, one)
            value = float(values_at(drive, one, np.array([angle]))[0])
            cells = [_plain(value), *map(_peak, facts[:2]), _plain(facts.mean), _plain(facts.rms)]
            rows.append((one.number, words[one.verdict], *cells, figure(facts.work, "J") if unit == "N*m" else ""))
            rows.append(("", _(one.name), "", "", "", "", "", ""))
        yield from _narrow(heads, rows, unit, width)


def _narrow(heads: Sequence[str], rows: Sequence[Sequence[str]], unit: str, width: int) -> Iterator[Text]:
    """A table whose rows of names are not columns of it."""
    shown = heads if unit == "N*m" else (*heads[:-1], "")
    laid = table(shown, [row for row in rows if row[0]], right=range(2, 8))
    yield Text({"1": "AC/BC", "N*m": "N·m; J", "kg": "kg", "kg*m^2": "GD², kg·m² (kgf·m²)"}[unit], style="bold")
    yield laid[0][:width]
    for line, (_number, name, *_cells) in zip(laid[1:], [row for row in rows if not row[0]], strict=True):
        yield line[:width]
        yield Text(f"       {name}")


def _peak(peak: CurvePeak) -> str:
    """A value with its angle."""
    return f"{_plain(peak.value)} {np.degrees(peak.angle):.1f}°"


def _plain(value: float) -> str:
    """Five figures; what is but rounding is 0."""
    return "0" if abs(value) < 1e-12 else f"{value:.5g}"


def _verdicts(drive: CrankRockerDrive) -> Iterator[tuple[str, str]]:
    """What is wrong, each with its number."""
    found = absurdities(drive)
    yield (
        "-",
        _(
            "Kunitsky and Popov: a turn with an active load and no losses takes {work}, which must be 0; their GD² "
            "falls below (GD²)₀ over {below:.2f}° of a turn, to {least}; their Q′ put into (1) needs sin²(α₁ − β) = 1, "
            "and it is down to {square:.4f}; their idle torque is a flat line."
        ).format(
            work=number(found.refuted_work, "J"),
            below=np.degrees(found.below),
            least=number(found.least_moment, "kg*m^2"),
            square=found.least_square,
        ),
    )
    yield "-", _("(13) prints r₁ for r: {times:g} times the torque of (12).").format(times=found.too_long)
    yield (
        "-",
        _(
            "(14) divides by η whether the load resists or drives: over a turn of an active load it loses nothing, "
            "where {lost} are lost."
        ).format(lost=number(found.lost, "J")),
    )
    yield (
        "-",
        _("(20) prints i for i², and η: the crank-rocker's part is {times:.4g} times too large.").format(
            times=found.too_large
        ),
    )
    yield (
        "-",
        _("(21) changes its sign with a weight or a spring alone: friction reverses with the rocker and never drives."),
    )


def _friction_lines(drive: CrankRockerDrive) -> Iterator[str]:
    """Say what friction circles give, if radii are known."""
    if drive.friction is None:
        yield _("No pins are given: f with r_O, r_B, r_A, r_O1.")
        return
    found = pin_friction(drive, drive.friction)
    if found is None:
        yield _("The pins lock the links, or no load drives them.")
        return
    parts = _(" and ").join(
        f"{np.degrees(one.start) % 360:.3f}–{np.degrees(one.end) % 360:.3f}°" for one in found.locked
    )
    yield _(
        "Mean efficiency {driving:.6f} while an active load resists and {driven:.6f} while it drives. Torque from "
        "{smallest} to {largest}; at the dead positions {extended} and {folded}, not 0. The load cannot drive "
        "in {parts}."
    ).format(
        driving=found.driving,
        driven=found.driven,
        smallest=number(found.smallest, "N*m"),
        largest=number(found.largest, "N*m"),
        extended=number(found.at_dead[0], "N*m"),
        folded=number(found.at_dead[1], "N*m"),
        parts=parts,
    )
