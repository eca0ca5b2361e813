"""`plot`: a machine as a sheet, a plan, a moving picture or a DXF; the file's name says which."""

import logging
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import PurePath
from typing import TYPE_CHECKING, Literal, TypeAlias

from cranktrain.cli.running_speed import OPTION, told_at_option
from cranktrain.cli.speed_curve import OPTION as SPEED_CURVE
from cranktrain.cli.speed_curve import speed_settings, told_as_typed
from cranktrain.errors import InputError, Position, Problem
from cranktrain.io.machine_file import MachineFile, computed, read_machine
from cranktrain.language import _
from cranktrain.one_line import one_line
from cranktrain.quantities import Dimension, QuantityError, read, shown, unlisted

if TYPE_CHECKING:
    from cranktrain.viz.paper.page import Figure

Angles: TypeAlias = int | Sequence[float]
"""How many crank angles over a turn, or which. [deg]"""

PLANS = {
    "positions": "plan_positions",
    "velocities": "plan_velocities",
    "accelerations": "plan_accelerations",
    "klein": "plan_klein",
    "centres": "plan_centres",
    "forces": "plan_forces",
    "zhukovsky": "plan_zhukovsky",
    "polar": "plan_polar",
    "arc": "plan_arc",
    "projection": "plan_projection",
    "brix": "plan_brix",
    "brix-backward": "plan_brix_backward",
    "wittenbauer": "plan_wittenbauer",
    "mertsalov": "plan_mertsalov",
}
"""Plans by name: what of `cranktrain.viz` draws them."""

_WHOLE_CYCLE = ("wittenbauer", "mertsalov")
"""Plans of the machine over its cycle, not of one mechanism at some angles."""

_AT_A_SPEED = ("positions", "velocities", "accelerations", "forces", "zhukovsky", "polar")
"""Plans that another speed of the crank changes."""
SHEETS_OF = {"machine": "sheet", "forces": "sheet_forces"}
"""Sheets by name: what of `cranktrain.viz` draws them."""

SOURCE_ANGLES = "source"
"""What `--at` says for the twelve positions of [slider-crank-synthesis]."""

SHEETS, ANIMATION, DRAWING = (".png", ".svg", ".pdf"), ".gif", ".dxf"
SUFFIXES = (*SHEETS, ANIMATION, DRAWING)

_TWELVE = ("positions", "arc", "projection", "brix")
"""Plans that can have the source's twelve positions."""

_SIZES = ("A4", "A3")
_POSITIONS = 12
"""Of a DXF, unless said otherwise."""

_DIGITS = 9
"""Of a crank angle in degrees, so that 30 deg stay 30."""


@dataclass(frozen=True)
class Request:
    """What is asked of `plot`, as typed."""

    file: str
    settings: tuple[str, ...] = ()
    is_partial: bool = False
    output: str | None = None
    force: bool = False
    plan: str | None = None
    at: str | None = None
    mechanism: str | None = None
    size: str | None = None
    sheet: str | None = None
    is_at_running_speed: bool = False
    speed_curve: str | None = None


@dataclass(frozen=True)
class Picture:
    """What is drawn: the file's name and ending, and the request as it was understood; None for what was not said."""

    output: str
    suffix: str
    plan: str | None
    angles: Angles | None
    mechanism: str | None
    size: str
    is_at_source_angles: bool = False
    sheet: str = "machine"
    speed: Literal["constant", "running"] = "constant"


def write_picture(request: Request) -> None:
    """Draw and write; say what was written.

    Raises
    ------
    InputError
        With everything that is wrong with the options, else with the machine, else with what cannot be drawn.
    """
    picture = understood(request)
    # What the plotting library says of its fonts and its folder is nothing that a user asked for.
    logging.getLogger("matplotlib").setLevel(logging.ERROR)
    with told_as_typed(request.speed_curve):
        settings = (*request.settings, *speed_settings(request.speed_curve))
        file = read_machine(request.file, settings, partial=request.is_partial)
    try:
        _mechanism_found(file, picture)
        with told_at_option():
            _drawn(file, picture, request)
    except InputError as error:
        raise InputError(_placed(error.problems, file, request)) from None
    print(_("written: {name}").format(name=one_line(picture.output)))


def understood(request: Request) -> Picture:
    """Read the options; refuse those that do not go together.

    Parameters
    ----------
    request : Request

    Returns
    -------
    Picture

    Raises
    ------
    InputError
        With everything that is wrong.
    """
    problems: list[Problem] = []
    suffix = PurePath(request.output or "").suffix.lower()
    if request.output is None:
        name = one_line(PurePath(request.file).stem) or "3d12"
        example = f"cranktrain plot {one_line(request.file) or name} -o {name}.png"
        allowed = _("is missing: the name of the picture, which ends in one of: {suffixes}")
        repair = _("such as: {example}").format(example=example)
        problems.append(Problem("-o", None, allowed.format(suffixes=", ".join(SUFFIXES)), repair))
    elif suffix not in SUFFIXES:
        allowed = _("must end in one of: {suffixes}").format(suffixes=", ".join(SUFFIXES))
        problems.append(Problem("-o", request.output, allowed))
    else:
        problems += _misplaced(request, suffix)
    plan = request.plan and request.plan.strip().casefold()
    if plan is not None and plan not in PLANS:
        problems.append(unlisted("--plan", request.plan, tuple(PLANS)))
    else:
        options = {OPTION: request.is_at_running_speed, SPEED_CURVE: request.speed_curve is not None}
        problems += [
            problem for name, is_so in options.items() if is_so for problem in _speed_misplaced(name, plan, suffix)
        ]
    sheet = (request.sheet or "machine").strip().casefold()
    if sheet not in SHEETS_OF:
        problems.append(unlisted("--sheet", request.sheet or "", tuple(SHEETS_OF)))
    size = (request.size or _SIZES[0]).strip().upper()
    if size not in _SIZES:
        problems.append(unlisted("--size", request.size, _SIZES))
    is_at_source_angles = plan in _TWELVE and (request.at or "").strip().casefold() == SOURCE_ANGLES
    angles = None
    try:
        angles = (
            None if is_at_source_angles else _angles(request.at, is_count_meant=plan is not None or suffix == DRAWING)
        )
    except InputError as error:
        problems += error.problems
    if problems:
        raise InputError(problems)
    speed = "running" if request.is_at_running_speed else "constant"
    name = request.output or ""
    return Picture(name, suffix, plan, angles, request.mechanism, size, is_at_source_angles, sheet, speed)


def _misplaced(request: Request, suffix: str) -> Iterator[Problem]:
    """Refuse options that mean nothing for the kind of picture."""
    options = {
        "--plan": request.plan,
        "--at": request.at,
        "--mechanism": request.mechanism,
        "--size": request.size,
        "--sheet": request.sheet,
    }
    if suffix == ANIMATION:
        allowed = _("must be left out: a .gif shows one turn of the first throw")
        unused = tuple(options)
    elif suffix == DRAWING:
        allowed = _("must be left out: a .dxf holds all plans, in true millimetres")
        unused = ("--plan", "--size", "--sheet")
    elif request.plan is not None and request.sheet is not None:
        allowed = _("must be left out: a picture is a plan or a sheet")
        unused = ("--sheet",)
    elif request.plan is not None and request.plan.strip().casefold() in _WHOLE_CYCLE:
        allowed = _("must be left out: this plan is of the whole machine over its cycle")
        unused = ("--at", "--mechanism")
    elif request.plan is not None:
        unused, allowed = (), ""
    elif (request.sheet or "").strip().casefold() == "forces":
        allowed = _("must be left out: the sheet of forces has the whole cycle")
        unused = ("--at",)
    else:
        allowed = _("must be left out: a sheet shows the first throw; only a plan or a .dxf is of one mechanism")
        unused = ("--mechanism",)
    yield from (Problem(name, options[name], allowed) for name in unused if options[name] is not None)


def _speed_misplaced(option: str, plan: str | None, suffix: str) -> Iterator[Problem]:
    """Refuse a speed over the cycle for what is alike at every speed, or for what that speed is found from."""
    if suffix == ANIMATION:
        allowed = _("must be left out: a .gif shows positions in even steps of the crank angle")
    elif plan in _WHOLE_CYCLE:
        allowed = _("must be left out: this diagram is what the running speed is found from")
    elif plan == "klein":
        allowed = _("must be left out: Klein's construction is for a crank that turns evenly; ask for accelerations")
    elif plan is not None and plan not in _AT_A_SPEED:
        allowed = _("must be left out: this plan is the same at every speed")
    else:
        return
    yield Problem(option, None, allowed)


def _angles(text: str | None, *, is_count_meant: bool) -> Angles | None:
    """Read crank angles, or where it is meant a count."""
    if text is None:
        return None
    if is_count_meant and text.strip().isdecimal():
        return int(text)
    angles: list[float] = []
    problems: list[Problem] = []
    for part in map(str.strip, text.split(",")):
        quantity = part if part[-1:].isalpha() or part.endswith("°") else f"{part} deg"
        try:
            angles.append(round(shown(read(quantity, Dimension.ANGLE), "deg"), _DIGITS))
        except QuantityError:
            allowed = _("must be crank angles in degrees with commas between, such as 30,60")
            problems.append(Problem("--at", text, allowed))
    if not problems and not is_count_meant and len(angles) > 1:
        problems.append(Problem("--at", text, _("must be one crank angle; for several, ask for a --plan")))
    if problems:
        raise InputError(problems[:1])
    return angles


def _mechanism_found(file: MachineFile, picture: Picture) -> None:
    """Refuse a mechanism that the machine does not have."""
    from cranktrain.plans.placement import place_called

    if picture.mechanism is None:
        return
    try:
        place_called(file.machine, picture.mechanism)
    except InputError as error:
        raise InputError(replace(problem, path="--mechanism") for problem in error.problems) from None


def _drawn(file: MachineFile, picture: Picture, request: Request) -> None:
    """Draw once the file is known to be possible, and write it."""
    from cranktrain.viz import SHEET_QUANTITIES, dxf, save, save_animation

    if picture.suffix == DRAWING:
        angles = _POSITIONS if picture.angles is None else picture.angles
        name, whose = picture.output, picture.mechanism
        dxf(file.machine, angles, name, mechanism=whose, speed=picture.speed, force=request.force)
    elif picture.suffix == ANIMATION:
        result = computed(file, partial=request.is_partial, quantities=SHEET_QUANTITIES)
        save_animation(result, picture.output, force=request.force)
    else:
        save(lambda: _figure(file, picture, request), picture.output, force=request.force)


def _figure(file: MachineFile, picture: Picture, request: Request) -> "Figure":
    """Draw a plan, or the sheet."""
    from cranktrain import viz

    if picture.plan is None:
        if picture.sheet == "forces":
            result = computed(file, speed=picture.speed, partial=request.is_partial)
            return viz.sheet_forces(result, size=picture.size, piston=picture.mechanism)
        quantities = viz.SHEET_QUANTITIES
        result = computed(file, speed=picture.speed, partial=request.is_partial, quantities=quantities)
        if isinstance(picture.angles, Sequence):
            return viz.sheet(result, size=picture.size, at=picture.angles[0])
        return viz.sheet(result, size=picture.size)
    draw: Callable[..., Figure] = getattr(viz, PLANS[picture.plan])
    if picture.plan in _WHOLE_CYCLE:
        return draw(computed(file, partial=request.is_partial), size=picture.size)
    angles = _source_angles(file, picture) if picture.is_at_source_angles else picture.angles
    chosen = {} if angles is None else {"angles": angles}
    at_speed = {"speed": picture.speed} if picture.plan in _AT_A_SPEED else {}
    return draw(file.machine, **chosen, **at_speed, mechanism=picture.mechanism, size=picture.size)


def _source_angles(file: MachineFile, picture: Picture) -> Sequence[float]:
    """Crank angles of the source's positions, counted as the plan counts them."""
    from cranktrain.plans.positions import source_angles

    return source_angles(file.machine, mechanism=picture.mechanism, is_shown=picture.plan == "positions")


def _placed(problems: Sequence[Problem], file: MachineFile, request: Request) -> Iterator[Problem]:
    """Place what cannot be drawn: in the machine file, or at the option that asks for it."""
    for problem in problems:
        if problem.position is not None or problem.path.startswith("-"):
            yield problem
        elif problem.path:
            yield file.document.located([problem])[0]
        else:
            repair = problem.repair
            if request.at is not None and request.at.strip().isdecimal():
                repair = _('for one crank angle, write "{angle} deg"').format(angle=request.at.strip())
            place = Position(file.document.name if request.at is None else "--at")
            yield replace(problem, repair=repair, position=place)
