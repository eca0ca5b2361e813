"""The server under a service: it ends at once, whatever is being computed."""

import socket

import uvicorn
from fastapi import FastAPI

from cranktrain.web.workers import Replying

_LAST = 1
"""How long it waits at its end for browsers that hold on to it. [s]"""


class Server(uvicorn.Server):
    """Serves pages until Ctrl-C."""

    def __init__(self, app: FastAPI, replying: Replying) -> None:
        super().__init__(
            uvicorn.Config(
                app,
                loop="asyncio",  # others that may be installed, as uvloop, start no processes apart
                ws="none",
                log_level="error",
                access_log=False,
                timeout_graceful_shutdown=_LAST,
            )
        )
        self._replying = replying

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        """End; whoever still waits for what is computed is said so first, else it would be waited for."""
        await self._replying.stop()
        await super().shutdown(sockets)
