"""Links that are added to a chain by clicks: two that meet in a joint, and a guide that rocks about a pin."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from cranktrain.language import N_, _
from cranktrain.mechanisms.by_hand import AddedTable, Addition, Click, Clicked
from cranktrain.mechanisms.chain.adding.guides import clicked_direction
from cranktrain.mechanisms.chain.adding.shown import (
    ON_PIN,
    ShownChain,
    distance,
    item,
    link_from,
    place_of,
    refusal,
    to_chain,
)
from cranktrain.mechanisms.chain.kinematics import chain_made
from cranktrain.mechanisms.chain.parts import PinPartSpec
from cranktrain.mechanisms.chain.steps import PinStep
from cranktrain.motion import Array


def _pair(shown: ShownChain, clicks: Sequence[Clicked]) -> AddedTable:
    """Two links that meet in a joint."""
    first, joint, last = clicks
    start, end, at = shown.pin(first), shown.pin(last), shown.place(joint)
    if first.name == last.name:
        raise refusal(last, _("is where the first link begins; take another pin"))
    for pin, clicked in ((start, first), (end, last)):
        if shown.typing.is_there(at, pin):
            raise refusal(clicked, _("is where both links would meet; let them meet elsewhere"))
    (x, y), (across, up) = end - start, at - start
    rod, rocker = shown.typing.reaching(distance(at, start), distance(at, end), distance(start, end))
    part: dict[str, Any] = {
        "type": "pin",
        "rod": link_from(shown, shown.new(["rod"]), first, rod),
        "rocker": link_from(shown, shown.new(["rocker"]), last, rocker),
        "joint": shown.new("B"),
        "side": "left" if x * up - y * across > 0.0 else "right",
    }
    crossed = {**part, "crossed": True}
    step, plain = _joint(shown, part)
    if step.form and distance(_joint(shown, crossed)[1], at) < distance(plain, at):
        part = crossed
    return item(**part)


def _joint(shown: ShownChain, part: Mapping[str, Any]) -> tuple[PinStep, Array]:
    """Put two links on the chain: how they pass change points, and where their joint is."""
    structure, size = shown.grown(PinPartSpec.model_validate(part))
    with np.errstate(all="ignore"):
        made = chain_made(structure, np.array([shown.angle]), size)
    step = structure.steps[-1]
    assert isinstance(step, PinStep)
    return step, place_of(made[step.joint])


def _swivel(shown: ShownChain, clicks: Sequence[Clicked]) -> AddedTable:
    """A guide that rocks about a pin, as a block on another pin slides in it; a third place is on its line, too."""
    first, pivot, toward = clicks
    pin, about = shown.pin(first), shown.pin(pivot)
    if first.name == pivot.name or shown.typing.is_there(pin, about):
        raise refusal(pivot, _("is where the block is; let the guide rock about another pin"))
    way = clicked_direction(shown, pin, toward)
    line, arm = np.array([np.cos(way), np.sin(way)]), pin - about
    # The guide is directed from its pivot toward the block, which so is ahead.
    offset = float(line[0] * arm[1] - line[1] * arm[0]) * (1.0 if line @ arm >= 0.0 else -1.0)
    return item(
        type="swivel",
        pin=first.name,
        guide={
            "name": shown.new(["lever"]),
            "from": pivot.name,
            "offset": shown.typing.text(shown.typing.beside(offset)),
        },
        slider=shown.new(["block"]),
        side="ahead",
    )


LINKS = (
    Addition(
        "pair",
        N_("Two links"),
        (
            Click(N_("On which pin does the first link begin?"), ON_PIN),
            Click(N_("Where do both links meet?"), {"ground": N_("joint")}),
            Click(N_("On which pin does the second link end?"), ON_PIN),
        ),
        to_chain(_pair),
    ),
    Addition(
        "swivel",
        N_("Rocking guide"),
        (
            Click(N_("On which pin is the block that slides in the guide?"), ON_PIN),
            Click(N_("About which pin does the guide rock?"), ON_PIN),
            Click(
                N_("Through which other place does its line go: through that pin, or beside it?"),
                {"pin": N_("through {name}"), "ground": N_("guide")},
            ),
        ),
        to_chain(_swivel),
    ),
)
"""Links between pins, and links that are guides."""
