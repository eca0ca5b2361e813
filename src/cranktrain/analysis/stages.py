"""Stages: functions whose parameter types are their needs and whose return type is their gift."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, is_dataclass
from functools import cache
from graphlib import TopologicalSorter
from types import NoneType
from typing import Any, cast, get_args, get_type_hints

import numpy as np

from cranktrain.catalogue import entries
from cranktrain.language import translated
from cranktrain.layout.axial import axial_positions
from cranktrain.mechanisms import KINDS
from cranktrain.questions.balance.frame_forces import frame_forces
from cranktrain.questions.balance.running_frame import running_frame
from cranktrain.questions.balance.shaking import rolling_moment, shaking_couples, shaking_forces
from cranktrain.questions.balance.weights import balance_weights
from cranktrain.questions.cylinders.firing import firing
from cranktrain.questions.cylinders.opposed import combined_motion, combined_speeds, volumetric_dead_centres
from cranktrain.questions.cylinders.ports import effective_compression, port_timing
from cranktrain.questions.cylinders.travel import cylinder_travel
from cranktrain.questions.cylinders.volumes import chamber_volumes, swept_volumes
from cranktrain.questions.doubts import doubts
from cranktrain.questions.evenness.applied_torque import applied_torque
from cranktrain.questions.evenness.flywheel import flywheel_size, rim_size
from cranktrain.questions.evenness.load_curve import load_torque
from cranktrain.questions.evenness.running_speed import flywheel_moment, running_speed, shaft_work
from cranktrain.questions.forces.crank_pins import crank_pin_loads
from cranktrain.questions.forces.events import force_events
from cranktrain.questions.forces.guides import guide_edges
from cranktrain.questions.forces.joint_forces import joint_forces
from cranktrain.questions.forces.largest_forces import largest_forces
from cranktrain.questions.forces.loaded import loaded_machine, mechanism_torques, solved_cycle
from cranktrain.questions.forces.piston_forces import piston_force_set
from cranktrain.questions.forces.rod_methods import rod_methods
from cranktrain.questions.gas.chambers import gas_in_chambers
from cranktrain.questions.gas.events import gas_events
from cranktrain.questions.gas.powers import brake_powers, indicated_powers
from cranktrain.questions.gas.pressures import gas_pressures
from cranktrain.questions.motion.closing import closing
from cranktrain.questions.motion.couplers import coupler_motion, coupler_speeds
from cranktrain.questions.motion.dead_centres import dead_centres, piston_grid, piston_turn
from cranktrain.questions.motion.followed import link_motion, slider_motions
from cranktrain.questions.motion.pistons import piston_motion, piston_speeds
from cranktrain.questions.motion.points import point_motion
from cranktrain.questions.motion.rocker_load import load_motion
from cranktrain.questions.motion.rockers import dead_positions, rocker_motion, rocker_speeds, rocker_turn
from cranktrain.questions.motion.rods import rod_motion, rod_speeds
from cranktrain.questions.torque.orders import phase_star_sums, torque_orders
from cranktrain.questions.torque.rod_orders import rod_orders
from cranktrain.questions.torque.sources import torque_sources
from cranktrain.questions.torque.torques import gear_torques, journal_torques, shaft_torques, torque_peaks
from cranktrain.questions.torque.work_check import work_balance
from cranktrain.questions.torsion.critical import critical_speeds, mode_vector_sums
from cranktrain.questions.torsion.modes import torsional_modes, torsional_train
from cranktrain.record import record
from cranktrain.textbook.comparison import textbook_motion


@record
class Stage:
    """One step of the computation.

    Attributes
    ----------
    function : callable
    needs : mapping of parameter name to type
    optional : set of str
        Parameters that may be None: never reported as missing.
    gives : type
    """

    function: Callable[..., Any]
    needs: dict[str, type]
    optional: frozenset[str]
    gives: type


@dataclass(frozen=True)
class Missing:
    """Results that a machine file does not allow yet: their names, and what the file would have to say."""

    results: tuple[str, ...]
    needs: tuple[str, ...]


def stage(function: Callable[..., Any]) -> Stage:
    """Read a stage's needs and gift from its annotations; a need may be `X | None`."""
    hints = get_type_hints(function)
    gives = hints.pop("return")
    needs: dict[str, type] = {}
    optional: set[str] = set()
    for name, hint in hints.items():
        choices = [choice for choice in get_args(hint) if choice is not NoneType]
        if NoneType in get_args(hint):
            optional.add(name)
            needs[name] = choices[0]
        else:
            needs[name] = hint
    return Stage(function, needs, frozenset(optional), gives)


def ordered(stages: Iterable[Stage]) -> tuple[Stage, ...]:
    """Put stages in an order in which every need comes before its use."""
    return _ordered(tuple(stages))


@cache
def _ordered(stages: tuple[Stage, ...]) -> tuple[Stage, ...]:
    """Put stages in order once, however often they run."""
    by_gift = {one.gives: one for one in stages}
    graph = {one.gives: [need for need in one.needs.values() if need in by_gift] for one in by_gift.values()}
    return tuple(by_gift[gift] for gift in TopologicalSorter(graph).static_order())


def leading_to(stages: Sequence[Stage], gifts: Iterable[type]) -> tuple[Stage, ...]:
    """Those stages that gifts need, and their own, in the order of `stages`."""
    by_gift = {one.gives: one for one in stages}
    wanted: set[type] = set()
    open_ends = list(gifts)
    while open_ends:
        gift = open_ends.pop()
        if gift in by_gift and gift not in wanted:
            wanted.add(gift)
            open_ends += by_gift[gift].needs.values()
    return tuple(one for one in stages if one.gives in wanted)


STAGES: tuple[Stage, ...] = tuple(
    stage(function)
    for function in (
        piston_turn,
        piston_grid,
        dead_centres,
        cylinder_travel,
        volumetric_dead_centres,
        swept_volumes,
        chamber_volumes,
        port_timing,
        effective_compression,
        firing,
        piston_motion,
        rod_motion,
        piston_speeds,
        rod_speeds,
        combined_motion,
        combined_speeds,
        rocker_turn,
        dead_positions,
        rocker_motion,
        coupler_motion,
        rocker_speeds,
        coupler_speeds,
        load_motion,
        point_motion,
        link_motion,
        slider_motions,
        *(function for kind in KINDS for function in kind.stages),
        gas_in_chambers,
        gas_events,
        gas_pressures,
        indicated_powers,
        brake_powers,
        loaded_machine,
        solved_cycle,
        force_events,
        piston_force_set,
        largest_forces,
        rod_methods,
        crank_pin_loads,
        torque_sources,
        torque_peaks,
        shaft_torques,
        gear_torques,
        work_balance,
        torque_orders,
        phase_star_sums,
        mechanism_torques,
        journal_torques,
        joint_forces,
        guide_edges,
        frame_forces,
        running_frame,
        balance_weights,
        shaking_forces,
        shaking_couples,
        rolling_moment,
        flywheel_moment,
        applied_torque,
        load_torque,
        shaft_work,
        running_speed,
        flywheel_size,
        rim_size,
        torsional_train,
        torsional_modes,
        critical_speeds,
        mode_vector_sums,
        axial_positions,
        closing,
        doubts,
        rod_orders,
        textbook_motion,
    )
)
"""All stages, in the order in which people read their results."""


def lacking(stages: Sequence[Stage], parts: Iterable[type]) -> dict[type, tuple[str, ...]]:
    """Which gifts cannot be made of some parts, and what is missing for them.

    Parameters
    ----------
    stages : sequence of Stage
        In any order.
    parts : iterable of type
        What the machine declares.

    Returns
    -------
    dict of type to tuple of str
        In words, for what a machine file could say; none of a gift of another kind of machine.
    """
    known = set(parts)
    roots: dict[type, frozenset[type]] = {}
    for one in ordered(stages):
        needed = {need for name, need in one.needs.items() if name not in one.optional} - known
        if needed:
            roots[one.gives] = frozenset[type]().union(*(roots.get(need, frozenset({need})) for need in needed))
        else:
            known.add(one.gives)
    words = {
        gift: tuple(sorted({translated(getattr(root, "needs", "")) for root in of_gift}))
        for gift, of_gift in roots.items()
    }
    return {gift: of_gift if all(of_gift) else () for gift, of_gift in words.items()}


def run_stages(stages: Sequence[Stage], parts: dict[type, object]) -> tuple[dict[type, object], tuple[Missing, ...]]:
    """Run every stage whose needs are met.

    Parameters
    ----------
    stages : sequence of Stage
        In any order; results come in this one.
    parts : mapping of type to object
        What the machine declares.

    Returns
    -------
    gifts : mapping of type to object
    missing : tuple of Missing
        In words, for the stages that lack something that a machine file could say; a stage for another kind of
        machine is not spoken of.
    """
    known = dict(parts)
    seen: set[int] = set()
    for part in parts.values():
        _freeze(part, seen)
    gifts: dict[type, object] = {}
    absent = lacking(stages, parts)
    for one in ordered(stages):
        if one.gives not in absent:
            # NaN stands for links that cannot close, and is no news.
            with np.errstate(all="ignore"):
                gift = one.function(**{name: known.get(need) for name, need in one.needs.items()})
            _freeze(gift, seen)
            known[one.gives] = gifts[one.gives] = gift
    in_order = {one.gives: gifts[one.gives] for one in stages if one.gives in gifts}
    missing: dict[tuple[str, ...], list[str]] = {}
    for one in stages:
        results = [entry.name for entry in entries(one.gives)] if absent.get(one.gives) else []
        if results:
            missing.setdefault(absent[one.gives], []).extend(results)
    return in_order, tuple(Missing(tuple(results), needs) for needs, results in missing.items())


def _freeze(gift: object, seen: set[int]) -> None:
    """Make all arrays of a gift read-only: stages and users share them. `seen` holds what has been gone through."""
    open_ends: list[object] = [gift]
    while open_ends:
        value = open_ends.pop()
        if isinstance(value, np.ndarray):
            value.setflags(write=False)
        elif isinstance(value, tuple) or _is_record(type(value)):
            held = cast(tuple[object, ...], value)
            if id(held) not in seen:
                seen.add(id(held))
                open_ends += held if isinstance(value, tuple) else vars(held).values()


@cache
def _is_record(kind: type) -> bool:
    """Whether what is of this type has fields."""
    return is_dataclass(kind)
