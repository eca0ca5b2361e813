"""What is wrong with shafts, seen beside the banks that they carry, and with how mechanisms stand on them."""

from collections.abc import Iterator, Mapping

from cranktrain.errors import Problem, judged
from cranktrain.language import _
from cranktrain.layout.crank_bodies import pin_problems
from cranktrain.layout.design import Design
from cranktrain.layout.specs import MAIN, BankSpec, ShaftSpec
from cranktrain.layout.standing import standing_problems
from cranktrain.paths import path_text


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
