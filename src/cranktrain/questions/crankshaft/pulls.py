"""Pulls on a crankshaft, constant or over the crank angle: of a belt, a generator, a wheel on its rail, a weight."""

from collections.abc import Iterator, Mapping, Sequence
from typing import ClassVar, NamedTuple

import numpy as np
from pydantic import Field

from cranktrain.columns import in_columns
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.language import N_, _
from cranktrain.layout.design import Designs
from cranktrain.layout.load_card import LoadCard, load_card
from cranktrain.layout.load_designs import as_long, unread_problems
from cranktrain.layout.load_laws import ByAngle, BySpeed, LoadState
from cranktrain.layout.load_tables import count_problems, order_problems, with_lists
from cranktrain.listed import OF_FILE, FileColumns, FileText, OneOrMany
from cranktrain.motion import ONE, ZERO, Array
from cranktrain.quantities import Angle, Force, Length
from cranktrain.spec import Spec

_LISTS = ("force", "crank_angles")


class PullSpec(Spec, frozen=True):
    """A force on the shaft, constant or over the crank angle: the pull of a belt, the weight of a flywheel."""

    of_file: ClassVar = OF_FILE

    z: Length = Field(description=N_("Where it acts, from throw 1 toward the flywheel."))
    force: OneOrMany[Force] | None = Field(
        default=None,
        description=N_("Its size, or a list of sizes over crank_angles, less than 0 where it pushes; or give a file."),
    )
    crank_angles: tuple[Angle, ...] | None = Field(
        default=None, min_length=2, description=N_("Crank angles as they are shown, at which it has the sizes listed.")
    )
    file: str | None = Field(
        default=None,
        min_length=1,
        description=N_("File with its sizes over the crank angle, relative to the machine file; units stand in heads."),
    )
    text: FileText = None
    columns: FileColumns = Field(
        default=None,
        min_length=2,
        max_length=2,
        description=N_("Columns of crank angle and force in the file, counted from 1; needed where there are more."),
    )
    direction: Angle = Field(
        description=N_("Where it pulls to, from straight up in the normal sense of rotation; a weight: 180 deg.")
    )

    @property
    def listed(self) -> "PullSpec":
        """The pull itself, or one with the lists that its file holds."""
        card = self._card
        return self if card is None else with_lists(self, {"force": card.out, "crank_angles": card.places})

    @property
    def _card(self) -> LoadCard | None:
        """What its file says; None where it has none, or nobody has read it."""
        return None if self.file is None or self.text is None else load_card(self.file, self.text, self.columns)

    def _problems(self) -> Iterator[Problem]:
        """Find a pull of no size, one that is no pull, and lists that do not go together."""
        if self.file is not None:
            yield from self._file_problems()
            return
        if self.text is not None or self.columns is not None:
            yield Problem("file", None, _("is missing; text and columns are of a file"))
        if self.force is None:
            yield Problem("force", None, _("is missing; give force, or a file"))
            return
        yield from count_problems({"force": self.force}, len(self.crank_angles or (0,)))
        if self.crank_angles is not None:
            yield from order_problems("crank_angles", self.crank_angles)
        elif len(self.force) == 1 and self.force[0].si <= 0:
            yield Problem("force", self.force[0].text, _("must be more than 0; its direction says where it pulls to"))

    def _file_problems(self) -> Iterator[Problem]:
        """Find what stands beside a file, and what is wrong in it."""
        beside = _("must not stand beside file, which says how large the pull is")
        yield from (Problem(name, None, beside) for name in _LISTS if getattr(self, name) is not None)
        try:
            card = self._card
        except InputError as error:
            yield from error.problems
            return
        if card is not None and (card.sort, card.over) != ("force", "crank_angles"):
            yield Problem("file", self.file, _("must hold forces over the crank angle"))


class Pulls(NamedTuple):
    """Forces on one shaft, each in a direction of its own.

    Attributes
    ----------
    z : Array, shape (design, pull)
        [m]
    toward : Array, shape (design, pull, 2)
        Direction toward X and Y.
    sizes : tuple of BySpeed or ByAngle, one for each pull
        Constant, or over the crank angle as it is shown. [N]
    names : tuple of str
    """

    z: Array
    toward: Array
    sizes: tuple[BySpeed | ByAngle, ...]
    names: tuple[str, ...]

    def force(self, shown: Array) -> Array:
        """Forces at crank angles as they are shown, shape (design, 1, n): (design, pull, 2, n). [N]"""
        if not self.sizes:
            return np.zeros((*self.toward.shape, shown.shape[-1]))
        state = LoadState(*np.broadcast_arrays(shown, ZERO, ONE))
        sizes = [np.broadcast_to(law.value(state), shown.shape) for law in self.sizes]
        return self.toward[..., np.newaxis] * np.stack(sizes, axis=1)

    @property
    def over_angle(self) -> tuple[ByAngle, ...]:
        """Those that have kinks at crank angles."""
        return tuple(law for law in self.sizes if isinstance(law, ByAngle))


def pulls_of(designs: Designs, each: Sequence[Mapping[str, PullSpec]], path: str) -> Pulls:
    """Put the pulls on one shaft, as each design has them, into arrays.

    Parameters
    ----------
    designs : Designs
    each : sequence of mapping of str to PullSpec
        By name, one for each design.
    path : str
        Of their tables, for messages.

    Returns
    -------
    Pulls

    Raises
    ------
    InputError
        Where nobody has read a file.

    Notes
    -----
    Directions count from Y in the normal sense of rotation. docs/theory/crankshaft, section Gears and pulls.
    """
    sense = 1.0 if designs.together.orientation.is_clockwise else -1.0
    pulls: list[PullSpec] = []
    for name in each[0]:
        own = [table[name].listed for table in each]
        for one in own:
            refuse(unread_problems(one.file, one.text, path=f"{path}.{name}"))
        pulls.append(in_columns(as_long(own, _LISTS)))
    direction = designs.by_design([pull.direction.array for pull in pulls])
    return Pulls(
        designs.by_design([pull.z.array for pull in pulls]),
        np.stack([np.sin(sense * direction), np.cos(direction)], axis=-1),
        tuple(_size(designs, pull) for pull in pulls),
        tuple(each[0]),
    )


def _size(designs: Designs, pull: PullSpec) -> BySpeed | ByAngle:
    """How large a pull is."""
    size = designs.by_design([force.array for force in pull.force or ()])
    if pull.crank_angles is not None:
        return ByAngle(designs.by_design([angle.array for angle in pull.crank_angles]), size)
    return BySpeed(size[..., np.newaxis], *(designs.by_design([one])[..., np.newaxis] for one in (ONE, ZERO)))
