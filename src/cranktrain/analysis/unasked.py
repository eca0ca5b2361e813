"""Questions that a file does not ask: what they would give and need, from a list that is made with the package.

Nobody needs their code for a machine without their tables; but what such a machine may be asked next is said. Of a
question that the list has not, or where it was not made, as in sources that were not installed, the question says it.
"""

import json
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from cranktrain.all_questions import QUESTIONS
from cranktrain.layout.question import Applies, Question, Stage, needs_of

LIST = Path(__file__).parent / "unasked.json"
_MODULES = Path(__file__).parents[1] / "questions"
_SOURCES = Path(__file__).parents[3] / "pyproject.toml"
"""Beside sources that are worked on; nowhere near an installed package."""


class UnaskedStage(NamedTuple):
    """A stage of a question that a file does not ask.

    Attributes
    ----------
    outcome : str
        Class of what it would give.
    results : sequence of str
        The quantities in that.
    lacks : mapping of str to str
        What it cannot do without, by the names of classes: what the file would have to say, where that gives it.
    answer : bool or str, or None
        Whether it is for a machine that has none of the question's tables, or what the file would have to say; None
        where that hangs on the machine.
    """

    outcome: str
    results: Sequence[str]
    lacks: Mapping[str, str]
    answer: bool | str | None

    def __hash__(self) -> int:
        """Tell it by what it gives."""
        return hash(self.outcome)

    def applies_to(self, _parts: Mapping[type, object]) -> Applies:
        """Answer as of any machine without the question's tables."""
        return self.answer or False


class UnaskedQuestion(NamedTuple):
    """A question that a file does not ask: its stages, and what it gives to those who ask next."""

    stages: tuple[UnaskedStage, ...]
    offers: Mapping[str, str]

    @property
    def is_general(self) -> bool:
        """Whether nothing in it hangs on the machine; else the question itself has to be asked."""
        return all(stage.answer is not None for stage in self.stages)


@cache
def unasked(name: str) -> UnaskedQuestion:
    """Give a question that only some tables ask, by its name: as the list has it, or as it is where that has it not."""
    listed = _listed().get(name)
    if listed is None:
        return described(QUESTIONS.named(name))
    stages, offers = listed
    return UnaskedQuestion(tuple(UnaskedStage(*stage) for stage in stages), offers)


@cache
def _listed() -> Mapping[str, Sequence[Any]]:
    """Read the list, if it was made, and of these sources: those that are worked on may have changed since."""
    if not LIST.exists():
        return {}
    if _SOURCES.exists() and _changed_at(LIST) < max(map(_changed_at, _MODULES.rglob("*.py"))):
        return {}
    return json.loads(LIST.read_text(encoding="utf-8"))


def _changed_at(path: Path) -> float:
    return path.stat().st_mtime


def made() -> dict[str, UnaskedQuestion]:
    """Make the list of the questions themselves."""
    return {name: described(QUESTIONS.named(name)) for name, tables in QUESTIONS.asked_by.items() if tables}


def described(question: Question) -> UnaskedQuestion:
    """Describe a question as it is where nothing of it is declared."""
    return UnaskedQuestion(tuple(_stage(question, stage) for stage in question.stages), dict(question.offers))


def _stage(question: Question, stage: Stage) -> UnaskedStage:
    """Describe a stage: what it says then of whether it is for a machine, it says of every machine."""
    answer: Applies | None = True
    if stage.applies is not None:
        asked = needs_of(stage.applies)
        own = f"cranktrain.questions.{question.name}."
        is_lacking = any(
            kind.__module__.startswith(own) for name, kind in asked.types.items() if name not in asked.optional
        )
        try:
            answer = not is_lacking and stage.applies(**dict.fromkeys(asked.types))
        except (AttributeError, TypeError):  # it looks at what other parts of the machine are
            answer = None
    if isinstance(answer, tuple):
        raise TypeError(f"{stage.outcome} must lack one thing where nothing of [{question.name}] is declared")
    return UnaskedStage(stage.outcome, stage.results, dict(stage.lacks), answer)


def write_list(path: Path) -> None:
    """Write the list to a file."""
    path.write_text(json.dumps(made(), ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
