"""A machine with all that acts on it: forces in every joint at any crank angle."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property, reduce
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cranktrain.language import Words, _
from cranktrain.layout.load_laws import ByTravel, LoadState
from cranktrain.layout.loads import LinkLoad, Loads, of_member
from cranktrain.layout.masses import Masses
from cranktrain.layout.mechanisms import Batch, Mechanisms, own_values
from cranktrain.layout.part_tables import Edges
from cranktrain.layout.speed import Speed
from cranktrain.linkage.forces import Conditions, Drive, Friction, Wrench, added
from cranktrain.linkage.forces.load import LoadWay
from cranktrain.mechanisms.dynamics import Forces
from cranktrain.mechanisms.kind import AnyMotion
from cranktrain.motion import ZERO, Array, Coefficient, Link
from cranktrain.numerics import extremes, in_windows
from cranktrain.numerics.nested import put
from cranktrain.questions.forces.carriers import Carriers
from cranktrain.questions.gas.chambers import GasInChambers
from cranktrain.record import record


class SolvedBatch(NamedTuple):
    """Forces of the mechanisms of one kind, arrays of shape (design, member, n).

    motion; loads, those of the mechanism alone, and of these what the gas presses; conditions; and `Forces`, whose
    joints bear what slaves hand over as well.
    """

    motion: AnyMotion
    loads: tuple[Wrench, ...]
    pressed: tuple[Wrench, ...]
    conditions: Conditions
    forces: Forces


@record
class LoadedMachine:
    """A machine with all that acts on it, to be solved at any crank angle.

    Attributes
    ----------
    mechanisms : Mechanisms
    carriers : Carriers
    masses : Masses
    gas : GasInChambers or None
    loads : Loads or None
    speed : Speed

    Notes
    -----
    docs/theory/forces, eqs. (13.1) to (13.3).
    """

    mechanisms: Mechanisms
    carriers: Carriers
    masses: Masses
    gas: GasInChambers | None
    loads: Loads | None
    speed: Speed

    @property
    def jumps(self) -> bool:
        """Whether something makes its torque jump, or gives it kinks, besides the gas."""
        return self.masses.has_friction or self.loads is not None

    def without_mass(self) -> Words | None:
        """Say what has no mass, and what alone acts then; None where all has."""
        return self.masses.without_mass(has_gas=self.gas is not None, has_loads=self.loads is not None)

    def in_order(self, by_batch: Iterable[NDArray[Any]]) -> NDArray[Any]:
        """Values of every batch, broadcastable to (design, member, ...), in the machine's order of mechanisms."""
        values = list(by_batch)
        shape = (max(map(len, values)), len(self.mechanisms.names), *values[0].shape[2:])
        found = np.empty(shape, values[0].dtype)
        for batch, own in zip(self.mechanisms.batches, values, strict=True):
            found[:, batch.index] = own
        return found

    def motions(self, angle: Array) -> tuple[AnyMotion, ...]:
        """Motion of every mechanism at crank angles φ [rad], in the order of `mechanisms.batches`."""
        return self.mechanisms.motions(angle)

    def solved(
        self,
        angle: Array,
        *,
        gas_force: Array | None = None,
        motions: Sequence[AnyMotion] | None = None,
    ) -> tuple[SolvedBatch, ...]:
        """Solve every mechanism.

        Parameters
        ----------
        angle : Array, shape (n,), (design, 1, n) or (design, mechanism, n)
            φ, the same for all mechanisms or one for each; those that hang on one rod or share a chamber have the same.
            [rad]
        gas_force : Array, shape (design, piston, n), optional
            Of the gas on the pistons toward their shafts, where it is known already. [N]
        motions : sequence, optional
            Of `motions` at the same angles, where the caller has them.

        Returns
        -------
        tuple of SolvedBatch
            In the order of `mechanisms.batches`. Where links lie in line and come through, forces are limits.
        """
        found = self._solved(angle, gas_force, motions)
        if not self.comes_through:
            return found
        from cranktrain.questions.forces.in_line import by_limits  # few machines need it

        limited = by_limits(
            self.mechanisms,
            angle,
            [one.forces for one in found],
            lambda aside: [one.forces for one in self._solved(aside, None, None)],
        )
        return tuple(one._replace(forces=forces) for one, forces in zip(found, limited, strict=True))

    def _solved(
        self, angle: Array, gas_force: Array | None, motions: Sequence[AnyMotion] | None
    ) -> tuple[SolvedBatch, ...]:
        """Solve every mechanism; parameters and returns as of `solved`."""
        moving = self.motions(angle) if motions is None else motions
        toward = self._gas_force(angle, moving) if gas_force is None else gas_force
        drives = self.speed.drive(angle)
        on_rods: dict[int, Wrench] = {}
        found: dict[int, SolvedBatch] = {}
        batches = list(enumerate(self.mechanisms.batches))
        # Slaves first: what they do to their masters' rods is a load there.
        for place, batch in sorted(batches, key=lambda one: one[1].kind.dynamics.on_master is None):
            dynamics, size = batch.kind.dynamics, batch.members.geometry
            motion = moving[place]
            made = self.masses.batches[place]
            drive = Drive(*(own_values(part, batch.index) for part in drives))
            pressed = dynamics.load(motion, size, self._pressing(batch.index, toward))
            loads = borne = self._with_loads(pressed, batch, motion, own_values(angle, batch.index), drive.speed)
            handed = _of_slaves(batch.index, on_rods) if batch.kind.is_direct else None
            if handed is not None:
                on_crank, on_rod, on_piston = loads
                borne = (on_crank, added(on_rod, handed), on_piston)
            friction = tuple(
                _friction(batch.kind.named(motion, name), coefficient, edges)
                for name, coefficient, edges in zip(dynamics.sliding, made.friction, made.edges, strict=True)
            )
            conditions = Conditions(drive, made.gravity, friction)
            forces = dynamics.forces(motion, size, made.bodies, borne, conditions)
            found[place] = SolvedBatch(motion, loads, pressed, conditions, forces)
            if dynamics.on_master is not None and (knuckle := dynamics.joint("knuckle_pin")) is not None:
                wrench = dynamics.on_master(motion, size, forces.joints[knuckle])
                for member, mechanism in enumerate(batch.index.tolist()):
                    master = int(self.carriers.master[mechanism])
                    own = Wrench(*(part[:, member : member + 1] for part in wrench))
                    on_rods[master] = Wrench(*map(np.add, on_rods[master], own)) if master in on_rods else own
        return tuple(found[place] for place, _batch in batches)

    @cached_property
    def comes_through(self) -> bool:
        """Whether links of any mechanism lie in line at some angles and come through."""
        return any(batch.kind.change_points is not None for batch in self.mechanisms.batches)

    @cached_property
    def unheld(self) -> NDArray[np.bool_]:
        """Whether a moment is left where the links of each mechanism lie in line, which no force of theirs can hold.

        Shape (design, mechanism). Forces go beyond all bounds there.
        """
        if not self.comes_through:
            return np.zeros(self.mechanisms.nominal_top.shape[:2], dtype=np.bool_)
        from cranktrain.questions.forces.in_line import change_points  # few machines need it

        points = change_points(self.mechanisms)
        at_points = self.solved(np.where(np.isnan(points), points[..., :1], points))
        return self.in_order(
            np.any(np.isnan(reduce(np.add, (part for joint in one.forces.joints for part in joint[:2]))), axis=-1)
            for one in at_points
        )

    def judged(self, residual: Array) -> tuple[Array, tuple[Words, ...]]:
        """Leave open what forces that go beyond all bounds would judge by their rounding, and say why, by design.

        residual: of an identity of forces, shape (design,); infinite in what is given back where it is left open.
        """
        is_open = np.any(self.unheld, axis=1)
        reasons = tuple(_("forces go beyond all bounds at change points") for _one in is_open) if is_open.any() else ()
        return np.where(is_open, np.inf, residual), reasons

    @cached_property
    def sharing(self) -> NDArray[np.intp]:
        """One number for all mechanisms that hang on one rod or share a chamber, shape (mechanism,)."""
        label: list[int] = list(range(len(self.mechanisms.names)))
        pairs = [(slave, master) for slave, master in enumerate(self.carriers.master.tolist()) if master >= 0]
        if self.gas is not None:
            works = np.any(self.gas.chambers.areas != 0.0, axis=0)
            for is_own in works.T:
                own = self.carriers.driven[is_own].tolist()
                pairs += [(own[0], other) for other in own[1:]]
        for one, other in pairs:
            label = [label[other] if each == label[one] else each for each in label]
        return np.array(label, dtype=np.intp)

    def of_each(
        self,
        rows: NDArray[np.intp],
        which: NDArray[np.intp],
        angle: Array,
        curves: Callable[[Array], Array],
    ) -> Array:
        """Values of some curves of the machine, each at angles of its own.

        Parameters
        ----------
        rows : array of int, shape (curve,)
            Of which mechanism each curve is; −1 of all.
        which : array of int, shape (p,)
            Which curves are asked for, counted design by design.
        angle : Array, shape (p, k)
            φ. [rad]
        curves : callable
            All of them, shape (design, curve, n), at φ of each mechanism, (design, mechanism, n).

        Returns
        -------
        Array, shape (p, k)

        Notes
        -----
        Mechanisms that have nothing to do with each other are asked at different angles at once.
        """
        n_designs, n_mechanisms = len(self.speed.value), self.sharing.size
        design, row = np.divmod(which, rows.size)
        whole = rows[row] < 0
        asked, slot = in_windows(
            np.where(whole, design, n_designs + design * n_mechanisms + self.sharing[rows[row]]),
            angle,
            n_designs * (1 + n_mechanisms),
        )
        # What is asked of all stands before what each is asked.
        n_whole = int(np.max(slot[whole], initial=-1)) + 1
        n_own = int(np.max(slot[~whole], initial=-1)) + 1
        n_angles = angle.shape[-1]
        laid = np.empty((n_designs, n_mechanisms, n_whole + n_own, n_angles))
        laid[:, :, :n_whole] = asked[:n_designs, np.newaxis, :n_whole]
        laid[:, :, n_whole:] = asked[n_designs:, :n_own].reshape(n_designs, n_mechanisms, -1, n_angles)[:, self.sharing]
        found = curves(laid.reshape(n_designs, n_mechanisms, -1))
        place = np.where(whole, slot, n_whole + slot)
        return found.reshape(n_designs, rows.size, -1, n_angles)[design, row, place]

    def _gas_force(self, angle: Array, motions: Sequence[AnyMotion]) -> Array | None:
        """Force of the gas on every piston toward its shaft, shape (design, piston, n); None without gas."""
        if self.gas is None:
            return None
        driven = self.carriers.driven
        slider = np.empty((3, len(self.speed.value), len(driven), angle.shape[-1]))
        for batch, motion in zip(self.mechanisms.batches, motions, strict=True):
            piston = self.carriers.piston[batch.index]
            if piston[0] >= 0:
                put(slider, piston, motion.slider)
        by_chamber = own_values(angle, driven[self.gas.chambers.leading])
        return self.gas.force(self.gas.pressure(by_chamber, self.gas.volume_by(Coefficient(*slider))))

    def load_way(self, load: LinkLoad, angle: Array) -> LoadWay:
        """Along what a load goes, at φ [rad], shape (n,) or (design, 1, n); arrays of shape (design, 1, n)."""
        return load.way(self.loaded_link(load, angle))

    def load_ways(self, loads: Sequence[LinkLoad], angle: Array) -> list[LoadWay]:
        """Along what some loads go; as `load_way`, with the motion of each mechanism found once."""
        return [load.way(link) for load, link in zip(loads, self.loaded_links(loads, angle), strict=True)]

    def loaded_link(self, load: LinkLoad, angle: Array) -> Link:
        """On what a load acts, in its mechanism's axes; angle and arrays as of `load_way`."""
        return next(self.loaded_links([load], angle))

    def loaded_links(self, loads: Sequence[LinkLoad], angle: Array) -> Iterator[Link]:
        """On what each of some loads acts; as `loaded_link`, with the motion of each mechanism found once."""
        moving: dict[int, tuple[Link, ...]] = {}
        for load in loads:
            place = next(i for i, batch in enumerate(self.mechanisms.batches) if load.mechanism in batch.index)
            batch = self.mechanisms.batches[place]
            if place not in moving:
                motion = batch.kind.motion(angle + batch.members.phase, batch.members.geometry)
                moving[place] = batch.kind.dynamics.links(motion, batch.members.geometry)
            yield of_member(moving[place][load.link], int(np.flatnonzero(batch.index == load.mechanism)[0]))

    @cached_property
    def travel_starts(self) -> dict[str, Array]:
        """Where the travel of each load begins by which its size goes, shape (design, 1, 1). [m or rad]"""
        return {} if self.loads is None else self.mechanisms.once("travel_starts", self.loads, self._travel_starts)

    def _travel_starts(self) -> dict[str, Array]:
        """Find them."""
        return {
            load.name: extremes(
                lambda phi, load=load: load.counts * self.load_way(load, phi).place,
                lambda phi, load=load: load.counts * self.load_way(load, phi).rate,
            ).smallest.value
            for load in (() if self.loads is None else self.loads.each)
            if isinstance(load.law, ByTravel)
        }

    def load_value(self, load: LinkLoad, way: LoadWay, angle: Array, speed: Array) -> Array:
        """Size of a load along its way, at φ and the speed of the crank [rad, rad/s], shape (design, 1, n)."""
        assert self.loads is not None
        travel = load.counts * way.place - self.travel_starts.get(load.name, ZERO)
        parts = np.broadcast_arrays(angle - self.loads.zero, travel, load.counts * way.rate * speed)
        return load.value(LoadState(*parts))

    def _with_loads(
        self, pressed: tuple[Wrench, ...], batch: Batch, motion: AnyMotion, angle: Array, speed: Array
    ) -> tuple[Wrench, ...]:
        """What the file's loads do to the links of one kind, with what the gas does."""
        if self.loads is None:
            return pressed
        found = list(pressed)
        links = batch.kind.dynamics.links(motion, batch.members.geometry)
        for member, mechanism in enumerate(batch.index.tolist()):
            for load in self.loads.of(mechanism):
                way = load.way(of_member(links[load.link], member))
                value = self.load_value(load, way, _of_member(angle, member), _of_member(speed, member))
                wrench = Wrench(*(_at_member(value * part, member, len(batch.index)) for part in way.unit))
                found[load.link] = added(found[load.link], wrench)
        return tuple(found)

    def _pressing(self, index: NDArray[np.intp], toward: Array | None) -> Array:
        """Force along the output of each of some mechanisms, away from the shaft, shape (design, member, n)."""
        piston = self.carriers.piston[index]
        return np.zeros((1, 1, 1)) if toward is None or piston[0] < 0 else -toward[:, piston]


def _of_member(values: Array, member: int) -> Array:
    """What one member has of values for all or for each."""
    return values[:, member : member + 1] if values.ndim == 3 and values.shape[1] > 1 else values


def _at_member(values: Array, member: int, n_members: int) -> Array:
    """Values of one member, shape (design, 1, n), among others that have none."""
    found = np.zeros((values.shape[0], n_members, values.shape[2]))
    found[:, member : member + 1] = values
    return found


def _friction(slider: Coefficient, coefficient: Array, edges: Edges) -> Friction:
    """Friction of what slides, and where its guide's middle lies from it: edges that stay are left behind."""
    return Friction(
        coefficient,
        np.sign(slider.first),
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
