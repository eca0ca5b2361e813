"""Gas in the chambers: pressure over the cycle by the declared model, its work, and its force on every piston."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import cached_property
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.checks import StageResult
from cranktrain.errors import InputError, Problem
from cranktrain.gas import AnyGasKind, Chamber, GasSpec, VolumeLimits, chamber_state, kind_of
from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Pistons
from cranktrain.motion import Array, Coefficient, single
from cranktrain.questions.cylinders.firing import Cycle, Firing
from cranktrain.questions.cylinders.travel import CylinderPistons, CylinderTravel
from cranktrain.questions.cylinders.volumes import Chambers, ChamberVolumes, SweptVolumes
from cranktrain.questions.motion.dead_centres import DeadCentres, slider_motion
from cranktrain.record import record
from cranktrain.wording import ranged

AMBIENT = 101325.0
"""Pressure under the pistons. [Pa]"""
_TELLING = np.array([0.0, 0.6, 1.7, 3.9])


@record
class DeclaredGas:
    """The gas model of every design, as its file declares it."""

    needs: ClassVar[str] = N_("[gas]")

    specs: tuple[GasSpec, ...]


class Shared(NamedTuple):
    """A model by its kind and table, and the chambers of one design that have it: they differ in their phase alone."""

    design: int
    kind: AnyGasKind
    spec: GasSpec
    model: object
    places: list[int]


@record
class GasInChambers(StageResult):
    """The gas model of every chamber, to be asked at any crank angle.

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
    shared : tuple of Shared
        Models of all designs.
    """

    pistons: Pistons
    chambers: Chambers
    limits: VolumeLimits
    start: Array
    tops: Array
    firing: Array
    cycle: float
    shared: tuple[Shared, ...]

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
        state = chamber_state(volume, self.limits, angle - self.firing, np.array(self.cycle))
        found = np.empty(volume.value.shape)
        for one in self.shared:
            own = type(state)(*(_rows(part, one.design, one.places) for part in state))
            found[one.design, one.places] = one.kind.pressure(own, one.model)
        return found

    def dead_centres(self, travel: CylinderTravel) -> tuple[Array, Array]:
        """φ of every chamber's least volume at its firing, and of its greatest, shape (design, chamber). [rad]"""
        of, is_head = self.chambers.cylinder, self.chambers.is_head
        least = np.where(is_head, travel.inner[:, of], travel.outer[:, of])
        turns = 2 * np.pi * np.rint((self.firing[..., 0] - least) / (2 * np.pi))
        return least + turns, np.where(is_head, travel.outer[:, of], travel.inner[:, of])

    def limits_of(self, design: int, place: int) -> VolumeLimits:
        """Volume limits of one chamber of one design."""
        return VolumeLimits(*(single(float(part[design, place, 0])) for part in self.limits))

    @cached_property
    def distinct(self) -> list[int]:
        """Chambers that stand for all others of their design which share their model."""
        return sorted({one.places[0] for one in self.shared})

    @cached_property
    def origin(self) -> NDArray[np.intp]:
        """Which of the distinct chambers stands for each, shape (design, chamber)."""
        found = np.empty(self.firing.shape[:2], dtype=np.intp)
        for one in self.shared:
            found[one.design, one.places] = self.distinct.index(one.places[0])
        return found

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
        areas = self.chambers.areas
        return self.chambers.pushed(pressure) - AMBIENT * np.sum(areas, axis=-1, keepdims=True)


def _rows(part: Array, design: int, places: list[int]) -> Array:
    """Some chambers' values of a state's part, which may stand for all."""
    if part.ndim < 3:
        return part
    of_design = part[min(design, part.shape[0] - 1)]
    return of_design if len(of_design) == 1 else of_design[places]


def gas_in_chambers(
    gas: DeclaredGas,
    cycle: Cycle,
    pistons: Pistons,
    cylinders: CylinderPistons,
    chambers: Chambers,
    dead_centres: DeadCentres,
    travel: CylinderTravel,
    volumes: ChamberVolumes,
    swept: SweptVolumes,
    crank_angle: CrankAngle,
    firing: Firing,
) -> GasInChambers:
    """Make each chamber's model out of the file."""
    _refuse_chambers_without_room(chambers, volumes)
    of = chambers.cylinder
    nominal = firing.firing_angle[:, of] + crank_angle.zero[..., 0] + np.where(chambers.is_head, 0.0, np.pi)
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
        shared=(),
    )
    ratios = _central_ratios(pistons, cylinders)[:, of]
    # What the volume is at some angles after firing tells a chamber from those that are not like it.
    every = range(len(chambers.names))
    volumes_then = empty.at_own(empty.firing + _TELLING, every, lambda angle: empty.volume(angle).value)
    shared = [
        one
        for design, spec in enumerate(gas.specs)
        for one in _models(spec, empty, design, volumes_then[design], ratios[design])
    ]
    flags = [flag for one in shared for flag in one.kind.flags(one.spec, one.model)]
    return replace(empty, shared=tuple(shared), flags=tuple(dict.fromkeys(flags)))


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


def _central_ratios(pistons: Pistons, cylinders: CylinderPistons) -> Array:
    """λ of every cylinder with a single central slider-crank, shape (design, cylinder); NaN for others."""
    ratio = np.full(pistons.nominal_top.shape[:2], np.nan)
    for batch in pistons.batches:
        if batch.kind.name == "slider_crank":
            size = batch.members.geometry
            ratio[:, batch.index] = np.where(size.offset == 0.0, size.crank_radius / size.rod_length, np.nan)[..., 0]
    return np.where(cylinders.is_opposed, np.nan, ratio[:, cylinders.leading])


def _models(spec: GasSpec, chambers: GasInChambers, design: int, volumes: Array, ratios: Array) -> Iterable[Shared]:
    """Models of one design's chambers; those that are alike but for their phase share one.

    By their limits and volumes at some angles, (chamber, n) [m³], they are told apart; λ of central ones, (chamber,).
    """
    kind = kind_of(spec)
    made: dict[tuple[float, ...], Shared] = {}
    for place in range(len(chambers.chambers.names)):
        limits = chambers.limits_of(design, place)
        start = float(chambers.firing[design, place, 0])

        def volume(angle: Array, start: float = start, place: int = place) -> Array:
            return chambers.volume_of(design, place, angle + start).value

        key = tuple(float(f"{float(value):.9g}") for value in (*limits, *volumes[place]))
        if key not in made:
            ratio = float(ratios[place])
            chamber = Chamber(chambers.cycle, limits, volume, None if np.isnan(ratio) else ratio)
            made[key] = Shared(design, kind, spec, _model(kind, spec, chamber), [])
        made[key].places.append(place)
    return made.values()


def _model(kind: AnyGasKind, spec: GasSpec, chamber: Chamber) -> object:
    """Make one chamber's model; what does not suit it is wrong in [gas]."""
    try:
        return kind.model(spec, chamber)
    except InputError as error:
        raise InputError(
            replace(problem, path=f"gas.{problem.path}".removesuffix(".")) for problem in error.problems
        ) from None
