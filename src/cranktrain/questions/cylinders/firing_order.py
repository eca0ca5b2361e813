"""The firing that a file gives, by order or by angles: put to cylinders, held against where the crank pins stand."""

import itertools
import re
from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import Problem, UnreadError
from cranktrain.language import Listed, Words, _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Array
from cranktrain.numerics.designs import by_design
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.ties import smallest_of
from cranktrain.quantities import Given
from cranktrain.questions.cylinders.firing import FiringOrder, firing_angles, within_turn
from cranktrain.questions.cylinders.possible_orders import likest_orders
from cranktrain.questions.cylinders.spec import CylindersSpec
from cranktrain.record import record
from cranktrain.saying.wording import either_of, number

_WRITTEN = np.radians(0.02)
"""An angle may be written to so many digits: 51.43 for 360/7. It says which turn; the crank pins say the rest. [rad]"""
_PATH = "cylinder.firing_angles"


@record
class _Asked:
    """An order as it is asked for: the table that has it, each cylinder by its leading piston, the sense of running."""

    common: CylindersSpec
    leading: Sequence[PlacedMechanism]
    astern: bool

    def repair(self, order: Sequence[str]) -> Words | None:
        """Give the most even orders that the crank pins allow, as the file writes them; `order` is ahead."""
        length = self.common.cycle_length
        names = [place.cylinder for place in self.leading]
        divided = self._divided(names)
        if len(order) == 1 and divided is not None:
            return _("write {orders}", orders=f'"{divided}"')
        if length is None or 2 * sum(name in names for name in order) < len(order):
            return None
        running = _backwards(order) if self.astern else order
        wanted = [names.index(name) if name in names else -1 for name in running]
        found = [[names[i] for i in one] for one in likest_orders(_tops(self.leading), length, wanted)]
        ahead = list(map(_backwards, found)) if self.astern else found
        said = [f'"{"-".join(self.common.makers_numbers(one) or one)}"' for one in ahead]
        return _("write {orders}", orders=either_of(said)) if said else None

    def _divided(self, names: Sequence[str]) -> str | None:
        """Write with hyphens an order that has none, but dots or nothing between; None for another."""
        text = self.common.firing_order or ""
        ways = (re.findall(r"\w+", text), re.findall(r"\w", text))
        return next(("-".join(words) for words in ways if sorted(words) == sorted(names)), None)


def firing_order_of(
    common: CylindersSpec, leading: Sequence[PlacedMechanism], *, zero: Array, astern: bool
) -> tuple[FiringOrder | None, tuple[Problem, ...]]:
    """Read the firing order of cylinders, each by its leading piston, or their firing angles; None without either.

    zero is φ where the shown crank angle is 0 [rad]. Running astern the order is read backwards from the same cylinder.
    Whether the crank pins allow it can be told where the cycle is known, too.
    """
    names = [place.cylinder for place in leading]
    problems = tuple(_number_problems(common, names))
    given = common.firing_angles is not None and not problems
    if given and (length := common.cycle_length) is not None:
        return given_firing(common, leading, length, zero=zero, astern=astern)
    if common.firing_order is None or problems:
        own = _own_order(common, leading) if not problems else None
        return own, problems
    order = [common.numbers.get(word, word) for word in re.split(r"[\s,–-]+", common.firing_order.strip()) if word]
    asked = _Asked(common, leading, astern)
    problems = _order_problems(asked, order, names)
    if problems:
        return None, problems
    if astern:
        order = _backwards(order)
    index = [names.index(name) for name in order]
    problems = _throw_problems(asked, order, _tops([leading[i] for i in index]))
    found = FiringOrder(np.array(index, dtype=np.intp), common.makers_numbers(order))
    return (None if problems else found), problems


def _backwards(order: Sequence[str]) -> list[str]:
    """Read an order backwards from the same cylinder."""
    return [*order[:1], *order[:0:-1]]


def _own_order(common: CylindersSpec, leading: Sequence[PlacedMechanism]) -> FiringOrder | None:
    """Order in which cylinders fire that have no choice: one alone, and those of a two-stroke as their cranks come."""
    if not leading or (len(leading) > 1 and common.cycle != "two-stroke"):
        return None
    return order_of_cranks(leading)


def order_of_cranks(leading: Sequence[PlacedMechanism]) -> FiringOrder:
    """Order in which cylinders fire of which each does once a turn: as their cranks come."""
    return FiringOrder(np.argsort(_tops(leading), kind="stable"))


def _tops(leading: Sequence[PlacedMechanism]) -> Array:
    """Where in a turn each piston is nominally at its top, in the first design, shape (cylinder,). [rad]"""
    return within_turn(np.array([np.ravel(place.nominal_top)[0] for place in leading]))


def _number_problems(common: CylindersSpec, names: Sequence[str]) -> Iterator[Problem]:
    """Find a maker's numbers for no cylinder, or two for one."""
    numbered: dict[str, str] = {}
    for word, name in common.numbers.items():
        first = numbered.setdefault(name, word)
        if name not in names:
            allowed = _("must be a cylinder of this machine: {cylinders}", cylinders=", ".join(names))
            yield Problem(f"cylinder.numbers.{word}", name, allowed)
        elif first != word:
            allowed = _("must be another cylinder: this one is number {number}", number=first)
            yield Problem(f"cylinder.numbers.{word}", name, allowed)


def _order_problems(asked: _Asked, order: Sequence[str], names: Sequence[str]) -> tuple[Problem, ...]:
    """Find cylinders that the order does not name once."""
    unknown = [name for name in order if name not in names]
    twice = sorted({name for name in order if order.count(name) > 1})
    left_out = [name for name in names if name not in order]
    wrong = [
        text.format(names=", ".join(those))
        for text, those in (
            (_("unknown: {names}"), unknown),
            (_("twice: {names}"), twice),
            (_("left out: {names}"), left_out),
        )
        if those
    ]
    if not wrong:
        return ()
    if len(names) == 1 and sorted(order) == [str(i + 1) for i in range(len(order))]:
        return (_missing_throws(asked, order),)
    allowed = _(
        "must name each cylinder once ({cylinders}); {wrong}", cylinders=", ".join(names), wrong=Listed(wrong, "; ")
    )
    return (Problem("cylinder.firing_order", asked.common.firing_order, allowed, _likely(asked, order, names)),)


def _likely(asked: _Asked, order: Sequence[str], names: Sequence[str]) -> Words | None:
    """Say what is likely meant; nothing where that cannot be told of what can be read."""
    try:
        if not asked.common.numbers and _are_makers_numbers(order, names):
            return numbers_line(order, asked.leading, _tops(asked.leading), asked.common.cycle_length)
        return asked.repair(order)
    except UnreadError:
        return None


def _missing_throws(asked: _Asked, order: Sequence[str]) -> Problem:
    """Ask for the throws of an engine in line of which an order names more cylinders than one throw carries.

    Where the cycle is known, too, those of an even engine follow: the cylinder that fires k-th is at its top after k
    parts of the cycle, and its throw as far behind that of cylinder 1.
    """
    n = len(order)
    allowed = _("is missing: firing_order {order} is of {n} cylinders, and there is one throw")
    said = allowed.format(order=asked.common.firing_order or "", n=n)
    repair = _("write a throw for each cylinder, the angles of their cranks, and [bank.NAME.mechanism] for all")
    if (length := asked.common.cycle_length) is not None:
        behind = np.array([order.index(str(i + 1)) for i in range(n)]) - order.index("1")
        throws = np.degrees(within_turn(-behind * length / n))
        listed = ", ".join(f'"{throw:.10g} deg"' for throw in throws.tolist())
        repair = _("an even engine's are throws = [{throws}], with [bank.NAME.mechanism] for all", throws=listed)
    return Problem("shaft.main.throws", None, said, repair)


def _throw_problems(asked: _Asked, order: Sequence[str], tops: Array) -> tuple[Problem, ...]:
    """Find an order in which the crank pins do not bring the pistons to their tops."""
    length = asked.common.cycle_length
    if length is None or firing_angles(tops, length) is not None:
        return ()
    turns = [TURN * turn for turn in range(round(length / TURN))]
    possible = [
        Listed((name, either_of([number(float(top + turn), "deg") for turn in turns])), " ")
        for name, top in zip(order, tops, strict=True)
    ]
    allowed = _("cannot fire so: as the crank pins stand, the pistons are at their tops at {possible}")
    ahead = _backwards(order) if asked.astern else order
    said = allowed.format(possible=Listed(possible))
    return (Problem("cylinder.firing_order", asked.common.firing_order, said, asked.repair(ahead)),)


def given_firing(
    common: CylindersSpec, leading: Sequence[PlacedMechanism], cycle: float, *, zero: Array, astern: bool
) -> tuple[FiringOrder | None, tuple[Problem, ...]]:
    """Read at which crank angles the cylinders fire.

    Parameters
    ----------
    common : CylindersSpec
        With `firing_angles`, which count as crank angles are shown, ahead.
    leading : sequence of PlacedMechanism
        Of each cylinder, the piston along whose axis the crank lies at nominal firing.
    cycle : float
        2π or 4π. [rad]
    zero : Array
        φ where the shown crank angle is 0. [rad]
    astern : bool
        The same metal at −φ: the angles count the other way.

    Returns
    -------
    FiringOrder or None, tuple of Problem
        No order where a cylinder has no angle, or one at which its crank does not lie along it.
    """
    names = [place.cylinder for place in leading]
    given, problems = _by_cylinder(common, names)
    if problems:
        return None, problems
    sense = -1.0 if astern else 1.0
    fires = [sense * angle.array + zero for _key, angle in given]
    tops_of = [place.nominal_top for place in leading]
    asked, tops = (by_design(each, max(map(np.size, (*fires, *tops_of)))) for each in (fires, tops_of))
    turns = np.rint((asked - tops) / (2 * np.pi))
    angles = within_turn(tops + 2 * np.pi * turns, cycle)
    off = np.abs(asked - tops - 2 * np.pi * turns) > _WRITTEN
    if np.any(off):
        possible = [
            np.sort(within_turn(sense * (top - zero) + 2 * np.pi * np.arange(round(cycle / (2 * np.pi))), cycle))
            for top in tops[0]
        ]
        allowed = _("must be where the crank lies along the cylinder: {angles}")
        return None, tuple(
            Problem(
                f"{_PATH}{key}",
                angle.text,
                allowed.format(angles=either_of([number(float(one), "deg") for one in where])),
            )
            for (key, angle), where, is_off in zip(given, possible, off[0], strict=True)
            if is_off
        )
    order: NDArray[np.intp] = np.argsort(angles[0], kind="stable")
    in_order: list[str] = [names[i] for i in order.tolist()]
    return FiringOrder(order, common.makers_numbers(in_order), angles), ()


def _by_cylinder(common: CylindersSpec, names: Sequence[str]) -> tuple[list[tuple[str, Given]], tuple[Problem, ...]]:
    """Give every cylinder its angle, with the path below the table; problems where it has none, or two."""
    angles = common.firing_angles or ()
    if not isinstance(angles, Mapping):
        if len(angles) == len(names):
            return [(f"[{i}]", angle) for i, angle in enumerate(angles)], ()
        allowed = _("must be one angle for each cylinder: {cylinders}", cylinders=", ".join(names))
        return [], (Problem(_PATH, _("a list of {n}", n=len(angles)), allowed),)
    meant = [(common.numbers.get(key, key), key, angle) for key, angle in angles.items()]
    allowed = _("must be a cylinder of this machine, each once: {cylinders}", cylinders=", ".join(names))
    named = [name for name, _key, _angle in meant]
    wrong = [
        Problem(f"{_PATH}.{key}", angle.text, allowed)
        for i, (name, key, angle) in enumerate(meant)
        if name not in names or name in named[:i]
    ]
    left_out = [name for name in names if name not in named]
    if left_out and not wrong:
        missing = _("must have an angle for each cylinder; left out: {names}", names=", ".join(left_out))
        wrong = [Problem(_PATH, None, missing)]
    found = {name: (f".{key}", angle) for name, key, angle in meant}
    return [found[name] for name in names if name in found], tuple(wrong)


def _are_makers_numbers(order: Sequence[str], names: Sequence[str]) -> bool:
    """Whether an order counts the cylinders from 1, and they have other names."""
    counted = {str(number) for number in range(1, len(names) + 1)}
    return set(order) == counted and counted != set(names)


def numbers_line(order: Sequence[str], leading: Sequence[PlacedMechanism], tops: Array, cycle: float | None) -> Words:
    """Give the line for the table of the cylinders: counted in the way in which the order fires most evenly.

    Of ways that fire as evenly, that along one bank after the other comes first, in the order of the file.
    """
    ways = [{str(n): name for n, name in enumerate(names, 1)} for names in _ways_to_count(leading)]
    places = [place.cylinder for place in leading]

    def unevenness(numbers: dict[str, str]) -> float:
        """Sum of squared intervals; infinite where the pins do not allow the order."""
        if cycle is None:
            return 0.0
        fired = firing_angles(tops[[places.index(numbers[word]) for word in order]], cycle)
        return np.inf if fired is None else float(np.sum(np.diff(fired, append=fired[0] + cycle) ** 2).round(6))

    numbers = smallest_of(ways, unevenness)
    pairs = ", ".join(f'{word} = "{name}"' for word, name in numbers.items())
    return _("where these are the maker's numbers, write in [cylinder]: {line}", line=f"numbers = {{ {pairs} }}")


def _ways_to_count(leading: Sequence[PlacedMechanism]) -> Iterator[list[str]]:
    """Count along one bank after the other, or throw by throw, from either bank."""
    banks = list(dict.fromkeys(place.bank for place in leading))
    of_bank = {bank: [place.cylinder for place in leading if place.bank == bank] for bank in banks}
    for ordered in (banks, banks[::-1]):
        yield [name for bank in ordered for name in of_bank[bank]]
    for ordered in (banks, banks[::-1]):
        rows = itertools.zip_longest(*(of_bank[bank] for bank in ordered))
        yield [name for row in rows for name in row if name is not None]
