"""What is wrong with shafts and with the banks that they carry, and with how mechanisms stand on them."""

import re
from collections.abc import Container, Iterator, Mapping

from cranktrain.errors import Problem, judged
from cranktrain.language import _
from cranktrain.layout.crank_bodies import pin_problems
from cranktrain.layout.design import Design
from cranktrain.layout.specs import MAIN, MOST_MECHANISMS, BankSpec, ShaftSpec
from cranktrain.layout.standing import standing_problems
from cranktrain.paths import path_text


def bank_problems(
    banks: Mapping[str, BankSpec], shafts: Mapping[str, ShaftSpec], keys: Container[str]
) -> Iterator[Problem]:
    """Find banks whose names are none, or are `keys` of the table of cylinders, and too many mechanisms in all."""
    for name in banks:
        if not re.fullmatch(r"[^\W\d]\w*", name) or name in keys:
            allowed = _("must have a name of letters, digits and _, a letter first, that is no key of [cylinder]")
            yield Problem(path_text(("bank", name)), None, allowed)
    n_mechanisms = sum(bank.n_mechanisms(shafts) for bank in banks.values())
    if n_mechanisms > MOST_MECHANISMS:
        allowed = _("gives {n} mechanisms; a machine may have at most {limit}")
        yield Problem("bank", None, allowed.format(n=n_mechanisms, limit=MOST_MECHANISMS))


def shaft_problems(shafts: Mapping[str, ShaftSpec], banks: Mapping[str, BankSpec]) -> Iterator[Problem]:
    """Find what only the main shaft has, or only another, and shafts that carry nothing."""
    used = {shaft for bank in banks.values() for shaft in bank.shafts}
    for name, shaft in shafts.items():
        foreign = ("ratio", "phase", "place") if name == MAIN else ("speed", "acceleration", "speed_curve", "motion")
        allowed = _("is for another shaft; angles and places count from [shaft.main]")
        if name != MAIN:
            allowed = _("must stand in [shaft.main]; this shaft turns with it, by its ratio")
            if name not in used:
                nothing = _("carries no bank: name it in [bank.NAME] shaft, or take it out")
                yield Problem(path_text(("shaft", name)), None, nothing)
        yield from (
            Problem(path_text(("shaft", name, key)), None, allowed) for key in foreign if key in shaft.model_fields_set
        )


def layout_problems(design: Design) -> Iterator[Problem]:
    """Find mechanisms and shafts that do not fit one another, and what is wrong with a motion that is wanted."""
    yield from judged(pin_problems(design.places))
    yield from judged(standing_problems(design.shafts, design.places, design.orientation))
    if design.shafts[MAIN].motion is not None:
        from cranktrain.layout.wish.declared import wish_problems  # for machines that have one

        yield from wish_problems(design)
