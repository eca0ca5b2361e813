"""What is asked of an articulated rod alone: which articulation angle would leave a dead centre unshifted."""

import numpy as np

from cranktrain.language import N_, _
from cranktrain.mechanisms.articulated_rod.kinematics import ArticulatedRod, articulated_rod
from cranktrain.mechanisms.kind import Members
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.saying.catalogue import quantity
from cranktrain.saying.checks import Check, Checked

_ROD = ("articulated_rod",)
_THEORY = "docs/theory/articulated-rod"


@record
class ArticulatedRods(Members[ArticulatedRod]):
    """The articulated rods of a machine."""


@record
class Articulation(Checked):
    """Where the knuckle pin stands, and where it would have to stand for an unshifted dead centre."""

    offset_angle: Array = quantity(
        "ψ", "rad", _ROD, N_("Articulation angle less bank angle, ζ − γ"), _THEORY, "definition"
    )
    articulation_angle_without_top_shift: Array = quantity(
        "ζ_T",
        "rad",
        _ROD,
        N_("Articulation angle that would leave the slave's top dead centre unshifted"),
        _THEORY,
        "4.8",
    )
    articulation_angle_without_bottom_shift: Array = quantity(
        "ζ_B",
        "rad",
        _ROD,
        N_("Articulation angle that would leave the slave's bottom dead centre unshifted"),
        _THEORY,
        "4.9",
    )


def articulation(rods: ArticulatedRods) -> Articulation:
    """Zero-shift angles of every slave: γ ± asin((R sin γ ∓ e)/L); NaN for a slave whose own cylinder is offset."""
    geometry = rods.geometry
    master = geometry.master
    sine = master.crank_radius * np.sin(geometry.bank_angle)
    central = np.where(geometry.offset == 0.0, 0.0, np.nan)
    top = geometry.bank_angle + np.arcsin((sine - master.offset) / master.rod_length) + central
    bottom = geometry.bank_angle - np.arcsin((sine + master.offset) / master.rod_length) + central
    return Articulation(
        offset_angle=(geometry.articulation_angle - geometry.bank_angle)[..., 0],
        articulation_angle_without_top_shift=top[..., 0],
        articulation_angle_without_bottom_shift=bottom[..., 0],
        checks=(_zero_shift_check(geometry, top),) if np.any(geometry.offset == 0.0) else (),
    )


def _zero_shift_check(geometry: ArticulatedRod, angle: Array) -> Check:
    """With ζ_T the slave stands still at α = γ, at H = R + r + l: a theorem that the kernel does not know."""
    slider = articulated_rod(geometry.bank_angle, geometry._replace(articulation_angle=angle)).slider
    radius = geometry.master.crank_radius
    height = radius + geometry.knuckle_radius + geometry.rod_length
    residual = np.maximum(np.abs(slider.first) / radius, np.abs(slider.value - height) / height)
    central = np.where(geometry.offset == 0.0, residual, 0.0)
    return Check(
        "zero_shift",
        _("with ζ_T the slave turns back at α = γ, at H = R + r + l from the shaft (relative to R and H)"),
        np.max(central, axis=(1, 2)),
        1e-13,
    )
