"""`web`: the page in a browser, served to this computer alone unless another host is named."""

import errno
import secrets
import socket
import sys
import threading
import webbrowser
from collections.abc import Iterator

from cranktrain.cli.options import n_processors
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.extras import lacking
from cranktrain.language import said as _

_PORT, _MOST_PORTS = 8765, 20
"""First port, and how many behind it are tried where others have it."""


def serve(file: str | None, port: int | None, host: str, *, opens: bool) -> None:
    """Serve pages until Ctrl-C.

    Parameters
    ----------
    file : str or None
        A machine file, or the name of an example, that the page shows first.
    port : int or None
        The first that is free unless given.
    host : str
        Name or address of this computer at which it listens. Where others reach it, whoever asks needs a token.
    opens : bool
        Whether a browser is opened.

    Raises
    ------
    InputError
        If a package is missing, the port is taken, the host is not this computer, or the machine file is wrong.
    """
    refuse(problem for package in ("fastapi", "uvicorn") for problem in lacking(package, "web"))
    if file is not None:
        from cranktrain.io.machine_file import read_machine  # who only serves reads nothing

        read_machine(file, partial=True)
    from cranktrain.web.guard import Door
    from cranktrain.web.server import Server
    from cranktrain.web.service import service
    from cranktrain.web.workers import Workers

    bound = _bound(host, port)
    door = Door(host)
    if door.is_open:
        door = Door(host, secrets.token_urlsafe(24))
        open_to = _("! whoever reaches {host} and knows this address may ask; what is sent can be read on the way")
        print(open_to.format(host=host), file=sys.stderr)
    workers = Workers(n_processors())
    server = Server(service(file, replying=workers, door=door), workers)
    address = _address(host, bound.getsockname()[1], door.token)
    print(_("the page is at {address}; Ctrl-C ends it", address=address), flush=True)
    if opens:
        threading.Timer(0.3, webbrowser.open, [address]).start()
    server.run(sockets=[bound])


def _address(host: str, port: int, token: str | None) -> str:
    """Give what is typed into a browser; of a service at all addresses of this computer by the computer's name."""
    name = socket.gethostname() if host in ("0.0.0.0", "::") else f"[{host}]" if ":" in host else host
    return f"http://{name}:{port}/" + (f"?token={token}" if token else "")


def _bound(host: str, port: int | None) -> socket.socket:
    """Take a port of this computer."""
    try:
        family, *_sort, place = socket.getaddrinfo(host, None, type=socket.SOCK_STREAM)[0]
    except (socket.gaierror, UnicodeError):
        raise InputError([_no_host(host)]) from None
    for number in _ports(port):
        # Only of one that is named as TCP's does asyncio send answers at once; else their last part waits up to 40 ms.
        one = socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)
        one.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            one.bind((place[0], number, *place[2:]))
            one.listen()  # a browser that is quicker than the service waits for it
        except (OSError, OverflowError) as error:
            one.close()
            if isinstance(error, OSError) and error.errno == errno.EADDRNOTAVAIL:
                raise InputError([_no_host(host)]) from None
        else:
            return one
    allowed = _("is taken, or may not be used") if port is not None else _("no port is free from {first}", first=_PORT)
    raise InputError([Problem("--port", None if port is None else str(port), allowed, _("name another: --port 8900"))])


def _no_host(host: str) -> Problem:
    return Problem("--host", host, _("is no name or address of this computer"), _("--host 0.0.0.0 is all it has"))


def _ports(port: int | None) -> Iterator[int]:
    """Give the ports that are tried."""
    if port is None:
        yield from range(_PORT, _PORT + _MOST_PORTS)
    else:
        yield port
