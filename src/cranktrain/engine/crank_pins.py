"""Loads of the crank pins: what every rod does to its pin, with its rotating mass and without."""

from collections.abc import Iterator
from typing import ClassVar, NamedTuple

import numpy as np

from cranktrain.catalogue import quantity
from cranktrain.engine.forces import LoadedMachine, SolvedCycle
from cranktrain.engine.layout import CrankAngle, Mechanisms
from cranktrain.language import N_, _
from cranktrain.linkage import Crank
from cranktrain.linkage.forces import crank_link
from cranktrain.loads.crank_pin import pin_load, with_rotating_mass
from cranktrain.loads.rod_masses import two_masses
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.wording import Names, number

_MECHANISM = ("mechanism",)
_CURVE = ("mechanism", "crank_angle")
_THEORY = "docs/theory/forces"
_PIN, _ROD = "crank_pin", "rod"
_ALIKE = 1e-9
"""Loads that differ by less, relative, are the same; the first is named."""


class CrankPin(NamedTuple):
    """A group of mechanisms with crank pins: its place among the groups, the joint's among the reactions."""

    group: int
    joint: int
    has_rod: bool


@record
class CrankPins:
    """Which mechanisms have something of their own on a crank pin."""

    needs: ClassVar[str] = ""

    pins: tuple[CrankPin, ...]


def crank_pins_of(mechanisms: Mechanisms) -> CrankPins | None:
    """Find the joints at crank pins; a slave's pin is its master's. None where there is none."""
    pins = tuple(_pins(mechanisms))
    return CrankPins(pins) if pins else None


def _pins(mechanisms: Mechanisms) -> Iterator[CrankPin]:
    for place, group in enumerate(mechanisms.groups):
        dynamics = group.kind.dynamics
        for joint, reaction in enumerate(dynamics.reactions):
            if reaction.name == _PIN and reaction.on in dynamics.moving:
                yield CrankPin(place, joint, reaction.on == _ROD)


@record
class CrankPinLoads:
    """Load of every rod on its crank pin, with what hangs on the rod; NaN for what has no rod there."""

    crankpin_load_radial: Array = quantity(
        "K_R", "N", _CURVE, N_("Load of the crank pin toward the shaft, the whole rod's"), _THEORY
    )
    crankpin_load_tangential: Array = quantity(
        "T_R", "N", _CURVE, N_("Load of the crank pin in the sense of rotation"), _THEORY
    )
    crankpin_load_radial_without_rod: Array = quantity(
        "K",
        "N",
        _CURVE,
        N_("Load of the crank pin toward the shaft without the rod's rotating mass, which then goes with the crank"),
        _THEORY,
    )
    largest_crankpin_load: Array = quantity(
        "R_max", "N", _MECHANISM, N_("Largest load of the crank pin on the grid of crank angles"), _THEORY
    )
    largest_crankpin_load_at: Array = quantity(
        "φ(R_max)", "deg", _MECHANISM, N_("Crank angle of the largest load of the crank pin"), _THEORY
    )

    def answer(self, names: Names, design: int) -> str | None:
        """Say the largest load of a crank pin."""
        largest = self.largest_crankpin_load[design]
        if np.all(np.isnan(largest)):
            return None
        worst = int(np.argmax(largest >= (1 - _ALIKE) * np.nanmax(largest)))
        return _("Largest load of a crank pin {load}, by the rod of {mechanism} at {angle}.").format(
            load=number(float(largest[worst]), "kN"),
            mechanism=names["mechanism"][worst],
            angle=number(float(self.largest_crankpin_load_at[design, worst]), "deg"),
        )


def crank_pin_loads(
    pins: CrankPins, loaded: LoadedMachine, solved: SolvedCycle, crank_angle: CrankAngle
) -> CrankPinLoads:
    """Loads of all crank pins from the joints' reactions, exact for rigid bodies.

    Notes
    -----
    A master's load holds its slaves'. Only one of both radial loads goes with a crank: the one without where the
    crank's masses have the rod's rotating share. docs/theory/forces, eqs. (13.35) and (13.36).
    """
    phi = crank_angle.angle
    shape = (len(phi), len(loaded.mechanisms.names), phi.shape[-1])
    radial, tangential, without = np.full((3, *shape), np.nan)
    for pin in pins.pins:
        group, one = loaded.mechanisms.groups[pin.group], solved.groups[pin.group]
        size = group.members.geometry
        radius: Array = np.hypot(one.motion.pin.x.value, one.motion.pin.y.value)[..., :1]
        load = pin_load(one.forces.joints[pin.joint], crank_link(one.motion.pin, Crank(radius)))
        radial[:, group.index], tangential[:, group.index] = load
        if pin.has_rod:
            rotating = two_masses(loaded.masses.groups[pin.group].bodies.rod, size.rod_length).first
            without[:, group.index] = with_rotating_mass(load, -rotating, radius, loaded.speed.drive(phi)).radial
    load = np.hypot(radial, tangential)
    largest = np.argmax(np.where(np.isnan(load), -np.inf, load), axis=-1)[..., np.newaxis]
    value = np.take_along_axis(load, largest, axis=-1)[..., 0]
    return CrankPinLoads(
        crankpin_load_radial=radial,
        crankpin_load_tangential=tangential,
        crankpin_load_radial_without_rod=without,
        largest_crankpin_load=value,
        largest_crankpin_load_at=np.where(np.isnan(value), np.nan, crank_angle.shown[largest[..., 0]]),
    )
