"""Names in a chain: what each part hangs on and what it makes; a part uses only names above it."""

import re
from collections.abc import Iterator
from math import sin
from typing import NamedTuple

from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.mechanisms.chain.made import SHAFT, pin_of
from cranktrain.mechanisms.chain.parts import (
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
from cranktrain.quantities import nearest

MAIN = "main"
_NAME = re.compile(r"[^\W\d]\w*")
_LEAST_SINE = 1e-3

_SORTS = {
    "point": N_("a point"),
    "link": N_("a link"),
    "fixed": N_("a fixed point"),
    "carrier": N_("a link or a slider in a fixed guide"),
}
_FITTING = {"point": ("point", "fixed"), "carrier": ("link", "slider")}
"""Sorts of what may stand where one is asked for, where they are not just that."""


class Use(NamedTuple):
    """A name that a part uses: where it stands, and what sort of thing it must be."""

    field: str
    name: str
    sort: str


class Made(NamedTuple):
    """A name that a part makes; `is_own` where it stands in the file as it is."""

    field: str
    name: str
    sort: str
    is_own: bool = True


def uses(part: PartSpec) -> tuple[Use, ...]:
    """Names that a part hangs on."""
    match part:
        case PinPartSpec():
            return Use("rod.from", part.rod.start, "point"), Use("rocker.from", part.rocker.start, "point")
        case SlidePartSpec():
            return Use("rod.from", part.rod.start, "point"), Use("guide.through", part.guide.through, "fixed")
        case SwivelPartSpec():
            return Use("pin", part.pin, "point"), Use("guide.from", part.guide.start, "point")
        case YokePartSpec():
            return Use("pin", part.pin, "point"), Use("guide.through", part.guide.through, "fixed")
        case TrammelPartSpec():
            return Use("link", part.link, "link"), Use("guide.through", part.guide.through, "fixed")
        case PointPartSpec():
            return (Use("link", part.link, "carrier"),)
        case TriadPartSpec():
            return tuple(use for place, leg in enumerate(part.leg) for use in _leg_uses(f"leg[{place}]", leg))


def _leg_uses(path: str, leg: TriadLegSpec) -> Iterator[Use]:
    if leg.rod is not None:
        yield Use(f"{path}.rod.from", leg.rod.start, "point")
    if leg.guide is not None:
        yield Use(f"{path}.guide.through", leg.guide.through, "fixed")


def makes(part: PartSpec) -> tuple[Made, ...]:
    """Names that a part makes."""
    match part:
        case PinPartSpec():
            links = Made("rod.name", part.rod.name, "link"), Made("rocker.name", part.rocker.name, "link")
            return (*links, Made("joint", part.joint, "point"))
        case SlidePartSpec():
            return (Made("rod.name", part.rod.name, "link"), *_slider(part.slider))
        case SwivelPartSpec():
            return Made("guide.name", part.guide.name, "link"), Made("slider", part.slider, "slider")
        case YokePartSpec() | TrammelPartSpec():
            return _slider(part.slider)
        case PointPartSpec():
            return (Made("name", part.name, "point"),)
        case TriadPartSpec():
            legs = tuple(made for place, leg in enumerate(part.leg) for made in _made_by_leg(f"leg[{place}]", leg))
            return Made("link", part.link, "link"), *legs


def _made_by_leg(path: str, leg: TriadLegSpec) -> Iterator[Made]:
    if leg.joint is not None and leg.rod is not None:
        yield Made(f"{path}.joint", leg.joint, "point")
        yield Made(f"{path}.rod.name", leg.rod.name, "link")
    if leg.slider is not None:
        yield from _slider(leg.slider, f"{path}.slider")


def _slider(name: str, field: str = "slider") -> tuple[Made, ...]:
    return Made(field, name, "slider"), Made(field, pin_of(name), "point", is_own=False)


def naming_problems(spec: ChainTable) -> tuple[Problem, ...]:
    """Find everything that is wrong with a chain's names, with paths within its table."""
    return tuple(_problems(spec))


def _problems(spec: ChainTable) -> Iterator[Problem]:
    if MAIN not in spec.crank:
        yield Problem("crank.main", None, _("is missing; its angle is the crank angle"))
    known = {SHAFT: "fixed"}
    driven: set[str] = set()
    for name in spec.fixed:
        yield from _new_name(f"fixed.{name}", name, known)
        known[name] = "fixed"
    for name, crank in spec.crank.items():
        yield from _new_name(f"crank.{name}", name, known)
        known |= {name: "crank", pin_of(name): "point"}
        driven.add(pin_of(name))
        if crank.ratio.si != 1.0:
            allowed = _("must be 1: all cranks of a chain are on one shaft")
            yield Problem(f"crank.{name}.ratio", crank.ratio.text, allowed)
        if name == MAIN and crank.angle.si != 0.0:
            allowed = _("must be 0 deg: the crank angle counts from this crank; the others have angles ahead of it")
            yield Problem("crank.main.angle", crank.angle.text, allowed)
    for place, part in enumerate(spec.part):
        path = f"part[{place}]"
        later = {made.name for after in spec.part[place:] for made in makes(after)}
        wrong = [problem for use in uses(part) for problem in _wrong_use(path, use, known, later)]
        yield from wrong
        if not wrong and not any(use.name in driven for use in uses(part)):
            yield Problem(path, None, _("is not driven: all that it hangs on stands still"))
        if isinstance(part, YokePartSpec) and abs(sin(part.slot_angle.si)) < _LEAST_SINE:
            allowed = _("must not lie along the guide: 90 deg is across it")
            yield Problem(f"{path}.slot_angle", part.slot_angle.text, allowed)
        for made in makes(part):
            if made.is_own:
                yield from _new_name(f"{path}.{made.field}", made.name, known)
            known[made.name] = made.sort
            driven.add(made.name)
    outputs = [name for name, sort in known.items() if sort in ("slider", "link")]
    if spec.output not in outputs:
        meant = nearest(spec.output, outputs)
        yield Problem(
            "output",
            spec.output,
            _("must be a slider or a link of this chain: {names}").format(names=", ".join(outputs)),
            _("did you mean {name}?").format(name=meant) if meant else None,
        )


def _new_name(path: str, name: str, known: dict[str, str]) -> Iterator[Problem]:
    """Refuse a name that stands already, or is no name."""
    if not _NAME.fullmatch(name):
        yield Problem(path, name, _("must be a name of letters, digits and _, a letter first"))
    elif name == SHAFT:
        yield Problem(path, name, _("is the name of the shaft's centre; give another"))
    elif name in known:
        yield Problem(path, name, _("stands already above; every name stands for one thing"))


def _wrong_use(path: str, use: Use, known: dict[str, str], later: set[str]) -> Iterator[Problem]:
    """Refuse a name that is unknown, made only further down, or of another sort."""
    sorts = _FITTING.get(use.sort, (use.sort,))
    # A block on a pin, of a swivel, is no slider to fix a point on.
    fitting = [name for name, sort in known.items() if sort in sorts and (sort != "slider" or pin_of(name) in known)]
    if use.name in fitting:
        return
    allowed = _("must be {sort} that stands above: {names}").format(
        sort=_(_SORTS[use.sort]), names=", ".join(fitting) or "–"
    )
    if use.name in later and use.name not in known:
        allowed = _("is made only here or further down; {allowed}").format(allowed=allowed)
    meant = pin_of(use.name) if pin_of(use.name) in fitting else nearest(use.name, fitting)
    repair = _("did you mean {name}?").format(name=meant) if meant else None
    yield Problem(f"{path}.{use.field}", use.name, allowed, repair)
