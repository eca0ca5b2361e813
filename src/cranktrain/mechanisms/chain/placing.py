"""One group of a chain, but the triad, put on what those above it made."""

from collections.abc import Callable, Mapping
from typing import Any

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
    point,
    slide,
    swivel,
    trammel,
    turned,
    turned_link,
    yoke,
)
from cranktrain.mechanisms.chain.made import SHAFT, Made, pin_of, slot_of
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    MountStep,
    PinSize,
    PinStep,
    PointSize,
    PointStep,
    SlideSize,
    SlideStep,
    Step,
    StepSize,
    Structure,
    SwivelSize,
    SwivelStep,
    TrammelSize,
    TrammelStep,
    YokeSize,
    YokeStep,
)
from cranktrain.motion import Array, Coefficient, Link, Point, single


def driven(structure: Structure, angle: Array, size: ChainSize) -> Made:
    """Shaft, fixed points and crank pins."""
    made: Made = {SHAFT: fixed(single(0.0), single(0.0))}
    made |= {name: fixed(*place) for name, place in zip(structure.fixed, size.fixed, strict=True)}
    for name, own in zip(structure.cranks, size.cranks, strict=True):
        made[pin_of(name)] = crank(angle + own.ahead, Crank(own.radius))
    return made


def guide_offset(made: Made, through: str, direction: Array, offset: Array) -> Array:
    """Offset of a guide from the shaft, in its own axes."""
    place = made[through]
    return offset + np.cos(direction) * place.y.value - np.sin(direction) * place.x.value


def in_guide(made: Made, name: str, direction: Array) -> Point:
    """Point in a guide's axes."""
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
    height = guide_offset(made, step.through, own.direction, own.offset)
    motion = slide(in_guide(made, step.rod_from, own.direction), Slide(own.rod_length, height, own.way))
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
    height = guide_offset(made, step.through, own.direction, own.offset)
    motion = yoke(in_guide(made, step.pin, own.direction), Yoke(height, own.slot_angle))
    made[step.slider] = motion.slider
    made[pin_of(step.slider)] = _on_guide(motion.slider, height, own.direction)
    made[slot_of(step.slider)] = motion.block


def _place_trammel(step: TrammelStep, own: TrammelSize, made: Made) -> None:
    height = guide_offset(made, step.through, own.direction, own.offset)
    motion = trammel(turned_link(made[step.link], own.direction), Trammel(height, own.shift))
    made[step.slider] = motion.slider
    made[pin_of(step.slider)] = _on_guide(motion.slider, height, own.direction)
    made[slot_of(step.slider)] = motion.block


def _place_point(step: PointStep, own: PointSize, made: Made) -> None:
    made[step.point] = point(made[step.link], LinkPoint(*own))


def _place_mount(step: MountStep, own: PointSize, made: Made) -> None:
    pin_x, pin_y = made[step.pin]
    x, y = own.radius * np.cos(own.direction), own.radius * np.sin(own.direction)
    made[step.point] = Point(pin_x._replace(value=pin_x.value + x), pin_y._replace(value=pin_y.value + y))


_PLACED: Mapping[type, Callable[[Any, Any, Made], None]] = {
    PinStep: _place_pin,
    SlideStep: _place_slide,
    SwivelStep: _place_swivel,
    YokeStep: _place_yoke,
    TrammelStep: _place_trammel,
    PointStep: _place_point,
    MountStep: _place_mount,
}


def place_group(step: Step, own: StepSize, made: Made) -> None:
    """Add what one group makes, which is no triad."""
    _PLACED[type(step)](step, own, made)
