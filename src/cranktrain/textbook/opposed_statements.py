"""What the text on opposed pistons states of a machine: (I.11), (I.12), lead and dead centres, beside what is exact."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.analysis import Result, run
from cranktrain.errors import problems_as
from cranktrain.grouping import grouped
from cranktrain.io.any_machine import MachineLike, source_of
from cranktrain.language import Listed, Words, _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.layout.specs import ENDS
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.motion import Array
from cranktrain.numerics import around_zero, extremes
from cranktrain.saying.percents import percent
from cranktrain.saying.wording import number, ranged
from cranktrain.textbook.alike import unspoken
from cranktrain.textbook.statements import (
    MotionForm,
    Statement,
    StatementCurve,
    Statements,
    Verdict,
    error_statements,
    with_degrees,
)
from cranktrain.texts.largest_errors import LargestErrors
from cranktrain.texts.leads import SOURCE, is_unsuited, reasons, verdict
from cranktrain.texts.opposed import (
    OpposedSize,
    combined_stroke,
    opposed_pistons,
    volumetric_dead_centres,
    volumetric_dead_centres_to_first_order,
)
from cranktrain.texts.opposed_errors import OpposedPair, exact_pair, opposed_errors

NEEDED = (
    "combined_stroke",
    "inner_volumetric_shift",
    "outer_volumetric_shift",
    "exhaust_opens_before",
    "exhaust_closes_before",
)
"""Results of a run that stand beside, where a machine gives them."""
INNER, OUTER = "inner", "outer"
"""Which dead centre one is."""

_DIGITS = 13
"""Of a lead in rad, in which leads of one machine are alike."""
_EQUATIONS = ("(I.11)", "(I.12)", "(I.11) (I.12)")
_MOTION = (("S", "m"), ("v/ω", "m/rad"), ("j/ω²", "m/rad^2"))
_INDICES = {"exhaust": "в", "scavenge": "п"}
"""The text's own: выпускной, продувочный."""


class OpposedCylinders(NamedTuple):
    """Cylinders with one pair of pistons: the pair, and the places of both pistons of each."""

    pair: OpposedPair
    places: tuple[tuple[PlacedMechanism, PlacedMechanism], ...]

    @property
    def of(self) -> tuple[str, str, str]:
        """Names of the exhaust pistons, of the scavenge pistons, of the cylinders."""
        members = range(len(self.places))
        exhaust, scavenge = (ranged([both[i].name for both in self.places], members) for i in range(len(ENDS)))
        return exhaust, scavenge, ranged([both[0].cylinder for both in self.places], members)

    @property
    def verdict(self) -> Verdict:
        """Whether the formulas' mechanisms are these, with lines of stroke through the shafts' centres."""
        return "approximate" if self.pair.is_central else "out of range"


def opposed(
    machine: MachineLike,
    *,
    set: "Mapping[str, object] | None" = None,  # noqa: A002 - as the terminal's --set
) -> Statements:
    """Give (I.11), (I.12) of [bolotin] for a machine's opposed pistons, on two shafts or on one, beside what is exact.

    Parameters
    ----------
    machine : str, path-like, dict or Machine
        As `cranktrain.run` takes it.
    set : mapping of str, optional
        Other values by path.

    Returns
    -------
    Statements
        Of every distinct pair: sizes of fig. 1.3 [m], λ [1]; the lead Δ [rad]; the largest errors of (I.11), of (I.12)
        and of both together, of travel in parts of the stroke, of velocity and acceleration in parts of the exact peak
        [1], `exact` 0 beside them; volumetric dead centres by the text and to first order [rad]; the combined stroke
        [m]. Angles count from the exhaust crank's inner dead centre: `crank_angle` in deg; curves by whole degrees, of
        each piston's travel from its own inner dead centre, outward, and of both. [m, m/rad, m/rad²]

    Raises
    ------
    InputError
        With everything that is wrong; where no cylinder has two pistons on slider-cranks.

    Notes
    -----
    The text writes both formulas for two shafts. On one shaft the far piston, on side rods, is innermost where its
    crank points away from the cylinder; λ has the minus sign there that (333), (336), (337) have from the crank-side
    dead centre.

    Examples
    --------
    >>> found = opposed("10d100")
    >>> [(one.of, one.symbol, f"{one.value:.2e}") for one in found.numbered("(I.11)")][0]
    ('1.exhaust–10.exhaust', 'Δx', '1.01e-03')
    >>> print(found.notes["Lead of the exhaust crank [bolotin]"][0])
    12.00 deg: suits engines that turn one way (10–15°), too much for engines that reverse (5–10°)
    """
    given = source_of(machine, set)
    with problems_as(given.placed):
        cylinders = opposed_cylinders(given.machine.places)
        if not cylinders:
            allowed = _("must have cylinders with two opposed pistons on slider-cranks, [bank.A.exhaust] and scavenge")
            raise unspoken(given.machine.places, allowed)
        return opposed_statements(cylinders, run(given.machine, quantities=NEEDED))


def opposed_cylinders(places: Sequence[PlacedMechanism]) -> tuple[OpposedCylinders, ...]:
    """Find cylinders with two pistons on slider-cranks, those with one sort of pair together."""
    members = grouped((place.cylinder, place) for place in places)
    pairs: list[tuple[PlacedMechanism, PlacedMechanism]] = []
    for pair in members.values():
        ends = {place.name.rpartition(".")[2]: place for place in pair}
        if len(pair) == len(ENDS) and all(isinstance(place.geometry, SliderCrank) for place in pair):
            pairs.append((ends["exhaust"], ends["scavenge"]))
    return tuple(
        OpposedCylinders(pair, tuple(both)) for pair, both in grouped((_pair(*both), both) for both in pairs).items()
    )


def _pair(exhaust: PlacedMechanism, scavenge: PlacedMechanism) -> OpposedPair:
    """Two pistons of a cylinder, with the lead of the exhaust's crank."""
    ahead = around_zero(np.array(scavenge.inner_dead_centre - exhaust.inner_dead_centre))
    far = next((end for end, place in zip(ENDS, (exhaust, scavenge), strict=True) if place.is_far), "")
    return OpposedPair(exhaust.geometry, scavenge.geometry, round(float(ahead), _DIGITS), far)


def opposed_statements(cylinders: Sequence[OpposedCylinders], result: Result) -> Statements:
    """Give them of a machine that has been run.

    Parameters
    ----------
    cylinders : sequence of OpposedCylinders
        Of that machine.
    result : Result
        Its own, with `NEEDED`.

    Returns
    -------
    Statements
        As `opposed` has them.
    """
    over = np.arange(361.0)
    return Statements(
        _("Opposed pistons, (I.11) and (I.12) [{source}]", source=SOURCE),
        tuple(found for one in cylinders for found in _of_cylinders(one, result)),
        over,
        tuple(curve for one in cylinders for curve in _curves(one, np.deg2rad(over))),
        {
            subject: tuple(sentences)
            for one in cylinders
            for subject, sentences in zip(
                subjects(one, several=len(cylinders) > 1),
                (_on_the_form(one), _on_dead_centres(one, result), _on_the_lead(one, result)),
                strict=True,
            )
        },
    )


def subjects(one: OpposedCylinders, *, several: bool) -> tuple[Words, Words, Words]:
    """What the notes are about: the formulas, the volumetric dead centres, the lead."""
    said = {"cylinders": one.of[2], "source": SOURCE}
    own, centres, lead = (
        _("(I.11), (I.12) for cylinders {cylinders} [{source}]"),
        _("Volumetric dead centres [{source}]"),
        _("Lead of the exhaust crank [{source}]"),
    )
    if several:
        centres = _("Volumetric dead centres of cylinders {cylinders} [{source}]")
        lead = _("Lead of the exhaust crank of cylinders {cylinders} [{source}]")
    return own.format(**said), centres.format(**said), lead.format(**said)


def _of_cylinders(one: OpposedCylinders, result: Result) -> Iterator[Statement]:
    """All numbers of one sort of pair."""
    yield from _sizes(one)
    suits: Verdict = "out of range" if is_unsuited(one.pair.lead) else "right"
    yield Statement(
        SOURCE, "", "Δ", _("lead of the exhaust crank"), one.of[2], "", one.pair.lead, "rad", suits, one.pair.lead
    )
    yield from _errors(one, opposed_errors(one.pair), _names())
    if one.pair.far:
        printed = tuple(_("{part}, λ as printed", part=name) for name in _names())
        for found in _errors(one, opposed_errors(one.pair, as_printed=True), printed, "out of range"):
            if found.of != one.of[1 - ENDS.index(one.pair.far)]:
                yield found
    yield from _dead_centres(one, result)


def _names() -> tuple[Words, Words, Words]:
    """What (I.11), (I.12) and both together are the motion of."""
    return _("exhaust"), _("scavenge"), _("both")


def _sizes(one: OpposedCylinders) -> Iterator[Statement]:
    """Cranks and rods, with the letters of fig. 1.3."""
    words = {
        "exhaust": (_("exhaust crank"), _("exhaust rod"), _("exhaust crank by rod")),
        "scavenge": (_("scavenge crank"), _("scavenge rod"), _("scavenge crank by rod")),
    }
    for end in ENDS:
        own: SliderCrank = getattr(one.pair, end)
        sizes = (own.crank_radius, own.rod_length, own.crank_radius / own.rod_length)
        for letter, name, size, unit in zip("RLλ", words[end], sizes, ("m", "m", "1"), strict=True):
            symbol = f"{letter}_{_INDICES[end]}"
            yield Statement(SOURCE, "fig. 1.3", symbol, name, one.of[2], "", float(size), unit, "right", float(size))


def _errors(
    one: OpposedCylinders, found: Sequence[LargestErrors], names: Sequence[Words], said: Verdict | None = None
) -> Iterator[Statement]:
    """Largest errors of each piston and of both together."""
    for equation, of, name, errors in zip(_EQUATIONS, one.of, names, found, strict=True):
        form = MotionForm(SOURCE, (equation,), name)
        yield from error_statements(form, of, with_degrees(errors), said or one.verdict)


def _dead_centres(one: OpposedCylinders, result: Result) -> Iterator[Statement]:
    """Volumetric dead centres by the text and to first order in the lead; the combined stroke."""
    pair, place = one.pair, _place(one, result)
    exact = (
        float(np.deg2rad(result.inner_volumetric_shift[place])),
        float(np.pi + np.deg2rad(result.outer_volumetric_shift[place])),
    )
    by_text: Verdict = "right" if pair.is_alike else "printed"
    first_order: Verdict = "right" if pair.is_alike else "approximate"
    half, better = volumetric_dead_centres(np.array(pair.lead)), volumetric_dead_centres_to_first_order(pair.size)
    for at, value, right in zip((INNER, OUTER), half, exact, strict=True):
        name = _("volumetric dead centre at half the lead")
        yield Statement(SOURCE, "", "Δ/2", name, one.of[2], at, float(value), "rad", by_text, right)
    for at, value, right in zip((INNER, OUTER), better, exact, strict=True):
        name = _("volumetric dead centre to first order in the lead")
        yield Statement(SOURCE, "", "Δ·w_s/(w_e + w_s)", name, one.of[2], at, float(value), "rad", first_order, right)
    stroke = float(result.combined_stroke[place])
    if pair.is_alike:
        value = float(combined_stroke(pair.exhaust.crank_radius, np.array(pair.lead)))
        yield Statement(SOURCE, "", "4R cos(Δ/2)", _("combined stroke"), one.of[2], "", value, "m", "right", stroke)
    else:
        value = _stroke_by_form(pair.size)
        yield Statement(
            SOURCE, _EQUATIONS[2], "S_Σ", _("combined stroke"), one.of[2], "", value, "m", one.verdict, stroke
        )


def _stroke_by_form(size: OpposedSize) -> float:
    """Largest less smallest travel of both together by (I.11) and (I.12). [m]"""
    low, high = extremes(lambda angle: opposed_pistons(angle, size).combined.value)
    return float((high.value - low.value)[..., 0])


def _place(one: OpposedCylinders, result: Result) -> int:
    """Which of the result's cylinders the first one is."""
    return result.labels["cylinder"].index(one.places[0][0].cylinder)


def _curves(one: OpposedCylinders, angle: Array) -> Iterator[StatementCurve]:
    """Travel, velocity and acceleration of each piston and of both, by the text and exact."""
    source, exact = opposed_pistons(angle, one.pair.size), exact_pair(angle, one.pair)
    for order, (symbol, unit) in enumerate(_MOTION):
        for equation, of, name, own, true in zip(_EQUATIONS, one.of, _names(), source, exact, strict=True):
            yield StatementCurve(SOURCE, equation, symbol, name, of, unit, one.verdict, own[order], true[order])


def _on_the_form(one: OpposedCylinders) -> Iterator[Words]:
    """Say from where travel counts, how the shafts turn, and what a far piston changes."""
    yield _("each piston from its own inner dead centre, outward; φ after the exhaust crank's")
    yield from _arrangement(one)
    if one.pair.far:
        part = ENDS.index(one.pair.far)
        error = float(opposed_errors(one.pair, as_printed=True)[part].displacement.value)
        yield _(
            "The {far} piston is the far one, on side rods: where it is innermost its crank points away from the "
            "cylinder, so that its λ has a minus sign, as (333) from the crank's side. The text prints plus, for two "
            "shafts; with that its {equation} is {error} % of the stroke off.",
            far=_names()[part],
            equation=_EQUATIONS[part],
            error=percent(error),
        )
    if not one.pair.is_central:
        yield _("Both formulas are of lines of stroke through the shafts' centres; here one is offset.")


def _arrangement(one: OpposedCylinders) -> Iterator[Words]:
    """Say which scheme of fig. 1.3 the shafts are, the cylinders of each."""
    names = [exhaust.cylinder for exhaust, _scavenge in one.places]
    words = {
        "one": _("one shaft for both pistons: the text names such engines, and has no figure of them"),
        "alike": _("fig. 1.3 а: two shafts that turn alike"),
        "against": _("fig. 1.3 б: two shafts that turn against each other"),
    }
    sorts = grouped((_turning(*both), i) for i, both in enumerate(one.places))
    for sort, members in sorts.items():
        whose = f"{ranged(names, members)}: " if len(sorts) > 1 else ""
        yield Listed((whose, words[sort], "."), "")


def _turning(exhaust: PlacedMechanism, scavenge: PlacedMechanism) -> str:
    if exhaust.shaft == scavenge.shaft:
        return "one"
    return "alike" if exhaust.sense == scavenge.sense else "against"


def _on_dead_centres(one: OpposedCylinders, result: Result) -> Iterator[Words]:
    """Say where half the lead is a dead centre, and by how much both pistons part."""
    pair = one.pair
    stroke = number(float(result.combined_stroke[_place(one, result)]), "mm")
    if pair.is_alike:
        own = number(float(combined_stroke(pair.exhaust.crank_radius, np.array(pair.lead))), "mm")
        nominal = number(4.0 * float(pair.exhaust.crank_radius), "mm")
        yield _(
            "Cranks and rods are equal: half the lead is exact, and so is 4R cos(Δ/2) = {own}, not {nominal}.",
            own=own,
            nominal=nominal,
        )
    elif pair.far:
        yield _(
            "One piston is on side rods, and has −λ in its w: half the lead is no dead centre. Both part by {stroke}.",
            stroke=stroke,
        )
    elif not pair.is_central:
        yield _("A line of stroke is offset: half the lead is no dead centre. Both part by {stroke}.", stroke=stroke)
    else:
        yield _("Cranks or rods differ: half the lead is no dead centre. Both part by {stroke}.", stroke=stroke)


def _on_the_lead(one: OpposedCylinders, result: Result) -> Iterator[Words]:
    """Say which engines the lead suits, and what it does to this machine's ports."""
    lead, place = one.pair.lead, _place(one, result)
    yield _("{lead}: {verdict}", lead=number(lead, "deg"), verdict=verdict(lead))
    gaps = (
        np.deg2rad(float(getattr(result, name)[place])) if name in result.catalogue else np.nan
        for name in ("exhaust_opens_before", "exhaust_closes_before")
    )
    yield from reasons(lead, *map(float, gaps))
