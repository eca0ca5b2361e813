"""What is asked of the commands that compute, as typed: which machine, at which speed, and where to write."""

import json
from collections.abc import Callable, Generator, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cranktrain.cli.how_far import says_how_far
from cranktrain.errors import Position, Problem, problems_as
from cranktrain.io.description import units_of
from cranktrain.io.machine_file import MachineFile, computed, read_machine
from cranktrain.language import said as _
from cranktrain.quantities import UnitChoice, shown_as_in, shown_by
from cranktrain.record import record

if TYPE_CHECKING:
    from cranktrain.analysis import Result

DECIMALS = ("point", "comma")
RUNNING_SPEED, SPEED_CURVE = "--running-speed", "--speed-curve"
_TABLE = "shaft.main.speed_curve"


@record
class Asked:
    """What the commands that compute have in common."""

    file: str
    settings: tuple[str, ...] = ()
    is_partial: bool = False
    output: str | None = None
    force: bool = False
    units: str | None = None


@record
class AskedAtSpeed(Asked):
    """What `run` and `plot` have in common."""

    is_at_running_speed: bool = False
    speed_curve: str | None = None

    @property
    def speed(self) -> str:
        """At which everything is computed, as `run` of the analysis takes it."""
        return "running" if self.is_at_running_speed else "constant"

    def read(self) -> MachineFile:
        """Read the machine; the file of a speed curve, relative to where one is, stands in its table for that."""
        settings = self.settings
        if self.speed_curve is not None:
            name = json.dumps(str(Path(self.speed_curve).absolute()), ensure_ascii=False)
            settings = (*settings, f"{_TABLE}.file={name}")
        with problems_as(self._at_curve):
            return read_machine(self.file, settings, partial=self.is_partial)

    def result(self, file: MachineFile, find: "Callable[[Result], None] | None" = None, **options: Any) -> "Result":
        """Compute, at once what `find` finds; `options` as `run` of the analysis takes them."""
        with says_how_far():
            result = computed(file, speed=self.speed, partial=self.is_partial, **options)
            if find is not None:
                find(result)
        return result

    def _at_curve(self, problem: Problem) -> Problem:
        """Put what is wrong with the name of a speed curve to its option; what stands in a file stays there."""
        of_setting = problem.position is not None and problem.position.line is None
        if self.speed_curve is not None and of_setting and problem.path == f"{_TABLE}.file":
            return replace(problem, path="", given=self.speed_curve, position=Position(SPEED_CURVE))
        return problem


@record
class CurvesAsked:
    """Which curves at which crank angles, as typed.

    Attributes
    ----------
    at : str or None
        `140`, or `0,30..720`.
    table : str or None
        Its name.
    of : str or None
        Of which member the table is.
    every : str or None
        How far apart its lines are. [deg]
    """

    at: str | None = None
    table: str | None = None
    of: str | None = None
    every: str | None = None

    def __bool__(self) -> bool:
        """Whether any are asked for."""
        return any(part is not None for part in (self.at, self.table, self.of, self.every))

    def problems(self) -> Iterator[Problem]:
        """Find what does not go together."""
        if self.table is None:
            for option, given in (("--of", self.of), ("--every", self.every)):
                if given is not None:
                    yield Problem(option, given, _("is for a table"), _("name one, such as --table forces"))
        elif self.at is not None and self.every is not None:
            yield Problem("--every", self.every, _("must be left out beside --at, which names the angles"))


def decimal_problems(typed: str) -> Iterator[Problem]:
    """Find what is wrong with what is to divide decimals in a file."""
    from cranktrain.quantities import unlisted

    if typed not in DECIMALS:
        yield unlisted("--decimal", typed, DECIMALS)


def at_running_speed(problem: Problem) -> Problem:
    """Put what is wrong with the running speed to the option that asks for it."""
    return replace(problem, path=RUNNING_SPEED, given=None) if problem.path == "speed" else problem


def units_asked_for(typed: str | None) -> "UnitChoice":
    """Read the units in which numbers are to be shown, `bar,kW`; refuse words that are none."""
    from cranktrain.quantities import units_by_dimension

    return {} if typed is None else units_by_dimension([name.strip() for name in typed.split(",")])


@contextmanager
def in_units_of(file: MachineFile, asked: UnitChoice | None = None) -> Generator[None]:
    """Show numbers in the units of a file, or in those that are asked for; what is wrong is said in them, too."""
    with shown_as_in(units_of(file.machine)), shown_by(asked or {}), problems_as(_said_here):
        yield


def _said_here(problem: Problem) -> Problem:
    """Say a problem here: it is told where these units are not."""
    given, repair = (None if words is None else str(words) for words in (problem.given, problem.repair))
    return replace(problem, given=given, allowed=str(problem.allowed), repair=repair)
