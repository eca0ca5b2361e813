"""Wanted motions that meet their work at rest, or on their way back: computed with all the same, and flagged."""

from collections.abc import Iterator, Sequence

import numpy as np

from cranktrain.grouping import grouped
from cranktrain.language import Words, _
from cranktrain.layout.load_laws import BySpeed, LoadState
from cranktrain.layout.loads import LinkLoad
from cranktrain.layout.wish.declared import RockingMotions, WantedMotions
from cranktrain.layout.wish.following import CrankMotion, Following, Rocking
from cranktrain.motion import Array
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.servo.rocking import RockingDrive
from cranktrain.questions.servo.stages import ServoDrive
from cranktrain.record import record
from cranktrain.saying.checks import Flagged
from cranktrain.saying.wording import number

_NOTHING = 1e-6
"""Of the largest size: less is where a load has not begun."""
_CLOSE = 1e-3
"""Of the stroke."""


@record
class UnlikelyMotion(Flagged):
    """Wanted motions that hardly any machine has."""


def unlikely_motion(
    loaded: LoadedMachine,
    wanted: WantedMotions | None,
    servo: ServoDrive | None,
    rocking: RockingMotions | None,
    rocked: RockingDrive | None,
) -> UnlikelyMotion:
    """Flag what is first met at rest or on the way back."""
    found: list[Words] = []
    if wanted is not None and servo is not None:
        found += _late(loaded, wanted.each, [one.crank for one in servo.demands])
    if rocking is not None and rocked is not None:
        found += _late(loaded, rocking.each, [one.crank for one in rocked.demands])
    return UnlikelyMotion(unlikely=tuple(found))


def _late(
    loaded: LoadedMachine, motions: Sequence[Following | Rocking], courses: Sequence[CrankMotion]
) -> Iterator[Words]:
    """Flag what a wanted motion meets first at rest, or on its way back."""
    loads = () if loaded.loads is None else loaded.loads.each
    at_work = [load for load in loads if load.resists and not isinstance(load.law, BySpeed)]
    for own in grouped(((load.mechanism, load.link), load) for load in at_work).values():
        for design, (made, course) in enumerate(zip(motions, courses, strict=True)):
            said = tuple(_first_met(loaded, own, design, made, course))
            if said:
                yield from said
                break


def _first_met(
    loaded: LoadedMachine, loads: Sequence[LinkLoad], design: int, made: Following | Rocking, course: CrankMotion
) -> Iterator[Words]:
    """Say when all loads of one part together are first met, if it is then at rest or on the way back."""
    size = sum((_size(loaded, load, design, course) for load in loads), start=np.zeros(course.time.shape))
    acts = size > _NOTHING * np.max(size)
    begins = np.flatnonzero(acts & ~np.roll(acts, 1))
    way = next((piece.rise for piece in made.wanted.pieces if piece.law is not None), 0.0)
    if not begins.size or way == 0:
        return
    first = int(begins[0])
    place = made.output.motion(course.angle)
    earlier = (first - np.arange(size.size)) % size.size
    # Nobody can tell a rest just before the work from one at it.
    is_there = np.abs(place.value[earlier] - place.value[first]) <= _CLOSE * made.output.stroke
    is_at_rest = bool(np.any((course.speed[earlier] == 0) & np.logical_and.accumulate(is_there)))
    speed = place.first[first] * course.speed[first]
    # A table of positions may begin anywhere, and has no way out.
    is_back = made.wanted.cubics is None and speed * way < 0
    if not (is_at_rest or is_back):
        return
    said = (
        _("{names} is first met at {time}, where the wanted motion rests: are its positions right?")
        if is_at_rest
        else _(
            "{names} is first met at {time}, on the way back of the wanted motion: does that count from the right end?"
        )
    )
    time = number(float(course.time[first] + made.wanted.zero), "s")
    yield said.format(names=", ".join(load.name for load in loads), time=time)


def _size(loaded: LoadedMachine, load: LinkLoad, design: int, course: CrankMotion) -> Array:
    """Size of a load over a wanted motion of one design, in rests as on the way out, shape (n,)."""
    way = loaded.load_way(load, course.angle)
    zero = 0.0 if loaded.loads is None else loaded.loads.zero
    travel = load.counts * way.place - loaded.travel_starts.get(load.name, np.zeros(()))
    state = LoadState(*np.broadcast_arrays(course.angle - zero, travel, load.counts * way.rate * course.speed))
    value = load.law.value(state)
    return np.abs(value[min(design, len(value) - 1), 0])
