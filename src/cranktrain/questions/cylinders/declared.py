"""Cylinders: bores, compression ratios and firing order of the file, put to the pistons of a layout."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from cranktrain.errors import Problem
from cranktrain.grouping import grouped
from cranktrain.language import _
from cranktrain.layout.places import PlacedMechanism
from cranktrain.paths import path_text
from cranktrain.quantities import Given
from cranktrain.questions.cylinders.spec import ROOM, CylinderSpec, CylindersSpec, ratio_of
from cranktrain.record import record

SIDES = ("head", "crank")
"""Of a piston."""


class ChamberRoom(NamedTuple):
    """Compression ratio of a chamber, as the nearest table gives it, and where that stands in the file."""

    ratio: Given | None
    path: str

    @property
    def is_own(self) -> bool:
        """Whether a table of its own, of its cylinder or of its bank gives it."""
        return self.path.rpartition(".")[0] != "cylinder"

    @property
    def is_clearance(self) -> bool:
        """Whether the file speaks of clearance."""
        return self.path.endswith(".clearance")


@record
class Cylinder:
    """One cylinder: what its own table, its bank's or the common one gives, the nearest first.

    Attributes
    ----------
    name, bank : str
    pistons : tuple of int
        Which of the pistons work in it: one, or the exhaust and the scavenge piston.
    signs : tuple of float
        Of each of them: +1 where room grows as the piston moves toward its shaft, −1 of one with side rods.
    bore, piston_rod, ambient, exhaust_port, scavenge_port : Given or None
        As the file has them.
    chambers : tuple of str
        Sides of the piston on which there is a chamber.
    ratios : tuple of ChamberRoom
        Of each chamber.
    paths : mapping of str to str
        Where in the machine file each field that is given stands.
    is_master : bool
        Whether its pistons hang on crank pins themselves.
    carrier : int
        Which piston's rod carries that of its own; −1 where that hangs on a crank pin itself.
    """

    name: str
    bank: str
    pistons: tuple[int, ...]
    signs: tuple[float, ...]
    bore: Given | None
    piston_rod: Given | None
    ambient: Given | None
    exhaust_port: Given | None
    scavenge_port: Given | None
    chambers: tuple[str, ...]
    ratios: tuple["ChamberRoom", ...]
    paths: Mapping[str, str]
    is_master: bool
    carrier: int


def name_of_side(cylinder: str, side: str) -> str:
    """Name a chamber by its side of the piston."""
    return f"{cylinder}.{side}"


def cylinders_of(common: CylindersSpec, pistons: Sequence[PlacedMechanism]) -> tuple[Cylinder, ...]:
    """Give every cylinder its pistons and its dimensions; a valve has none."""
    members = grouped((place.cylinder, i) for i, place in enumerate(pistons) if place.kind.output.has_chambers)
    on_throws = grouped(((place.bank, place.shaft, place.throw), i) for i, place in enumerate(pistons))
    # Most cylinders have no table of their own: what holds for all of a bank is found once.
    tables: dict[tuple[str, ...], _Given] = {}

    def given(*names: str) -> _Given:
        own = tuple(name for name in names if name in common.overrides)
        if own not in tables:
            tables[own] = _given(common, own)
        return tables[own]

    return tuple(
        _cylinder(
            pistons,
            tuple(index),
            {
                side: given(pistons[index[0]].bank, name, *([name_of_side(name, side)] if side else []))
                for side in ("", *SIDES)
            },
            on_throws,
        )
        for name, index in members.items()
    )


class _Given(NamedTuple):
    """Fields of a cylinder, each as the nearest table gives it, and where that stands in the file."""

    values: Mapping[str, Any]
    paths: Mapping[str, str]


def _given(common: CylindersSpec, own: Sequence[str]) -> _Given:
    """Take each field from the nearest table that gives it: the nearer it is, the later it comes."""
    given: dict[str, tuple[str, Any]] = {}
    named = ((path_text(("cylinder", name)), common.overrides[name]) for name in own)
    for path, table in (("cylinder", common), *named):
        fields = {name: (f"{path}.{name}", getattr(table, name)) for name in CylinderSpec.model_fields}
        if (ratio := ratio_of(table)) is not None:
            fields["compression_ratio"] = (f"{path}.{ratio[0]}", ratio[1])
        given |= {name: found for name, found in fields.items() if found[1] is not None}
    return _Given(
        {field: value for field, (_path, value) in given.items()},
        {field: path for field, (path, _value) in given.items()},
    )


def _cylinder(
    pistons: Sequence[PlacedMechanism],
    index: tuple[int, ...],
    given: Mapping[str, _Given],
    on_throws: Mapping[tuple[str, str, int], Sequence[int]],
) -> Cylinder:
    """Put together what is known of one cylinder, and of each side of its piston, by the side, "" of the whole.

    `on_throws` has the pistons of each bank on each throw.
    """
    places = [pistons[i] for i in index]
    leading, values = places[0], given[""].values
    chambers = values.get("chambers", ("head",))
    # A slave hangs on the first piston, on its throw, of the bank that it names.
    master = getattr(leading.spec, "master", "") if leading.kind.is_slave else None
    carriers = () if master is None else on_throws.get((master, leading.shaft, leading.throw), ())
    return Cylinder(
        name=leading.cylinder,
        bank=leading.bank,
        pistons=index,
        signs=tuple(-1.0 if place.is_far else 1.0 for place in places),
        bore=values.get("bore"),
        piston_rod=values.get("piston_rod"),
        ambient=values.get("ambient"),
        exhaust_port=values.get("exhaust_port"),
        scavenge_port=values.get("scavenge_port"),
        chambers=chambers,
        ratios=tuple(
            ChamberRoom(
                given[side].values.get("compression_ratio"), given[side].paths.get("compression_ratio", "cylinder.")
            )
            for side in chambers
        ),
        paths=given[""].paths,
        is_master=all(place.kind.is_direct for place in places),
        carrier=next(iter(carriers), -1),
    )


def cylinder_problems(
    common: CylindersSpec, pistons: Sequence[PlacedMechanism], cylinders: Sequence[Cylinder]
) -> tuple[Problem, ...]:
    """Find cylinders and overrides of nothing, bores given for some pistons only, piston rods that do not fit."""
    pistons = [place for place in pistons if place.kind.output.has_chambers]
    if not pistons:
        allowed = _("is not for this machine, which has no pistons")
        return (Problem("cylinder", None, allowed),) if common.model_fields_set else ()
    sides = [name_of_side(one.name, side) for one in cylinders if one.chambers != ("head",) for side in one.chambers]
    known = dict.fromkeys([name for place in pistons for name in (place.bank, place.cylinder) if name] + sides)
    problems = list(_problems_of_overrides(common, tuple(known), sides))
    without = [cylinder.name for cylinder in cylinders if cylinder.bore is None]
    if without and len(without) < len(cylinders):
        allowed = _(
            "is missing for {cylinders}, while others have one; give it in [cylinder], or in [cylinder.{first}]",
            cylinders=", ".join(without),
            first=without[0],
        )
        problems.append(Problem("cylinder.bore", None, allowed))
    for cylinder in cylinders:
        bore, rod = cylinder.bore, cylinder.piston_rod
        if bore is not None and rod is not None and rod.si >= bore.si:
            allowed = _("must be less than the bore, {bore}", bore=bore.text)
            problems.append(Problem(cylinder.paths["piston_rod"], rod.text, allowed))
        if len(cylinder.pistons) > 1 and cylinder.chambers != ("head",):
            allowed = _("must be left out for opposed pistons, which have one chamber between them")
            problems.append(Problem(cylinder.paths["chambers"], None, allowed))
    return tuple(dict.fromkeys(problems))


def _problems_of_overrides(common: CylindersSpec, known: Sequence[str], sides: Sequence[str]) -> Iterator[Problem]:
    """Find tables of nothing, and in those of one side of a piston what is of the cylinder."""
    for name, table in common.overrides.items():
        path = path_text(("cylinder", name))
        if name not in known:
            allowed = _("is neither a key of [cylinder] nor a bank, cylinder or chamber of this machine: {known}")
            yield Problem(path, None, allowed.format(known=", ".join(known)))
        elif name in sides:
            allowed = _("must be left out: one side of a piston has a clearance or compression_ratio of its own alone")
            for key in sorted(table.model_fields_set.difference(ROOM)):
                yield Problem(f"{path}.{key}", None, allowed)
