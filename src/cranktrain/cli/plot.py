"""`plot`: a machine as a sheet, a plan, a moving picture or a DXF; the file's name says which."""

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from math import inf
from pathlib import PurePath
from typing import Any, Literal, NamedTuple, TypeAlias

from cranktrain.analysis import Result
from cranktrain.cli.asked import (
    RUNNING_SPEED,
    SPEED_CURVE,
    AskedAtSpeed,
    at_running_speed,
    in_units_of,
    units_asked_for,
)
from cranktrain.cli.quiet_pictures import hush
from cranktrain.errors import InputError, Position, Problem, problems_as
from cranktrain.extras import lacking_for
from cranktrain.io.machine_file import MachineFile
from cranktrain.language import said as _
from cranktrain.machine import Machine
from cranktrain.one_line import one_line
from cranktrain.panels.picture import Picture
from cranktrain.quantities import Dimension, QuantityError, UnitChoice, read, shown, unlisted
from cranktrain.record import record
from cranktrain.viz import PICTURES, save, save_animation
from cranktrain.viz.output import FORMATS

Angles: TypeAlias = int | list[float] | Literal["source"]
"""How many crank angles over a turn, which [deg], or the twelve positions of [slider-crank-synthesis]."""

_SOURCE = "source"

NAMED = {kind: {one.name: one for one in PICTURES if one.kind == kind} for kind in ("plan", "sheet", "file")}
"""Pictures by their kind and name."""

SUFFIXES = (*FORMATS, *NAMED["file"])

_SIZES = ("A4", "A3")
_SHEET = "machine"
_POSITIONS = 12
"""Of a DXF, unless said otherwise."""

_RIGHT = 90.0

_DIGITS = 9
"""Of a crank angle in degrees, so that 30 deg stay 30."""


@record
class PlotRequest(AskedAtSpeed):
    """What is asked of `plot`, as typed."""

    plan: str | None = None
    at: str | None = None
    mechanism: str | None = None
    size: str | None = None
    sheet: str | None = None
    count: str | None = None
    scale: str | None = None
    letters: str | None = None
    method: str | None = None


class Choice(NamedTuple):
    """A request as it was understood: which picture, at which angles if any were said, on which paper, to which scale.

    permissible is the pressure angle of the source's twelve positions [deg]; scale is metal in one of paper; units are
    those that were asked for.
    """

    picture: Picture
    angles: Angles | None
    size: str
    permissible: float | None = None
    scale: float | None = None
    letters: str | None = None
    method: str | None = None
    units: UnitChoice = {}  # noqa: RUF012 - nobody changes a choice


def write_picture(request: PlotRequest) -> None:
    """Draw and write; say what was written.

    Raises
    ------
    InputError
        With everything that is wrong with the options, else with the machine, else with what cannot be drawn.
    """
    from cranktrain.plans.placement import place_called

    choice = understood(request)
    hush()
    file = request.read()
    with (
        in_units_of(file, choice.units),
        problems_as(partial(_placed, file, request)),
        problems_as(at_running_speed),
        problems_as(partial(_with_texts, file.machine, request)),
    ):
        if request.mechanism is not None:
            with problems_as(lambda problem: replace(problem, path="--mechanism")):
                place_called(file.machine, request.mechanism)
        _draw(file, choice, request)
    print(_("written: {name}", name=one_line(request.output or "")))


def understood(request: PlotRequest) -> Choice:
    """Read the options; refuse those that do not go together.

    Parameters
    ----------
    request : PlotRequest

    Returns
    -------
    Choice

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    suffix = PurePath(request.output or "").suffix.lower()
    problems = list(_output_problems(request, suffix))
    names = {"plan": request.plan, "sheet": request.sheet}
    found = {kind: NAMED[kind].get(name.strip().casefold()) for kind, name in names.items() if name is not None}
    file = NAMED["file"].get(suffix)
    picture = file or next(iter(found.values()), NAMED["sheet"][_SHEET])
    if picture is not None and suffix in SUFFIXES:
        problems += _refused(request, picture)
    if file is None and len(found) > 1:
        problems.append(Problem("--sheet", request.sheet, _("must be left out: a picture is a plan or a sheet")))
    problems += [unlisted(f"--{kind}", names[kind], tuple(NAMED[kind])) for kind, one in found.items() if one is None]
    size = (request.size or _SIZES[0]).strip().upper()
    if size not in _SIZES:
        problems.append(unlisted("--size", request.size, _SIZES))
    angles, permissible, scale, units = None, None, None, {}
    try:
        angles, permissible = _angles(request, picture)
    except InputError as error:
        problems += error.problems
    try:
        scale = None if request.scale is None else read_scale(request.scale)
    except InputError as error:
        problems += error.problems
    try:
        units = units_asked_for(request.units)
    except InputError as error:
        problems += error.problems
    if problems or picture is None:
        raise InputError(problems)
    return Choice(picture, angles, size, permissible, scale, request.letters, request.method, units)


def read_scale(text: str) -> float:
    """Read a scale as drawings have it: 1:4 is 4 of metal in one of paper, 2:1 a half.

    Examples
    --------
    >>> read_scale("1:4"), read_scale("2 : 1")
    (4.0, 0.5)
    """
    paper, _colon, metal = text.partition(":")
    try:
        found = float(metal) / float(paper)
    except (ValueError, ZeroDivisionError):
        found = 0.0
    if not 0.0 < found < inf:
        raise InputError([Problem("--scale", text, _("must be a scale, such as 1:4"))])
    return found


def _output_problems(request: PlotRequest, suffix: str) -> Iterator[Problem]:
    """Refuse a name of the picture that says nothing of its form."""
    if request.output is None:
        name = one_line(PurePath(request.file).stem) or "3d12"
        example = f"cranktrain plot {one_line(request.file) or name} -o {name}.png"
        allowed = _("is missing: the name of the picture, which ends in one of: {suffixes}")
        repair = _("such as: {example}", example=example)
        yield Problem("-o", None, allowed.format(suffixes=", ".join(SUFFIXES)), repair)
    elif suffix not in SUFFIXES:
        allowed = _("must end in one of: {suffixes}", suffixes=", ".join(SUFFIXES))
        yield Problem("-o", request.output, allowed)
    else:
        yield from lacking_for(suffix)


def _refused(request: PlotRequest, picture: Picture) -> Iterator[Problem]:
    """Refuse options that mean nothing for a picture."""
    for option, about, is_typed, given in (
        ("--plan", "plan", request.plan is not None, request.plan),
        ("--at", "at", request.at is not None, request.at),
        ("--count", "at", request.count is not None, request.count),
        ("--mechanism", "mechanism", request.mechanism is not None, request.mechanism),
        ("--size", "size", request.size is not None, request.size),
        ("--sheet", "sheet", request.sheet is not None, request.sheet),
        (RUNNING_SPEED, "speed", request.is_at_running_speed, None),
        (SPEED_CURVE, "speed", request.speed_curve is not None, None),
    ):
        if is_typed and about in picture.refused:
            yield Problem(option, given, _(picture.refused[about]))
    for option, about, given in (
        ("--scale", "scale", request.scale),
        ("--letters", "letters", request.letters),
        ("--method", "method", request.method),
    ):
        if given is not None and about not in picture.takes:
            others = ", ".join(f"{one.kind} {one.name}" for one in PICTURES if about in one.takes)
            yield Problem(option, given, _("must be left out: only for {pictures}", pictures=others))


def _angles(request: PlotRequest, picture: Picture | None) -> tuple[Angles | None, float | None]:
    """Read crank angles, or how many; of the source's the permissible pressure angle, if that is said. [deg]"""
    text = request.at
    if picture is not None and "at" in picture.refused:
        return None, None
    is_plan = picture is None or picture.over == "angles"
    if request.count is not None:
        return _count(request, is_plan=is_plan), None
    if text is None:
        return None, None
    word, _space, rest = text.strip().casefold().partition(" ")
    if picture is not None and picture.source_angles and word == _SOURCE:
        found = _degrees(rest, "--at", text) if rest else []
        if len(found) > 1 or any(not 0.0 < angle < _RIGHT for angle in found):
            raise InputError([Problem("--at", text, _("must be `source` with one angle from 0 to 90°: source 30"))])
        return _SOURCE, next(iter(found), None)
    angles = _degrees(text, "--at", text)
    if not is_plan and len(angles) > 1:
        raise InputError([Problem("--at", text, _("must be one crank angle; for several, ask for a --plan"))])
    return angles, None


def _count(request: PlotRequest, *, is_plan: bool) -> int:
    """Read at how many crank angles."""
    text = (request.count or "").strip()
    if request.at is not None:
        raise InputError([Problem("--count", text, _("must be left out beside --at"))])
    if not is_plan:
        raise InputError([Problem("--count", text, _("must be left out: only a plan or a .dxf is at several"))])
    if not text.isdecimal() or int(text) < 1:
        raise InputError([Problem("--count", text, _("must be a whole number, such as 12"))])
    return int(text)


def _degrees(words: str, option: str, text: str) -> list[float]:
    """Read angles with commas between. [deg]"""
    angles: list[float] = []
    for part in map(str.strip, words.split(",")):
        quantity = part if part[-1:].isalpha() or part.endswith("°") else f"{part} deg"
        try:
            angles.append(round(shown(read(quantity, Dimension.ANGLE), "deg"), _DIGITS))
        except QuantityError:
            allowed = _("must be crank angles in degrees with commas between, such as 30,60")
            raise InputError([Problem(option, text if text.strip() else '""', allowed)]) from None
    return angles


def _draw(file: MachineFile, choice: Choice, request: PlotRequest) -> None:
    """Draw once the file is known to be possible, and write it."""
    from cranktrain.viz.pictures import drawing_of

    picture, name, force = choice.picture, request.output or "", request.force
    if picture.name == ".gif":
        save_animation(_result(file, picture, request), name, force=force, piston=request.mechanism)
    elif picture.name == ".dxf":
        options = {"angles": _POSITIONS} | _of_machine(file, choice, request)
        drawing_of(picture)(file.machine, path=name, **options, force=force)
    elif picture.over == "angles":
        options = _of_machine(file, choice, request) | {"size": choice.size}
        save(lambda: drawing_of(picture)(file.machine, **options), name, force=force)
    else:
        angle = {"at": choice.angles[0]} if isinstance(choice.angles, list) else {}
        whose = {"piston": request.mechanism} if request.mechanism is not None else {}
        options = angle | whose | {"size": choice.size} | _chosen(choice)
        save(lambda: drawing_of(picture)(_result(file, picture, request), **options), name, force=force)


def _result(file: MachineFile, picture: Picture, request: PlotRequest) -> Result:
    """Compute what a picture says that it draws; of one that draws what there is, that is found while it is drawn."""
    return request.result(file, Result.find_all if picture.quantities else None, quantities=picture.quantities)


def _of_machine(file: MachineFile, choice: Choice, request: PlotRequest) -> dict[str, Any]:
    """What is said of a picture at crank angles; a speed only where there is one to be chosen."""
    from cranktrain.plans.positions import source_angles

    angles, mechanism = choice.angles, request.mechanism
    if angles == "source":
        is_shown = choice.picture.source_angles == "shown"
        angles = source_angles(file.machine, mechanism=mechanism, is_shown=is_shown, permissible=choice.permissible)
    options: dict[str, Any] = {"mechanism": mechanism} | ({} if angles is None else {"angles": angles})
    if "speed" not in choice.picture.refused:
        options["speed"] = request.speed
    return options | _chosen(choice)


def _chosen(choice: Choice) -> dict[str, Any]:
    """Scale, letters and methods, where they are said."""
    said = {"scale": choice.scale, "letters": choice.letters, "method": choice.method}
    return {name: value for name, value in said.items() if value is not None}


def _with_texts(machine: Machine, request: PlotRequest, problem: Problem) -> Problem:
    """Say with a problem of what mechanisms a machine has which texts speak of it."""
    from cranktrain.textbook.speaking import with_speaking

    return with_speaking(machine, request.file, request.settings, ("mechanism",))(problem)


def _placed(file: MachineFile, request: PlotRequest, problem: Problem) -> Problem:
    """Place what cannot be drawn: in the machine file, or at the option that asks for it."""
    if problem.path in ("scale", "letters", "method"):
        return replace(problem, path=f"--{problem.path}")
    if problem.position is not None or problem.path.startswith("-"):
        return problem
    if problem.path:
        return file.document.located(problem)
    said = next((name for name, one in (("--at", request.at), ("--count", request.count)) if one is not None), None)
    return replace(problem, position=Position(said or file.document.name))
