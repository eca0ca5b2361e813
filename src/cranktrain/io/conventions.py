"""How a result counts angles and signs, in words: what every file of numbers says at its head."""

from collections.abc import Iterator

from cranktrain.analysis import Result, sentences
from cranktrain.io.description import longer_cycle_words
from cranktrain.language import said as _
from cranktrain.layout.speed import SpeedCurve
from cranktrain.machine import Machine
from cranktrain.quantities import units_asked


def conventions(result: Result) -> dict[str, str]:
    """Say what the numbers of a result count from, and in which sense.

    Parameters
    ----------
    result : Result

    Returns
    -------
    dict of str
        Sentences by what they are about: `rotation`, `running`, `crank_angle`, `units`, and the signs that matter;
        `unused` where the file has tables that nothing rests on; `cycle` where loads or the speed make it two turns;
        `crank_speed` where it varies over the cycle.
    """
    return dict(_sentences(result))


def _sentences(result: Result) -> Iterator[tuple[str, str]]:
    machine = result.machines[0]
    rotation = {
        "clockwise": _("clockwise, seen from the free end of the shaft"),
        "anticlockwise": _("anticlockwise, seen from the free end of the shaft"),
    }
    running = {
        "ahead": _("ahead: in the sense of rotation"),
        "astern": _(
            "astern: against the sense of rotation; crank angles, speeds and torques count in the sense of running"
        ),
    }
    yield "rotation", rotation[machine.rotation]
    yield "running", running[machine.running]
    if result.unused:
        yield "unused", " ".join(map(str, sentences(result.unused)))
    yield "crank_angle", _crank_angle(machine)
    if longer := longer_cycle_words(machine):
        yield "cycle", longer
    if (curve := result.get(SpeedCurve)) is not None:
        yield "crank_speed", str(curve.condition(0))
    if "piston" in result.labels:
        yield (
            "piston_displacement",
            _("from the true top dead centre toward the shaft; velocity and acceleration likewise"),
        )
        yield "rod_angle", _("from the line of stroke, away from the shaft, positive in the sense of rotation")
    if "rocker" in result.labels:
        yield "rocker_angle", _("from the line from the shaft to the rocker's pivot, positive in the sense of rotation")
    asked = ", ".join(units_asked().values())
    yield (
        "units",
        _("{units} where they fit, else SI, in brackets; crank angles in degrees, other angles in radians", units=asked)
        if asked
        else _("SI, in brackets; crank angles in degrees, other angles in radians"),
    )


def _crank_angle(machine: Machine) -> str:
    """Say where the crank angle is zero."""
    if machine.mechanism is not None:
        start = _("0 where the crank points along the mechanism's x axis")
    elif len(machine.bank) == 1:
        start = _("0 where the crank of throw 1 points along the first cylinder's axis")
    else:
        start = _("0 where the crank of throw 1 points along the axis of bank {bank}", bank=next(iter(machine.bank)))
    if machine.crank_zero == "Y":
        return _("0 where the crank of throw 1 points up, along Y")
    if machine.crank_zero.si == 0.0:
        return start
    return _("{zero} of it is shown as 0; it is {start}", zero=machine.crank_zero.text, start=start)
