"""Mechanisms of which a text speaks, those that move alike under one name, and the exact motion of each."""

from collections.abc import Collection, Hashable, Iterator, Sequence
from typing import NamedTuple

from cranktrain.errors import InputError, Problem
from cranktrain.grouping import places_of_equal
from cranktrain.language import Words, _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.mechanisms.articulated_rod import ArticulatedRod
from cranktrain.mechanisms.eccentric import Eccentric
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import extremes
from cranktrain.saying.wording import ranged
from cranktrain.textbook.statements import Verdict
from cranktrain.texts.comparison import FORMS
from cranktrain.texts.largest_errors import from_top
from cranktrain.texts.plain_cranks import PLAIN, plain_crank
from cranktrain.texts.ranges import Range

_SPOKEN_OF = {"crank_rocker"}.union(*FORMS.values())
"""Kinds of mechanisms on whose motion a text has something."""


def alike_places(places: Sequence[PlacedMechanism], keys: Sequence[Hashable]) -> Iterator[tuple[str, PlacedMechanism]]:
    """Give the names of those with one key, as a range, and the first of them."""
    names = [place.name for place in places]
    for members in places_of_equal(keys).values():
        yield ranged(names, members), places[members[0]]


def unspoken(places: Sequence[PlacedMechanism], allowed: Words) -> InputError:
    """What is wrong with a machine of which a text does not speak, and which function has what the texts do say."""
    kinds = dict.fromkeys(place.kind.name for place in places)
    return InputError([Problem("machine", ", ".join(kinds), allowed, instead(places))])


def instead(places: Sequence[PlacedMechanism]) -> Words:
    """Say which function has what the texts say of the motion of some mechanisms, or that no text speaks of it."""
    if any(place.kind.name in _SPOKEN_OF for place in places):
        return _("`cranktrain.textbook.motion` has what the texts say of it")
    return _("none of the texts speaks of its motion")


class AlikePistons(NamedTuple):
    """Pistons and valves that move alike from where their own cranks point along their lines: names, the first one."""

    of: str
    first: PlacedMechanism

    @property
    def geometry(self) -> SliderCrank | Eccentric | ArticulatedRod:
        """The first one's."""
        return self.first.geometry

    @property
    def plain(self) -> SliderCrank:
        """Its crank, rod and offset; of a slave its master's, by whose λ ranges go."""
        geometry = self.geometry
        return plain_crank(geometry.master if isinstance(geometry, ArticulatedRod) else geometry)

    @property
    def ratio(self) -> float:
        """λ = R/L."""
        return float(self.plain.crank_radius / self.plain.rod_length)

    @property
    def offset(self) -> float:
        """Of the line of stroke. [m]"""
        return float(self.plain.offset)

    def verdict(self, one: Range) -> Verdict:
        """Whether a form is in its source's range."""
        return "out of range" if any(one.reasons(self.ratio, self.offset)) else "approximate"

    def kernel_angle(self, angle: Array) -> Array:
        """The kernel's angle, from that of the own crank after the line of stroke; both in rad."""
        return angle + float(self.first.phase + self.first.nominal_top) - getattr(self.geometry, "ahead", 0.0)

    def exact(self, angle: Array) -> Coefficient:
        """Exact displacement from the own top toward the shaft, by the angle of the own crank. [m, m/rad, m/rad²]"""
        if self.first.kind.name in PLAIN:
            return from_top(self.plain)(angle)

        def slider(alpha: Array) -> Coefficient:
            return self.first.kind.motion(self.kernel_angle(alpha), self.geometry).slider

        top = extremes(lambda alpha: slider(alpha).value).largest.value
        motion = slider(angle)
        return Coefficient(top - motion.value, -motion.first, -motion.second)


def alike(places: Sequence[PlacedMechanism], kinds: Collection[str]) -> tuple[AlikePistons, ...]:
    """Put those of some kinds together that move alike, whether crank or eccentric."""
    spoken_of = [place for place in places if place.kind.name in kinds]
    keys = [plain_crank(one.geometry) if one.kind.name in PLAIN else one.geometry for one in spoken_of]
    return tuple(AlikePistons(*group) for group in alike_places(spoken_of, keys))
