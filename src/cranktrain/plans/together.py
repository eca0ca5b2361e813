"""What a plan shows: one mechanism, or those of both pistons of a cylinder together."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.mechanisms.drawing import Drawing
from cranktrain.motion import Array, Point
from cranktrain.plans.lettering import renamed
from cranktrain.plans.placement import place_called, placed, shaft_places


def places_called(machine: Machine, name: str | None) -> tuple[PlacedMechanism, ...]:
    """Find the mechanisms that a plan shows: one; of a cylinder with opposed pistons those of both.

    A cylinder is meant by its name, or where nothing is named. What is on a shaft whose place is not known is left out.

    Raises
    ------
    InputError
        If nothing has that name.

    Examples
    --------
    >>> from cranktrain.machine import Machine
    >>> crank = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "200 mm"}
    >>> pistons = {"exhaust": {"mechanism": crank}, "scavenge": {"mechanism": crank, "shaft": "upper"}}
    >>> engine = Machine(shaft={"upper": {}}, bank={"A": {**pistons, "lead": "0 deg"}})
    >>> [[place.name for place in places_called(engine, name)] for name in (None, "1", "1.scavenge")]
    [['1.exhaust', '1.scavenge'], ['1.exhaust', '1.scavenge'], ['1.scavenge']]
    """
    first = place_called(machine, name)
    if name == first.name:
        return (first,)
    centres = shaft_places(machine).centres
    others = (
        place
        for place in machine.places
        if place.cylinder == first.cylinder and place.shaft in centres and place is not first
    )
    return (first, *(others if first.shaft in centres else ()))


def placed_together(machine: Machine, places: Sequence[PlacedMechanism], angle: Array) -> Drawing:
    """Give the drawing of several places in machine axes about the first one's shaft.

    Parameters
    ----------
    machine : Machine
    places : sequence of PlacedMechanism
        On shafts that stand somewhere known.
    angle : Array, shape (n,)
        φ of the machine. [rad]

    Returns
    -------
    Drawing
        Pins of the second place have its number: `A2`.
    """
    if len(places) == 1:
        return placed(machine, places[0], angle)
    centres = shaft_places(machine).centres
    parts: list[Drawing] = []
    for i, place in enumerate(places):
        drawing = placed(machine, place, angle)
        away = np.ravel(centres[place.shaft] - centres[places[0].shaft])
        pins = {
            name: Point(*(along._replace(value=along.value + step) for along, step in zip(pin, away, strict=True)))
            for name, pin in drawing.pins.items()
        }
        parts.append(renamed(replace(drawing, pins=pins), {name: numbered_pin(name, i) for name in pins}))
    return Drawing(
        pins={name: pin for part in parts for name, pin in part.pins.items()},
        **{
            field: tuple(one for part in parts for one in getattr(part, field))
            for field in ("links", "guides", "fixed", "paths", "blocks", "ends", "points")
        },
    )


def numbered_pin(name: str, i: int) -> str:
    """Name of a pin of one of several places that are drawn together."""
    return f"{name}{i + 1}" if i else name


def together_name(places: Sequence[PlacedMechanism]) -> str:
    """Name of what is drawn together: a mechanism, or a cylinder."""
    return places[0].name if len(places) == 1 else places[0].cylinder
