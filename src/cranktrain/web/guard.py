"""What stands before a service: it lets in who may ask, and says to browsers what a page may do.

A service answers to its own host name alone, so that no other page of a browser reaches it under a name of its own, and
what it sends forbids a browser to ask anybody else. One that listens to other computers asks for a token, too.
"""

import secrets
from collections.abc import Awaitable, Callable, MutableMapping
from ipaddress import ip_address
from typing import Any, NamedTuple, TypeAlias

from fastapi import Request
from fastapi.responses import Response

from cranktrain.language import Words, _
from cranktrain.web.asked import Reply
from cranktrain.web.refusals import refusal_of

MOST_BYTES = 256_000
"""Of a request: the text of a machine file, and of the files that it names."""

# Of ASGI.
_Event: TypeAlias = MutableMapping[str, Any]
_Receive: TypeAlias = Callable[[], Awaitable[_Event]]
_Send: TypeAlias = Callable[[_Event], Awaitable[None]]
_Application: TypeAlias = Callable[[_Event, _Receive, _Send], Awaitable[None]]

_OWN_COMPUTER = ("127.0.0.1", "localhost", "::1")
_ANY_ADDRESS = ("0.0.0.0", "::")
_POLICY = "; ".join(
    (
        "default-src 'none'",
        "script-src 'self'",
        "style-src 'self' 'unsafe-inline'",  # widths of cursors
        "img-src 'self' data:",
        "connect-src 'self'",
        "base-uri 'none'",
        "form-action 'none'",
        "frame-ancestors 'none'",
    )
)
_HEADERS = {
    "Content-Security-Policy": _POLICY,
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-store",
}


class Door(NamedTuple):
    """Where a service listens, and what whoever asks has to know."""

    host: str = _OWN_COMPUTER[0]
    token: str | None = None

    @property
    def is_open(self) -> bool:
        """Whether other computers reach it."""
        try:
            return not ip_address(self.host).is_loopback
        except ValueError:
            return self.host not in _OWN_COMPUTER

    def has_name(self, name: str) -> bool:
        """Whether it is meant by the name of a host; of all addresses each number is, and no name but its own."""
        if name.casefold() in (self.host.casefold(), *_OWN_COMPUTER):
            return True
        try:
            ip_address(name)
        except ValueError:
            return False
        return self.host in _ANY_ADDRESS


def response_of(reply: Reply) -> Response:
    """Give a reply as a browser takes it."""
    return Response(reply.content, reply.status, media_type=reply.sort)


class Guard:
    """Stands before an application of ASGI."""

    def __init__(self, app: _Application, door: Door) -> None:
        self._app = app
        self._door = door

    async def __call__(self, scope: _Event, receive: _Receive, send: _Send) -> None:
        """Refuse who may not ask; else hand on, with what a page may do in every answer."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        request = Request(scope)
        cookie = f"cranktrain-{(scope.get('server') or ('', ''))[1]}"  # services on other ports have their own
        shown = request.query_params.get("token")
        refused = self._refused(request, shown or request.cookies.get(cookie))

        async def sent(message: _Event) -> None:
            if message["type"] == "http.response.start":
                headers = dict(_HEADERS)
                if shown and not refused:
                    headers["Set-Cookie"] = f"{cookie}={shown}; HttpOnly; SameSite=Strict; Path=/"
                message["headers"] = [
                    *message["headers"],
                    *((name.lower().encode(), value.encode()) for name, value in headers.items()),
                ]
            await send(message)

        await (response_of(refusal_of(*refused)) if refused else self._app)(scope, receive, sent)

    def _refused(self, request: Request, token: str | None) -> tuple[int, Words] | None:
        """Say why a request is refused, if it is."""
        headers = request.headers
        host, origin = headers.get("host", ""), headers.get("origin")
        length = headers.get("content-length", "0")
        if not self._door.has_name(_name_in(host)):
            return 400, _("answers to {host} alone", host=self._door.host)
        if origin is not None and origin.partition("://")[2] != host:
            return 403, _("takes no request from another page")
        if not self._is_known(token or headers.get("authorization", "").removeprefix("Bearer ")):
            return 401, _("needs the token of the address that `cranktrain web` said: open that, or send it along")
        if not length.isdecimal() or int(length) > MOST_BYTES or "transfer-encoding" in headers:
            return 413, _("is too long: what is sent may have {n} kB, and says how many", n=MOST_BYTES // 1000)
        return None

    def _is_known(self, token: str) -> bool:
        """Whether a token is right; how long this takes does not tell how much of it is."""
        right = self._door.token
        return right is None or secrets.compare_digest(token.encode(errors="replace"), right.encode())


def _name_in(host: str) -> str:
    """Give the name of a host without its port."""
    return host[1:].rpartition("]")[0] if host.startswith("[") else host.partition(":")[0]
