"""Points and pins that are added to a chain by clicks: on a link, on a slider, on the ground, and on the shaft."""

from collections.abc import Mapping, Sequence

import numpy as np

from cranktrain.language import N_, _
from cranktrain.mechanisms.by_hand import AddedTable, Addition, Click, Clicked
from cranktrain.mechanisms.chain.adding.shown import (
    ShownChain,
    degrees_text,
    distance,
    item,
    none_of,
    refusal,
    refused,
    to_chain,
)
from cranktrain.mechanisms.chain.groups import guide_directions, pin_of

_FIXED = ("C", "D", "E", "F")
"""Names of fixed points."""


def _followed(shown: ShownChain, clicks: Sequence[Clicked]) -> AddedTable:
    """A point on a link that is followed."""
    return AddedTable(f"points.{shown.new('GHKLM')}", _point_on(shown, clicks[0]))


def _pin(shown: ShownChain, clicks: Sequence[Clicked]) -> AddedTable:
    """A pin on a link, or a fixed point."""
    (clicked,) = clicks
    if clicked.name:
        return item(type="point", name=shown.new("P"), **_point_on(shown, clicked))
    return AddedTable("fixed", {shown.new(_FIXED): shown.typing.texts(shown.place(clicked))})


def _point_on(shown: ShownChain, clicked: Clicked) -> Mapping[str, str]:
    """Keys that say where on a link a point is."""
    along, across = shown.on_link(clicked.name, np.array([clicked.x, clicked.y]))
    return {"link": clicked.name, "along": shown.typing.text(along), "across": shown.typing.text(across)}


def _pin_on_slider(shown: ShownChain, clicks: Sequence[Clicked]) -> AddedTable:
    """A pin on a slider in a fixed guide, which goes along with it."""
    on, at = clicks
    directions = {pin_of(name): (name, way) for name, way in guide_directions(shown.structure, shown.size).items()}
    if on.name not in directions:
        raise none_of(on, directions)
    slider, direction = directions[on.name]
    beside = shown.place(at) - shown.pin(on)
    if shown.typing.is_small(float(np.hypot(*beside))):
        raise refusal(on, _("is a pin already; put the other one elsewhere"))
    cos, sin = float(np.cos(np.ravel(direction)[0])), float(np.sin(np.ravel(direction)[0]))
    return item(
        type="point",
        name=shown.new("P"),
        link=slider,
        along=shown.typing.text(float(beside[0] * cos + beside[1] * sin)),
        across=shown.typing.text(float(beside[1] * cos - beside[0] * sin)),
    )


def _eccentric(shown: ShownChain, clicks: Sequence[Clicked]) -> AddedTable:
    """Another crank on the shaft."""
    (clicked,) = clicks
    at = shown.place(clicked)
    radius = distance(at, np.zeros(2))
    if shown.typing.is_small(radius):
        raise refused(_("the pin would be at the shaft's centre; put it elsewhere"))
    ahead = round(np.degrees(np.arctan2(at[1], at[0]) - shown.angle))
    return AddedTable(
        f"crank.{shown.new(['eccentric'])}",
        {"radius": shown.typing.text(radius), "angle": degrees_text((ahead + 180) % 360 - 180)},
    )


POINTS = (
    Addition(
        "point",
        N_("Followed point"),
        (Click(N_("Where on a link is the point that is followed?"), {"link": N_("point on {name}")}),),
        to_chain(_followed),
    ),
    Addition(
        "pin",
        N_("Pin"),
        (
            Click(
                N_("Where is the pin: on a link, or on the ground as a fixed point?"),
                {"link": N_("pin on {name}"), "ground": N_("fixed point")},
            ),
        ),
        to_chain(_pin),
    ),
    Addition(
        "slider_pin",
        N_("Pin on a slider"),
        (
            Click(N_("Which slider carries the pin?"), {"slider": N_("slider of {name}")}),
            Click(N_("Where is the pin that goes along with it?"), {"ground": N_("pin")}),
        ),
        to_chain(_pin_on_slider),
    ),
    Addition(
        "eccentric",
        N_("Eccentric"),
        (Click(N_("Where is the pin of another crank on the shaft?"), {"ground": N_("crank pin")}),),
        to_chain(_eccentric),
    ),
)
"""Points that are followed, and pins on which other parts hang."""
