"""The service of pages: a machine and numbers set anew in, what a page shows out. It keeps nothing between requests."""

import asyncio
import re
from collections.abc import AsyncGenerator, Callable
from contextlib import AbstractContextManager, asynccontextmanager
from html import escape
from importlib.resources import files
from typing import Any

from fastapi import FastAPI, Request
from fastapi.exceptions import HTTPException, RequestValidationError
from fastapi.middleware.gzip import GZipMiddleware
from fastapi.responses import HTMLResponse, JSONResponse, PlainTextResponse, Response

from cranktrain.errors import InputError, Problem
from cranktrain.io.examples import example_names
from cranktrain.language import Words, _, in_language, languages, spoken_language
from cranktrain.version import VERSION
from cranktrain.web.asked import HowFar, PageQuestion, Part, Reply, SweepQuestion
from cranktrain.web.guard import Door, Guard, response_of
from cranktrain.web.refusals import ProblemSaid, refusal_of, refused, too_much_to_do
from cranktrain.web.requests import (
    CaseAsked,
    ExampleNamed,
    ExportAsked,
    FileAsked,
    PageAsked,
    SweepAsked,
    SweepGoing,
    SweepTaken,
    ThrowAsked,
    WhenceAsked,
    question_of,
    sweep_of,
)
from cranktrain.web.sweeps import Sweeps
from cranktrain.web.workers import InThisProcess, Replying

_LEAST_COMPRESSED, _QUICKLY = 1000, 1
"""Bytes of an answer from which on it is compressed, and how hard: harder takes more time and hardly less room."""

_SETTING = re.compile(r"([\w.\[\]-]{1,100})=")
"""A number that is set, after its path."""

_PAGE = """<!doctype html>
<html lang="{language}">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>cranktrain</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="app.css">
<main id="page" data-file="{file}"></main>
<script src="app.js"></script>
</html>
"""

_REFUSED: dict[int | str, dict[str, Any]] = {
    status: {"model": list[ProblemSaid], "description": about}
    for status, about in (
        (422, "What is wrong with the machine or the request, all of it."),
        (503, "Was given up, as it took too long or too much was asked at once."),
    )
}
_UNKNOWN: dict[int | str, dict[str, Any]] = {404: {"model": list[ProblemSaid], "description": "Not known any more."}}
_NUMBERS: dict[str, Any] = {
    "response_class": Response,
    "responses": {
        200: {
            "content": {"application/octet-stream": {}},
            "description": "A length n (32 bits, little-endian), n bytes of JSON, then 32-bit numbers, little-endian:"
            " the first bytes of all, then the second ones, the third, the fourth."
            ' In the JSON {"at": first, "shape": [...]} is an array, row by row, which begins at that number.',
        },
        **_REFUSED,
    },
}
"""Of what gives packed data: its answers."""
_FILES: dict[int | str, dict[str, Any]] = {200: {"content": {"application/octet-stream": {}}}, **_REFUSED}
"""Of what gives a file: its answers."""


def service(file: str | None = None, *, replying: Replying | None = None, door: Door | None = None) -> FastAPI:
    """Make the service.

    Parameters
    ----------
    file : str, optional
        A machine file that it serves beside the examples.
    replying : Replying, optional
        Who computes; this process unless given.
    door : Door, optional
        Where it listens, and what whoever asks has to know; this computer's own users ask unless given.
    """
    crew, sweeps = InThisProcess() if replying is None else replying, Sweeps()
    app = FastAPI(title="cranktrain", version=VERSION, docs_url=None, redoc_url=None, lifespan=_running(crew, sweeps))
    app.add_middleware(GZipMiddleware, minimum_size=_LEAST_COMPRESSED, compresslevel=_QUICKLY)
    app.add_middleware(Guard, door=Door() if door is None else door)
    app.exception_handler(RequestValidationError)(_malformed)
    for status in (400, 404, 405):
        app.exception_handler(status)(_unknown)
    known = frozenset(example_names())

    async def answered(request: Request, asked: CaseAsked, part: Part) -> Response:
        with _in_language_of(asked.language):
            try:
                question = question_of(asked, part, known, file)
            except InputError as error:
                return response_of(refused(error.problems))
            return response_of(await _while_waited_for(request, crew.reply(question)))

    @app.get("/", response_class=HTMLResponse, include_in_schema=False)
    def _page() -> str:
        return _PAGE.format(language=spoken_language(), file="" if file is None else escape(file, quote=True))

    @app.get("/{name}.{kind}", include_in_schema=False)
    def _built(name: str, kind: str) -> Response:
        if (name, kind) not in (("app", "js"), ("app", "css")):
            raise HTTPException(404)
        text = (files("cranktrain.web") / "built" / f"{name}.{kind}").read_text(encoding="utf-8")
        return Response(text, media_type={"js": "text/javascript", "css": "text/css"}[kind])

    @app.get("/api/examples")
    def _examples() -> list[ExampleNamed]:
        return [ExampleNamed(name=name) for name in sorted(known)]

    @app.post("/api/case", **_NUMBERS)
    async def _case(request: Request, asked: PageAsked) -> Response:
        """Give a machine as a page shows it with one tab open."""
        return await answered(request, asked, "page")

    @app.post("/api/tab", **_NUMBERS)
    async def _tab(request: Request, asked: PageAsked) -> Response:
        """Give what stands on a tab."""
        return await answered(request, asked, "tab")

    @app.post("/api/others", **_NUMBERS)
    async def _others(request: Request, asked: PageAsked) -> Response:
        """Give the curves that stand on a tab of one piston of all the others."""
        return await answered(request, asked, "others")

    @app.post("/api/trust", **_NUMBERS)
    async def _trust(request: Request, asked: CaseAsked) -> Response:
        """Give what is to be minded of a machine, and its checks: everything that it allows is computed for these."""
        return await answered(request, asked, "trust")

    @app.post("/api/members", **_NUMBERS)
    async def _members(request: Request, asked: ThrowAsked) -> Response:
        """Give pins and links of the drawing over the cycle: places, speeds, directions."""
        return await answered(request, asked, "members")

    @app.post("/api/handles", **_NUMBERS)
    async def _handles(request: Request, asked: ThrowAsked) -> Response:
        """Give the pins of the drawing that may be moved, and which numbers that changes."""
        return await answered(request, asked, "handles")

    @app.post("/api/file", response_class=PlainTextResponse, responses=_REFUSED)
    async def _file(request: Request, asked: FileAsked) -> Response:
        """Give the machine file with the numbers in place, its comments where they were, and with another table."""
        return await answered(request, asked, "file")

    @app.post("/api/whence", **_NUMBERS)
    async def _whence(request: Request, asked: WhenceAsked) -> Response:
        """Give where a number is from: its equation, the stages and the numbers of the file behind it."""
        return await answered(request, asked, "whence")

    @app.post("/api/export", response_class=Response, responses=_FILES)
    async def _export(request: Request, asked: ExportAsked) -> Response:
        """Give a file of what is computed of a machine: tables, its sheet, a page of its own."""
        return await answered(request, asked, "export")

    @app.get("/api/gallery", **_NUMBERS)
    async def _gallery(request: Request, language: str = "") -> Response:
        """Give machines to begin with, each with a small drawing."""
        with _in_language_of(language):
            question = PageQuestion(None, "gallery", language=spoken_language())
            return response_of(await _while_waited_for(request, crew.reply(question)))

    _add_sweeps(app, sweeps, lambda asked: sweep_of(asked, known, file))
    return app


def _add_sweeps(app: FastAPI, sweeps: Sweeps, question_of_sweep: Callable[[SweepAsked], SweepQuestion]) -> None:
    """Let sweeps be begun, asked for and ended."""

    @app.post("/api/sweep", status_code=202, response_model=SweepTaken, responses=_REFUSED)
    async def _begin(asked: SweepAsked) -> Any:
        """Begin to compute facts over values of the file; gives a number by which it is asked for."""
        with _in_language_of(asked.language):
            try:
                number = sweeps.begin(question_of_sweep(asked))
            except InputError as error:
                return response_of(refused(error.problems))
            return response_of(too_much_to_do()) if number is None else SweepTaken(number=number)

    @app.get("/api/sweep/{number}", responses={**_NUMBERS["responses"], 202: {"model": SweepGoing}, **_UNKNOWN})
    async def _reply(number: str) -> Response:
        """Give how far a sweep is (202), or what is varied and the facts over it."""
        found = sweeps.reply(number)
        if found is None:
            raise HTTPException(404)
        if isinstance(found, HowFar):
            return JSONResponse(found._asdict(), status_code=202)
        return response_of(found)

    @app.delete("/api/sweep/{number}", status_code=204, responses=_UNKNOWN)
    async def _end(number: str) -> None:
        """Stop a sweep, and forget it."""
        if not sweeps.end(number):
            raise HTTPException(404)


def _in_language_of(name: str) -> AbstractContextManager[None]:
    """Say what is said to whoever asks in their language, where there is one of the name."""
    return in_language(name if name in languages() else None)


def _running(crew: Replying, sweeps: Sweeps) -> Callable[[FastAPI], Any]:
    """Have those who compute as long as the service runs."""

    @asynccontextmanager
    async def running(_app: FastAPI) -> AsyncGenerator[None]:
        await crew.start()
        try:
            yield
        finally:
            await sweeps.stop()
            await crew.stop()

    return running


async def _while_waited_for(request: Request, replying: Any) -> Reply:
    """Wait for a reply as long as whoever asked does."""
    reply, gone = asyncio.ensure_future(replying), asyncio.ensure_future(_gone(request))
    try:
        await asyncio.wait((reply, gone), return_when=asyncio.FIRST_COMPLETED)
        return reply.result() if reply.done() else refusal_of(499, _("nobody waits for it"))
    finally:
        reply.cancel()
        gone.cancel()


async def _gone(request: Request) -> None:
    """Wait until whoever asked is gone."""
    while (await request.receive())["type"] != "http.disconnect":
        pass


def _malformed(_request: Request, error: Any) -> Response:
    """Say what of a request is wrong; nothing of it is quoted but the path of a number."""
    return response_of(refused(Problem(_place_of(one), None, _allowed_of(one)) for one in error.errors()))


def _place_of(one: dict[str, Any]) -> str:
    """Where something malformed stands: of a number that is set its path, so that it is told beside its field."""
    where = ".".join(map(str, one["loc"][1:] or one["loc"]))
    setting = _SETTING.match(str(one["input"])) if where.startswith("settings.") else None
    return setting[1] if setting else where


def _allowed_of(one: dict[str, Any]) -> Words:
    """What would be right in its place."""
    most = one.get("ctx", {}).get("max_length")
    if one["type"] == "string_too_long":
        return _("is too long: it may have {n} characters", n=most)
    if one["type"] == "too_long":
        return _("is too much at once: {n} may be sent", n=most)
    return str(one["msg"])


def _unknown(_request: Request, error: Any) -> Response:
    """Say that there is nothing of that name, or that it is not asked so."""
    return response_of(refusal_of(error.status_code, str(error.detail)))
