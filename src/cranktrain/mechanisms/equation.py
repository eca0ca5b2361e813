"""The equation of motion of a kind as a function of the crank angle: what a transient integrates."""

from collections.abc import Callable
from functools import cache
from typing import Any, TypeAlias, cast

from cranktrain.linkage import compiled
from cranktrain.linkage.forces import Gravity, Reduced, reduced_of
from cranktrain.mechanisms.kind import Geometry, Kind, Motion
from cranktrain.motion import Array, Link

Equation: TypeAlias = Callable[[Array, Geometry, Any, Array, Gravity], Reduced]
"""From crank angle, geometry, bodies, load on the output and gravity to reduced inertia, its derivative and torque."""


def equation_of_motion(kind: Kind[Motion, Geometry]) -> Equation[Geometry]:
    """Give a kind's equation of motion.

    Parameters
    ----------
    kind : Kind

    Returns
    -------
    function (angle, geometry, bodies, load, gravity) → Reduced
        J, J′ and Q of M = Jε + ½J′ω² − Q at crank angles of shape (..., n); load is a force along the output slider's
        coordinate or a torque on the output link. Without friction. docs/theory/forces, eq. (13.7).
    """
    return _joined(kind.motion, kind.dynamics.load, kind.dynamics.links, reduced_of)


@cache
def compiled_equation(kind: Kind[Motion, Geometry]) -> Equation[Geometry]:
    """Give a kind's equation of motion under Numba, for numbers; every kind but a chain has one.

    Parameters
    ----------
    kind : Kind

    Returns
    -------
    function
        As `equation_of_motion` gives it, to be called from other compiled code too.
    """
    from cranktrain.extras import imported  # only for who compiles

    numba = imported("numba", "compiled")
    own = kind.dynamics
    joined = _joined(compiled(kind.motion), compiled(own.load), compiled(own.links), compiled(reduced_of))
    return cast(Equation[Geometry], numba.njit(error_model="numpy")(joined))


def _joined(
    motion_at: Callable[[Array, Geometry], Motion],
    load_of: Callable[[Motion, Geometry, Array], Any],
    links_of: Callable[[Motion, Geometry], tuple[Link, ...]],
    reduced_by: Callable[[tuple[Link, ...], Any, Any, Gravity], Reduced],
) -> Equation[Geometry]:
    def at(angle: Array, geometry: Geometry, bodies: Any, load: Array, gravity: Gravity) -> Reduced:
        motion = motion_at(angle, geometry)
        return reduced_by(links_of(motion, geometry), bodies, load_of(motion, geometry, load), gravity)

    return at
