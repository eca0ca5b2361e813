"""Events of the forces: angles at which gas or friction make them jump or give them kinks; between, all is smooth."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.load_laws import ByAngle, ByTravel
from cranktrain.layout.loads import LinkLoad, of_member
from cranktrain.motion import Array
from cranktrain.numerics import bracketed_roots, in_slots
from cranktrain.questions.forces.edges import edges_of
from cranktrain.questions.forces.loaded_machine import LoadedMachine, SolvedBatch
from cranktrain.questions.forces.solved_cycle import SolvedCycle
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
    """

    angle: Array
    whole: Array


class _Signals(NamedTuple):
    """What tells of kinks or jumps by its sign.

    Attributes
    ----------
    mechanisms : array of int, shape (member,)
        Whose they are.
    each : int
        How many each has.
    of : callable (solved) → Array, shape (design, member · each, n)
    """

    mechanisms: NDArray[np.intp]
    each: int
    of: Callable[[Sequence[SolvedBatch]], Array]


def force_events(
    loaded: LoadedMachine, solved: SolvedCycle, gas: GasEvents | None, crank_angle: CrankAngle
) -> ForceEvents:
    """Collect the events of gas and friction."""
    n_designs = len(crank_angle.zero)
    own: dict[int, list[Array]] = {i: [np.empty((n_designs, 0))] for i in range(len(loaded.mechanisms.names))}
    if gas is not None and loaded.gas is not None:
        for chamber, mechanism in enumerate(loaded.carriers.driven[loaded.gas.chambers.leading].tolist()):
            own[mechanism].append(gas.angle[:, chamber])
    for signals in (*_rubbing(loaded), *_loading(loaded)):
        turns = _turns(loaded, solved, signals, crank_angle)
        for member, mechanism in enumerate(signals.mechanisms.tolist()):
            own[mechanism].append(turns[:, member])
    for load in () if loaded.loads is None else loaded.loads.each:
        if isinstance(load.law, ByAngle):
            own[load.mechanism].append(load.law.kinks(crank_angle.cycle) + crank_angle.zero[..., 0])
    curve = loaded.speed.curve
    if curve is not None and curve.corners is not None:
        for parts in own.values():
            parts.append(np.broadcast_to(curve.corners, (n_designs, curve.corners.shape[-1])))
    each = [np.concatenate(parts, axis=-1) for parts in own.values()]
    shared = [
        np.concatenate([each[i] for i in np.flatnonzero(loaded.sharing == label)], axis=-1) for label in loaded.sharing
    ]
    longest = max(part.shape[-1] for part in shared)
    filled = [np.pad(part, ((0, 0), (0, longest - part.shape[-1])), constant_values=np.nan) for part in shared]
    return ForceEvents(np.stack(filled, axis=1), np.concatenate(each, axis=-1))


def _rubbing(loaded: LoadedMachine) -> Iterator[_Signals]:
    """Find what rubs."""
    for place, (batch, made) in enumerate(zip(loaded.mechanisms.batches, loaded.masses.batches, strict=True)):
        for sliding, coefficient in enumerate(made.friction):
            if np.any(coefficient != 0.0):
                yield _Signals(batch.index, 3, partial(_pressing, loaded, place, sliding))


def _loading(loaded: LoadedMachine) -> Iterator[_Signals]:
    """Find loads that jump where their point turns back, or have kinks along its travel."""
    for load in () if loaded.loads is None else loaded.loads.each:
        if load.resists or isinstance(load.law, ByTravel):
            kinks = load.law.places.shape[1] if isinstance(load.law, ByTravel) else 0
            yield _Signals(np.array([load.mechanism]), 1 + kinks, partial(_along, loaded, load))


def _along(loaded: LoadedMachine, load: LinkLoad, solved: Sequence[SolvedBatch]) -> Array:
    """Speed along a load's way, and its travel less each place at which its size has a kink: (design, 1 + kink, n)."""
    for batch, one in zip(loaded.mechanisms.batches, solved, strict=True):
        member = np.flatnonzero(batch.index == load.mechanism)
        if member.size:
            link = batch.kind.dynamics.links(one.motion, batch.members.geometry)[load.link]
            way = load.way(of_member(link, int(member[0])))
            turns = load.turns_back(of_member(link, int(member[0])), way)
            rate = np.broadcast_to(turns, one.forces.driving_torque[:, :1].shape)
            if not isinstance(load.law, ByTravel):
                return rate
            travel = load.counts * way.place - loaded.travel_starts[load.name]
            return np.concatenate([rate, travel - load.law.places[..., np.newaxis]], axis=1)
    raise IndexError(load.mechanism)


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


def _turns(loaded: LoadedMachine, solved: SolvedCycle, signals: _Signals, crank_angle: CrankAngle) -> Array:
    """φ at which one of the signals changes its sign, shape (design, member, event)."""
    samples = signals.of(solved.batches)
    is_clear = np.abs(samples) > _ROUNDING * np.max(np.abs(samples), axis=-1, keepdims=True)
    sign = np.where(is_clear, np.sign(samples), 0.0)
    changes = sign != np.roll(sign, -1, axis=-1)
    which, place = np.nonzero(changes.reshape(-1, changes.shape[-1]))
    n_designs, rows = len(samples), np.repeat(signals.mechanisms, signals.each)
    if which.size == 0:
        return np.empty((n_designs, len(signals.mechanisms), 0))

    def signal(angle: Array) -> Array:
        return loaded.of_each(rows, which, angle, signals.of)

    step = crank_angle.cycle / crank_angle.shown.size
    low = (crank_angle.shown[place] + crank_angle.zero[which // rows.size, 0, 0])[:, np.newaxis]
    # What is 0 at a point of the grid has changed its sign within the steps before and after.
    aside = _ASIDE * step
    found = bracketed_roots(signal, low - aside, low + step + aside)
    laid, slot = in_slots(which // signals.each, found, n_designs * len(signals.mechanisms))
    is_one = np.zeros(laid.shape, dtype=np.bool_)
    is_one[which // signals.each, slot] = True
    return np.where(is_one, laid, np.nan).reshape(n_designs, len(signals.mechanisms), -1)
