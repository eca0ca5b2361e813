"""A process that computes beside a service, as the service has it."""

import asyncio
import os
import pickle
import signal
import sys
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from math import inf
from time import monotonic
from typing import Any

from cranktrain.web.asked import MOST_KEPT, Case, HowFar, PageQuestion, Reply, SweepQuestion
from cranktrain.web.worker import LENGTH, framed

GONE = (asyncio.IncompleteReadError, OSError)
"""What is raised of a process that ends before it answers."""

_START = "import sys; sys.path[:] = {}; from cranktrain.web.worker import work; work()"
"""Of a process: it finds what this one finds, and nothing that only lies in the working folder."""


def _unheard(_how_far: HowFar) -> None:
    """Take no notice of how far an answer is."""


class WorkerProcess:
    """A process, and the machines that it has."""

    def __init__(self) -> None:
        self.cases: deque[Case | None] = deque(maxlen=MOST_KEPT)
        self._process: asyncio.subprocess.Process | None = None
        self._is_ready = False
        self._since = inf

    async def reply(self, question: PageQuestion | SweepQuestion, heard: Callable[[HowFar], None] = _unheard) -> Reply:
        """Have a question answered, and hear how far that is; one that ends meanwhile is one of `GONE`."""
        if self._process is None or self._process.returncode is not None:
            await self.start()
        assert self._process is not None and self._process.stdin is not None and self._process.stdout is not None
        with suppress(ValueError):
            self.cases.remove(question.case)
        self.cases.append(question.case)
        self._since = monotonic() if self._is_ready else inf
        self._process.stdin.write(framed(question))
        await self._process.stdin.drain()
        while True:
            (length,) = LENGTH.unpack(await self._process.stdout.readexactly(LENGTH.size))
            # Written by a process of ours, and by nobody else.
            found: Reply | HowFar = pickle.loads(await self._process.stdout.readexactly(length))
            if isinstance(found, Reply):
                return found
            if self._is_ready:
                heard(found)
            else:
                self._is_ready, self._since = True, monotonic()

    @property
    def has_taken(self) -> float:
        """How long it has been at what it was asked last, not counting its own start. [s]"""
        return monotonic() - self._since

    async def start(self) -> None:
        """Begin, or begin anew; it is ready for questions at once, and answers when it has imported what it needs."""
        self.cases.clear()
        self._is_ready = False
        apart: dict[str, Any] = {"process_group": 0} if os.name == "posix" else {}  # Ctrl-C does not reach it
        self._process = await asyncio.create_subprocess_exec(
            sys.executable,
            "-c",
            _START.format(sys.path),
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            **apart,
        )

    async def end(self) -> None:
        """Take the process away, whatever it is at."""
        if self._process is None:
            return
        with suppress(ProcessLookupError):
            if os.name == "posix" and self._process.returncode is None:
                # Its own kill() looks first whether it has ended, which then nobody else learns who waits for that.
                os.kill(self._process.pid, signal.SIGKILL)
            elif os.name != "posix":
                self._process.kill()
        await self._process.wait()
