"""How many times a cycle repeats itself: cylinders that are alike and fire evenly do the same one after another.

Some φ later every mechanism stands where another one stood, that is alike and in whose cylinder the same goes on.
So the whole machine does again what it did, and one part of its cycle says all of its shaft. Plain loops, which
compile.
"""

import numpy as np

from cranktrain.motion import Array
from cranktrain.study.cycle.given import OfRepeats, Repeats

_TURN = 2 * np.pi
_ALIKE, _TOGETHER = 1e-13, 1e-12
"""Numbers that differ by less, in parts of the larger, and angles, are one. [rad]"""


def times_repeated(design: int, alike: OfRepeats, cycle: float, repeats: Repeats) -> int:
    """How many times a design's cycle repeats itself; what stands in each one's place then is noted."""
    for many in range(alike.kind.size, 1, -1):
        later = cycle / many
        if _mechanisms_repeat(design, alike, later, cycle, repeats) and _chambers_repeat(
            design, alike, later, cycle, repeats
        ):
            return many
    return 1


def first_chambers(n_repeats: int, repeats: Repeats) -> None:
    """Note which chambers come first among those that stand in one another's places."""
    for chamber in range(repeats.is_first.size):
        repeats.is_first[chamber] = True
    for chamber in range(repeats.is_first.size if n_repeats > 1 else 0):
        image = repeats.chamber[chamber]
        for _later in range(n_repeats):
            repeats.is_first[image] &= image <= chamber
            image = repeats.chamber[image]


def _mechanisms_repeat(design: int, alike: OfRepeats, later: float, cycle: float, repeats: Repeats) -> bool:
    """Whether every mechanism stands, some φ later, as another one, and hangs on what stands in its master's place."""
    for mechanism in range(alike.kind.size):
        repeats.is_taken[mechanism] = False
    for mechanism in range(alike.kind.size):
        fires, is_there = alike.firing[design, mechanism], False
        for image in range(alike.kind.size):
            to_fire = alike.firing[design, image]
            if (
                not repeats.is_taken[image]
                and alike.kind[image] == alike.kind[mechanism]
                and (alike.master[image] < 0) == (alike.master[mechanism] < 0)
                and _is_later(alike.phase[design, mechanism], alike.phase[design, image], later, _TURN)
                and (_is_later(to_fire, fires, later, cycle) or (fires != fires and to_fire != to_fire))
                and _are_alike(alike.numbers[design, mechanism], alike.numbers[design, image])
            ):
                is_there, repeats.is_taken[image] = True, True
                repeats.mechanism[mechanism] = image
                if alike.piston[mechanism] >= 0:
                    repeats.piston[alike.piston[mechanism]] = alike.piston[image]
                break
        if not is_there:
            return False
    for mechanism in range(alike.kind.size):
        master = alike.master[mechanism]
        if master >= 0 and alike.master[repeats.mechanism[mechanism]] != repeats.mechanism[master]:
            return False
    return True


def _chambers_repeat(design: int, alike: OfRepeats, later: float, cycle: float, repeats: Repeats) -> bool:
    """Whether every chamber is, some φ later, as that of the pistons in its own ones' places."""
    for chamber in range(alike.fluid.size):
        one, other = repeats.piston[alike.partner[chamber, 0]], repeats.piston[alike.partner[chamber, 1]]
        own, is_there = alike.angles[design, chamber], False
        for image in range(alike.fluid.size):
            its = alike.angles[design, image]
            if (
                alike.partner[image, 0] == one
                and alike.partner[image, 1] == other
                and alike.fluid[image] == alike.fluid[chamber]
                and _is_later(its[0], own[0], later, cycle)
                and _is_later(its[1], own[1], later, _TURN)
                and _is_later(its[2], own[2], later, _TURN)
                and _are_alike(alike.volumes[design, chamber], alike.volumes[design, image])
            ):
                is_there = True
                repeats.chamber[chamber] = image
                break
        if not is_there:
            return False
    return True


def _are_alike(one: Array, other: Array) -> bool:
    """Whether two rows of numbers are one."""
    alike = True
    for place in range(one.size):
        alike &= abs(one[place] - other[place]) <= _ALIKE * max(abs(one[place]), abs(other[place]))
    return alike


def _is_later(angle: float, other: float, later: float, turn: float) -> bool:
    """Whether one angle is another one and some more, but for whole turns."""
    apart = angle - other - later
    return abs(apart - turn * np.floor(apart / turn + 0.5)) <= _TOGETHER
