"""Cards in the chambers of all designs: each is unrolled once for chambers that are alike."""

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import problems_as
from cranktrain.fluids.fluid import Rooms
from cranktrain.fluids.indicator.card import CardNumbers
from cranktrain.fluids.indicator.chamber import Chamber
from cranktrain.fluids.indicator.curve import slope_at
from cranktrain.fluids.indicator.diagram import Diagram, diagram_work, pressure_at
from cranktrain.fluids.indicator.model import indicator_diagram
from cranktrain.fluids.state import ChamberState, VolumeLimits
from cranktrain.language import Words
from cranktrain.motion import Array, single


class Diagrams(NamedTuple):
    """The diagram of every chamber; chambers that are alike have the same. Shape (design, chamber, 1)."""

    diagram: NDArray[np.object_]


def diagrams_of(numbers: CardNumbers, rooms: Rooms) -> Diagrams:
    """Put each design's card into its chambers.

    Parameters
    ----------
    numbers : CardNumbers, of shape (design, 1, 1)
    rooms : Rooms

    Returns
    -------
    Diagrams

    Raises
    ------
    InputError
        If a file is no diagram of such a machine.
    """
    alike = rooms.alike()
    found = np.empty((*alike.shape, 1), dtype=np.object_)
    for design, place in _distinct(alike):
        limits = VolumeLimits(*(single(float(part[design, place, 0])) for part in rooms.limits))

        def volume(angle: Array, design: int = design, place: int = place) -> Array:
            return rooms.volume_of(design, place, angle).value

        with problems_as(lambda one: replace(one, path=f"{rooms.path}.{one.path}".removesuffix("."))):
            own = indicator_diagram(numbers.card[design, 0, 0], Chamber(rooms.cycle, limits, volume))
        found[design, alike[design] == place, 0] = own
    return Diagrams(found)


def card_pressure(state: ChamberState, diagrams: Diagrams) -> Array:
    """Absolute pressure by each chamber's diagram. [Pa]"""
    found = np.empty(np.broadcast_shapes(state.volume.shape, state.angle_from_firing.shape))
    angle = np.broadcast_to(state.angle_from_firing, found.shape)
    for diagram, chosen in _alike(diagrams):
        found[chosen] = pressure_at(diagram, angle[chosen])
    return found


def card_slope(state: ChamberState, _pressure: Array, volume_slope: Array, diagrams: Diagrams) -> Array:
    """Derivative of each chamber's diagram by the crank angle. [Pa/rad]"""
    found = np.empty(np.broadcast_shapes(volume_slope.shape, state.angle_from_firing.shape))
    angle = np.broadcast_to(state.angle_from_firing, found.shape)
    for diagram, chosen in _alike(diagrams):
        found[chosen] = slope_at(diagram.curve, angle[chosen])
    return found


def card_work(diagrams: Diagrams, rooms: Rooms) -> Array:
    """∮ p dV of every chamber, shape (design, chamber). [J]"""
    alike = rooms.alike()
    works = np.empty(alike.shape)
    for design, place in _distinct(alike):

        def slope(angle: Array, design: int = design, place: int = place) -> Array:
            return rooms.volume_of(design, place, angle.ravel()).first.reshape(angle.shape)

        work = diagram_work(diagrams.diagram[design, place, 0], slope)
        works[design, alike[design] == place] = work
    return works


def card_breaks(diagrams: Diagrams) -> Array:
    """Where the pieces of each curve meet, from nominal firing, shape (design, chamber, k): NaN fills up. [rad]"""
    alike = list(_alike(diagrams))
    most = max(len(diagram.curve.places) for diagram, _chosen in alike)
    filled = np.full((*diagrams.diagram.shape[:2], most), np.nan)
    for diagram, chosen in alike:
        filled[chosen] = np.pad(diagram.curve.places, (0, most - len(diagram.curve.places)), constant_values=np.nan)
    return filled


def card_notes(diagrams: Diagrams) -> tuple[Words, ...]:
    """Flags and findings of all diagrams."""
    alike = [diagram for diagram, _chosen in _alike(diagrams)]
    return (*(flag for one in alike for flag in one.flags), *(finding for one in alike for finding in one.findings))


def _distinct(alike: NDArray[np.intp]) -> list[tuple[int, int]]:
    """Of each design, the chambers that stand for those alike."""
    return [(design, place) for design, own in enumerate(alike) for place in np.unique(own).tolist()]


def _alike(diagrams: Diagrams) -> Iterator[tuple[Diagram, NDArray[np.bool_]]]:
    """Each diagram once, with the chambers that have it; as the rows stand, or one alone."""
    rows = diagrams.diagram[..., 0]
    for diagram in {id(one): one for one in rows.ravel()}.values():
        yield diagram, np.reshape([one is diagram for one in rows.ravel()], rows.shape)
