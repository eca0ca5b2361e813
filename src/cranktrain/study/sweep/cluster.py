"""A cluster that computes blocks of designs: its scheduler's workers do what processes do otherwise."""

import logging
from contextlib import AbstractContextManager, suppress
from queue import Empty, SimpleQueue
from socket import create_connection
from threading import Lock
from typing import Any

from cranktrain.errors import InputError, Problem
from cranktrain.extras import imported
from cranktrain.language import _
from cranktrain.study.facts_of_rows import FactsOfRows
from cranktrain.study.sweep.crew import Compute, Span

_ANSWERS = 10.0
"""So long a scheduler has to answer. [s]"""
_LOOK = 2.0
"""How often it is looked whether it is still there. [s]"""
_FOR_EACH = 2
"""Blocks that are handed over for each thread of the cluster, so that none waits for this process."""
_one_at_a_time = Lock()


class Cluster(AbstractContextManager["Cluster"]):
    """Workers of a scheduler of Dask.

    Parameters
    ----------
    compute : callable
        What makes facts of a span of designs; each task has it with it: a worker that joins later needs nothing else.
    scheduler : str or distributed.Client
        Its address, `tcp://HOST:8786`; or whoever knows it, who is left open.

    Raises
    ------
    InputError
        If distributed is not installed, or no scheduler answers.
    """

    def __init__(self, compute: Compute, scheduler: object) -> None:
        self._distributed = imported("distributed", "scheduler", _("ask for processes"))
        if not isinstance(scheduler, str | self._distributed.Client):
            allowed = _("must be the address of a scheduler, or a client of Dask's that knows one")
            raise InputError([Problem("scheduler", repr(scheduler), allowed)])
        self._compute = compute
        self._is_own = isinstance(scheduler, str)
        self._address = str(scheduler) if self._is_own else "scheduler"
        self._client: Any = self._joined(scheduler) if isinstance(scheduler, str) else scheduler
        self._futures: dict[Any, int] = {}
        self._done: SimpleQueue[Any] = SimpleQueue()

    @property
    def n_at_once(self) -> int:
        """How many blocks may be handed over: more when workers join."""
        with suppress(OSError, TimeoutError):
            return max(1, _FOR_EACH * sum(self._client.nthreads().values()))
        raise self._gone()

    def __exit__(self, *_raised: object) -> None:
        futures, self._futures = list(self._futures), {}
        with suppress(Exception):  # of one that is gone nothing can be taken back
            self._client.cancel(futures, force=True)
        if self._is_own:
            with suppress(Exception), _silent():
                self._client.close(timeout=_LOOK)

    def take(self, number: int, span: Span) -> None:
        """Hand a block over."""
        future = self._client.submit(_computed, self._compute, span, pure=False)
        self._futures[future] = number
        future.add_done_callback(self._done.put)

    def finished(self) -> list[tuple[int, FactsOfRows | None]]:
        """Wait for blocks; of one whose workers were killed as often as the scheduler lets them there is none."""
        while True:
            with suppress(Empty):
                found = [self._done.get(timeout=_LOOK)]
                with suppress(Empty):
                    while True:
                        found.append(self._done.get_nowait())
                return [(self._futures.pop(future), self._facts(future)) for future in found]
            if self._client.status != "running":
                raise self._gone()

    def _facts(self, future: Any) -> FactsOfRows | None:
        """What a task gave."""
        if future.status not in ("finished", "error"):
            raise self._gone()
        try:
            return future.result(timeout=_ANSWERS)
        except self._distributed.KilledWorker:
            return None
        except ImportError as error:
            repair = _("install the same version there as here")
            raise self._refused(_("has workers without what it takes: {why}", why=str(error)), repair) from None
        except (OSError, TimeoutError, self._distributed.CancelledError):
            raise self._gone() from None

    def _joined(self, address: str) -> Any:
        """Join a scheduler."""
        try:
            # A client that nobody answers would wait once more when it is taken away.
            host, port = self._distributed.comm.get_address_host_port(address)
            create_connection((host, port), timeout=_ANSWERS).close()
            with _silent():
                return self._distributed.Client(address, timeout=_ANSWERS, set_as_default=False)
        except (OSError, TimeoutError, ValueError):
            repair = _("start one with `dask scheduler`, and name it as it says: tcp://HOST:8786")
            raise self._refused(_("no scheduler answers there"), repair) from None

    def _gone(self) -> InputError:
        repair = _("start it anew; with a store what was computed is kept, and --resume goes on")
        return self._refused(_("the scheduler is gone, or has let its tasks go"), repair)

    def _refused(self, allowed: object, repair: object) -> InputError:
        return InputError([Problem("scheduler", self._address, str(allowed), str(repair))])


class _silent(AbstractContextManager[None]):  # noqa: N801 - is read as a verb
    """Keep distributed from telling the terminal what is told in a sentence."""

    def __enter__(self) -> None:
        self._logger = logging.getLogger("distributed")
        self._level = self._logger.level
        self._logger.setLevel(logging.CRITICAL + 1)

    def __exit__(self, *_raised: object) -> None:
        self._logger.setLevel(self._level)


def _computed(compute: Compute, span: Span) -> FactsOfRows:
    """Compute a block on a worker, one at a time in each process, however many threads it has."""
    with _one_at_a_time:
        return compute(span)
