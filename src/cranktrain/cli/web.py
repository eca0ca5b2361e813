"""`web`: the page in a browser, served to this computer alone."""

import socket
import threading
import webbrowser
from collections.abc import Iterator

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.extras import imported, lacking
from cranktrain.io.machine_file import read_machine
from cranktrain.language import said as _

_HOST, _PORT, _MOST_PORTS = "127.0.0.1", 8765, 20
"""First port, and how many behind it are tried where others have it."""
_LAST = 1
"""How long it waits at its end for browsers that hold on to it. [s]"""


def serve(file: str | None, port: int | None, *, opens: bool) -> None:
    """Serve pages until Ctrl-C.

    Parameters
    ----------
    file : str or None
        A machine file, or the name of an example, that the page shows first.
    port : int or None
        The first that is free unless given.
    opens : bool
        Whether a browser is opened.

    Raises
    ------
    InputError
        If a package is missing, the port is taken, or the machine file is wrong.
    """
    refuse(problem for package in ("fastapi", "uvicorn") for problem in lacking(package, "web"))
    if file is not None:
        read_machine(file, partial=True)
    bound = _bound(port)
    address = f"http://{_HOST}:{bound.getsockname()[1]}/"
    uvicorn = imported("uvicorn", "web")
    from cranktrain.web.service import service

    settings = uvicorn.Config(service(file), log_level="error", access_log=False, timeout_graceful_shutdown=_LAST)
    server = uvicorn.Server(settings)
    print(_("the page is at {address}; Ctrl-C ends it", address=address), flush=True)
    if opens:
        threading.Timer(0.3, webbrowser.open, [address]).start()
    server.run(sockets=[bound])


def _bound(port: int | None) -> socket.socket:
    """Take a port of this computer."""
    for number in _ports(port):
        one = socket.socket()
        one.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            one.bind((_HOST, number))
            one.listen()  # a browser that is quicker than the service waits for it
        except (OSError, OverflowError):
            one.close()
        else:
            return one
    allowed = _("is taken, or may not be used") if port is not None else _("no port is free from {first}", first=_PORT)
    raise InputError([Problem("--port", None if port is None else str(port), allowed, _("name another: --port 8900"))])


def _ports(port: int | None) -> Iterator[int]:
    """Give the ports that are tried."""
    if port is None:
        yield from range(_PORT, _PORT + _MOST_PORTS)
    else:
        yield port
