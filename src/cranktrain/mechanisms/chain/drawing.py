"""A chain, to be drawn."""

import numpy as np

from cranktrain.linkage import LinkPoint, point
from cranktrain.mechanisms.chain.groups import SHAFT, each_part, guide_directions, pin_of
from cranktrain.mechanisms.chain.kinematics import chain_made
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
    YokeStep,
)
from cranktrain.mechanisms.drawing import Block, Drawing, DrawnLink, Guide
from cranktrain.motion import Array, Point
from cranktrain.numerics import turn_grid

_COARSE = turn_grid(72)


def chain_drawing(structure: Structure, angle: Array, size: ChainSize) -> Drawing:
    """All points at each angle, shape (..., n), and what joins them; the output's guide comes first."""
    made = chain_made(structure, angle, size)
    links = [DrawnLink("crank" if name == "main" else name, (SHAFT, pin_of(name))) for name in structure.cranks]
    guides = [Guide(pin_of(name), direction) for name, direction in guide_directions(structure, size).items()]
    blocks: list[Block] = []
    ends: list[str] = []
    for step, _own in each_part(structure, size):
        match step:
            case PinStep():
                links.append(DrawnLink(step.rod, (step.rod_from, step.joint)))
                links.append(DrawnLink(step.rocker, (step.rocker_from, step.joint)))
            case SlideStep():
                links.append(DrawnLink(step.rod, (step.rod_from, pin_of(step.slider))))
            case SwivelStep():
                reach = np.max(np.abs(chain_made(structure, _COARSE, size)[step.slider].value), -1, keepdims=True)
                end = f"{step.guide}.end"
                ends.append(end)
                blocks.append(Block(step.pin, (step.pivot, end)))
                made[end] = point(made[step.guide], LinkPoint(1.1 * reach, 0.0 * reach))
                links.append(DrawnLink(step.guide, (step.pivot, end)))
            case PointStep():
                links = [one._replace(pins=(*one.pins, step.point)) if one.name == step.link else one for one in links]
            case YokeStep():
                blocks.append(Block(step.pin, (pin_of(step.slider),)))
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
        paths=tuple(name for name in points if name not in fixed),
        blocks=tuple(blocks),
        ends=tuple(ends),
    )
