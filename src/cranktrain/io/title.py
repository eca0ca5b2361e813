"""Which machine this is: in one line, or its name and what it is made of."""

from collections.abc import Iterator

from cranktrain.analysis import Result
from cranktrain.grouping import places_of_equal
from cranktrain.io.description import counted_parts, kind_words, layout_words, longer_cycle_words
from cranktrain.language import said as _
from cranktrain.layout.specs import ShaftSpec
from cranktrain.machine import Machine
from cranktrain.one_line import one_line
from cranktrain.questions.cylinders.firing import Firing
from cranktrain.saying.wording import as_given, in_words, ranged

_BETWEEN = " · "


def title(machine: Machine) -> str:
    """Say in one line which machine this is."""
    parts = [layout_words(machine)]
    if len(machine.shafts) > 1:
        parts.append(_shafts(machine))
    shaft = machine.main_shaft
    parts += _speeds(shaft)
    senses = {
        "clockwise": _("clockwise"),
        "anticlockwise": _("anticlockwise"),
        "ahead": _("ahead"),
        "astern": _("astern"),
    }
    parts.append(f"{senses[machine.rotation]}, {senses[machine.running]}")
    return one_line(": ".join(filter(None, (machine.name.strip(), "; ".join(parts)))))


def _shafts(machine: Machine) -> str:
    """Say which mechanisms work on which shaft."""
    places = machine.places
    names = [place.name for place in places]
    on = places_of_equal([place.shaft for place in places])
    said = (_("{shaft} ({mechanisms})", shaft=shaft, mechanisms=ranged(names, few)) for shaft, few in on.items())
    return _("shafts {shafts}", shafts=", ".join(said))


def headed(result: Result) -> tuple[str, str]:
    """Say which machine this is: its name; and what it is made of, its cycle, speed and sense."""
    machine = result.machines[0]
    said = one_line(_BETWEEN.join(filter(None, (_made_of(machine), _cycle(result), _turning(machine)))))
    return one_line(machine.name.strip()), said


def _made_of(machine: Machine) -> str:
    """Say what it is: its mechanism, or its parts with the names of banks and shafts where there are several."""
    if words := kind_words(machine):
        return words
    said = counted_parts(machine)
    if len(machine.bank) > 1:
        said.append(_("banks {banks}", banks=in_words([*machine.bank])))
    if len(machine.shafts) > 1:
        said.append(_("shafts {shafts}", shafts=in_words([*dict.fromkeys(one.shaft for one in machine.places)])))
    return ", ".join(said)


def _cycle(result: Result) -> str:
    """Say how many strokes a cycle has, where anything fires; and that loads or the speed have one of two turns."""
    words = {"two-stroke": _("two-stroke"), "four-stroke": _("four-stroke")}
    machine = result.machines[0]
    given = machine.cylinder.cycle
    strokes = "" if given is None or result.get(Firing) is None else words[given]
    return _BETWEEN.join(filter(None, (strokes, longer_cycle_words(machine))))


def _speeds(shaft: ShaftSpec) -> Iterator[str]:
    """Speed and acceleration as given, or in the units that are chosen."""
    for given, usual in ((shaft.speed, "rpm"), (shaft.acceleration, "rad/s²")):
        if given is not None:
            yield str(as_given(given, usual))


def _turning(machine: Machine) -> str:
    """Say how fast and in which sense it turns."""
    shaft = machine.main_shaft
    senses = {"clockwise": _("clockwise"), "anticlockwise": _("anticlockwise")}
    said = list(_speeds(shaft))
    said.append(senses[machine.rotation])
    if machine.running == "astern":
        said.append(_("running astern"))
    return ", ".join(said)
