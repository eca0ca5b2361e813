"""Where counterweights may stand on a crankshaft, how heavy they may be there, and what would be a full one."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from cranktrain.analysis import run
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.layout.shafts import throw_positions
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.numerics.ties import first_smallest
from cranktrain.quantities import unlisted
from cranktrain.questions.balance.spec import WeightSpec
from cranktrain.questions.balance.weights import BalanceWeights
from cranktrain.questions.crankshaft.shaft_layout import ShaftLayout
from cranktrain.saying.wording import all_of

_SOLVED_FOR = ("counterweights", "share", "planes")
"""Keys of [balance] that say which counterweights are solved for."""


class WeightPlace(NamedTuple):
    """Where a counterweight may stand.

    Attributes
    ----------
    throw : int
        Counted from 1.
    z : float or None
        Of the web that carries it; None where both webs of the throw do. [m]
    opposite : float
        Where it stands at crank angle 0 of throw 1, ahead of throw 1, if it stands opposite its throw. [rad]
    crank_radius : float
        [m]
    full : float
        Mass times radius of what takes away all that rotates there, webs that the file has as weights too. [kg·m]
    there : float
        That of the counterweights that it has. [kg·m]
    """

    throw: int
    z: float | None
    opposite: float
    crank_radius: float
    full: float
    there: float


class OnThrow(NamedTuple):
    """A weight of the file on a throw, from 0: its mass times radius on that's side, less than 0 opposite. [kg·m]"""

    throw: int
    moment: float


class Kept(NamedTuple):
    """What of [balance] stays: its tables, its weights on the crankshaft's throws; and paths of what is taken out."""

    table: Mapping[str, Any]
    weights: tuple[OnThrow, ...]
    taken_out: tuple[str, ...]


def kept_balance(machine: Machine, *, afresh: bool) -> Kept:
    """What stays of the file's [balance]: afresh all but its counterweights, given or solved for."""
    declared: Mapping[str, Any] = machine.declared.get("balance") or {}
    every = [_on_throw(weight, machine) for weight in (() if machine.balance is None else machine.balance.weight)]
    stays = [one is None or not afresh or one.moment > 0 for one in every]
    solved_for = tuple(key for key in _SOLVED_FOR if key in declared) if afresh else ()
    table = {key: value for key, value in declared.items() if key not in (*solved_for, "weight")}
    weights = tuple(one for one, stay in zip(declared.get("weight", ()), stays, strict=True) if stay)
    return Kept(
        {**table, "weight": weights} if weights else table,
        tuple(one for one, stay in zip(every, stays, strict=True) if one is not None and stay),
        (
            *(f"balance.{key}" for key in solved_for),
            *(f"balance.weight[{i}]" for i, stay in enumerate(stays) if not stay),
        ),
    )


def throw_places(machine: Machine, layout: ShaftLayout, kept: Kept) -> list[WeightPlace]:
    """A place on each throw of the crankshaft, whose webs carry alike."""
    directions, radius = _directions(machine), layout.shaft.pieces.radius[0, layout.pins]
    full, there = full_moments(machine), np.zeros(directions.size)
    for throw, moment in kept.weights:
        full[throw] += max(moment, 0.0)
        there[throw] += max(-moment, 0.0)
    first = [int(np.flatnonzero(layout.declared.throw == n)[0]) for n in range(len(directions))]
    return [
        WeightPlace(n + 1, None, float(directions[n] + np.pi), float(radius[pin]), float(full[n]), float(there[n]))
        for n, pin in enumerate(first)
    ]


def web_places(of_throws: Sequence[WeightPlace], layout: ShaftLayout) -> list[WeightPlace]:
    """A place on each web of the crankshaft, along the shaft; each is half as heavy as on a throw of two."""
    found: dict[int, WeightPlace] = {}
    for pin, webs in enumerate(layout.webs):
        place = of_throws[int(layout.declared.throw[pin])]
        own = [side for side in (0, 1) if webs[side] >= 0]
        for side in own:
            z = float(layout.declared.planes[0, pin, side])
            found.setdefault(
                int(webs[side]), place._replace(z=z, full=place.full / len(own), there=place.there / len(own))
            )
    return [found[web] for web in sorted(found)]


def full_moments(machine: Machine) -> Array:
    """What takes away all that rotates of the mechanisms on each throw of the crankshaft. [kg·m]"""
    solved = run(machine.with_({"balance": {"counterweights": "rotating"}}), quantities="balance_weight_moment")
    weights = solved.get(BalanceWeights)
    if weights is None:
        needs = all_of(solved.needs_of("balance_weight_moment"))
        raise InputError([Problem("", None, _("what rotates is not known without {needs} in the file", needs=needs))])
    names = solved.labels["weight"]
    directions = _directions(machine)
    full = np.zeros(directions.size)
    for n, direction in enumerate(directions):
        name = f"throw_{n + 1}"
        if name in names:
            own = names.index(name)
            ahead = weights.balance_weight_angle[0, own] - direction - np.pi
            full[n] = np.nan_to_num(weights.balance_weight_moment[0, own] * np.cos(ahead))
    return full


def chosen_throws(text: str | None, n_throws: int) -> tuple[list[int], list[Problem]]:
    """Read which throws may have weights, counted from 1: `1,4`; all unless given."""
    if text is None or text.strip().casefold() == "all":
        return list(range(1, n_throws + 1)), []
    known = [str(n) for n in range(1, n_throws + 1)]
    named = [word.strip() for word in text.split(",")]
    problems = [unlisted("throws", word, known) for word in named if word not in known]
    return [n for n in range(1, n_throws + 1) if str(n) in named], problems


def alike_places(places: Sequence[WeightPlace], alike: str, n_throws: int) -> Iterator[list[int]]:
    """Groups of places that have one weight's numbers: all, those as far from both ends, or each alone."""
    if alike == "alike":
        yield list(range(len(places)))
        return
    if alike != "mirrored":
        yield from ([i] for i in range(len(places)))
        return
    throws = [place.throw for place in places]
    for i, throw in enumerate(throws):
        other = n_throws + 1 - throw
        if other not in throws or throw == other:
            yield [i]
        elif throw < other:
            yield [i, throws.index(other)]


def _directions(machine: Machine) -> Array:
    """Angles of the throws ahead of throw 1. [rad]"""
    angles = [throw.si for throw in machine.main_shaft.throws]
    return np.array(angles) - angles[0]


def _on_throw(weight: WeightSpec, machine: Machine) -> OnThrow | None:
    """The throw on which a weight turns, or the nearest; None of one on a shaft of its own."""
    directions, positions = _directions(machine), throw_positions(machine.main_shaft)
    if weight.throw is not None:
        throw = weight.throw - 1
    elif weight.z is None or positions is None or weight.ratio != 1 or any(spot.si for spot in weight.place):
        return None
    else:
        throw = first_smallest([abs(float(position) - weight.z.si) for position in positions])
    side = -1.0 if weight.angle is None else float(np.cos(weight.angle.si - directions[throw]))
    return OnThrow(throw, float(weight.moment) * side)
