"""Source of the cycle of one design: a module of plain loops over the kernels of just those kinds that a machine has.

What differs among machines of one structure, throws, orders, counts of cylinders, is an array of the loops and never
stands in the source.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from cranktrain.fluids import ChamberState
from cranktrain.linkage.forces import Body, Conditions, Drive, Friction, Gravity, Wrench
from cranktrain.study.cycle.chambers import branch_at, nearer, toward_end
from cranktrain.study.cycle.lines import CRANK, Imports, body_lines, indented, member_lines, taken_out
from cranktrain.study.cycle.loops import (
    cut_cycle,
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
from cranktrain.study.cycle.repeats import (
    begin_repeats,
    chambers_repeat,
    first_chambers,
    masters_repeat,
    mechanisms_repeat,
)
from cranktrain.study.cycle.structure import CycleStructure, KindSource, Shape, kernels


class WrittenLoops(NamedTuple):
    """Source of a module, and the functions of the package that it calls."""

    source: str
    calls: tuple[Callable[..., Any], ...]


def written_cycle(structure: CycleStructure) -> WrittenLoops:
    """Write the module whose function `cycle` fills `Found` for designs from `first` up to `last`."""
    imports, called = Imports(), kernels(structure)
    body = [
        *_kernels(called, (*_PARTS, *_tellers(structure)), imports),
        *_volume(structure, imports),
        *_fill(structure, imports),
        *(_repeating(structure) if structure.is_of_shaft else ()),
        *_cycle(structure),
    ]
    return _put_together(imports, body, called)


def written_turning(kinds: Sequence[KindSource]) -> WrittenLoops:
    """Write the module whose function `turning_points` finds where pistons turn back."""
    imports = Imports()
    called = {f"motion_{place}": one.kind.motion for place, one in enumerate(kinds) if one.has_pistons}
    return _put_together(imports, [*_kernels(called, (toward_end,), imports), *_turning(kinds, imports)], called)


def _put_together(imports: Imports, body: Sequence[str], called: Mapping[str, Callable[..., Any]]) -> WrittenLoops:
    """Put a module together."""
    head = [
        '"""WrittenLoops for the structure of a machine; docs/scale."""',
        "",
        "import numpy as np",
        "",
        *imports.lines(),
        "from cranktrain.study.cycle.chambers import SETTLED, STEPS, TURN",
        "from cranktrain.study.cycle.compiling import Direction, called, kernel, loop, part",
        "from cranktrain.study.cycle.loops import FINEST",
        "",
    ]
    return WrittenLoops("\n".join([*head, *body, ""]), tuple(called.values()))


_PARTS = (branch_at, nearer, cut_cycle, directions, first_chambers, own_edges, push_on, shows)
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


def _arguments(structure: CycleStructure) -> str:
    kinds = ", ".join(f"k{place}" for place in range(len(structure.kinds)))
    fluids = ", ".join(f"f{place}" for place in range(len(structure.fluids)))
    return ", ".join(filter(None, (kinds, fluids)))


def _volume(structure: CycleStructure, imports: Imports) -> Iterator[str]:
    """Volume of one chamber with its derivatives."""
    if not structure.fluids:
        return
    yield "@part"
    yield f"def volume_at(design, chamber, angle, {_arguments(structure)}, room):"
    yield "    value, first, second = room.start[design, chamber], 0.0, 0.0"
    yield "    cos, sin = np.cos(angle), np.sin(angle)"
    for place, one in enumerate(structure.kinds):
        if not one.has_pistons:
            continue
        yield f"    for member in range(k{place}.mechanism.size):"
        yield "        for partner in range(2):"
        yield f"            piston = k{place}.piston[member]"
        yield "            if piston >= 0 and room.partner[chamber, partner] == piston:"
        yield from indented(member_lines(place, one, imports), 4)
        yield f"                motion = motion_{place}({CRANK}, size)"
        yield "                area = room.area[design, chamber, partner]"
        yield "                value += area * (room.top[design, piston] - motion.slider.value)"
        yield "                first -= area * motion.slider.first"
        yield "                second -= area * motion.slider.second"
    yield "    return value, first, second"
    yield ""
    yield ""


def _turning(kinds: Sequence[KindSource], imports: Imports) -> Iterator[str]:
    """Dead centres of all pistons: the best of some points of the turn, and Newton's method from there."""
    arguments = ", ".join(f"k{place}" for place in range(len(kinds)))
    yield "@loop"
    yield f"def turning_points(first, last, {arguments}, around, found):"
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


def _fill(structure: CycleStructure, imports: Imports) -> Iterator[str]:
    """Curves at all points of the panels: pistons first, then chambers, then forces, slaves' before their masters'."""
    for thing in (Body, ChamberState, Conditions, Drive, Friction, Gravity, Wrench):
        imports.name(thing)
    yield "@part"
    yield f"def fill(design, cut, speed, cycle_length, {_arguments(structure)}, room, work):"
    yield "    n_points = cut.n_points"
    yield "    all_cos, all_sin = work.cos, work.sin"
    if structure.fluids:
        for place, one in enumerate(structure.kinds):
            if one.has_pistons:
                yield from _pistons(place, one, imports)
        for place, (_fluid, shape) in enumerate(structure.fluids):
            yield from _chambers(place, shape, structure.asks, imports)
    yield "    work.torque[:, :n_points] = 0.0"
    if structure.needs_inertia:
        yield "    work.running[:2, :n_points] = 0.0"
    if any(one.has_slaves for one in structure.kinds):
        yield "    work.on_rod[:, :, :n_points] = 0.0"
    # what slaves do to their masters' rods is a load there
    order = sorted(enumerate(structure.kinds), key=lambda one: one[1].kind.dynamics.on_master is None)
    for place, one in order:
        yield from _forces(place, one, structure, imports)
    yield ""
    yield ""


def _pistons(place: int, one: KindSource, imports: Imports) -> Iterator[str]:
    """How far pistons of one kind are from their shafts."""
    yield f"    for member in range(k{place}.mechanism.size):"
    yield f"        piston = k{place}.piston[member]"
    yield from indented(member_lines(place, one, imports), 2)
    yield "        slider, push = work.slider[piston], work.push[piston]"
    yield "        for point in range(n_points):"
    yield "            cos, sin = all_cos[point], all_sin[point]"
    yield f"            motion = motion_{place}({CRANK}, size)"
    yield "            slider[point] = motion.slider.value"
    yield "            push[point] = 0.0"


def _chambers(place: int, shape: Shape, asks: frozenset[str], imports: Imports) -> Iterator[str]:
    """Pressure in the chambers that hold one fluid, and what it does to their pistons."""
    numbers, made = taken_out(shape, imports, f"f{place}.numbers", "c")
    yield f"    for member in range(f{place}.places.size):"
    yield f"        chamber = f{place}.places[member]"
    yield from indented(numbers, 2)
    yield f"        gas = {made}"
    yield "        smallest, largest = room.smallest[design, chamber], room.largest[design, chamber]"
    yield "        start, ambient = room.start[design, chamber], room.ambient[design, chamber]"
    yield "        firing = room.firing[design, chamber]"
    yield "        one, other = room.partner[chamber, 0], room.partner[chamber, 1]"
    yield "        area, beside = room.area[design, chamber, 0], room.area[design, chamber, 1]"
    yield "        start += area * room.top[design, one] + beside * room.top[design, other]"
    yield "        for panel in range(cut.n_panels):"
    yield "            middle = cut.panels.start[panel] + 0.5 * cut.panels.width[panel]"
    yield "            sense, turn = branch_at(middle, room, design, chamber, cycle_length)"
    yield "            begin = cut.panels.first[panel]"
    yield "            size = cut.nodes.size[cut.panels.size[panel]]"
    yield "            end = begin + size"
    yield "            of_one, of_other = work.slider[one, begin:end], work.slider[other, begin:end]"
    yield "            angle, pressure = cut.panels.angle[begin:end], work.gas[begin:end]"
    yield "            for point in range(size):"
    yield "                volume = start - area * of_one[point] - beside * of_other[point]"
    yield "                state = ChamberState(volume, smallest, largest, sense, turn, angle[point] - firing)"
    yield f"                pressure[point] = pressure_{place}(state, gas)"
    if "pressure" in asks:
        yield "        for point in range(n_points):"
        yield "            work.pressure[chamber, point] = work.gas[point]"
    # for itself on each piston: loops whose results may be one another's are not vectorised
    yield "        push_on(work.push[one], area, work.gas, ambient, n_points)"
    yield "        push_on(work.push[other], beside, work.gas, ambient, n_points)"


def _forces(place: int, one: KindSource, structure: CycleStructure, imports: Imports) -> Iterator[str]:
    """Forces of the mechanisms of one kind, and what they do to the shaft."""
    dynamics, asks = one.kind.dynamics, structure.asks
    yield f"    for member in range(k{place}.mechanism.size):"
    yield from indented([*member_lines(place, one, imports), *body_lines(place, one)], 2)
    is_slave = dynamics.on_master is not None
    if one.has_pistons and structure.fluids:
        yield f"        piston = k{place}.piston[member]"
    if one.has_slaves or is_slave:
        yield f"        master = k{place}.{'master' if is_slave else 'mechanism'}[member]"
    joints = [place for place, reaction in enumerate(dynamics.reactions) if reaction.on in dynamics.moving]
    if "joint" in asks:
        for number in joints:
            yield f"        j{number} = k{place}.joint[member, {number}]"
    if one.has_pistons and structure.fluids:
        yield "        push = work.push[piston]"
    if one.has_slaves or is_slave:
        yield "        rod_x, rod_y = work.on_rod[0, master], work.on_rod[1, master]"
        yield "        rod_moment = work.on_rod[2, master]"
    yield "        torque, gross = work.torque[0], work.torque[1]"
    if structure.needs_inertia:
        yield "        applied, inertia = work.running[0], work.running[1]"
    if "joint" in asks:
        for number in joints:
            yield f"        x{number}, y{number} = work.joint_x[j{number}], work.joint_y[j{number}]"
    has_rods = "rod" in asks and one.has_pistons and one.kind.has_rod
    if has_rods:
        yield f"        piston = k{place}.piston[member]"
        yield "        along, across = work.rod[0, piston], work.rod[1, piston]"
        yield "        at_piston, at_crank = work.rod[2, piston], work.rod[3, piston]"
    yield "        for point in range(n_points):"
    yield "            cos, sin = all_cos[point], all_sin[point]"
    yield f"            motion = motion_{place}({CRANK}, size)"
    pushed = "-push[point]" if one.has_pistons and structure.fluids else "0.0"
    yield f"            own = load_{place}(motion, size, {pushed})"
    borne = "own"
    if one.has_slaves:
        yield "            handed = Wrench("
        yield "                own[1].x + rod_x[point], own[1].y + rod_y[point], own[1].moment + rod_moment[point]"
        yield "            )"
        borne = "(own[0], handed, own[2])"
    yield f"            forces = forces_{place}(motion, size, bodies, {borne}, conditions)"
    if is_slave:
        yield f"            on_rod = on_master_{place}(motion, size, forces.joints[{dynamics.joint('knuckle_pin')}])"
        yield "            rod_x[point] += on_rod.x"
        yield "            rod_y[point] += on_rod.y"
        yield "            rod_moment[point] += on_rod.moment"
    else:
        yield "            torque[point] -= forces.driving_torque"
        yield "            gross[point] += abs(forces.driving_torque)"
    if structure.needs_inertia:
        yield f"            carried = reduced(links_{place}(motion, size), bodies, own, gravity)"
        yield "            inertia[point] += carried.inertia.value"
        driving = "" if is_slave else " - forces.driving_torque"
        yield f"            applied[point] += 0.5 * carried.inertia.first * speed * speed{driving}"
    if "joint" in asks:
        for number in joints:
            yield f"            x{number}[point] = forces.joints[{number}].x"
            yield f"            y{number}[point] = forces.joints[{number}].y"
    if has_rods:
        yield from indented(_rod(one), 3)


def _rod(one: KindSource) -> Iterator[str]:
    """Forces of one piston and its rod."""
    dynamics = one.kind.dynamics
    moving = list(dynamics.moving)
    first = dynamics.joint("crank_pin")
    first = dynamics.joint("knuckle_pin") if first is None else first
    second, guide = dynamics.joint("piston_pin"), dynamics.joint("guide")
    rod, slider = moving.index("rod"), moving.index("slider")
    yield f"shares = shares_of(bodies[{rod}], size.rod_length)"
    yield f"back = bodies[{slider}].mass + shares.second"
    yield f"pins = (forces.joints[{first}], forces.joints[{second}])"
    yield "ends = along_rod(motion.rod, motion.slider, pins, shares, conditions.drive, gravity)"
    yield "pulled = inertia_of(motion.slider, back, conditions.drive)"
    yield f"along[point] = -own[{slider}].x - back * gravity.x + pulled"
    yield f"across[point] = forces.joints[{guide}].y"
    yield "at_piston[point] = ends[0]"
    # a slave's rod is on no crank pin: of it the force at the piston pin alone is told
    yield f"at_crank[point] = ends[{1 if dynamics.on_master is None else 0}]"


def _tellers(structure: CycleStructure) -> Iterator[Callable[..., Any]]:
    """What tells the facts that are asked for."""
    yield from (call for ask, call in _TOLD.items() if ask in structure.asks)
    if structure.is_of_shaft:
        yield from (begin_repeats, chambers_repeat, masters_repeat, mechanisms_repeat)
    if structure.needs_inertia:
        yield tell_running
    if "given" in structure.asks:
        yield tell_given
    if "points" in structure.asks:
        yield keep_panels


def _repeating(structure: CycleStructure) -> Iterator[str]:
    """How many times a design's cycle repeats itself."""
    later = "room, later, turning.cycle, work.repeats"
    kinds, fluids = range(len(structure.kinds)), range(len(structure.fluids))
    conditions = [
        *(f"mechanisms_repeat(design, k{place}, {later})" for place in kinds),
        *(f"masters_repeat(k{place}, work.repeats)" for place in kinds),
        *(f"chambers_repeat(design, f{place}, {later})" for place in fluids),
    ]
    yield "@part"
    yield f"def repeating(design, {_arguments(structure)}, room, turning, work):"
    yield "    found = 1"
    yield "    for many in range(work.repeats.mechanism.size, 1, -1):"
    yield "        later = turning.cycle / many"
    yield "        begin_repeats(work.repeats)"
    yield f"        if {' and '.join(conditions)}:"
    yield "            found = many"
    yield "            break"
    yield "    return found"
    yield ""
    yield ""


def _cycle(structure: CycleStructure) -> list[str]:
    """The loop over designs."""
    arguments = _arguments(structure)
    own = f"def cycle(first, last, {arguments}, room, turning, wanted, nodes, panels, work, found):"
    gas = _GAS.format(arguments=arguments) if structure.fluids else ""
    curves = [curve for ask, curve in _CURVES.items() if ask in structure.asks]
    shown = " and ".join(f"shows({curve}, cut)" for curve in ("work.torque[:1]", *curves))
    told = [
        f"                {call.__name__}(design, cut, work, found.{ask})"
        for ask, call in _TOLD.items()
        if ask in structure.asks
    ]
    known = "True"
    if structure.needs_inertia:
        known = "tell_running(design, cut, turning, wanted, work, found)"
    if "given" in structure.asks:
        known += " and tell_given(design, cut, turning, wanted, work, found)"
    if "points" in structure.asks:
        known += " and keep_panels(design, cut, work, found)"
    told.append(f"                found.is_known[design] = {known}")
    repeats = f"repeating(design, {arguments}, room, turning, work)" if structure.is_of_shaft else "1"
    return _CYCLE.format(
        head=own, arguments=arguments, gas=gas, shown=shown, told="\n".join(told), repeats=repeats
    ).splitlines()


_CURVES = {"pressure": "work.pressure", "joint": "work.joint_x", "rod": "work.rod[1]"}
"""What has to be shown by the panels, besides the torque, by what is asked."""
_TOLD = {"torque": tell_torque, "joint": tell_joints, "pressure": tell_chambers, "rod": tell_rods}
"""What tells the facts that are asked for."""

_CYCLE = """\
@loop
{head}
    for design in range(first, last):
        speed = turning.speed[design]
        n_repeats = {repeats}
        first_chambers(n_repeats, work.repeats)
        finer = 1.0
        while finer <= FINEST:
            n_poles, n_edges = 0, own_edges(design, turning, room, panels, work)
{gas}\
            cut = cut_cycle(design, n_edges, n_poles, n_repeats, finer, turning, panels, work, nodes)
            if cut.n_panels > 0:
                directions(cut, work.cos, work.sin)
                fill(design, cut, speed, turning.cycle, {arguments}, room, work)
            if cut.n_panels > 0 and {shown}:
{told}
                break
            finer *= 2.0"""

_GAS = """\
            for chamber in range(room.partner.shape[0]):
                if not work.repeats.is_first[chamber]:
                    continue
                least = room.least[design, chamber]
                smallest, _slope, bend = volume_at(design, chamber, least, {arguments}, room)
                work.pole[n_poles] = least
                work.away[n_poles] = np.sqrt(2.0 * smallest / bend)
                n_poles += 1
                for kink in range(room.sense.size):
                    volume, sense = room.kink[design, chamber, kink], room.sense[kink]
                    if volume > smallest:
                        away = min(np.sqrt(2.0 * (volume - smallest) / bend), 0.75 * np.pi)
                        for _step in range(STEPS):
                            now, rate, bending = volume_at(design, chamber, least + sense * away, {arguments}, room)
                            before = away
                            away = nearer(away, sense, now - volume, rate, bending)
                            if abs(away - before) < SETTLED:
                                break
                        other = 0.0 if room.turn[kink] > 0.0 else TURN
                        panels.edge[n_edges] = least + other + sense * away
                        n_edges += 1
"""
