"""The slider-crank's table of the machine file."""

from collections.abc import Iterator
from math import pi, sqrt
from typing import Annotated, ClassVar, Literal

import numpy as np
from pydantic import Field

from cranktrain.errors import Problem
from cranktrain.language import N_, Words, _
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank
from cranktrain.mechanisms.spec import Master, MechanismSpec
from cranktrain.motion import Array, chosen, single
from cranktrain.quantities import Dimension, Given, Length, PositiveLength, PositiveRatio, Quantity
from cranktrain.saying.wording import as_limit

_CRANKS = ("crank_radius", "stroke")
RODS = ("rod_length", "crank_to_rod_ratio", "rod_to_crank_ratio")
"""Forms in which the rod may be given."""
_PressureAngle = Annotated[Given, Quantity(Dimension.ANGLE, above=0.0, below=pi / 2)]


class SliderCrankSpec(MechanismSpec, frozen=True):
    """Slider-crank: crank by its radius or the true stroke, rod by its length or either ratio to the crank."""

    elsewhere: ClassVar = {
        **MechanismSpec.elsewhere,
        **dict.fromkeys(("lambda", "lam", "λ"), "crank_to_rod_ratio"),
        **dict.fromkeys(("r", "crank", "radius"), "crank_radius"),
        **dict.fromkeys(("l", "rod", "conrod", "connecting_rod"), "rod_length"),
        **dict.fromkeys(("s", "h"), "stroke"),
        **dict.fromkeys(("e", "eccentricity"), "offset"),
        "k": "offset: k · crank_radius",
    }

    kind: Literal["slider_crank"]
    crank_radius: PositiveLength | None = Field(
        default=None, description=N_("From shaft centre to crank pin; or give the stroke.")
    )
    stroke: PositiveLength | None = Field(
        default=None, description=N_("True travel of the piston; or give the crank radius.")
    )
    rod_length: PositiveLength | None = Field(
        default=None, description=N_("From crank pin to piston pin; or give one of the ratios.")
    )
    crank_to_rod_ratio: PositiveRatio | None = Field(
        default=None, description=N_("λ = R/L instead of the rod's length.")
    )
    rod_to_crank_ratio: PositiveRatio | None = Field(default=None, description=N_("L/R instead of the rod's length."))
    offset: Length = Field(
        default=Given(0.0, "0 mm"),
        description=N_(
            "Of the line of stroke from the shaft, positive toward +y: 90° ahead of the stroke's direction."
        ),
    )
    permissible_pressure_angle: _PressureAngle | None = Field(
        default=None,
        description=N_(
            "Largest angle between rod and line of stroke that is permitted: what is over it is flagged, no more."
        ),
    )

    @property
    def pressure_angle_limit(self) -> Given | None:
        """That of the file."""
        return self.permissible_pressure_angle

    def _problems(self) -> Iterator[Problem]:
        """Find a crank or a rod that is given twice or not at all, and a stroke that no crank can make."""
        wrong = [problem for names in (_CRANKS, RODS) for problem in _not_once(self, names)]
        yield from wrong
        with np.errstate(all="ignore"):
            if not wrong and self.stroke is not None and np.isnan(_radius_from_stroke(self)):
                yield Problem("stroke", None, _stroke_limit(self))


def slider_crank_rod_field(spec: SliderCrankSpec, _geometry: SliderCrank) -> str:
    """Give whichever of the three forms gives the rod."""
    return next(name for name in RODS if getattr(spec, name) is not None)


def _stroke_limit(spec: SliderCrankSpec) -> Words:
    """Say which strokes a crank can make with this rod and offset; docs/theory/slider-crank."""
    if spec.rod_length is None:
        return _("no crank makes this stroke with this ratio and offset: the stroke must be longer")
    rod, offset = spec.rod_length.si, abs(spec.offset.si)
    if offset >= rod:
        return _("no crank makes a stroke with this offset, which must be less than the rod's length")
    most = as_limit(2 * sqrt(rod * (rod - offset)))
    return _("must be at most 2√(L(L − |e|)) = {most} with this rod and offset", most=most)


def _not_once(spec: SliderCrankSpec, names: tuple[str, ...]) -> Iterator[Problem]:
    """Refuse fields of which not exactly one is given."""
    given = [name for name in names if getattr(spec, name) is not None]
    if not given:
        yield Problem(names[0], None, _("is missing; give one of {names}", names=", ".join(names)))
    if len(given) > 1:
        yield Problem(given[1], None, _("must not stand beside {other}; give one of them", other=given[0]))


def slider_crank_geometry(spec: SliderCrankSpec, _master: Master | None = None) -> SliderCrank:
    """Crank radius, rod length and offset in SI, whichever way they were given; docs/theory/slider-crank."""
    radius = _radius_from_stroke(spec) if spec.crank_radius is None else spec.crank_radius.array
    return SliderCrank(radius, _rod_length(spec, radius), spec.offset.array)


def _rod_length(spec: SliderCrankSpec, radius: Array) -> Array:
    """Rod length from whichever of its three forms the file gives."""
    if spec.rod_length is not None:
        return spec.rod_length.array
    if spec.crank_to_rod_ratio is not None:
        return radius / spec.crank_to_rod_ratio.array
    assert spec.rod_to_crank_ratio is not None  # the spec asks for exactly one
    return radius * spec.rod_to_crank_ratio.array


def _radius_from_stroke(spec: SliderCrankSpec) -> Array:
    """Crank radius that makes the true stroke S = √((L + R)² − e²) − √((L − R)² − e²); NaN where none does."""
    assert spec.stroke is not None
    stroke, offset = spec.stroke.array, spec.offset.array
    if spec.rod_length is not None:
        rod = spec.rod_length.array
        left = 4 * rod**2 - stroke**2  # 0 only of a stroke of twice the rod, where R = S/2 follows from no offset
        square = stroke**2 * (left - 4 * offset**2) / (4 * chosen(left == 0.0, 1.0, left))
        square = chosen(stroke**2 <= 4 * rod * (rod - abs(offset)), square, np.nan)
    else:
        ratio = _rod_length(spec, single(1.0))
        # 16 ν² R⁴ − 4 S² (1 + ν²) R² + S² (4 e² + S²) = 0; the larger root in R², as L > R.
        middle = stroke**2 * (1 + ratio**2)
        inside = middle**2 - 4 * ratio**2 * stroke**2 * (4 * offset**2 + stroke**2)
        square = (middle + np.sqrt(inside)) / (8 * ratio**2)
    return chosen(offset == 0.0, stroke / 2, np.sqrt(chosen(square > 0.0, square, np.nan)))


def slider_crank_advice(geometry: SliderCrank) -> Words:
    """Say how long the rod must be for the crank to turn."""
    least = geometry.crank_radius + abs(geometry.offset)
    return _("rod_length must be more than crank_radius + |offset| = {least}", least=as_limit(float(least)))


def slider_crank_ratio(geometry: SliderCrank) -> Array:
    """λ, crank radius over rod length; NaN where the line of stroke is offset. [1]"""
    return np.where(geometry.offset == 0.0, geometry.crank_radius / geometry.rod_length, np.nan)
