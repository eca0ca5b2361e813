"""How two dumps of quantities differ: by numbers, by what there is, and by words."""

import difflib
import json
import re
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

LIMIT, ITERATED_LIMIT = 1e-13, 1e-10
"""How far a number may move, in parts of its quantity's largest member; and one that is found by iteration."""
NO_AMPLITUDE = 1e-9
"""In parts of the largest amplitude: the phase of less is rounding."""
TURNS = {"deg": 360.0, "rad": 2 * np.pi}
ITERATED = re.compile(
    r"closing_(margin|angle)|(crank_(speed|acceleration)|coefficient_of_fluctuation|mean_speed_\w+)"
    r"|(largest|smallest)_crank_speed|wanted_flywheel_moment|flywheel_(inertia|inertia_error|fluctuation)|rim_\w+|\w+_at"
)
"""Names of what is found by iteration: running speed, flywheels and their rims, closing margins, where peaks are."""
AT_RUNNING_SPEED = "running speed"
"""In the name of a run, all of which rests on an iterated speed."""
PHASES = {
    "torque_order_phase": ("torque_order_amplitude",),
    "shaking_force_direction": ("shaking_force_forward", "shaking_force_backward"),
    "shaking_couple_direction": ("shaking_couple_forward", "shaking_couple_backward"),
    "balance_weight_angle": ("balance_weight_moment",),
}
"""Phases and the amplitudes without which they mean nothing; of a crank angle `x_at` that is `x`."""
WORST, MOST_NAMES, MOST_LINES = 10, 20, 12


class Dump(NamedTuple):
    """Arrays by run and quantity; unit and dimensions of each, the texts, and the commit."""

    arrays: Mapping[tuple[str, str], np.ndarray]
    entries: Mapping[tuple[str, str], list[str]]
    texts: Mapping[str, str]
    commit: str = ""


class Moved(NamedTuple):
    """By how much a quantity moved, in parts of its largest member, and how much it may."""

    run: str
    quantity: str
    part: float
    limit: float

    @property
    def share(self):
        """Of what it may."""
        return self.part / self.limit


def read(path):
    """Read a dump."""
    with np.load(path) as file:
        about = json.loads(str(file["about"]))
        arrays = {tuple(name.rsplit("|", 1)): file[name] for name in file.files if name != "about"}
    entries = {(run, name): entry for run, names in about["entries"].items() for name, entry in names.items()}
    return Dump(arrays, entries, about["texts"], about["commit"])


def report(before, after):
    """Say in lines how two dumps differ, and whether a number moved too far or a quantity is lost."""
    both = [name for name in before.arrays if name in after.arrays]
    found = [moved(before, after, *name) for name in both]
    same = sum(np.array_equal(before.arrays[name], after.arrays[name], equal_nan=True) for name in both)
    too_far = [one for one in found if not one.part <= one.limit]
    lost, new = (missing_from(*pair) for pair in ((before, after), (after, before)))
    others = [name for name in both if before.entries[name] != after.entries[name]]
    lines = [
        f"before {before.commit}, after {after.commit}",
        f"{same} of {len(both)} quantities are the same to the last bit",
        f"{len(too_far)} moved by more than {LIMIT:g} of their largest member, or {ITERATED_LIMIT:g} where iterated",
        *(line(one) for one in sorted(found, key=lambda one: -one.share)[:WORST] if one.part > 0),
        *listed("only before", lost),
        *listed("only after", new),
        *listed("other unit or dimensions", [" | ".join(name) for name in others]),
        *words(before.texts, after.texts),
    ]
    return lines, bool(too_far or lost or others)


def line(one):
    return f"  {one.part:8.1e} of {one.limit:g}  {one.quantity}  ({one.run})"


def missing_from(one, other):
    """Name what one dump has and the other has not: runs, and quantities of a run that both have."""
    runs = dict.fromkeys(run for run, _name in one.arrays)
    known = {run for run, _name in other.arrays}
    names = [f"all of {run}" for run in runs if run not in known]
    return names + [" | ".join(key) for key in one.arrays if key[0] in known and key not in other.arrays]


def moved(before, after, run, name):
    """Compare one quantity of one run."""
    is_iterated = ITERATED.fullmatch(name) or AT_RUNNING_SPEED in run
    was, now = (defined(dump.arrays, run, name, before.arrays) for dump in (before, after))
    turn = TURNS.get(before.entries[run, name][0])
    return Moved(run, name, difference(was, now, turn), ITERATED_LIMIT if is_iterated else LIMIT)


def defined(arrays, run, name, measures):
    """Give a quantity, with NaN for phases whose amplitude in `measures` is as good as none."""
    values = arrays[run, name]
    amplitudes = PHASES.get(name, (name.removesuffix("_at"),) if name.endswith("_at") else ())
    for amplitude in amplitudes:
        size = np.abs(measures.get((run, amplitude), np.ones(values.shape)))
        if size.shape == values.shape and size.size:
            values = np.where(size < NO_AMPLITUDE * np.max(size, initial=0.0, where=np.isfinite(size)), np.nan, values)
    return values


def difference(was, now, turn=None):
    """Largest difference of two arrays in parts of the largest member; infinite where only one has a number.

    Parameters
    ----------
    was, now : ndarray
    turn : float, optional
        What angles may differ by and be the same.
    """
    is_finite = np.isfinite(was)
    if was.shape != now.shape or not np.array_equal(was[~is_finite], now[~is_finite], equal_nan=True):
        return np.inf
    apart = now[is_finite] - was[is_finite]
    if turn is not None:
        apart = apart - turn * np.round(apart / turn)
    most = np.max(np.abs(apart), initial=0.0)
    return 0.0 if most == 0 else np.divide(most, np.max(np.abs(was[is_finite])))


def listed(head, names):
    """Give a head and so many names."""
    left = [f"  and {len(names) - MOST_NAMES} more"] if len(names) > MOST_NAMES else []
    return [f"{head}: {len(names)}", *(f"  {name}" for name in names[:MOST_NAMES]), *left] if names else []


def words(before, after):
    """Say which texts differ, alike differences once, with the first lines of each."""
    alike = {}
    for name in before.keys() | after.keys():
        alike.setdefault(changes(before.get(name, ""), after.get(name, "")), []).append(name)
    same = alike.pop((), [])
    lines = [f"{len(same)} of {len(before.keys() | after.keys())} texts are the same"]
    for changed, names in sorted(alike.items(), key=lambda item: (-len(item[1]), min(item[1]))):
        first, *others = sorted(names)
        lines += [
            f"{first}{f' and {len(others)} more' if others else ''}",
            *(f"  {one}" for one in changed[:MOST_LINES]),
        ]
    return lines


def changes(before, after):
    """Give the lines that differ, with their signs."""
    if before == after:
        return ()
    found = difflib.unified_diff(before.splitlines(), after.splitlines(), n=0, lineterm="")
    return tuple(one for one in found if not one.startswith(("---", "+++", "@@"))) or ("  in line ends alone",)
