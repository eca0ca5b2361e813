"""A mechanism of the package as a machine for the equation of motion."""

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple, cast

from cranktrain.linkage import compiled
from cranktrain.linkage.forces import Body, Gravity, reduced_of
from cranktrain.mechanisms.kind import Kind
from cranktrain.transient.equation import Machine


class OutputLoad(NamedTuple):
    """Load on the slider [N] or link [N·m] that a mechanism drives.

    Attributes
    ----------
    along : float
        Positive in the sense of the coordinate; the same whichever way it moves: weight, spring.
    dry : float
        Against the motion, whatever the speed; never below 0.
    viscous : float
        Against the motion, for each unit of speed. [N·s/m, N·m·s]
    """

    along: float
    dry: float
    viscous: float


class Mechanism(NamedTuple):
    """Numbers of a mechanism with its load."""

    geometry: Any
    bodies: tuple[Body, ...]
    load: OutputLoad
    gravity: Gravity


def of_slider(motion: Any) -> Any:
    """How the slider moves by the crank angle."""
    return motion.slider.first


def of_rocker(motion: Any) -> Any:
    """How the rocker moves by the crank angle."""
    return motion.rocker.angle.first


@cache
def machine_of(kind: Kind[Any, Any], is_compiled: bool = True) -> Machine:
    """Give a kind's inertia, load and output as the equation of motion asks for them; its numbers are a `Mechanism`.

    docs/theory/transient, eq. (26.9). Compiled, every kind but a chain; plain, of numbers, it is slow.
    """
    own = kind.dynamics
    output_of = of_slider if kind.output.is_slider else of_rocker
    parts: tuple[Any, ...] = (kind.motion, output_of, own.load, own.links, reduced_of)
    if not is_compiled:
        return _joined(*parts)
    import numba

    made: Any = numba.njit(error_model="numpy", nogil=True)(_joined(*(compiled(part) for part in parts)))
    return cast(Machine, made)


def _joined(
    motion_at: Callable[..., Any],
    output_of: Callable[..., Any],
    load_of: Callable[..., Any],
    links_of: Callable[..., Any],
    reduced_by: Callable[..., Any],
) -> Machine:
    def at(angle: float, speed: float, sense: float, numbers: Any) -> tuple[float, float, float, float]:
        motion = motion_at(angle, numbers.geometry)
        output = output_of(motion)
        way = output * sense
        rubbing = numbers.load.dry if way < 0 else -numbers.load.dry if way > 0 else 0.0
        load = numbers.load.along + rubbing - numbers.load.viscous * output * speed
        loads = load_of(motion, numbers.geometry, load)
        inertia, torque = reduced_by(links_of(motion, numbers.geometry), numbers.bodies, loads, numbers.gravity)
        return inertia.value, inertia.first, -torque, output

    return at
