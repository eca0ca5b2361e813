"""Loads of the crank pins: what every rod does to its pin, with its rotating mass and without, and whose it is."""

import numpy as np

from cranktrain.language import N_
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.linkage import Crank, crank
from cranktrain.linkage.forces import Gravity, Wrench, crank_link
from cranktrain.motion import ONE, ZERO, Array, Link
from cranktrain.numerics import Extreme
from cranktrain.numerics.nested import put
from cranktrain.questions.forces.joint_forces import JointForces, joint_label
from cranktrain.questions.forces.loaded_machine import LoadedMachine
from cranktrain.questions.forces.pin_load import (
    PinLoad,
    RodBearingLoad,
    pin_load,
    rod_bearing_load,
    with_rotating_mass,
)
from cranktrain.questions.forces.rod_masses import weighed_ends
from cranktrain.questions.forces.solved_cycle import SolvedCycle
from cranktrain.record import record
from cranktrain.references import THEORY_OF_CRANKSHAFT as _CRANKSHAFT
from cranktrain.references import THEORY_OF_FORCES as _THEORY
from cranktrain.saying.catalogue import extreme, quantity

_CURVE = ("mechanism", "crank_angle")


def have_crank_pins(mechanisms: Mechanisms) -> bool:
    """Whether any mechanism has something of its own on a crank pin; a slave's pin is its master's."""
    return any(batch.kind.dynamics.joint("crank_pin") is not None for batch in mechanisms.batches)


@record
class CrankPinLoads:
    """Load of every rod on its crank pin, with what hangs on the rod; NaN for what has no rod there.

    Of the shares, which add up to a pin's load, a slave has its own: that comes through its master's rod.
    """

    crankpin_load_radial: Array = quantity(
        "K_R", "N", _CURVE, N_("Load of the crank pin toward the shaft, the whole rod's"), _THEORY, "13.35"
    )
    crankpin_load_tangential: Array = quantity(
        "T_R", "N", _CURVE, N_("Load of the crank pin in the sense of rotation"), _THEORY, "13.35"
    )
    crankpin_radial_without_rod: Array = quantity(
        "K",
        "N",
        _CURVE,
        N_("Load of the crank pin toward the shaft without the rod's rotating mass, which then goes with the crank"),
        _THEORY,
        "13.35, 13.36",
    )
    crankpin_tangential_without_rod: Array = quantity(
        "T",
        "N",
        _CURVE,
        N_("Load of the crank pin in the sense of rotation without the rod's rotating mass"),
        _THEORY,
        "13.35, 13.36",
    )
    crankpin_share_radial: Array = quantity(
        "K_i",
        "N",
        _CURVE,
        N_("Share of this piston and rod in the crank pin's load toward the shaft, a slave's through its master"),
        _THEORY,
        "13.3, 13.35",
    )
    crankpin_share_tangential: Array = quantity(
        "T_i",
        "N",
        _CURVE,
        N_("Share of this piston and rod in the crank pin's load in the sense of rotation"),
        _THEORY,
        "13.3, 13.35",
    )
    rod_bearing_load_along: Array = quantity(
        "R_L",
        "N",
        _CURVE,
        N_("Load of the crank pin on the rod's bearing, along the rod to its other pin"),
        _CRANKSHAFT,
        "24.45",
    )
    rod_bearing_load_across: Array = quantity(
        "R_A",
        "N",
        _CURVE,
        N_("Load of the crank pin on the rod's bearing, across the rod, 90° from its line in the sense of rotation"),
        _CRANKSHAFT,
        "24.45",
    )
    largest_crankpin_load: Extreme = extreme(
        "R_max",
        "N",
        ("mechanism",),
        N_("Largest load of the crank pin"),
        N_("Crank angle of the largest load of the crank pin"),
        _THEORY,
        "13.35",
        worst="largest",
    )


def crank_pin_loads(
    loaded: LoadedMachine, solved: SolvedCycle, crank_angle: CrankAngle, joints: JointForces
) -> CrankPinLoads:
    """Loads of all crank pins from the joints' reactions, exact for rigid bodies.

    Notes
    -----
    A master's load holds its slaves'. Only one of both radial loads goes with a crank: the one without where the
    crank's masses have the rod's rotating share. docs/theory/forces, eqs. (13.35) and (13.36).
    """
    phi = crank_angle.angle
    shape = (len(phi), len(loaded.mechanisms.names), phi.shape[-1])
    whole, without = (PinLoad(*np.full((2, *shape), np.nan)) for _i in range(2))
    on_rods = RodBearingLoad(*np.full((2, *shape), np.nan))
    largest = Extreme(*np.full((2, *shape[:-1]), np.nan))
    for batch, one, made in zip(loaded.mechanisms.batches, solved.batches, loaded.masses.batches, strict=True):
        joint = batch.kind.dynamics.joint("crank_pin")
        if joint is None:
            continue
        radius: Array = np.hypot(one.motion.pin.x.value[..., :1], one.motion.pin.y.value[..., :1])
        link = crank_link(one.motion.pin, Crank(radius))
        load = pin_load(one.forces.joints[joint], link)
        put(whole, batch.index, load)
        reaction = batch.kind.dynamics.reactions[joint]
        if reaction.on == "rod":
            put(on_rods, batch.index, rod_bearing_load(one.forces.joints[joint], one.motion.rod))
            rod = batch.kind.dynamics.by_link(made.bodies)["rod"]
            rotating = weighed_ends(rod, batch.members.geometry.rod_length).first
            massless = with_rotating_mass(load, -rotating, radius, loaded.speed.drive(phi))
            put(without, batch.index, map(np.subtract, massless, _weight(rotating, made.gravity, link)))
        names = (joint_label(loaded.mechanisms.names[i], reaction) for i in map(int, batch.index))
        rows = [joints.labels["joint"].index(name) for name in names]
        put(largest, batch.index, [part[:, rows] for part in joints.largest_joint_force[:2]])
    shares = _shares(whole, loaded, solved, phi)
    return CrankPinLoads(
        crankpin_load_radial=whole.radial,
        crankpin_load_tangential=whole.tangential,
        crankpin_radial_without_rod=without.radial,
        crankpin_tangential_without_rod=without.tangential,
        crankpin_share_radial=shares.radial,
        crankpin_share_tangential=shares.tangential,
        rod_bearing_load_along=on_rods.along,
        rod_bearing_load_across=on_rods.across,
        largest_crankpin_load=largest,
    )


def _weight(mass: Array, gravity: Gravity, crank_of: Link) -> PinLoad:
    """Load of a crank pin by the weight of a mass on it."""
    return pin_load(Wrench(-mass * gravity.x, -mass * gravity.y, ZERO), crank_of)


def _shares(whole: PinLoad, loaded: LoadedMachine, solved: SolvedCycle, phi: Array) -> PinLoad:
    """What of the pins' loads is each mechanism's own; a master has what its slaves leave, its guide's friction too."""
    shares = PinLoad(*(part.copy() for part in whole))
    for batch, one in zip(loaded.mechanisms.batches, solved.batches, strict=True):
        joint = batch.kind.dynamics.joint("crank_pin", is_own=False)
        if joint is None:
            continue
        direction = crank(phi - loaded.mechanisms.nominal_top[:, batch.index], Crank(ONE))
        load = pin_load(one.forces.joints[joint], crank_link(direction, Crank(ONE)))
        put(shares, batch.index, load)
        for member, master in enumerate(loaded.carriers.master[batch.index].tolist()):
            for part, values in zip(shares, load, strict=True):
                part[:, master] -= values[:, member]
    return shares
