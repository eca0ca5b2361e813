"""Gas in the chambers: pressure over the cycle by the declared model, its work, and its force on every piston."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cached_property, partial
from typing import Any, NamedTuple, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import InputError, Problem
from cranktrain.fluids import AnyFluid, ChamberState, Rooms, VolumeLimits, chamber_state
from cranktrain.language import _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Pistons
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array, Coefficient, single
from cranktrain.numerics.nested import each_changed
from cranktrain.questions.cylinders.firing import Cycle, Firing, FiringOrder
from cranktrain.questions.cylinders.travel import CylinderPistons, CylinderTravel
from cranktrain.questions.cylinders.volumes import Chambers, ChamberVolumes, SweptVolumes
from cranktrain.questions.gas.declared import DeclaredGas, GasTable
from cranktrain.questions.motion.dead_centres import DeadCentres, slider_motion
from cranktrain.record import record
from cranktrain.saying.checks import Flagged
from cranktrain.saying.wording import ranged

_TELLING = np.array([0.0, 0.6, 1.7, 3.9])
_DIGITS = 9
"""Of volumes that are one."""


_Ready: TypeAlias = tuple[object, ...]


class Filling(NamedTuple):
    """Chambers that one table fills: which, as its fluid asks for them, and what its pressure takes."""

    fluid: AnyFluid
    places: NDArray[np.intp]
    rooms: Rooms
    ready: Any

    def of_chamber(self, design: int, place: int) -> Any:
        """What the pressure takes of one chamber of one design."""
        own = int(np.searchsorted(self.places, place))
        return each_changed(
            lambda part: part[min(design, len(part) - 1), min(own, part.shape[1] - 1)], cast(_Ready, self.ready)
        )


@record
class GasInChambers(Flagged):
    """The gas in every chamber, to be asked at any crank angle.

    Attributes
    ----------
    pistons, chambers : Pistons, Chambers
    limits : VolumeLimits, fields of shape (design, chamber, 1)
    start : Array, shape (design, chamber, 1)
        Volume of each chamber where its pistons are at their tops. [m³]
    tops : Array, shape (design, piston, 1)
        Distance of each piston pin from its shaft there. [m]
    firing : Array, shape (design, chamber, 1)
        φ of each chamber's nominal firing. [rad]
    cycle : float
        [rad]
    likeness : Likeness
        Which chambers are like one another.
    fillings : tuple of Filling
    """

    pistons: Pistons
    chambers: Chambers
    limits: VolumeLimits
    start: Array
    tops: Array
    firing: Array
    cycle: float
    likeness: "Likeness | None" = None
    fillings: tuple[Filling, ...] = ()

    @property
    def origin(self) -> NDArray[np.intp]:
        """The first of its design's chambers that is like each but for the phase, shape (design, chamber)."""
        assert self.likeness is not None
        return self.likeness.origin

    def volume(self, angle: Array) -> Coefficient:
        """Volume of every chamber at φ [rad], and its derivatives, shape (design, chamber, n). [m³, m³/rad, m³/rad²]"""
        return self.volume_by(slider_motion(self.pistons, angle))

    def volume_by(self, slider: Coefficient) -> Coefficient:
        """Volume of every chamber, as `volume` gives it, from the pistons' distances from their shafts."""
        summed = self.chambers.summed
        return Coefficient(self.start + summed(self.tops - slider.value), summed(-slider.first), summed(-slider.second))

    def volume_of(self, design: int, place: int, angle: Array) -> Coefficient:
        """Volume of one chamber of one design at φ [rad], shape (n,), and its derivatives. [m³, m³/rad, m³/rad²]"""
        areas = self.chambers.areas[design, :, place]
        value, first, second = (np.zeros(angle.shape) for _part in range(3))
        for piston in np.flatnonzero(areas).tolist():
            slider = self.pistons.alone(design, piston, angle).slider
            value = value + areas[piston] * (self.tops[design, piston] - slider.value[0])
            first = first - areas[piston] * slider.first[0]
            second = second - areas[piston] * slider.second[0]
        return Coefficient(self.start[design, place] + value, first, second)

    def pressure(self, angle: Array, volume: Coefficient) -> Array:
        """Absolute pressure in every chamber at φ [rad], where its volume is known, shape (design, chamber, n). [Pa]"""
        found = np.empty(volume.value.shape)
        for filling, state in self._states(angle, volume):
            found[:, filling.places] = filling.fluid.pressure(state, filling.ready)
        return found

    def pressure_and_slope(self, angle: Array, volume: Coefficient) -> Array:
        """`pressure`, and its derivative by φ, which has nothing of jumps, (2, design, chamber, n). [Pa, Pa/rad]"""
        found = np.empty((2, *volume.value.shape))
        for filling, state in self._states(angle, volume):
            own, fluid = filling.places, filling.fluid
            found[0][:, own] = pressure = fluid.pressure(state, filling.ready)
            found[1][:, own] = fluid.slope(state, pressure, volume.first[:, own], filling.ready)
        return found

    def _states(self, angle: Array, volume: Coefficient) -> Iterator[tuple[Filling, ChamberState]]:
        """State of the chambers of each table."""
        state = chamber_state(volume, self.limits, angle - self.firing, np.array(self.cycle))
        for filling in self.fillings:
            # One table mostly fills all chambers.
            if filling.places.size == len(self.chambers.names):
                yield filling, state
                continue
            parts = (np.broadcast_to(part, volume.value.shape)[:, filling.places] for part in state)
            yield filling, ChamberState(*parts)

    def pressure_of(self, design: int, place: int, angle: Array, volume: Coefficient) -> Array:
        """Absolute pressure in one chamber of one design, angles since its nominal firing, shape (n,). [Pa]"""
        limits = VolumeLimits(*(single(float(part[design, place, 0])) for part in self.limits))
        state = chamber_state(volume, limits, angle, single(self.cycle))
        filling = next(one for one in self.fillings if place in one.places)
        return filling.fluid.pressure(state, filling.of_chamber(design, place))

    def filled_with(self, kind: str) -> list[Filling]:
        """Fillings with the fluid of that name."""
        return [one for one in self.fillings if one.fluid.name == kind]

    def by_chamber(self, found: Iterable[tuple[Filling, Array]]) -> Array:
        """What some fillings have, of shape (design, own chamber), for every chamber: NaN of the others."""
        whole = np.full(self.firing.shape[:2], np.nan)
        for filling, own in found:
            whole[:, filling.places] = own
        return whole

    def dead_centres(self, travel: CylinderTravel) -> tuple[Array, Array]:
        """φ of every chamber's least volume at its firing, and of its greatest, shape (design, chamber). [rad]"""
        of, is_head = self.chambers.cylinder, self.chambers.is_head
        least = np.where(is_head, travel.inner[:, of], travel.outer[:, of])
        turns = 2 * np.pi * np.rint((self.firing[..., 0] - least) / (2 * np.pi))
        return least + turns, np.where(is_head, travel.outer[:, of], travel.inner[:, of])

    @cached_property
    def alike(self) -> list[tuple[int, NDArray[np.intp]]]:
        """Designs, and chambers of each that are alike but for their phase, together."""
        return [(i, np.flatnonzero(own == first)) for i, own in enumerate(self.origin) for first in np.unique(own)]

    @cached_property
    def distinct(self) -> list[int]:
        """Chambers that stand for all others which are like them, of any design."""
        return np.unique(self.origin).tolist()

    @cached_property
    def among_distinct(self) -> NDArray[np.intp]:
        """Which of the distinct chambers stands for each, shape (design, chamber)."""
        return np.asarray(np.searchsorted(self.distinct, self.origin), dtype=np.intp)

    def at_own(self, angle: Array, places: Sequence[int], values: Callable[[Array], Array]) -> Array:
        """Values of some chambers, each at its own angles φ.

        Parameters
        ----------
        angle : Array, shape (design, place, k). [rad]
        places : sequence of int
            Which chambers.
        values : callable
            From angles of shape (design, 1, n) to values of all chambers, shape (..., design, chamber, n).

        Returns
        -------
        Array, shape (..., design, place, k)
        """
        n_designs, n_places, n_angles = angle.shape
        found = values(angle.reshape(n_designs, 1, -1))
        apart = found.reshape(*found.shape[:-1], n_places, n_angles)
        return apart[..., list(places), np.arange(n_places), :]

    def force(self, pressure: Array) -> Array:
        """Force of the gas less the ambient pressure on every piston, toward its shaft, (design, piston, n). [N]"""
        return self.chambers.pushed(pressure - self.chambers.ambient[..., np.newaxis])


@record
class Likeness:
    """Which chambers go through the same volumes with the same gas, each from its own firing; found when it is asked.

    Attributes
    ----------
    gas : GasInChambers
        Before anything fills them.
    table : array of int, shape (chamber,)
        Which table fills each.
    """

    gas: GasInChambers
    table: NDArray[np.intp]

    @cached_property
    def origin(self) -> NDArray[np.intp]:
        """The first chamber of each design with the same table, volumes and ambient, shape (design, chamber)."""
        gas, every = self.gas, range(len(self.table))
        then = gas.at_own(gas.firing + _TELLING, every, lambda angle: gas.volume(angle).value)
        seen = np.concatenate([*gas.limits, then], axis=-1)
        place = 10.0 ** (_DIGITS - 1 - np.floor(np.log10(np.abs(seen))))
        rounded = np.rint(seen * place) / place
        is_same = np.all(rounded[:, :, np.newaxis] == rounded[:, np.newaxis], axis=-1)
        ambient = gas.chambers.ambient
        is_same &= ambient[:, :, np.newaxis] == ambient[:, np.newaxis]
        return np.argmax(is_same & (self.table[:, np.newaxis] == self.table), axis=-1)

    def among(self, places: NDArray[np.intp]) -> NDArray[np.intp]:
        """Which of some chambers each of them is like, shape (design, place)."""
        return np.searchsorted(places, self.origin[:, places])


def gas_in_chambers(
    gas: DeclaredGas,
    cycle: Cycle,
    pistons: Pistons,
    chambers: Chambers,
    dead_centres: DeadCentres,
    travel: CylinderTravel,
    volumes: ChamberVolumes,
    swept: SweptVolumes,
    crank_angle: CrankAngle,
    cylinders: CylinderPistons,
    firing: Firing | None,
    speed: Speed | None,
) -> GasInChambers:
    """Fill the chambers as the file says; a cycle of what does not fire begins at the tops.

    Notes
    -----
    Which stroke and turn it is docs/theory/gas, eqs. (14.1) and (14.2) say; the pressure is each fluid's own.
    """
    _refuse_chambers_without_room(chambers, volumes)
    of = chambers.cylinder
    tops = (
        pistons.nominal_top[:, cylinders.leading, 0]
        if firing is None
        else firing.firing_angle + crank_angle.zero[..., 0]
    )
    nominal = tops[:, of] + np.where(chambers.is_head, 0.0, np.pi)
    smallest = np.where(chambers.is_head, travel.least[:, of], -travel.stroke[:, of])
    empty = GasInChambers(
        pistons=pistons,
        chambers=chambers,
        limits=VolumeLimits(
            volumes.clearance_volume[..., np.newaxis], (volumes.clearance_volume + swept.swept_volume)[..., np.newaxis]
        ),
        start=(volumes.clearance_volume - chambers.area * smallest)[..., np.newaxis],
        tops=dead_centres.top_position[..., np.newaxis],
        firing=nominal[..., np.newaxis],
        cycle=cycle.length,
    )
    likeness = Likeness(empty, gas.table)
    _least, bottom = empty.dead_centres(travel)
    fillings = tuple(_filled(likeness, gas, bottom, None if speed is None else speed.mean))
    notes = [note for one in fillings for note in one.fluid.notes(one.ready)]
    flags = [flag for table in gas.tables for flag in table.flags]
    return replace(empty, likeness=likeness, fillings=fillings, flags=tuple(dict.fromkeys((*flags, *notes))))


def can_be_filled(gas: DeclaredGas | None, cycle: Cycle | None, order: FiringOrder | None) -> bool | str:
    """Say whether the file has what it takes: for cylinders that fire, their order."""
    fires = gas is None or gas.fires
    return FiringOrder.needs if fires and (cycle is None or cycle.fires) and order is None else True


def _filled(likeness: Likeness, declared: DeclaredGas, bottom: Array, speed: Array | None) -> Iterator[Filling]:
    """Fill the chambers table by table, those of one fluid together; `bottom`: φ of greatest volumes."""
    rooms = [
        _rooms(likeness, one, np.flatnonzero(declared.table == i), bottom, speed)
        for i, one in enumerate(declared.tables)
    ]
    for fluid in dict.fromkeys(one.fluid for one in declared.tables):
        own = [i for i, one in enumerate(declared.tables) if one.fluid is fluid]
        found = fluid.together([declared.tables[i].numbers for i in own], [rooms[i] for i in own])
        for i, numbers in zip(own, found, strict=True):
            places = np.flatnonzero(declared.table == i)
            yield Filling(fluid, places, rooms[i], fluid.prepared(numbers, rooms[i]))


def _rooms(likeness: Likeness, table: GasTable, places: NDArray[np.intp], bottom: Array, speed: Array | None) -> Rooms:
    """The chambers of one table, as its fluid asks for them."""
    gas = likeness.gas
    after = np.mod(bottom - gas.firing[..., 0], 2 * np.pi)
    return Rooms(
        path=table.path,
        cycle=gas.cycle,
        limits=VolumeLimits(*(part[:, places] for part in gas.limits)),
        area=gas.chambers.area[:, places, np.newaxis],
        bottoms=np.stack([after - 2 * np.pi, after], axis=-1)[:, places],
        alike=partial(likeness.among, places),
        speed=speed if table.fluid.goes_by_time else None,
        volume_of=partial(_volume_from_firing, gas, places),
    )


def _volume_from_firing(
    gas: GasInChambers, places: NDArray[np.intp], design: int, own: int, angle: Array
) -> Coefficient:
    """Volume of one of some chambers, of one design, at angles since its nominal firing [rad]; as `volume_of`."""
    place = int(places[own])
    return gas.volume_of(design, place, angle + gas.firing[design, place])


def _refuse_chambers_without_room(chambers: Chambers, volumes: ChamberVolumes) -> None:
    """Refuse chambers that the deck of the first one leaves no room: no gas can be in them."""
    short = np.flatnonzero(np.any(volumes.clearance_volume <= 0, axis=0)).tolist()
    if short:
        allowed = _("leaves no room over {chambers}, whose pistons reach beyond the first one's deck")
        repair = _("give these a compression_ratio of their own, such as [cylinder.{name}], or check their dimensions")
        names = ranged(chambers.names, short)
        bank = chambers.banks[short[0]] or chambers.names[short[0]]
        problem = Problem("cylinder.compression_ratio", None, allowed.format(chambers=names), repair.format(name=bank))
        raise InputError([problem])
