"""A chain's structure: which group hangs on what, and what it makes, by names; the numbers are apart."""

from typing import NamedTuple, TypeAlias

from cranktrain.linkage import LinkPoint, Pin
from cranktrain.mechanisms.change_points import Form
from cranktrain.motion import Array, Handed, single


class PinStep(NamedTuple):
    """Rod and rocker, each from a point, that meet in a joint.

    Where they pass change points, in which form, and the hinge of the two bodies that carry their ends.
    """

    rod_from: str
    rocker_from: str
    rod: str
    rocker: str
    joint: str
    form: Form = ""
    hinge: str = ""


class SlideStep(NamedTuple):
    """Rod from a point to a slider on a fixed guide through a fixed point."""

    rod_from: str
    rod: str
    slider: str
    through: str


class SwivelStep(NamedTuple):
    """Guide about a pivot, which follows a slider on a pin."""

    pin: str
    pivot: str
    guide: str
    slider: str


class YokeStep(NamedTuple):
    """Slotted slider on a fixed guide through a fixed point, driven by a block on a pin."""

    pin: str
    slider: str
    through: str


class TrammelStep(NamedTuple):
    """Slider on a fixed guide through a fixed point, where a link's slot crosses it."""

    link: str
    slider: str
    through: str


class PointStep(NamedTuple):
    """Point fixed on a link."""

    link: str
    point: str


class MountStep(NamedTuple):
    """Point fixed on a slider that does not turn."""

    slider: str
    point: str


class RodLegStep(NamedTuple):
    """Rod from a point to a joint on a triad's link."""

    rod_from: str
    rod: str
    joint: str


class GuideLegStep(NamedTuple):
    """Slider on a fixed guide through a fixed point, whose pin is a joint on a triad's link."""

    slider: str
    through: str


class TriadStep(NamedTuple):
    """Link on three legs."""

    link: str
    legs: tuple[RodLegStep | GuideLegStep, ...]


Step: TypeAlias = PinStep | SlideStep | SwivelStep | YokeStep | TrammelStep | PointStep | MountStep | TriadStep


class Structure(NamedTuple):
    """What a chain is made of, in the order of its file: cranks and fixed points by name, steps, the output's name."""

    cranks: tuple[str, ...]
    fixed: tuple[str, ...]
    steps: tuple[Step, ...]
    output: str


class CrankSize(NamedTuple):
    """Radius [m], and angle ahead of the crank `main` [rad]."""

    radius: Array
    ahead: Handed


class Coordinates(NamedTuple):
    """Where a fixed point is. [m]"""

    x: Array
    y: Handed


class SlideSize(NamedTuple):
    """Rod length [m], way +1 ahead; guide's direction from x [rad], its offset to the left of its point [m]."""

    rod_length: Array
    way: Array
    direction: Handed
    offset: Handed


class SwivelSize(NamedTuple):
    """Offset of the guide's line to the left of its pivot [m]; way +1 where the slider lies ahead.

    outside is +1 where the fixed pivot lies outside the circle of the crank pin that drives the slider, −1 inside; 0
    where no crank pin drives it, or the pivot moves.
    """

    offset: Handed
    way: Array
    outside: Array


class YokeSize(NamedTuple):
    """Angle from the guide to the slot [rad]; guide's direction [rad] and offset [m]."""

    slot_angle: Handed
    direction: Handed
    offset: Handed


class TrammelSize(NamedTuple):
    """Shift of the slot to the left of its link [m]; guide's direction [rad] and offset [m].

    side is the sign of the sine of the angle from the guide to the slot, which must not change.
    """

    shift: Handed
    direction: Handed
    offset: Handed
    side: Handed


class RodLegSize(NamedTuple):
    """Joint on the link; rod length. [m]"""

    joint: LinkPoint
    length: Array


class GuideLegSize(NamedTuple):
    """Joint on the link; guide's direction [rad] and offset [m]."""

    joint: LinkPoint
    direction: Handed
    offset: Handed


class StartSize(NamedTuple):
    """Where a triad's link lies when the crank `main` is along x, or near there: origin [m], direction [rad].

    sign is that of the legs' transmission there, in the file's own axes, which is kept; side is +1 in these axes, −1
    where the mechanism is seen with y reversed.
    """

    x: Array
    y: Handed
    direction: Handed
    sign: Array
    side: Handed


NO_START = StartSize(single(0.0), single(0.0), single(0.0), single(0.0), single(1.0))
"""What stands there before a triad is put together."""


class TriadSize(NamedTuple):
    """The three legs, and the start of the walk round the turn, which chooses the assembly mode."""

    legs: tuple[RodLegSize | GuideLegSize, ...]
    start: StartSize


StepSize: TypeAlias = Pin | SlideSize | SwivelSize | YokeSize | TrammelSize | LinkPoint | TriadSize
"""Numbers of a group; of a point on a slider, radius and angle are from the slider's pin and from x."""


class ChainSize(NamedTuple):
    """All numbers of a chain, in the order of its structure."""

    cranks: tuple[CrankSize, ...]
    fixed: tuple[Coordinates, ...]
    steps: tuple[StepSize, ...]
