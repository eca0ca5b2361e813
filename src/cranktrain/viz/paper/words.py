"""What a sheet says of its machine: speed, conventions, where the numbers are from."""

from cranktrain.io.description import counted_by_status, given_numbers
from cranktrain.language import _
from cranktrain.layout.speed import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.quantities import shown
from cranktrain.wording import as_given


def running_words(machine: Machine) -> str:
    """Say speed and sense of rotation, and at one moment the angular acceleration."""
    senses = {
        ("clockwise", "ahead"): _("clockwise"),
        ("anticlockwise", "ahead"): _("anticlockwise"),
        ("clockwise", "astern"): _("astern, anticlockwise"),
        ("anticlockwise", "astern"): _("astern, clockwise"),
    }
    shaft = machine.main_shaft
    given = (("n", shaft.speed, "rpm"), ("ε", shaft.acceleration, "rad/s²"))
    said = [f"{symbol} = {as_given(one, usual)}" for symbol, one, usual in given if one is not None]
    sense = senses[machine.rotation, machine.running]
    return ", ".join([*said, sense if said else sense[:1].upper() + sense[1:]])


def speed_words(curve: SpeedCurve | None, design: int = 0) -> str:
    """Say at which speed over the cycle a picture is, as the terminal does; nothing of a constant one."""
    return "" if curve is None else curve.answer({}, design)


def first_that_holds(*cases: tuple[bool, str]) -> str:
    """Give the first of some sentences whose case it is."""
    return next(sentence for holds, sentence in cases if holds)


def zero_words(machine: Machine) -> str:
    """Say where the crank angle is 0 and how it counts."""
    axis = first_that_holds(
        (len(machine.bank) > 1, _("the axis of bank {bank}")),
        (len(machine.bank) == 1, _("the first cylinder's axis")),
        (True, _("the mechanism's x")),
    ).format(bank=next(iter(machine.bank), ""))
    ahead = 0.0 if machine.crank_zero == "Y" else machine.crank_zero.si
    start = first_that_holds(
        (machine.crank_zero == "Y", _("φ = 0 where crank 1 points up")),
        (ahead > 0.0, _("φ = 0 where crank 1 is {angle} ahead of {axis}")),
        (ahead < 0.0, _("φ = 0 where crank 1 is {angle} behind {axis}")),
        (True, _("φ = 0 where crank 1 is on {axis}")),
    ).format(angle=f"{shown(abs(ahead), 'deg'):.2f}°", axis=axis)
    return _("{start}; counted in the sense of running; seen from the free end").format(start=start)


def provenance_words(machine: Machine) -> str:
    """Count the numbers that a machine's file gives by where they are from."""
    return _("Inputs: {counts}").format(counts=counted_by_status(given_numbers(machine)))
