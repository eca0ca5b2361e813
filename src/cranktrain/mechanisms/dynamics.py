"""What forces a kind of mechanism gives: its joints, what slides in it, its groups and kernels."""

from collections.abc import Callable, Iterable, Mapping
from functools import cached_property
from typing import Any, Generic, Literal, NamedTuple, TypeAlias, TypeVar

from cranktrain.linkage.forces import Body, Conditions, Gravity, Reduced, Wrench, reduced_of
from cranktrain.motion import Array, Link
from cranktrain.record import record

_Motion = TypeVar("_Motion", bound=tuple[object, ...])
_Geometry = TypeVar("_Geometry", bound=tuple[object, ...])
_Each = TypeVar("_Each")

Role = Literal["main_bearing", "crank_pin", "knuckle_pin", "piston_pin", "guide", "slot", "pivot", "pin"]
"""What a joint is to its mechanism, whatever it is called.

The bearing of the crank; what has its bearing on the crank pin; a slave's rod on its master's; the rod in the piston,
crosshead or slider; a slider in its guide; a block in a slot; a link's bearing in the frame; any other pin. A chain has
neither crank pin nor piston pin: of its several each is as good.
"""


class Forces(NamedTuple):
    """Wrenches in the joints, the torque that must be applied to the crank, and that of friction on it. [N·m]

    joints: in the order of the kind's `reactions`, which name them. driving_torque is what their reactions leave to the
    shaft. friction_torque is what the forces of friction do along the crank angle: all of the reactions that the torque
    by virtual work needs.
    """

    joints: tuple[Wrench, ...]
    driving_torque: Array
    friction_torque: Array


class Reaction(NamedTuple):
    """A joint's reaction: its name, the two bodies, of which the wrench is `by` one `on` the other, and its role."""

    name: str
    on: str
    by: str
    role: Role


class Contact(NamedTuple):
    """Where something slides: the joint that bears its friction, and the drawing's pin at which that acts.

    bears_moment: whether it is a guide, and not a slot about a block; way: −1 where what slides counts its position
    against its link's direction.
    """

    joint: str
    pin: str
    bears_moment: bool = True
    way: float = 1.0


class Across(NamedTuple):
    """An outer joint of a group whose force has a part that moments give: its part across a link.

    joint; link, along and across whose direction the force is split; the pin about which the moments are taken.
    """

    joint: str
    link: str
    about: str


class Group(NamedTuple):
    """An Assur group: its sort by its joints, such as `RRP`; its links; what of its outer reactions moments give."""

    sort: str
    links: tuple[str, ...]
    across: tuple[Across, ...] = ()


FRAME = "frame"
"""What stands still, as one of a joint's two bodies."""


@record
class Dynamics(Generic[_Motion, _Geometry]):
    """What forces a kind of mechanism gives; every function is a kernel.

    Attributes
    ----------
    moving : tuple of str
        What has mass and bears loads, in the order in which links, bodies and loads stand.
    reactions : tuple of Reaction
        In the order in which `forces` gives them.
    sliding : tuple of str
        What may have friction, in the order in which `Conditions` has it. The sense of each is the sign of its
        coordinate's velocity.
    contacts : tuple of Contact
        Where it slides, in that order.
    groups : tuple of Group
        What hangs on the crank, each after those that carry it.
    links : kernel (motion, geometry) → tuple of Link
        In the mechanism's axes.
    load : kernel (motion, geometry, value) → tuple of Wrench
        Load on each link, about its first pin, for a force along the output slider's coordinate, or a torque on the
        output link; with its counterpart on whichever has to bear it. [N or N·m]
    forces : kernel (motion, geometry, bodies, loads, conditions) → Forces
        `Forces` has the joints' wrenches, as `reactions` has them, the driving torque by them, and that of friction.
    on_master : kernel (motion, geometry, wrench) → Wrench, optional
        Of a mechanism that hangs on another's rod: what it does to that rod, from the reaction in its knuckle pin.
    """

    moving: tuple[str, ...]
    reactions: tuple[Reaction, ...]
    sliding: tuple[str, ...]
    contacts: tuple[Contact, ...]
    groups: tuple[Group, ...]
    links: Callable[[_Motion, _Geometry], tuple[Link, ...]]
    load: Callable[[_Motion, _Geometry, Array], tuple[Wrench, ...]]
    forces: Callable[[_Motion, _Geometry, tuple[Body, ...], tuple[Wrench, ...], Conditions], Forces]
    on_master: Callable[[_Motion, _Geometry, Wrench], Wrench] | None = None

    @property
    def straight(self) -> tuple[str, ...]:
        """What slides in a guide of the frame, and so does not turn: it has neither a centroid aside nor an inertia."""
        guided = {one.name for one in self.reactions if FRAME in (one.on, one.by)}
        return tuple(name for name, contact in zip(self.sliding, self.contacts, strict=True) if contact.joint in guided)

    def reduced(
        self,
        motion: _Motion,
        geometry: _Geometry,
        bodies: tuple[Body, ...],
        loads: tuple[Wrench, ...],
        gravity: Gravity,
    ) -> Reduced:
        """What an equation of motion needs: reduced inertia, its derivative, and the loads' torque on the crank."""
        return reduced_of(self.links(motion, geometry), bodies, loads, gravity)

    def by_link(self, each: Iterable[_Each]) -> dict[str, _Each]:
        """What each of `moving` has, by its name: its link, its body, or the load that it bears."""
        return dict(zip(self.moving, each, strict=True))

    def by_joint(self, joints: Iterable[Wrench]) -> dict[str, Wrench]:
        """What passes through each of `reactions`, by its name."""
        return dict(zip((reaction.name for reaction in self.reactions), joints, strict=True))

    def joint(self, role: Role, *, is_own: bool = True) -> int | None:
        """Place among `reactions` of the first of the mechanism's own joints that has a role; None without one.

        Unless `is_own`, of a slave's shares of its master's joints.
        """
        return self._joints.get((role, is_own))

    @cached_property
    def _joints(self) -> Mapping[tuple[Role, bool], int]:
        """Place of the first joint with each role, by the role and whether it is the mechanism's own."""
        places = reversed(list(enumerate(self.reactions)))
        return {(reaction.role, reaction.on in self.moving): place for place, reaction in places}


AnyDynamics: TypeAlias = Dynamics[Any, Any]
"""Forces of a kind that is known only when it runs."""
