"""A link on three legs that is added to a chain by clicks: each leg a rod from a pin, or a slider in a fixed guide."""

from collections.abc import Mapping, Sequence
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

from cranktrain.language import N_, _
from cranktrain.linkage import Pose, TriadEnds
from cranktrain.mechanisms.by_hand import AddedTable, Addition, Click, Clicked, Taken
from cranktrain.mechanisms.chain.adding.guides import WAY, clicked_guide
from cranktrain.mechanisms.chain.adding.shown import ShownChain, distance, item, link_from, refusal, refused, to_chain
from cranktrain.mechanisms.chain.assembly import Mode, joints_of, made_above, modes_of
from cranktrain.mechanisms.chain.kinematics import chain_made
from cranktrain.mechanisms.chain.parts import TriadPartSpec
from cranktrain.mechanisms.chain.steps import StartSize
from cranktrain.mechanisms.chain.triads import triad_at, triad_ends, triad_legs
from cranktrain.mechanisms.chain.walks import branch_from, sign_of, start_at
from cranktrain.motion import Array, single
from cranktrain.numerics.nested import each_changed
from cranktrain.numerics.ties import largest_of, smallest_of


class _Leg(NamedTuple):
    """Keys of a leg's table, and where its joint on the link is, shape (2,). [m]"""

    keys: Mapping[str, Any]
    joint: Array


def _triad(shown: ShownChain, clicks: Sequence[Clicked]) -> AddedTable:
    """A link on three legs, its line from the first joint to the second."""
    names: list[str] = []
    legs = [_leg(shown, *pair, names) for pair in zip(clicks[::2], clicks[1::2], strict=True)]
    for one, other in combinations(legs, 2):
        if shown.typing.is_there(one.joint, other.joint):
            raise refused(_("two of the three joints on the link are in one place; put them apart"))
    (first, second, third), typed = (leg.joint for leg in legs), shown.typing
    line = (second - first) / distance(second, first)
    along, (far, beside) = typed.rounded(distance(second, first)), _in_axes(line, third - first)
    keys = [
        dict(legs[0].keys),
        {**legs[1].keys, "along": typed.text(along)},
        {**legs[2].keys, "along": typed.text(far), "across": typed.text(typed.beside(beside))},
    ]
    part = {"type": "triad", "link": shown.new(["plate"]), "leg": keys}
    pose = Pose(*map(single, (*map(float, first), float(np.arctan2(line[1], line[0])))))
    for leg, near in _near(shown, part, pose).items():
        keys[leg]["near"] = near
    return item(**part)


def _in_axes(line: Array, place: Array) -> tuple[float, float]:
    """How far a place is along a line and to its left. [m]"""
    return float(line @ place), float(line[0] * place[1] - line[1] * place[0])


def _leg(shown: ShownChain, start: Clicked, then: Clicked, names: list[str]) -> _Leg:
    """One leg: a rod from a pin to a joint, or the pin of a slider and the direction of its guide."""

    def new(name: str) -> str:
        names.append(shown.new([name], names))
        return names[-1]

    if start.name:
        pin, joint = shown.pin(start), shown.place(then)
        if shown.typing.is_there(pin, joint):
            raise refusal(start, _("is where its rod would hold the link; let it hold the link elsewhere"))
        return _Leg({"joint": new("B"), "rod": link_from(shown, new("rod"), start, distance(pin, joint))}, joint)
    guide = clicked_guide(shown, shown.place(start), then)
    return _Leg({"slider": new("slider"), "guide": guide.keys}, guide.foot(shown.place(start)))


def _near(shown: ShownChain, part: Mapping[str, Any], pose: Pose) -> Mapping[int, list[str]]:
    """Where about the joint of one leg is with the crank along x, if the link fits there in several ways."""
    structure, size = shown.grown(TriadPartSpec.model_validate(part))
    place = len(structure.steps) - 1
    step, own = triad_at(structure, place, size)
    above, legs = structure._replace(steps=structure.steps[:place]), triad_legs(own)

    def ends(turned: Array) -> TriadEnds:
        made = chain_made(above, shown.angle + turned, size)
        return each_changed(lambda value: value + 0.0 * turned, triad_ends(step, own, made))

    begun = StartSize(*pose, sign_of(ends(np.zeros(1)), legs, pose), single(1.0))
    with np.errstate(all="ignore"):
        back = start_at(branch_from(ends, legs, begun), np.array([-shown.angle]))
    joints = joints_of(legs, Pose(*(single(part.item()) for part in back)))
    if not np.all(np.isfinite(joints)):
        raise refused(
            _("the link cannot go from where it is clicked to where the crank lies along x; put its joints elsewhere")
        )
    others = _others(modes_of(step, own, made_above(structure, place, size)), joints)
    if not others:
        return {}
    leg = largest_of(range(3), lambda k: min(distance(mode.joints[k], joints[k]) for mode in others))
    return {leg: shown.typing.texts(joints[leg])}


def _others(modes: Sequence[Mode], joints: Array) -> list[Mode]:
    """All ways of putting a link in place but the one in which its joints are there."""
    own = smallest_of(modes, lambda mode: float(np.sum((mode.joints - joints) ** 2)))
    return [mode for mode in modes if mode is not own]


_RUNS: Mapping[Taken, Click] = {
    "pin": Click(N_("Where on the link does that rod end?"), {"ground": N_("joint")}),
    "ground": WAY,
}
_BEGINS: Mapping[Taken, str] = {"pin": N_("rod from {name}"), "ground": N_("slider")}

TRIADS = (
    Addition(
        "triad",
        N_("Link on three legs"),
        (
            Click(N_("First leg: from which pin does a rod come, or where is the pin of a slider?"), _BEGINS),
            _RUNS,
            Click(N_("Second leg: from which pin does a rod come, or where is the pin of a slider?"), _BEGINS, True),
            _RUNS,
            Click(N_("Third leg: from which pin does a rod come, or where is the pin of a slider?"), _BEGINS, True),
            _RUNS,
        ),
        to_chain(_triad),
    ),
)
"""Links that no two legs hold."""
