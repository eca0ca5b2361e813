"""What the text on support reactions states of a throw: fig. 35, (44) to (53), beside the shaft split at bearings."""

import tomllib
from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

import numpy as np

from cranktrain.errors import Problem, problems_as, refuse
from cranktrain.io.any_machine import MachineLike, source_of
from cranktrain.io.own_tables import own_table
from cranktrain.io.syntax import parsed
from cranktrain.language import N_, Listed, Words, _
from cranktrain.motion import Array
from cranktrain.plans.machine_throw import MachineThrow, ThrownMachine
from cranktrain.plans.throw_loads import CrankMasses
from cranktrain.questions.crankshaft.methods.throw_reactions import (
    ThrowForces,
    ThrowReactions,
    throw_constituents,
    throw_length,
    throw_reactions,
)
from cranktrain.saying.wording import number
from cranktrain.textbook.asked_angle import asked_angle
from cranktrain.textbook.statements import Statement, StatementCurve, Statements, Verdict
from cranktrain.texts.example_tables import example_table
from cranktrain.texts.throw_conditions import BalanceConditions, balance_conditions
from cranktrain.texts.throw_table import CHAIN, Throw, read_throw, symbol_of

SOURCE = "crankshaft-reactions"
REACTIONS = {"kp": "R_KP", "tp": "R_TP", "kl": "R_KL", "tl": "R_TL"}
"""Loads of the journals on the bearings P and L by their letters: K inward, T with the rotation."""

TOGETHER = N_("together")
_ROUNDING = 1e-12


class _Constituent(NamedTuple):
    """A row of formulas: its name, and the number of each reaction; none of one that it does not have."""

    name: str
    numbers: Mapping[str, str]


_CONSTITUENTS: Mapping[str, _Constituent] = {
    "rotating": _Constituent(N_("rotating masses"), {"kp": "(44)", "tp": "(45)", "kl": "(46)", "tl": "(47)"}),
    "first": _Constituent(N_("left external counterweight"), dict.fromkeys(REACTIONS, "(48)")),
    "last": _Constituent(N_("right external counterweight"), dict.fromkeys(REACTIONS, "(49)")),
    "normal": _Constituent(N_("K of the rods"), {"kp": "(50)", "kl": "(52)"}),
    "tangential": _Constituent(N_("T of the rods"), {"tp": "(51)", "tl": "(53)"}),
}


def throw(
    machine: "MachineLike | None" = None,
    throw_number: str | int | None = None,
    at: float | None = None,
    *,
    set: "Mapping[str, object] | None" = None,  # noqa: A002 - as the terminal's --set
    crank_masses: CrankMasses = "given",
) -> Statements:
    """Give fig. 35 and (44) to (53) of [crankshaft-reactions] for a throw of an engine, beside its split shaft.

    Parameters
    ----------
    machine : str, path-like, dict or Machine, optional
        As `cranktrain.run` takes it, with [crankshaft], or a file with a throw's table; the text's own example unless
        given.
    throw_number : int or str, optional
        Of the throw; with several shafts below the shaft's name: `main.3`. The first unless given.
    at : float, optional
        Crank angle as the machine shows it; where the largest load of both bearings is unless given. [deg]
    set : mapping of str, optional
        Other values by path; of the text's own example by its symbols.
    crank_masses : "given" or "sizes"
        Whether C2, C4 and C6 are what [masses.crank] says, as in `run`, or what pins and webs of [crankshaft] weigh.

    Returns
    -------
    Statements
        Reactions with the constituents of the text, loads for which it has no letter, and as `exact` those of the shaft
        split at its bearings; curves over the cycle.

    Raises
    ------
    InputError
        With everything that is wrong; where the throw is none of which the text speaks.

    Examples
    --------
    >>> found = throw("3d12", 3, 420)
    >>> for one in found.numbered("(50)"):
    ...     print(one.symbol, one.name, round(one.value, 1), one.unit)
    R_KP K of the rods ... N
    """
    values = {} if set is None else dict(set)
    angle, table = None if at is None else asked_angle(at), own_table(machine)
    if machine is None or table is not None:
        asked = {
            "throw_number": throw_number,
            "at": at,
            "crank_masses": None if crank_masses == "given" else crank_masses,
        }
        allowed = _("is for the throw of a machine: name it")
        refuse(Problem(name, str(value), allowed) for name, value in asked.items() if value is not None)
        data = tomllib.loads(example_table("throw")) if table is None else parsed(table.text, table.name)
        with problems_as(lambda one: one if table is None or one.path in values else table.located(one)):
            return throw_statements(read_throw({**data, **values}))
    given = source_of(machine, values)
    with problems_as(given.placed):
        thrown = ThrownMachine(given.machine)
        name = next(iter(thrown.throws)) if throw_number is None else str(throw_number)
        return machine_statements(thrown, name, angle, crank_masses)


def throw_statements(of: Throw) -> Statements:
    """Give fig. 35 and (44) to (53) for a throw's own table."""
    title = _("Reactions of the supports of a throw, (44) to (53) [{source}]", source=SOURCE)
    each = [*_lengths(of, ""), *_forces(of, "", np.nan), *_reactions(of, _All(), "", np.nan), *_conditions(of, "")]
    return Statements(title, tuple(each), np.zeros(0), sentences=_notes(of, ()))


class _All(NamedTuple):
    """Of a throw's own table: both external counterweights count, and no shaft stands beside."""

    is_first: bool = True
    is_last: bool = True
    beyond: tuple[()] = ()
    exact: None = None


def machine_statements(of: ThrownMachine, name: str, at: float | None, masses: CrankMasses) -> Statements:
    """Give them for a throw of a machine, at one crank angle and over the cycle. [deg]"""
    over = of.throw(name, of.crank_angle, masses)
    at = of.usual_angle(over) if at is None else at
    one = of.throw(name, np.array([at]), masses)
    each = [
        *_lengths(one.throw, name),
        *_forces(one.throw, name, at),
        *_reactions(one.throw, one, name, at),
        *_conditions(one.throw, name),
    ]
    title = _(
        "Throw {name} of {machine} at {at}°, bearings {left} (L) and {right} (P) [{source}]",
        name=name,
        machine=of.machine.name,
        at=f"{at:g}".replace("-", "−"),
        left=one.bearings[0],
        right=one.bearings[1],
        source=SOURCE,
    )
    return Statements(
        title, tuple(each), of.crank_angle, tuple(_curves(over)), _notes(one.throw, _of_machine(one, masses))
    )


def _lengths(of: Throw, name: str) -> Iterator[Statement]:
    """Lengths of the figure, and the sum of the chain."""
    for field, size in of.lengths._asdict().items():
        yield _statement("fig. 35", symbol_of(field), _("length"), name, size, "m")
    yield _statement("fig. 35", "l", _("distance of the supports"), name, throw_length(of.lengths), "m")


def _forces(of: Throw, name: str, at: float) -> Iterator[Statement]:
    """Forces of the figure."""
    words = {"c": _("inertia"), "k": _("rod, inward"), "t": _("rod, with the rotation")}
    for field, size in of.forces._asdict().items():
        yield _statement("fig. 35", symbol_of(field), words[field[0]], name, size, "N", at)


def _statement(
    equation: str, symbol: str, words: Words, name: str, value: Array, unit: str, at: float = np.nan
) -> Statement:
    """A number that is right."""
    size = float(np.ravel(value)[0])
    return Statement(SOURCE, equation, symbol, words, name, "at", size, unit, "right", size, at)


def _reactions(of: Throw, one: MachineThrow | _All, name: str, at: float) -> Iterator[Statement]:
    """Each constituent, all together, what has no letter, and resultants."""
    found = throw_constituents(of.lengths, of.forces)
    for part, constituent in _CONSTITUENTS.items():
        if (part != "first" or one.is_first) and (part != "last" or one.is_last):
            for side, equation in constituent.numbers.items():
                value = getattr(getattr(found, part), side)
                yield _statement(equation, REACTIONS[side], _(constituent.name), name, value, "N", at)
    whole = throw_reactions(found, is_first=one.is_first, is_last=one.is_last)
    yield from _together(whole, one, name, at)
    for load in one.beyond:
        for side, symbol in REACTIONS.items():
            value = float(np.ravel(getattr(load.share, side))[0])
            yield Statement(SOURCE, "", symbol, load.name, name, "at", value, "N", "beyond", value, at)


def _together(whole: ThrowReactions, one: MachineThrow | _All, name: str, at: float) -> Iterator[Statement]:
    """The sums by the text, beside those of the split shaft, and the resultants."""
    exact = whole if one.exact is None else one.exact
    scale = max(float(np.max(np.abs(part))) for part in exact)
    off = max(float(np.max(np.abs(own - true))) for own, true in zip(whole, exact, strict=True))
    verdict: Verdict = "right" if off <= _ROUNDING * scale else "approximate"
    for side, symbol in REACTIONS.items():
        numbers = _numbers(side, one)
        values = (float(np.ravel(getattr(every, side))[0]) for every in (whole, exact))
        own, true = values
        yield Statement(SOURCE, numbers, symbol, _(TOGETHER), name, "at", own, "N", verdict, true, at)
    for side, symbol in (("p", "R_P"), ("l", "R_L")):
        own, true = (
            float(np.ravel(np.hypot(getattr(every, f"k{side}"), getattr(every, f"t{side}")))[0])
            for every in (whole, exact)
        )
        yield Statement(SOURCE, "", symbol, _("resultant"), name, "at", own, "N", verdict, true, at)


def _numbers(side: str, one: MachineThrow | _All) -> str:
    """The formulas whose sum a reaction is."""
    counted = {"first": one.is_first, "last": one.is_last}
    each = (own.numbers.get(side) for part, own in _CONSTITUENTS.items() if counted.get(part, True))
    return " ".join(numbered for numbered in each if numbered)


def _conditions(of: Throw, name: str) -> Iterator[Statement]:
    """What is left over of both conditions of a throw without reactions."""
    first = Throw(of.lengths, ThrowForces(*(np.ravel(force)[0] for force in of.forces)))
    words = {"static": (_("static, ΣC = 0"), "N"), "dynamic": (_("dynamic, ΣCz = 0 about L"), "N*m")}
    for one in balance_conditions(first.lengths, first.forces):
        said, unit = words[one.name]
        for at, value in (("outward", one.outward), ("against the rotation", one.against)):
            left = 0.0 if one.holds else value
            yield Statement(
                SOURCE, "after (53)", "ΣC" if unit == "N" else "ΣCz", said, name, at, left, unit, "right", left
            )


def _curves(over: MachineThrow) -> Iterator[StatementCurve]:
    """Reactions over the cycle by the text, beside the split shaft."""
    whole = over.by_text
    verdict: Verdict = "approximate" if over.beyond else "right"
    for side, symbol in REACTIONS.items():
        numbers = _numbers(side, over)
        own, exact = (np.broadcast_to(getattr(every, side), over.exact.kp.shape) for every in (whole, over.exact))
        yield StatementCurve(SOURCE, numbers, symbol, _(TOGETHER), over.name, "N", verdict, own, exact)


def _of_machine(one: MachineThrow, masses: CrankMasses) -> Iterator[Words]:
    """Say whose rods are on the pin, and of whose masses C2, C4 and C6 are."""
    forces = [Listed((f"K{i}, T{i}", names), ": ") for i, names in enumerate(one.rods, 1)]
    yield _("Rods on the pin: {rods}", rods=Listed(forces, "; "))
    if masses == "sizes":
        yield _("C2, C4, C6 are what pins and webs of [crankshaft] weigh; in `run` a crank is what [masses.crank] says")
    elif one.has_mass:
        yield _(
            "C2 and C6 are half of [masses.crank] each, its pin with them, and C4 is 0; --crank-masses sizes parts them"
        )
    else:
        yield _(
            "C2, C4, C6 are 0: cranks have no mass without [masses.crank]; --crank-masses sizes weighs [crankshaft]"
        )


def _notes(of: Throw, more: Iterable[Words]) -> dict[Words, tuple[Words, ...]]:
    """Sentences on the throw, on its balance, and what is to be minded."""
    rods = {
        "one": _("Rods at one place of the pin, K1 and T1."),
        "two": _("Two rods side by side, K1, T1 and K2, T2."),
        "articulated": _("An articulated pair: one resultant K1, T1 on the master's axis, K2 = T2 = 0."),
    }
    chain = Listed((f"l = {' + '.join(CHAIN)}", number(float(throw_length(of.lengths)), "mm")), " = ")
    first = ThrowForces(*(np.ravel(force)[0] for force in of.forces))
    conditions = balance_conditions(of.lengths, first)
    return {
        _("The throw"): (chain, rods[of.rods], *more),
        _("Whether the rotating masses, C1 to C15, load the bearings"): (_said_of(conditions),),
        _("Mind"): (
            _(
                "C8, C9, C12, C14, C15 count against the rotation: the text is silent, but only so may (45) be added "
                "to (51)"
            ),
            _("C3 and C5 hold what turns of the rods: K1 and K2 must not hold it again"),
            _("where external counterweights are moments at the ends of a continuous shaft, (48) and (49) count twice"),
            _("`cranktrain textbook errata --source crankshaft`: what is wrong in the text and left open by it"),
        ),
    }


def _said_of(found: BalanceConditions) -> Words:
    """Say what follows from both conditions."""
    if found.hold:
        return _("Both hold: the rotating masses load no bearing.")
    if found.static.holds:
        return _(
            "Static balance alone: the forces are equal and opposite, but a couple is left, and loads both bearings "
            "alike, in opposite directions."
        )
    if found.dynamic.holds:
        return _("The resultant passes through L: it alone bears it.")
    return _("Neither holds: (44) to (49) say what the bearings bear.")
