"""How fast the kernels are, as ratios of processor times to other ways of the same, measured in turn in one process.

    python benchmarks/kernels.py [--quick]

Ends with status 1 where a limit is missed. See README.md beside this file.
"""

import sys
from collections.abc import Callable
from typing import Any, NamedTuple

import by_hand
import force_peers
import gas
import loops
import numpy as np
import peers
from comparison import SAME, Comparison, filled, is_kept

from cranktrain.linkage import Pin, in_blocks
from cranktrain.linkage.forces import NO_FRICTION, Body, Conditions, Drive, Gravity
from cranktrain.mechanisms.chain.groups import made_names
from cranktrain.mechanisms.chain.kinematics import chain_motion
from cranktrain.mechanisms.chain.steps import (
    ChainSize,
    Coordinates,
    CrankSize,
    PinStep,
    SlideSize,
    SlideStep,
    Structure,
)
from cranktrain.mechanisms.crank_rocker.kinematics import CrankRocker, crank_rocker
from cranktrain.mechanisms.on_crank import force_on_slider
from cranktrain.mechanisms.slider_crank.forces import slider_crank_forces
from cranktrain.mechanisms.slider_crank.kinematics import SliderCrank, slider_crank

SLIDER_CRANK = SliderCrank(0.04, 0.14, 0.01)
CRANK_ROCKER = CrankRocker(0.3, 1.0, 0.8, 1.1, 1.0)


CHAIN_CRANKS = [(0.05 + 0.01 * i, 0.7 * i) for i in range(5)]
CHAIN_PINS = [(0.4, 0.25 + 0.01 * i, 0.3, 0.35, -1.0) for i in range(5)]
CHAIN_SLIDES = [(0.6, -1.5 + 0.2 * i, 0.01 * i) for i in range(5)]
CHAIN = Structure(
    ("main", *(f"c{i}" for i in range(1, 5))),
    ("C",),
    tuple(
        step
        for i, name in enumerate(("main", *(f"c{i}" for i in range(1, 5))))
        for step in (
            PinStep(f"{name}.pin", "C", f"rod{i}", f"rocker{i}", f"B{i}"),
            SlideStep(f"B{i}", f"link{i}", f"s{i}", "O"),
        )
    ),
    "s0",
)
"""Ten parts: five cranks, each with a pin group and a slide."""
CHAIN_SIZE = ChainSize(
    tuple(CrankSize(*one) for one in CHAIN_CRANKS),
    (Coordinates(0.3, 0.35),),
    tuple(
        size
        for (rod, rocker, _x, _y, side), (link, direction, offset) in zip(CHAIN_PINS, CHAIN_SLIDES, strict=True)
        for size in (Pin(rod, rocker, side), SlideSize(link, 1.0, direction, offset))
    ),
)


FORCED = (Body(3.2, 0.021, -0.004, 0.006), Body(1.15, 0.05, 0.006, 0.0069), Body(0.95, 0.0, 0.0, 0.0))
"""Bodies of crank, rod and slider."""
PRESSING = 5200.0
DRIVE, GRAVITY = Drive(157.0, 850.0), Gravity(-9.2, -3.4)


class Mechanism(NamedTuple):
    """One mechanism: kernel and function by hand, loops that fill a table, a peer's linkage.

    columns: of a motion, all that a table has; n_points: how many of these are of points, which is what the peer gives.
    """

    name: str
    geometry: tuple[float, ...]
    kernel: Callable[..., Any]
    by_hand: Callable[..., Any]
    loop: Callable[..., Any]
    loop_by_hand: Callable[..., Any]
    points_loop: Callable[..., Any]
    peer: Callable[..., Any]
    columns: Callable[[Any], list[Any]]
    n_columns: int
    n_points: int


def coefficients(point):
    """Columns of a point."""
    return [*point.x, *point.y]


def directions(link):
    """Columns of a link, without its origin, which is a point that is there already."""
    return [*link.angle, link.cos, link.sin]


def slider_crank_columns(motion):
    return [*coefficients(motion.pin), *motion.slider, *directions(motion.rod)]


def crank_rocker_columns(motion):
    points = [*coefficients(motion.pin), *coefficients(motion.joint)]
    return [*points, *directions(motion.rod), *directions(motion.rocker)]


MECHANISMS = [
    Mechanism(
        "slider_crank",
        SLIDER_CRANK,
        slider_crank,
        by_hand.slider_crank_numpy,
        loops.slider_crank_loop,
        by_hand.slider_crank_numba,
        loops.slider_crank_points_loop,
        peers.slider_crank,
        slider_crank_columns,
        14,
        9,
    ),
    Mechanism(
        "crank_rocker",
        CRANK_ROCKER,
        crank_rocker,
        by_hand.crank_rocker_numpy,
        loops.crank_rocker_loop,
        by_hand.crank_rocker_numba,
        loops.crank_rocker_points_loop,
        peers.crank_rocker,
        crank_rocker_columns,
        22,
        12,
    ),
]


def chain_columns(motion):
    made, columns = dict(zip(made_names(CHAIN), motion.parts, strict=True)), []
    for i in range(5):
        pin = "main.pin" if i == 0 else f"c{i}.pin"
        columns += [value for name in (pin, f"B{i}", f"s{i}.pin") for value in coefficients(made[name])]
        columns += made[f"s{i}"]
        for link in ("rod", "rocker", "link"):
            columns += directions(made[f"{link}{i}"])
    return columns


def chain_comparison(n):
    """A chain of ten parts against the same by hand."""
    angles = np.arange(n) * (2 * np.pi / n)
    return Comparison(
        "NumPy",
        "NumPy by hand",
        lambda: chain_motion(CHAIN, angles, CHAIN_SIZE),
        lambda: by_hand.chain_numpy(angles, CHAIN_CRANKS, CHAIN_PINS, CHAIN_SLIDES),
        chain_columns,
        list,
        1.3,
    )


def force_columns(forces):
    *on_pins, guide = forces.joints
    pins = [part for wrench in on_pins for part in wrench[:2]]
    return [*pins, guide.y, forces.driving_torque]


def force_comparisons(n):
    """Motion, reactions and torque of a slider-crank with a rigid rod, from the crank angle."""
    angles = np.arange(n) * (2 * np.pi / n)
    geometry, bodies = SliderCrank(*SLIDER_CRANK), tuple(FORCED)
    conditions = Conditions(DRIVE, GRAVITY, (NO_FRICTION,))
    crank, rod, piston = (tuple(body) for body in FORCED)
    given = tuple(geometry), crank, rod, piston[0], PRESSING, *DRIVE, tuple(GRAVITY)

    def forces():
        motion = slider_crank(angles, geometry)
        load = force_on_slider(motion, geometry, -PRESSING)
        return slider_crank_forces(motion, geometry, bodies, load, conditions)

    def forces_by_hand():
        return by_hand.slider_crank_forces_numpy(angles, *given)

    loop = filled(loops.slider_crank_forces_loop, angles, (geometry, bodies, PRESSING, conditions), 8)
    loop_by_hand = filled(by_hand.slider_crank_forces_numba, angles, given, 8)
    yield Comparison("NumPy", "NumPy by hand", forces, forces_by_hand, force_columns, list, 3.0)
    yield Comparison("compiled", "Numba by hand", loop, loop_by_hand, list, list, 1.7)


def golden_forces(n):
    """Forces of the golden case's slider-crank at n angles: with NumPy, and compiled as a loop that fills a table."""
    angles = np.arange(n) * (2 * np.pi / n)
    given = force_peers.machine()
    geometry = SliderCrank(given.crank_radius, given.rod_length, 0.0)
    (crank, crank_off, crank_inertia), (rod, rod_off, rod_inertia) = given.crank, given.rod
    bodies = (
        Body(crank, crank_off, 0.0, crank_inertia),
        Body(rod, rod_off, 0.0, rod_inertia),
        Body(given.piston[0], 0.0, 0.0, given.piston[1]),
    )
    conditions = Conditions(Drive(given.speed, 0.0), Gravity(0.0, 0.0), (NO_FRICTION,))

    def forces():
        motion = slider_crank(angles, geometry)
        return slider_crank_forces(motion, geometry, bodies, force_on_slider(motion, geometry, 0.0), conditions)

    return forces, filled(loops.slider_crank_forces_loop, angles, (geometry, bodies, 0.0, conditions), 8)


FORCE_PEERS = (
    ("kinepy", force_peers.kinepy_forces, 1, 2e-5, (1 / 10, 1 / 50)),
    ("Exudyn", force_peers.exudyn_forces, 1, 1e-4, (1 / 100, 1 / 100)),
    ("Exudyn, 1e-6", force_peers.exudyn_forces, 6, 1e-6, (1 / 100, 1 / 100)),
)
"""Name, solution, how many steps it takes for one angle, its error at most, limits for NumPy and compiled."""


def force_peer_comparisons(n):
    """Forces of the golden case against those by kinepy and by Exudyn, with as many steps as angles and with more."""
    forces, loop = golden_forces(n)
    for against, peer, n_steps, apart, limits in FORCE_PEERS:
        solve, read = peer(force_peers.machine(), n_steps * n)

        def their_columns(_solved, read=read, n_steps=n_steps):
            return list(read()[:, ::n_steps])

        solve()
        errors = f"errors {force_peers.error(force_columns(forces())):.0e}, {force_peers.error(read()):.0e}"
        for what, ours, our_columns, limit in (
            ("NumPy", forces, force_columns, limits[0]),
            ("compiled", loop, list, limits[1]),
        ):
            yield Comparison(what, against, ours, solve, our_columns, their_columns, limit, apart, errors)


def stepped(mechanism, n):
    """A new linkage of the peer's, as a function without arguments that goes through one turn."""
    linkage = mechanism.peer(n, *mechanism.geometry)
    return lambda: linkage.step_fast_with_kinematics(n)


def comparisons(mechanism, n):
    """All that is compared at n angles of a turn."""
    angles = np.arange(n) * (2 * np.pi / n)
    geometry, columns, n_points = mechanism.geometry, mechanism.columns, mechanism.n_points

    def kernel():
        return mechanism.kernel(angles, geometry)

    def blocks():
        return in_blocks(mechanism.kernel, angles, geometry)

    def by_hand():
        return mechanism.by_hand(angles, *geometry)

    def points(motion):
        return columns(motion)[:n_points]

    def points_of_peer(simulated):
        return peers.columns(simulated)[:n_points]

    loop = filled(mechanism.loop, angles, geometry, mechanism.n_columns)
    loop_by_hand = filled(mechanism.loop_by_hand, angles, geometry, mechanism.n_columns)
    points_loop = filled(mechanism.points_loop, angles, geometry, n_points)
    # The peer adds up the turn from n steps, each of them rounded.
    apart = max(SAME, n * np.finfo(float).eps)
    yield Comparison("NumPy", "NumPy by hand", kernel, by_hand, columns, list, 1.3)
    yield Comparison("compiled", "Numba by hand", loop, loop_by_hand, list, list, 1.05)
    yield Comparison("NumPy", "pylinkage", blocks, stepped(mechanism, n), points, points_of_peer, 1 / 4, apart)
    yield Comparison("compiled", "pylinkage", points_loop, stepped(mechanism, n), list, points_of_peer, 1 / 8, apart)


def main(arguments):
    n_repetitions = 15 if "--quick" in arguments else 101
    print(" " * 43 + "ns an angle")
    print("mechanism     angles  what     against           ours  theirs    ratio         min–max   limit")
    kept = [
        is_kept(mechanism.name, n, comparison, n_repetitions)
        for n in (720, 100_000)
        for mechanism in MECHANISMS
        for comparison in comparisons(mechanism, n)
    ]
    kept += [is_kept("forces", n, each, n_repetitions) for n in (720, 100_000) for each in force_comparisons(n)]
    kept += [is_kept("forces", 720, each, n_repetitions) for each in force_peer_comparisons(720)]
    kept += [is_kept("gas", n, each, n_repetitions) for n in (720, 100_000) for each in gas.comparisons(n)]
    kept += [is_kept("chain", n, chain_comparison(n), n_repetitions) for n in (720, 100_000)]
    sys.exit(not all(kept))


if __name__ == "__main__":
    main(sys.argv[1:])
