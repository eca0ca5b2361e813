"""Volumes: what each chamber sweeps, holds and compresses; V = V₀ + Σ A x with a signed area for each piston."""

from collections.abc import Iterator
from functools import cached_property
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, Words, _
from cranktrain.motion import Array
from cranktrain.questions.cylinders.travel import CylinderTravel
from cranktrain.questions.motion.pistons import PistonMotion
from cranktrain.record import record
from cranktrain.references import THEORY_OF_GAS as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Flagged, Limit, flagged
from cranktrain.saying.wording import ranged

_CHAMBER = ("chamber",)
ATMOSPHERE = 101325.0
"""Pressure under pistons, and on piston rods, where the file says none. [Pa]"""


@record
class Chambers:
    """The working chambers.

    Attributes
    ----------
    names : tuple of str
        `1L`, or `1L.head` and `1L.crank` of a double-acting cylinder.
    banks : tuple of str
        Bank of each.
    cylinder : array of int, shape (chamber,)
        Which cylinder each is of.
    is_head : array of bool, shape (chamber,)
        Whether it is at the head, or between opposed pistons; otherwise it is on the crank's side.
    areas : Array, shape (design, piston, chamber)
        Signed: a chamber's volume grows by the area for each metre of piston displacement. [m²]
    ambient : Array, shape (design, chamber)
        Absolute pressure on the same piston where no chamber is. [Pa]
    """

    needs: ClassVar[str] = N_("[cylinder] bore")

    names: tuple[str, ...]
    banks: tuple[str, ...]
    cylinder: NDArray[np.intp]
    is_head: NDArray[np.bool_]
    areas: Array
    ambient: Array

    @property
    def labels(self) -> dict[str, tuple[str, ...]]:
        """Names of the chambers, and of their banks."""
        return {"chamber": self.names, "bank": tuple(dict.fromkeys(self.banks))}

    @cached_property
    def area(self) -> Array:
        """Area of each chamber, shape (design, chamber). [m²]"""
        return np.max(np.abs(self.areas), axis=1)

    @property
    def are_double_acting(self) -> bool:
        """Whether any piston works on the crank's side, and so through a piston rod."""
        return not np.all(self.is_head)

    @property
    def leading(self) -> NDArray[np.intp]:
        """A piston of each chamber, shape (chamber,)."""
        return self._own[0][0]

    @cached_property
    def _own(self) -> "_Partners":
        """Pistons of each chamber."""
        return _partners(self.areas)

    @cached_property
    def _pushing(self) -> "_Partners":
        """Chambers of each piston."""
        return _partners(np.swapaxes(self.areas, 1, 2))

    def summed(self, lengths: Array) -> Array:
        """Volume that lengths of travel of its own pistons make, (design, piston, n) to (design, chamber, n). [m³]

        A piston that cannot move all round, NaN, leaves the chambers of others alone.
        """
        return _weighed(self._own, lengths)

    def pushed(self, pressure: Array) -> Array:
        """Force toward its shaft by pressures in its own chambers, (design, chamber, n) to (design, piston, n). [N]"""
        return _weighed(self._pushing, pressure)


_Partners = tuple[tuple[NDArray[np.intp], Array], ...]
"""The first partner of each and its area, shape (design, one, 1), then the second …."""


def _partners(areas: Array) -> _Partners:
    """List what works on each, from areas of shape (design, partner, one); a few of all partners are enough."""
    works: NDArray[np.bool_] = np.any(areas != 0.0, axis=0)
    order: NDArray[np.intp] = np.argsort(~works, axis=0, kind="stable")
    one = np.arange(len(works.T))
    found: list[tuple[NDArray[np.intp], Array]] = []
    for place in range(int(np.max(np.sum(works, axis=0), initial=0))):
        # One that has fewer counts its first again, by no area: what is another's may be NaN.
        partner = order[place].copy()
        idle: NDArray[np.bool_] = ~works[partner, one]
        partner[idle] = order[0, idle]
        area = np.where(idle, 0.0, areas[:, partner, one])
        found.append((partner, area[..., np.newaxis]))
    return tuple(found)


def _weighed(partners: _Partners, values: Array) -> Array:
    """Sum what each's partners have, times their areas."""
    parts = [area * values[:, partner] for partner, area in partners]
    return sum(parts[1:], start=parts[0])


@record
class CompressionRatios:
    """Compression ratio of each chamber, shape (design, chamber); NaN where the deck decides it.

    leader : array of int, shape (chamber,)
        The chamber whose clearance height a chamber without a ratio of its own shares; itself on the crank's side.
    master : array of int, shape (chamber,)
        The chamber of the piston on whose rod its own hangs; itself where that hangs on the crank.
    is_clearance : bool
        Whether the file says the first one by its clearance.
    """

    needs: ClassVar[str] = N_("[cylinder] compression_ratio or clearance")

    value: Array
    leader: NDArray[np.intp]
    master: NDArray[np.intp]
    is_clearance: bool = False


# Compressors have a clearance of 3 % of the swept volume and more: 1 + 1/0.03 = 34.
RATIO = Limit(
    40.0,
    "",
    N_("A compression ratio of {value} is more than engines or compressors have: is its decimal point right?"),
)


@record
class SweptVolumes:
    """What the pistons sweep between their true dead centres."""

    swept_volume: Array = quantity(
        "V_h", "m^3", _CHAMBER, N_("Swept volume of the chamber, by the true stroke"), _THEORY, "14.25"
    )
    bank_swept_volume: Array = quantity("V_b", "m^3", ("bank",), N_("Swept volume of the bank"), _THEORY, "14.25")
    displacement: Array = quantity(
        "V_H", "m^3", (), N_("Swept volume of all chambers"), _THEORY, "14.25", line="Σ {swept_volume}"
    )


def swept_volumes(chambers: Chambers, travel: CylinderTravel) -> SweptVolumes:
    """Swept volumes from piston areas and true strokes, of opposed pistons the combined one."""
    swept = chambers.area * travel.stroke[:, chambers.cylinder]
    banks = tuple(dict.fromkeys(chambers.banks))
    by_bank = [np.sum(swept[:, [of == bank for of in chambers.banks]], axis=1) for bank in banks]
    return SweptVolumes(
        swept_volume=swept, bank_swept_volume=np.stack(by_bank, axis=1), displacement=np.sum(swept, axis=1)
    )


@record
class ChamberVolumes(Flagged):
    """Volume of every chamber, and what is left of it at its smallest.

    Attributes
    ----------
    is_clearance : bool
        Whether the file speaks of clearance, the smallest volume over the swept one, and not of compression ratios.
    """

    chamber_volume: Array = quantity(
        "V", "m^3", ("chamber", "crank_angle"), N_("Volume of the chamber"), _THEORY, "14.25"
    )
    clearance_volume: Array = quantity("V_c", "m^3", _CHAMBER, N_("Smallest volume of the chamber"), _THEORY, "14.25")
    compression_ratio: Array = quantity(
        "ε",
        "1",
        _CHAMBER,
        N_("Geometric compression ratio, largest volume over smallest"),
        _THEORY,
        "14.25",
        line="1 + {swept_volume} / {clearance_volume}",
    )

    is_clearance: bool = False


def chamber_volumes(
    chambers: Chambers, ratios: CompressionRatios, travel: CylinderTravel, swept: SweptVolumes, motion: PistonMotion
) -> ChamberVolumes:
    """Volume of every chamber over the cycle.

    Notes
    -----
    A chamber with a ratio of its own has V_c = V_h/(ε − 1). One without shares deck and chamber with its leader, so
    that its clearance height is c = c_leader + H_leader − H, where H is how far its pistons reach into it, the height
    of the piston pin at its top: the ratios of articulated rods differ by stroke *and* by pin height.
    """
    own = swept.swept_volume / (ratios.value - 1) / chambers.area
    reach = travel.reach[:, chambers.cylinder]
    clearance_height: Array = np.where(
        np.isnan(ratios.value), own[:, ratios.leader] + reach[:, ratios.leader] - reach, own
    )
    clearance = clearance_height * chambers.area
    # A chamber on the shaft's side is smallest where its piston is at the bottom.
    smallest = np.where(chambers.is_head, travel.least[:, chambers.cylinder], -travel.stroke[:, chambers.cylinder])
    start = clearance - chambers.area * smallest
    volume = start[..., np.newaxis] + chambers.summed(motion.piston_displacement.value)
    ratio = 1 + swept.swept_volume / clearance
    return ChamberVolumes(
        chamber_volume=volume,
        clearance_volume=clearance,
        compression_ratio=ratio,
        is_clearance=ratios.is_clearance,
        flags=tuple(_flags(chambers, clearance)),
        unlikely=tuple(flagged(RATIO, ratio)),
    )


def _flags(chambers: Chambers, clearance: Array) -> Iterator[Words]:
    """Flag chambers that a shared deck leaves no room."""
    short = np.flatnonzero(np.any(clearance <= 0, axis=0)).tolist()
    if short:
        said = _(
            "With the first one's deck no room is left over {chambers}: give these a compression_ratio of their own."
        )
        yield said.format(chambers=ranged(chambers.names, short))
