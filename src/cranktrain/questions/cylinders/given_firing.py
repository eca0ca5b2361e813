"""Firing angles that the file gives: put to the cylinders, and held against where the crank pins stand."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.motion import Array
from cranktrain.numerics.designs import by_design
from cranktrain.quantities import Given
from cranktrain.questions.cylinders.firing import FiringOrder, within_turn
from cranktrain.questions.cylinders.spec import CylindersSpec
from cranktrain.wording import number

_WRITTEN = np.radians(0.02)
"""An angle may be written to so many digits: 51.43 for 360/7. It says which turn; the crank pins say the rest. [rad]"""
_PATH = "cylinder.firing_angles"


def given_firing(
    common: CylindersSpec, leading: Sequence[PlacedMechanism], cycle: float, *, zero: Array, astern: bool
) -> tuple[FiringOrder | None, tuple[Problem, ...]]:
    """Read at which crank angles the cylinders fire.

    Parameters
    ----------
    common : CylindersSpec
        With `firing_angles`, which count as crank angles are shown, ahead.
    leading : sequence of PlacedMechanism
        Of each cylinder, the piston along whose axis the crank lies at nominal firing.
    cycle : float
        2π or 4π. [rad]
    zero : Array
        φ where the shown crank angle is 0. [rad]
    astern : bool
        The same metal at −φ: the angles count the other way.

    Returns
    -------
    FiringOrder or None, tuple of Problem
        No order where a cylinder has no angle, or one at which its crank does not lie along it.
    """
    names = [place.cylinder for place in leading]
    given, problems = _by_cylinder(common, names)
    if problems:
        return None, problems
    sense = -1.0 if astern else 1.0
    fires = [sense * angle.array + zero for _key, angle in given]
    tops_of = [place.nominal_top for place in leading]
    asked, tops = (by_design(each, max(map(np.size, (*fires, *tops_of)))) for each in (fires, tops_of))
    turns = np.rint((asked - tops) / (2 * np.pi))
    angles = within_turn(tops + 2 * np.pi * turns, cycle)
    off = np.abs(asked - tops - 2 * np.pi * turns) > _WRITTEN
    if np.any(off):
        possible = [
            np.sort(within_turn(sense * (top - zero) + 2 * np.pi * np.arange(round(cycle / (2 * np.pi))), cycle))
            for top in tops[0]
        ]
        allowed = _("must be where the crank lies along the cylinder: {angles}")
        return None, tuple(
            Problem(
                f"{_PATH}{key}",
                angle.text,
                allowed.format(angles=_(" or ").join(number(float(one), "deg") for one in where)),
            )
            for (key, angle), where, is_off in zip(given, possible, off[0], strict=True)
            if is_off
        )
    order: NDArray[np.intp] = np.argsort(angles[0], kind="stable")
    in_order: list[str] = [names[i] for i in order.tolist()]
    return FiringOrder(order, common.makers_numbers(in_order), angles), ()


def _by_cylinder(common: CylindersSpec, names: Sequence[str]) -> tuple[list[tuple[str, Given]], tuple[Problem, ...]]:
    """Give every cylinder its angle, with the path below the table; problems where it has none, or two."""
    angles = common.firing_angles or ()
    if not isinstance(angles, Mapping):
        if len(angles) == len(names):
            return [(f"[{i}]", angle) for i, angle in enumerate(angles)], ()
        allowed = _("must be one angle for each cylinder: {cylinders}").format(cylinders=", ".join(names))
        return [], (Problem(_PATH, _("a list of {n}").format(n=len(angles)), allowed),)
    meant = [(common.numbers.get(key, key), key, angle) for key, angle in angles.items()]
    allowed = _("must be a cylinder of this machine, each once: {cylinders}").format(cylinders=", ".join(names))
    named = [name for name, _key, _angle in meant]
    wrong = [
        Problem(f"{_PATH}.{key}", angle.text, allowed)
        for i, (name, key, angle) in enumerate(meant)
        if name not in names or name in named[:i]
    ]
    left_out = [name for name in names if name not in named]
    if left_out and not wrong:
        missing = _("must have an angle for each cylinder; left out: {names}").format(names=", ".join(left_out))
        wrong = [Problem(_PATH, None, missing)]
    found = {name: (f".{key}", angle) for name, key, angle in meant}
    return [found[name] for name in names if name in found], tuple(wrong)
