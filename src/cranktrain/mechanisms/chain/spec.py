"""A chain of the machine file whose parts hang together: a part uses only names above it."""

import re
from collections.abc import Iterable, Iterator
from math import sin
from typing import NamedTuple, cast

from cranktrain.declared_types import parts_of
from cranktrain.errors import Problem
from cranktrain.language import N_, _
from cranktrain.mechanisms.chain.groups import SHAFT, pin_of
from cranktrain.mechanisms.chain.parts import ChainTable, Made, Used, YokePartSpec
from cranktrain.mechanisms.chain.table import crossed_problems, mode_problems
from cranktrain.quantities import nearest
from cranktrain.spec import Spec

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


class Name(NamedTuple):
    """A name in a part: the path of its key, and what it marks there."""

    path: str
    name: str
    mark: Used | Made

    @property
    def made(self) -> dict[str, str]:
        """What it makes, and of which sort: a slider in a fixed guide has a pin."""
        pin = {pin_of(self.name): "point"} if self.mark.sort == "slider" else {}
        return {self.name: self.mark.sort, **pin} if isinstance(self.mark, Made) else {}


def names_in(table: Spec, above: str) -> Iterator[Name]:
    """Names that a part, or a table in it, uses and makes, in the order of its keys."""
    for key, field in type(table).model_fields.items():
        path, value = above + (field.alias or key), getattr(table, key)
        if isinstance(value, Spec):
            yield from names_in(value, f"{path}.")
        elif isinstance(value, str):
            marks = (*field.metadata, *parts_of(field.annotation))
            yield from (Name(path, value, mark) for mark in marks if isinstance(mark, Used | Made))
        elif isinstance(value, tuple):
            for place, leg in enumerate(cast("tuple[object, ...]", value)):
                if isinstance(leg, Spec):
                    yield from names_in(leg, f"{path}[{place}].")


def _naming_problems(spec: ChainTable) -> Iterator[Problem]:
    """Find everything that is wrong with a chain's names, with paths within its table."""
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
    names = [tuple(names_in(part, f"part[{place}].")) for place, part in enumerate(spec.part)]
    for place, part in enumerate(spec.part):
        used = [name for name in names[place] if isinstance(name.mark, Used)]
        later = {made for after in names[place:] for name in after for made in name.made}
        wrong = [problem for use in used for problem in _wrong_use(use, known, later)]
        yield from wrong
        if not wrong and not any(use.name in driven for use in used):
            yield Problem(f"part[{place}]", None, _("is not driven: all that it hangs on stands still"))
        if isinstance(part, YokePartSpec) and abs(sin(part.slot_angle.si)) < _LEAST_SINE:
            allowed = _("must not lie along the guide: 90 deg is across it")
            yield Problem(f"part[{place}].slot_angle", part.slot_angle.text, allowed)
        for name in names[place]:
            if name.made:
                yield from _new_name(name.path, name.name, known)
            known |= name.made
            driven |= name.made.keys()
    outputs = [name for name, sort in known.items() if sort in ("slider", "block", "link")]
    if spec.output not in outputs:
        meant = nearest(spec.output, outputs)
        yield Problem(
            "output",
            spec.output,
            _("must be a slider or a link of this chain: {names}", names=", ".join(outputs)),
            _("did you mean {name}?", name=meant) if meant else None,
        )


def _new_name(path: str, name: str, known: dict[str, str]) -> Iterator[Problem]:
    """Refuse a name that stands already, or is no name."""
    if not _NAME.fullmatch(name):
        yield Problem(path, name, _("must be a name of letters, digits and _, a letter first"))
    elif name == SHAFT:
        yield Problem(path, name, _("is the name of the shaft's centre; give another"))
    elif name in known:
        yield Problem(path, name, _("stands already above; every name stands for one thing"))


def _wrong_use(use: Name, known: dict[str, str], later: set[str]) -> Iterator[Problem]:
    """Refuse a name that is unknown, made only further down, or of another sort."""
    sorts = _FITTING.get(use.mark.sort, (use.mark.sort,))
    fitting = [name for name, sort in known.items() if sort in sorts]
    if use.name in fitting:
        return
    allowed = _(
        "must be {sort} that stands above: {names}", sort=_(_SORTS[use.mark.sort]), names=", ".join(fitting) or "–"
    )
    if use.name in later and use.name not in known:
        allowed = _("is made only here or further down; {allowed}", allowed=allowed)
    meant = pin_of(use.name) if pin_of(use.name) in fitting else nearest(use.name, fitting)
    repair = _("did you mean {name}?", name=meant) if meant else None
    yield Problem(use.path, use.name, allowed, repair)


class ChainSpec(ChainTable, frozen=True):
    """Cranks on one shaft, fixed points, and groups that each hang on what stands above them."""

    def _problems(self) -> Iterable[Problem]:
        """Find names unknown or twice, parts that nothing drives, an output that is none, triads of unclear mode."""
        return tuple(_naming_problems(self)) or (*crossed_problems(self), *mode_problems(self))
