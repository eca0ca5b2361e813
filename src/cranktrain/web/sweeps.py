"""Sweeps that a service computes while others ask it: each in a process of its own, known by its number alone."""

import asyncio
import secrets

from cranktrain.web.asked import HowFar, Reply, SweepQuestion
from cranktrain.web.refusals import given_up, process_ended
from cranktrain.web.worker_process import GONE, WorkerProcess

_LONGEST = 600.0
"""After which a sweep is given up. [s]"""
_KEPT = 600.0
"""So long one is kept for which nobody asks. [s]"""
_MOST, _AT_ONCE = 20, 2
"""So many are known, and so many are computed at once."""


class _Going:
    """A sweep: how far it is, and what came of it."""

    def __init__(self) -> None:
        self.how_far = HowFar()
        self.reply: Reply | None = None
        self.work: asyncio.Task[None] | None = None
        self.forgotten: asyncio.TimerHandle | None = None


class Sweeps:
    """Sweeps by their numbers, which nobody else can guess."""

    def __init__(self, longest: float = _LONGEST, kept: float = _KEPT) -> None:
        self._longest, self._kept = longest, kept
        self._all: dict[str, _Going] = {}
        self._room = asyncio.Semaphore(_AT_ONCE)

    def begin(self, question: SweepQuestion) -> str | None:
        """Take a sweep on, and give its number; None where there are too many."""
        if len(self._all) >= _MOST:
            return None
        number, going = secrets.token_urlsafe(12), _Going()
        self._all[number] = going
        going.work = asyncio.ensure_future(self._computed(going, question))
        self._remember(number, going)
        return number

    def reply(self, number: str) -> Reply | HowFar | None:
        """Give what came of a sweep, or how far it is; None of one that is not known."""
        going = self._all.get(number)
        if going is None:
            return None
        self._remember(number, going)
        return going.how_far if going.reply is None else going.reply

    def end(self, number: str) -> bool:
        """Stop a sweep and forget it; whether there was one."""
        going = self._all.pop(number, None)
        if going is not None and going.work is not None and going.reply is None:
            going.work.cancel()
        return going is not None

    async def stop(self) -> None:
        """End all."""
        work = [going.work for going in self._all.values() if going.work is not None]
        for number in list(self._all):
            self.end(number)
        await asyncio.gather(*work, return_exceptions=True)

    def _remember(self, number: str, going: _Going) -> None:
        """Keep a sweep for a while from now on."""
        if going.forgotten is not None:
            going.forgotten.cancel()
        going.forgotten = asyncio.get_running_loop().call_later(self._kept, self.end, number)

    async def _computed(self, going: _Going, question: SweepQuestion) -> None:
        """Compute a sweep when there is room for it."""
        async with self._room:
            worker = WorkerProcess()

            def heard(how_far: HowFar) -> None:
                going.how_far = how_far

            try:
                async with asyncio.timeout(self._longest):
                    going.reply = await worker.reply(question, heard)
            except TimeoutError:  # which is an OSError, too
                going.reply = given_up(self._longest)
            except GONE:
                going.reply = process_ended()
            finally:
                await worker.end()
