"""The declared machine: the domains' tables together, and what only they together can check."""

from collections.abc import Iterator, Mapping
from functools import cached_property
from os import PathLike
from typing import Any, ClassVar, Literal, Self

import numpy as np
from pydantic import Field, ValidationError

from cranktrain.all_questions import QUESTIONS, CrankshaftSpec, DriveSpec, GearSpec, PumpingSpec, RodSpec, TorsionSpec
from cranktrain.allowed import ELSEWHERE, Name
from cranktrain.errors import InputError, Problem, judged, refuse
from cranktrain.faces import face
from cranktrain.kept import read_like
from cranktrain.language import N_, _
from cranktrain.layout.as_in_file import as_in_file
from cranktrain.layout.bodies import BodySpec, Friction, GravitySpec, GuideSpec
from cranktrain.layout.closing import closing_problems
from cranktrain.layout.design import Design
from cranktrain.layout.frames import Orientation
from cranktrain.layout.gearing import first_axis
from cranktrain.layout.load_tables import LoadSpec, LoadTables, cycle_of, in_place_of_lists
from cranktrain.layout.masses import Weighed
from cranktrain.layout.places import PlacedMechanism, places_of
from cranktrain.layout.question import Question
from cranktrain.layout.shaft_problems import bank_problems, layout_problems, shaft_problems
from cranktrain.layout.specs import MAIN, TURNING, BankSpec, OpposedPistonSpec, ShaftSpec
from cranktrain.layout.unit_tables import unit_problems
from cranktrain.mechanisms import KINDS, AnyMechanism
from cranktrain.motion import Array
from cranktrain.paths import values_by_path, with_values
from cranktrain.quantities import Angle, Given
from cranktrain.questions.balance.spec import BalanceSpec
from cranktrain.questions.cylinders.spec import CylindersSpec
from cranktrain.questions.evenness.spec import EvennessSpec
from cranktrain.questions.gas.spec import GasTables
from cranktrain.spec import Spec, problems, with_tuples
from cranktrain.spec_class import listed_property
from cranktrain.typed_file import TypedFile

_PLACED = {**dict.fromkeys(("angle", "bank", "mechanism", "running"), ()), "shaft": TURNING}
_RESTS_ON = {"arranged": _PLACED, "kinds": _PLACED, "closing_problems": {**_PLACED, "crank_zero": (), "units": ()}}
"""What of it is found from some tables alone, and which of their keys say nothing of it."""


class Machine(Spec, frozen=True):
    """A machine as its file declares it, with units and provenance.

    Raises
    ------
    InputError
        With everything that is wrong, each with its path in the machine file.

    Examples
    --------
    >>> machine = Machine(
    ...     mechanism={"kind": "slider_crank", "stroke": "80 mm", "rod_length": "136 mm"},
    ...     shaft={"main": {"speed": "5200 rpm"}},
    ... )
    >>> machine.mechanism.rod_length.si
    0.136
    """

    elsewhere: ClassVar = ELSEWHERE
    name: str = Field(default="", description=N_("Name of the machine, as tables and plots show it."))
    rotation: Literal["clockwise", "anticlockwise"] = Field(
        default="clockwise",
        description=N_(
            "Normal sense of rotation, seen from the free end of the shaft; all angles of the file count in it."
        ),
    )
    running: Literal["ahead", "astern"] = Field(
        default="ahead", description=N_("`astern` is the same machine turning against its normal sense of rotation.")
    )
    crank_zero: Literal["Y"] | Angle = Field(
        default=Given(0.0, "0 deg"),
        description=N_(
            "Crank angle that is shown as 0, or `Y`: where throw 1 points up; otherwise 0 is along the first bank."
        ),
    )
    angle: Angle = Field(
        default=Given(0.0, "0 deg"),
        description=N_("Direction of the mechanism's x axis, from straight up; for a machine with one [mechanism]."),
    )
    shaft: Mapping[Name, ShaftSpec] = Field(
        default={}, description=N_("Shafts by name; the angle of `main` is the crank angle.")
    )
    mechanism: AnyMechanism | None = Field(
        default=None, description=N_("The mechanism of a machine that has only one; otherwise each bank has its own.")
    )
    bank: Mapping[Name, BankSpec] = Field(
        default={}, description=N_("Banks by name; the first one in the file is the first bank.")
    )
    cylinder: CylindersSpec = Field(
        default=CylindersSpec(),
        description=N_("Cylinders: what is common to all, and tables for one bank or one cylinder."),
    )
    masses: Mapping[Name, BodySpec] = Field(
        default={},
        description=N_(
            "Bodies by the part that they are: piston, rod, crank, a chain's own names; a bank may have its own."
        ),
    )
    friction: Mapping[Name, Friction] = Field(
        default={},
        description=N_(
            'Coefficients of friction by what slides: piston, block, or a chain\'s slider S and its slot, "S.slot".'
        ),
    )
    guide: Mapping[Name, GuideSpec] = Field(
        default={},
        description=N_(
            "Guides of what slides, by the names of [friction]: how long they are; a bank may have its own."
        ),
    )
    load: Mapping[Name, LoadSpec] = Field(
        default={},
        description=N_("What the machine works against besides gas and weight, by name; a bank may have its own."),
    )
    gravity: bool | GravitySpec = Field(
        default=False, description=N_("Whether weights count, downward; or a table, for another strength or direction.")
    )
    gas: GasTables | None = Field(
        default=None,
        description=N_(
            "What the chambers hold: a fluid by its kind, or several by the names of chambers, cylinders or banks."
        ),
    )
    units: Mapping[str, str] = Field(
        default={}, description=N_('Units in which numbers are shown, by what they measure: pressure = "bar".')
    )
    balance: BalanceSpec | None = Field(default=None, description=N_("Counterweights and balance shafts."))
    evenness: EvennessSpec | None = Field(
        default=None, description=N_("What balances the machine, its flywheel, and how evenly it is to run.")
    )
    crankshaft: CrankshaftSpec | None = Field(default=None, description=N_("The crankshaft's sections and bearings."))
    gear: Mapping[Name, GearSpec] = Field(default={}, description=N_("Gears between shafts, by name, and their teeth."))
    torsion: TorsionSpec | None = Field(default=None, description=N_("The crankshaft as it vibrates in torsion."))
    drive: DriveSpec | None = Field(default=None, description=N_("What drives the crank, and how it starts."))
    rod_load: RodSpec | None = Field(default=None, description=N_("Limits of rod loads, masses of crossheads."))
    pumping: PumpingSpec | None = Field(default=None, description=N_("A beam pumping unit: its loads and ratings."))

    def __init__(self, /, **data: Any) -> None:
        try:
            super().__init__(**data)
        except ValidationError as error:
            found = [as_in_file(problem, data) for problem in problems(error, Machine)]
            # A list is also called too short where one of its items is wrong.
            wrong = {problem.path.rpartition("[")[0] for problem in found if "[" in problem.path}
            raise InputError(problem for problem in found if problem.path not in wrong) from None
        vars(self)["declared"] = with_tuples(data)  # what a caller does with its own later is no matter

    @cached_property
    def declared(self) -> Mapping[str, Any]:
        """Its tables as they were given; of a machine that was never checked there are none."""
        return {}

    @cached_property
    def alike(self) -> dict[type, Any]:
        """What is kept of machines that come from one another by `with_`, which costs less time where it can be used.

        Whoever keeps something has a class for it, by which it stands here, and of which nothing is sent or copied.
        """
        return {}

    @cached_property
    def typed_in(self) -> TypedFile:
        """Where it is from; of a machine made in Python nothing is known."""
        return TypedFile()

    def coming_from(self, file: TypedFile) -> Self:
        """Let the machine, which nobody has seen yet, know where it is from; give itself."""
        vars(self)["typed_in"] = file
        return self

    def save(self, path: "str | PathLike[str]", *, force: bool = False) -> None:
        """Write it as a machine file, whole or not at all.

        Parameters
        ----------
        path : str or path-like
            Ends in `.toml`. If the machine was read from a file, its comments and layout stay as they are there.
        force : bool
            Replace a file that is there.

        Raises
        ------
        InputError
            If a file is there and `force` is not given, or it cannot be written.
        """
        face("save_machine")(self, path, force=force)

    def with_(self, values: Mapping[str, object]) -> Self:
        """Give a machine like this one with other values at some paths, checked as a new one is.

        Parameters
        ----------
        values : mapping of str
            By path, as `--set` takes it: `mechanism.rod_length`, `shaft.main.throws[2]`, `balance`; quantities as texts
            with their units, tables as mappings, lists as lists. What was said of where an old value is from does not
            hold of the new one, and goes with it. A file that is named is read relative to the machine file.

        Returns
        -------
        Machine

        Raises
        ------
        InputError
            With everything that is wrong, each with its path.

        Examples
        --------
        >>> machine = Machine(mechanism={"kind": "slider_crank", "stroke": "80 mm", "rod_length": "136 mm"})
        >>> longer = machine.with_({"mechanism.rod_length": "140 mm", "shaft.main.speed": "5200 rpm"})
        >>> longer.mechanism.rod_length.text, machine.mechanism.rod_length.text
        ('140 mm', '136 mm')
        """
        data, paths = with_values(self.declared, with_tuples(values_by_path("with_", values, "machine.with_({})")))
        data, found = self.typed_in.files_read(in_place_of_lists(data, paths))
        refuse(found)
        # What is wrong is told in the units of its time.
        is_right = "arranged" in vars(self) and self.places and not vars(self).get("closing_problems")
        changed = read_like(self, data, self.declared, _RESTS_ON if is_right else {})
        vars(changed).update(declared=data, alike=self.alike)
        return changed.coming_from(self.typed_in)

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """Copy it; refuse other values, which nothing would check."""
        if update:
            given = ", ".join(update)
            allowed = _("cannot be changed in a copy, where nothing checks it")
            repair = _("write machine.with_({example})", example='{"mechanism.rod_length": "140 mm"}')
            raise InputError([Problem("model_copy", given, allowed, repair)])
        return super().model_copy(deep=deep)

    def _problems(self) -> Iterator[Problem]:
        """Find a machine with no mechanism, one beside its banks, and what belongs to the other way of arranging."""
        if self.mechanism is None and not self.bank:
            allowed = _("is missing; a machine needs a [mechanism], or banks with [bank.NAME.mechanism]")
            yield Problem("mechanism", None, allowed)
        if self.mechanism is not None and self.bank:
            allowed = _("must not stand beside [bank]; give the mechanism of each bank in [bank.NAME.mechanism]")
            yield Problem("mechanism", None, allowed)
        elif self.bank and "angle" in self.model_fields_set:
            allowed = _("is for a machine with one [mechanism]; here each bank has its own, [bank.NAME] angle")
            yield Problem("angle", self.angle.text, allowed)
        elif self.mechanism is not None and len(self.main_shaft.throws) > 1:
            allowed = _("must be one throw for one [mechanism]; for more, make it a bank, [bank.NAME.mechanism]")
            yield Problem("shaft.main.throws", None, allowed)
        yield from bank_problems(self.bank, self.shafts, CylindersSpec.model_fields)
        yield from judged(shaft_problems(self.shaft, self.banks))
        yield from unit_problems(self.units)

    @listed_property
    def shafts(self) -> Mapping[str, ShaftSpec]:
        """The shafts by name; `main` is there whether the file has a table for it or not."""
        return {MAIN: ShaftSpec(), **self.shaft}

    @listed_property
    def banks(self) -> Mapping[str, BankSpec]:
        """The banks by name; a bare `[mechanism]` is a bank of one, without a name."""
        alone: dict[str, Any] = {"angle": (self.angle,), "mechanism": (self.mechanism,), "throws": (1,)}
        return self.bank or {"": BankSpec.model_construct(**alone)}

    @property
    def main_shaft(self) -> ShaftSpec:
        """The shaft whose angle is the crank angle."""
        return self.shafts[MAIN]

    @property
    def is_astern(self) -> bool:
        """Whether it runs against its normal sense of rotation."""
        return self.running == "astern"

    @property
    def zero(self) -> Array:
        """φ where the shown crank angle is 0: as given, or where the crank of throw 1 points along Y. [rad]"""
        zero = -self.orientation.first_angle if self.crank_zero == "Y" else self.crank_zero.array
        return -zero if self.is_astern else zero

    @property
    def weighed(self) -> Weighed:
        """What the file says of masses, by the paths of its tables."""
        homes = self._homes
        return Weighed(
            {f"{home}masses": table.masses for home, table in homes.items() if table.masses},
            self.friction,
            {f"{home}guide": table.guide for home, table in homes.items() if table.guide},
            GravitySpec() if self.gravity is True else self.gravity or None,
            self.orientation,
        )

    @property
    def loads(self) -> LoadTables:
        """What it works against, by the paths of its tables; what files hold as lists."""
        homes = ((home, table.load) for home, table in self._homes.items() if table.load)
        return {f"{home}load": {name: load.listed for name, load in loads.items()} for home, loads in homes}

    @property
    def _homes(self) -> "Mapping[str, Machine | BankSpec | OpposedPistonSpec]":
        """Tables that speak of all mechanisms, of a bank's, or of one piston's, by what their paths begin with."""
        homes: dict[str, Machine | BankSpec | OpposedPistonSpec] = {"": self}
        for name, bank in self.bank.items():
            homes[f"bank.{name}."] = bank
            homes |= {f"bank.{name}.{end}.": piston for end, piston in bank.opposed.items()}
        return homes

    @listed_property
    def orientation(self) -> Orientation:
        """How it stands and runs."""
        return Orientation(first_axis(self.banks), self.rotation == "clockwise", self.is_astern)

    @property
    def places(self) -> tuple[PlacedMechanism, ...]:
        """Every mechanism of the machine, arranged on shaft and banks; none where they cannot be arranged."""
        return self.arranged[0]

    @cached_property
    def arranged(self) -> tuple[tuple[PlacedMechanism, ...], tuple[Problem, ...]]:
        """Its mechanisms in their places, and what is wrong with these; with problems there are no places."""
        with np.errstate(all="ignore"):  # sizes that cannot be are found where their links do not close
            return places_of(self.shafts, self.banks, astern=self.is_astern)

    @cached_property
    def design(self) -> Design:
        """What questions see of it."""
        tables = {key: table for key in type(self).model_fields if (table := getattr(self, key)) is not None}
        return Design(self.places, self.shafts, self.orientation, self.zero, self.weighed, self.loads, tables)

    @cached_property
    def asks(self) -> tuple[str, ...]:
        """Names of the questions that its tables ask."""
        return QUESTIONS.by({key for key in type(self).model_fields if getattr(self, key)})

    @cached_property
    def questions(self) -> tuple[Question, ...]:
        """What its tables ask."""
        return tuple(map(QUESTIONS.named, self.asks))

    @cached_property
    def kinds(self) -> tuple[str, ...]:
        """Names of the kinds of its mechanisms."""
        return tuple(filter({place.spec.kind for place in self.places}.__contains__, KINDS.names))

    @property
    def cycle(self) -> float:
        """Crank angle after which all repeats: a turn, or two of cylinders, loads, pulls or the speed. [rad]"""
        pulls = () if self.crankshaft is None else self.crankshaft.pulls
        return max(self.cylinder.cycle_length or 0.0, cycle_of(self.loads, pulls), self.main_shaft.speed_cycle)

    @cached_property
    def table_problems(self) -> tuple[Problem, ...]:
        """What only the tables together can show to be wrong."""
        if found := self.arranged[1]:
            return found
        with np.errstate(all="ignore"):  # links that cannot close have no motion, which is said beside
            of_questions = (problem for question in self.questions for problem in question.problems(self.design))
            return (*layout_problems(self.design), *of_questions)

    @cached_property
    def closing_problems(self) -> tuple[Problem, ...]:
        """Over which crank angles a mechanism cannot close, once for each geometry."""
        return closing_problems(self.design)

    def __repr__(self) -> str:
        """Say in one line what it is."""
        line: str = face("machine_line")(self)
        return line

    __str__ = __repr__

    def _repr_html_(self) -> str:
        """Say what it is, for a notebook."""
        words: str = face("machine_html")(self)
        return words

    def __copy__(self) -> Self:
        """Copy what was declared alone: what was found may not hold of the copy, which may be given other fields."""
        copied = super().__copy__()
        for found in _FOUND:
            vars(copied).pop(found, None)
        return copied

    def __getstate__(self) -> dict[Any, Any]:
        """Send what was declared alone, as what was found is soon found again."""
        state = super().__getstate__()
        declared = {name: held for name, held in state["__dict__"].items() if name not in _FOUND}
        return {**state, "__dict__": declared}


_FOUND = {name for name, held in vars(Machine).items() if isinstance(held, cached_property)} - {"declared", "typed_in"}
"""What is found of what a machine declares: once, however often it runs."""


def machine_problems(machine: Machine, *, partial: bool = False) -> tuple[Problem, ...]:
    """Find what only the whole machine shows to be wrong; with `partial`, links may close over a part of the turn."""
    found = machine.table_problems
    return found if partial or machine.arranged[1] else (*found, *machine.closing_problems)
