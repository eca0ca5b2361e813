"""One group of a chain, but the triad, put on what those above it made."""

import numpy as np

from cranktrain.linkage import (
    Crank,
    Ends,
    LinkPoint,
    Pin,
    Slide,
    Swivel,
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
from cranktrain.linkage.change_point import Hinged
from cranktrain.mechanisms.chain.groups import SHAFT, Made, pin_of, slot_of
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    MountStep,
    PinStep,
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
from cranktrain.mechanisms.change_points import FORMS
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


def placed(step: Step, own: StepSize, made: Made) -> Made:
    """What one group makes, which is no triad, on what those above it made."""
    match step, own:
        case PinStep(), Pin():
            ends = Ends(made[step.rod_from], made[step.rocker_from])
            motion = FORMS[step.form](Hinged(ends, made[step.hinge]), own) if step.form else pin(ends, own)
            return {step.joint: motion.joint, step.rod: motion.rod, step.rocker: motion.rocker}
        case SlideStep(), SlideSize():
            height = guide_offset(made, step.through, own.direction, own.offset)
            motion = slide(turned(made[step.rod_from], own.direction), Slide(own.rod_length, height, own.way))
            rod = _in_file(motion.rod, made[step.rod_from], own.direction)
            return {step.rod: rod, **_on_guide(step.slider, motion.slider, height, own.direction)}
        case SwivelStep(), SwivelSize():
            motion = swivel(Ends(made[step.pin], made[step.pivot]), Swivel(own.offset, own.way))
            return {step.slider: motion.slider, step.guide: motion.guide}
        case YokeStep(), YokeSize():
            height = guide_offset(made, step.through, own.direction, own.offset)
            motion = yoke(turned(made[step.pin], own.direction), Yoke(height, own.slot_angle))
        case TrammelStep(), TrammelSize():
            height = guide_offset(made, step.through, own.direction, own.offset)
            motion = trammel(turned_link(made[step.link], own.direction), Trammel(height, own.shift))
        case PointStep(), LinkPoint():
            return {step.point: point(made[step.link], own)}
        case MountStep(), LinkPoint():
            return {step.point: beside(made[pin_of(step.slider)], own)}
        case _:
            raise TypeError(step)
    slider = _on_guide(step.slider, motion.slider, height, own.direction)
    return {**slider, slot_of(step.slider): motion.block}


def _on_guide(name: str, slider: Coefficient, height: Array, direction: Array) -> Made:
    """Slider, and its pin in the file's axes."""
    cos, sin = np.cos(direction), np.sin(direction)
    place = Point(
        Coefficient(cos * slider.value - sin * height, cos * slider.first, cos * slider.second),
        Coefficient(sin * slider.value + cos * height, sin * slider.first, sin * slider.second),
    )
    return {name: slider, pin_of(name): place}


def _in_file(rod: Link, start: Point, direction: Array) -> Link:
    """Rod of a slider in the file's axes."""
    cos, sin = np.cos(direction), np.sin(direction)
    angle = rod.angle._replace(value=rod.angle.value + direction)
    return Link(start, angle, cos * rod.cos - sin * rod.sin, sin * rod.cos + cos * rod.sin)


def beside(place: Point, own: LinkPoint) -> Point:
    """Point that keeps so far from another, in a direction that does not turn."""
    x, y = own.radius * np.cos(own.angle), own.radius * np.sin(own.angle)
    return Point(place.x._replace(value=place.x.value + x), place.y._replace(value=place.y.value + y))
