"""Groups of a chain that pass change points: found by what carries their ends, and told where they lie in line."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from cranktrain.linkage import Ends, Pin
from cranktrain.linkage.change_point import Hinged, out_of_line
from cranktrain.linkage.vectors import between
from cranktrain.mechanisms.chain.groups import SHAFT, anatomy, carriers_of, pin_of
from cranktrain.mechanisms.chain.kinematics import chain_made
from cranktrain.mechanisms.chain.steps import ChainSize, PinStep, Structure, TriadStep
from cranktrain.mechanisms.change_points import ChangePoints, FourBar, form_of
from cranktrain.mechanisms.dynamics import FRAME
from cranktrain.motion import Array, single
from cranktrain.numerics import bracketed_roots, turn_grid
from cranktrain.numerics.nested import each_changed, leaves

_GRID = turn_grid(72) + 0.01
"""Not at the angles at which a crank lies along an axis, where most change points are."""
_SAME = 1e-9
"""Angles that are nearer to one another are one. [rad]"""


def with_forms(structure: Structure, size: ChainSize, crossed: frozenset[str]) -> Structure:
    """Find the groups that pass change points, and their forms.

    Parameters
    ----------
    structure : Structure
    size : ChainSize, of numbers or arrays of shape (design,)
    crossed : frozenset of str
        Joints of those that are to be crossed.

    Returns
    -------
    Structure
        A group that hangs on a triad passes none.
    """
    for place, step in enumerate(structure.steps):
        if isinstance(step, TriadStep):
            return structure
        if isinstance(step, PinStep):
            found = _through(structure, place, size, crossed=step.joint in crossed)
            structure = structure._replace(steps=(*structure.steps[:place], found, *structure.steps[place + 1 :]))
    return structure


def _through(structure: Structure, place: int, size: ChainSize, *, crossed: bool) -> PinStep:
    """One group with the form in which it passes change points, if it does."""
    step, own = structure.steps[place], size.steps[place]
    assert isinstance(step, PinStep)
    assert isinstance(own, Pin)
    above = _above(structure, place)
    columns = each_changed(lambda value: np.reshape(value, (-1, 1)), size)
    for hinge in _hinges(above, step):
        lengths = _four_bar(above, columns, step._replace(hinge=hinge), own)
        form = form_of(lengths, crossed)
        if form:
            found = step._replace(form=form, hinge=hinge)
            sines = _out_of_line(above, found, _GRID, columns)
            if np.all(np.any(sines < 0, axis=-1) & np.any(sines > 0, axis=-1)):
                return found
    return step


def _hinges(structure: Structure, step: PinStep) -> Iterator[str]:
    """Points in which a body that carries the rod's end is joined to one that carries the rocker's."""
    points: dict[str, set[str]] = {FRAME: {SHAFT, *structure.fixed}}
    # All cranks are one body, on one shaft.
    points[SHAFT] = {SHAFT, *map(pin_of, structure.cranks)}
    carriers = carriers_of(structure)
    for above in structure.steps:
        for joint in anatomy(above).joints:
            if joint.role == "pin":
                points.setdefault(joint.on, set()).add(joint.at)
        for name, made in anatomy(above).made.items():
            if made.carrier:
                points.setdefault(carriers[name], set()).add(name)
    found: set[str] = set()
    for one in points.values():
        for other in points.values():
            if one is not other and step.rod_from in one and step.rocker_from in other:
                found |= (one & other) - {step.rod_from, step.rocker_from}
    yield from sorted(found)


def _four_bar(structure: Structure, size: ChainSize, step: PinStep, own: Pin) -> FourBar:
    """Lengths of the four links of which rod and rocker are two."""
    made = chain_made(structure, single(0.0), size)
    to_driver, to_pivot = (between(made[step.hinge], made[name]) for name in (step.rod_from, step.rocker_from))
    crank, ground = (np.hypot(arm.x, arm.y)[..., 0] for arm in (to_driver, to_pivot))
    return FourBar(crank, own.rod_length, own.rocker_length, ground)


def _out_of_line(structure: Structure, step: PinStep, angle: Array, size: ChainSize) -> Array:
    """Sine of the angle between what carries the ends of a group, at angles of the crank."""
    made = chain_made(structure, angle, size)
    return out_of_line(Hinged(Ends(made[step.rod_from], made[step.rocker_from]), made[step.hinge]))


def chain_change_points(structure: Structure) -> ChangePoints | None:
    """Where groups of a chain lie in line and come through; None where none does."""
    through = [(place, step) for place, step in enumerate(structure.steps) if isinstance(step, PinStep) and step.form]
    if not through:
        return None
    return ChangePoints(
        partial(_in_line, structure),
        f"steps.{through[0][0]}.rod_length",
        {step.joint: step.form for _place, step in through},
    )


def _in_line(structure: Structure, size: ChainSize) -> Array:
    """Angles of the crank at which a group lies in line, shape (..., k), NaN where others have more. [rad]"""
    shape = np.broadcast_shapes((1,), *(np.shape(leaf) for leaf in leaves(size)))
    low = _GRID + np.zeros(shape)
    curves = [
        partial(_out_of_line, _above(structure, place), step, size=size)
        for place, step in enumerate(structure.steps)
        if isinstance(step, PinStep) and step.form
    ]
    roots = [bracketed_roots(curve, low, low + _GRID[1] - _GRID[0]) for curve in curves]
    angles = np.sort(np.mod(np.concatenate(roots, axis=-1) + _SAME, 2 * np.pi) - _SAME, axis=-1)
    # Groups that hang on one another lie in line together.
    is_new = np.diff(angles, axis=-1, prepend=-1.0) > 2 * _SAME
    angles = np.sort(np.where(is_new, angles, np.nan), axis=-1)
    return angles[..., : int(np.max(np.sum(is_new, axis=-1)))]


def _above(structure: Structure, place: int) -> Structure:
    return structure._replace(steps=structure.steps[:place])
