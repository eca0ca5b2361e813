"""How many times a cycle repeats itself: cylinders that are alike and fire evenly do the same one after another.

Some φ later every mechanism stands where another one stood, that is alike and in whose cylinder the same goes on.
So the whole machine does again what it did, and one part of its cycle says all of its shaft. Plain loops, which
compile.
"""

import numpy as np

from cranktrain.motion import Array
from cranktrain.study.cycle.given import ChamberNumbers, OfFluid, OfKind, Repeats

_TURN = 2 * np.pi
_ALIKE, _TOGETHER = 1e-13, 1e-12
"""Numbers that differ by less, in parts of the larger, and angles, are one. [rad]"""


def begin_repeats(repeats: Repeats) -> None:
    """Begin anew: nothing stands in anything's place."""
    for mechanism in range(repeats.is_taken.size):
        repeats.is_taken[mechanism] = False


def first_chambers(n_repeats: int, repeats: Repeats) -> None:
    """Note which chambers come first among those that stand in one another's places."""
    for chamber in range(repeats.is_first.size):
        repeats.is_first[chamber] = True
    for chamber in range(repeats.is_first.size if n_repeats > 1 else 0):
        image = repeats.chamber[chamber]
        for _later in range(n_repeats):
            repeats.is_first[image] &= image <= chamber
            image = repeats.chamber[image]


def mechanisms_repeat(
    design: int, kind: OfKind, room: ChamberNumbers, later: float, cycle: float, repeats: Repeats
) -> bool:
    """Whether every mechanism of a kind stands, some φ later, as another one of them; note which."""
    for member in range(kind.mechanism.size):
        other = _in_its_place(design, member, kind, room, later, cycle, repeats)
        if other < 0:
            return False
        image = kind.mechanism[other]
        repeats.is_taken[image] = True
        repeats.mechanism[kind.mechanism[member]] = image
        if kind.piston[member] >= 0:
            repeats.piston[kind.piston[member]] = kind.piston[other]
    return True


def masters_repeat(kind: OfKind, repeats: Repeats) -> bool:
    """Whether what hangs on a rod hangs, in its new place, on what stands in that rod's."""
    for member in range(kind.mechanism.size):
        if kind.master[member] >= 0:
            image, is_there = repeats.mechanism[kind.mechanism[member]], False
            for other in range(kind.mechanism.size):
                if kind.mechanism[other] == image:
                    is_there = kind.master[other] == repeats.mechanism[kind.master[member]]
            if not is_there:
                return False
    return True


def chambers_repeat(
    design: int, fluid: OfFluid, room: ChamberNumbers, later: float, cycle: float, repeats: Repeats
) -> bool:
    """Whether every chamber of a fluid is, some φ later, as that of the pistons in its own ones' places."""
    for member in range(fluid.places.size):
        chamber, is_there = fluid.places[member], False
        for other in range(fluid.places.size):
            image = fluid.places[other]
            if (
                room.partner[image, 0] == repeats.piston[room.partner[chamber, 0]]
                and room.partner[image, 1] == repeats.piston[room.partner[chamber, 1]]
                and _are_alike(room.area[design, chamber], room.area[design, image])
                and _is_chamber_alike(design, chamber, image, room)
                and _is_later(room.firing[design, image], room.firing[design, chamber], later, cycle)
                and _is_later(room.least[design, image], room.least[design, chamber], later, _TURN)
                and _is_later(room.greatest[design, image], room.greatest[design, chamber], later, _TURN)
                and _are_alike(fluid.numbers[design, member], fluid.numbers[design, other])
            ):
                is_there = True
                repeats.chamber[chamber] = image
                break
        if not is_there:
            return False
    return True


def _in_its_place(
    design: int, member: int, kind: OfKind, room: ChamberNumbers, later: float, cycle: float, repeats: Repeats
) -> int:
    """Which member stands, some φ earlier, as a given one does later; −1 for none."""
    for other in range(kind.mechanism.size):
        if (
            not repeats.is_taken[kind.mechanism[other]]
            and _is_later(kind.phase[design, member], kind.phase[design, other], later, _TURN)
            and (kind.master[member] < 0) == (kind.master[other] < 0)
            and _fire_alike(design, kind.piston[member], kind.piston[other], room, later, cycle)
            and _are_alike(kind.geometry[design, member], kind.geometry[design, other])
            and _are_alike(kind.bodies[design, member], kind.bodies[design, other])
            and _are_alike(kind.gravity[design, member], kind.gravity[design, other])
        ):
            return other
    return -1


def _fire_alike(design: int, one: int, other: int, room: ChamberNumbers, later: float, cycle: float) -> bool:
    """Whether the first chamber of a piston fires so much later than that of another; or neither has any."""
    own, image = _first_chamber(one, room), _first_chamber(other, room)
    if own < 0 or image < 0:
        return own == image
    return _is_later(room.firing[design, image], room.firing[design, own], later, cycle)


def _first_chamber(piston: int, room: ChamberNumbers) -> int:
    for chamber in range(room.partner.shape[0]):
        if piston >= 0 and (room.partner[chamber, 0] == piston or room.partner[chamber, 1] == piston):
            return chamber
    return -1


def _is_chamber_alike(design: int, one: int, other: int, room: ChamberNumbers) -> bool:
    """Whether two chambers have the same volumes."""
    alike = _is_alike(room.start[design, one], room.start[design, other])
    alike &= _is_alike(room.ambient[design, one], room.ambient[design, other])
    alike &= _is_alike(room.smallest[design, one], room.smallest[design, other])
    alike &= _is_alike(room.largest[design, one], room.largest[design, other])
    for partner in range(2):
        top, image = room.top[design, room.partner[one, partner]], room.top[design, room.partner[other, partner]]
        alike &= _is_alike(top, image)
    return alike


def _are_alike(one: Array, other: Array) -> bool:
    """Whether two rows of numbers are one."""
    alike = True
    for place in range(one.size):
        alike &= _is_alike(one[place], other[place])
    return alike


def _is_alike(one: float, other: float) -> bool:
    return abs(one - other) <= _ALIKE * max(abs(one), abs(other))


def _is_later(angle: float, other: float, later: float, turn: float) -> bool:
    """Whether one angle is another one and some more, but for whole turns."""
    apart = angle - other - later
    return abs(apart - turn * np.floor(apart / turn + 0.5)) <= _TOGETHER
