"""The firing order of the file, put to the cylinders and held against where the crank pins stand."""

import re
from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.questions.cylinders.firing import FiringOrder, firing_angles, within_turn
from cranktrain.questions.cylinders.given_firing import given_firing
from cranktrain.questions.cylinders.makers_numbers import are_makers_numbers, numbers_line
from cranktrain.questions.cylinders.possible_orders import likest_orders
from cranktrain.questions.cylinders.spec import CylindersSpec
from cranktrain.record import record
from cranktrain.wording import number


@record
class _Asked:
    """An order as it is asked for: the table that has it, each cylinder by its leading piston, the sense of running."""

    common: CylindersSpec
    leading: Sequence[PlacedMechanism]
    astern: bool

    def repair(self, order: Sequence[str]) -> str | None:
        """Give the most even orders that the crank pins allow, as the file writes them; `order` is ahead."""
        length = self.common.cycle_length
        names = [place.cylinder for place in self.leading]
        divided = self._divided(names)
        if len(order) == 1 and divided is not None:
            return _("write {orders}").format(orders=f'"{divided}"')
        if length is None or 2 * sum(name in names for name in order) < len(order):
            return None
        running = _backwards(order) if self.astern else order
        wanted = [names.index(name) if name in names else -1 for name in running]
        found = [[names[i] for i in one] for one in likest_orders(_tops(self.leading), length, wanted)]
        ahead = list(map(_backwards, found)) if self.astern else found
        said = [f'"{"-".join(self.common.makers_numbers(one) or one)}"' for one in ahead]
        return _("write {orders}").format(orders=_(" or ").join(said)) if said else None

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
    length = common.cycle_length
    if common.firing_angles is not None and length is not None and not problems:
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
            allowed = _("must be a cylinder of this machine: {cylinders}").format(cylinders=", ".join(names))
            yield Problem(f"cylinder.numbers.{word}", name, allowed)
        elif first != word:
            allowed = _("must be another cylinder: this one is number {number}").format(number=first)
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
    allowed = _("must name each cylinder once ({cylinders}); {wrong}").format(
        cylinders=", ".join(names), wrong="; ".join(wrong)
    )
    if not asked.common.numbers and are_makers_numbers(order, names):
        line = numbers_line(order, asked.leading, _tops(asked.leading), asked.common.cycle_length)
        return (Problem("cylinder.firing_order", asked.common.firing_order, allowed, line),)
    return (Problem("cylinder.firing_order", asked.common.firing_order, allowed, asked.repair(order)),)


def _throw_problems(asked: _Asked, order: Sequence[str], tops: Array) -> tuple[Problem, ...]:
    """Find an order in which the crank pins do not bring the pistons to their tops."""
    length = asked.common.cycle_length
    if length is None or firing_angles(tops, length) is not None:
        return ()
    turns = [TURN * turn for turn in range(round(length / TURN))]
    possible = ", ".join(
        f"{name} {_(' or ').join(number(float(top + turn), 'deg') for turn in turns)}"
        for name, top in zip(order, tops, strict=True)
    )
    allowed = _("cannot fire so: as the crank pins stand, the pistons are at their tops at {possible}")
    ahead = _backwards(order) if asked.astern else order
    said = allowed.format(possible=possible)
    return (Problem("cylinder.firing_order", asked.common.firing_order, said, asked.repair(ahead)),)
