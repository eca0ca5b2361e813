"""What the source of a cycle is written for: kinds, fluids, and what is asked, with the kernels of all these."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple, cast

from cranktrain.fluids import AnyFluid
from cranktrain.linkage.forces import reduced_of
from cranktrain.mechanisms.kind import AnyKind
from cranktrain.questions.forces.piston_formulas import inertia_force, rod_forces
from cranktrain.questions.forces.rod_masses import weighed_ends


class Shape(NamedTuple):
    """How numbers are put into nested tuples: the class of each, and of what its fields are made; None of a number."""

    made: type[tuple[object, ...]]
    fields: "tuple[Shape | None, ...]"


OF_EVENNESS = frozenset({"work", "flywheel", "given", "running"})
"""What is asked of how evenly a machine runs."""
_OF_SHAFT = OF_EVENNESS | {"torque"}


def shape_of(parts: tuple[object, ...]) -> Shape:
    """Shape of nested tuples of arrays or numbers."""
    fields = (shape_of(cast("tuple[object, ...]", part)) if isinstance(part, tuple) else None for part in parts)
    return Shape(type(parts), tuple(fields))


@dataclass(frozen=True)
class KindSource:
    """What of one kind of mechanism stands in the source.

    Attributes
    ----------
    kind : Kind
    geometry : Shape
    n_links : int
        Links that have bodies.
    has_slaves : bool
        Whether others hang on its rods.
    has_pistons : bool
        Whether its sliders are pistons.
    """

    kind: AnyKind
    geometry: Shape
    n_links: int
    has_slaves: bool
    has_pistons: bool

    @property
    def is_slave(self) -> bool:
        """Whether it hangs on the rods of others."""
        return self.kind.dynamics.on_master is not None

    @property
    def has_rods(self) -> bool:
        """Whether forces of its pistons and their rods are told."""
        return self.has_pistons and self.kind.has_rod

    @property
    def joints(self) -> tuple[int, ...]:
        """Which of its reactions are of its own joints, and no shares of its master's."""
        dynamics = self.kind.dynamics
        return tuple(place for place, reaction in enumerate(dynamics.reactions) if reaction.on in dynamics.moving)


@dataclass(frozen=True)
class CycleStructure:
    """What stands in the source: kinds, fluids, and what is asked of the loop.

    Attributes
    ----------
    kinds : tuple of KindSource
    fluids : tuple of (Fluid, Shape)
    asks : frozenset of str
        Of `torque`, `pressure`, `joint`, `rod`, `work`, `flywheel`, what fluctuation that is `given` by it, `running`;
        and `points`, which are to be kept.
    has_several : bool
        Whether there is more than one mechanism, so that a cycle may repeat itself.
    """

    kinds: tuple[KindSource, ...]
    fluids: tuple[tuple[AnyFluid, Shape], ...]
    asks: frozenset[str]
    has_several: bool

    @property
    def needs_inertia(self) -> bool:
        """Whether it is asked how evenly the machine runs."""
        return bool(self.asks & OF_EVENNESS)

    @property
    def needs_forces(self) -> bool:
        """Whether forces in the mechanisms are asked."""
        return not self.asks.isdisjoint({"joint", "rod"})

    @property
    def goes_by_work(self) -> bool:
        """Whether work of loads and inertia is found: the torque by it, where no forces are that give it too."""
        return self.needs_inertia or not self.needs_forces

    @property
    def may_repeat(self) -> bool:
        """Whether a part of the cycle may say all that is asked: of the shaft alone, and of no cylinder or joint."""
        return self.has_several and self.asks <= _OF_SHAFT


def kernels(structure: CycleStructure) -> dict[str, Callable[..., Any]]:
    """Kernels by the names that they have in the source."""
    found: dict[str, Callable[..., Any]] = {}
    for place, one in enumerate(structure.kinds):
        dynamics = one.kind.dynamics
        found |= {
            f"motion_{place}": one.kind.motion,
            f"load_{place}": dynamics.load,
        }
        if structure.goes_by_work:
            found[f"links_{place}"] = dynamics.links
        if structure.needs_forces:
            found[f"forces_{place}"] = dynamics.forces
            if dynamics.on_master is not None:
                found[f"on_master_{place}"] = dynamics.on_master
    if structure.goes_by_work:
        found["reduced"] = reduced_of
    if "rod" in structure.asks:
        found |= {"shares_of": weighed_ends, "along_rod": rod_forces, "inertia_of": inertia_force}
    for place, (fluid, _shape) in enumerate(structure.fluids):
        found[f"pressure_{place}"] = fluid.pressure
    return found
