"""How far a kernel is from the exact motion, in units of what rounding excuses."""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.motion import Coefficient

Array = NDArray[np.float64]

_AT_ONCE = 200  # machines; more would leave the cache


class Disagreement(NamedTuple):
    """The worst of one quantity: error over what is allowed, and where."""

    excess: float
    quantity: str
    machine: int
    angle: float
    error_of_peak: float
    margin: float


def allowance(margin: Array) -> Array:
    """Allowed error as a share of the quantity's peak.

    A hundred roundings; and where a length's relative change of `margin` opens the links, a rounding of that length
    changes the result by 1/margin roundings: four and a half of them.
    """
    return np.maximum(2e-14, 5e-16 / margin)


def flattened(motion: NamedTuple, path: str = "") -> Iterator[tuple[str, Coefficient | Array]]:
    """Every coefficient (and cosine or sine) of a kernel's result, by its dotted name."""
    for name, value in motion._asdict().items():
        if isinstance(value, Coefficient) or not hasattr(value, "_asdict"):
            yield path + name, value
        else:
            yield from flattened(value, f"{path}{name}.")


def _orders(name: str, coefficient: Coefficient | Array) -> Iterator[tuple[str, Array]]:
    """Value and derivatives, as far as the kernel gives them: a link's cosine and sine come alone."""
    if isinstance(coefficient, Coefficient):
        for order, values in coefficient._asdict().items():
            yield f"{name}.{order}", np.asarray(values)
    else:
        yield f"{name}.value", np.asarray(coefficient)


def quantities(motion: NamedTuple, wanted: set[str]) -> dict[str, Array]:
    """The wanted coefficients of a kernel's result, taken apart."""
    return {
        key: values
        for name, coefficient in flattened(motion)
        if name in wanted
        for key, values in _orders(name, coefficient)
    }


def _turn_apart(difference: Array) -> Array:
    return (difference + np.pi) % (2 * np.pi) - np.pi


def rows(geometry: NamedTuple, which: slice) -> NamedTuple:
    """Some of the machines."""
    parts = [rows(field, which) if isinstance(field, tuple) else field[which] for field in geometry]
    return type(geometry)(*parts) if hasattr(geometry, "_fields") else tuple(parts)


def cycle_peaks(kernel: Callable[..., NamedTuple], geometry: NamedTuple, n: int, wanted: set[str]) -> dict[str, Array]:
    """Largest size of each quantity over 720 angles of the turn, (n, 1)."""
    turn = np.arange(720) * (2 * np.pi / 720)
    parts = [
        {
            key: np.abs(values).max(axis=-1, keepdims=True)
            for key, values in quantities(kernel(turn, rows(geometry, slice(at, at + _AT_ONCE))), wanted).items()
        }
        for at in range(0, n, _AT_ONCE)
    ]
    return {key: np.concatenate([part[key] for part in parts]) for key in parts[0]}


def disagreements(
    kernel: Callable[..., NamedTuple],
    geometry: NamedTuple,
    angle: Array,
    exact: dict[str, Coefficient],
    margin: Array,
) -> list[Disagreement]:
    """Worst error of each quantity over all machines and angles, the worst quantity first."""
    wanted = set(exact)
    found = quantities(kernel(angle, geometry), wanted)
    missing = wanted - {key.rsplit(".", 1)[0] for key in found}
    if missing:
        raise KeyError(f"the kernel does not give {sorted(missing)}")
    peaks = cycle_peaks(kernel, geometry, len(margin), wanted)
    worst: list[Disagreement] = []
    for name, coefficient in exact.items():
        for order, expected in coefficient._asdict().items():
            key = f"{name}.{order}"
            if key not in found:
                continue
            error = found[key] - expected
            if key.endswith("angle.value"):
                error = _turn_apart(error)
            of_peak = np.abs(error) / peaks[key]
            excess = np.where(np.isfinite(of_peak), of_peak / allowance(margin), np.inf)
            at = np.unravel_index(np.argmax(excess), excess.shape)
            worst.append(
                Disagreement(
                    float(excess[at]), key, int(at[0]), float(angle[at]), float(of_peak[at]), float(margin[at[0], 0])
                )
            )
    return sorted(worst, reverse=True)


def assert_exact(
    kernel: Callable[..., NamedTuple],
    geometry: NamedTuple,
    angle: Array,
    exact: dict[str, Coefficient],
    margin: Array,
) -> None:
    """Assert that every quantity of the kernel is exact to rounding; name the worst where it is not."""
    failed = [d for d in disagreements(kernel, geometry, angle, exact, margin) if not d.excess <= 1]
    assert not failed, "beyond the allowance:\n" + "\n".join(
        f"{d.quantity}: {d.excess:.2f} times; machine {d.machine} (margin {d.margin:.3g}) at {d.angle:.6f} rad, "
        f"{d.error_of_peak:.3g} of the peak"
        for d in failed
    )
