"""Events of the forces: angles at which gas or friction make them jump or give them kinks; between, all is smooth."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.grouping import grouped
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.load_laws import ByAngle, ByTravel, Law
from cranktrain.layout.loads import LinkLoad
from cranktrain.layout.speed import Speed
from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots, in_slots
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.forces.solved_cycle import SolvedCycle, edges_of
from cranktrain.questions.gas.events import GasEvents
from cranktrain.record import record

_ROUNDING = 1e-12
"""Forces and speeds smaller than this part of their peak may be of either sign."""
_ASIDE = 1e-6


@record
class ForceEvents:
    """Where forces may jump or have kinks; NaN for none.

    Attributes
    ----------
    angle : Array, shape (design, mechanism, event)
        φ of what happens to each mechanism, or to one whose rod or chamber it shares. [rad]
    whole : Array, shape (design, event)
        φ of all. [rad]
    misses : Array, shape (design, event)
        Of all: at a row of a load's curve by how much its straight lines may miss a smooth curve there, in parts of
        its largest size; infinite for whatever else happens.
    """

    angle: Array
    whole: Array
    misses: Array


class _Signals(NamedTuple):
    """What tells of kinks or jumps by its sign: curves less levels.

    Attributes
    ----------
    mechanisms : array of int, shape (member,)
        Whose they are.
    on_grid : Array, shape (design, member · curve, n)
    at : callable (angle) → Array, of that shape
        At φ of each mechanism. [rad]
    curve : array of int, shape (signal,)
        Of the signals that each member has: which of its curves each is of.
    levels, misses : Array, shape (design, signal)
        What is taken off that curve; and as those of `ForceEvents`.
    """

    mechanisms: NDArray[np.intp]
    on_grid: Array
    at: Callable[[Array], Array]
    curve: NDArray[np.intp]
    levels: Array
    misses: Array


class _Found(NamedTuple):
    """What happens, and the misses of rows, as in `ForceEvents`."""

    angle: Array
    misses: Array


def force_events(
    loaded: LoadedMachine, solved: SolvedCycle, gas: GasEvents | None, crank_angle: CrankAngle
) -> ForceEvents:
    """Collect the events of gas and friction; docs/theory/harmonics-and-orders, eq. (15.17)."""
    n_designs = len(crank_angle.zero)
    none = _beside_rows(np.empty((n_designs, 0)))
    own = {i: [none] for i in range(len(loaded.mechanisms.names))}
    if gas is not None and loaded.gas is not None:
        for chamber, mechanism in enumerate(loaded.carriers.driven[loaded.gas.chambers.leading].tolist()):
            own[mechanism].append(_beside_rows(gas.angle[:, chamber]))
    for signals in (*_rubbing(loaded, solved.batches), *_loading(loaded, crank_angle)):
        turns = _turns(loaded, signals, crank_angle)
        for member, mechanism in enumerate(signals.mechanisms.tolist()):
            own[mechanism].append(_Found(turns.angle[:, member], turns.misses[:, member]))
    for load in () if loaded.loads is None else loaded.loads.each:
        if isinstance(load.law, ByAngle):
            own[load.mechanism].append(_rows_by_angle(load.law, crank_angle))
    curve = loaded.speed.curve
    if curve is not None and curve.corners is not None:
        for parts in own.values():
            parts.append(_beside_rows(np.broadcast_to(curve.corners, (n_designs, curve.corners.shape[-1]))))
    each = [np.concatenate([part.angle for part in parts], axis=-1) for parts in own.values()]
    misses = np.concatenate([part.misses for parts in own.values() for part in parts], axis=-1)
    sharing = loaded.sharing.tolist()
    together = grouped(zip(sharing, each, strict=True))
    of_label = {label: np.concatenate(parts, axis=-1) for label, parts in together.items()}
    shared = [of_label[label] for label in sharing]
    angle = np.full((n_designs, len(shared), max(part.shape[-1] for part in shared)), np.nan)
    for mechanism, part in enumerate(shared):
        angle[:, mechanism, : part.shape[-1]] = part
    return ForceEvents(angle, np.concatenate(each, axis=-1), misses)


def friction_kinks(loaded: LoadedMachine, crank_angle: CrankAngle) -> Array:
    """Crank angles φ at which the friction of what slides has kinks, shape (design, event); NaN for none. [rad]"""
    each = [_turns(loaded, own, crank_angle).angle for own in _rubbing(loaded, loaded.solved(crank_angle.angle))]
    n_designs = len(crank_angle.zero)
    return np.concatenate([np.empty((n_designs, 0)), *(found.reshape(n_designs, -1) for found in each)], axis=-1)


def breaks_at_speed(events: ForceEvents, speed: Speed, crank_angle: CrankAngle) -> Array:
    """Crank angles, as shown, of all events, and of the nodes of a speed's curve, which is made of pieces. [rad]"""
    breaks = events.whole - crank_angle.zero[:, 0]
    if speed.curve is None:
        return breaks
    nodes = speed.curve.square.angle + speed.curve.zero[:, 0] - crank_angle.zero[:, 0]
    return np.concatenate([breaks, np.broadcast_to(nodes, (len(breaks), nodes.shape[-1]))], axis=-1)


def with_rows(events: ForceEvents, laws: Sequence[Law], crank_angle: CrankAngle) -> ForceEvents:
    """Add the rows of laws of loads on shafts, which are events of the machine as a whole."""
    return _with(events, [_rows_by_angle(law, crank_angle) for law in laws if isinstance(law, ByAngle)])


def with_kinks(events: ForceEvents, angle: Array) -> ForceEvents:
    """Add kinks at φ, shape (design, event), to the events of the machine as a whole. [rad]"""
    return _with(events, [_beside_rows(angle)])


def _with(events: ForceEvents, more: Sequence[_Found]) -> ForceEvents:
    """Add what happens to the machine as a whole."""
    if not more:
        return events
    return replace(
        events,
        whole=np.concatenate([events.whole, *(each.angle for each in more)], axis=-1),
        misses=np.concatenate([events.misses, *(each.misses for each in more)], axis=-1),
    )


def _beside_rows(angle: Array) -> _Found:
    """What happens at no row of a load's curve."""
    return _Found(angle, np.full(angle.shape, np.inf))


def _rows_by_angle(law: ByAngle, crank_angle: CrankAngle) -> _Found:
    """Rows of a load over the crank angle."""
    angle = law.kinks(crank_angle.cycle) + crank_angle.zero[..., 0]
    return _Found(angle, np.broadcast_to(law.misses(crank_angle.cycle), angle.shape))


def _rubbing(loaded: LoadedMachine, solved: Sequence[SolvedBatch]) -> Iterator[_Signals]:
    """Find what rubs."""
    for place, (batch, made) in enumerate(zip(loaded.mechanisms.batches, loaded.masses.batches, strict=True)):
        for sliding, coefficient in enumerate(made.friction):
            if np.any(coefficient != 0.0):
                pressing = partial(_pressing, loaded, place, sliding)
                yield _of_no_rows(batch.index, pressing(solved), partial(_solved, loaded, pressing))


def _solved(loaded: LoadedMachine, pick: Callable[[Sequence[SolvedBatch]], Array], angle: Array) -> Array:
    """Pick curves of forces, at φ of each mechanism."""
    return pick(loaded.solved(angle))


def _loading(loaded: LoadedMachine, crank_angle: CrankAngle) -> Iterator[_Signals]:
    """Find loads that jump where their point turns back, or have kinks along its travel."""
    for load in () if loaded.loads is None else loaded.loads.each:
        if load.resists or isinstance(load.law, ByTravel):
            own, along = np.array([load.mechanism]), partial(_along, loaded, load)
            shape = len(crank_angle.zero), loaded.sharing.size, crank_angle.shown.size
            on_grid = along(np.broadcast_to(crank_angle.angle, shape))
            if not isinstance(load.law, ByTravel):
                yield _of_no_rows(own, on_grid, along)
                continue
            curve = np.array([0, *[1] * load.law.places.shape[1]])
            first = ((0, 0), (1, 0))
            levels, misses = np.pad(load.law.places, first), np.pad(load.law.misses, first, constant_values=np.inf)
            yield _Signals(own, on_grid, along, curve, levels, misses)


def _of_no_rows(mechanisms: NDArray[np.intp], on_grid: Array, at: Callable[[Array], Array]) -> _Signals:
    """Curves whose own signs tell, and which are of no rows."""
    n_curves = on_grid.shape[1] // mechanisms.size
    none = np.full((1, n_curves), np.inf)
    return _Signals(mechanisms, on_grid, at, np.arange(n_curves), np.zeros((1, n_curves)), none)


def _along(loaded: LoadedMachine, load: LinkLoad, angle: Array) -> Array:
    """Speed along a load's way, and its travel where its size goes by that, shape (design, curve, n)."""
    # Of the motion alone: what the load does to the forces comes after.
    own = angle[:, load.mechanism : load.mechanism + 1]
    link = loaded.loaded_link(load, own)
    way = load.way(link)
    curves = [load.turns_back(link, way)]
    if isinstance(load.law, ByTravel):
        curves.append(load.counts * way.place - loaded.travel_starts[load.name])
    shape = len(loaded.speed.value), 1, angle.shape[-1]
    return np.concatenate([np.broadcast_to(curve, shape) for curve in curves], axis=1)


def _pressing(loaded: LoadedMachine, place: int, sliding: int, solved: Sequence[SolvedBatch]) -> Array:
    """Speed of what slides, and what presses it: friction has kinks where one of these changes its sign.

    Shape (design, member · 3, n). A guide presses by both its edges; of a slot both parts of the force are 0 at once.
    """
    batch, one = loaded.mechanisms.batches[place], solved[place]
    dynamics = batch.kind.dynamics
    name, contact = dynamics.sliding[sliding], dynamics.contacts[sliding]
    if name in dynamics.moving:
        pressing = edges_of(batch, one, sliding)
    else:
        joint = next(i for i, reaction in enumerate(dynamics.reactions) if reaction.name == contact.joint)
        pressing = one.forces.joints[joint][:2]
    shape = one.forces.driving_torque.shape
    parts = [np.broadcast_to(part, shape) for part in (batch.kind.named(one.motion, name).first, *pressing)]
    return np.stack(parts, axis=2).reshape(shape[0], -1, shape[-1])


def _turns(loaded: LoadedMachine, signals: _Signals, crank_angle: CrankAngle) -> _Found:
    """φ at which one of the signals changes its sign, shape (design, member, event)."""
    n_designs, n_members, n_signals = len(signals.on_grid), len(signals.mechanisms), signals.curve.size
    each = signals.on_grid.reshape(n_designs, n_members, -1, signals.on_grid.shape[-1])
    n_curves = each.shape[2]
    samples = each[:, :, signals.curve] - signals.levels[:, np.newaxis, :, np.newaxis]
    is_clear = np.abs(samples) > _ROUNDING * np.max(np.abs(samples), axis=-1, keepdims=True)
    sign = np.where(is_clear, np.sign(samples), 0.0)
    changes = sign != np.roll(sign, -1, axis=-1)
    design, member, own, place = np.nonzero(changes)
    if design.size == 0:
        return _beside_rows(np.empty((n_designs, n_members, 0)))
    levels, misses = (np.broadcast_to(of, (n_designs, n_signals))[design, own] for of in signals[-2:])
    rows = np.repeat(signals.mechanisms, n_curves)
    which = (design * n_members + member) * n_curves + signals.curve[own]

    def signal(angle: Array) -> Array:
        return loaded.of_each(rows, which, angle, signals.at) - levels[:, np.newaxis]

    step = crank_angle.cycle / crank_angle.shown.size
    low = (crank_angle.shown[place] + crank_angle.zero[design, 0, 0])[:, np.newaxis]
    # What is 0 at a point of the grid has changed its sign within the steps before and after.
    aside = _ASIDE * step
    found = bracketed_roots(signal, low - aside, low + step + aside)
    whose = design * n_members + member
    laid, slot = in_slots(whose, found, n_designs * n_members)
    angles, own_misses = np.full(laid.shape[:2], np.nan), np.full(laid.shape[:2], np.inf)
    angles[whose, slot], own_misses[whose, slot] = found[:, 0], misses
    shape = (n_designs, n_members, -1)
    return _Found(angles.reshape(shape), own_misses.reshape(shape))
