"""What the groups of a chain make, by name."""

from typing import Any, TypeAlias

from cranktrain.mechanisms.chain.steps import (
    GuideLegStep,
    MountStep,
    PinStep,
    PointStep,
    RodLegStep,
    SlideStep,
    Step,
    Structure,
    SwivelStep,
    TrammelStep,
    TriadStep,
    YokeStep,
)
from cranktrain.motion import Coefficient, Link, Point

SHAFT = "O"
"""Name of the shaft's centre."""

Part: TypeAlias = Point | Link | Coefficient
"""A point, a link or a slider."""

Made: TypeAlias = dict[str, Any]
"""Each `Part` by its name, which says what it is."""


def pin_of(name: str) -> str:
    """Name of the point that a crank or a slider gives."""
    return f"{name}.pin"


def slot_of(slider: str) -> str:
    """Name of what slides in the slot that drives a slider, or that it drives."""
    return f"{slider}.slot"


def made_names(structure: Structure) -> tuple[str, ...]:
    """Names of all that a chain makes, in order."""
    pins = [pin_of(name) for name in structure.cranks]
    return (SHAFT, *structure.fixed, *pins, *(name for step in structure.steps for name in made_by(step)))


def made_by(step: Step | RodLegStep | GuideLegStep) -> dict[str, str]:
    """Names of what a group makes, in order; what sort of thing each is: a point, link, slider or block."""
    match step:
        case PinStep():
            return {step.joint: "point", step.rod: "link", step.rocker: "link"}
        case SlideStep():
            return {step.rod: "link", **_slider(step.slider)}
        case SwivelStep():
            return {step.slider: "slider", step.guide: "link"}
        case YokeStep() | TrammelStep():
            return {**_slider(step.slider), slot_of(step.slider): "block"}
        case GuideLegStep():
            return _slider(step.slider)
        case PointStep() | MountStep():
            return {step.point: "point"}
        case RodLegStep():
            return {step.joint: "point", step.rod: "link"}
        case TriadStep():
            return {step.link: "link"} | {name: sort for leg in step.legs for name, sort in made_by(leg).items()}


def _slider(name: str) -> dict[str, str]:
    return {name: "slider", pin_of(name): "point"}
