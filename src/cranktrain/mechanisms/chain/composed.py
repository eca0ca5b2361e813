"""A chain's structure and numbers from its table, and the kind that it is."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache, partial
from typing import Any

import numpy as np

from cranktrain.errors import Problem
from cranktrain.language import _
from cranktrain.mechanisms.chain.assembly import assembled, made_above, modes_of
from cranktrain.mechanisms.chain.drawing import chain_drawing
from cranktrain.mechanisms.chain.forces import chain_dynamics
from cranktrain.mechanisms.chain.kinematics import (
    SHAFT,
    ChainMotion,
    chain_gap,
    chain_gaps,
    chain_motion,
    made_by,
    made_names,
    pin_of,
    triad_branch,
)
from cranktrain.mechanisms.chain.spec import (
    ChainGuideSpec,
    ChainSpec,
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
    CrankSize,
    GuideLegSize,
    GuideLegStep,
    MountStep,
    PinSize,
    PinStep,
    Place,
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
from cranktrain.mechanisms.kind import Kind, Master
from cranktrain.motion import Array, single
from cranktrain.numerics import turn_grid
from cranktrain.wording import precise

_HUNG_ON = ("rod_from", "rocker_from", "pin", "pivot", "link", "through")
_SIDES = {"left": 1.0, "right": -1.0, "ahead": 1.0, "behind": -1.0}

_LENGTHS: dict[type, tuple[tuple[str, str], ...]] = {
    PinStep: (("rod_length", "rod.length"), ("rocker_length", "rocker.length")),
    SlideStep: (("rod_length", "rod.length"), ("offset", "guide.offset")),
    SwivelStep: (("offset", "guide.offset"),),
    YokeStep: (("offset", "guide.offset"),),
    TrammelStep: (("shift", "shift"), ("offset", "guide.offset")),
    PointStep: (("radius", "along"),),
    MountStep: (),
}
"""Lengths of each group but the triad: as its numbers call them, and as the file does."""

_WALKED = 1e-6
"""A walk round the turn tells to this, in parts of a length, whether a triad's link can pass."""

_LEG_LENGTHS: dict[type, tuple[str, str]] = {
    RodLegStep: ("length", "rod.length"),
    GuideLegStep: ("offset", "guide.offset"),
}


def chain_geometry(spec: ChainSpec, master: Master | None = None) -> ChainSize:
    """All numbers in SI, in the order of the file."""
    del master
    near = {part.link: _near(part) for part in spec.part if isinstance(part, TriadPartSpec)}
    return assembled(structure_of(spec), _size_of(spec), near)


def _size_of(spec: ChainSpec) -> ChainSize:
    guides = _guides(spec)
    return ChainSize(
        tuple(CrankSize(single(one.radius.si), single(one.angle.si)) for one in spec.crank.values()),
        tuple(Place(single(x.si), single(y.si)) for x, y in spec.fixed.values()),
        tuple(_size(part, guides) for part in spec.part),
    )


def _guides(spec: ChainSpec) -> dict[str, ChainGuideSpec]:
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


def _joint(along: float, across: float, turned: float = 0.0) -> PointSize:
    return PointSize(single(float(np.hypot(along, across))), single(turned + float(np.arctan2(across, along))))


def _size(part: PartSpec, guides: Mapping[str, ChainGuideSpec]) -> Any:
    """One part's numbers; what `assembled` finds stands as nothing."""
    match part:
        case PinPartSpec():
            return PinSize(single(part.rod.length.si), single(part.rocker.length.si), single(_SIDES[part.side]))
        case SlidePartSpec():
            return SlideSize(single(part.rod.length.si), single(_SIDES[part.side]), *_guide(part.guide))
        case SwivelPartSpec():
            return SwivelSize(single(part.guide.offset.si), single(_SIDES[part.side]), single(0.0))
        case YokePartSpec():
            return YokeSize(single(part.slot_angle.si), *_guide(part.guide))
        case TrammelPartSpec():
            return TrammelSize(single(part.shift.si), *_guide(part.guide), single(1.0))
        case PointPartSpec():
            turned = guides[part.link].direction.si if part.link in guides else 0.0
            return _joint(part.along.si, part.across.si, turned)
        case TriadPartSpec():
            return TriadSize(tuple(map(_leg_size, part.leg)), NO_START)


def _leg_size(leg: TriadLegSpec) -> RodLegSize | GuideLegSize:
    joint = _joint(leg.along.si, leg.across.si)
    if leg.rod is not None:
        return RodLegSize(joint, single(leg.rod.length.si))
    assert leg.guide is not None  # the spec asks for one of the two
    return GuideLegSize(joint, *_guide(leg.guide))


def structure_of(spec: ChainSpec) -> Structure:
    """What the chain is made of, without its numbers."""
    guides = _guides(spec)
    return Structure(
        tuple(spec.crank), tuple(spec.fixed), tuple(_step(part, guides) for part in spec.part), spec.output
    )


def _step(part: PartSpec, guides: Mapping[str, ChainGuideSpec]) -> Step:
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
            return MountStep(pin_of(part.link), part.name) if part.link in guides else PointStep(part.link, part.name)
        case TriadPartSpec():
            return TriadStep(part.link, tuple(map(_leg_step, part.leg)))


def _leg_step(leg: TriadLegSpec) -> RodLegStep | GuideLegStep:
    if leg.rod is not None and leg.joint is not None:
        return RodLegStep(leg.rod.start, leg.rod.name, leg.joint)
    assert leg.guide is not None  # the spec asks for one of the two
    assert leg.slider is not None
    return GuideLegStep(leg.slider, leg.guide.through)


def mode_problems(spec: ChainSpec) -> tuple[Problem, ...]:
    """Find triads that fit in more than one way, without a word on which it is; with paths within the chain's table."""
    found: list[Problem] = []
    structure = structure_of(spec)
    for place, part in enumerate(spec.part):
        if not isinstance(part, TriadPartSpec) or any(leg.near is not None for leg in part.leg):
            continue
        size, step = chain_geometry(spec), structure.steps[place]
        own = size.steps[place]
        assert isinstance(step, TriadStep)
        assert isinstance(own, TriadSize)
        modes = modes_of(step, own, made_above(structure, place, size))
        if len(modes) > 1:
            ways = "; ".join(_joints(part, mode.joints) for mode in modes)
            allowed = _(
                "fits in {n} ways where the crank lies along x; say where about a joint lies, near = [x, y] in a leg: "
                "{ways}"
            )
            found.append(Problem(f"part[{place}].link", part.link, allowed.format(n=len(modes), ways=ways)))
    return tuple(found)


def _joints(part: TriadPartSpec, joints: Array) -> str:
    """Say where the joints of a link lie."""
    return ", ".join(
        f"{leg.joint or leg.slider} ({precise(x)}, {precise(y)})" for leg, (x, y) in zip(part.leg, joints, strict=True)
    )


def chain_kind(base: Kind, spec: ChainSpec) -> Kind:
    """Give the kind of just this chain; chains alike but for their numbers are of one kind."""
    return _chain_kind(base, structure_of(spec))


@cache
def _chain_kind(base: Kind, structure: Structure) -> Kind:
    return replace(base, composed=None, **fields_of(structure))


def fields_of(structure: Structure) -> dict[str, Any]:
    """What a kind says that depends on the chain's structure."""
    places = tuple(_length_places(structure))
    return {
        "motion": partial(chain_motion, structure),
        "gap": partial(chain_gap, structure),
        "lengths": tuple(path for path, _name in places),
        "length_paths": tuple(name for _path, name in places),
        "drawing": partial(chain_drawing, structure),
        "closing_advice": partial(_advice, structure),
        "closing_field": partial(_stuck_part, structure),
        "dynamics": chain_dynamics(structure),
        "margin_precision": _WALKED if any(isinstance(step, TriadStep) for step in structure.steps) else 1e-15,
        **parts_of(structure),
    }


def parts_of(structure: Structure) -> dict[str, Any]:
    """What a kind says of the names in its motion: output, links, sliders, joints, and how to find them."""
    made = {name: sort for step in structure.steps for name, sort in made_by(step).items()}

    def named(sort: str) -> tuple[str, ...]:
        return tuple(name for name, own in made.items() if own == sort)

    return {
        "output": "slider" if structure.output in named("slider") else "rocker",
        "links": named("link"),
        "sliders": tuple(name for name in named("slider") if name != structure.output),
        "joints": (*(pin_of(name) for name in structure.cranks), *named("point")),
        "part": partial(_part_named, made_names(structure)),
    }


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
        for own, path in _lengths(step)
    ]
    return [*cranks, *fixed, *steps]


def _lengths(step: Step) -> Sequence[tuple[str, str]]:
    """Lengths of one group: as its numbers call them, and as the file does."""
    if not isinstance(step, TriadStep):
        return _LENGTHS[type(step)]
    return [
        (f"legs.{k}.{own}", f"leg[{k}].{path}")
        for k, leg in enumerate(step.legs)
        for own, path in (("joint.radius", "along"), _LEG_LENGTHS[type(leg)])
    ]


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
    place = _stuck(structure, size)
    step = structure.steps[place]
    groups = step.legs if isinstance(step, TriadStep) else (step,)
    named = [getattr(group, field) for group in groups for field in _HUNG_ON if hasattr(group, field)]
    said = _("it is the part that makes {made} on {on}").format(
        made=", ".join(name for name in made_by(step) if name not in map(pin_of, made_by(step))),
        on=", ".join(dict.fromkeys(name for name in named if name != SHAFT)) or SHAFT,
    )
    if isinstance(step, TriadStep) and np.any(triad_branch(structure, place, size).apart > 0):
        said = _("{part}; on each turn its link goes over to another assembly mode").format(part=said)
    return said
