"""Static torque and inertia reduced to every shaft of a drive: what the motor must hold, and what it must speed up."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import N_, Words, _
from cranktrain.layout.crank_angle import CrankAngle, within
from cranktrain.layout.drive.declared import DeclaredDrive
from cranktrain.motion import ONE, Array
from cranktrain.numerics import Extreme, bracketed_roots, largest_between
from cranktrain.numerics.ties import without_residue
from cranktrain.questions.reduction.at_angles import reduced_at
from cranktrain.questions.reduction.cycle_pieces import CyclePieces, mesh_of
from cranktrain.questions.reduction.gear_train import torque_through
from cranktrain.questions.reduction.machines import ReducedMachines
from cranktrain.record import record
from cranktrain.saying.catalogue import extreme, quantity
from cranktrain.saying.checks import Flagged
from cranktrain.transient.gearing import Gearing, overall_ratio
from cranktrain.transient.reduced import ReducedMachine

THEORY = "docs/theory/reduced-machine"
RULES = {
    "by_transmitted_torque": N_("by transmitted torque"),
    "same_efficiency_back": N_("same efficiency back"),
    "always_dividing": N_("always dividing"),
}
"""Where losses go: by the sign of what a stage passes on, with its own efficiency back, or with that forward; or
against the motor always, as [gandzha] has it."""

_SHAFT = ("drive_shaft",)
_CURVE = ("drive_shaft", "crank_angle")

ASIDE = 1e-9
"""Of a corner, on both its sides. [rad]"""
_NOTHING = 1e-9
"""Of the peak: a smaller torque is of neither sign."""


@record
class StaticTorques(Flagged):
    """Static torque and inertia at every shaft of the drive."""

    static_torque: Array = quantity(
        "M_st",
        "N*m",
        _CURVE,
        N_("Torque that holds the machine against its loads, at each shaft of the drive"),
        THEORY,
        "31.9",
    )
    static_motor_torque: Array = quantity(
        "M_st,m",
        "N*m",
        ("loss_rule", "crank_angle"),
        N_("Static torque at the motor, by where losses go"),
        THEORY,
        "31.9",
    )
    largest_static_motor_torque: Array = quantity(
        "M_st,m,max",
        "N*m",
        ("loss_rule",),
        N_("Largest static torque at the motor, by where losses go"),
        THEORY,
        "31.9",
        worst="largest",
    )
    smallest_static_motor_torque: Array = quantity(
        "M_st,m,min",
        "N*m",
        ("loss_rule",),
        N_("Smallest static torque at the motor, by where losses go"),
        THEORY,
        "31.9",
        worst="smallest",
    )
    driven_inertia: Array = quantity(
        "J_k", "kg*m^2", _CURVE, N_("Inertia of drive and machine together, reduced to each shaft"), THEORY, "31.10"
    )
    driven_flywheel_moment: Array = quantity(
        "GD²", "kg*m^2", _CURVE, N_("Flywheel moment GD² at each shaft, four times the inertia"), THEORY, "31.10"
    )
    gear_flywheel_moment: Array = quantity(
        "(GD²)₀", "kg*m^2", _SHAFT, N_("Flywheel moment GD² of the drive without the machine"), THEORY, "31.10"
    )
    largest_static_torque: Extreme = extreme(
        "M_st,max",
        "N*m",
        _SHAFT,
        N_("Largest static torque"),
        N_("Crank angle of the largest static torque"),
        THEORY,
        "31.9",
        worst="largest",
        of="static_torque",
    )
    smallest_static_torque: Extreme = extreme(
        "M_st,min",
        "N*m",
        _SHAFT,
        N_("Smallest static torque, or largest that drives"),
        N_("Crank angle of the smallest static torque"),
        THEORY,
        "31.9",
        worst="smallest",
        of="static_torque",
    )
    mean_static_torque: Array = quantity(
        "M_st,mean", "N*m", _SHAFT, N_("Mean static torque over the crank angle"), THEORY, "31.9"
    )
    rms_static_torque: Array = quantity(
        "M_st,rms", "N*m", _SHAFT, N_("Root mean square of the static torque over the crank angle"), THEORY, "31.9"
    )


class TorqueFacts(NamedTuple):
    """Torque of one design at every shaft: extremes, mean and root mean square, each of shape (shaft,)."""

    largest: Extreme
    smallest: Extreme
    mean: Array
    rms: Array


def static_torques(drive: DeclaredDrive, machines: ReducedMachines, crank_angle: CrankAngle) -> StaticTorques:
    """Reduce loads and inertia to every shaft of the drive.

    Notes
    -----
    docs/theory/reduced-machine, eqs. (31.9) and (31.10).
    """
    grid = np.broadcast_to(crank_angle.angle[:, 0], (len(machines.each), crank_angle.shown.size))
    torque, others, inertia = list[Array](), list[Array](), list[Array]()
    facts: list[TorqueFacts] = []
    for design, (machine, gearing) in enumerate(zip(machines.each, drive.gearings, strict=True)):
        at = reduced_at(machine, grid[design])
        still = at.by_load(0.0 * grid[design])
        torque.append(torque_through(still, ONE, gearing))
        others.append(np.stack([torque_through(still, ONE, other)[0] for other in _other_laws(gearing)]))
        inertia.append(_inertias(at.inertia, gearing))
        corners = machines.corners[design]
        zero = float(crank_angle.zero[min(design, len(crank_angle.zero) - 1), 0, 0])
        facts.append(torque_facts(machine, corners, machines.cycle, gearing, zero=zero, grid=crank_angle.shown))
    driven = np.stack(inertia)
    of_drive = np.stack([_inertias(np.zeros(1), gearing)[:, 0] for gearing in drive.gearings])
    at_motor = np.stack([own[:1] for own in torque])
    ranges = [_by_rule(own, gearing) for own, gearing in zip(facts, drive.gearings, strict=True)]
    return StaticTorques(
        labels={"drive_shaft": drive.shafts, "loss_rule": tuple(RULES)},
        static_torque=np.stack(torque),
        static_motor_torque=np.concatenate([at_motor, np.stack(others)], axis=1),
        largest_static_motor_torque=np.stack([own[1] for own in ranges]),
        smallest_static_motor_torque=np.stack([own[0] for own in ranges]),
        driven_inertia=driven,
        driven_flywheel_moment=4 * driven,
        gear_flywheel_moment=4 * of_drive,
        largest_static_torque=together([own.largest for own in facts]),
        smallest_static_torque=together([own.smallest for own in facts]),
        mean_static_torque=np.stack([own.mean for own in facts]),
        rms_static_torque=np.stack([own.rms for own in facts]),
        flags=tuple(_flags(drive)),
    )


def _other_laws(gearing: Gearing) -> tuple[Gearing, Gearing]:
    """Gearing that is as efficient back as forward; and one whose losses are always against the motor."""
    return gearing._replace(backward=gearing.forward), gearing._replace(backward=1 / gearing.forward)


def _by_rule(found: TorqueFacts, gearing: Gearing) -> Array:
    """Least and largest torque at the motor by each law, shape (2, rule). [N·m]

    By the two other laws it grows with the torque on the crank, which is the last shaft's by any.
    """
    own = np.array([found.smallest.value[0], found.largest.value[0]])
    on_crank = np.array([found.smallest.value[-1], found.largest.value[-1]])
    return np.stack([own, *(torque_through(on_crank, ONE, other)[0] for other in _other_laws(gearing))], axis=1)


def _inertias(machine: Array, gearing: Gearing) -> Array:
    """Inertia of drive and machine reduced to every shaft, the motor's first, shape (shaft, n). [kg·m²]"""
    turned = np.cumprod(np.append(1.0, gearing.ratio))  # turns of the motor for one of each shaft
    at_motor = gearing.motor_inertia + np.sum(gearing.inertia / turned[1:] ** 2) + machine / overall_ratio(gearing) ** 2
    return at_motor * turned[:, np.newaxis] ** 2


def torque_facts(
    machine: ReducedMachine,
    corners: Array,
    cycle: float,
    gearing: Gearing,
    *,
    zero: float,
    grid: Array,
    speed: float = 0.0,
) -> TorqueFacts:
    """Extremes between corners of the torque at a constant speed, and means by quadrature between them.

    Parameters
    ----------
    machine : ReducedMachine
    corners : Array, shape (corner,)
        φ; NaN is none. [rad]
    cycle : float
        [rad]
    gearing : Gearing
    zero : float
        φ from which angles of extremes are counted. [rad]
    grid : Array, shape (n,)
        Equal steps over the cycle, counted so, near which extremes are looked for. [rad]
    speed : float
        Of the crank; static torque unless given. [rad/s]
    """

    def torque(angle: Array) -> Array:
        taken = reduced_at(machine, np.ravel(angle)).taken(np.full(angle.size, speed))
        return torque_through(taken, ONE, gearing).reshape(len(gearing.ratio) + 1, *angle.shape)

    def passed(place: int, angle: Array) -> Array:
        return torque(angle)[place]

    # Where the torque that a stage passes on changes its sign, its losses turn round: with drag not at once in all.
    between = mesh_of(cycle, corners)
    changes = [sign_changes(partial(passed, place), between) for place in range(1, gearing.ratio.size + 1)]
    mesh = mesh_of(cycle, np.concatenate([corners, *changes]))
    samples = torque(grid + zero)
    largest = np.max(np.abs(samples), axis=-1)

    def peak(sign: float) -> Extreme:
        def curves(which: NDArray[np.intp], shown: Array) -> Array:
            return sign * torque(shown + zero)[which, np.arange(len(which))]

        found = largest_between(curves, grid, sign * samples, np.concatenate([corners, *changes]) - zero)
        return Extreme(within(found.angle, cycle), without_residue(sign * found.value, largest))

    at_nodes = torque(mesh.nodes)
    return TorqueFacts(peak(1.0), peak(-1.0), mesh.mean(at_nodes), np.sqrt(mesh.mean(at_nodes**2)))


def together(each: Sequence[Extreme]) -> Extreme:
    """Extremes of all designs, shape (design, shaft)."""
    return Extreme(np.stack([own.angle for own in each]), np.stack([own.value for own in each]))


def _flags(drive: DeclaredDrive) -> Iterator[Words]:
    """Flag irreversible gearing."""
    if any(np.any(gearing.backward < 0) for gearing in drive.gearings):
        yield _("A stage of the drive is irreversible: the motor must drive even while the load pulls.")


def sign_changes(torque: Callable[[Array], Array], mesh: CyclePieces) -> Array:
    """Crank angles at which a torque changes its sign, also where it jumps across 0. [rad]"""
    ends = np.stack([mesh.start + ASIDE, mesh.start + mesh.width - ASIDE], axis=-1)
    places = np.ravel(np.hstack([ends[:, :1], mesh.nodes.reshape(len(mesh.start), -1), ends[:, 1:]]))
    values = torque(places)
    clear = np.abs(values) > _NOTHING * np.max(np.abs(values))
    angles, signs = places[clear], np.sign(values[clear])
    if not angles.size:
        return angles
    cycle = float(np.sum(mesh.width))
    low, high = angles, np.append(angles[1:], angles[0] + cycle)
    changes = signs * np.append(signs[1:], signs[0]) < 0
    return np.mod(bracketed_roots(torque, low[changes], high[changes]), cycle)
