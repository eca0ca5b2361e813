"""How far the sources' forms are off over a turn, of each sort of drawn pistons that of which they miss most."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cranktrain.analysis import Result
from cranktrain.grouping import grouped
from cranktrain.language import N_, _
from cranktrain.motion import Array
from cranktrain.numerics.ties import largest_of
from cranktrain.panels.design import OneDesign
from cranktrain.panels.plotted import role_at
from cranktrain.panels.shapes import Curve, Panel
from cranktrain.plans.placement import first_throw
from cranktrain.texts.ranges import RANGES

_MOTIONS = {
    "s": ("displacement_by_method", N_("Error of displacement, {piston}, in parts of the stroke"), "x"),
    "v": ("velocity_coefficient_by_method", N_("Error of velocity, {piston}, in parts of the largest"), "v"),
    "j": ("acceleration_coefficient_by_method", N_("Error of acceleration, {piston}, in parts of the largest"), "j"),
}
"""By the letter of a quantity: the curves by each method, the title of their errors, and its symbol."""

_FARTHER = 8.0
"""A form that is off by so many times as much as another has panels of its own."""


class _Off(NamedTuple):
    """A form, and how far it is off over the turn, shape (3, n). [1]"""

    method: str
    errors: Array


def textbook_error_panels(result: Result) -> Iterator[tuple[Panel, ...]]:
    """Collect errors of the sources' forms of motion.

    Parameters
    ----------
    result : Result
        Of one machine, with its motion.

    Yields
    ------
    tuple of Panel
        Of forms that are off about as far, over the crank angle; of a form that stands alone all three in one.
    """
    shown = OneDesign(result, 0)
    if not shown.has("displacement_by_method"):
        return
    methods = result.labels["motion_method"]
    largest = shown("acceleration_error")
    names = [place.name for place in first_throw(result.machines[0]) if place.name in result.labels["piston"]]
    members = {name: shown.member("piston", name) for name in names}
    spoken_of = {name: tuple(_forms_of(largest[:, member])) for name, member in members.items()}
    for forms, sort in grouped((forms, name) for name, forms in spoken_of.items() if forms).items():
        worst = largest_of(sort, lambda name, forms=forms: float(np.max(largest[list(forms), members[name]])))
        in_order = sorted(forms, key=lambda form: float(largest[form, members[worst]]))
        for lot in _lots(in_order, [float(largest[form, members[worst]]) for form in in_order]):
            yield tuple(_panels(shown, worst, [methods[form] for form in lot]))


def _forms_of(largest: Array) -> list[int]:
    """Places of the methods that have an error, but the exact one."""
    return (np.flatnonzero(np.isfinite(largest[1:])) + 1).tolist()


def _lots(forms: Sequence[int], errors: Sequence[float]) -> list[list[int]]:
    """Part forms in the order of their errors where one is off much farther than the first of its lot."""
    lots: list[list[int]] = []
    least = 0.0
    for form, error in zip(forms, errors, strict=True):
        if not lots or error > _FARTHER * least:
            lots.append([])
            least = error
        lots[-1].append(form)
    return lots


def _panels(shown: OneDesign, piston: str, methods: Sequence[str]) -> Iterator[Panel]:
    """Errors of some forms: a panel for each quantity, or one for all of a form."""
    member = shown.member("piston", piston)
    off = [_Off(method, _errors(shown, member, method)) for method in methods]
    angle = np.append(shown.result.crank_angle[: off[0].errors.shape[1] - 1], 360.0)
    names = {one.method: _(one.name) for one in RANGES}
    if len(off) == 1:
        (only,) = off
        title = _("Errors of {form}, {piston}", form=names[only.method], piston=piston)
        curves = (
            Curve(errors, role_at(place), letter, rf"\Delta {symbol}")
            for place, (errors, (letter, (_name, _title, symbol))) in enumerate(
                zip(only.errors, _MOTIONS.items(), strict=True)
            )
        )
        yield Panel(title, "error", angle, tuple(curves))
        return
    for order, (letter, (_curves, title, _symbol)) in enumerate(_MOTIONS.items()):
        each = (Curve(one.errors[order], role_at(at), letter, name=names[one.method]) for at, one in enumerate(off))
        yield Panel(_(title, piston=piston), "error", angle, tuple(each))


def _errors(shown: OneDesign, member: int, method: str) -> Array:
    """Errors of displacement, velocity and acceleration over the turn, closed, shape (3, n). [1]"""
    form = shown.member("motion_method", method)
    n_turn = int(np.count_nonzero(shown.result.crank_angle < 360.0))
    found: list[Array] = []
    for letter, (name, _title, _symbol) in _MOTIONS.items():
        exact, own = (shown(name)[one, member, :n_turn] for one in (0, form))
        size = np.ptp(exact) if letter == "s" else np.max(np.abs(exact))
        errors = (own - exact) / size
        found.append(np.append(errors, errors[0]))
    return np.stack(found)
