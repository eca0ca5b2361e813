"""What a machine is, and where its numbers are from, as every sheet and report says it."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, cast

from cranktrain.language import N_
from cranktrain.language import said as _
from cranktrain.layout.unit_tables import unit_problems, units_of_table
from cranktrain.machine import Machine
from cranktrain.mechanisms import KINDS
from cranktrain.numerics.harmonics import TURN
from cranktrain.quantities import FileUnits, Given, UnitChoice, own_units
from cranktrain.spec import Spec


def layout_words(machine: Machine) -> str:
    """Say what the machine is, to begin no sentence: its mechanism, or its pistons, throws and banks."""
    if machine.mechanism is not None:
        return kind_words(machine)
    banks = _("bank {banks}") if len(machine.bank) == 1 else _("banks {banks}")
    return ", ".join([*counted_parts(machine), banks.format(banks=", ".join(machine.bank))])


def kind_words(machine: Machine) -> str:
    """Say what the one mechanism of a machine is; nothing of one that has banks."""
    return "" if machine.mechanism is None else _(KINDS.named(machine.mechanism.kind).title)


def counted_parts(machine: Machine) -> list[str]:
    """Count pistons, valves, rockers and throws."""
    outputs = Counter(place.kind.output for place in machine.places)
    in_order = sorted(outputs, key=lambda output: output.rank)
    counts = [(outputs[output], output.counted) for output in in_order]
    counts.append((len(machine.main_shaft.throws), (N_("1 throw"), N_("{n} throws"))))
    return [_(one) if n == 1 else _(many, n=n) for n, (one, many) in counts]


def longer_cycle_words(machine: Machine) -> str:
    """Say that loads, or the speed, have a cycle of two turns; nothing where cylinders have it, or it is one turn."""
    return _("two turns a cycle") if machine.cycle > (machine.cylinder.cycle_length or TURN) else ""


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


def units_of(machine: Machine) -> FileUnits:
    """Units in which a machine is to be shown: those of its [units], and those in which most of its numbers stand."""
    return FileUnits(units_of_table(machine.units), own_units(one.text for one in given_numbers(machine)))


def units_of_tables(data: Mapping[str, object]) -> FileUnits:
    """Units in which a machine is to be shown whose tables are no machine yet; what is wrong in them says nothing."""
    units = data.get("units")
    table = cast("Mapping[str, object]", units if isinstance(units, Mapping) else {})
    texts: dict[str, str] = {name: unit for name, unit in table.items() if isinstance(unit, str)}
    said: UnitChoice = {} if any(unit_problems(texts)) else units_of_table(texts)
    return FileUnits(said, own_units(_texts(data)))


def _texts(data: object) -> Iterator[str]:
    """Give the texts of tables, but for what is said of their numbers."""
    if isinstance(data, str):
        yield data
    elif isinstance(data, Mapping):
        for key, item in cast("Mapping[str, object]", data).items():
            if key not in ("note", "source", "name"):
                yield from _texts(item)
    elif isinstance(data, list | tuple):
        for item in cast("Sequence[object]", data):
            yield from _texts(item)


def given_numbers(part: object, name: object = "") -> Iterator[Given]:
    """Give the numbers that a machine's tables declare; what they leave unsaid is none of them."""
    if isinstance(part, Given):
        yield part
    for inner, item in _inside(part, name).items():
        yield from given_numbers(item, inner)


def _fields(part: Spec) -> list[str]:
    """What is given of a table, in the order of its keys."""
    return [field for field in type(part).model_fields if field in part.model_fields_set]


def _inside(part: object, name: object) -> Mapping[Any, object]:
    """What a part of a machine is made of, by name.

    Of a bank's mechanisms, one for each angle, a field that is alike in all of them stands in the file once.
    """
    match part:
        case tuple() if name == "mechanism":
            each = cast("tuple[Spec, ...]", part)
            fields = {field: tuple(getattr(one, field) for one in each) for field in _fields(each[0])}
            return {field: one[0] if len(set(map(repr, one))) == 1 else one for field, one in fields.items()}
        case Spec():
            return {field: getattr(part, field) for field in _fields(part)}
        case tuple():
            return dict(enumerate(cast("tuple[object, ...]", part)))
        case Mapping():
            return cast("Mapping[str, object]", part)
        case _:
            return {}
