"""What the text on the crank drive states of a crank-rocker with its drive: (1) to (21), each beside what is right."""

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from cranktrain.errors import Problem, problems_as, refuse
from cranktrain.io.any_machine import MachineLike, source_of
from cranktrain.io.own_tables import own_table
from cranktrain.io.syntax import parsed
from cranktrain.language import Words, _
from cranktrain.motion import Array
from cranktrain.plans.machine_drive import machine_drive
from cranktrain.saying.wording import all_of, number
from cranktrain.textbook.alike import instead
from cranktrain.textbook.asked_angle import asked_angle
from cranktrain.textbook.statements import Statement, StatementCurve, Statements, Verdict
from cranktrain.texts.crank_rocker_drive import (
    Directions,
    centre_distances,
    crank_pin_force,
    directions,
    refuted_rod_force,
    rod_force,
    weight_at_rocker_pin,
)
from cranktrain.texts.drive_curves import CurveFacts, DriveCurve, curve_facts, dead_positions, drive_curves, values_at
from cranktrain.texts.drive_table import DRIVE_KEYS, CrankRockerDrive, read_drive
from cranktrain.texts.drive_verdicts import absurdities, pin_friction, swing
from cranktrain.texts.example_tables import example_table
from cranktrain.texts.friction_circles import rubbing_links

SOURCE = "gandzha"
USUAL_ANGLE = 60.0
"""At which forces and distances are given unless asked otherwise. [deg]"""

FACTS = ("at", "advancing", "going back", "mean", "rms", "turn")
"""What is given of every curve: its value at the angle, its peaks in both half-periods, means, the work of a turn."""
PEAKS = FACTS[1:3]
_ROUNDING = 1e-12

_VERDICTS: Mapping[str, Verdict] = {"right": "right", "source": "printed", "refuted": "refuted"}


def drive(
    machine: "MachineLike | None" = None,
    *,
    set: "Mapping[str, object] | None" = None,  # noqa: A002 - as the terminal's --set
    at: float = USUAL_ANGLE,
) -> Statements:
    """Give (1) to (21) of [gandzha] for a machine's crank-rocker and its drive, each beside what is right.

    Parameters
    ----------
    machine : str, path-like, dict or Machine, optional
        As `cranktrain.run` takes it, or a file with a drive's table; the text's own example unless given.
    set : mapping of str, optional
        Other values by path; what the text needs and the machine lacks by the text's symbols: `i`, `eta_p`, `eta_sh`,
        `Q`, `GD2_0`, …
    at : float
        Crank angle from the line of the fixed pivots, at which forces and distances are given. [deg]

    Returns
    -------
    Statements

    Raises
    ------
    InputError
        With everything that is wrong, or that the text needs.

    Examples
    --------
    >>> found = drive("tilting_table")
    >>> [(one.name, round(one.value, 3)) for one in found.numbered("14") if one.at == "going back"][0]
    ('at the motor, active load, by the stages of [drive]', -24.981)
    """
    values = {} if set is None else dict(set)
    symbols = {name: values.pop(name) for name in DRIVE_KEYS if name in values}
    angle, table = asked_angle(at), own_table(machine)
    if machine is None or table is not None:
        refuse(Problem(path, str(value), _("is for a machine: name it")) for path, value in values.items())
        data = tomllib.loads(example_table("drive")) if table is None else parsed(table.text, table.name)
        with problems_as(lambda one: one if table is None or one.path in symbols else table.located(one)):
            return drive_statements(read_drive({**data, **symbols}), angle)
    given = source_of(machine, values)

    def said(problem: Problem) -> Problem:
        return replace(problem, repair=instead(given.machine.places)) if problem.path == "mechanism" else problem

    with problems_as(given.placed), problems_as(said):
        return drive_statements(machine_drive(given.machine, symbols), angle)


def drive_statements(drive: CrankRockerDrive, angle: float = USUAL_ANGLE) -> Statements:
    """Give all numbers and curves of the text for a drive.

    Parameters
    ----------
    drive : CrankRockerDrive
    angle : float
        Crank angle from the line of the fixed pivots, at which forces and distances are given. [deg]

    Returns
    -------
    Statements
        Curves by whole degrees of that angle.
    """
    curves = drive_curves(drive)
    facts = {one: curve_facts(drive, one) for one in curves}
    right = {one: _right_of(one, curves) for one in curves}
    over = np.arange(361.0)
    return Statements(
        _("Drive of a crank-rocker, (1) to (21) [{source}]", source=SOURCE),
        (
            *_at_angle(drive, angle),
            *(one for curve in curves for one in _of_curve(drive, curve, right[curve], facts, angle)),
        ),
        over,
        (
            *(_over_turn(drive, curve, right[curve], np.deg2rad(over)) for curve in curves),
            *_rubbing(drive, np.deg2rad(over)),
        ),
        {
            _("The linkage"): (*_of_linkage(drive), *_of_numbers(drive)),
            _("What is absurd about it"): tuple(_absurd(drive)),
            _("Friction in the pins instead of η_ш, at the crank"): tuple(_of_friction(drive)),
        },
    )


def _right_of(curve: DriveCurve, curves: tuple[DriveCurve, ...]) -> DriveCurve:
    """The right curve of the same thing."""
    if curve.verdict == "right":
        return curve
    return next(one for one in curves if one.verdict == "right" and one.thing == curve.thing)


def _statement(
    equation: str, symbol: str, words: Words, value: Array | float, unit: str, right: Array | float | None = None
) -> Statement:
    """A number at the angle: right, or refuted where another one is."""
    size = float(value)
    verdict: Verdict = "right" if right is None else "refuted"
    return Statement(
        SOURCE, equation, symbol, words, "", "at", size, unit, verdict, size if right is None else float(right)
    )


def _at_angle(drive: CrankRockerDrive, angle: float) -> Iterator[Statement]:
    """Directions, forces, the instant centre, the weights: (1) to (11), (15) to (17)."""
    at = directions(np.array(np.deg2rad(angle)), drive.geometry)
    for one in (*_directions(at), *_forces(drive, at), *_distances(drive, at)):
        yield replace(one, crank_angle=angle)


def _directions(at: Directions) -> Iterator[Statement]:
    turn = 2 * np.pi
    yield _statement("", "β", _("direction of the rod"), at.rod % turn, "rad")
    yield _statement("", "α₁", _("direction of the rocker"), at.rocker % turn, "rad")


def _forces(drive: CrankRockerDrive, at: Directions) -> Iterator[Statement]:
    load, in_rod = drive.load, rod_force(drive.load, at)
    yield _statement("(1)", "Q r₁", _("torque on the rocker"), load * drive.geometry.rocker_length, "N*m")
    yield _statement("(2)", "Q′", _("force in the rod"), in_rod, "N")
    yield _statement("(2)", "Q′", _("the same by Kunitsky and Popov"), refuted_rod_force(load, at), "N", in_rod)
    yield _statement("(3) (4)", "T", _("force at the crank pin"), crank_pin_force(load, at), "N")


def _distances(drive: CrankRockerDrive, at: Directions) -> Iterator[Statement]:
    ac, bc = centre_distances(drive.geometry.rod_length, at)
    weight = weight_at_rocker_pin(drive.driven_moment, drive.geometry.rocker_length)
    yield _statement("(8) (9)", "T", _("the same as Q AC/BC"), drive.load * ac / bc, "N")
    yield _statement("(5) (10)", "AC", _("from the instant centre to A"), ac, "m")
    yield _statement("(5) (10)", "BC", _("to B, by the sine rule in ABC"), bc, "m")
    yield _statement("(11)", "sin ∠BAC", _("proof of (10)"), np.abs(np.sin(at.rocker - at.rod)), "1")
    yield _statement("(15)", "G_A", _("weight at A"), weight, "kg")
    yield _statement("(16) (17)", "G_B", _("weight at B"), weight * (ac / bc) ** 2, "kg")


def _of_curve(
    drive: CrankRockerDrive, curve: DriveCurve, right: DriveCurve, facts: Mapping[DriveCurve, CurveFacts], angle: float
) -> Iterator[Statement]:
    """Value at the angle, peaks, means and work of a curve."""
    values, exact = (_facts(drive, one, facts[one], angle) for one in (curve, right))
    for at, value in values.items():
        if at != "turn" or curve.unit == "N*m":
            size, where = value
            yield Statement(
                SOURCE,
                curve.number,
                curve.symbol,
                _(curve.name),
                "",
                at,
                size,
                _unit(curve, at),
                _VERDICTS[curve.verdict],
                exact[at][0],
                where,
            )


def _unit(curve: DriveCurve, at: str) -> str:
    return "J" if at == "turn" else curve.unit


def _facts(
    drive: CrankRockerDrive, curve: DriveCurve, facts: CurveFacts, angle: float
) -> dict[str, tuple[float, float]]:
    """Each fact of a curve with its angle; a flat line has no peaks at any. [deg]"""
    value = float(values_at(drive, curve, np.deg2rad(np.array([angle])))[0])
    is_flat = all(abs(peak.value - facts.mean) <= _ROUNDING * abs(facts.mean) for peak in facts[:2])
    peaks = [(peak.value, np.nan if is_flat else float(np.degrees(peak.angle))) for peak in facts[:2]]
    return dict(zip(FACTS, [(value, angle), *peaks, *((one, np.nan) for one in facts[2:])], strict=True))


def _over_turn(drive: CrankRockerDrive, curve: DriveCurve, right: DriveCurve, angle: Array) -> StatementCurve:
    values, exact = (values_at(drive, one, angle) for one in (curve, right))
    return StatementCurve(
        SOURCE, curve.number, curve.symbol, _(curve.name), "", curve.unit, _VERDICTS[curve.verdict], values, exact
    )


def _rubbing(drive: CrankRockerDrive, angle: Array) -> Iterator[StatementCurve]:
    """Torque on the crank whose pins rub, if radii are known."""
    if drive.friction is not None and any(map(float, drive.friction)):
        load = drive.load * drive.geometry.rocker_length
        torque = rubbing_links(angle, drive.geometry, load, drive.friction).torque
        name = _("torque on the crank with friction circles")
        yield StatementCurve(SOURCE, "", "M_O", name, "", "N*m", "beyond", torque)


def _of_linkage(drive: CrankRockerDrive) -> Iterator[Words]:
    """Say where the rocker turns round, and how far it swings."""
    dead = dead_positions(drive.geometry)
    yield _(
        "Dead positions at {extended:.4f}° (extended) and {folded:.4f}° (folded), where the load has no torque. Swing "
        "{swing:.4f}°, advance during {advance:.2f}°, back during {back:.2f}°.",
        extended=np.degrees(dead.extended),
        folded=np.degrees(dead.folded),
        swing=np.degrees(swing(drive)),
        advance=np.degrees(dead.advance.end - dead.advance.start),
        back=np.degrees(dead.back.end - dead.back.start),
    )


def _of_numbers(drive: CrankRockerDrive) -> Iterator[Words]:
    """Say which numbers are counted with, and which rows of (14) are of the machine's own load."""
    train = drive.train
    yield _(
        "i = {ratio:g}, η_p = {gear:.4g}, η_ш = {linkage:.4g}; Q = {load}, M_xx = {idle}; (GD²)₀ = {own}, of what is "
        "driven GD² = {driven}.",
        ratio=train.ratio,
        gear=float(train.gear_efficiency),
        linkage=float(train.linkage_efficiency),
        load=number(float(drive.load), "N"),
        idle=number(float(drive.idle_torque), "N*m"),
        own=number(float(drive.gear_moment), "kg*m^2"),
        driven=number(float(drive.driven_moment), "kg*m^2"),
    )
    said = {
        "active": _("This machine's load is active: of (14) the first row is its own."),
        "resisting": _("This machine's load resists: of (14) the row of dry friction is its own."),
        "both": _(
            "Of this machine's loads some are active and some resist: Q is their sum, and no row of (14) its own."
        ),
    }
    if drive.load_sense:
        yield said[drive.load_sense]


def _absurd(drive: CrankRockerDrive) -> Iterator[Words]:
    """Say what is wrong, each with its number."""
    found = absurdities(drive)
    yield _(
        "Kunitsky and Popov: a turn with an active load and no losses takes {work}, which must be 0; their GD² falls "
        "below (GD²)₀ over {below:.2f}° of a turn, to {least}; their Q′ put into (1) needs sin²(α₁ − β) = 1, and it is "
        "down to {square:.4f}; their idle torque is a flat line.",
        work=number(found.refuted_work, "J"),
        below=np.degrees(found.below),
        least=number(found.least_moment, "kg*m^2"),
        square=found.least_square,
    )
    yield _("(13) prints r₁ for r: {times:g} times the torque of (12).", times=found.too_long)
    yield _(
        "(14) divides by η whether the load resists or drives: over a turn of an active load it loses nothing, where "
        "{lost} are lost.",
        lost=number(found.lost, "J"),
    )
    yield _(
        "(20) prints i for i², and η: the crank-rocker's part is {times:.4g} times too large.", times=found.too_large
    )
    yield _(
        "(21) changes its sign with a weight or a spring alone: friction reverses with the rocker and never drives."
    )


def _of_friction(drive: CrankRockerDrive) -> Iterator[Words]:
    """Say what friction circles give, if radii are known."""
    if drive.friction is None:
        yield _("No pins are given: f with r_O, r_B, r_A, r_O1.")
        return
    if not any(map(float, drive.friction)):
        yield _("The pins have no friction: f or all their radii are 0.")
        return
    yield _(
        "The load is the torque Q r₁ on the rocker's shaft, as (1) has it: a force Q across the rocker at A would "
        "press on the pin O₁, too, and rub there."
    )
    found = pin_friction(drive, drive.friction)
    if found is None:
        yield _("The pins lock the links, or no load drives them.")
        return
    parts = [f"{np.degrees(one.start) % 360:.3f}–{np.degrees(one.end) % 360:.3f}°" for one in found.locked]
    yield _(
        "Mean efficiency {driving:.6f} while an active load resists and {driven:.6f} while it drives. Torque from "
        "{smallest} to {largest}; at the dead positions {extended} and {folded}, not 0. The load cannot drive "
        "in {parts}.",
        driving=found.driving,
        driven=found.driven,
        smallest=number(found.smallest, "N*m"),
        largest=number(found.largest, "N*m"),
        extended=number(found.at_dead[0], "N*m"),
        folded=number(found.at_dead[1], "N*m"),
        parts=all_of(parts),
    )
