"""A chain, to be drawn."""

import numpy as np

from cranktrain.linkage import LinkPoint
from cranktrain.mechanisms.chain.groups import SHAFT, Made, each_part, end_of, guide_directions, pin_of, slot_of
from cranktrain.mechanisms.chain.kinematics import chain_made
from cranktrain.mechanisms.chain.placing import beside, guide_offset
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    GuideLegStep,
    MountStep,
    PinStep,
    PointStep,
    RodLegStep,
    SlideStep,
    Structure,
    SwivelStep,
    TrammelStep,
    TriadStep,
    YokeSize,
    YokeStep,
)
from cranktrain.mechanisms.drawing import Block, Drawing, DrawnLink, Guide
from cranktrain.mechanisms.rocking_guide import slot_points
from cranktrain.motion import Array, Point, chosen
from cranktrain.numerics import turn_grid

_COARSE = turn_grid(72)

_BEYOND = 0.2
"""How far a slot or a guide goes on beyond what slides in it, in parts of its way."""


def chain_drawing(structure: Structure, angle: Array, size: ChainSize) -> Drawing:
    """All points at each angle, shape (..., n), and what joins them; the output's guide comes first."""
    made = chain_made(structure, angle, size)
    links = [DrawnLink("crank" if name == "main" else name, (SHAFT, pin_of(name))) for name in structure.cranks]
    guides = [Guide(pin_of(name), direction) for name, direction in guide_directions(structure, size).items()]
    blocks: list[Block] = []
    ends: list[str] = []
    for step, own in each_part(structure, size):
        match step:
            case PinStep():
                links.append(DrawnLink(step.rod, (step.rod_from, step.joint)))
                links.append(DrawnLink(step.rocker, (step.rocker_from, step.joint)))
            case SlideStep():
                links.append(DrawnLink(step.rod, (step.rod_from, pin_of(step.slider))))
            case SwivelStep():
                reach = np.max(np.abs(_on_turn(structure, size, step.slider)), -1, keepdims=True)
                slot = slot_points(made[step.guide], 1.1 * own.way * reach, own.offset)
                end, *foot = names = [end_of(step.guide), f"{step.guide}.foot"][: len(slot)]
                ends += names
                made |= zip(names, slot, strict=True)
                blocks.append(Block(step.pin, (*(foot or [step.pivot]), end)))
                links.append(DrawnLink(step.guide, (step.pivot, *names)))
            case PointStep():
                links = [one._replace(pins=(*one.pins, step.point)) if one.name == step.link else one for one in links]
            case YokeStep():
                slot = _slot_of_yoke(step, own, made, _on_turn(structure, size, slot_of(step.slider)))
                start, end = slot
                ends += slot
                made |= slot
                blocks.append(Block(step.pin, (pin_of(step.slider),)))
                links.append(DrawnLink(step.slider, (start, pin_of(step.slider), end)))
            case TrammelStep():
                slotted = next(one.pins for one in links if one.name == step.link)
                blocks.append(Block(pin_of(step.slider), slotted[:2]))
            case MountStep():
                links.append(DrawnLink(step.point, (pin_of(step.slider), step.point)))
            case RodLegStep():
                links.append(DrawnLink(step.rod, (step.rod_from, step.joint)))
            case GuideLegStep():
                pass
            case TriadStep():
                pins = [leg.joint if isinstance(leg, RodLegStep) else pin_of(leg.slider) for leg in step.legs]
                links.append(DrawnLink(step.link, (*pins, pins[0])))
    fixed = (SHAFT, *structure.fixed)
    points = {name: part for name, part in made.items() if isinstance(part, Point)}
    return Drawing(
        pins=points,
        links=tuple(links),
        guides=tuple(sorted(guides, key=lambda guide: guide.pin != pin_of(structure.output))),
        fixed=fixed,
        paths=tuple(name for name in points if name not in (*fixed, *ends)),
        blocks=tuple(blocks),
        ends=tuple(ends),
    )


def _on_turn(structure: Structure, size: ChainSize, name: str) -> Array:
    """Where about a slider or a block is over a turn, along its guide or slot, shape (..., n). [m]"""
    return chain_made(structure, _COARSE, size)[name].value


def _beyond(places: Array) -> tuple[Array, Array]:
    """Where a slot or a guide begins and ends in which something slides, shape (..., 1). [m]"""
    low, high = (of(places, axis=-1, keepdims=True) for of in (np.fmin.reduce, np.fmax.reduce))
    return low - _BEYOND * (high - low), high + _BEYOND * (high - low)


def _slot_of_yoke(step: YokeStep, own: YokeSize, made: Made, places: Array) -> dict[str, Point]:
    """Both ends of a slotted slider's slot, which reaches to the slider's pin."""
    low, high = _beyond(places)
    ends = {f"{step.slider}.begin": np.fmin(low, 0.0), end_of(step.slider): np.fmax(high, 0.0)}
    angle = own.direction + own.slot_angle
    return {name: beside(made[pin_of(step.slider)], LinkPoint(along, angle)) for name, along in ends.items()}


def guide_end(structure: Structure, slider: str, size: ChainSize) -> tuple[Array, Array]:
    """X and y of that end of a slider's fixed guide which is farther from the point beside which it goes. [m]"""
    made = chain_made(structure, _COARSE, size)
    step, own = next(
        (step, own)
        for step, own in each_part(structure, size)
        if isinstance(step, SlideStep | YokeStep | TrammelStep | GuideLegStep) and step.slider == slider
    )
    cos, sin = np.cos(own.direction), np.sin(own.direction)
    through = cos * made[step.through].x.value + sin * made[step.through].y.value
    begin, end = _beyond(made[slider].value)
    along = chosen(np.abs(begin - through) > np.abs(end - through), begin, end)
    height = guide_offset(made, step.through, own.direction, own.offset)
    return cos * along - sin * height, sin * along + cos * height
