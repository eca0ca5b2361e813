"""What a sheet says of its machine: layout, speed, conventions, where the numbers are from."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from typing import cast

from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.mechanisms import kind_named
from cranktrain.quantities import Given, shown
from cranktrain.spec import Spec


def layout_words(machine: Machine) -> str:
    """Say what the machine is, to begin no sentence: its mechanism, or its pistons, throws and banks."""
    if machine.mechanism is not None:
        return _(kind_named(machine.mechanism.kind).title)
    places = machine.places
    pistons = sum(place.kind.output == "slider" for place in places)
    rockers = len(places) - pistons
    throws = len(machine.main_shaft.throws)
    banks = ", ".join(machine.bank)
    parts = [
        _("1 piston") if pistons == 1 else _("{n} pistons").format(n=pistons) if pistons else "",
        _("1 rocker") if rockers == 1 else _("{n} rockers").format(n=rockers) if rockers else "",
        _("1 throw") if throws == 1 else _("{n} throws").format(n=throws),
        (_("bank {banks}") if len(machine.bank) == 1 else _("banks {banks}")).format(banks=banks),
    ]
    return ", ".join(part for part in parts if part)


def running_words(machine: Machine) -> str:
    """Say speed and sense of rotation."""
    senses = {
        ("clockwise", "ahead"): _("clockwise"),
        ("anticlockwise", "ahead"): _("anticlockwise"),
        ("clockwise", "astern"): _("astern, anticlockwise"),
        ("anticlockwise", "astern"): _("astern, clockwise"),
    }
    sense = senses[machine.rotation, machine.running]
    speed = machine.main_shaft.speed
    return f"n = {speed.text}, {sense}" if speed is not None else sense


def zero_words(machine: Machine) -> str:
    """Say where the crank angle is 0 and how it counts."""
    axis = _("the mechanism's x")
    if len(machine.bank) == 1:
        axis = _("the first cylinder's axis")
    elif machine.bank:
        axis = _("the axis of bank {bank}").format(bank=next(iter(machine.bank)))
    if machine.crank_zero == "Y":
        start = _("φ = 0 where crank 1 points up")
    elif machine.crank_zero.si != 0.0:
        words = _("φ = 0 where crank 1 is {angle} ahead of {axis}")
        if machine.crank_zero.si < 0.0:
            words = _("φ = 0 where crank 1 is {angle} behind {axis}")
        start = words.format(angle=f"{shown(abs(machine.crank_zero.si), 'deg'):.2f}°", axis=axis)
    else:
        start = _("φ = 0 where crank 1 is on {axis}").format(axis=axis)
    return _("{start}; counted in the sense of running; seen from the free end").format(start=start)


def counted_by_status(numbers: Iterable[Given]) -> str:
    """Count given numbers by where they are from."""
    counts = Counter(number.status for number in numbers)
    words = {
        "published": _("{n} published"),
        "derived": _("{n} derived"),
        "assumed": _("{n} assumed"),
        "fitted": _("{n} fitted"),
        None: _("{n} without a status"),
    }
    return ", ".join(word.format(n=counts[status]) for status, word in words.items() if counts[status])


def provenance_words(machine: Machine) -> str:
    """Count the numbers that a machine's file gives by where they are from."""
    given = dict.fromkeys(_given(machine, ""))
    return _("Inputs: {counts}").format(counts=counted_by_status(number for _path, number in given))


def _given(part: object, path: str) -> Iterator[tuple[str, Given]]:
    """Give the numbers that a file declares, with their paths; what it leaves unsaid is none of them.

    A bank's mechanisms share a path: a number that the file gives once for all its angles is one number.
    """
    if isinstance(part, Given):
        yield path, part
    elif isinstance(part, tuple):
        for i, item in enumerate(cast("tuple[object, ...]", part)):
            yield from _given(item, path if path.endswith(".mechanism") else f"{path}[{i}]")
    elif isinstance(part, Mapping):
        for name, item in cast("Mapping[str, object]", part).items():
            yield from _given(item, f"{path}.{name}")
    elif isinstance(part, Spec):
        for name in part.model_fields_set:
            yield from _given(getattr(part, name), f"{path}.{name}")
