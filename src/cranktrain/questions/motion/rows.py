"""What motion says in the answer: strokes, dead centres, speeds, swings of rockers, how near links are to parting."""

from collections.abc import Iterator

import numpy as np

from cranktrain.language import _
from cranktrain.mechanisms.output import SliderWords
from cranktrain.numerics.ties import first_smallest
from cranktrain.questions.motion.closing import Closing
from cranktrain.questions.motion.dead_centres import DeadCentres
from cranktrain.questions.motion.outputs import members_by_output
from cranktrain.questions.motion.pistons import PistonSpeeds
from cranktrain.questions.motion.rocker_load import LoadMotion
from cranktrain.questions.motion.rockers import DeadPositions
from cranktrain.questions.motion.rods import RodMotion
from cranktrain.saying.rows import Amount, AnswerLine, Extent, valued, worded
from cranktrain.saying.wording import Names, around_turn

_ON_AXIS = np.radians(0.005)
"""A dead centre so near the axis is shown as on it. [rad]"""
_NEAR = 0.2
"""A closing margin that is more says nothing of most machines."""


def slider_rows(
    labels: Names, design: int, centres: DeadCentres, speeds: PistonSpeeds | None, rods: RodMotion | None
) -> Iterator[AnswerLine]:
    """Strokes, dead centres and speeds: of pistons, of rams, of valves."""
    for output, own in members_by_output(centres.outputs):
        words = output.words
        assert words is not None  # of sliders
        names = [labels["piston"][int(member)] for member in own]
        yield valued(_(words.stroke), centres.stroke[design, own], "m", names)
        if not np.any(np.isfinite(centres.stroke[design, own])):
            yield worded(_("stroke"), _("none: the links do not close all round"))
            continue
        shifts = (centres.top_shift[design, own], centres.bottom_shift[design, own])
        if any(np.any(np.abs(shift) > _ON_AXIS) for shift in shifts):
            yield valued(_(words.top), shifts[0], "rad", names, _(words.after_top))
            if output.is_loaded:
                yield valued(_(words.bottom), shifts[1], "rad", names)
        if speeds is not None:
            yield from _speed_rows(names, design, speeds, own, words, is_loaded=output.is_loaded)
        if rods is not None and output.is_loaded:
            largest = np.fmax(
                np.abs(rods.largest_pressure_angle.value[design, own]),
                np.abs(rods.opposite_pressure_angle.value[design, own]),
            )
            yield valued(_("largest pressure angle"), largest, "rad", names)


def _speed_rows(
    names: list[str], design: int, speeds: PistonSpeeds, own: np.ndarray, words: SliderWords, *, is_loaded: bool
) -> Iterator[AnswerLine]:
    """Mean and largest speed, and largest acceleration of either sense; of what carries no load the largest speed."""
    fastest = speeds.largest_piston_speed.value[design, own]
    if is_loaded:
        yield valued(_(words.mean_speed), speeds.mean_piston_speed[design, own], "m/s", names)
    yield valued(_(words.largest_speed), fastest, "m/s", names)
    if not is_loaded:
        return
    acceleration = np.maximum(
        speeds.largest_piston_acceleration.value[design, own], -speeds.smallest_piston_acceleration.value[design, own]
    )
    yield valued(_("largest acceleration"), acceleration, "m/s^2", names)


def rocker_rows(
    labels: Names, design: int, dead: DeadPositions, load: LoadMotion | None, closing: Closing | None
) -> Iterator[AnswerLine]:
    """Swing and dead positions of rockers, and the travel of what hangs on them."""
    names = labels["rocker"]
    if closing is not None and np.all(np.isnan(dead.swing[design])) and np.all(closing.closing_margin[design] > 0):
        yield worded(_("rocker"), _("turns all round"))
        return
    lowest, highest = dead.smallest_rocker_angle.value[design], dead.largest_rocker_angle.value[design]
    ends = {"least": Amount(float(lowest[0]), "rad"), "most": Amount(float(highest[0]), "rad")}
    words = _(", from {least} to {most}") if len(names) == 1 else ""
    yield valued(_("swing of the rocker"), dead.swing[design], "rad", names, words, **ends)
    least, most = dead.smallest_rocker_angle.angle[design], dead.largest_rocker_angle.angle[design]
    for name, *angles in zip(names[:_FEW], least, most, strict=False):
        first, second = (Amount(float(one), "position") for one in around_turn(np.array(angles)))
        said = _("{first} and {second} of the crank") if len(names) == 1 else _("{first} and {second} ({rocker})")
        yield worded(_("dead positions"), said, first=first, second=second, rocker=name)
    yield valued(_("time ratio"), dead.time_ratio[design], "1", names)
    if load is not None:
        factors = load.smallest_torque_factor[design], load.largest_torque_factor[design]
        yield valued(_("stroke of the load"), load.load_stroke[design], "m", names)
        yield worded(
            _("torque factor"),
            "{factor}",
            factor=Extent(float(np.fmin.reduce(factors[0])), float(np.fmax.reduce(factors[1])), "m"),
        )


_FEW = 2
"""So many rockers have a line each."""


def closing_rows(labels: Names, design: int, closing: Closing) -> Iterator[AnswerLine]:
    """The least margin before links part, where it is a small one."""
    margins = closing.closing_margin[design]
    if np.all(np.isnan(margins)) or np.nanmin(margins) > _NEAR:
        return
    least = first_smallest(margins)
    name = labels["mechanism"][least]
    yield valued(
        _("closing margin"),
        margins[least],
        "%",
        (),
        _("of {length}, at {angle}") if len(margins) == 1 else _("of {name} {length}, at {angle}"),
        name=name,
        length=_(closing.length_names[design][least]),
        angle=Amount(float(around_turn(closing.closing_angle[design, least])), "position"),
    )
