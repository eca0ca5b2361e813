"""Kinematics of a chain: the groups of its structure, one after the other, each on what those above it made."""

from collections.abc import Callable, Hashable, Mapping
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from cranktrain.linkage import (
    GUIDE,
    ROD,
    Crank,
    Ends,
    Leg,
    LinkPoint,
    Pin,
    RodEnds,
    Slide,
    Swivel,
    SwivelEnds,
    Trammel,
    Triad,
    TriadDriver,
    TriadEnds,
    TriadMotion,
    Yoke,
    crank,
    fixed,
    fixed_guide,
    pin,
    pin_gap,
    point,
    rod_between,
    rod_end,
    slide,
    slide_gap,
    swivel,
    swivel_gap,
    trammel,
    trammel_transmission,
    triad,
    turned,
    turned_link,
    yoke,
)
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    GuideLegSize,
    GuideLegStep,
    MountStep,
    PinSize,
    PinStep,
    PointSize,
    PointStep,
    RodLegSize,
    RodLegStep,
    SlideSize,
    SlideStep,
    Step,
    Structure,
    SwivelSize,
    SwivelStep,
    TrammelSize,
    TrammelStep,
    TriadSize,
    TriadStep,
    YokeSize,
    YokeStep,
)
from cranktrain.mechanisms.chain.walks import Branch, Walks, lacking, start_at
from cranktrain.mechanisms.kind import leaves
from cranktrain.motion import Array, Coefficient, Link, Point, single

SHAFT = "O"
"""Name of the shaft's centre."""

Made = dict[str, Any]
"""Points, links and sliders by name: `Point`, `Link`, `Coefficient`."""


class SliderChainMotion(NamedTuple):
    """All that a chain makes, in the order of `made_names`; the slider that is its output."""

    parts: tuple[Any, ...]
    slider: Coefficient


class LinkChainMotion(NamedTuple):
    """All that a chain makes, in the order of `made_names`; the link that is its output."""

    parts: tuple[Any, ...]
    rocker: Link


ChainMotion: TypeAlias = SliderChainMotion | LinkChainMotion


def pin_of(name: str) -> str:
    """Name of the point that a crank or a slider gives."""
    return f"{name}.pin"


def made_names(structure: Structure) -> tuple[str, ...]:
    """Names of all that a chain makes, in order."""
    pins = [pin_of(name) for name in structure.cranks]
    return (SHAFT, *structure.fixed, *pins, *(name for step in structure.steps for name in made_by(step)))


def made_by(step: Step | RodLegStep | GuideLegStep) -> dict[str, str]:
    """Names of what a group makes, in order; what sort of thing each is: a point, a link or a slider."""
    match step:
        case PinStep():
            return {step.joint: "point", step.rod: "link", step.rocker: "link"}
        case SlideStep():
            return {step.rod: "link", **_slider(step.slider)}
        case SwivelStep():
            return {step.slider: "slider", step.guide: "link"}
        case YokeStep() | TrammelStep() | GuideLegStep():
            return _slider(step.slider)
        case PointStep() | MountStep():
            return {step.point: "point"}
        case RodLegStep():
            return {step.joint: "point", step.rod: "link"}
        case TriadStep():
            return {step.link: "link"} | {name: sort for leg in step.legs for name, sort in made_by(leg).items()}


def _slider(name: str) -> dict[str, str]:
    return {name: "slider", pin_of(name): "point"}


def chain_made(structure: Structure, angle: Array, size: ChainSize) -> Made:
    """All points, links and sliders of a chain by name; parameters as of `chain_motion`."""
    made = _driven(structure, angle, size)
    for place in range(len(structure.steps)):
        _place(structure, place, angle, size, made)
    return made


def _place(structure: Structure, place: int, angle: Array, size: ChainSize, made: Made) -> None:
    """Add what one group makes; of a triad the start at these angles comes first."""
    step, own = structure.steps[place], size.steps[place]
    if isinstance(step, TriadStep) and isinstance(own, TriadSize):
        _place_triad(step, own, _triad_motion(structure, place, angle, size, made).link, made)
    else:
        _PLACED[type(step)](step, own, made)


def chain_motion(structure: Structure, angle: Array, size: ChainSize) -> ChainMotion:
    """All of a chain, and its derivatives by the crank angle.

    Parameters
    ----------
    structure : Structure
    angle : Array, shape (..., n)
        Angle of the crank `main` from x. [rad]
    size : ChainSize, fields broadcastable to (..., 1)

    Returns
    -------
    ChainMotion, shape (..., n)
        NaN from the first group that cannot close on.

    Notes
    -----
    docs/theory/chain.
    """
    made = chain_made(structure, angle, size)
    parts, output = tuple(made.values()), made[structure.output]
    return LinkChainMotion(parts, output) if isinstance(output, Link) else SliderChainMotion(parts, output)


def chain_gaps(structure: Structure, angle: Array, size: ChainSize) -> list[Array]:
    """By how much each group can close; negative where it cannot, NaN where one above it cannot. [m]"""
    made = _driven(structure, angle, size)
    radius = size.cranks[0].radius
    gaps: list[Array] = []
    for place, (step, own) in enumerate(zip(structure.steps, size.steps, strict=True)):
        if isinstance(step, TriadStep) and isinstance(own, TriadSize):
            motion = _triad_motion(structure, place, angle, size, made)
            gaps.append(_gap_of_triad(triad_branch(structure, place, size), triad_ends(step, own, made), own, motion))
            _place_triad(step, own, motion.link, made)
        else:
            gaps.append(_GAPS[type(step)](step, own, made, radius))
            _PLACED[type(step)](step, own, made)
    return gaps


def chain_gap(structure: Structure, angle: Array, size: ChainSize) -> Array:
    """By how much the group that closes least does; negative where it cannot. [m]"""
    least = np.full_like(angle + size.cranks[0].radius, np.inf)
    for gap in chain_gaps(structure, angle, size):
        least = np.fmin(least, gap)
    return least


def _driven(structure: Structure, angle: Array, size: ChainSize) -> Made:
    """Shaft, fixed points and crank pins."""
    made: Made = {SHAFT: fixed(single(0.0), single(0.0))}
    made |= {name: fixed(*place) for name, place in zip(structure.fixed, size.fixed, strict=True)}
    for name, own in zip(structure.cranks, size.cranks, strict=True):
        made[pin_of(name)] = crank(angle + own.ahead, Crank(own.radius))
    return made


def _height(made: Made, through: str, direction: Array, offset: Array) -> Array:
    """Offset of a guide from the shaft, in its own axes."""
    place = made[through]
    return offset + np.cos(direction) * place.y.value - np.sin(direction) * place.x.value


def _in_guide(made: Made, name: str, direction: Array) -> Point:
    return turned(made[name], direction)


def _on_guide(slider: Coefficient, height: Array, direction: Array) -> Point:
    """Slider as a point in the file's axes."""
    cos, sin = np.cos(direction), np.sin(direction)
    return Point(
        Coefficient(cos * slider.value - sin * height, cos * slider.first, cos * slider.second),
        Coefficient(sin * slider.value + cos * height, sin * slider.first, sin * slider.second),
    )


def _place_pin(step: PinStep, own: PinSize, made: Made) -> None:
    motion = pin(Ends(made[step.rod_from], made[step.rocker_from]), Pin(*own))
    made[step.joint], made[step.rod], made[step.rocker] = motion


def _place_slide(step: SlideStep, own: SlideSize, made: Made) -> None:
    height = _height(made, step.through, own.direction, own.offset)
    motion = slide(_in_guide(made, step.rod_from, own.direction), Slide(own.rod_length, height, own.way))
    rod = motion.rod
    cos, sin = np.cos(own.direction), np.sin(own.direction)
    made[step.rod] = Link(
        made[step.rod_from],
        rod.angle._replace(value=rod.angle.value + own.direction),
        cos * rod.cos - sin * rod.sin,
        sin * rod.cos + cos * rod.sin,
    )
    made[step.slider] = motion.slider
    made[pin_of(step.slider)] = _on_guide(motion.slider, height, own.direction)


def _place_swivel(step: SwivelStep, own: SwivelSize, made: Made) -> None:
    motion = swivel(SwivelEnds(made[step.pin], made[step.pivot]), Swivel(own.offset, own.way))
    made[step.slider], made[step.guide] = motion


def _place_yoke(step: YokeStep, own: YokeSize, made: Made) -> None:
    height = _height(made, step.through, own.direction, own.offset)
    motion = yoke(_in_guide(made, step.pin, own.direction), Yoke(height, own.slot_angle))
    made[step.slider] = motion.slider
    made[pin_of(step.slider)] = _on_guide(motion.slider, height, own.direction)


def _place_trammel(step: TrammelStep, own: TrammelSize, made: Made) -> None:
    height = _height(made, step.through, own.direction, own.offset)
    motion = trammel(turned_link(made[step.link], own.direction), Trammel(height, own.shift))
    made[step.slider] = motion.slider
    made[pin_of(step.slider)] = _on_guide(motion.slider, height, own.direction)


def _place_point(step: PointStep, own: PointSize, made: Made) -> None:
    made[step.point] = point(made[step.link], LinkPoint(*own))


def _place_mount(step: MountStep, own: PointSize, made: Made) -> None:
    pin_x, pin_y = made[step.pin]
    x, y = own.radius * np.cos(own.direction), own.radius * np.sin(own.direction)
    made[step.point] = Point(pin_x._replace(value=pin_x.value + x), pin_y._replace(value=pin_y.value + y))


def _place_triad(step: TriadStep, own: TriadSize, link: Link, made: Made) -> None:
    made[step.link] = link
    for leg, size in zip(step.legs, own.legs, strict=True):
        joint = point(link, LinkPoint(*size.joint))
        if isinstance(leg, RodLegStep):
            made[leg.joint] = joint
            made[leg.rod] = rod_between(RodEnds(made[leg.rod_from], joint))
        elif isinstance(size, GuideLegSize):
            made[leg.slider] = turned(joint, size.direction).x
            made[pin_of(leg.slider)] = joint


def _triad_motion(structure: Structure, place: int, angle: Array, size: ChainSize, made: Made) -> TriadMotion:
    step, own = structure.steps[place], size.steps[place]
    assert isinstance(step, TriadStep)
    assert isinstance(own, TriadSize)
    start = start_at(triad_branch(structure, place, size), angle)
    return triad(TriadDriver(triad_ends(step, own, made), start), triad_legs(own))


_PLACED: Mapping[type, Callable[[Any, Any, Made], None]] = {
    PinStep: _place_pin,
    SlideStep: _place_slide,
    SwivelStep: _place_swivel,
    YokeStep: _place_yoke,
    TrammelStep: _place_trammel,
    PointStep: _place_point,
    MountStep: _place_mount,
}


class _Alike:
    """A chain down to one of its groups, to be looked up: alike where its structure and all its numbers are."""

    def __init__(self, structure: Structure, size: ChainSize) -> None:
        arrays = [np.asarray(leaf) for leaf in leaves(size)]
        self._parts: Hashable = (structure, *((array.shape, array.tobytes()) for array in arrays))

    def __hash__(self) -> int:
        return hash(self._parts)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Alike) and self._parts == other._parts


_WALKS = Walks()


def triad_branch(structure: Structure, place: int, size: ChainSize) -> Branch:
    """Branch of a chain's triad round the turn.

    Parameters
    ----------
    structure : Structure
    place : int
        Of the triad among the chain's groups.
    size : ChainSize, fields broadcastable to (..., 1)

    Returns
    -------
    Branch
        For `start_at`.
    """
    above = structure._replace(steps=structure.steps[:place])
    step, own = structure.steps[place], size.steps[place]
    assert isinstance(step, TriadStep)
    assert isinstance(own, TriadSize)
    upper = size._replace(steps=size.steps[:place])
    key = _Alike(structure._replace(steps=structure.steps[: place + 1]), size._replace(steps=size.steps[: place + 1]))
    shape = np.broadcast_shapes((1,), *(np.shape(leaf) for leaf in leaves(size)))

    def ends(angle: Array) -> TriadEnds:
        return triad_ends(step, own, chain_made(above, angle + np.zeros(shape), upper))

    return _WALKS.branch(key, ends, triad_legs(own), own.start)


def triad_ends(step: TriadStep, own: TriadSize, made: Made) -> TriadEnds:
    """Outer ends of a triad's legs."""
    return TriadEnds(*(_leg_end(leg, size, made) for leg, size in zip(step.legs, own.legs, strict=True)))


def _leg_end(leg: RodLegStep | GuideLegStep, size: RodLegSize | GuideLegSize, made: Made) -> Link:
    """Outer end of a leg: the point that its rod is on, or its guide."""
    if isinstance(leg, RodLegStep):
        return rod_end(made[leg.rod_from])
    assert isinstance(size, GuideLegSize)
    through = made[leg.through]
    return fixed_guide(through.x.value, through.y.value, size.direction)


def triad_legs(own: TriadSize) -> Triad:
    """Legs as the kernel takes them."""
    return Triad(
        *(
            Leg(LinkPoint(*leg.joint), leg.length, ROD)
            if isinstance(leg, RodLegSize)
            else Leg(LinkPoint(*leg.joint), leg.offset, GUIDE)
            for leg in own.legs
        )
    )


def _gap_of_triad(branch: Branch, ends: TriadEnds, own: TriadSize, motion: TriadMotion) -> Array:
    """Square of the transmission, which must keep its sign; where the link cannot be, what one leg lacks. [m]

    Toward the end of a branch the transmission goes as the root of what is left of a length.
    """
    legs = triad_legs(own)
    firmness = motion.transmission**2 / np.maximum.reduce([leg.point.radius for leg in legs])
    is_open = np.isnan(firmness)
    if not np.any(is_open):
        return firmness
    # What is lost within a walk's last step may still close by a hair.
    return np.where(is_open, -np.maximum(lacking(branch, ends, legs, is_open), _HAIR), firmness)


_HAIR = float(np.finfo(float).tiny)


def _gap_of_pin(step: PinStep, own: PinSize, made: Made, radius: Array) -> Array:
    del radius
    return pin_gap(Ends(made[step.rod_from], made[step.rocker_from]), Pin(*own))


def _gap_of_slide(step: SlideStep, own: SlideSize, made: Made, radius: Array) -> Array:
    del radius
    height = _height(made, step.through, own.direction, own.offset)
    return slide_gap(_in_guide(made, step.rod_from, own.direction), Slide(own.rod_length, height, own.way))


def _gap_of_swivel(step: SwivelStep, own: SwivelSize, made: Made, radius: Array) -> Array:
    """As of a swivel; less what the pivot is on the wrong side of a crank pin's circle, through which it has come."""
    del radius
    ends = SwivelEnds(made[step.pin], made[step.pivot])
    nearest = _distance(ends.pivot) - _distance(ends.pin)
    crossed = own.outside * (own.outside * np.abs(nearest) - nearest)
    return swivel_gap(ends, Swivel(own.offset, own.way)) - crossed


def _distance(moving: Point) -> Array:
    return np.hypot(moving.x.value, moving.y.value)


def _gap_of_yoke(step: YokeStep, own: YokeSize, made: Made, radius: Array) -> Array:
    return radius * np.abs(np.sin(own.slot_angle)) + 0.0 * made[step.pin].x.value


def _gap_of_trammel(step: TrammelStep, own: TrammelSize, made: Made, radius: Array) -> Array:
    return radius * own.side * trammel_transmission(turned_link(made[step.link], own.direction))


def _gap_of_point(step: PointStep, own: PointSize, made: Made, radius: Array) -> Array:
    del own
    return radius + 0.0 * made[step.link].cos


def _gap_of_mount(step: MountStep, own: PointSize, made: Made, radius: Array) -> Array:
    del own
    return radius + 0.0 * made[step.pin].x.value


_GAPS: Mapping[type, Callable[[Any, Any, Made, Array], Array]] = {
    PinStep: _gap_of_pin,
    SlideStep: _gap_of_slide,
    SwivelStep: _gap_of_swivel,
    YokeStep: _gap_of_yoke,
    TrammelStep: _gap_of_trammel,
    PointStep: _gap_of_point,
    MountStep: _gap_of_mount,
}
