"""Questions for the processes of a service that do what no machine does: hang, end the process, say which it was."""

import os
import time
from pathlib import Path
from typing import NamedTuple

from cranktrain.errors import InputError, Problem
from cranktrain.web.asked import Case


class Hanging(NamedTuple):
    """Is at it for ten minutes."""

    case: Case = Case("hanging")
    language: None = None

    @property
    def part(self):
        """Which part is asked for is looked at before all else that is computed."""
        time.sleep(600)


class Fatal(NamedTuple):
    """Ends the process, as the system does with one that takes all memory."""

    case: Case = Case("fatal")
    language: None = None

    @property
    def part(self):
        os._exit(1)


class Faulty(NamedTuple):
    """Comes upon a fault of the program."""

    case: Case = Case("faulty")
    language: None = None

    @property
    def part(self):
        raise ZeroDivisionError("canary-of-a-traceback")


class Leaving(NamedTuple):
    """Leaves a file, so that one sees that it was computed."""

    path: str
    case: Case = Case("leaving")
    language: None = None

    @property
    def part(self):
        Path(self.path).touch()
        return "file"


class Naming(NamedTuple):
    """Says which process has it."""

    case: Case
    language: None = None

    @property
    def part(self):
        time.sleep(0.3)
        raise InputError([Problem("", str(os.getpid()), "")])
