"""Designs that cannot be: what is wrong with each is said when somebody reads it, which takes as long as the design."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, cast

from cranktrain.errors import InputError, Problem
from cranktrain.machine import Machine, machine_problems
from cranktrain.study.sweep.varied import SweptDesigns


def checked(machine: Machine, row: Mapping[str, object]) -> Machine:
    """Give a design with which nothing is wrong.

    Raises
    ------
    InputError
        With everything that is wrong with it.
    """
    design = machine.with_(row) if row else machine
    if problems := machine_problems(design):
        raise InputError(problems)
    return design


def problem_of(machine: Machine, row: Mapping[str, object]) -> Problem | None:
    """The first of what is wrong with a design; None where nothing is."""
    try:
        checked(machine, row)
    except InputError as error:
        return error.problems[0]
    return None


class UnsaidProblem(Problem):
    """What is wrong with a design that is known to be refused, found when somebody reads it."""

    def __init__(self, machine: Machine, row: Mapping[str, object]) -> None:
        vars(self)["design"] = machine, row

    def __getattribute__(self, name: str) -> Any:
        """Be the problem itself for whoever reads a field of it."""
        if name in Problem.__dataclass_fields__ or name == "__class__":
            return getattr(said(self), name)
        return super().__getattribute__(name)

    def __reduce__(self) -> tuple[object, ...]:
        """Go to other processes unsaid."""
        return UnsaidProblem, vars(self)["design"]


def said(problem: Problem) -> Problem:
    """Give a problem as one that is found."""
    if not issubclass(type(problem), UnsaidProblem):
        return problem
    own = vars(problem)
    if "said" not in own:
        own["said"] = problem_of(*own["design"])
        assert own["said"] is not None, "a design that can be was to be refused"
    return cast("Problem", own["said"])


class RefusedDesigns(Mapping[int, Problem]):
    """What is wrong with designs that cannot be, the first of it, by their places in a block.

    Parameters
    ----------
    machine : Machine
    designs : SweptDesigns
    first : int
        With which of them the block begins.
    """

    def __init__(self, machine: Machine, designs: SweptDesigns, first: int) -> None:
        self._machine, self._designs, self._first = machine, designs, first
        self._known: dict[int, Problem | None] = {}

    def add(self, places: Sequence[int]) -> None:
        """Take places of designs that are refused."""
        self._known |= dict.fromkeys(places)

    def say(self, place: int, problem: Problem) -> None:
        """Take the place of one, and what is wrong with it."""
        self._known[place] = problem

    def unsaid(self, place: int) -> Problem:
        """Give what is wrong with a design, to be found when it is read."""
        known = self._known[place]
        return UnsaidProblem(self._machine, self._designs.row(self._first + place)) if known is None else known

    def __getitem__(self, place: int) -> Problem:
        problem = self._known[place] = said(self.unsaid(place))
        return problem

    def __contains__(self, place: object) -> bool:
        return place in self._known

    def __iter__(self) -> Iterator[int]:
        return iter(sorted(self._known))

    def __len__(self) -> int:
        return len(self._known)
