"""Where loads change sides, of pins along their links and of guides across them, and play is taken up with a knock."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle, within
from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots
from cranktrain.numerics.subintervals import Subintervals, interpolation, leggauss
from cranktrain.questions.forces.events import ForceEvents
from cranktrain.questions.forces.joint_forces import joints_of
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.forces.solved_cycle import Member, force_size, mechanisms_of, parts_of
from cranktrain.questions.wear.cycle_points import CyclePoints, cycle_points
from cranktrain.record import record
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import StageResult

_ASIDE = 1e-4
"""How far beside a root its curve's slope is taken. [rad]"""
_NOTHING = 1e-12
"""Of the largest; what is smaller may be of either sign."""
_MOST = 12
"""So many angles of a cycle are told: a guide's load changes sides at dead centres, and where gas and inertia part."""
_ENDS: Array = np.array([-1.0, 1.0])
"""Ways at which a panel begins and ends."""
_ACROSS = ("guide", "slot")
"""Roles of joints whose load counts across their link."""

Pick = Callable[[Sequence[SolvedBatch]], Array]
"""Gives some curves, shape (design, curve, …), of a machine that is solved at any angles."""


class SignChanges(NamedTuple):
    """Of a curve of a design: where it changes its sign, φ, rising, and which it has after each; 0 where it is nothing.

    Of one that nowhere does, no angle and its own sign.
    """

    design: int
    curve: int
    angle: Array
    sign: Array

    @property
    def sides(self) -> Array:
        """Where it has come to the other side, φ: of a way on which it is nothing the end."""
        acts = np.flatnonzero(self.sign)
        return self.angle[acts[self.sign[acts] != np.roll(self.sign[acts], 1)]] if self.angle.size else self.angle


def sign_changes(
    rows: NDArray[np.intp], pick: Pick, points: CyclePoints, loaded: LoadedMachine, gross: Array | None = None
) -> list[SignChanges]:
    """Find where curves of forces change their signs in a cycle.

    Parameters
    ----------
    rows : array of int, shape (curve,)
        Of which mechanism each is.
    pick : callable
    points : CyclePoints
    loaded : LoadedMachine
    gross : Array, shape (design, curve), optional
        What is rounding beside it is nothing; the curve's own peak unless given.

    Returns
    -------
    list of SignChanges
        None of a curve that is nothing all round.
    """
    values = pick(points.solved)
    found = [
        one
        for design, cut in enumerate(points.cuts)
        for one in _of_design(design, cut, values[design, :, : cut.angle.size], gross)
    ]
    return _refined(found, rows, pick, points, loaded)


def _of_design(design: int, cut: Subintervals, values: Array, gross: Array | None) -> Iterator[SignChanges]:
    """Sign changes of the curves of one design, by the polynomials of panels; over whole panels it may be nothing."""
    sampled, n_panels = _sampled(cut, values), cut.size.size
    whole = np.max(np.abs(sampled.value), axis=-1) if gross is None else gross[design]
    edges = np.append(cut.start, cut.start[0])
    for curve, own in enumerate(sampled.value):
        clear = np.flatnonzero(np.abs(own) > _NOTHING * whole[curve])
        if clear.size == 0:
            continue
        after = np.roll(clear, -1)
        signs, panels = np.sign(own[clear]), sampled.panel[clear]
        signs_after, panels_after = np.roll(signs, -1), np.roll(panels, -1)
        ahead = panels_after - panels
        ahead[-1] += n_panels
        is_nothing = ahead > 1
        crosses = np.flatnonzero(~is_nothing & (signs != signs_after))
        crossings = _crossings(cut, sampled, curve, clear[crosses], after[crosses])
        angle = np.concatenate([edges[panels[is_nothing] + 1], edges[panels_after[is_nothing]], crossings])
        sign = np.concatenate([np.zeros(np.count_nonzero(is_nothing)), signs_after[is_nothing], signs_after[crosses]])
        order = np.argsort(angle, kind="stable")
        yield SignChanges(design, curve, angle[order], sign[order] if order.size else signs[:1])


class _Sampled(NamedTuple):
    """Curves at the points of panels and at both their ends, shape (curve, sample); of which panel, at which way."""

    value: Array
    panel: NDArray[np.intp]
    way: Array


def _sampled(cut: Subintervals, values: Array) -> _Sampled:
    """Take curves at the points of their panels, and by the polynomial through these at the ends."""
    found: list[Array] = []
    ways: list[Array] = []
    for first, size in zip(cut.first.tolist(), cut.size.tolist(), strict=True):
        own = values[:, first : first + size]
        first_end, last_end = np.moveaxis(np.sum(interpolation(_ENDS, size) * own[:, np.newaxis], axis=-1), -1, 0)
        found.append(np.column_stack([first_end, own, last_end]))
        nodes, _weight = leggauss(size)
        ways.append(np.concatenate((_ENDS[:1], nodes, _ENDS[1:])))
    return _Sampled(
        np.concatenate(found, axis=-1), np.repeat(np.arange(cut.size.size), cut.size + 2), np.concatenate(ways)
    )


def _crossings(cut: Subintervals, of: _Sampled, curve: int, low: NDArray[np.intp], high: NDArray[np.intp]) -> Array:
    """Where a curve passes nothing between two samples: by their panel's polynomial, or at the edge between panels."""
    panel = of.panel[high]
    angle = cut.start[panel]
    is_within = of.panel[low] == panel
    for size in set(cut.size[panel[is_within]].tolist()):
        own = np.flatnonzero(is_within & (cut.size[panel] == size))
        # A panel's samples begin with its edge.
        first = cut.first[panel[own]] + 2 * panel[own] + 1
        values = of.value[curve, first[:, np.newaxis] + np.arange(size)]
        root = bracketed_roots(
            lambda way, values=values: np.sum(interpolation(way, values.shape[-1]) * values, axis=-1),
            of.way[low[own]],
            of.way[high[own]],
        )
        angle[own] += 0.5 * cut.width[panel[own]] * (1.0 + root)
    return angle


def _refined(
    found: list[SignChanges], rows: NDArray[np.intp], pick: Pick, points: CyclePoints, loaded: LoadedMachine
) -> list[SignChanges]:
    """Correct each root by the curve itself, as the polynomial's digits are those of its peak; at an edge it stays."""
    sizes = [one.angle.size for one in found]
    if not sum(sizes):
        return found
    which = np.repeat(np.array([one.design * rows.size + one.curve for one in found]), sizes)
    edges = [np.append(cut.start, cut.start[0] + points.cycle) for cut in points.cuts]
    reach = np.concatenate(
        [np.min(np.abs(one.angle[:, np.newaxis] - edges[one.design]), axis=-1, initial=np.inf) for one in found]
    )
    root = np.concatenate([one.angle for one in found])
    beside = np.minimum(_ASIDE, 0.5 * reach)[:, np.newaxis] * np.array([-1.0, 0.0, 1.0])
    value = loaded.of_each(rows, which, root[:, np.newaxis] + beside, lambda own: pick(loaded.solved(own)))
    slope = (value[:, 2] - value[:, 0]) / np.where(reach > 0, beside[:, 2] - beside[:, 0], 1.0)
    step = np.where((reach > 0) & (slope != 0), -value[:, 1] / np.where(slope != 0, slope, 1.0), 0.0)
    root = root + np.where(np.abs(step) <= beside[:, 2], step, 0.0)
    each = np.split(root, np.cumsum(sizes)[:-1])
    return [one._replace(angle=own) for one, own in zip(found, each, strict=True)]


@record
class SideChanges(StageResult):
    """At which crank angles the loads of pins and guides change sides."""

    side_changes: Array = quantity(
        "n_k",
        "1",
        ("joint",),
        N_("How often in a cycle the joint's load changes sides, along its link or across its guide"),
        _THEORY,
        "13.58",
    )
    side_change_at: Array = quantity(
        "φ_k",
        "deg",
        ("joint", "side_change"),
        N_("Crank angle at which the joint's load changes sides, the first twelve in a cycle"),
        _THEORY,
        "13.58",
        is_place=True,
    )


def side_changes(
    loaded: LoadedMachine, events: ForceEvents, crank_angle: CrankAngle, of_wear: CyclePoints | None
) -> SideChanges:
    """Roots of the loads along links and across guides, between the points of a cycle; docs/theory/forces, (13.58).

    Those of wear, where there are crank pins.
    """
    points = cycle_points(loaded, events, crank_angle) if of_wear is None else of_wear
    joints = joints_of(loaded)
    parts = parts_of(joints, points.solved, lambda batch, place: points.solved[batch].forces.joints[place][:2])
    gross = np.max(force_size(*parts), axis=-1)
    found = sign_changes(mechanisms_of(joints), partial(_sides, loaded, joints), points, loaded, gross)
    n_designs = len(points.angle)
    often = np.full((n_designs, len(joints)), np.nan)
    angles = np.full((n_designs, len(joints), _MOST), np.nan)
    for one in found:
        zero = float(crank_angle.zero[one.design, 0, 0])
        often[one.design, one.curve] = one.sides.size
        shown = np.sort(within(one.sides - zero, points.cycle))[:_MOST]
        angles[one.design, one.curve, : shown.size] = shown
    names = tuple(joint.name for joint in joints)
    return SideChanges(often, angles, labels={"joint": names, "side_change": tuple(str(i + 1) for i in range(_MOST))})


def _sides(loaded: LoadedMachine, joints: Sequence[Member], solved: Sequence[SolvedBatch]) -> Array:
    """Load of each joint along the link on which it acts, of guides and slots across it."""

    def side(place: int, number: int) -> tuple[Array]:
        batch, one = loaded.mechanisms.batches[place], solved[place]
        dynamics = batch.kind.dynamics
        reaction, wrench = dynamics.reactions[number], one.forces.joints[number]
        link = dynamics.by_link(dynamics.links(one.motion, batch.members.geometry))[reaction.on]
        if reaction.role in _ACROSS:
            return (link.cos * wrench.y - link.sin * wrench.x,)
        return (link.cos * wrench.x + link.sin * wrench.y,)

    return parts_of(joints, solved, side)[0]
