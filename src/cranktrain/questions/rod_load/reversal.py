"""Reversal: for how many degrees rod loads press and pull, by the angles at which they pass nothing."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle, within
from cranktrain.layout.mechanisms import Pistons
from cranktrain.motion import Array
from cranktrain.numerics.harmonics import TURN
from cranktrain.numerics.ties import first_largest
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.rod_load.declared import DeclaredRodLoads
from cranktrain.questions.rod_load.loads import CROSSHEAD_PIN, PLACES, RodLoadCurves, RodLoads
from cranktrain.questions.wear.cycle_points import CyclePoints
from cranktrain.questions.wear.side_changes import SignChanges, sign_changes
from cranktrain.record import record
from cranktrain.references import CONVENTIONS
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import DEFINITION, quantity
from cranktrain.saying.checks import Flagged
from cranktrain.saying.wording import number, ranged

_FACT = ("rod_load_place", "piston")
_SAME = 1e-9
"""Roots that differ by less stand at one place of their turns. [rad]"""


class _Arcs(NamedTuple):
    """Of one load: degrees in compression and in tension, the longest piece of each, and the tension's two ends."""

    compression: float = np.nan
    tension: float = np.nan
    longest_compression: float = np.nan
    longest_tension: float = np.nan
    tension_begins: float = np.nan
    tension_ends: float = np.nan


@record
class Reversals(Flagged):
    """For how long, and by how much, rod loads reverse."""

    compression_arc: Array = quantity(
        "α_c", "deg", _FACT, N_("Crank travel over which the rod load is compression, in a cycle"), _THEORY, "13.57"
    )
    tension_arc: Array = quantity(
        "α_t", "deg", _FACT, N_("Crank travel over which the rod load is tension, in a cycle"), _THEORY, "13.57"
    )
    longest_compression_arc: Array = quantity(
        "α_c,1", "deg", _FACT, N_("Longest crank travel over which the rod load stays compression"), _THEORY, "13.57"
    )
    longest_tension_arc: Array = quantity(
        "α_t,1", "deg", _FACT, N_("Longest crank travel over which the rod load stays tension"), _THEORY, "13.57"
    )
    tension_begins: Array = quantity(
        "φ_t", "deg", _FACT, N_("Crank angle at which the longest tension begins"), _THEORY, "13.57", is_place=True
    )
    tension_ends: Array = quantity(
        "φ_c", "deg", _FACT, N_("Crank angle at which the longest tension ends"), _THEORY, "13.57", is_place=True
    )
    reversal_arc: Array = quantity(
        "α_r",
        "deg",
        _FACT,
        N_("Shorter of both crank travels, in compression and in tension"),
        _THEORY,
        "13.57",
        worst="smallest",
    )
    reversal_share: Array = quantity(
        "r",
        "1",
        _FACT,
        N_("Smaller of the largest compression and tension over the larger"),
        _THEORY,
        "13.57",
        worst="smallest",
    )
    wanted_reversal_arc: Array = quantity(
        "α_w", "deg", (), N_("Crank travel of either sense from which on a load reverses"), CONVENTIONS, DEFINITION
    )
    wanted_reversal_share: Array = quantity(
        "r_w", "1", (), N_("Share of the larger peak from which on a load reverses"), CONVENTIONS, DEFINITION
    )


def reversals(
    pistons: Pistons,
    declared: DeclaredRodLoads,
    curves: RodLoadCurves,
    loads: RodLoads,
    points: CyclePoints,
    loaded: LoadedMachine,
    crank_angle: CrankAngle,
) -> Reversals:
    """Degrees of compression and tension, as roots between the points of a cycle; docs/theory/forces, eq. (13.57)."""
    arcs = np.full((len(_Arcs._fields), len(curves.whole), len(PLACES), len(pistons.names)), np.nan)
    n_loads = curves.place.size
    for one in sign_changes(
        curves.rows[:n_loads], lambda solved: curves.pick(tuple(solved))[:, :n_loads], points, loaded
    ):
        zero = float(crank_angle.zero[one.design, 0, 0])
        arcs[:, one.design, curves.place[one.curve], curves.piston[one.curve]] = _arcs(one, points.cycle, zero)
    compression, tension = loads.largest_rod_compression.value, loads.largest_rod_tension.value
    larger = np.maximum(compression, tension)
    arc = np.minimum(arcs[0], arcs[1])
    share = np.minimum(compression, tension) / np.where(larger > 0, larger, np.nan)
    is_short = arc[:, CROSSHEAD_PIN] < declared.least_arc[:, np.newaxis]
    is_small = share[:, CROSSHEAD_PIN] < declared.least_share[:, np.newaxis]
    return Reversals(
        *arcs,
        reversal_arc=arc,
        reversal_share=share,
        wanted_reversal_arc=declared.least_arc,
        wanted_reversal_share=declared.least_share,
        flags=tuple(_flags(pistons.names, is_short | is_small, declared)),
    )


def _flags(names: Sequence[str], is_lacking: NDArray[np.bool_], declared: DeclaredRodLoads) -> Iterator[Words]:
    """Flag crosshead pins whose load does not reverse for long enough, or not by enough."""
    lacking = np.flatnonzero(np.any(is_lacking, axis=0)).tolist()
    if lacking:
        yield _(
            "The load on the crosshead pin of {pistons} does not reverse as wanted, for {arc} of either sense and by "
            "{share} of the larger: oil cannot come between pin and bearing.",
            pistons=ranged(names, lacking),
            arc=number(float(declared.least_arc[0]), "deg"),
            share=number(float(declared.least_share[0]), "%"),
        )


def _repeats(of: SignChanges) -> bool:
    """Whether the second turn of two is like the first."""
    n_turn, odd = divmod(of.angle.size, 2)
    if odd:
        return False
    late = of.angle[n_turn:] - of.angle[:n_turn] - TURN
    return bool(np.all(np.abs(late) < _SAME) and np.all(of.sign[n_turn:] == of.sign[: of.sign.size - n_turn]))


def _first_half(of: SignChanges) -> SignChanges:
    """The first turn of two that are alike; what nowhere changes its sign has one sign in both."""
    n_turn = of.angle.size // 2
    return of._replace(angle=of.angle[:n_turn], sign=of.sign[:n_turn]) if n_turn else of


def _arcs(of: SignChanges, cycle: float, zero: float) -> _Arcs:
    """Arcs between roots; angles as they are shown. Where the load is nothing on a way, that is of neither.

    Of a load that is the same in both turns of a cycle, for whatever else the machine has two, one turn counts.
    """
    if cycle > TURN and _repeats(of):
        of, cycle = _first_half(of), TURN
    if not of.angle.size:
        whole = (cycle, 0.0) if of.sign[0] > 0 else (0.0, cycle)
        return _Arcs(*whole, *whole)
    length = np.diff(np.append(of.angle, of.angle[0] + cycle))
    pressing, pulling = (np.where(own, length, 0.0) for own in (of.sign > 0, of.sign < 0))
    longest = first_largest(pulling)
    begins = float(of.angle[longest]) - zero
    return _Arcs(
        float(np.sum(pressing)),
        float(np.sum(pulling)),
        float(np.max(pressing)),
        float(np.max(pulling)),
        *within(np.array([begins, begins + length[longest]]), cycle).tolist(),
    )
