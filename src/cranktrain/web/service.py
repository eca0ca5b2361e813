"""The service of pages: a machine and numbers set anew in, what a page shows out. It keeps nothing between requests.

It answers to its own host name alone, so that no other page of a browser reaches it under a name of its own, and what
it sends forbids a browser to ask anybody else.
"""

import json
import struct
from collections.abc import Awaitable, Callable, Iterator, Sequence
from html import escape
from importlib.resources import files
from typing import Annotated, Any

from fastapi import FastAPI, Request
from fastapi.concurrency import run_in_threadpool
from fastapi.exceptions import RequestValidationError
from fastapi.middleware.trustedhost import TrustedHostMiddleware
from fastapi.responses import HTMLResponse, JSONResponse, PlainTextResponse, Response
from pydantic import BaseModel, Field

from cranktrain.errors import InputError, Problem, refuse
from cranktrain.io.examples import example_names
from cranktrain.language import _
from cranktrain.paths import parts_of
from cranktrain.version import VERSION
from cranktrain.web.case import Case
from cranktrain.web.packed import Packed

_HOSTS = ("127.0.0.1", "localhost")
_MOST_BYTES = 64_000
"""Of a request: numbers set anew, and the name of an example."""
_MOST_SETTINGS, _LONGEST = 100, 500

_FILE_KEY = "file"
"""Of tables of a machine file that name another."""

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
_PAGE = """<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>cranktrain</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="app.css">
<main id="page" data-file="{file}"></main>
<script src="app.js"></script>
</html>
"""


class CaseAsked(BaseModel):
    """A machine, and numbers set anew."""

    machine: Annotated[
        str, Field(max_length=_LONGEST, description="Name of an example; empty for the served file.")
    ] = ""
    settings: Annotated[
        list[Annotated[str, Field(max_length=_LONGEST)]],
        Field(max_length=_MOST_SETTINGS, description="PATH=VALUE, such as shaft.main.speed=1800 rpm."),
    ] = []


class PageAsked(CaseAsked):
    """A machine, and which tab is open."""

    tab: Annotated[str, Field(max_length=_LONGEST, description="By its name; the first where there is none of it.")] = (
        ""
    )
    beside: Annotated[CaseAsked | None, Field(description="A saved case that stands beside it.")] = None


class ProblemSaid(BaseModel):
    """One thing that is wrong: where, what was given, what is allowed, what to write instead."""

    path: str
    given: str | None
    allowed: str
    repair: str | None


class ExampleNamed(BaseModel):
    """An example by its name."""

    name: str


_NUMBERS: dict[str, Any] = {"response_class": Response, "responses": {422: {"model": list[ProblemSaid]}}}
"""Of what gives packed data: its answers."""


def service(file: str | None = None) -> FastAPI:
    """Make the service.

    Parameters
    ----------
    file : str, optional
        A machine file that it serves beside the examples.
    """
    app = FastAPI(title="cranktrain", version=VERSION, docs_url=None, redoc_url=None)
    app.add_middleware(TrustedHostMiddleware, allowed_hosts=list(_HOSTS))
    app.middleware("http")(_guarded)
    app.exception_handler(InputError)(_refused)
    app.exception_handler(RequestValidationError)(_malformed)
    known = frozenset(example_names())

    def case_of(asked: CaseAsked) -> Case:
        """Find what is meant: what is sent never becomes the name of a file."""
        refuse(_naming_files(asked.settings))
        source = asked.machine if asked.machine in known else file if not asked.machine else None
        if source is not None:
            return Case(source, tuple(asked.settings))
        allowed = _("must be one of the examples: {names}", names=", ".join(sorted(known)))
        raise InputError([Problem("machine", asked.machine, allowed)])

    def saved_of(asked: PageAsked) -> Case | None:
        """Find the saved case that is to stand beside."""
        return None if asked.beside is None else case_of(asked.beside)

    @app.get("/", response_class=HTMLResponse, include_in_schema=False)
    def _page() -> str:
        return _PAGE.format(file="" if file is None else escape(file, quote=True))

    @app.get("/{name}.{kind}", include_in_schema=False)
    def _built(name: str, kind: str) -> Response:
        if (name, kind) not in (("app", "js"), ("app", "css")):
            return Response(status_code=404)
        text = (files("cranktrain.web") / "built" / f"{name}.{kind}").read_text(encoding="utf-8")
        return Response(text, media_type={"js": "text/javascript", "css": "text/css"}[kind])

    @app.get("/api/examples")
    def _examples() -> list[ExampleNamed]:
        return [ExampleNamed(name=name) for name in sorted(known)]

    @app.post("/api/case", **_NUMBERS)
    async def _case(asked: PageAsked) -> Response:
        """Give a machine as a page shows it with one tab open: a length, so much JSON, and the numbers of arrays."""
        return _numbers(await run_in_threadpool(case_of(asked).packed_page, asked.tab, saved_of(asked)))

    @app.post("/api/tab", **_NUMBERS)
    async def _tab(asked: PageAsked) -> Response:
        """Give what stands on a tab."""
        return _numbers(await run_in_threadpool(case_of(asked).packed_tab, asked.tab, saved_of(asked)))

    @app.post("/api/trust", **_NUMBERS)
    async def _trust(asked: CaseAsked) -> Response:
        """Give what is to be minded of a machine, and its checks: everything that it allows is computed for these."""
        return _numbers(await run_in_threadpool(case_of(asked).packed_trust))

    @app.post("/api/file", response_class=PlainTextResponse, responses={422: {"model": list[ProblemSaid]}})
    async def _file(asked: CaseAsked) -> str:
        """Give the machine file with the numbers in place, its comments where they were."""
        return await run_in_threadpool(lambda: case_of(asked).text)

    return app


def _naming_files(settings: Sequence[str]) -> Iterator[Problem]:
    """Refuse what would have a file read: a key that names one, or a table in which such a key may stand."""
    for setting in settings:
        path, _equals, value = setting.partition("=")
        if _FILE_KEY in parts_of(path.strip()) or "{" in value:
            yield Problem(path, None, _("may be a number or a word here, and no file or table"))


def _numbers(found: Packed) -> Response:
    """Give JSON behind its length, filled up with spaces to whole numbers, and the numbers."""
    text = json.dumps(found.data, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    content = struct.pack("<I", len(text)) + text + found.numbers.astype("<f4").tobytes()
    return Response(content, media_type="application/octet-stream")


async def _guarded(request: Request, call_next: Callable[[Request], Awaitable[Response]]) -> Response:
    """Refuse what is too large or comes from another page; say to the browser what a page may do."""
    length = request.headers.get("content-length", "0")
    origin = request.headers.get("origin")
    if not length.isdecimal() or int(length) > _MOST_BYTES or "transfer-encoding" in request.headers:
        answer = Response(status_code=413)
    elif origin is not None and origin.partition("://")[2] != request.headers.get("host"):
        answer = Response(status_code=403)
    else:
        answer = await call_next(request)
    for name, value in _HEADERS.items():
        answer.headers[name] = value
    return answer


def _refused(_request: Request, error: Any) -> Response:
    """Say all that is wrong with a machine."""
    return _problems([_said(problem) for problem in error.problems])


def _malformed(_request: Request, error: Any) -> Response:
    """Say what of a request is wrong; nothing of it is quoted."""
    return _problems(
        [
            ProblemSaid(path=".".join(map(str, one["loc"])), given=None, allowed=str(one["msg"]), repair=None)
            for one in error.errors()
        ]
    )


def _problems(found: Sequence[ProblemSaid]) -> Response:
    return JSONResponse([one.model_dump() for one in found], status_code=422)


def _said(problem: Problem) -> ProblemSaid:
    """Say a problem, in the language and the units of whoever asks."""
    given, repair = (None if words is None else str(words) for words in (problem.given, problem.repair))
    return ProblemSaid(path=problem.path, given=given, allowed=str(problem.allowed), repair=repair)
