"""What the texts state of a piston's or a valve's motion: every form with its largest errors, and constructions."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from cranktrain.analysis import Result, run
from cranktrain.errors import problems_as
from cranktrain.grouping import places_of_equal
from cranktrain.io.any_machine import MachineLike, source_of
from cranktrain.language import Listed, Words, _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.motion import Array, Coefficient
from cranktrain.saying.wording import all_of, ranged
from cranktrain.textbook.alike import AlikePistons, alike, unspoken
from cranktrain.textbook.construction_statements import construction_statements
from cranktrain.textbook.crank_rocker_statements import alike_rockers, crank_rocker_curves, crank_rocker_statements
from cranktrain.textbook.statements import (
    Heading,
    MotionForm,
    Statement,
    StatementCurve,
    Statements,
    Verdict,
    error_statements,
    with_degrees,
)
from cranktrain.textbook.steam_engine_statements import crank_side_curves, plain_crank_statements
from cranktrain.texts.comparison import FORMS
from cranktrain.texts.largest_errors import largest_errors
from cranktrain.texts.plain_cranks import PLAIN, plain_crank
from cranktrain.texts.ranges import EXACT_ROOT, RANGES, Range
from cranktrain.texts.steam_engine import exact_root

_ERRORS = ("displacement_error", "velocity_error", "acceleration_error")
NEEDED = (*_ERRORS, "top_dead_centre", "top_shift")
"""Results of a run on which these statements rest."""

_SYMBOLS: Mapping[str, tuple[str, str, str]] = {
    "steam-engine": ("S", "c/ω", "j/ω²"),
    "bolotin": ("S", "v/ω", "j/ω²"),
}
_KINDS = frozenset(kind for form in FORMS.values() for kind in form)
"""Of which there are forms."""
_UNITS = ("m", "m/rad", "m/rad^2")


def motion(
    machine: MachineLike,
    *,
    set: "Mapping[str, object] | None" = None,  # noqa: A002 - as the terminal's --set
) -> Statements:
    """Give what the texts state of the motion of a machine's pistons and valves, each beside what is exact.

    (333) to (337), the exact root, arcs and Brix's construction of [steam-engine], for slider-cranks and for
    eccentrics; (7), (10), (13) and (17) of [gandzha], for crank-rockers; (I.13) of [bolotin], for slaves on articulated
    rods.

    Parameters
    ----------
    machine : str, path-like, dict or Machine
        As `cranktrain.run` takes it.
    set : mapping of str, optional
        Other values by path.

    Returns
    -------
    Statements
        Of every distinct piston, valve and crank-rocker. Errors of displacement `Δx` are parts of the stroke, of
        velocity `Δv` and acceleration `Δj` parts of the exact peak [1], `exact` 0 beside them; lengths in m, angles in
        rad. The verdict is `approximate` in the range that the text gives, else `out of range`. `crank_angle` and the
        curves' angles count from where the piston's own crank, or the valve's eccentric, points along its line of
        stroke; what is `from the crank side`, from half a turn later; a crank-rocker's from the line of its fixed
        pivots [deg]. Curves by whole degrees. [m, m/rad, m/rad²; 1]

    Raises
    ------
    InputError
        With everything that is wrong; where no text has a form for any mechanism of the machine.

    Examples
    --------
    >>> found = motion("great_northern")
    >>> [(one.symbol, f"{one.value:.2e}", one.verdict) for one in found.numbered("(334)")][0]
    ('Δx', '3.12e-02', 'out of range')
    """
    given = source_of(machine, set)
    with problems_as(given.placed):
        if not (alike(given.machine.places, _KINDS) or alike_rockers(given.machine.places)):
            allowed = _("must have a slider-crank, an eccentric, an articulated rod or a crank-rocker")
            raise unspoken(given.machine.places, allowed)
        return motion_statements(given.machine, run(given.machine, quantities=NEEDED))


def motion_statements(machine: Machine, result: Result) -> Statements:
    """Give them of a machine that has been run.

    Parameters
    ----------
    machine : Machine
        With a mechanism that a text speaks of.
    result : Result
        Its own, with `NEEDED`.

    Returns
    -------
    Statements
        As `motion` has them; the ranges, and who is inside, as notes by the methods' names.
    """
    plain = alike(machine.places, PLAIN)
    rockers = alike_rockers(machine.places)
    spoken_of = [one for one in RANGES if alike(machine.places, FORMS[one.method])]
    over = np.arange(361.0)
    return Statements(
        _("Motion by the texts"),
        (
            *(found for one in spoken_of for found in form_statements(machine, result, one)),
            *plain_crank_statements(plain),
            *construction_statements(machine, plain),
            *(found for one in rockers for found in crank_rocker_statements(one)),
        ),
        over,
        (
            *(curve for one in spoken_of for curve in form_curves(machine, one, np.deg2rad(over))),
            *(curve for one in plain for curve in root_curves(one, np.deg2rad(over))),
            *(curve for one in plain for curve in crank_side_curves(one, np.deg2rad(over))),
            *(curve for one in rockers for curve in crank_rocker_curves(one, np.deg2rad(over))),
        ),
        {
            **{form_heading(one): tuple(form_notes(machine, one)) for one in spoken_of},
            **({form_heading(EXACT_ROOT): tuple(root_notes(machine.places))} if plain else {}),
        },
    )


def form_heading(one: Range) -> Words:
    """Name a method with its numbers and its source."""
    return Heading(Listed((_(one.name), f"{', '.join(one.equations)} [{one.source}]"), ": "))


def form_notes(machine: Machine, one: Range) -> Iterator[Words]:
    """Say a method's range, and which pistons and valves are inside; outside, for what."""
    yield _("range: {condition}", condition=_(one.condition))
    if one.most_ratio is not None:
        yield _inside_of(one, [place for place in machine.places if place.kind.name in FORMS[one.method]])


def root_notes(places: Sequence[PlacedMechanism]) -> Iterator[Words]:
    """Say what the exact root is, its range, and which pistons and valves are inside."""
    yield _("range: {condition}", condition=_(EXACT_ROOT.condition))
    yield _inside_of(EXACT_ROOT, [place for place in places if place.kind.name in PLAIN])
    yield _("S = R(1 − cos φ) + L(1 − √(1 − λ² sin² φ)), and its derivatives")


def _inside_of(one: Range, places: Sequence[PlacedMechanism]) -> Words:
    """Say which are inside a range, and for what the others are not."""
    names = [place.name for place in places]
    said = places_of_equal([_inside(one, place) for place in places])
    return Listed([Listed((ranged(names, members), words), ": ") for words, members in said.items()], "; ")


def _inside(one: Range, place: PlacedMechanism) -> Words:
    radius, rod, offset = plain_crank(getattr(place.geometry, "master", place.geometry))
    if reasons := list(one.reasons(float(radius / rod), float(offset))):
        return _("outside, as {reasons}", reasons=all_of(reasons))
    return _("inside, λ = {ratio:.4g}", ratio=float(f"{float(radius / rod):.4g}"))


def form_statements(machine: Machine, result: Result, one: Range) -> Iterator[Statement]:
    """Give a method's largest errors for every distinct piston or valve."""
    form = MotionForm(one.source, one.equations, _(one.name))
    for each in alike(machine.places, FORMS[one.method]):
        found = _of_plain(each, one) if each.first.kind.name in PLAIN else _of_slave(each, result, one)
        yield from error_statements(form, each.of, found, each.verdict(one))


def _of_plain(each: AlikePistons, one: Range) -> list[tuple[float, float]]:
    """Errors and own angles of a crank or an eccentric, however long its rod is. [1, deg]"""
    return with_degrees(largest_errors(FORMS[one.method]["slider_crank"](each.plain), each.exact))


def _of_slave(each: AlikePistons, result: Result, one: Range) -> list[tuple[float, float]]:
    """Errors of a slave, which its run has, and its own angles. [1, deg]"""
    row, piston = result.labels["motion_method"].index(one.method), result.labels["piston"].index(each.first.name)
    along = result.top_dead_centre[piston] - result.top_shift[piston]
    return [
        (float(getattr(result, name)[row, piston]), float(getattr(result, f"{name}_at")[row, piston] - along))
        for name in _ERRORS
    ]


def form_curves(machine: Machine, one: Range, angle: Array) -> Iterator[StatementCurve]:
    """Motion of every distinct piston or valve by a method."""
    for each in alike(machine.places, FORMS[one.method]):
        form = FORMS[one.method][each.first.kind.name]
        own = form(each.geometry)(each.kernel_angle(angle))
        yield from _curves(one, each, each.verdict(one), own, each.exact(angle))


def root_curves(each: AlikePistons, angle: Array) -> Iterator[StatementCurve]:
    """Motion by the root that is not approximated."""
    own = exact_root(angle, each.plain.crank_radius, each.plain.crank_radius / each.plain.rod_length)
    verdict: Verdict = "right" if each.offset == 0.0 else "out of range"
    yield from _curves(EXACT_ROOT, each, verdict, own, each.exact(angle))


def _curves(
    one: Range, each: AlikePistons, verdict: Verdict, own: Coefficient, exact: Coefficient
) -> Iterator[StatementCurve]:
    """Displacement, velocity and acceleration."""
    for order, (symbol, unit) in enumerate(zip(_SYMBOLS[one.source], _UNITS, strict=True)):
        equation = one.equations[min(order, len(one.equations) - 1)]
        yield StatementCurve(
            one.source, equation, symbol, _(one.name), each.of, unit, verdict, own[order], exact[order]
        )
