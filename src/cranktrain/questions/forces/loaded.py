"""Forces in every joint of a machine, and the torque that its mechanisms give to the shaft."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property, reduce
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.catalogue import quantity
from cranktrain.checks import Check
from cranktrain.language import N_, _
from cranktrain.layout.crank_angle import CrankAngle
from cranktrain.layout.guide_tables import Edges
from cranktrain.layout.masses import Masses
from cranktrain.layout.mechanisms import Mechanisms
from cranktrain.layout.places import Place
from cranktrain.layout.speed import Speed
from cranktrain.linkage.forces import Conditions, Drive, Friction, Wrench, added, torque_by_work
from cranktrain.motion import Array, Coefficient, single
from cranktrain.numerics import in_slots
from cranktrain.questions.gas.chambers import GasInChambers
from cranktrain.questions.gas.pressures import GasPressures
from cranktrain.record import record

_MECHANISM = ("mechanism", "crank_angle")
_THEORY = "docs/theory/forces"
_TORQUES_LIMIT = 1e-12
_MASTER = "slider_crank"
"""Kind of what slaves hang on."""


@record
class Carriers:
    """Which mechanisms hang on which, and which pistons they are.

    Attributes
    ----------
    master : array of int, shape (mechanism,)
        On whose rod a slave hangs; −1 for a mechanism on the crank itself.
    piston : array of int, shape (mechanism,)
        Which piston it drives; −1 for none.
    """

    needs: ClassVar[str] = ""

    master: NDArray[np.intp]
    piston: NDArray[np.intp]

    @property
    def driven(self) -> NDArray[np.intp]:
        """Which mechanism drives each piston, shape (piston,)."""
        found = np.flatnonzero(self.piston >= 0)
        return found[np.argsort(self.piston[found])]


def carriers_of(places: Sequence[Place]) -> Carriers:
    """Find every slave's master: the slider-crank of the bank that it names, on the same throw."""
    master: list[int] = []
    pistons = 0
    piston: list[int] = []
    for place in places:
        bank = getattr(place.spec, "master", None)
        master.append(
            next(
                (
                    i
                    for i, other in enumerate(places)
                    if other.bank == bank
                    and (other.shaft, other.throw) == (place.shaft, place.throw)
                    and other.kind.name == _MASTER
                ),
                -1,
            )
            if bank is not None
            else -1
        )
        is_piston = place.kind.output == "slider"
        piston.append(pistons if is_piston else -1)
        pistons += is_piston
    return Carriers(np.array(master, dtype=np.intp), np.array(piston, dtype=np.intp))


class SolvedGroup(NamedTuple):
    """Forces of the mechanisms of one kind, arrays of shape (design, member, n).

    motion; loads, those of the mechanism alone; conditions; and `Forces`, whose joints bear what slaves hand over as
    well.
    """

    motion: Any
    loads: Any
    conditions: Conditions
    forces: Any


@record
class LoadedMachine:
    """A machine with all that acts on it, to be solved at any crank angle.

    Attributes
    ----------
    mechanisms : Mechanisms
    carriers : Carriers
    masses : Masses
    gas : GasInChambers or None
    speed : Speed
    """

    mechanisms: Mechanisms
    carriers: Carriers
    masses: Masses
    gas: GasInChambers | None
    speed: Speed

    def motions(self, angle: Array) -> tuple[Any, ...]:
        """Motion of every mechanism at crank angles φ [rad], in the order of `mechanisms.groups`."""
        return tuple(
            group.kind.motion(_own(angle, group.index) + group.members.phase, group.members.geometry)
            for group in self.mechanisms.groups
        )

    def solved(
        self,
        angle: Array,
        friction_sense: float | None = None,
        *,
        gas_force: Array | None = None,
        motions: Sequence[Any] | None = None,
    ) -> tuple[SolvedGroup, ...]:
        """Solve every mechanism.

        Parameters
        ----------
        angle : Array, shape (n,), (design, 1, n) or (design, mechanism, n)
            φ, the same for all mechanisms or one for each; those that hang on one rod or share a chamber have the same.
            [rad]
        friction_sense : float, optional
            +1 or −1 for the value on either side of a standstill; of each slider's own velocity unless given.
        gas_force : Array, shape (design, piston, n), optional
            Of the gas on the pistons toward their shafts, where it is known already. [N]
        motions : sequence, optional
            Of `motions` at the same angles, where the caller has them.

        Returns
        -------
        tuple of SolvedGroup
            In the order of `mechanisms.groups`.
        """
        moving = self.motions(angle) if motions is None else motions
        toward = self._gas_force(angle, moving) if gas_force is None else gas_force
        drives = self.speed.drive(angle)
        on_rods: dict[int, Wrench] = {}
        found: dict[int, SolvedGroup] = {}
        groups = list(enumerate(self.mechanisms.groups))
        # Slaves first: what they do to their masters' rods is a load there.
        for place, group in sorted(groups, key=lambda one: one[1].kind.dynamics.on_master is None):
            dynamics, size = group.kind.dynamics, group.members.geometry
            motion = moving[place]
            made = self.masses.groups[place]
            loads = borne = dynamics.load(motion, size, self._pressing(group.index, toward))
            handed = _of_slaves(group.index, on_rods) if group.kind.name == _MASTER else None
            if handed is not None:
                borne = loads._replace(rod=added(loads.rod, handed))
            friction = tuple(
                _friction(group.kind.part(motion, name), coefficient, edges, friction_sense)
                for name, coefficient, edges in zip(dynamics.sliding, made.friction, made.edges, strict=True)
            )
            drive = Drive(*(_own(part, group.index) for part in drives))
            conditions = Conditions(drive, made.gravity, friction)
            forces = dynamics.forces(motion, size, made.bodies, borne, conditions)
            found[place] = SolvedGroup(motion, loads, conditions, forces)
            if dynamics.on_master is not None and (knuckle := dynamics.joint("knuckle_pin")) is not None:
                wrench = dynamics.on_master(motion, size, forces.joints[knuckle])
                for member, mechanism in enumerate(group.index.tolist()):
                    master = int(self.carriers.master[mechanism])
                    own = Wrench(*(part[:, member : member + 1] for part in wrench))
                    on_rods[master] = Wrench(*map(np.add, on_rods[master], own)) if master in on_rods else own
        return tuple(found[place] for place, _group in groups)

    @cached_property
    def sharing(self) -> NDArray[np.intp]:
        """One number for all mechanisms that hang on one rod or share a chamber, shape (mechanism,)."""
        label = np.arange(len(self.mechanisms.names), dtype=np.intp)
        pairs = [(slave, master) for slave, master in enumerate(self.carriers.master.tolist()) if master >= 0]
        if self.gas is not None:
            driven, works = self.carriers.driven, np.any(self.gas.chambers.areas != 0.0, axis=0)
            pairs += [(driven[np.argmax(own)], other) for own in works.T for other in driven[own].tolist()]
        for one, other in pairs:
            label[label == label[one]] = label[other]
        return label

    def of_each(
        self,
        rows: NDArray[np.intp],
        which: NDArray[np.intp],
        angle: Array,
        pick: Callable[[tuple[SolvedGroup, ...]], Array],
    ) -> Array:
        """Solve the machine where some of its curves are asked for, each at angles of its own.

        Parameters
        ----------
        rows : array of int, shape (curve,)
            Of which mechanism each curve is.
        which : array of int, shape (p,)
            Which curves are asked for, counted design by design.
        angle : Array, shape (p, k)
            φ. [rad]
        pick : callable
            From what `solved` gives to all curves, shape (design, curve, …).

        Returns
        -------
        Array, shape (p, k)

        Notes
        -----
        Mechanisms that have nothing to do with each other are asked at different angles at once.
        """
        n_designs, n_mechanisms = len(self.speed.value), self.sharing.size
        design, row = np.divmod(which, rows.size)
        label = self.sharing[rows]
        asked, slot = in_slots(design * n_mechanisms + label[row], angle, n_designs * n_mechanisms)
        each = asked.reshape(n_designs, n_mechanisms, -1)[:, self.sharing]
        found = pick(self.solved(each))
        return found.reshape(n_designs, rows.size, *asked.shape[1:])[design, row, slot]

    def _gas_force(self, angle: Array, motions: Sequence[Any]) -> Array | None:
        """Force of the gas on every piston toward its shaft, shape (design, piston, n); None without gas."""
        if self.gas is None:
            return None
        driven = self.carriers.driven
        slider = np.empty((3, len(self.speed.value), len(driven), angle.shape[-1]))
        for group, motion in zip(self.mechanisms.groups, motions, strict=True):
            piston = self.carriers.piston[group.index]
            if piston[0] >= 0:
                for part, values in zip(slider, motion.slider, strict=True):
                    part[:, piston] = values
        by_chamber = _own(angle, driven[self.gas.chambers.leading])
        return self.gas.force(self.gas.pressure(by_chamber, self.gas.volume_by(Coefficient(*slider))))

    def _pressing(self, index: NDArray[np.intp], toward: Array | None) -> Array:
        """Force along the output of each of some mechanisms, away from the shaft, shape (design, member, n)."""
        piston = self.carriers.piston[index]
        return np.zeros((1, 1, 1)) if toward is None or piston[0] < 0 else -toward[:, piston]


def _own(values: Array, index: NDArray[np.intp]) -> Array:
    """What some mechanisms have of values (n,), (design, 1, n) for all, or (design, mechanism, n) for each."""
    return values[:, index] if values.ndim == 3 and values.shape[1] > 1 else values


def _friction(slider: Coefficient, coefficient: Array, edges: Edges, sense: float | None) -> Friction:
    """Friction of what slides, and where its guide's middle lies from it: edges that stay are left behind."""
    return Friction(
        coefficient,
        np.sign(slider.first) if sense is None else single(sense),
        edges.per_length,
        edges.middle - edges.stays * slider.value,
    )


def _of_slaves(index: NDArray[np.intp], on_rods: Mapping[int, Wrench]) -> Wrench | None:
    """What slaves do to the rods of some mechanisms, shape (design, member, n); None where there is none."""
    if not any(int(mechanism) in on_rods for mechanism in index):
        return None
    nothing = Wrench(*(np.zeros_like(part) for part in next(iter(on_rods.values()))))
    rods = [on_rods.get(int(mechanism), nothing) for mechanism in index]
    return Wrench(*(np.concatenate(parts, axis=1) for parts in zip(*rods, strict=True)))


def loaded_machine(
    mechanisms: Mechanisms, carriers: Carriers, masses: Masses, speed: Speed, gas: GasInChambers | None
) -> LoadedMachine:
    """Put masses and gas to the mechanisms."""
    return LoadedMachine(mechanisms, carriers, masses, gas, speed)


def driving_torques(loaded: LoadedMachine, solved: Sequence[SolvedGroup]) -> Array:
    """Torque that must be applied at each mechanism's crank, by the reactions.

    Parameters
    ----------
    loaded : LoadedMachine
    solved : sequence of SolvedGroup
        What `LoadedMachine.solved` gave.

    Returns
    -------
    Array, shape (design, mechanism, n)
        A slave's comes through its master's crank pin: 0 for itself. [N·m]
    """
    shape = solved[0].forces.driving_torque.shape
    torque = np.zeros((shape[0], len(loaded.mechanisms.names), shape[-1]))
    for group, one in zip(loaded.mechanisms.groups, solved, strict=True):
        is_own = loaded.carriers.master[group.index] < 0
        torque[:, group.index[is_own]] = one.forces.driving_torque[:, is_own]
    return torque


@record
class SolvedCycle:
    """Forces of every mechanism on the grid of crank angles; nothing that people read as it is."""

    groups: tuple[SolvedGroup, ...]


def solved_cycle(loaded: LoadedMachine, crank_angle: CrankAngle, gas: GasPressures | None) -> SolvedCycle:
    """Solve the machine on its grid."""
    return SolvedCycle(loaded.solved(crank_angle.angle, gas_force=None if gas is None else gas.gas_force))


def largest_in_joints(loaded: LoadedMachine, solved: Sequence[SolvedGroup]) -> Array:
    """Largest force in any joint of each mechanism, shape (design, mechanism). [N]"""
    return _by_mechanism(loaded, (_largest_force(one) for one in solved))


def forces_times_arms(loaded: LoadedMachine, solved: Sequence[SolvedGroup]) -> Array:
    """What the joints of each mechanism could do to the shaft at most, shape (design, mechanism). [N·m]

    Its largest force by the longest way of its pins for a turn of 1 rad, and its largest moment by the fastest turn.
    """
    found: list[Array] = []
    for group, one in zip(loaded.mechanisms.groups, solved, strict=True):
        links = group.kind.dynamics.links(one.motion, group.members.geometry)
        way = np.sqrt(_largest(link.origin.x.first**2 + link.origin.y.first**2 for link in links))
        turn = _largest(np.abs(link.angle.first) for link in links)
        moment = _largest(np.abs(joint.moment) for joint in one.forces.joints)
        found.append(_largest_force(one) * way + moment * turn)
    return _by_mechanism(loaded, found)


def _largest_force(one: SolvedGroup) -> Array:
    """Largest force in any joint of each mechanism of one kind, shape (design, member)."""
    return np.sqrt(_largest(joint.x * joint.x + joint.y * joint.y for joint in one.forces.joints))


def _largest(curves: Iterable[Array]) -> Array:
    """Largest value of several curves of shape (..., n), each of which may stand for all."""
    return reduce(np.maximum, (np.max(curve, axis=-1) for curve in map(np.atleast_1d, curves)))


def _by_mechanism(loaded: LoadedMachine, groups: Iterable[Array]) -> Array:
    """Put what the mechanisms of each kind have into the machine's order."""
    values = list(groups)
    order = np.argsort(np.concatenate([group.index for group in loaded.mechanisms.groups]))
    n_designs = max(len(value) for value in values)
    shaped = (
        np.broadcast_to(value, (n_designs, group.index.size))
        for value, group in zip(values, loaded.mechanisms.groups, strict=True)
    )
    return np.concatenate(list(shaped), axis=1)[:, order]


@record
class MechanismTorques:
    """What every mechanism does to the shaft, and all together."""

    mechanism_torque: Array = quantity(
        "M_i", "N*m", _MECHANISM, N_("Torque of the mechanism on its shaft, by virtual work"), _THEORY
    )
    driving_torque: Array = quantity(
        "M", "N*m", ("crank_angle",), N_("Torque that must be applied to the shaft, by the reactions"), _THEORY
    )
    reduced_inertia: Array = quantity(
        "J", "kg*m^2", ("crank_angle",), N_("Inertia of all moving parts reduced to the crank"), _THEORY
    )
    reduced_inertia_slope: Array = quantity(
        "J′", "kg*m^2/rad", ("crank_angle",), N_("Derivative of the reduced inertia by the crank angle"), _THEORY
    )
    checks: tuple[Check, ...] = ()


def mechanism_torques(loaded: LoadedMachine, solved: SolvedCycle) -> MechanismTorques:
    """Torques by virtual work and by reactions, which share little, and the reduced inertia."""
    by_reactions = driving_torques(loaded, solved.groups)
    shape = by_reactions.shape
    by_work = np.empty(shape)
    inertia, slope = np.zeros((2, shape[0], shape[-1]))
    for place, (group, one) in enumerate(zip(loaded.mechanisms.groups, solved.groups, strict=True)):
        dynamics, size, made = group.kind.dynamics, group.members.geometry, loaded.masses.groups[place]
        # What slaves hand over is their own work, which counts once: the mechanism's own loads.
        equation = dynamics.reduced(one.motion, size, made.bodies, one.loads, made.gravity)
        by_work[:, group.index] = torque_by_work(equation, one.conditions.drive) - one.forces.friction_torque
        inertia = inertia + np.sum(equation.inertia.value, axis=1)
        slope = slope + np.sum(equation.inertia.first, axis=1)
    driving = np.sum(by_reactions, axis=1)
    # Where forces stand across the way of their pins there is no torque, but rounding of forces times arms.
    scale = np.max(np.sum(np.abs(by_work), axis=1), axis=-1) + np.sum(forces_times_arms(loaded, solved.groups), axis=1)
    residual = np.max(np.abs(driving - np.sum(by_work, axis=1)), axis=-1) / np.where(scale > 0, scale, 1.0)
    return MechanismTorques(
        mechanism_torque=-by_work,
        driving_torque=driving,
        reduced_inertia=inertia,
        reduced_inertia_slope=slope,
        checks=(
            Check(
                "torque",
                _("Torque by the reactions of all joints against that by virtual work, relative to forces times arms"),
                residual,
                _TORQUES_LIMIT,
            ),
        ),
    )
