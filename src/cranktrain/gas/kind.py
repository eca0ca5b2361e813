"""What every kind of gas model gives: its spec, what it makes of it for a chamber, and the pressure by the state."""

from collections.abc import Callable
from typing import Any, Generic, NamedTuple, TypeAlias, TypeVar

from cranktrain.gas.state import ChamberState, VolumeLimits
from cranktrain.gas.work import MeanPressures
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.spec import Spec


class GasSpec(Spec, frozen=True):
    """What every gas model of a machine file declares."""

    kind: str


class Chamber(NamedTuple):
    """A working chamber as a gas model asks for it.

    Attributes
    ----------
    cycle : float
        2π of a two-stroke, 4π of a four-stroke. [rad]
    limits : VolumeLimits
        Floats. [m³]
    volume : callable
        From crank angles since nominal firing, shape (n,) [rad], to volumes of that shape [m³].
    ratio : float, optional
        λ, crank radius to rod length, of central slider-cranks.
    """

    cycle: float
    limits: VolumeLimits
    volume: Callable[[Array], Array]
    ratio: float | None = None


class Kink(NamedTuple):
    """Where the pressure has a kink away from the dead centres.

    Attributes
    ----------
    volume : Array
        [m³]
    sense, turn : float
        On which branch, as in `ChamberState`: +1 where the volume grows; +1 in the working turn.
    """

    volume: Array
    sense: float
    turn: float


_Table = TypeVar("_Table", bound=GasSpec)
_Model = TypeVar("_Model")


@record
class GasKind(Generic[_Table, _Model]):
    """A kind of gas model, as data.

    Attributes
    ----------
    name, title : str
        Name in the machine file; title for people.
    spec : type of GasSpec
        Its table of the machine file.
    model : callable (spec, chamber) → parameters or Diagram
        What `pressure` takes. Raises `InputError`, paths relative to the table, where it does not suit the chamber.
    pressure : callable (ChamberState, model) → Array
        Absolute pressure at each crank angle, of the state's shape. [Pa]
    flags : callable (spec, model) → tuple of str
        What may be meant otherwise than it was given, and what was found in a file and changed, as sentences.
    example : str
        A commented `[gas]` table to start from.
    mean_pressures : callable (model, compression ratio) → MeanPressures, optional
        In closed form, where there is one.
    kinks : callable (model, VolumeLimits) → tuple of Kink
        Where the pressure is not smooth, beside the dead centres: quadrature stops there. Nowhere unless given.
    work : callable (model, volume slope) → float, optional
        ∮ p dV of a model that goes through samples, exactly; takes dV/dφ at angles since nominal firing. [J]
    breaks : callable (model) → Array, shape (n,), optional
        Of a model that goes through samples: crank angles since nominal firing, rising in [0, cycle), between which the
        pressure is smooth; a jump stands there once. [rad]
    """

    name: str
    title: str
    spec: type[_Table]
    model: Callable[[_Table, Chamber], _Model]
    pressure: Callable[[ChamberState, _Model], Array]
    flags: Callable[[_Table, _Model], tuple[str, ...]]
    example: str
    mean_pressures: Callable[[_Model, Array], MeanPressures] | None = None
    kinks: Callable[[_Model, VolumeLimits], tuple[Kink, ...]] = lambda model, limits: ()
    work: Callable[[_Model, Callable[[Array], Array]], float] | None = None
    breaks: Callable[[_Model], Array] | None = None


AnyGasKind: TypeAlias = GasKind[Any, Any]
"""A kind that is known only when it runs."""
