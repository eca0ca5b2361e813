"""A chain's structure and numbers from its table."""

from collections.abc import Iterator, Mapping
from typing import TypeAlias

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import Listed, Words, _
from cranktrain.linkage import LinkPoint, Pin
from cranktrain.mechanisms.chain.assembly import assembled, made_above, modes_of
from cranktrain.mechanisms.chain.parts import (
    ChainGuideSpec,
    ChainTable,
    PartSpec,
    PinPartSpec,
    PointPartSpec,
    SlidePartSpec,
    SwivelPartSpec,
    TrammelPartSpec,
    TriadLegSpec,
    TriadPartSpec,
    YokePartSpec,
)
from cranktrain.mechanisms.chain.steps import (
    NO_START,
    ChainSize,
    Coordinates,
    CrankSize,
    GuideLegSize,
    GuideLegStep,
    MountStep,
    PinStep,
    PointStep,
    RodLegSize,
    RodLegStep,
    SlideSize,
    SlideStep,
    Step,
    StepSize,
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
from cranktrain.mechanisms.chain.through import with_forms
from cranktrain.mechanisms.chain.triads import triad_at
from cranktrain.mechanisms.change_points import NOT_CROSSED
from cranktrain.mechanisms.spec import Master
from cranktrain.motion import ZERO, Array, single
from cranktrain.numerics.designs import over_designs
from cranktrain.quantities import Given
from cranktrain.saying.wording import as_limit

_Near: TypeAlias = tuple[Coordinates, ...]

_SIDES = {"left": 1.0, "right": -1.0, "ahead": 1.0, "behind": -1.0}


def chain_geometry(spec: ChainTable, _master: Master | None) -> ChainSize:
    """All numbers in SI, in the order of the file."""
    structure, size = _chain(spec)
    near = {part.link: _near(part) for part in spec.part if isinstance(part, TriadPartSpec)}

    def put_together(own: tuple[ChainSize, *tuple[_Near, ...]]) -> ChainSize:
        return assembled(structure, own[0], dict(zip(near, map(np.array, own[1:]), strict=True)))

    return over_designs(put_together, (size, *near.values()))


def structure_of(spec: ChainTable) -> Structure:
    """What the chain is made of, without its numbers."""
    return _chain(spec)[0]


def _chain(spec: ChainTable) -> tuple[Structure, ChainSize]:
    """What the chain is made of, and its numbers, of which `assembled` finds some."""
    guides = _guides(spec)
    groups = [_group(part, guides) for part in spec.part]
    structure = Structure(tuple(spec.crank), tuple(spec.fixed), tuple(step for step, _size in groups), spec.output)
    size = ChainSize(
        tuple(CrankSize(one.radius.array, one.angle.array) for one in spec.crank.values()),
        tuple(Coordinates(x.array, y.array) for x, y in spec.fixed.values()),
        tuple(size for _step, size in groups),
    )
    crossed = frozenset(part.joint for part in spec.part if isinstance(part, PinPartSpec) and part.crossed)
    return with_forms(structure, size, crossed), size


def _guides(spec: ChainTable) -> dict[str, ChainGuideSpec]:
    """Guides by what slides in them."""
    parts = [part for part in spec.part if isinstance(part, SlidePartSpec | YokePartSpec | TrammelPartSpec)]
    legs = [leg for part in spec.part if isinstance(part, TriadPartSpec) for leg in part.leg]
    of_legs = {leg.slider: leg.guide for leg in legs if leg.slider is not None and leg.guide is not None}
    return {part.slider: part.guide for part in parts} | of_legs


def _near(part: TriadPartSpec) -> _Near:
    """Where about the joints of a triad's link are said to lie; NaN where nothing is said. [m]"""
    unsaid = Coordinates(single(np.nan), single(np.nan))
    return tuple(Coordinates(*(at.array for at in leg.near)) if leg.near is not None else unsaid for leg in part.leg)


def _guide(guide: ChainGuideSpec) -> tuple[Array, Array]:
    return guide.direction.array, guide.offset.array


def _joint(along: Given, across: Given, turned: Array = ZERO) -> LinkPoint:
    return LinkPoint(np.hypot(along.array, across.array), turned + np.arctan2(across.array, along.array))


def _group(part: PartSpec, guides: Mapping[str, ChainGuideSpec]) -> tuple[Step, StepSize]:
    """One part by names, and its numbers; what `assembled` finds stands as nothing."""
    match part:
        case PinPartSpec(rod=rod, rocker=rocker):
            return (
                PinStep(rod.start, rocker.start, rod.name, rocker.name, part.joint),
                Pin(rod.length.array, rocker.length.array, single(_SIDES[part.side])),
            )
        case SlidePartSpec(rod=rod, guide=guide):
            return (
                SlideStep(rod.start, rod.name, part.slider, guide.through),
                SlideSize(rod.length.array, single(_SIDES[part.side]), *_guide(guide)),
            )
        case SwivelPartSpec(guide=swinging):
            return (
                SwivelStep(part.pin, swinging.start, swinging.name, part.slider),
                SwivelSize(swinging.offset.array, single(_SIDES[part.side]), single(0.0)),
            )
        case YokePartSpec(guide=guide):
            return (
                YokeStep(part.pin, part.slider, guide.through),
                YokeSize(part.slot_angle.array, *_guide(guide)),
            )
        case TrammelPartSpec(guide=guide):
            return (
                TrammelStep(part.link, part.slider, guide.through),
                TrammelSize(part.shift.array, *_guide(guide), single(1.0)),
            )
        case PointPartSpec() if part.link in guides:
            turned = guides[part.link].direction.array
            return MountStep(part.link, part.name), _joint(part.along, part.across, turned)
        case PointPartSpec():
            return PointStep(part.link, part.name), _joint(part.along, part.across)
        case TriadPartSpec():
            legs = [_leg(leg) for leg in part.leg]
            return (
                TriadStep(part.link, tuple(step for step, _size in legs)),
                TriadSize(tuple(size for _step, size in legs), NO_START),
            )


def _leg(leg: TriadLegSpec) -> tuple[RodLegStep | GuideLegStep, RodLegSize | GuideLegSize]:
    joint = _joint(leg.along, leg.across)
    if leg.rod is not None and leg.joint is not None:
        return RodLegStep(leg.rod.start, leg.rod.name, leg.joint), RodLegSize(joint, leg.rod.length.array)
    assert leg.guide is not None  # the spec asks for one of the two
    assert leg.slider is not None
    return GuideLegStep(leg.slider, leg.guide.through), GuideLegSize(joint, *_guide(leg.guide))


def crossed_problems(spec: ChainTable) -> Iterator[Problem]:
    """Find links that would be crossed and are no parallelogram, with paths within the chain's table."""
    steps = structure_of(spec).steps
    for place, (part, step) in enumerate(zip(spec.part, steps, strict=True)):
        if isinstance(part, PinPartSpec) and isinstance(step, PinStep) and part.crossed and not step.form:
            yield Problem(f"part[{place}].crossed", "true", _(NOT_CROSSED))


def mode_problems(spec: ChainTable) -> Iterator[Problem]:
    """Find triads that fit in more than one way, without a word on which it is; with paths within the chain's table."""
    structure = structure_of(spec)
    for place, part in enumerate(spec.part):
        if not isinstance(part, TriadPartSpec) or any(leg.near is not None for leg in part.leg):
            continue
        size = chain_geometry(spec, None)
        step, own = triad_at(structure, place, size)
        modes = modes_of(step, own, made_above(structure, place, size))
        if len(modes) > 1:
            ways = Listed([_joints(part, mode.joints) for mode in modes], "; ")
            allowed = _(
                "fits in {n} ways where the crank lies along x; say where about a joint lies, near = [x, y] in a leg: "
                "{ways}"
            )
            yield Problem(f"part[{place}].link", part.link, allowed.format(n=len(modes), ways=ways))


def _joints(part: TriadPartSpec, joints: Array) -> Words:
    """Say where the joints of a link lie."""
    return Listed(
        [
            Listed((f"{leg.joint or leg.slider} (", as_limit(x), ", ", as_limit(y), ")"), "")
            for leg, (x, y) in zip(part.leg, joints, strict=True)
        ]
    )
