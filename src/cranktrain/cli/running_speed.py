"""The option `--running-speed`: what is wrong with the speed is a problem of it."""

from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import replace

from cranktrain.errors import InputError, Problem

OPTION = "--running-speed"


@contextmanager
def problems_at_option() -> Generator[None]:
    """Put what is wrong with the running speed to the option that asks for it."""
    try:
        yield
    except InputError as error:
        raise InputError(map(_at_option, error.problems)) from None


def _at_option(problem: Problem) -> Problem:
    return replace(problem, path=OPTION, given=None) if problem.path == "speed" else problem
