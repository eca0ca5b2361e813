"""Knuckle of an articulated rod from a wanted stroke, unshifted dead centre, pin height or compression ratio."""

from collections.abc import Collection, Iterator, Sequence
from math import pi
from typing import Annotated, Literal

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import N_, Words, _
from cranktrain.mechanisms.articulated_rod import ArticulatedRod
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.motion import single
from cranktrain.paths import quoted
from cranktrain.saying.wording import as_limit, number
from cranktrain.synthesis.knuckle_equations import Free, stroke_product, unshifted_angle
from cranktrain.synthesis.knuckle_search import Search, is_usable, searched
from cranktrain.synthesis.knuckle_slave import KnuckleRequirements, cylinder_table, slave_numbers
from cranktrain.synthesis.proposal import (
    Alternative,
    Angle,
    Bore,
    Length,
    Proposal,
    ProposedTable,
    Ratio,
    Speed,
    found,
    not_positive,
    plain,
    quantity_text,
    shaft_table,
    wanted,
)

_FREE: tuple[Free, ...] = ("articulation_angle", "knuckle_radius", "rod_length")
_UNITS: dict[Free, str] = {"articulation_angle": "deg", "knuckle_radius": "mm", "rod_length": "mm"}
_FACTORS = (0.8, 0.9, 1.1, 1.2)
_STEPS = tuple(pi / 180 * degree for degree in (-4, -2, 2, 4))
_KNUCKLE_SHARE = 0.25
"""Where the search for a free knuckle radius begins, in parts of the master rod; the slave rod has the rest."""


def knuckle_from_requirements(
    crank_radius: Length,
    master_rod_length: Length,
    bank_angle: Annotated[Angle, N_("From the master's cylinder, in the sense of rotation.")],
    *,
    master_offset: Length = 0.0,
    stroke: Annotated[Length | None, N_("Want: of the slave.")] = None,
    unshifted: Annotated[Literal["top", "bottom"] | None, N_("Want: a dead centre on the cylinder's axis.")] = None,
    same_height: Annotated[bool, N_("Want: the master's pin height at the top.")] = False,
    same_ratio: Annotated[Ratio | None, N_("Want: the master's compression ratio, this.")] = None,
    knuckle_radius: Length | None = None,
    rod_length: Length | None = None,
    articulation_angle: Angle | None = None,
    bore: Bore | None = None,
    speed: Speed | None = None,
) -> Proposal:
    """Propose a knuckle: of r, l and ζ as many are free as there are requirements, the others are given.

    Parameters
    ----------
    crank_radius, master_rod_length : float
        [m]
    bank_angle : float
        γ, from the master's cylinder to the slave's in the sense of rotation. [rad]
    master_offset : float
        [m]
    stroke : float, optional
        Wanted of the slave. [m]
    unshifted : "top" or "bottom", optional
        The dead centre that is to stay where the crank points along the slave's cylinder.
    same_height : bool
        Whether the slave's piston pin is to stand as high at its top as the master's.
    same_ratio : float, optional
        Compression ratio of the master that the slave is to have too, with the same deck and chamber.
    knuckle_radius, rod_length, articulation_angle : float, optional
        r [m], l [m] and ζ [rad] where they are given.
    bore : float, optional
        For the machine file. [m]
    speed : float, optional
        [rad/s]

    Returns
    -------
    Proposal
        With the numbers `knuckle_radius`, `articulation_angle`, `rod_length`, `stroke`, `top_shift`, `bottom_shift`,
        `top_distance`, `height_over_master`, `stroke_product`, and `compression_ratio` where one is wanted;
        alternatives: other solutions, the same requirements with other dimensions, others with the same r and l.

    Raises
    ------
    InputError
        If no knuckle can do it, with what is possible.

    Examples
    --------
    >>> from math import degrees, radians
    >>> given = {"knuckle_radius": 0.085, "rod_length": 0.235}
    >>> proposal = knuckle_from_requirements(0.09, 0.32, radians(60), stroke=0.1867, **given)
    >>> round(degrees(proposal.value("articulation_angle")), 2)
    66.63
    """
    requirements = KnuckleRequirements(stroke, unshifted, same_height, same_ratio)
    given: dict[Free, float | None] = {
        "articulation_angle": articulation_angle,
        "knuckle_radius": knuckle_radius,
        "rod_length": rod_length,
    }
    master = SliderCrank(single(crank_radius), single(master_rod_length), single(master_offset))
    refuse(_impossible(requirements, given, master, bank_angle, bore, speed))
    known: dict[Free, float] = {name: value for name, value in given.items() if value is not None}
    rods = _solutions(master, bank_angle, requirements, known)
    rod = rods[0]
    return Proposal(
        title=_("Articulated rod {angle} after its master", angle=number(bank_angle, "deg")),
        numbers=slave_numbers(rod, same_ratio),
        alternatives=(
            *(Alternative(_("another solution"), slave_numbers(one, same_ratio)) for one in rods[1:]),
            *_with_other_dimensions(rod, requirements, known),
            *_with_other_requirements(rod, same_ratio),
        ),
        remarks=tuple(_remarks(rod, requirements, known)),
        tables=_tables(rod, requirements, known, bore, speed),
    )


def _impossible(
    requirements: KnuckleRequirements,
    given: dict[Free, float | None],
    master: SliderCrank,
    bank_angle: float,
    bore: float | None,
    speed: float | None,
) -> Iterator[Problem]:
    """Find requirements that contradict themselves or geometry."""
    lengths = {
        "crank_radius": float(master.crank_radius),
        "stroke": requirements.stroke,
        "knuckle_radius": given["knuckle_radius"],
        "rod_length": given["rod_length"],
        "bore": bore,
    }
    yield from not_positive(lengths)
    yield from not_positive({"speed": speed}, plain)
    if not -2 * pi < bank_angle < 2 * pi:
        yield Problem("bank_angle", number(bank_angle, "deg"), _("must lie between -360 and 360 deg"))
    least = float(master.crank_radius + abs(master.offset))
    if not master.rod_length > least:
        allowed = _("must be more than {least}, or the crank cannot turn", least=as_limit(least))
        yield Problem("master_rod_length", as_limit(float(master.rod_length)), allowed)
    if requirements.same_ratio is not None and not requirements.same_ratio > 1:
        yield Problem("same_ratio", plain(requirements.same_ratio), _("must be more than 1"))
    yield from _count_problems(requirements, [name for name, value in given.items() if value is None])


def _count_problems(requirements: KnuckleRequirements, free: list[Free]) -> Iterator[Problem]:
    """Say what is missing or too much where requirements and free dimensions are not as many."""
    if requirements.decided == 0:
        allowed = _("is missing; ask for a stroke, an unshifted dead centre, the same_height or the same_ratio")
        yield Problem("stroke", None, allowed)
    elif requirements.decided != len(free):
        allowed = _(
            "each requirement decides one dimension; requirements: {requirements}, free dimensions: {free}",
            requirements=requirements.decided,
            free=len(free),
        )
        repair = _("give more of {names}", names=", ".join(free))
        if requirements.decided > len(free):
            repair = _("leave out more of {names}", names=", ".join(name for name in _FREE if name not in free))
        yield Problem("", None, allowed, repair)
    elif requirements.unshifted is not None and "articulation_angle" not in free:
        allowed = _("must be left out: an unshifted dead centre decides it")
        yield Problem("articulation_angle", None, allowed)
    elif requirements.decided - (requirements.unshifted is not None) == 3:
        allowed = _("must not stand beside stroke and same_ratio, which decide the height")
        yield Problem("same_height", None, allowed)


def _solutions(
    master: SliderCrank, bank_angle: float, requirements: KnuckleRequirements, known: dict[Free, float]
) -> tuple[ArticulatedRod, ...]:
    """Give all rods that meet the requirements; refuse requirements that none meets."""
    length = float(master.rod_length)
    knuckle = known.get("knuckle_radius", _KNUCKLE_SHARE * length)
    rod = ArticulatedRod(
        master,
        single(knuckle),
        single(known.get("articulation_angle", bank_angle)),
        single(bank_angle),
        single(known.get("rod_length", max(length - knuckle, _KNUCKLE_SHARE * length))),
        single(0.0),
    )
    decided: Collection[Free] = known if requirements.unshifted is None else {"articulation_angle", *known}
    free: tuple[Free, ...] = tuple(name for name in _FREE if name not in decided)
    search = searched(rod, requirements, free)
    if not search.rods:
        raise InputError([_unreachable(rod, requirements, search, free)])
    return search.rods


def _unreachable(
    rod: ArticulatedRod, requirements: KnuckleRequirements, search: Search, free: Sequence[Free]
) -> Problem:
    """Say what can be reached where a requirement cannot."""
    if not free:
        return Problem("rod_length", as_limit(float(rod.rod_length)), _("is too short: the slave cannot close"))
    names = ", ".join(free)
    if requirements.stroke is not None and search.least <= search.most:
        allowed = _(
            "must lie between {least} and {most}, all that {names} can give here",
            least=as_limit(search.least),
            most=as_limit(search.most),
            names=names,
        )
        return Problem("stroke", as_limit(requirements.stroke), allowed)
    path = (
        "same_height" if requirements.same_height else "same_ratio" if requirements.same_ratio is not None else "stroke"
    )
    allowed = _("cannot be met by {names} with what is given: every rod that would is one that does not close")
    return Problem(path, None, allowed.format(names=names))


def _with_other_dimensions(
    rod: ArticulatedRod, requirements: KnuckleRequirements, known: dict[Free, float]
) -> Iterator[Alternative]:
    """The same requirements met with each given dimension somewhat changed; those that cannot be had are left out."""
    for name, value in known.items():
        changed = [value + step for step in _STEPS] if name == "articulation_angle" else [value * by for by in _FACTORS]
        for other in changed:
            try:
                best = _solutions(rod.master, float(rod.bank_angle), requirements, {**known, name: other})[0]
            except InputError:
                continue
            label = _(
                "the same requirements with {symbol} = {value}",
                symbol=_SYMBOLS[name],
                value=number(other, _UNITS[name]),
            )
            yield Alternative(label, slave_numbers(best, requirements.same_ratio))


_SYMBOLS: dict[Free, str] = {"articulation_angle": "ζ", "knuckle_radius": "r", "rod_length": "l"}


def _with_other_requirements(rod: ArticulatedRod, ratio: float | None) -> tuple[Alternative, ...]:
    """The same r and l at the articulation angles that leave a dead centre unshifted, and at the bank angle."""
    angles = (
        (_("no shift of the top dead centre, the same r and l"), unshifted_angle(rod, "top")),
        (_("no shift of the bottom dead centre, the same r and l"), unshifted_angle(rod, "bottom")),
        (_("ζ = γ, the same r and l"), rod.bank_angle),
    )
    others = (
        (label, rod._replace(articulation_angle=angle)) for label, angle in angles if angle != rod.articulation_angle
    )
    return tuple(Alternative(label, slave_numbers(other, ratio)) for label, other in others if is_usable(other))


def _remarks(rod: ArticulatedRod, requirements: KnuckleRequirements, known: dict[Free, float]) -> Iterator[Words]:
    """Say in words what the requirements fix and what they do not."""
    product = number(float(stroke_product(rod)), "mm")
    if requirements.stroke is not None:
        yield _(
            "A stroke fixes little more than r(1 + r/l) sin(ζ − γ), here {product}; not r, l and ζ each. "
            "The alternatives with other dimensions have the same stroke.",
            product=product,
        )
    if requirements.stroke is not None or requirements.same_height or requirements.same_ratio is not None:
        yield _("Dimensions found in this way are fitted: they are no data of any engine.")
    if requirements.unshifted is not None:
        stays, moves = (_("top"), _("bottom")) if requirements.unshifted == "top" else (_("bottom"), _("top"))
        yield _(
            "The {stays} dead centre stays, so the {moves} one must shift, unless sin γ = 0; and {sum}.",
            stays=stays,
            moves=moves,
            sum="H = R + r + l" if requirements.unshifted == "top" else "h = r + l − R",
        )
    if not known:
        yield _("All three dimensions follow from the requirements; none was given.")


def _tables(
    rod: ArticulatedRod,
    requirements: KnuckleRequirements,
    known: dict[Free, float],
    bore: float | None,
    speed: float | None,
) -> tuple[ProposedTable, ...]:
    """Tables of the machine file: master, slave, cylinders."""
    master = rod.master
    how = _("to the wanted stroke, height or ratio")

    def written(name: Free) -> Words:
        value = float(getattr(rod, name))
        if name in known:
            return wanted(value, _UNITS[name])
        if name == "articulation_angle" and requirements.unshifted is not None:
            return found(value, "deg", _("no shift of the dead centre: {which}", which=requirements.unshifted))
        return found(value, _UNITS[name], how, "fitted")

    master_keys = {
        "kind": '"slider_crank"',
        "crank_radius": wanted(float(master.crank_radius), "mm"),
        "rod_length": wanted(float(master.rod_length), "mm"),
    }
    if master.offset:
        master_keys["offset"] = wanted(float(master.offset), "mm")
    return (
        *shaft_table(speed),
        ProposedTable("bank.M.mechanism", master_keys),
        ProposedTable("bank.S", {"angle": quoted(quantity_text(float(rod.bank_angle), "deg"))}),
        ProposedTable(
            "bank.S.mechanism",
            {
                "kind": '"articulated_rod"',
                "master": '"M"',
                "knuckle_radius": written("knuckle_radius"),
                "rod_length": written("rod_length"),
                "articulation_angle": written("articulation_angle"),
            },
        ),
        *cylinder_table(requirements.same_ratio, bore),
    )
