"""Load of a crank pin as data: in the crank's axes and in the rod's, with the rod's rotating mass and without."""

import numpy as np

from cranktrain.analysis import SpeedWanted, run
from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.machine import Machine
from cranktrain.mechanisms.dynamics import AnyDynamics
from cranktrain.motion import Array
from cranktrain.plans.acting import refuse_absent, refuse_idle
from cranktrain.plans.placement import place_called
from cranktrain.record import record

_QUANTITIES = (
    "crankpin_load_radial",
    "crankpin_load_tangential",
    "crankpin_radial_without_rod",
    "crankpin_tangential_without_rod",
    "largest_crankpin_load",
    "largest_crankpin_load_at",
)
_ROD = "rod"


@record
class CrankpinLoad:
    """Load of a crank pin over the cycle, each of shape (2, n): across and along an axis. [N]

    Attributes
    ----------
    mechanism : str
    angle : Array, shape (n,)
        Crank angle as the machine shows it. [deg]
    on_pin, on_pin_without : Array
        Tangentially, in the sense of rotation, and radially, away from the shaft: in axes fixed to the crank.
    in_rod, in_rod_without : Array
        What the pin does to the rod's bearing: across, 90° ahead of the rod in the sense of rotation, and along, toward
        the piston; in axes fixed to the rod.
    largest, largest_at : float
        On the grid. [N, deg]
    """

    mechanism: str
    angle: Array
    on_pin: Array
    on_pin_without: Array
    in_rod: Array
    in_rod_without: Array
    largest: float
    largest_at: float

    @property
    def cycle(self) -> float:
        """Length of the cycle. [deg]"""
        return float(len(self.angle) * (self.angle[1] - self.angle[0]))

    @property
    def mean(self) -> float:
        """Mean size of the load over the cycle. [N]"""
        size: Array = np.sqrt(np.sum(self.on_pin * self.on_pin, axis=0))
        return float(np.mean(size))


def pin_loads(machine: Machine, *, mechanism: str | None = None, speed: SpeedWanted = "constant") -> CrankpinLoad:
    """Collect the load of a crank pin.

    Parameters
    ----------
    machine : Machine
        With masses or gas, and a speed.
    mechanism : str, optional
        Whose rod; the first with a rod on a crank pin unless given. A master's load holds its slaves'.
    speed : SpeedWanted
        As `cranktrain.run` takes it.

    Returns
    -------
    CrankpinLoad

    Raises
    ------
    InputError
        If nothing acts on the links, or the mechanism has no rod on a crank pin.

    Notes
    -----
    docs/theory/forces, eqs. (13.35) and (13.36). The rod's load on the pin, turned from the crank's directions to the
    rod's and reversed, is the pin's on the rod.
    """
    refuse_idle(machine)
    first = next((one.name for one in machine.places if _has_rod_on_pin(one.kind.dynamics)), None)
    place = place_called(machine, mechanism or first)
    if not _has_rod_on_pin(place.kind.dynamics):
        raise InputError([Problem("--mechanism", place.name, _("has no rod of its own on a crank pin"))])
    result = run(machine, speed=speed, quantities=_QUANTITIES)
    refuse_absent(result, ("crankpin_load_radial", "largest_crankpin_load"))
    at = result.labels["mechanism"].index(place.name)
    if np.isnan(result.largest_crankpin_load[at]):
        allowed = _("the load of the crank pin goes beyond all bounds where links lie in line: no diagram holds it")
        raise InputError([Problem("", None, allowed)])
    if not result.largest_crankpin_load[at] > 0:
        raise InputError([Problem("", None, _("no load acts on the crank pin, so there is no diagram of it"))])
    radial, tangential, *without = (getattr(result, name)[at] for name in _QUANTITIES[:4])
    phi = np.deg2rad(result.crank_angle) + machine.zero + place.phase
    motion = place.kind.motion(phi, place.geometry)
    lean = np.broadcast_to(motion.rod.angle.value, phi.shape) - phi
    loads = [np.stack([across, -inward]) for inward, across in ((radial, tangential), without)]
    return CrankpinLoad(
        place.name,
        result.crank_angle,
        *loads,
        *(_in_rod(load, lean) for load in loads),
        largest=float(result.largest_crankpin_load[at]),
        largest_at=float(result.largest_crankpin_load_at[at]),
    )


def _has_rod_on_pin(dynamics: AnyDynamics) -> bool:
    """Whether a rod that is the mechanism's own has its bearing on the crank pin."""
    joint = dynamics.joint("crank_pin")
    return joint is not None and dynamics.reactions[joint].on == _ROD


def _in_rod(load: Array, lean: Array) -> Array:
    """Load on the rod, across and along it, from the rod's on the pin; the rod is `lean` ahead of the crank. [rad]"""
    across, along = load
    cos, sin = np.cos(lean), np.sin(lean)
    return -np.stack([across * cos - along * sin, along * cos + across * sin])
