"""Velocities of pins as vectors, exact at every crank angle."""

from collections.abc import Iterator, Sequence

from cranktrain.analysis import Result
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Array
from cranktrain.panels.members import has_speed, moving_pins
from cranktrain.panels.vectors import PinVector, VectorsToScale, to_one_scale
from cranktrain.plans.vectors import spoken_name


def velocities(result: Result, places: Sequence[PlacedMechanism], angles: Array) -> Iterator[VectorsToScale]:
    """Give the velocities of all that moves, of pins that mechanisms share once; none where no speed is known.

    Parameters
    ----------
    result : Result
        Of one machine.
    places : sequence of PlacedMechanism
        What is drawn.
    angles : Array, shape (n,)
        Crank angles as the machine shows them. [deg]

    Yields
    ------
    VectorsToScale
        v = r′ω. [m/s]
    """
    if has_speed(result):
        pins = (one for one in moving_pins(result, places, angles) if not one.is_fixed)
        vectors = (
            PinVector(one.mechanism, one.names[0], "v", f"v_{{{_index(one.names[0])}}}", one.velocity) for one in pins
        )
        yield from to_one_scale("m/s", [(_("Velocities"), vectors)])


def _index(pin: str) -> str:
    """Name of a pin as an index: a letter is one of mathematics, a word is not."""
    name = spoken_name(pin).replace("_", " ")
    return name if len(name) == 1 else rf"\mathrm{{{name}}}"
