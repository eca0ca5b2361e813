"""What is said to whoever asked for what cannot be given: problems, as other programs read them."""

import json
from collections.abc import Iterable
from typing import Annotated

from pydantic import BaseModel, Field

from cranktrain.errors import Problem
from cranktrain.language import Words, _
from cranktrain.quantities.refusal import Instead
from cranktrain.web.asked import Reply


class ProblemSaid(BaseModel):
    """One thing that is wrong: where, what was given, what is allowed, what to write instead."""

    path: Annotated[str, Field(description="Of the value in the machine file; empty for the file or request itself.")]
    given: str | None
    allowed: str
    repair: str | None
    instead: Annotated[list[str], Field(description="Texts that would be right there, one of which may be meant.")] = []
    line: Annotated[int | None, Field(description="Of the machine file, from 1.")] = None
    column: int | None = None


def refused(problems: Iterable[Problem], status: int = 422) -> Reply:
    """Say all that is wrong, in the language and the units of whoever asks."""
    content = json.dumps([_said(problem).model_dump() for problem in problems], ensure_ascii=False)
    return Reply(status, "application/json", content.encode(errors="replace"))


def refusal_of(status: int, allowed: Words, repair: Words | None = None) -> Reply:
    """Say in a sentence why a request is refused."""
    return refused([Problem("", None, allowed, repair)], status)


def too_much_to_do() -> Reply:
    """Say that others have to be answered first."""
    return refusal_of(503, _("has too much to do now"), _("ask again"))


def given_up(seconds: float) -> Reply:
    """Say that something took too long."""
    return refusal_of(503, _("takes longer than {n} s, and was given up", n=f"{seconds:g}"))


def process_ended() -> Reply:
    """Say that the process that was at it is gone."""
    return refusal_of(503, _("could not be computed: its process ended"), _("ask again"))


def _said(problem: Problem) -> ProblemSaid:
    """Say a problem."""
    given, repair = (None if words is None else str(words) for words in (problem.given, problem.repair))
    line, column = (problem.position.line, problem.position.column) if problem.position else (None, None)
    return ProblemSaid(
        path=problem.path,
        given=given,
        allowed=str(problem.allowed),
        repair=repair,
        instead=list(problem.repair.texts) if isinstance(problem.repair, Instead) else [],
        line=line,
        column=column,
    )
