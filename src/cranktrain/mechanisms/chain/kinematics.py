"""Kinematics of a chain: the groups of its structure, one after the other, each on what those above it made."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from cranktrain.linkage import (
    Crank,
    Ends,
    LinkPoint,
    Pin,
    Slide,
    Swivel,
    SwivelEnds,
    Trammel,
    Yoke,
    crank,
    fixed,
    pin,
    pin_gap,
    point,
    slide,
    slide_gap,
    swivel,
    swivel_gap,
    trammel,
    trammel_transmission,
    turned,
    turned_link,
    yoke,
)
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    PinSize,
    PinStep,
    PointSize,
    PointStep,
    SlideSize,
    SlideStep,
    Step,
    Structure,
    SwivelSize,
    SwivelStep,
    TrammelSize,
    TrammelStep,
    YokeSize,
    YokeStep,
)
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
    return (SHAFT, *structure.fixed, *pins, *(name for step in structure.steps for name in _names(step)))


def _names(step: Step) -> tuple[str, ...]:
    match step:
        case PinStep():
            return step.joint, step.rod, step.rocker
        case SlideStep():
            return step.rod, step.slider, pin_of(step.slider)
        case SwivelStep():
            return step.slider, step.guide
        case YokeStep() | TrammelStep():
            return step.slider, pin_of(step.slider)
        case PointStep():
            return (step.point,)


def chain_made(structure: Structure, angle: Array, size: ChainSize) -> Made:
    """All points, links and sliders of a chain by name; parameters as of `chain_motion`."""
    made = _driven(structure, angle, size)
    for step, own in zip(structure.steps, size.steps, strict=True):
        _PLACED[type(step)](step, own, made)
    return made


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
    for step, own in zip(structure.steps, size.steps, strict=True):
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
    motion = swivel(SwivelEnds(made[step.pin], made[step.pivot]), Swivel(*own))
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


_PLACED: Mapping[type, Callable[[Any, Any, Made], None]] = {
    PinStep: _place_pin,
    SlideStep: _place_slide,
    SwivelStep: _place_swivel,
    YokeStep: _place_yoke,
    TrammelStep: _place_trammel,
    PointStep: _place_point,
}


def _gap_of_pin(step: PinStep, own: PinSize, made: Made, radius: Array) -> Array:
    del radius
    return pin_gap(Ends(made[step.rod_from], made[step.rocker_from]), Pin(*own))


def _gap_of_slide(step: SlideStep, own: SlideSize, made: Made, radius: Array) -> Array:
    del radius
    height = _height(made, step.through, own.direction, own.offset)
    return slide_gap(_in_guide(made, step.rod_from, own.direction), Slide(own.rod_length, height, own.way))


def _gap_of_swivel(step: SwivelStep, own: SwivelSize, made: Made, radius: Array) -> Array:
    del radius
    return swivel_gap(SwivelEnds(made[step.pin], made[step.pivot]), Swivel(*own))


def _gap_of_yoke(step: YokeStep, own: YokeSize, made: Made, radius: Array) -> Array:
    return radius * np.abs(np.sin(own.slot_angle)) + 0.0 * made[step.pin].x.value


def _gap_of_trammel(step: TrammelStep, own: TrammelSize, made: Made, radius: Array) -> Array:
    return radius * own.side * trammel_transmission(turned_link(made[step.link], own.direction))


def _gap_of_point(step: PointStep, own: PointSize, made: Made, radius: Array) -> Array:
    del own
    return radius + 0.0 * made[step.link].cos


_GAPS: Mapping[type, Callable[[Any, Any, Made, Array], Array]] = {
    PinStep: _gap_of_pin,
    SlideStep: _gap_of_slide,
    SwivelStep: _gap_of_swivel,
    YokeStep: _gap_of_yoke,
    TrammelStep: _gap_of_trammel,
    PointStep: _gap_of_point,
}


def with_sides(structure: Structure, size: ChainSize) -> ChainSize:
    """Give each trammel the side that it has where the crank `main` lies along x."""
    with np.errstate(all="ignore"):
        made = chain_made(structure, single(0.0), size)

    def sided(step: Any, own: Any) -> Any:
        if not isinstance(step, TrammelStep):
            return own
        side = float(np.sign(trammel_transmission(turned_link(made[step.link], own.direction))))
        return own._replace(side=single(side if side != 0.0 else 1.0))

    return size._replace(steps=tuple(map(sided, structure.steps, size.steps)))
