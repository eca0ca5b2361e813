"""Gearing of shafts: where each stands at crank angle 0, by a phase of its own or by the lead of opposed pistons."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import Words, _
from cranktrain.layout.specs import MAIN, BankSpec, ShaftSpec, throws_of
from cranktrain.motion import ZERO, Array
from cranktrain.numerics import around_zero
from cranktrain.saying.wording import precise, shared

_CLOSED = 1e-9
"""A ring of shafts that closes to less than this is closed: phases are sums of a few angles. [rad]"""

_ALIKE = np.radians(0.02)
"""Throws of seven cylinders are written as 51.43°: leads that differ by less are one. [rad]"""


class _Crank(NamedTuple):
    """The crank of a bank's first cylinder: its shaft, that shaft's sense, and where it stands from its axis. [rad]"""

    shaft: str
    sense: float
    ahead: Array


class _Pair(NamedTuple):
    """A bank of opposed pistons as a tie between two shafts: the exhaust crank is ahead by the lead. [rad]

    And what the file gives for the lead.
    """

    bank: str
    exhaust: _Crank
    scavenge: _Crank
    lead: Array
    given: str


def opposed_angle(bank: BankSpec, end: str) -> Array:
    """Direction from the shaft of one of two opposed pistons to their cylinder, from Y in the file's sense. [rad]"""
    faces = end == "scavenge" and len(set(bank.shafts)) == 2
    return bank.angle[0].array + (np.pi if faces else 0.0)


def first_axis(banks: Mapping[str, BankSpec]) -> Array:
    """Direction from which the crank angle counts, from Y in the normal sense of rotation. [rad]

    It is the first bank's; of opposed pistons that of the one that works on the main shaft, or else the exhaust's.
    """
    bank = next(iter(banks.values()))
    on_main = (opposed_angle(bank, end) for end, side in bank.sides.items() if side.shaft == MAIN)
    return next(on_main, bank.angle[0].array)


def shaft_phases(
    shafts: Mapping[str, ShaftSpec], banks: Mapping[str, BankSpec]
) -> tuple[dict[str, Array], tuple[Problem, ...]]:
    """Find how far throw 1 of every shaft stands ahead of throw 1 of `main` when the crank angle is 0.

    Parameters
    ----------
    shafts : mapping of name to ShaftSpec
    banks : mapping of name to BankSpec
        On shafts and throws that there are.

    Returns
    -------
    phases : dict of Array
        In the normal sense of rotation. [rad]
    problems : tuple of Problem
        Leads that do not close round the shafts.

    Notes
    -----
    α_e − α_s = Δ, where a crank's angle from its cylinder's axis, in its own sense, is α = ±(phase + throw − axis), all
    from where throw 1 of `main` stands, along the first axis:
    docs/theory/opposed-pistons, eq. (18.8). Three shafts in a triangle close only if 3Δ + 60°·Σ(±1) ≡ 0.
    """
    first = first_axis(banks)
    pairs = [
        _Pair(
            name,
            _crank(shafts, bank, "exhaust", first),
            _crank(shafts, bank, "scavenge", first),
            bank.lead.array,
            bank.lead.text,
        )
        for name, bank in banks.items()
        if bank.lead is not None
    ]
    given = {name: shaft.phase.array for name, shaft in shafts.items() if shaft.phase is not None}
    phases, excess = _propagated(tuple(shafts), {MAIN: ZERO, **given}, pairs)
    return phases, tuple(
        Problem(f"bank.{pair.bank}.lead", pair.given, _allowed(shafts, given, pairs, pair, over))
        for pair, over in excess
        if np.any(np.abs(over) > _CLOSED)
    )


def _crank(shafts: Mapping[str, ShaftSpec], bank: BankSpec, end: str, first: Array) -> _Crank:
    """Find the crank of the first cylinder's exhaust or scavenge piston."""
    piston = bank.opposed[end]
    shaft = shafts[piston.shaft]
    throw = shaft.throws[throws_of(piston, shafts)[0] - 1].array - shaft.throws[0].array
    return _Crank(piston.shaft, float(shaft.ratio), first + throw - opposed_angle(bank, end))


def _propagated(
    shafts: tuple[str, ...], known: Mapping[str, Array], pairs: list[_Pair]
) -> tuple[dict[str, Array], list[tuple[_Pair, Array]]]:
    """Go from shaft to shaft along the pairs; a pair between shafts that stand already leaves an excess of lead."""
    phases = dict(known)
    rest = list(pairs)
    excess: list[tuple[_Pair, Array]] = []

    def angle(crank: _Crank) -> Array:
        """Of a crank on a shaft that stands, from its cylinder's axis, in its own sense. [rad]"""
        return crank.sense * (phases[crank.shaft] + crank.ahead)

    while rest:
        reached = next((pair for pair in rest if {pair.exhaust.shaft, pair.scavenge.shaft} & phases.keys()), None)
        if reached is None:
            # Shafts that nothing ties to `main`: one of them stands as if it were it.
            phases[rest[0].exhaust.shaft] = ZERO
            continue
        rest.remove(reached)
        exhaust, scavenge, lead = reached.exhaust, reached.scavenge, reached.lead
        if {exhaust.shaft, scavenge.shaft} <= phases.keys():
            excess.append((reached, around_zero(lead - (angle(exhaust) - angle(scavenge)))))
            continue
        standing, other, ahead = (exhaust, scavenge, -lead) if exhaust.shaft in phases else (scavenge, exhaust, lead)
        phases[other.shaft] = around_zero(other.sense * (angle(standing) + ahead) - other.ahead)
    return {name: phases.get(name, ZERO) for name in shafts}, excess


def _allowed(
    shafts: Mapping[str, ShaftSpec], given: Mapping[str, Array], pairs: list[_Pair], pair: _Pair, excess: Array
) -> Words:
    """Say which lead would close the ring of shafts: here alone, or everywhere where all leads are alike."""
    here = precise(float(around_zero(pair.lead - excess)), "deg")
    allowed = _("must be {lead}, as the other phases and leads already place both of its shafts", lead=here)
    step = 1e-3
    moved = [one._replace(lead=one.lead + step) for one in pairs]
    shifted = dict(_propagated(tuple(shafts), {MAIN: ZERO, **given}, moved)[1])[pair._replace(lead=pair.lead + step)]
    turns = round(float(around_zero(shifted - excess)) / step)
    if turns < 2 or len({float(one.lead) for one in pairs}) > 1:
        return allowed
    everywhere = precise(float(around_zero(pair.lead - excess / turns)), "deg")
    return _(
        "{allowed}; or {lead} for each of the {n} banks round these shafts", allowed=allowed, lead=everywhere, n=turns
    )


def lead_problems(shafts: Mapping[str, ShaftSpec], banks: Mapping[str, BankSpec]) -> Iterator[Problem]:
    """Find leads that only the first cylinder of a bank has.

    Parameters
    ----------
    shafts : mapping of name to ShaftSpec
        Whose phases give the first cylinder of every bank its lead.
    banks : mapping of name to BankSpec
        On shafts and throws that there are.

    Yields
    ------
    Problem
        With every cylinder's lead, and what would give all of them the one that is declared.

    Notes
    -----
    Δ_i = Δ + r_e (θ_e,i − θ_e,1) − r_s (θ_s,i − θ_s,1): docs/theory/opposed-pistons, eq. (18.8) of two cylinders.
    """
    for name, bank in banks.items():
        if bank.lead is None:
            continue
        exhaust, scavenge = (_turned(shafts, bank, end) for end in ("exhaust", "scavenge"))
        more = around_zero(exhaust - scavenge)
        if np.any(np.abs(more) > _ALIKE):
            cylinders = [str(i) for i in range(1, more.size + 1)]
            allowed = _(
                "is that of its first cylinder alone: as the throws stand, the leads are {leads}",
                leads=shared(cylinders, around_zero(bank.lead.si + more), "deg"),
            )
            yield Problem(f"bank.{name}.lead", bank.lead.text, allowed, _repair(shafts, bank))


def _turned(shafts: Mapping[str, ShaftSpec], bank: BankSpec, end: str) -> Array:
    """How far the crank of each cylinder's piston stands ahead of the first one's, in its own sense. [rad]"""
    shaft = shafts[bank.opposed[end].shaft]
    throws = np.array([shaft.throws[throw - 1].si for throw in throws_of(bank.opposed[end], shafts)])
    return shaft.ratio * (throws - throws[0])


def _repair(shafts: Mapping[str, ShaftSpec], bank: BankSpec) -> Words:
    """Say which throws of the shaft that is not the main one give all cylinders one lead, or which ratio does."""
    end, other = ("exhaust", "scavenge") if bank.opposed["scavenge"].shaft == MAIN else ("scavenge", "exhaust")
    name = bank.opposed[end].shaft
    shaft, wanted = shafts[name], _turned(shafts, bank, other)
    angles: Array = np.array([throw.si for throw in shaft.throws])
    own = [throw - 1 for throw in throws_of(bank.opposed[end], shafts)]
    angles[own] = np.mod(np.round(angles[own[:1]] + shaft.ratio * wanted, 12), 2 * np.pi)
    listed = ", ".join(f'"{precise(angle, "deg")}"' for angle in angles.tolist())
    repair = _("all have it with shaft.{name}.throws = [{angles}]", name=name, angles=listed)
    if np.all(np.abs(around_zero(wanted + _turned(shafts, bank, end))) <= _ALIKE):
        repair = _("{repair}, or with shaft.{name}.ratio = {ratio}", repair=repair, name=name, ratio=-shaft.ratio)
    return repair
