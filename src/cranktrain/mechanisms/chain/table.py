"""A chain's structure and numbers from its table."""

from collections.abc import Iterator, Mapping

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import _
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
from cranktrain.mechanisms.chain.triads import triad_at
from cranktrain.mechanisms.spec import Master
from cranktrain.motion import Array, single
from cranktrain.wording import precise

_SIDES = {"left": 1.0, "right": -1.0, "ahead": 1.0, "behind": -1.0}


def chain_geometry(spec: ChainTable, _master: Master | None) -> ChainSize:
    """All numbers in SI, in the order of the file."""
    near = {part.link: _near(part) for part in spec.part if isinstance(part, TriadPartSpec)}
    return assembled(*_chain(spec), near)


def structure_of(spec: ChainTable) -> Structure:
    """What the chain is made of, without its numbers."""
    return _chain(spec)[0]


def _chain(spec: ChainTable) -> tuple[Structure, ChainSize]:
    """What the chain is made of, and its numbers, of which `assembled` finds some."""
    guides = _guides(spec)
    groups = [_group(part, guides) for part in spec.part]
    return (
        Structure(tuple(spec.crank), tuple(spec.fixed), tuple(step for step, _size in groups), spec.output),
        ChainSize(
            tuple(CrankSize(single(one.radius.si), single(one.angle.si)) for one in spec.crank.values()),
            tuple(Coordinates(single(x.si), single(y.si)) for x, y in spec.fixed.values()),
            tuple(size for _step, size in groups),
        ),
    )


def _guides(spec: ChainTable) -> dict[str, ChainGuideSpec]:
    """Guides by what slides in them."""
    parts = [part for part in spec.part if isinstance(part, SlidePartSpec | YokePartSpec | TrammelPartSpec)]
    legs = [leg for part in spec.part if isinstance(part, TriadPartSpec) for leg in part.leg]
    of_legs = {leg.slider: leg.guide for leg in legs if leg.slider is not None and leg.guide is not None}
    return {part.slider: part.guide for part in parts} | of_legs


def _near(part: TriadPartSpec) -> Array:
    """Where about the joints of a triad's link are said to lie, shape (3, 2); NaN where nothing is said. [m]"""
    return np.array([[at.si for at in leg.near] if leg.near is not None else [np.nan] * 2 for leg in part.leg])


def _guide(guide: ChainGuideSpec) -> tuple[Array, Array]:
    return single(guide.direction.si), single(guide.offset.si)


def _joint(along: float, across: float, turned: float = 0.0) -> LinkPoint:
    return LinkPoint(single(float(np.hypot(along, across))), single(turned + float(np.arctan2(across, along))))


def _group(part: PartSpec, guides: Mapping[str, ChainGuideSpec]) -> tuple[Step, StepSize]:
    """One part by names, and its numbers; what `assembled` finds stands as nothing."""
    match part:
        case PinPartSpec(rod=rod, rocker=rocker):
            return (
                PinStep(rod.start, rocker.start, rod.name, rocker.name, part.joint),
                Pin(single(rod.length.si), single(rocker.length.si), single(_SIDES[part.side])),
            )
        case SlidePartSpec(rod=rod, guide=guide):
            return (
                SlideStep(rod.start, rod.name, part.slider, guide.through),
                SlideSize(single(rod.length.si), single(_SIDES[part.side]), *_guide(guide)),
            )
        case SwivelPartSpec(guide=swinging):
            return (
                SwivelStep(part.pin, swinging.start, swinging.name, part.slider),
                SwivelSize(single(swinging.offset.si), single(_SIDES[part.side]), single(0.0)),
            )
        case YokePartSpec(guide=guide):
            return (
                YokeStep(part.pin, part.slider, guide.through),
                YokeSize(single(part.slot_angle.si), *_guide(guide)),
            )
        case TrammelPartSpec(guide=guide):
            return (
                TrammelStep(part.link, part.slider, guide.through),
                TrammelSize(single(part.shift.si), *_guide(guide), single(1.0)),
            )
        case PointPartSpec() if part.link in guides:
            turned = guides[part.link].direction.si
            return MountStep(part.link, part.name), _joint(part.along.si, part.across.si, turned)
        case PointPartSpec():
            return PointStep(part.link, part.name), _joint(part.along.si, part.across.si)
        case TriadPartSpec():
            legs = [_leg(leg) for leg in part.leg]
            return (
                TriadStep(part.link, tuple(step for step, _size in legs)),
                TriadSize(tuple(size for _step, size in legs), NO_START),
            )


def _leg(leg: TriadLegSpec) -> tuple[RodLegStep | GuideLegStep, RodLegSize | GuideLegSize]:
    joint = _joint(leg.along.si, leg.across.si)
    if leg.rod is not None and leg.joint is not None:
        return RodLegStep(leg.rod.start, leg.rod.name, leg.joint), RodLegSize(joint, single(leg.rod.length.si))
    assert leg.guide is not None  # the spec asks for one of the two
    assert leg.slider is not None
    return GuideLegStep(leg.slider, leg.guide.through), GuideLegSize(joint, *_guide(leg.guide))


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
            ways = "; ".join(_joints(part, mode.joints) for mode in modes)
            allowed = _(
                "fits in {n} ways where the crank lies along x; say where about a joint lies, near = [x, y] in a leg: "
                "{ways}"
            )
            yield Problem(f"part[{place}].link", part.link, allowed.format(n=len(modes), ways=ways))


def _joints(part: TriadPartSpec, joints: Array) -> str:
    """Say where the joints of a link lie."""
    return ", ".join(
        f"{leg.joint or leg.slider} ({precise(x)}, {precise(y)})" for leg, (x, y) in zip(part.leg, joints, strict=True)
    )
