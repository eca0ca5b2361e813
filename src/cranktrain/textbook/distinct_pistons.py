"""Pistons and valves of which a text speaks, those that move alike together, and the exact motion of each."""

from collections.abc import Collection, Sequence
from typing import NamedTuple

from cranktrain.layout.places import PlacedMechanism
from cranktrain.mechanisms.articulated_rod import ArticulatedRod
from cranktrain.mechanisms.eccentric import Eccentric
from cranktrain.mechanisms.slider_crank import SliderCrank
from cranktrain.motion import Array, Coefficient
from cranktrain.numerics import extremes
from cranktrain.textbook.alike_places import alike_places
from cranktrain.textbook.statements import Verdict
from cranktrain.texts.largest_errors import from_top
from cranktrain.texts.plain_cranks import PLAIN, plain_crank
from cranktrain.texts.ranges import Range


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
