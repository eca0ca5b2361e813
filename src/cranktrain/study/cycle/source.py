"""Source of the cycle of one design: a module of plain loops over the kernels of just those kinds that a machine has.

What differs among machines of one structure, throws, orders, counts of cylinders, is an array of the loops and never
stands in the source.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from cranktrain.study.cycle.chambers import branch_from, nearer, toward_end
from cranktrain.study.cycle.curves import branch_lines, fill_lines
from cranktrain.study.cycle.lines import CRANK, Imports, in_names, indented, member_lines, taken_by
from cranktrain.study.cycle.loops import (
    directions,
    keep_panels,
    own_edges,
    push_on,
    shows,
    tell_chambers,
    tell_given,
    tell_joints,
    tell_rods,
    tell_running,
    tell_torque,
)
from cranktrain.study.cycle.panels import cut_cycle, sorted_edges
from cranktrain.study.cycle.repeats import first_chambers, times_repeated
from cranktrain.study.cycle.structure import CycleStructure, KindSource, kernels


class WrittenLoops(NamedTuple):
    """Source of a module, and the functions of the package that it calls.

    Attributes
    ----------
    source : str
    calls : tuple of functions
    takes : tuple of str
        What its loop is given after the first and the last design.
    """

    source: str
    calls: tuple[Callable[..., Any], ...]
    takes: tuple[str, ...]


def written_cycle(structure: CycleStructure) -> WrittenLoops:
    """Write the module whose function `cycle` fills `Found` for designs from `first` up to `last`."""
    imports, called = Imports(), kernels(structure)
    volume = _volume(structure, imports)
    lines = _cycle(structure, taken_by(volume), imports)
    takes = (*taken_by(lines), *(["alike"] if structure.may_repeat else []), "nodes", "panels")
    body = [
        *_kernels(called, (*_PARTS, *_tellers(structure)), imports),
        *_function("@part", "volume_at(design, chamber, angle, {given})", taken_by(volume), volume),
        *branch_lines(structure),
        *_function("@loop", "cycle(first, last, {given})", takes, lines),
    ]
    return WrittenLoops(_put_together(imports, body), tuple(called.values()), takes)


def written_turning(kinds: Sequence[KindSource]) -> WrittenLoops:
    """Write the module whose function `turning_points` finds where pistons turn back."""
    imports = Imports()
    called = {f"motion_{place}": one.kind.motion for place, one in enumerate(kinds) if one.has_pistons}
    lines = list(_turning(kinds, imports))
    takes = (*taken_by(lines), "around", "found")
    loop = _function("@loop", "turning_points(first, last, {given})", takes, lines)
    source = _put_together(imports, [*_kernels(called, (toward_end,), imports), *loop])
    return WrittenLoops(source, tuple(called.values()), takes)


def _function(how: str, head: str, takes: Sequence[str], lines: Sequence[str]) -> Iterator[str]:
    """Lines of a function that is given parts of tuples, each by a name of its own."""
    if not lines:
        return
    yield how
    yield f"def {head.format(given=', '.join(each.replace('.', '_') for each in takes))}:"
    yield from in_names(lines)
    yield ""
    yield ""


def _put_together(imports: Imports, body: Sequence[str]) -> str:
    """Put a module together."""
    head = [
        '"""Loops for the structure of a machine; docs/scale."""',
        "",
        "import numpy as np",
        "",
        *imports.lines(),
        "from cranktrain.study.cycle.chambers import NEARLY, SETTLED, STEPS, TURN",
        "from cranktrain.study.cycle.compiling import Direction, called, kernel, loop, part",
        "from cranktrain.study.cycle.loops import FINEST",
        "",
    ]
    return "\n".join([*head, *body[:-1]])


_PARTS = (branch_from, nearer, cut_cycle, directions, first_chambers, own_edges, push_on, shows, sorted_edges)
"""What is the same for all machines, whatever is asked."""


def _kernels(
    called: Mapping[str, Callable[..., Any]], parts: Sequence[Callable[..., Any]], imports: Imports
) -> Iterator[str]:
    """Compiled kernels by their names, and what else is called."""
    for name, kernel in called.items():
        yield f"{name} = kernel({imports.name(kernel)})"
    for part in parts:
        yield f"{part.__name__} = called({imports.name(part)})"
    yield ""
    yield ""


def _volume(structure: CycleStructure, imports: Imports) -> list[str]:
    """Volume of one chamber with its derivatives; nothing where there is none."""
    return list(_volume_lines(structure, imports)) if structure.fluids else []


def _volume_lines(structure: CycleStructure, imports: Imports) -> Iterator[str]:
    yield "    value, first, second = room.start[design, chamber], 0.0, 0.0"
    yield "    cos, sin = np.cos(angle), np.sin(angle)"
    for place, one in enumerate(structure.kinds):
        if not one.has_pistons:
            continue
        yield f"    for member in range(k{place}.mechanism.size):"
        yield "        for partner in range(2):"
        yield f"            piston = k{place}.piston[member]"
        yield "            area = room.area[design, chamber, partner]"
        yield "            if area != 0.0 and room.partner[chamber, partner] == piston:"
        yield from indented(member_lines(place, one, imports), 4)
        yield f"                motion = motion_{place}({CRANK}, size)"
        yield "                value += area * (room.top[design, piston] - motion.slider.value)"
        yield "                first -= area * motion.slider.first"
        yield "                second -= area * motion.slider.second"
    yield "    return value, first, second"


def _turning(kinds: Sequence[KindSource], imports: Imports) -> Iterator[str]:
    """Dead centres of all pistons: the best of some points of the turn, and Newton's method from there."""
    yield "    for design in range(first, last):"
    for place, one in enumerate(kinds):
        if not one.has_pistons:
            continue
        motion = f"motion = motion_{place}({CRANK}, size)"
        yield f"        for member in range(k{place}.mechanism.size):"
        yield from indented(member_lines(place, one, imports), 3)
        yield "            for end in range(2):"
        yield "                sign, best, angle = 1.0 - 2.0 * end, -np.inf, 0.0"
        yield "                for point in range(around.shape[1]):"
        yield "                    cos, sin = around[1, point], around[2, point]"
        yield f"                    {motion}"
        yield "                    if sign * motion.slider.value > best:"
        yield "                        best, angle = sign * motion.slider.value, around[0, point]"
        yield "                cos, sin = np.cos(angle), np.sin(angle)"
        yield f"                {motion}"
        yield "                for _step in range(STEPS):"
        yield "                    move = toward_end(sign, motion.slider.first, motion.slider.second, around)"
        yield "                    angle += move"
        yield "                    cos, sin = np.cos(angle), np.sin(angle)"
        yield f"                    {motion}"
        yield "                    if abs(move) < SETTLED:"
        yield f"                        found[design, k{place}.piston[member], end, 0] = angle"
        yield f"                        found[design, k{place}.piston[member], end, 1] = motion.slider.value"
        yield "                        break"


def _tellers(structure: CycleStructure) -> Iterator[Callable[..., Any]]:
    """What tells the facts that are asked for."""
    yield from (call for ask, call in _TOLD.items() if ask in structure.asks)
    if structure.may_repeat:
        yield times_repeated
    if structure.needs_inertia:
        yield tell_running
    if "given" in structure.asks:
        yield tell_given
    if "points" in structure.asks:
        yield keep_panels


def _cycle(structure: CycleStructure, of_volume: Sequence[str], imports: Imports) -> list[str]:
    """The loop over designs."""
    gas = _GAS.format(of_volume=", ".join(of_volume)) if structure.fluids else ""
    curves = [curve for ask, curve in _CURVES.items() if ask in structure.asks]
    shown = " and ".join(f"shows({curve}, cut)" for curve in ("work.torque[:1]", *curves))
    repeats = "times_repeated(design, alike, turning.cycle, work.repeats)" if structure.may_repeat else "1"
    return _CYCLE.format(
        gas=gas,
        fill="\n".join(indented(fill_lines(structure, imports), 4)),
        shown=shown,
        told="\n".join(indented(_telling(structure), 5)),
        repeats=repeats,
    ).splitlines()


def _telling(structure: CycleStructure) -> Iterator[str]:
    """Lines that tell the facts that are asked for, and whether all of them are known."""
    for ask, call in _TOLD.items():
        if ask in structure.asks:
            curves = ", ".join(f"work.{curve}" for curve in _TOLD_OF[ask])
            yield f"{call.__name__}(cut, {curves}, work.tops, found.{ask}[design])"
    yield "is_known = True"
    if structure.needs_inertia:
        yield "found.work[design], is_known = tell_running("
        yield "    cut, speed, wanted.inertia[design], wanted.coefficient[design], work.running, work.tops,"
        yield "    found.running[design], found.flywheel[design],"
        yield ")"
    if "given" in structure.asks:
        yield "is_known = is_known and tell_given("
        yield "    cut, speed, wanted.coefficient[design], work.running, work.tops, work.speeds, found.flywheel[design]"
        yield ")"
    if "points" in structure.asks:
        yield "if is_known:"
        yield "    found.n_panels[design] = keep_panels("
        yield "        cut, work.push, found.panel[design], found.row[design], found.angle[design], found.push[design]"
        yield "    )"
        yield "    is_known = found.n_panels[design] > 0"
    yield "found.is_known[design] = is_known"


_CURVES = {"pressure": "work.pressure", "joint": "work.joint_x", "rod": "work.rod[1]"}
"""What has to be shown by the panels, besides the torque, by what is asked."""
_TOLD = {"torque": tell_torque, "joint": tell_joints, "pressure": tell_chambers, "rod": tell_rods}
"""What tells the facts that are asked for."""
_TOLD_OF = {"torque": ("torque",), "joint": ("joint_x", "joint_y"), "pressure": ("pressure",), "rod": ("rod",)}
"""Of which curves."""

_CYCLE = """\
    for design in range(first, last):
        speed = turning.speed[design]
        n_repeats = {repeats}
        length = turning.cycle / n_repeats
        first_chambers(n_repeats, work.repeats)
        finer = 1.0
        while finer <= FINEST:
            least, greatest = room.least[design], room.greatest[design]
            n_edges, n_poles = own_edges(least, greatest, turning.cycle, work.repeats.is_first, panels.edge, work.pole)
{gas}\
            n_edges = sorted_edges(panels.edge, n_edges, length)
            poles, away = work.pole[:n_poles], work.away[:n_poles]
            n_panels, n_points = cut_cycle(panels, n_edges, length, poles, away, finer, nodes)
            if n_panels > 0:
{fill}
                if {shown}:
{told}
                    break
            finer *= 2.0"""

_GAS = """\
            place = 0
            for chamber in range(room.partner.shape[0]):
                if not work.repeats.is_first[chamber]:
                    continue
                top = least[chamber]
                smallest, _slope, bend = volume_at(design, chamber, top, {of_volume})
                work.away[place] = np.sqrt(2.0 * smallest / bend)
                place += 1
                for kink in range(room.sense.size):
                    volume, sense = room.kink[design, chamber, kink], room.sense[kink]
                    if volume > smallest:
                        away = min(np.sqrt(2.0 * (volume - smallest) / bend), 0.75 * np.pi)
                        for _step in range(STEPS):
                            now, rate, bending = volume_at(design, chamber, top + sense * away, {of_volume})
                            before = away
                            away = nearer(away, sense, now - volume, rate, bending)
                            if abs(away - before) < NEARLY:
                                break
                        other = 0.0 if room.turn[kink] > 0.0 else TURN
                        panels.edge[n_edges] = top + other + sense * away
                        n_edges += 1
"""
