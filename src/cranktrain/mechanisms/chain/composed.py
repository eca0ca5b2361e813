"""The kind that a chain is, from its structure."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache, partial, reduce
from typing import Any, TypeVar

import numpy as np

from cranktrain.language import Words, _
from cranktrain.mechanisms.by_hand import Handle
from cranktrain.mechanisms.chain.drawing import chain_drawing, guide_end
from cranktrain.mechanisms.chain.forces import chain_dynamics
from cranktrain.mechanisms.chain.gaps import chain_gap, chain_gaps
from cranktrain.mechanisms.chain.groups import SHAFT, Part, anatomy, end_of, guide_of, made_names, pin_of
from cranktrain.mechanisms.chain.kinematics import ChainMotion, chain_motion, triad_branch
from cranktrain.mechanisms.chain.margin import chain_openings
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
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
from cranktrain.mechanisms.chain.through import chain_change_points
from cranktrain.mechanisms.kind import ClosingPart, Geometry, Kind
from cranktrain.mechanisms.output import PISTON, ROCKER, OutputPart
from cranktrain.motion import Array

_Outcome = TypeVar("_Outcome")

_HUNG_ON = ("rod_from", "rocker_from", "pin", "pivot", "link", "through")

_LENGTHS: dict[type, tuple[tuple[str, str], ...]] = {
    PinStep: (("rod_length", "rod.length"), ("rocker_length", "rocker.length")),
    SlideStep: (("rod_length", "rod.length"), ("offset", "guide.offset")),
    SwivelStep: (("offset", "guide.offset"),),
    YokeStep: (("offset", "guide.offset"),),
    TrammelStep: (("shift", "shift"), ("offset", "guide.offset")),
    PointStep: (("radius", "along"),),
    MountStep: (),
    RodLegStep: (("joint.radius", "along"), ("length", "rod.length")),
    GuideLegStep: (("joint.radius", "along"), ("offset", "guide.offset")),
}
"""Lengths of each group, of a triad those of its legs: as its numbers call them, and as the file does."""


@cache
def kind_of_structure(
    base: Kind[ChainMotion, Geometry], fields: Callable[[Structure], dict[str, Any]], structure: Structure
) -> Kind[ChainMotion, Geometry]:
    """Give the kind of chains of one structure, alike but for their numbers: `fields` says what depends on it."""
    return replace(base, structure=structure, **fields(structure))


def fields_of(structure: Structure) -> dict[str, Any]:
    """What a kind says that depends on the chain's structure, where the file has the chain's numbers."""
    return {
        "closing_advice": partial(_closing_parts, structure),
        "handles": tuple(_handles(structure)),
        **as_chain(structure, _as_it_is, dict(_length_places(structure))),
    }


def _handles(structure: Structure) -> Iterator[Handle]:
    """Give the pins by which a chain's numbers are changed, of cranks, fixed points and groups, and ends of guides.

    Of triads there are only the latter.
    """
    for name in structure.cranks:
        yield Handle(pin_of(name), (f"crank.{name}.radius", f"crank.{name}.angle"))
    for name in structure.fixed:
        yield Handle(name, (f"fixed.{name}[0]", f"fixed.{name}[1]"))
    for place, step in enumerate(structure.steps):
        match step:
            case PinStep():
                pin, numbers = step.joint, ("rod.length", "rocker.length")
            case SlideStep():
                pin, numbers = pin_of(step.slider), ("rod.length", "guide.offset")
            case YokeStep() | TrammelStep():
                pin, numbers = pin_of(step.slider), ("guide.offset",)
            case PointStep() | MountStep():
                pin, numbers = step.point, ("along", "across")
            case SwivelStep():
                pin, numbers = end_of(step.guide), ("guide.offset",)
            case TriadStep():
                pin, numbers = "", ()
        if pin:
            yield Handle(pin, tuple(f"part[{place}].{number}" for number in numbers))
        for path, slider in _guided(step):
            at = partial(guide_end, structure, slider)
            yield Handle(guide_of(slider), (f"part[{place}].{path}guide.direction",), at, pin_of(slider))


def _guided(step: Step) -> Iterator[tuple[str, str]]:
    """Give the sliders of a group that are in fixed guides, each with where its guide stands in the group's table."""
    if isinstance(step, SlideStep | YokeStep | TrammelStep):
        yield "", step.slider
    elif isinstance(step, TriadStep):
        yield from ((f"leg[{k}].", leg.slider) for k, leg in enumerate(step.legs) if isinstance(leg, GuideLegStep))


def _as_it_is(size: ChainSize) -> ChainSize:
    return size


def as_chain(
    structure: Structure,
    size_of: Callable[[Geometry], ChainSize],
    lengths: Mapping[str, str],
    slider: OutputPart = PISTON,
) -> dict[str, Any]:
    """What a kind says whose mechanism is a chain: kernels, drawing, forces, and the names in its motion.

    Parameters
    ----------
    structure : Structure
    size_of : callable (geometry) → ChainSize
        Numbers of the chain from those of the kind, in the axes of the kind's motion.
    lengths : mapping
        Geometry fields that are lengths, to what the file calls them.
    slider : OutputPart
        What the output is where it slides.

    Returns
    -------
    dict
        Fields of `Kind`. A triad is walked for its margin; without one the gap is followed as any other kind's.
    """
    made = {name: own.sort for step in structure.steps for name, own in anatomy(step).made.items()}
    has_triad = any(isinstance(step, TriadStep) for step in structure.steps)

    def named(sort: str) -> tuple[str, ...]:
        return tuple(name for name, own in made.items() if own == sort)

    def of_geometry(
        of_chain: Callable[[Structure, Array, ChainSize], _Outcome],
    ) -> Callable[[Array, Geometry], _Outcome]:
        return lambda angle, geometry: of_chain(structure, angle, size_of(geometry))

    return {
        "motion": of_geometry(chain_motion),
        "gap": of_geometry(chain_gap),
        "drawing": of_geometry(chain_drawing),
        "dynamics": chain_dynamics(structure, size_of),
        "change_points": chain_change_points(structure),
        "openings": partial(chain_openings, structure, tuple(lengths), size_of) if has_triad else None,
        "lengths": tuple(lengths),
        "length_paths": tuple(lengths.values()),
        "output": slider if structure.output in named("slider") else ROCKER,
        "links": named("link"),
        "sliders": tuple(name for name in named("slider") if name != structure.output),
        "joints": (*(pin_of(name) for name in structure.cranks), *named("point")),
        "named": partial(_part_named, made_names(structure)),
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
        (f"legs.{k}.{own}", f"leg[{k}].{path}") for k, leg in enumerate(step.legs) for own, path in _LENGTHS[type(leg)]
    ]


def _part_named(names: tuple[str, ...], motion: ChainMotion, name: str) -> Part:
    """Link, slider or point of a chain's motion."""
    return motion.parts[names.index(name)]


def _closing_parts(structure: Structure, size: ChainSize) -> list[ClosingPart]:
    """Every group with its own gap: where one that it hangs on cannot close, it is not to blame."""
    return [
        ClosingPart(
            f"part[{place}]",
            _made_by(structure.steps[place]),
            _advice(structure, size, place),
            partial(_own_gap, structure, size, place),
        )
        for place in range(len(structure.steps))
    ]


def _made_by(step: Step) -> str:
    """Name a group by the joint or the slider that it makes."""
    made = anatomy(step).made
    return next((name for name, own in made.items() if own.sort != "link" and "." not in name), next(iter(made)))


def _own_gap(structure: Structure, size: ChainSize, place: int, angle: Array) -> Array:
    """Gap of one group; where it has none, by how much those before it cannot close, as if it had that to spare. [m]"""
    gaps = chain_gaps(structure, angle, size)
    spare = -reduce(np.fmin, gaps[:place], np.full_like(angle + size.cranks[0].radius, np.inf))
    return np.where(np.isnan(gaps[place]), spare, gaps[place])


def _advice(structure: Structure, size: ChainSize, place: int) -> Words:
    """Say which part it is, by what it makes, and what it hangs on."""
    step = structure.steps[place]
    groups = step.legs if isinstance(step, TriadStep) else (step,)
    named = [getattr(group, field) for group in groups for field in _HUNG_ON if hasattr(group, field)]
    said = _(
        "it is the part that makes {made} on {on}",
        made=", ".join(name for name in anatomy(step).made if "." not in name),
        on=", ".join(dict.fromkeys(name for name in named if name != SHAFT)) or SHAFT,
    )
    if isinstance(step, TriadStep) and np.any(triad_branch(structure, place, size).apart > 0):
        said = _("{part}; on each turn its link goes over to another assembly mode", part=said)
    return said
