"""Lines of a written cycle that many of its parts have: what is imported, and numbers taken out of their arrays."""

import re
from collections.abc import Iterable, Iterator
from typing import Any

from cranktrain.study.cycle.structure import KindSource, Shape

INDENT = "    "
CRANK = "Direction(cos * ahead.cos - sin * ahead.sin, sin * ahead.cos + cos * ahead.sin)"
"""Direction of a member's crank: the machine's, turned by the member's phase."""


class Imports:
    """Names of the source by what they are imported from."""

    def __init__(self) -> None:
        self.known: dict[tuple[str, str], str] = {}

    def name(self, thing: Any) -> str:
        """Give a function's or class's name, imported once."""
        module, own = thing.__module__, thing.__qualname__
        taken = [name for (other, _own), name in self.known.items() if other != module]
        name = own if own not in taken else f"{own}_{len(self.known)}"
        return self.known.setdefault((module, own), name)

    def lines(self) -> Iterator[str]:
        """Import statements."""
        for (module, own), name in sorted(self.known.items()):
            yield f"from {module} import {own}" + ("" if own == name else f" as {name}")


def _counting() -> Iterator[int]:
    place = 0
    while True:
        yield place
        place += 1


def taken_out(shape: Shape, imports: Imports, array: str, name: str) -> tuple[list[str], str]:
    """Lines that take a row of numbers out of its array, and the expression that makes nested tuples of them."""
    number = _counting()
    made = _made(shape, imports, number, name)
    n_numbers = next(number)
    return [f"{name}{place} = {array}[design, member, {place}]" for place in range(n_numbers)], made


def _made(shape: Shape, imports: Imports, number: Iterator[int], name: str) -> str:
    """Expression that makes nested tuples from numbers that stand in names of their own."""
    parts = [f"{name}{next(number)}" if one is None else _made(one, imports, number, name) for one in shape.fields]
    return f"{imports.name(shape.made)}({', '.join(parts)})"


def member_lines(place: int, one: KindSource, imports: Imports) -> list[str]:
    """Lines that take the geometry of a member, and how its crank stands, out of their arrays."""
    lines, made = taken_out(one.geometry, imports, f"k{place}.geometry", "g")
    return [
        *lines,
        f"size = {made}",
        f"ahead = Direction(k{place}.ahead[design, member, 0], k{place}.ahead[design, member, 1])",
    ]


def body_lines(place: int, one: KindSource) -> list[str]:
    """Lines that take the bodies of a member and its gravity out of their arrays."""
    lines = [f"b{number} = k{place}.bodies[design, member, {number}]" for number in range(4 * one.n_links)]
    each = (f"Body({', '.join(f'b{4 * link + number}' for number in range(4))})" for link in range(one.n_links))
    return [
        *lines,
        f"bodies = ({', '.join(each)},)",
        f"gravity = Gravity(k{place}.gravity[design, member, 0], k{place}.gravity[design, member, 1])",
    ]


def indented(lines: Iterable[str], depth: int) -> Iterator[str]:
    """Lines so many steps deep."""
    return (f"{INDENT * depth}{line}" for line in lines)


_IN_TUPLE = re.compile(r"\b(k\d+|f\d+|room|turning|wanted|panels|work|found)\.(\w+)")
"""What a loop is given of a tuple, where a written line names it."""


def taken_by(lines: Iterable[str]) -> tuple[str, ...]:
    """What lines name of the tuples that are given, each once."""
    return tuple(dict.fromkeys(f"{whole}.{part}" for line in lines for whole, part in _IN_TUPLE.findall(line)))


def in_names(lines: Iterable[str]) -> list[str]:
    """Lines in which each of these has a name of its own.

    A tuple of arrays is given word by word, and read so wherever one of them is named, until the compiler sees which.
    """
    return [_IN_TUPLE.sub(r"\1_\2", line) for line in lines]
