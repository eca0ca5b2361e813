"""Commands typed in this process, with a limit of processor time; what is no answer to a user is told in one line."""

import contextlib
import io
import os
import re
import signal
import warnings
from collections.abc import Sequence
from typing import NamedTuple
from unittest import mock

from cranktrain.cli import main

GOOD, REFUSED = 0, 2
_FRAME = re.compile(r'File "[^"]*/(cranktrain/[^"]*)", line (\d+), in (\S+)')
_NOT_A_NUMBER = re.compile(r"(?<![\w.])[-−]?(?:nan|inf)(?![\w.])")


class TooLong(BaseException):
    """A command has not ended in its time; no handler of exceptions holds it up."""


class Answered(NamedTuple):
    """What a command said, and what is wrong with that, nothing if it is an answer."""

    status: int
    output: str
    errors: str
    fault: str


def answered(arguments: Sequence[str], *, longest: float = 60.0) -> Answered:
    """Type a command; a warning of Python or NumPy, a status of neither 0 nor 2, a NaN shown or a wait is a fault."""
    output, errors = io.StringIO(), io.StringIO()
    status, fault = -1, ""
    before = signal.signal(signal.SIGPROF, _too_long)
    signal.setitimer(signal.ITIMER_PROF, longest)
    try:
        with (
            warnings.catch_warnings(),
            mock.patch.dict(os.environ, {"CRANKTRAIN_TRACEBACK": "1", "LANGUAGE": "en"}),
            contextlib.redirect_stdout(output),
            contextlib.redirect_stderr(errors),
        ):
            warnings.simplefilter("error")
            status = main(list(arguments))
    except TooLong:
        fault = f"not done within {longest:g} s of the processor"
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)
    said = errors.getvalue()
    return Answered(status, output.getvalue(), said, fault or _fault(arguments, status, output.getvalue(), said))


def _too_long(_number, _frame):
    raise TooLong


def _fault(arguments: Sequence[str], status: int, output: str, errors: str) -> str:
    """Say in one line why this is no answer."""
    if status not in (GOOD, REFUSED):
        frames = _FRAME.findall(errors)
        place = ":".join(frames[-1][:2]) if frames else "nowhere"
        last = [line for line in errors.splitlines() if re.match(r"[\w.]+(Error|Warning|Exception)\b", line)]
        return f"status {status} at {place}: {last[-1] if last else ''}"
    if status == REFUSED and (not errors.strip() or output):
        return "refused without a word" if not errors.strip() else "refused after an answer was begun"
    if status == GOOD and "--partial" not in arguments:
        shown = [line for line in output.splitlines() if _NOT_A_NUMBER.search(line)]
        if shown:
            return f"shows no number: {shown[0].strip()}"
    return ""
