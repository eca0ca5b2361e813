"""What forces a kind of mechanism gives: its joints, what slides in it, its groups and kernels."""

from collections.abc import Callable
from typing import Any, Generic, Literal, NamedTuple, TypeAlias, TypeVar

from cranktrain.linkage.forces import Body, Conditions, Gravity, Reduced, Wrench, reduced_of
from cranktrain.mechanisms.solved import Forces
from cranktrain.motion import Array, Link
from cranktrain.record import record

_Motion = TypeVar("_Motion", bound=tuple[object, ...])
_Geometry = TypeVar("_Geometry", bound=tuple[object, ...])
_Bodies = TypeVar("_Bodies", bound=tuple[Body, ...])
_Loads = TypeVar("_Loads", bound=tuple[Wrench, ...])

Role = Literal["main_bearing", "crank_pin", "knuckle_pin", "piston_pin", "guide", "slot", "pivot", "pin"]
"""What a joint is to its mechanism, whatever it is called.

The bearing of the crank; what has its bearing on the crank pin; a slave's rod on its master's; the rod in the piston,
crosshead or slider; a slider in its guide; a block in a slot; a link's bearing in the frame; any other pin. A chain has
neither crank pin nor piston pin: of its several each is as good.
"""


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
class Dynamics(Generic[_Motion, _Geometry, _Bodies, _Loads]):
    """What forces a kind of mechanism gives; every function is a kernel.

    Attributes
    ----------
    bodies : callable (*Body) → what `forces` takes as bodies
    moving : tuple of str
        What has mass and bears loads, in the order in which `forces` takes bodies and loads.
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
        In the order of `moving`, in the mechanism's axes.
    load : kernel (motion, geometry, value) → wrenches
        Load on each of `moving` for a force along the output slider's coordinate, or a torque on the output link, or
        of whichever else has to bear its counterpart. [N or N·m]
    forces : kernel (motion, geometry, bodies, loads, conditions) → Forces
        bodies and loads as `moving` has them; `Forces` has the joints' wrenches, as `reactions` has them, the driving
        torque by them, and that of friction.
    on_master : kernel (motion, geometry, wrench) → Wrench, optional
        Of a mechanism that hangs on another's rod: what it does to that rod, from the reaction in its knuckle pin.
    """

    bodies: Callable[..., _Bodies]
    moving: tuple[str, ...]
    reactions: tuple[Reaction, ...]
    sliding: tuple[str, ...]
    contacts: tuple[Contact, ...]
    groups: tuple[Group, ...]
    links: Callable[[_Motion, _Geometry], tuple[Link, ...]]
    load: Callable[[_Motion, _Geometry, Array], _Loads]
    forces: Callable[[_Motion, _Geometry, _Bodies, _Loads, Conditions], Forces[tuple[Wrench, ...]]]
    on_master: Callable[[_Motion, _Geometry, Wrench], Wrench] | None = None

    def reduced(
        self, motion: _Motion, geometry: _Geometry, bodies: _Bodies, loads: _Loads, gravity: Gravity
    ) -> Reduced:
        """What an equation of motion needs: reduced inertia, its derivative, and the loads' torque on the crank."""
        return reduced_of(self.links(motion, geometry), bodies, loads, gravity)

    def joint(self, role: Role) -> int | None:
        """Place among `reactions` of the first of the mechanism's own joints that has a role; None without one."""
        return self._place(role, is_own=True)

    def share_of_masters(self, role: Role) -> int | None:
        """Place among `reactions` of a slave's share of that joint of its master's; None without one."""
        return self._place(role, is_own=False)

    def _place(self, role: Role, *, is_own: bool) -> int | None:
        places = (
            place
            for place, reaction in enumerate(self.reactions)
            if reaction.role == role and (reaction.on in self.moving) is is_own
        )
        return next(places, None)


AnyDynamics: TypeAlias = Dynamics[Any, Any, Any, Any]
"""Forces of a kind that is known only when it runs."""
