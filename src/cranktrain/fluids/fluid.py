"""What every fluid gives: its table of the machine file, its numbers, and from these the pressure in a chamber."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, ClassVar, Generic, NamedTuple, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import Problem
from cranktrain.fluids.state import ChamberState, VolumeLimits
from cranktrain.folders import member_named
from cranktrain.language import Words
from cranktrain.motion import Array, Coefficient
from cranktrain.paths import path_text
from cranktrain.record import record
from cranktrain.spec import Spec


class FluidSpec(Spec, frozen=True):
    """What every fluid of a machine file declares."""

    elsewhere: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(("epsilon", "ε", "compression_ratio"), "[cylinder] compression_ratio"),
        "clearance": "[cylinder] clearance",
    }
    kinds_elsewhere: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(("steam", "card", "trace", "measured"), 'kind = "indicator"'),
        **dict.fromkeys(("petrol", "gasoline", "spark"), 'kind = "otto"'),
        **dict.fromkeys(("air", "gas"), 'kind = "compressor"'),
        **dict.fromkeys(("sabathe", "mixed", "seiliger"), 'kind = "dual"'),
    }

    kind: str


def table_path(name: str) -> str:
    """Path of the table of that name, `[gas.NAME]`."""
    return path_text(("gas", name))


class Rooms(NamedTuple):
    """The chambers that one table fills, in all designs, as its fluid asks for them.

    Attributes
    ----------
    path : str
        Of the table in the machine file.
    cycle : float
        2π of a two-stroke, 4π of a four-stroke. [rad]
    limits : VolumeLimits, fields of shape (design, chamber, 1)
    area : Array, shape (design, chamber, 1)
        Of one end of the chamber. [m²]
    bottoms : Array, shape (design, chamber, 2)
        Where the volume is largest before nominal firing and after, from there. [rad]
    alike : callable
        Gives the first chamber that goes through the same volumes as each, from its own nominal firing, shape
        (design, chamber).
    speed : Array, shape (design, 1, 1), optional
        Mean speed of the shaft, where the file says it and the fluid goes by time. [rad/s]
    volume_of : callable
        From a design, a chamber and angles since its nominal firing, shape (n,), to its volume, shape (n,).
    """

    path: str
    cycle: float
    limits: VolumeLimits
    area: Array
    bottoms: Array
    alike: Callable[[], NDArray[np.intp]]
    speed: Array | None
    volume_of: Callable[[int, int, Array], Coefficient]

    def volume(self, angle: Array) -> Coefficient:
        """Volume of every chamber, each at its own angles since nominal firing, shape (design, chamber, k)."""
        found: Array = np.empty((3, *angle.shape))
        for design, place in np.ndindex(*angle.shape[:2]):
            found[:, design, place] = self.volume_of(design, place, angle[design, place])
        return Coefficient(found[0], found[1], found[2])

    @property
    def compression_ratio(self) -> Array:
        """Largest volume over smallest, shape (design, chamber, 1)."""
        return self.limits.largest / self.limits.smallest

    @property
    def swept_volume(self) -> Array:
        """Largest volume less the smallest, shape (design, chamber, 1). [m³]"""
        return self.limits.largest - self.limits.smallest

    @property
    def n_turns(self) -> int:
        """Turns of a cycle: 2 where one of them is for gas exchange."""
        return round(self.cycle / (2 * np.pi))


class Kink(NamedTuple):
    """Where the pressure has a kink away from the dead centres.

    Attributes
    ----------
    volume : Array, broadcastable to (design, chamber, 1)
        NaN where it has none. [m³]
    sense, turn : float
        On which branch, as in `ChamberState`: +1 where the volume grows; +1 in the working turn.
    called : str
        What happens there, where results say when it does: a key of `GasEvents.named`.
    """

    volume: Array
    sense: float
    turn: float
    called: str = ""


_Table = TypeVar("_Table", bound=FluidSpec)
_Numbers = TypeVar("_Numbers", bound=tuple[object, ...])
_Ready = TypeVar("_Ready", bound=tuple[object, ...])


@record
class Fluid(Generic[_Table, _Numbers, _Ready]):
    """A kind of fluid, as data.

    It is of one of three forms, by what `prepared` makes of its numbers: nothing, where the pressure is a closed
    function of the volume and its branch; a curve over the cycle, made with the volume at hand; or numbers that
    chambers which share a medium find together.

    Attributes
    ----------
    name, title : str
        Name in the machine file; title for people.
    spec : type of FluidSpec
        Its table of the machine file.
    numbers : callable (spec) → NamedTuple of numbers or objects
        In SI; of several designs together, arrays of shape (design,).
    prepared : callable (numbers, Rooms) → NamedTuple of arrays
        What `pressure` takes, each of shape (design, chamber, …), of numbers of shape (design, 1, 1). Raises
        `InputError` where they do not suit the chambers.
    pressure : callable (ChamberState, prepared) → Array
        Absolute pressure at each crank angle, of the state's shape; of one chamber of one design too. [Pa]
    slope : callable (ChamberState, p, V′, prepared) → Array
        Derivative of the pressure by the crank angle, where it does not jump, for the pressure itself and the volume's
        derivative. [Pa/rad; Pa, m³/rad]
    work : callable (prepared, Rooms) → Array, shape (design, chamber)
        ∮ p dV over a cycle, exactly. [J]
    example : str
        A commented `[gas]` table to start from.
    flags : callable (spec) → tuple of Words
        What may be meant otherwise than it was given, as sentences.
    problems : callable (mapping of path to spec) → Problems
        What all tables of this fluid show to be wrong only together.
    together : callable (sequence of numbers, sequence of Rooms) → sequence of numbers
        What chambers that share a medium find together: of all tables of this fluid, before `prepared`.
    fires : bool
        Whether its cylinders fire: it takes a cycle and a firing order. Otherwise every turn is one cycle.
    goes_by_time : bool
        Whether its pressure hangs on the speed of the shaft.
    notes : callable (prepared) → tuple of Words
        What was found beside: in a file, or with the chambers at hand.
    kinks : callable (prepared, VolumeLimits) → tuple of Kink
        Where the pressure is not smooth, beside the dead centres: quadrature stops there.
    breaks : callable (prepared) → Array, shape (design, chamber, k)
        The same as crank angles since nominal firing, rising in [0, cycle); NaN fills up. [rad]
    """

    name: str
    title: str
    spec: type[_Table]
    numbers: Callable[[_Table], _Numbers]
    prepared: Callable[[_Numbers, Rooms], _Ready]
    pressure: Callable[[ChamberState, _Ready], Array]
    slope: Callable[[ChamberState, Array, Array, _Ready], Array]
    work: Callable[[_Ready, Rooms], Array]
    example: str
    flags: Callable[[_Table], tuple[Words, ...]] = lambda spec: ()
    problems: Callable[[Mapping[str, _Table]], Iterable[Problem]] = lambda tables: ()
    together: Callable[[Sequence[_Numbers], Sequence[Rooms]], Sequence[_Numbers]] = lambda numbers, rooms: numbers
    fires: bool = True
    goes_by_time: bool = False
    notes: Callable[[_Ready], tuple[Words, ...]] = lambda prepared: ()
    kinks: Callable[[_Ready, VolumeLimits], tuple[Kink, ...]] = lambda prepared, limits: ()
    breaks: Callable[[_Ready], Array] | None = None

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[str, ...]]:
        """Give what finds it again by its name."""
        return member_named, ("cranktrain.fluids", "KIND", self.name)


AnyFluid: TypeAlias = Fluid[Any, Any, Any]
"""A fluid that is known only when it runs."""
