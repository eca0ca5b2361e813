"""What is found of a mechanism alone, again and again: of one that stands as it stood it is found once.

Machines that come from one another by `with_` share it, as they do what stages gave; one that was never changed keeps
nothing.
"""

from collections.abc import Callable
from typing import Any, Concatenate, ParamSpec, TypeVar, cast, final

import numpy as np

from cranktrain.analysis.outcomes import read_only
from cranktrain.layout.places import PlacedMechanism
from cranktrain.machine import Machine
from cranktrain.motion import Array
from cranktrain.numerics.sameness import is_same

Found = TypeVar("Found")
Given = ParamSpec("Given")

_MOST = 64
"""Of what is kept: mechanisms that a page draws, each at some grids."""


def found_again(
    machine: Machine,
    find: Callable[Concatenate[PlacedMechanism, Given], Found],
    place: PlacedMechanism,
    *given: Given.args,
    **named: Given.kwargs,
) -> Found:
    """Give what is found of a mechanism and of what is given beside, without finding it again where that is the same.

    Parameters
    ----------
    machine : Machine
    find : callable
        Reads nothing else.
    place : PlacedMechanism
    *given, **named
        Arrays and records of these.

    Returns
    -------
    object
        Whose arrays cannot be written to, where it is kept.
    """
    if "alike" not in vars(machine):
        return find(place, *given, **named)
    kept: _Kept = machine.alike.setdefault(_Kept, _Kept())
    return kept.found(find, place, *given, **named)


@final
class _Kept:
    """The last that functions found of each mechanism at so many angles. Threads may ask together."""

    def __init__(self) -> None:
        self._last: dict[object, tuple[object, Any]] = {}

    def __reduce__(self) -> "tuple[type[_Kept], tuple[()]]":
        """Leave all behind where machines are sent or copied."""
        return (_Kept, ())

    def found(
        self,
        find: Callable[Concatenate[PlacedMechanism, Given], Found],
        place: PlacedMechanism,
        *given: Given.args,
        **named: Given.kwargs,
    ) -> Found:
        """Give what was found, if all is the same to the last bit; else find it."""
        what = (find, place.name, tuple(map(_shape, given)))
        known = self._last.pop(what, None)
        if known is None or not is_same(known[0], (place, given, named)):
            found = find(place, *given, **named)
            read_only(found)
            known = (place, tuple(map(_own, given)), named), found
        self._last[what] = known
        for old in list(self._last)[:-_MOST]:
            self._last.pop(old, None)
        return known[1]


def _shape(value: object) -> tuple[int, ...] | None:
    """Shape of an array; None of anything else."""
    return cast("Array", value).shape if isinstance(value, np.ndarray) else None


def _own(value: object) -> object:
    """Give what nobody else writes to: a copy of an array; anything else as it is."""
    return cast("Array", value).copy() if isinstance(value, np.ndarray) else value
