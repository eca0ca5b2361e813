"""What a machine is, and where its numbers are from, as every sheet and report says it."""

from collections import Counter
from collections.abc import Iterable

from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.mechanisms import kind_named
from cranktrain.quantities import Given


def layout_words(machine: Machine) -> str:
    """Say what the machine is, to begin no sentence: its mechanism, or its pistons, throws and banks."""
    if machine.mechanism is not None:
        return kind_words(machine)
    banks = _("bank {banks}") if len(machine.bank) == 1 else _("banks {banks}")
    return ", ".join([*counted_parts(machine), banks.format(banks=", ".join(machine.bank))])


def kind_words(machine: Machine) -> str:
    """Say what the one mechanism of a machine is; nothing of one that has banks."""
    return "" if machine.mechanism is None else _(kind_named(machine.mechanism.kind).title)


def counted_parts(machine: Machine) -> list[str]:
    """Count pistons, valves, rockers and throws."""
    places = machine.places
    rockers = sum(place.kind.output == "rocker" for place in places)
    pistons = sum(place.kind.output == "slider" and place.kind.has_chambers for place in places)
    counts = (
        (pistons, _("1 piston"), _("{n} pistons")),
        (len(places) - rockers - pistons, _("1 valve"), _("{n} valves")),
        (rockers, _("1 rocker"), _("{n} rockers")),
        (len(machine.main_shaft.throws), _("1 throw"), _("{n} throws")),
    )
    return [one if n == 1 else many.format(n=n) for n, one, many in counts if n]


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
