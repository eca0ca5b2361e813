"""The option `--speed-curve`: a file that says how the shaft turns, as `[shaft.main.speed_curve]` names one."""

import json
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from cranktrain.errors import InputError, Position, Problem

OPTION = "--speed-curve"
_TABLE = "shaft.main.speed_curve"


def speed_settings(file: str | None) -> tuple[str, ...]:
    """Name the file, relative to where one is, in the machine's table; nothing where none was typed."""
    return () if file is None else (f"{_TABLE}.file={json.dumps(str(Path(file).absolute()), ensure_ascii=False)}",)


@contextmanager
def problems_as_typed(file: str | None) -> Generator[None]:
    """Put what is wrong with the file's name to the option that gives it."""
    try:
        yield
    except InputError as error:
        if file is None:
            raise
        raise InputError(_as_typed(problem, file) for problem in error.problems) from None


def _as_typed(problem: Problem, file: str) -> Problem:
    """Put a problem with the setting that stands for the option to that; what stands in the file itself stays there."""
    of_setting = problem.position is not None and problem.position.line is None
    if of_setting and problem.path == f"{_TABLE}.file":
        return replace(problem, path="", given=file, position=Position(OPTION))
    return problem
