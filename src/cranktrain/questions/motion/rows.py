"""What motion says in the answer: strokes, dead centres, speeds, swings of rockers, how near links are to parting."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from cranktrain.grouping import grouped
from cranktrain.language import N_, Listed, Message, Words, _
from cranktrain.mechanisms.output import SliderWords
from cranktrain.numerics.ties import first_smallest
from cranktrain.questions.motion.closing import Closing
from cranktrain.questions.motion.dead_centres import DeadCentres
from cranktrain.questions.motion.outputs import members_by_output
from cranktrain.questions.motion.pistons import PistonSpeeds
from cranktrain.questions.motion.point_paths import PointPaths
from cranktrain.questions.motion.ranges import CrankRanges, PointRanges
from cranktrain.questions.motion.rocker_load import LoadMotion
from cranktrain.questions.motion.rockers import DeadPositions
from cranktrain.questions.motion.rods import RodMotion
from cranktrain.saying.amounts import Amount, Extent
from cranktrain.saying.rows import AnswerLine, Telling, worded
from cranktrain.saying.wording import around_turn

_ON_AXIS = np.radians(0.005)
"""A dead centre so near the axis is shown as on it. [rad]"""
_QUICK = 1.1
"""A time ratio from which on a ram, or a tool, is quick on one of its ways."""
_NEAR = 0.2
"""A closing margin that is more says nothing of most machines."""


def slider_rows(
    of: Telling, centres: DeadCentres, speeds: PistonSpeeds | None, rods: RodMotion | None
) -> Iterator[AnswerLine]:
    """Strokes, dead centres and speeds: of pistons, of rams, of valves."""
    for output, own in members_by_output(centres.outputs):
        words = output.words
        assert words is not None  # of sliders
        stroke = of.row(_(words.stroke), centres, "stroke", own=own)
        yield stroke
        if not np.any(np.isfinite(stroke.values)):
            yield worded(_("stroke"), _("none: the links do not close all round"))
            continue
        top = of.row(_(words.top), centres, "top_shift", _(words.after_top), own=own)
        bottom = of.row(_(words.bottom), centres, "bottom_shift", own=own)
        if any(np.any(np.abs(shift.values) > _ON_AXIS) for shift in (top, bottom)):
            yield top
            if output.is_loaded:
                yield bottom
        is_tool = output.is_loaded and not output.has_chambers
        if is_tool and np.any(of.values(centres, "stroke_time_ratio")[own] > _QUICK):
            yield of.row(_("time ratio"), centres, "stroke_time_ratio", own=own)
        if speeds is not None:
            yield from _speed_rows(of, speeds, own, words, is_loaded=output.is_loaded)
        if rods is not None and output.is_loaded:
            yield _larger(
                of, _("largest pressure angle"), rods, "largest_pressure_angle", "opposite_pressure_angle", own
            )


def _speed_rows(
    of: Telling, speeds: PistonSpeeds, own: NDArray[np.intp], words: SliderWords, *, is_loaded: bool
) -> Iterator[AnswerLine]:
    """Mean and largest speed, and largest acceleration of either sense; of what carries no load the largest speed."""
    if is_loaded:
        yield of.row(_(words.mean_speed), speeds, "mean_piston_speed", own=own)
    yield of.row(_(words.largest_speed), speeds, "largest_piston_speed", own=own)
    if is_loaded:
        ends = ("largest_piston_acceleration", "smallest_piston_acceleration")
        yield _larger(of, _("largest acceleration"), speeds, *ends, own)


def _larger(of: Telling, name: Words, found: object, quantity: str, opposite: str, own: NDArray[np.intp]) -> AnswerLine:
    """Give the larger size of the ends of a curve."""
    row, other = (of.row(name, found, one, own=own) for one in (quantity, opposite))
    return replace(row, values=np.fmax(np.abs(row.values), np.abs(other.values)))


def rocker_rows(
    of: Telling, dead: DeadPositions, load: LoadMotion | None, closing: Closing | None
) -> Iterator[AnswerLine]:
    """Swing and dead positions of rockers, and the travel of what hangs on them."""
    names = of.labels["rocker"]
    if (
        closing is not None
        and np.all(np.isnan(of.values(dead, "swing")))
        and np.all(of.values(closing, "closing_margin") >= 0)
    ):
        yield worded(_("rocker"), _("turns all round"))
        return
    ends = _(
        "{values}, from {least} to {most}",
        least=of.amount(dead, "smallest_rocker_angle", 0),
        most=of.amount(dead, "largest_rocker_angle", 0),
    )
    yield of.row(_("swing of the rocker"), dead, "swing", ends if len(names) == 1 else None)
    for place, name in enumerate(names[:_FEW]):
        positions = (of.amount(dead, f"{end}_rocker_angle_at", place) for end in ("smallest", "largest"))
        first, second = (replace(one, value=float(around_turn(np.array(one.value)))) for one in positions)
        said = _("{first} and {second} of the crank") if len(names) == 1 else _("{first} and {second} ({rocker})")
        yield worded(_("dead positions"), said.format(first=first, second=second, rocker=name))
    yield of.row(_("time ratio"), dead, "time_ratio")
    if load is not None:
        yield of.row(_("stroke of the load"), load, "load_stroke")
        least, most = "smallest_torque_factor", "largest_torque_factor"
        ends = (float(np.fmin.reduce(of.values(load, least))), float(np.fmax.reduce(of.values(load, most))))
        yield worded(_("torque factor"), Extent(*ends, "m", quantity=f"{least} {most}"))


_FEW = 2
"""So many rockers have a line each."""


def point_rows(of: Telling, paths: PointPaths) -> Iterator[AnswerLine]:
    """How long the paths are of points that the file asks to follow, how far they go, and how long they stay."""
    asked = [place for place, is_joint in enumerate(paths.is_joint) if not is_joint][:_FEW]
    for place in asked:
        if not np.isfinite(of.values(paths, "point_path_length")[place]):
            continue
        x, y = (of.extent(paths, f"smallest_point_{one}", f"largest_point_{one}", place) for one in "xy")
        length = of.amount(paths, "point_path_length", place)
        words = _("{length}, x {x}, y {y}", length=length, x=x, y=y)
        if np.isfinite(of.values(paths, "point_band_share")[place]):
            share = of.amount(paths, "point_band_share", place, unit="%")
            words = _("{words}; {share} of the turn at its end", words=words, share=share)
        yield worded(_("path of {point}", point=of.labels["point"][place].rpartition(".")[2]), words)


def range_rows(of: Telling, found: CrankRanges, points: PointRanges | None) -> Iterator[AnswerLine]:
    """Over which angles a crank goes that cannot turn all round, what blocks it, and how far links and points go."""
    names = of.labels["mechanism"]
    for place, blocked in found.blocked[of.design].items():
        goes, is_blocked = _("crank goes"), _("blocked by")
        if len(names) > 1:
            goes = _("crank of {mechanism} goes", mechanism=names[place])
            is_blocked = _("{mechanism} blocked by", mechanism=names[place])
        if not blocked:
            yield worded(goes, _("nowhere: the links close at no angle"))
        ends = ("crank_range_start", "crank_range_end")
        each = [[of.amount(found, end, place, number, unit="rad") for end in ends] for number in range(len(blocked))]
        yield worded(goes, Listed([_("{start} to {end}", start=start, end=end) for start, end in each]))
        said = _("{before} before, {behind} behind")
        parts = [said.format(before=before, behind=behind) for before, behind in blocked if before]
        yield worded(is_blocked, Listed(parts, "; "))
    yield from _extents(of, found, "ranged_link", link_angle=_("{link_angle}"))
    if points is not None:
        yield from _extents(of, points, "point", point_x=_("x {point_x}"), point_y=_("y {point_y}"))


def _extents(of: Telling, found: object, dimension: str, **said: Message) -> Iterator[AnswerLine]:
    """How far some parts go, over each range of the crank: messages by the quantity's name."""
    for place, name in enumerate(of.labels[dimension][:_MOST_EXTENTS]):
        each = [
            Listed(
                [
                    words.format(**{one: of.extent(found, f"{one}_from", f"{one}_to", place, number)})
                    for one, words in said.items()
                ]
            )
            for number in range(len(of.labels["crank_range"]))
            if np.isfinite(of.values(found, f"{next(iter(said))}_from")[place, number])
        ]
        own = name.rpartition(".")[2] if len(of.labels["mechanism"]) == 1 else name
        yield worded(_("{part} goes", part=own), Listed(each, "; "))


_MOST_EXTENTS = 8
"""Links, or points, that have a line each."""


_PASSED = {
    "parallelogram": N_("as a parallelogram"),
    "crossed": N_("as a crossed parallelogram"),
    "kite": N_("as a kite"),
}


def closing_rows(of: Telling, closing: Closing) -> Iterator[AnswerLine]:
    """The least margin before links part, where it is a small one; and the change points that links pass."""
    for place, passed in closing.passed.items():
        angles = passed.angle[of.design]
        places = [Amount(angle, "position", "closing_angle") for angle in angles[np.isfinite(angles)].tolist()]
        at = Listed(places)
        name = _("change points")
        if len(of.labels["mechanism"]) > 1:
            name = _("change points of {mechanism}", mechanism=of.labels["mechanism"][place])
        for form, joints in grouped((form, joint) for joint, form in passed.forms.items()).items():
            words = _("{at}; passed {form}", at=at, form=_(_PASSED[form]))
            joint = ", ".join(filter(None, joints))
            yield worded(name, _("{words}: {joint}", words=words, joint=joint) if joint else words)
    if closing.passed:
        return
    margins = of.values(closing, "closing_margin")
    if np.all(np.isnan(margins)) or np.nanmin(margins) > _NEAR:
        return
    least = first_smallest(margins)
    at = of.amount(closing, "closing_angle", least)
    said = _("{values} of {length}, at {angle}") if len(margins) == 1 else _("{values} of {name} {length}, at {angle}")
    words = said.format(
        name=of.labels["mechanism"][least],
        length=_(closing.length_names[of.design][least]),
        angle=replace(at, value=float(around_turn(np.array(at.value)))),
    )
    yield of.row(_("closing margin"), closing, "closing_margin", words, own=[least], unit="%")
