"""Sliders that are added to a chain by clicks, in fixed guides: on a rod, on a slot of their own, on a link's slot."""

from collections.abc import Sequence

import numpy as np

from cranktrain.language import N_, _
from cranktrain.mechanisms.by_hand import AddedTable, Addition, Click, Clicked
from cranktrain.mechanisms.chain.adding.guides import WAY, clicked_guide
from cranktrain.mechanisms.chain.adding.shown import (
    ON_PIN,
    ShownChain,
    degrees_text,
    distance,
    item,
    link_from,
    refusal,
    round_direction,
    to_chain,
)

_SCOTCH = 90.0
"""Angle from the guide of a slotted slider to its slot, where no place says another. [deg]"""


def _slide(shown: ShownChain, clicks: Sequence[Clicked]) -> AddedTable:
    """A link with a slider on a fixed guide."""
    first, slider, toward = clicks
    start, at = shown.pin(first), shown.place(slider)
    if shown.typing.is_there(at, start):
        raise refusal(first, _("is where the slider would be, on a link of no length; put it elsewhere"))
    guide = clicked_guide(shown, at, toward)
    at = guide.foot(at)
    return item(
        type="slide",
        rod=link_from(shown, shown.new(["rod"]), first, distance(at, start)),
        slider=shown.new(["slider"]),
        guide=guide.keys,
        side="ahead" if guide.along @ (at - start) >= 0.0 else "behind",
    )


def _yoke(shown: ShownChain, clicks: Sequence[Clicked]) -> AddedTable:
    """A slotted slider: its slot goes through its own pin and the driving one; across its guide if both are one."""
    first, slider, toward = clicks
    pin, at = shown.pin(first), shown.place(slider)
    guide = clicked_guide(shown, at, toward)
    slot, angle = pin - at, _SCOTCH
    if not shown.typing.is_there(pin, at):
        angle = round_direction(float(np.degrees(np.arctan2(guide.across @ slot, guide.along @ slot))) % 180.0) % 180.0
    return item(
        type="yoke", pin=first.name, slider=shown.new(["yoke"]), guide=guide.keys, slot_angle=degrees_text(angle)
    )


def _trammel(shown: ShownChain, clicks: Sequence[Clicked]) -> AddedTable:
    """A slider on a fixed guide, held where it crosses a link's slot, which goes through the slider's pin."""
    link, slider, toward = clicks
    at = shown.place(slider)
    guide = clicked_guide(shown, at, toward)
    _along, across = shown.on_link(link.name, guide.foot(at))
    shift = shown.typing.text(shown.typing.beside(across))
    return item(type="trammel", link=link.name, slider=shown.new(["slider"]), guide=guide.keys, shift=shift)


SLIDERS = (
    Addition(
        "slider",
        N_("Link and slider"),
        (
            Click(N_("On which pin does the link begin?"), ON_PIN),
            Click(N_("Where is the pin of the slider?"), {"ground": N_("slider")}),
            WAY,
        ),
        to_chain(_slide),
    ),
    Addition(
        "yoke",
        N_("Slotted slider"),
        (
            Click(N_("Which pin drives the slider, by a block in its slot?"), ON_PIN),
            Click(N_("Where, seen from there along the slot, is the slider's guide?"), {"ground": N_("slider")}),
            WAY,
        ),
        to_chain(_yoke),
    ),
    Addition(
        "trammel",
        N_("Slider in a link's slot"),
        (
            Click(N_("Which link has the slot?"), {"link": N_("slot of {name}")}),
            Click(N_("Where is the slider's pin, on the link or beside it?"), {"ground": N_("slider")}),
            WAY,
        ),
        to_chain(_trammel),
    ),
)
"""Sliders in fixed guides."""
