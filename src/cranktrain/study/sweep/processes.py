"""Processes that compute blocks of designs; what one of them leaves when it is killed, another one does."""

from contextlib import AbstractContextManager, suppress
from multiprocessing import get_context
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from signal import SIG_IGN, SIGINT, signal
from typing import NamedTuple

from cranktrain.errors import InputError, Problem
from cranktrain.language import _
from cranktrain.study.facts_of_rows import FactsOfRows
from cranktrain.study.sweep.crew import TRIES, Compute, Span

_GONE = 2.0
"""So long a process has to end by itself. [s]"""


class _Block(NamedTuple):
    number: int
    span: Span


class _Worker:
    """A process, and the block that it has."""

    def __init__(self, compute: Compute) -> None:
        context = get_context("spawn")
        self.connection, other = context.Pipe()
        self.process: SpawnProcess = context.Process(target=_work, args=(compute, other), daemon=True)
        self.process.start()
        other.close()  # else nobody would see that the process is gone
        self.block: _Block | None = None
        self.is_ready = False

    def end(self) -> None:
        """Take the process away."""
        self.connection.close()
        self.process.kill()
        self.process.join(_GONE)


class Processes(AbstractContextManager["Processes"]):
    """Processes beside this one, each with a pipe of its own: of one that is killed is known which block it had.

    Parameters
    ----------
    compute : callable
        What makes facts of a span of designs.
    n_at_once : int
    """

    def __init__(self, compute: Compute, n_at_once: int) -> None:
        self.n_at_once = n_at_once
        self._compute = compute
        self._workers: list[_Worker] = []
        self._waiting: list[_Block] = []
        self._lost: list[_Block] = []
        self._kills: dict[int, int] = {}
        self._stillborn = 0
        self._is_tried = False

    def __enter__(self) -> "Processes":
        return self

    def __exit__(self, *_raised: object) -> None:
        for worker in self._workers:
            worker.end()
        self._workers.clear()

    def take(self, number: int, span: Span) -> None:
        """Take a block over; a process is started where all have one."""
        self._waiting.append(_Block(number, span))
        self._hand_out()

    def finished(self) -> list[tuple[int, FactsOfRows | None]]:
        """Wait until some block is finished, or given up."""
        while True:
            woken = wait([end for worker in self._workers for end in (worker.connection, worker.process.sentinel)])
            found: list[tuple[int, FactsOfRows | None]] = []
            for worker in list(self._workers):
                if worker.connection in woken or worker.process.sentinel in woken:
                    found += self._heard(worker)
            found += [(block.number, None) for block in self._lost]
            self._lost.clear()
            self._hand_out()
            if found:
                return found

    def _hand_out(self) -> None:
        """Give each block that waits to a process that has none."""
        while len(self._workers) < min(self.n_at_once, len(self._waiting) + self._n_at_work()):
            self._workers.append(self._started())
        for worker in self._workers:
            if self._waiting and worker.is_ready and worker.block is None:
                worker.block = self._waiting.pop(0)
                with suppress(OSError):  # one that is gone is seen by its end
                    worker.connection.send(worker.block.span)

    def _n_at_work(self) -> int:
        return sum(worker.block is not None for worker in self._workers)

    def _started(self) -> _Worker:
        try:
            return _Worker(self._compute)
        except OSError as error:
            raise _not_started(self.n_at_once, str(error.strerror)) from None

    def _heard(self, worker: _Worker) -> list[tuple[int, FactsOfRows | None]]:
        """What a process says that has something to say, or has ended."""
        try:
            if worker.connection.poll():
                said = worker.connection.recv()
                if isinstance(said, BaseException):
                    raise said
                if not worker.is_ready:
                    worker.is_ready = self._is_tried = True
                    return []
                assert worker.block is not None  # of which else did it speak
                number, worker.block = worker.block.number, None
                return [(number, said)]
            if worker.process.is_alive():
                return []
        except (EOFError, ConnectionError):
            pass
        self._bury(worker)
        return []

    def _bury(self, worker: _Worker) -> None:
        """Give the block of a process that is gone back to those that wait, unless it was tried often enough."""
        worker.end()
        self._workers.remove(worker)
        if not worker.is_ready and not self._is_tried:
            self._stillborn += 1
            if self._stillborn >= max(TRIES, self.n_at_once):
                raise _not_started(self.n_at_once, _("they end before they begin"))
        if worker.block is None:
            return
        kills = self._kills[worker.block.number] = self._kills.get(worker.block.number, 0) + 1
        if kills < TRIES:
            self._waiting.insert(0, worker.block)
        else:
            self._lost.append(worker.block)


def _not_started(n_processes: int, why: object) -> InputError:
    allowed = _("cannot be started: {why}", why=why)
    repair = _('ask for fewer; in a script what asks for them stands below `if __name__ == "__main__":`')
    return InputError([Problem("processes", str(n_processes), allowed, repair)])


def _work(compute: Compute, connection: "Connection[object, Span]") -> None:
    """Compute what comes, until nobody is there any more."""
    signal(SIGINT, SIG_IGN)  # Ctrl-C is for who waits: it reaches all processes of a terminal
    with suppress(EOFError, ConnectionError, OSError):
        connection.send(None)
        while True:
            span = connection.recv()
            try:
                found: object = compute(span)
            except Exception as error:  # is raised where it is waited for
                found = error
            connection.send(found)
