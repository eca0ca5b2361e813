"""One step of Tsitouras' method, and the state anywhere within it."""

from collections.abc import Callable
from typing import Any, TypeAlias

from cranktrain.transient.tableau import ERRORS, INTERPOLANT, NODES, WEIGHTS

N_STATE = 6
BESIDE = N_STATE
"""Where in a row a stage may leave what it knows besides its slopes."""
ROW = N_STATE + 1
"""How many numbers of a stage stand in a row.

A place or a kind that is given to a function as a whole number, and not as a product, would have Numba compile that
function anew for each number, and with it all that calls it.
"""

Derive: TypeAlias = Callable[[float, float, float, float, float, Any, int, Any], tuple[float, float]]
"""(x, first, second, sense, bound, slopes, place, parts): writes the slopes of all components from a place on, of which
the first two feed back, and gives these two; NaN where there are none. The bound is of a crank angle."""

(A10,), (A20, A21), (A30, A31, A32), (A40, A41, A42, A43), (A50, A51, A52, A53, A54), LAST = WEIGHTS
B0, B1, B2, B3, B4, B5 = LAST
E0, E1, E2, E3, E4, E5, E6 = ERRORS
_, C1, C2, C3, C4, _, _ = NODES
(_, F2, F3, F4), (_, G2, G3, G4), (_, H2, H3, H4), (_, I2, I3, I4), *_rest = INTERPOLANT
(_, J2, J3, J4), (_, K2, K3, K4), (_, L2, L3, L4) = _rest


def take_step(
    derive: Derive, x: float, width: float, state: Any, slopes: Any, ahead: Any, sense: float, bound: float, parts: Any
) -> None:
    """Go a step from `state`, whose slopes stand first in `slopes`, into `ahead`; slopes of all stages are left there.

    Only the first two components feed back; the others are integrals along the way. Written out: neither Numba nor
    plain Python does loops over so few numbers well.
    """
    y, z = state[0], state[1]
    a, p = slopes[0], slopes[1]
    h = width
    b, q = derive(x + C1 * h, y + h * (A10 * a), z + h * (A10 * p), sense, bound, slopes, 1 * ROW, parts)
    c, r = derive(
        x + C2 * h, y + h * (A20 * a + A21 * b), z + h * (A20 * p + A21 * q), sense, bound, slopes, 2 * ROW, parts
    )
    d, s = derive(
        x + C3 * h,
        y + h * (A30 * a + A31 * b + A32 * c),
        z + h * (A30 * p + A31 * q + A32 * r),
        sense, bound, slopes, 3 * ROW, parts,
    )  # fmt: skip
    e, t = derive(
        x + C4 * h,
        y + h * (A40 * a + A41 * b + A42 * c + A43 * d),
        z + h * (A40 * p + A41 * q + A42 * r + A43 * s),
        sense, bound, slopes, 4 * ROW, parts,
    )  # fmt: skip
    f, u = derive(
        x + h,
        y + h * (A50 * a + A51 * b + A52 * c + A53 * d + A54 * e),
        z + h * (A50 * p + A51 * q + A52 * r + A53 * s + A54 * t),
        sense, bound, slopes, 5 * ROW, parts,
    )  # fmt: skip
    ahead[0] = y + h * (B0 * a + B1 * b + B2 * c + B3 * d + B4 * e + B5 * f)
    ahead[1] = z + h * (B0 * p + B1 * q + B2 * r + B3 * s + B4 * t + B5 * u)
    derive(x + h, ahead[0], ahead[1], sense, bound, slopes, 6 * ROW, parts)


def integrate_along(width: float, state: Any, slopes: Any, ahead: Any) -> None:
    """Put the components that do not feed back into `ahead`, of a step that was taken."""
    for part in range(2, N_STATE):
        ahead[part] = state[part] + width * (
            B0 * slopes[part]
            + B1 * slopes[ROW + part]
            + B2 * slopes[2 * ROW + part]
            + B3 * slopes[3 * ROW + part]
            + B4 * slopes[4 * ROW + part]
            + B5 * slopes[5 * ROW + part]
        )


def error_of(slopes: Any, width: float, part: int) -> float:
    """Estimated error of one component of a step."""
    return abs(
        width
        * (
            E0 * slopes[part]
            + E1 * slopes[ROW + part]
            + E2 * slopes[2 * ROW + part]
            + E3 * slopes[3 * ROW + part]
            + E4 * slopes[4 * ROW + part]
            + E5 * slopes[5 * ROW + part]
            + E6 * slopes[6 * ROW + part]
        )
    )


def within(state: Any, slopes: Any, width: float, theta: float, part: int) -> float:
    """One component of the state at the part θ of a step."""
    x = theta
    total = (
        (1 + x * (F2 + x * (F3 + x * F4))) * slopes[part]
        + x * (G2 + x * (G3 + x * G4)) * slopes[ROW + part]
        + x * (H2 + x * (H3 + x * H4)) * slopes[2 * ROW + part]
        + x * (I2 + x * (I3 + x * I4)) * slopes[3 * ROW + part]
        + x * (J2 + x * (J3 + x * J4)) * slopes[4 * ROW + part]
        + x * (K2 + x * (K3 + x * K4)) * slopes[5 * ROW + part]
        + x * (L2 + x * (L3 + x * L4)) * slopes[6 * ROW + part]
    )
    return state[part] + width * x * total
