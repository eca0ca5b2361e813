"""What several have, put and gathered where it acts, as that of the cylinders on each throw."""

from itertools import pairwise
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Number = TypeVar("Number", np.float64, np.complex128)


def gathered(values: NDArray[Number], place: NDArray[np.intp], n_places: int) -> NDArray[Number]:
    """Sum at each place what is there.

    Parameters
    ----------
    values : array, shape (..., one, n)
        Real or complex.
    place : integer array, shape (one,)
        Index of the place of each.
    n_places : int

    Returns
    -------
    array, shape (..., place, n)
        0 where nothing is. What is NaN stays at its own place.

    Examples
    --------
    >>> gathered(np.array([[1.0], [2.0], [4.0]]), np.array([0, 1, 0]), 2)
    array([[5.],
           [2.]])
    """
    found = np.zeros((*values.shape[:-2], n_places, values.shape[-1]), values.dtype)
    # Ones and zeros times the values say the same, but a matrix product of this size calls up threads, which then spin.
    for one, there in enumerate(place.tolist()):
        found[..., there, :] += values[..., one, :]
    return found


def in_even_steps(places: list[int]) -> list[int] | slice:
    """Give places that follow one another in even steps as a slice: what stands there is taken in less time.

    Examples
    --------
    >>> in_even_steps([2, 5, 8]), in_even_steps([2, 5, 7])
    (slice(2, 9, 3), [2, 5, 7])
    """
    steps = {after - before for before, after in pairwise(places)} or {1}
    is_even = len(places) > 0 and len(steps) == 1 and min(steps) > 0
    return slice(places[0], places[-1] + 1, min(steps)) if is_even else places
