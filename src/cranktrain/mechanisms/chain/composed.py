"""A chain's structure and numbers from its table, and the kind that it is."""

from collections.abc import Sequence
from dataclasses import replace
from functools import cache, partial
from typing import Any

import numpy as np

from cranktrain.language import _
from cranktrain.mechanisms.chain.drawing import chain_drawing
from cranktrain.mechanisms.chain.forces import chain_dynamics
from cranktrain.mechanisms.chain.kinematics import (
    SHAFT,
    ChainMotion,
    chain_gap,
    chain_gaps,
    chain_motion,
    made_names,
    with_sides,
)
from cranktrain.mechanisms.chain.naming import makes
from cranktrain.mechanisms.chain.spec import (
    ChainGuideSpec,
    ChainSpec,
    PartSpec,
    PinPartSpec,
    PointPartSpec,
    SlidePartSpec,
    SwivelPartSpec,
    TrammelPartSpec,
    YokePartSpec,
)
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    CrankSize,
    PinSize,
    PinStep,
    Place,
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
from cranktrain.mechanisms.kind import Kind, Master
from cranktrain.motion import Array, single
from cranktrain.numerics import turn_grid

_SIDES = {"left": 1.0, "right": -1.0, "ahead": 1.0, "behind": -1.0}

_LENGTHS: dict[type, tuple[tuple[str, str], ...]] = {
    PinStep: (("rod_length", "rod.length"), ("rocker_length", "rocker.length")),
    SlideStep: (("rod_length", "rod.length"), ("offset", "guide.offset")),
    SwivelStep: (("offset", "guide.offset"),),
    YokeStep: (("offset", "guide.offset"),),
    TrammelStep: (("shift", "shift"), ("offset", "guide.offset")),
    PointStep: (("radius", "along"),),
}
"""Lengths of each group: as its numbers call them, and as the file does."""


def chain_geometry(spec: ChainSpec, master: Master | None = None) -> ChainSize:
    """All numbers in SI, in the order of the file."""
    del master
    size = ChainSize(
        tuple(CrankSize(single(one.radius.si), single(one.angle.si)) for one in spec.crank.values()),
        tuple(Place(single(x.si), single(y.si)) for x, y in spec.fixed.values()),
        tuple(map(_size, spec.part)),
    )
    return with_sides(structure_of(spec), size)


def _guide(guide: ChainGuideSpec) -> tuple[Array, Array]:
    return single(guide.direction.si), single(guide.offset.si)


def _size(part: PartSpec) -> Any:
    match part:
        case PinPartSpec():
            return PinSize(single(part.rod.length.si), single(part.rocker.length.si), single(_SIDES[part.side]))
        case SlidePartSpec():
            return SlideSize(single(part.rod.length.si), single(_SIDES[part.side]), *_guide(part.guide))
        case SwivelPartSpec():
            return SwivelSize(single(part.guide.offset.si), single(_SIDES[part.side]))
        case YokePartSpec():
            return YokeSize(single(part.slot_angle.si), *_guide(part.guide))
        case TrammelPartSpec():
            return TrammelSize(single(part.shift.si), *_guide(part.guide), single(1.0))
        case PointPartSpec():
            along, across = part.along.si, part.across.si
            return PointSize(single(float(np.hypot(along, across))), single(float(np.arctan2(across, along))))


def structure_of(spec: ChainSpec) -> Structure:
    """What the chain is made of, without its numbers."""
    return Structure(tuple(spec.crank), tuple(spec.fixed), tuple(map(_step, spec.part)), spec.output)


def _step(part: PartSpec) -> Step:
    match part:
        case PinPartSpec():
            return PinStep(part.rod.start, part.rocker.start, part.rod.name, part.rocker.name, part.joint)
        case SlidePartSpec():
            return SlideStep(part.rod.start, part.rod.name, part.slider, part.guide.through)
        case SwivelPartSpec():
            return SwivelStep(part.pin, part.guide.start, part.guide.name, part.slider)
        case YokePartSpec():
            return YokeStep(part.pin, part.slider, part.guide.through)
        case TrammelPartSpec():
            return TrammelStep(part.link, part.slider, part.guide.through)
        case PointPartSpec():
            return PointStep(part.link, part.name)


def chain_kind(base: Kind, spec: ChainSpec) -> Kind:
    """Give the kind of just this chain; chains alike but for their numbers are of one kind."""
    made = tuple((one.name, one.sort) for part in spec.part for one in makes(part))
    return _chain_kind(base, structure_of(spec), made)


@cache
def _chain_kind(base: Kind, structure: Structure, made: tuple[tuple[str, str], ...]) -> Kind:
    def named(sort: str) -> tuple[str, ...]:
        return tuple(name for name, own in made if own == sort)

    places = tuple(_length_places(structure))
    is_slider = structure.output in named("slider")
    return replace(
        base,
        motion=partial(chain_motion, structure),
        gap=partial(chain_gap, structure),
        lengths=tuple(path for path, _name in places),
        length_paths=tuple(name for _path, name in places),
        output="slider" if is_slider else "rocker",
        links=named("link"),
        sliders=tuple(name for name in named("slider") if name != structure.output),
        joints=(*(f"{name}.pin" for name in structure.cranks), *named("point")),
        drawing=partial(chain_drawing, structure),
        part=partial(_part_named, made_names(structure)),
        closing_advice=partial(_advice, structure),
        closing_field=partial(_stuck_part, structure),
        dynamics=chain_dynamics(structure),
        composed=None,
    )


def _length_places(structure: Structure) -> Sequence[tuple[str, str]]:
    """Lengths by their place among the numbers, and by their path in the table."""
    cranks = [(f"cranks.{i}.radius", f"crank.{name}.radius") for i, name in enumerate(structure.cranks)]
    fixed = [
        (f"fixed.{i}.{axis}", f"fixed.{name}[{k}]")
        for i, name in enumerate(structure.fixed)
        for k, axis in enumerate("xy")
    ]
    steps = [
        (f"steps.{i}.{own}", f"part[{i}].{path}")
        for i, step in enumerate(structure.steps)
        for own, path in _LENGTHS[type(step)]
    ]
    return [*cranks, *fixed, *steps]


def _part_named(names: tuple[str, ...], motion: ChainMotion, name: str) -> Any:
    """Link, slider or point of a chain's motion."""
    return motion.parts[names.index(name)]


def _stuck(structure: Structure, size: ChainSize) -> int:
    """The first group that cannot close somewhere over the turn; otherwise the one that closes least."""
    with np.errstate(all="ignore"):
        least = [float(np.nanmin(np.append(gap, np.inf))) for gap in chain_gaps(structure, turn_grid(), size)]
    return next((place for place, gap in enumerate(least) if gap < 0), int(np.argmin(least)))


def _stuck_part(structure: Structure, size: ChainSize) -> str:
    return f"part[{_stuck(structure, size)}]"


def _advice(structure: Structure, size: ChainSize) -> str:
    """Say which part it is, by what it makes, and what it hangs on."""
    step = structure.steps[_stuck(structure, size)]
    named = {name: getattr(step, name) for name in step._fields}
    on = [named[field] for field in ("rod_from", "rocker_from", "pin", "pivot", "link", "through") if field in named]
    made = [name for name in named.values() if name not in on]
    return _("it is the part that makes {made} on {on}").format(
        made=", ".join(made), on=", ".join(name for name in on if name != SHAFT) or SHAFT
    )
