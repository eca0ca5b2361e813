"""Parts that may be added to a machine by clicks on its drawing: what a click may take there, and what it gives."""

from collections.abc import Iterator, Mapping, Sequence
from typing import get_args

import numpy as np

from cranktrain.errors import InputError, Problem
from cranktrain.language import Words, _
from cranktrain.layout.frames import in_own_axes
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.mechanisms.by_hand import AddedTable, Addition, Click, Clicked, Taken
from cranktrain.mechanisms.drawing import Drawing
from cranktrain.motion import Array
from cranktrain.plans.placement import frame, place_called, placed, shaft_places
from cranktrain.record import record

_TAKEN: tuple[Taken, ...] = get_args(Taken)


@record
class DrawnTarget:
    """What a click may take.

    Attributes
    ----------
    name : str
        Of a pin or a link; none of the ground.
    words : Words
        What it will be.
    pins : tuple of str
        Of the drawing: the pin, or those between which the link lies; none of the ground.
    then : int
        Place of the click that follows among those of the part; their number behind the last.
    """

    name: str
    words: Words
    pins: tuple[str, ...]
    then: int


@record
class DrawnClick:
    """A click: the sentence that asks for it, what it may take, and whether no line leads to it from the one before."""

    asks: Words
    targets: tuple[DrawnTarget, ...]
    begins: bool


@record
class DrawnAddition:
    """A part that may be added to a mechanism: its name among those of the kind, what it is called, its clicks.

    The first click is asked for first; each target says which follows.
    """

    mechanism: str
    name: str
    title: Words
    clicks: tuple[DrawnClick, ...]


def drawn_additions(machine: Machine, places: Sequence[PlacedMechanism]) -> tuple[DrawnAddition, ...]:
    """Give what may be added to what is drawn.

    Parameters
    ----------
    machine : Machine
    places : sequence of PlacedMechanism

    Returns
    -------
    tuple of DrawnAddition
        To each table of the file once.
    """
    by_table = {place.path: place for place in reversed(places) if place.kind.additions}
    return tuple(
        DrawnAddition(place.name, one.name, _title(one, place, len(by_table)), tuple(_clicks(machine, place, one)))
        for place in reversed(by_table.values())
        for one in place.kind.additions
    )


def _title(one: Addition, place: PlacedMechanism, n_tables: int) -> Words:
    """Say what it is, and of several mechanisms to which it is added."""
    return _(one.title) if n_tables == 1 else f"{place.name} {_(one.title)}"


def _clicks(machine: Machine, place: PlacedMechanism, addition: Addition) -> Iterator[DrawnClick]:
    """Give the clicks of a part with what they may take in the drawing; alternatives stand one after another."""
    drawing = placed(machine, place, np.zeros(1))
    for clicks, then in zip(addition.clicks, _places(addition)[1:], strict=True):
        for click in (clicks,) if isinstance(clicks, Click) else clicks.values():
            yield DrawnClick(_(click.asks), tuple(_targets(place, drawing, click, then)), click.begins)


def _places(addition: Addition) -> list[Mapping[Taken, int]]:
    """Places of the clicks of a part by what the click before took, and their number."""
    places: list[Mapping[Taken, int]] = []
    n_clicks = 0
    for clicks in addition.clicks:
        alternatives: dict[Taken, int] = dict.fromkeys(_TAKEN, n_clicks)
        if not isinstance(clicks, Click):
            alternatives = {sort: n_clicks + k for k, sort in enumerate(clicks)}
        places.append(alternatives)
        n_clicks = max(alternatives.values()) + 1
    return [*places, dict.fromkeys(_TAKEN, n_clicks)]


def _targets(
    place: PlacedMechanism, drawing: Drawing, click: Click, then: Mapping[Taken, int]
) -> Iterator[DrawnTarget]:
    """Give the pins, sliders, links and the ground, as far as a click takes them."""
    pins = [name for name in (*drawing.fixed, *place.kind.joints) if name in drawing.pins]
    links = {link.name: link.pins for link in drawing.links if link.name in place.kind.links}
    targets: Mapping[Taken, Mapping[str, tuple[str, ...]]] = {
        "pin": {name: (name,) for name in pins},
        "slider": {guide.pin: (guide.pin,) for guide in drawing.guides},
        "link": links,
        "ground": {"": ()},
    }
    for sort, words in click.takes.items():
        for name, own in targets[sort].items():
            yield DrawnTarget(name, _(words, name=name), own, then[sort])


def added_table(
    machine: Machine, mechanism: str, name: str, angle: float, clicks: Sequence[Clicked]
) -> tuple[str, AddedTable]:
    """Find a part that is added by clicks.

    Parameters
    ----------
    machine : Machine
    mechanism : str
        To which it is added, by its name.
    name : str
        Of the part among those that its kind has.
    angle : float
        Crank angle as the machine shows it. [deg]
    clicks : sequence of Clicked
        What they took; x to the right and y up from the main shaft. [m]

    Returns
    -------
    str
        Path of the mechanism's table in the file.
    AddedTable

    Raises
    ------
    InputError
        If there is no such mechanism or part, and where clicks took what it cannot be.
    """
    place = place_called(machine, mechanism)
    addition = next((one for one in place.kind.additions if one.name == name), None)
    if addition is None:
        names = ", ".join(one.name for one in place.kind.additions)
        raise InputError([Problem("addition.name", name, _("must be one of: {names}", names=names or "–"))])
    if len(clicks) != len(addition.clicks):
        allowed = _("must be as many as it asks for: {n}", n=len(addition.clicks))
        raise InputError([Problem("addition.clicks", str(len(clicks)), allowed)])
    shift = shaft_places(machine).centres.get(place.shaft, np.zeros(2))
    own = [_in_table(machine, place, one, np.ravel(shift)) for one in clicks]
    turned = place.sense * float(np.ravel(np.deg2rad(angle) + machine.zero + place.phase)[0])
    return place.path, addition.added(place.spec, own, turned)


def _in_table(machine: Machine, place: PlacedMechanism, clicked: Clicked, centre: Array) -> Clicked:
    """Give a click in the axes of a mechanism's table: its metal stays where its crank turns the other way."""
    x, y = in_own_axes(clicked.x - centre[0], clicked.y - centre[1], frame(machine, place))
    return Clicked(clicked.name, float(np.ravel(x)[0]), place.sense * float(np.ravel(y)[0]))
