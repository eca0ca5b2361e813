"""Radial engines with articulated rods: five ways to choose the knuckles, each with what it costs elsewhere."""

from collections.abc import Iterator, Mapping, Sequence
from math import pi
from typing import Annotated, Literal

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import N_, Words, _
from cranktrain.mechanisms.articulated_rod import ArticulatedRod
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.motion import single
from cranktrain.paths import quoted
from cranktrain.quantities import unlisted
from cranktrain.saying.wording import as_limit, number
from cranktrain.synthesis.knuckle_equations import Free
from cranktrain.synthesis.knuckle_search import Search, searched
from cranktrain.synthesis.knuckle_slave import KnuckleRequirements, cylinder_table, slave_numbers
from cranktrain.synthesis.proposal import (
    Alternative,
    Bore,
    Count,
    Length,
    Number,
    Proposal,
    ProposedTable,
    Ratio,
    Speed,
    found,
    listed_in_lines,
    not_positive,
    plain,
    quantity_text,
    shaft_table,
    wanted,
)

Strategy = Literal["plain", "unshifted", "equal_ratio", "equal_stroke", "unshifted_equal_ratio"]

STRATEGIES: dict[Strategy, str] = {
    "plain": N_("ζ = γ, the same r and l for all"),
    "unshifted": N_("ζ = γ + asin(λ sin γ), no shift of a top dead centre"),
    "equal_ratio": N_("ζ = γ, each l for the same compression ratio"),
    "equal_stroke": N_("each r and ζ for the master's stroke and pin height"),
    "unshifted_equal_ratio": N_("no shift of a top dead centre, each l for the same compression ratio"),
}
"""Strategies by name, in words."""

_FREE: dict[Strategy, tuple[Free, ...]] = {
    "plain": (),
    "unshifted": (),
    "equal_ratio": ("rod_length",),
    "equal_stroke": ("articulation_angle", "knuckle_radius"),
    "unshifted_equal_ratio": ("rod_length",),
}
"""Dimensions of each slave that a strategy chooses."""


def radial(
    crank_radius: Length,
    rod_length: Annotated[Length, N_("Of the master.")],
    n_cylinders: Annotated[Count, N_("With the master's.")],
    strategy: Strategy,
    *,
    knuckle_radius: Annotated[Length, N_("Of all slaves, or where the search for each begins.")],
    slave_rod_length: Annotated[Length, N_("Of all slaves, or where the search for each begins.")],
    compression_ratio: Annotated[Ratio, N_("Of the master.")],
    bore: Bore | None = None,
    speed: Speed | None = None,
) -> Proposal:
    """Propose the knuckles of a radial engine with equally spaced cylinders, the first one the master's.

    Parameters
    ----------
    crank_radius, rod_length : float
        Of the master. [m]
    n_cylinders : int
        At least 3.
    strategy : str
        A key of `STRATEGIES`.
    knuckle_radius, slave_rod_length : float
        Common to all slaves, or where the search for their own begins. [m]
    compression_ratio : float
        Of the master.
    bore : float, optional
        For the machine file. [m]
    speed : float, optional
        [rad/s]

    Returns
    -------
    Proposal
        With `knuckle_radius(2)`, `articulation_angle(2)`, `rod_length(2)`, `stroke(2)`, `top_shift(2)`,
        `bottom_shift(2)`, `height_over_master(2)`, `compression_ratio(2)` … for every slave; the alternatives are all
        strategies, with the spread of each.

    Raises
    ------
    InputError
        If the strategy cannot be had, with what is possible.
    """
    lengths = {"crank_radius": crank_radius, "knuckle_radius": knuckle_radius, "slave_rod_length": slave_rod_length}
    refuse(_impossible(n_cylinders, strategy, compression_ratio, lengths, rod_length))
    master = SliderCrank(single(crank_radius), single(rod_length), single(0.0))
    common = single(knuckle_radius), single(slave_rod_length)
    start = [
        ArticulatedRod(master, common[0], single(angle), single(angle), common[1], single(0.0))
        for angle in (2 * pi * i / n_cylinders for i in range(1, n_cylinders))
    ]
    chosen = [_chosen(rod, strategy, compression_ratio) for rod in start]
    return Proposal(
        title=_(
            "Radial engine of {n} cylinders, {stroke} master stroke",
            n=n_cylinders,
            stroke=number(2 * crank_radius, "mm"),
        ),
        numbers=tuple(
            one._replace(member=str(i))
            for i, rod in enumerate(chosen, start=2)
            for one in slave_numbers(rod, compression_ratio)
        ),
        alternatives=tuple(_alternatives(start, compression_ratio)),
        remarks=(
            _("Chosen: {strategy}.", strategy=_(STRATEGIES[strategy])),
            _("Equal strokes and unshifted top dead centres exclude one another; one of them has to be borne."),
        ),
        tables=_tables(chosen, strategy, compression_ratio, bore, speed),
    )


def _impossible(
    n_cylinders: int, strategy: str, compression_ratio: float, lengths: Mapping[str, float], rod_length: float
) -> Iterator[Problem]:
    """Find requirements that contradict themselves."""
    yield from not_positive(lengths)
    if not rod_length > lengths["crank_radius"]:
        allowed = _("must be more than the crank radius, or the crank cannot turn")
        yield Problem("rod_length", as_limit(rod_length), allowed)
    if n_cylinders < 3:
        yield Problem("n_cylinders", str(n_cylinders), _("must be at least 3"))
    if strategy not in STRATEGIES:
        yield unlisted("strategy", strategy, list(STRATEGIES))
    if not compression_ratio > 1:
        yield Problem("compression_ratio", plain(compression_ratio), _("must be more than 1"))


def _requirements(strategy: Strategy, master: SliderCrank, ratio: float) -> KnuckleRequirements:
    """What a strategy demands of a slave."""
    is_equal = strategy == "equal_stroke"
    return KnuckleRequirements(
        stroke=float(2 * master.crank_radius) if is_equal else None,
        unshifted="top" if strategy.startswith("unshifted") else None,
        same_height=is_equal,
        same_ratio=ratio if strategy.endswith("equal_ratio") else None,
    )


def _chosen(rod: ArticulatedRod, strategy: Strategy, ratio: float) -> ArticulatedRod:
    """Geometry of one slave by a strategy."""
    search = searched(rod, _requirements(strategy, rod.master, ratio), _FREE[strategy])
    if not search.rods:
        raise InputError([_unreachable(rod, strategy, search)])
    return search.rods[0]


def _unreachable(rod: ArticulatedRod, strategy: Strategy, search: Search) -> Problem:
    """Say which slave defeats a strategy, and how near it comes."""
    angle = number(float(rod.bank_angle), "deg")
    if not _FREE[strategy]:
        allowed = _("too short: the slave at {angle} cannot close", angle=angle)
        return Problem("slave_rod_length", as_limit(float(rod.rod_length)), allowed)
    allowed = _("cannot be had for the slave at {angle} with this knuckle radius and rod", angle=angle)
    if strategy == "equal_stroke" and search.least <= search.most:
        allowed = _(
            "cannot be had: the slave at {angle} can have strokes from {least} to {most}",
            angle=angle,
            least=as_limit(search.least),
            most=as_limit(search.most),
        )
    return Problem("strategy", strategy, allowed, _("choose another strategy, or other common sizes"))


def _alternatives(start: Sequence[ArticulatedRod], ratio: float) -> Iterator[Alternative]:
    """All strategies with the spread of what they give; those that cannot be had are left out."""
    for strategy, words in STRATEGIES.items():
        try:
            rods = [_chosen(rod, strategy, ratio) for rod in start]
        except InputError:
            continue
        yield Alternative(_(words), _spread(rods, ratio))


def _spread(rods: Sequence[ArticulatedRod], ratio: float) -> tuple[Number, ...]:
    """Smallest and largest of what matters over all cylinders, the master's among them."""
    numbers = [{one.name: one.value for one in slave_numbers(rod, ratio)} for rod in rods]
    stroke = float(2 * rods[0].master.crank_radius)
    strokes = [stroke, *(each["stroke"] for each in numbers)]
    ratios = [ratio, *(each["compression_ratio"] for each in numbers)]
    shifts = [abs(each["top_shift"]) for each in numbers]
    return (
        Number("least_stroke", "S_min", min(strokes), "mm", _("Least stroke")),
        Number("largest_stroke", "S_max", max(strokes), "mm", _("Largest stroke")),
        Number("largest_top_shift", "ε_T", max(shifts), "deg", _("Largest shift of a top dead centre")),
        Number("least_ratio", "ε_min", min(ratios), "1", _("Least compression ratio")),
        Number("largest_ratio", "ε_max", max(ratios), "1", _("Largest compression ratio")),
    )


def _tables(
    rods: Sequence[ArticulatedRod], strategy: Strategy, ratio: float, bore: float | None, speed: float | None
) -> tuple[ProposedTable, ...]:
    """Tables of the machine file: the master's bank, the slaves', and the cylinders."""
    master = rods[0].master
    how = _("strategy {name}", name=strategy)

    def each(name: Free, unit: str) -> Words:
        values = [float(getattr(rod, name)) for rod in rods]
        if name in _FREE[strategy]:
            return listed_in_lines([found(value, unit, how, "fitted") for value in values])
        if name == "articulation_angle":
            return listed_in_lines([found(value, unit, how) for value in values])
        return wanted(values[0], unit)

    angles = ", ".join(quoted(quantity_text(float(rod.bank_angle), "deg")) for rod in rods)
    return (
        *shaft_table(speed),
        ProposedTable(
            "bank.M.mechanism",
            {
                "kind": '"slider_crank"',
                "crank_radius": wanted(float(master.crank_radius), "mm"),
                "rod_length": wanted(float(master.rod_length), "mm"),
            },
        ),
        ProposedTable("bank.S", {"angle": f"[{angles}]"}),
        ProposedTable(
            "bank.S.mechanism",
            {
                "kind": '"articulated_rod"',
                "master": '"M"',
                "knuckle_radius": each("knuckle_radius", "mm"),
                "rod_length": each("rod_length", "mm"),
                "articulation_angle": each("articulation_angle", "deg"),
            },
        ),
        *cylinder_table(ratio, bore),
    )
