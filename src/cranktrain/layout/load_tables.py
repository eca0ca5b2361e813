"""Loads: what a machine works against, or what drives it besides the gas; their tables of the machine file."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Annotated, ClassVar, Literal, Protocol, TypeAlias, cast

from pydantic import BaseModel, Field

from cranktrain.errors import InputError, Problem
from cranktrain.language import N_, _
from cranktrain.layout.load_card import LoadCard, load_card
from cranktrain.layout.load_heads import Sort
from cranktrain.layout.load_laws import is_over_two_turns
from cranktrain.listed import OF_FILE, FileColumns, FileText, OneOrMany
from cranktrain.numerics.harmonics import TURN
from cranktrain.paths import PathParts, item_at, replaced
from cranktrain.quantities import (
    Angle,
    Dimension,
    Force,
    Given,
    Length,
    NonNegativeLength,
    PositiveSpeed,
    PositiveVelocity,
    Quantity,
    TurnedAngle,
)
from cranktrain.spec import Spec, SpecType

Torque = Annotated[Given, Quantity(Dimension.TORQUE)]
Exponent = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, at_most=10.0, example="2")]
Factor = Annotated[Given, Quantity(Dimension.RATIO, at_least=0.0, example="1.1")]

_MOST = 2 * TURN * (1 + 1e-9)
"""How far crank angles may reach. [rad]"""
AT_POINT = ("along", "across")
"""Keys of where on a link a force acts."""
_OVER = ("crank_angles", "travel", "swing")
_OF_FORCES = (*AT_POINT, "radius", "direction", "at_speed", "travel", "force_back")
_OF_TORQUES = ("at_turning", "swing", "torque_back")
_SIZES = ("force", "torque", "force_back", "torque_back")
OF_LISTS = (*_SIZES, *_OVER)
"""Keys of sizes, and of what they are listed over."""
_OF_LAWS = (*OF_LISTS, "at_speed", "at_turning", "exponent")
"""What a file says instead."""


class LoadSpec(Spec, frozen=True):
    """A force on a link or a slider, or a torque on a link or a shaft.

    A resisting load is always against the motion of its point, as friction or a cut; an active one has a direction of
    its own, as a weight or a spring. Beside `at_speed` the size goes with a power of the speed: exponent 1 is viscous.
    """

    of_file: ClassVar = OF_FILE

    on: str = Field(
        min_length=1,
        description=N_(
            "What it acts on: a part of a mechanism as [masses] names it, or a point on one; a torque also on a shaft."
        ),
    )
    force: OneOrMany[Force] | None = Field(
        default=None, description=N_("Size of a force, or a list of sizes over angles or travel; or give a torque.")
    )
    torque: OneOrMany[Torque] | None = Field(
        default=None, description=N_("Size of a torque on a link, or a list of sizes; or give a force.")
    )
    crank_angles: tuple[Angle, ...] | None = Field(
        default=None, min_length=2, description=N_("Crank angles as they are shown, at which it has the sizes listed.")
    )
    travel: tuple[NonNegativeLength, ...] | None = Field(
        default=None, min_length=2, description=N_("Travel of its point from where it is least, at which it has them.")
    )
    swing: tuple[TurnedAngle, ...] | None = Field(
        default=None,
        min_length=2,
        description=N_("Turn of its link from its least angle, at which it has them."),
    )
    counts: Literal["with", "against"] = Field(
        default="with", description=N_("Whether the travel grows in the direction of the force, or against it.")
    )
    force_back: tuple[Force, ...] | None = Field(
        default=None, description=N_("Sizes on the way back, where they are others than on the way out.")
    )
    torque_back: tuple[Torque, ...] | None = Field(
        default=None, description=N_("Sizes on the way back, where they are others than on the way out.")
    )
    sense: Literal["resisting", "active"] = Field(
        default="resisting", description=N_("Always against the motion, or in a direction of its own.")
    )
    scale: Literal["given", "balanced"] = Field(
        default="given",
        description=N_(
            "Of a torque on a shaft: whether its sizes count as given, or times one factor, so that they balance the"
            " mean of the machine's torque."
        ),
    )
    factor: Factor | None = Field(
        default=None,
        description=N_("By which all sizes of a list or a file count, as of another material; 1 unless given."),
    )
    direction: Angle | None = Field(
        default=None,
        description=N_("Of a force, from the mechanism's x in the sense of rotation; of a slider's along its guide."),
    )
    along: Length | None = Field(
        default=None,
        description=N_("Where a force acts: from the link's first pin toward its second; a force on a link needs it."),
    )
    across: Length | None = Field(default=None, description=N_("Where a force acts: to the left of the line of pins."))
    radius: Length | None = Field(
        default=None,
        description=N_(
            "Arm of the force about the link's first pin; less than 0 on the far side of that pin, where the force"
            " turns the link against the sense of rotation. Across the link, or with a direction as a rope off an arc."
        ),
    )
    at_speed: PositiveVelocity | None = Field(
        default=None, description=N_("Speed of its point at which the force has its size.")
    )
    at_turning: PositiveSpeed | None = Field(
        default=None, description=N_("Speed of its link at which the torque has its size.")
    )
    exponent: Exponent | None = Field(
        default=None, description=N_("Of the speed, with which the size goes; 1 unless given: viscous.")
    )

    file: str | None = Field(
        default=None,
        min_length=1,
        description=N_(
            "File with its sizes over the crank angle, or over travel or swing there and back, relative to the machine"
            " file; units stand in its heads."
        ),
    )
    text: FileText = None
    columns: FileColumns = Field(
        default=None,
        min_length=2,
        max_length=3,
        description=N_(
            "Columns of the file, counted from 1: place, size, and size on the way back if it has a column of its own."
        ),
    )

    @property
    def card(self) -> LoadCard | None:
        """What its file says; None where it has none, or nobody has read it."""
        return None if self.file is None or self.text is None else load_card(self.file, self.text, self.columns)

    @property
    def listed(self) -> "LoadSpec":
        """The load itself, or one with the lists that its file holds."""
        card = self.card
        if card is None:
            return self
        lists = {card.sort: card.out, f"{card.sort}_back": card.back, card.over: card.places}
        return with_lists(self, lists)

    def in_file(self, problem: Problem, where: str) -> Problem:
        """Say what is wrong with lists of a file, at paths below `where`, of that file and at its line."""
        card, key = self.card, problem.path.removeprefix(f"{where}.")
        if card is None or key.partition("[")[0] not in _OF_LAWS:
            return problem
        if problem.given is None:
            return replace(problem, path=f"{where}.file", given=self.file)
        return replace(problem, path=where, position=card.first if key.endswith("[0]") else card.last)

    @property
    def sizes(self) -> tuple[Given, ...]:
        """Of force or torque."""
        return self.force or self.torque or ()

    @property
    def back(self) -> tuple[Given, ...] | None:
        """Sizes on the way back."""
        return self.force_back or self.torque_back

    @property
    def over(self) -> tuple[str, tuple[Given, ...]] | None:
        """Over what sizes are listed, and where."""
        given = ((name, getattr(self, name)) for name in _OVER)
        return next(((name, places) for name, places in given if places is not None), None)

    @property
    def is_balanced(self) -> bool:
        """Whether its size is found, so that it balances the machine."""
        return self.scale == "balanced"

    def resisting_problems(self) -> Iterator[Problem]:
        """Find sizes of less than 0, which do not resist; on a shaft, which turns one way, they may stand."""
        if self.sense != "resisting":
            return
        allowed = _('must be at least 0 of a load that resists; sense = "active" gives it a direction')
        if self.card is not None:
            yield from (Problem("", size, allowed, None, position) for size, position in self.card.negative)
            return
        listed = {name: getattr(self, name) or () for name in _SIZES}
        yield from (
            Problem(f"{name}[{i}]" if len(sizes) > 1 else name, size.text, allowed)
            for name, sizes in listed.items()
            for i, size in enumerate(sizes)
            if size.si < 0
        )

    def _problems(self) -> Iterator[Problem]:
        """Find a load of no sort or of two, and what belongs to another."""
        if self.is_balanced and self.sense != "resisting":
            yield Problem("sense", self.sense, _("must be resisting: it balances what the machine gives"))
        yield from self._factor_problems()
        if self.file is not None:
            yield from self._file_problems(self.file)
            return
        if self.text is not None or self.columns is not None:
            yield Problem("file", None, _("is missing; text and columns are of a file"))
        if self.is_balanced:
            yield from self._balanced_problems()
            return
        if self.force is None and self.torque is None:
            yield Problem("force", None, _("is missing; give force or torque, or a file"))
            return
        if self.torque is not None and self.force is not None:
            yield Problem("torque", None, _("must not stand beside force; make it another load"))
        sort: Sort = "torque" if self.force is None else "force"
        yield from self._sort_problems(sort)
        yield from self._size_problems(sort)

    def _factor_problems(self) -> Iterator[Problem]:
        """Find a factor of one size, which says it itself, and one of what has its own."""
        if self.factor is None:
            return
        if self.is_balanced:
            allowed = _('must not stand beside scale = "balanced", by which the factor is found')
            yield Problem("factor", self.factor.text, allowed)
        elif self.file is None and self.over is None:
            allowed = _("is for a list of sizes or a file; write the one size as it is")
            yield Problem("factor", self.factor.text, allowed)

    def _file_problems(self, file: str) -> Iterator[Problem]:
        """Find what stands beside a file, what is wrong in it, and what does not suit what it holds."""
        beside = _("must not stand beside file, which says how large the load is")
        yield from (Problem(name, None, beside) for name in _OF_LAWS if getattr(self, name) is not None)
        try:
            card = self.card
        except InputError as error:
            yield from error.problems
            return
        if card is None:
            return
        yield from self._sort_problems(card.sort)
        if card.back is None and self.counts != "with":
            yield Problem("counts", self.counts, _("is for sizes over the travel"))
        if self.is_balanced and (card.sort, card.over) != ("torque", "crank_angles"):
            allowed = _('must hold torques over the crank angle beside scale = "balanced"')
            yield Problem("file", self.file, allowed)

    def _sort_problems(self, sort: Sort) -> Iterator[Problem]:
        """Find what belongs to the other sort, and arms that are none."""
        other = "force" if sort == "torque" else "torque"
        foreign = _OF_FORCES if sort == "torque" else _OF_TORQUES
        allowed = _("is for a {sort}", sort=_(other))
        yield from (Problem(name, None, allowed) for name in foreign if getattr(self, name) is not None)
        if self.radius is not None:
            beside = _("must not stand beside radius, which says where the force acts")
            yield from (Problem(name, None, beside) for name in AT_POINT if getattr(self, name) is not None)
            if self.radius.si == 0:
                yield Problem("radius", self.radius.text, _("must not be 0: such a force turns nothing"))

    def _balanced_problems(self) -> Iterator[Problem]:
        """Find what says how large a load is whose size is found, and one that does not resist."""
        is_listed = self.crank_angles is not None
        foreign = ("force", *_OF_FORCES, "swing", "torque_back", "at_turning")
        foreign += ("exponent",) if is_listed else ("torque",)
        found = _('must not stand beside scale = "balanced", by which the size is found')
        if is_listed:
            found = _('must not stand beside scale = "balanced" and crank_angles')
        yield from (Problem(name, None, found) for name in foreign if getattr(self, name) is not None)
        if is_listed and self.torque is None:
            yield Problem("torque", None, _("is missing: sizes at the crank_angles, which count by one factor"))
        yield from self._size_problems("torque")

    def _size_problems(self, sort: Sort) -> Iterator[Problem]:
        """Find sizes that do not suit the sense, or what they are listed over."""
        listed = {sort: self.sizes, f"{sort}_back": self.back or ()}
        given = [name for name in (*_OVER, "at_speed", "at_turning") if getattr(self, name) is not None]
        if len(given) > 1:
            yield Problem(given[1], None, _("must not stand beside {other}: one law at a time", other=given[0]))
        if self.exponent is not None and not self.is_balanced and self.at_speed is None and self.at_turning is None:
            yield Problem("exponent", self.exponent.text, _("needs at_speed, or of a torque at_turning"))
        if self.travel is None and self.swing is None:
            if self.back is not None:
                yield Problem(f"{sort}_back", None, _("is for sizes over the travel, which has a way back"))
            if self.counts != "with":
                yield Problem("counts", self.counts, _("is for sizes over the travel"))
        yield from count_problems(listed, 1 if self.over is None else len(self.over[1]))
        if self.over is not None:
            yield from order_problems(*self.over)


def count_problems(listed: Mapping[str, Sequence[Given]], n_places: int) -> Iterator[Problem]:
    """Find sizes, by their keys, that are not as many as the places that they are for."""
    allowed = _("must be as many as the places that they are for: {n}", n=n_places)
    for name, sizes in listed.items():
        if sizes and len(sizes) != n_places:
            yield Problem(name, _("a list of {n}", n=len(sizes)), allowed)


def order_problems(name: str, places: Sequence[Given]) -> Iterator[Problem]:
    """Find the first place that is not beyond the one before it; where all are, what reaches too far."""
    for number, (before, place) in enumerate(pairwise(places), 1):
        if not before.si < place.si:
            allowed = _("must be more than {before}, the place before it", before=before.text)
            yield Problem(f"{name}[{number}]", place.text, allowed)
            return
    if name == "crank_angles" and places[-1].si - places[0].si > _MOST:
        yield Problem(name, None, _("must reach over two turns at most, 720°"))


def with_lists(spec: SpecType, lists: Mapping[str, object]) -> SpecType:
    """Give a load or a pull whose file holds some lists these as its own, unchecked: the file was."""
    return cast("SpecType", BaseModel.model_copy(spec, update=lists))


def in_place_of_lists(data: Mapping[str, object], paths: Sequence[PathParts]) -> dict[str, object]:
    """Take the lists out of tables of loads and pulls whose file was set: it stands in their place.

    Parameters
    ----------
    data : mapping
        The tables of a machine, with what was set.
    paths : sequence of tuple of str and int
        What was set; lists among it stay.

    Returns
    -------
    dict
    """
    found: object = data
    for path in paths:
        if path[-1:] != ("file",) or path[-3:-2] not in (("load",), ("pull",)):
            continue
        above = path[:-1]
        if isinstance(table := item_at(data, above), Mapping):
            own = cast("Mapping[str, object]", table)
            kept = {key: value for key, value in own.items() if key not in OF_LISTS or (*above, key) in paths}
            found = replaced(found, above, kept)
    return dict(cast("Mapping[str, object]", found))


LoadTables: TypeAlias = Mapping[str, Mapping[str, LoadSpec]]
"""Loads by the path of their tables, `load` or `bank.B.load`, and by name."""


class OverAngles(Protocol):
    """What may have sizes over crank angles: a load, or a pull."""

    @property
    def crank_angles(self) -> tuple[Given, ...] | None:
        """These angles."""
        ...


def cycle_of(loads: LoadTables, pulls: Iterable[OverAngles]) -> float:
    """Crank angle after which loads and pulls repeat: two turns where one of them reaches farther than one. [rad]"""
    over = [one.crank_angles for one in (*(load for named in loads.values() for load in named.values()), *pulls)]
    is_longer = any(one is not None and is_over_two_turns(one[0].si, one[-1].si) for one in over)
    return 2 * TURN if is_longer else TURN
