"""Processes that compute for a service, so that nobody waits for another one's long question, and none is lost with it.

They are subprocesses and no pool of `concurrent.futures`: one that is at a question for too long, or for nobody any
more, is ended and another one takes its place, and a question goes to the process that has its machine.
"""

import asyncio
from collections import deque
from collections.abc import Coroutine
from contextlib import suppress
from typing import Any, Protocol

from cranktrain.language import _
from cranktrain.web.asked import Case, PageQuestion, Reply
from cranktrain.web.refusals import given_up, process_ended, refusal_of, too_much_to_do
from cranktrain.web.worker_process import GONE, WorkerProcess

_LONGEST = 60.0
"""After which a question is given up. [s]"""
_PATIENCE = 1.0
"""So long one waits for a process before another is started, and so long goes on what nobody waits for. [s]"""
_MOST_WAITING = 100


class Replying(Protocol):
    """Who answers questions, and what goes on for it as long as a service runs."""

    async def start(self) -> None:
        """Begin."""
        ...

    async def stop(self) -> None:
        """End, with all that is computed."""
        ...

    async def reply(self, question: PageQuestion) -> Reply:
        """Answer; whoever cancels this waits no longer."""
        ...


class InThisProcess:
    """Computes where the service is, without a limit of time: for tests, and for one user."""

    async def start(self) -> None:
        """Begin."""

    async def stop(self) -> None:
        """End."""

    async def reply(self, question: PageQuestion) -> Reply:
        """Answer in a thread."""
        from cranktrain.web.replies import reply_to  # a service with processes of its own computes nothing itself

        return await asyncio.to_thread(reply_to, question)


class Workers:
    """Processes that answer questions, each one at a time.

    Parameters
    ----------
    n_at_once : int
        How many there are at most. Where all are at long questions, up to so many again are started for those who wait.
    longest : float
        After which a question is given up. [s]
    """

    def __init__(self, n_at_once: int, longest: float = _LONGEST) -> None:
        self.n_at_once = n_at_once
        self._longest = longest
        self._all: list[WorkerProcess] = []
        self._idle: list[WorkerProcess] = []
        """Those that were at work last stand last: what they have is still at hand."""
        self._waiting: deque[asyncio.Future[WorkerProcess | None]] = deque()
        self._going: set[asyncio.Future[Any]] = set()
        self._is_over = False

    async def start(self) -> None:
        """Start the first; the others begin when they are needed, as one user needs one, and each has its memory."""
        self._is_over = False
        self._all = [WorkerProcess() for _each in range(self.n_at_once)]
        self._idle = list(self._all)
        await self._idle[-1].start()

    async def stop(self) -> None:
        """End all; whoever waits is said so."""
        self._is_over = True
        while self._waiting:
            self._waiting.popleft().set_result(None)
        await asyncio.gather(*(worker.end() for worker in self._all))
        await asyncio.gather(*self._going, return_exceptions=True)
        self._all, self._idle = [], []

    async def reply(self, question: PageQuestion) -> Reply:
        """Answer, or say why it is not answered; what has not begun when this is cancelled never does."""
        if self._is_over or len(self._waiting) >= _MOST_WAITING:
            return too_much_to_do()
        try:
            async with asyncio.timeout(self._longest):
                worker = await self._free_worker(question.case)
        except TimeoutError:
            return too_much_to_do()
        if worker is None or self._is_over:
            return _ended()
        going = self._apart(self._computed(worker, question))
        try:
            return await asyncio.shield(going)
        except asyncio.CancelledError:
            # What is soon ready is kept for the next question; a new process takes longer.
            asyncio.get_running_loop().call_later(_PATIENCE, going.cancel)
            raise

    def _apart(self, coroutine: Coroutine[Any, Any, Reply]) -> asyncio.Task[Reply]:
        """Let something go on, whoever waits for it."""
        going = asyncio.ensure_future(coroutine)
        self._going.add(going)
        going.add_done_callback(self._going.discard)
        return going

    async def _computed(self, worker: WorkerProcess, question: PageQuestion) -> Reply:
        """Have a question answered by a process that is free, and let it be free again."""
        try:
            async with asyncio.timeout(self._longest):
                return await worker.reply(question)
        except TimeoutError:  # which is an OSError, too
            await self._replace(worker)
            return given_up(self._longest)
        except asyncio.CancelledError:
            await self._replace(worker)
            raise
        except GONE:
            await self._replace(worker)
            if self._is_over:
                return _ended()
            return process_ended()
        finally:
            self._give_back(worker)

    async def _replace(self, worker: WorkerProcess) -> None:
        """Take a process away and start another for it; one that cannot be started is tried again when it is needed."""
        await worker.end()
        if not self._is_over:
            with suppress(OSError):
                await worker.start()

    async def _free_worker(self, case: Case | None) -> WorkerProcess | None:
        """Find a process that is free, best one that has the machine, or wait for one; None where all has ended.

        Where each is at a long question, another one is started: who asks a short one does not wait for these.
        """
        if self._idle:
            worker = next((one for one in self._idle if case in one.cases), self._idle[-1])
            self._idle.remove(worker)
            return worker
        turn: asyncio.Future[WorkerProcess | None] = asyncio.get_running_loop().create_future()
        self._waiting.append(turn)
        try:
            while not (await asyncio.wait((turn,), timeout=_PATIENCE))[0]:
                are_long = all(one.has_taken > _PATIENCE for one in self._all)
                if are_long and len(self._all) < 2 * self.n_at_once:
                    self._all.append(WorkerProcess())
                    self._waiting.remove(turn)
                    return self._all[-1]
            return turn.result()
        except asyncio.CancelledError:
            if not turn.done():
                self._waiting.remove(turn)
            elif worker := turn.result():
                self._give_back(worker)
            raise

    def _give_back(self, worker: WorkerProcess) -> None:
        """Hand a process on to whoever waits longest, or keep it; of more than there were at first, end it."""
        if self._waiting:
            self._waiting.popleft().set_result(worker)
            return
        if len(self._all) > self.n_at_once:
            self._all.remove(worker)
            self._going.add(ending := asyncio.ensure_future(worker.end()))
            ending.add_done_callback(self._going.discard)
        else:
            self._idle.append(worker)


def _ended() -> Reply:
    return refusal_of(503, _("has ended"))
