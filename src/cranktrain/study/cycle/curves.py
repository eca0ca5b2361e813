"""Lines of a written cycle that fill its curves at the points of panels: pistons, chambers, forces."""

from collections.abc import Iterator

from cranktrain.fluids import ChamberState
from cranktrain.linkage.forces import Body, Conditions, Drive, Friction, Gravity, Wrench
from cranktrain.study.cycle.lines import CRANK, Imports, body_lines, indented, member_lines, taken_out
from cranktrain.study.cycle.structure import CycleStructure, KindSource, Shape


def fill_lines(structure: CycleStructure, imports: Imports) -> Iterator[str]:
    """Curves at all points of the panels: pistons first, then chambers, then forces, slaves' before their masters'."""
    for thing in (Body, ChamberState, Conditions, Drive, Friction, Gravity, Wrench):
        imports.name(thing)
    yield "n_points = cut.n_points"
    yield "all_cos, all_sin = work.cos, work.sin"
    if structure.fluids:
        for place, one in enumerate(structure.kinds):
            if one.has_pistons:
                yield from _pistons(place, one, imports)
        for place, (_fluid, shape) in enumerate(structure.fluids):
            yield from _chambers(place, shape, structure.asks, imports)
    yield "work.torque[:, :n_points] = 0.0"
    if structure.needs_inertia:
        yield "work.running[:2, :n_points] = 0.0"
    if any(one.has_slaves for one in structure.kinds):
        yield "work.on_rod[:, :, :n_points] = 0.0"
    # what slaves do to their masters' rods is a load there
    order = sorted(enumerate(structure.kinds), key=lambda one: one[1].kind.dynamics.on_master is None)
    for place, one in order:
        yield from _forces(place, one, structure, imports)


def _pistons(place: int, one: KindSource, imports: Imports) -> Iterator[str]:
    """How far pistons of one kind are from their shafts."""
    yield f"for member in range(k{place}.mechanism.size):"
    yield f"    piston = k{place}.piston[member]"
    yield from indented(member_lines(place, one, imports), 1)
    yield "    slider, push = work.slider[piston], work.push[piston]"
    yield "    for point in range(n_points):"
    yield "        cos, sin = all_cos[point], all_sin[point]"
    yield f"        motion = motion_{place}({CRANK}, size)"
    yield "        slider[point] = motion.slider.value"
    yield "        push[point] = 0.0"


def _chambers(place: int, shape: Shape, asks: frozenset[str], imports: Imports) -> Iterator[str]:
    """Pressure in the chambers that hold one fluid, and what it does to their pistons."""
    numbers, made = taken_out(shape, imports, f"f{place}.numbers", "c")
    yield f"for member in range(f{place}.places.size):"
    yield f"    chamber = f{place}.places[member]"
    yield from indented(numbers, 1)
    yield f"    gas = {made}"
    yield "    smallest, largest = room.smallest[design, chamber], room.largest[design, chamber]"
    yield "    start, ambient = room.start[design, chamber], room.ambient[design, chamber]"
    yield "    firing = room.firing[design, chamber]"
    yield "    one, other = room.partner[chamber, 0], room.partner[chamber, 1]"
    yield "    area, beside = room.area[design, chamber, 0], room.area[design, chamber, 1]"
    yield "    start += area * room.top[design, one] + beside * room.top[design, other]"
    yield "    for panel in range(cut.n_panels):"
    yield "        middle = cut.panels.start[panel] + 0.5 * cut.panels.width[panel]"
    yield "        sense, turn = branch_at(middle, room, design, chamber, turning.cycle)"
    yield "        begin = cut.panels.first[panel]"
    yield "        size = cut.nodes.size[cut.panels.size[panel]]"
    yield "        end = begin + size"
    yield "        of_one, of_other = work.slider[one, begin:end], work.slider[other, begin:end]"
    yield "        angle, pressure = cut.panels.angle[begin:end], work.gas[begin:end]"
    yield "        for point in range(size):"
    yield "            volume = start - area * of_one[point] - beside * of_other[point]"
    yield "            state = ChamberState(volume, smallest, largest, sense, turn, angle[point] - firing)"
    yield f"            pressure[point] = pressure_{place}(state, gas)"
    if "pressure" in asks:
        yield "    for point in range(n_points):"
        yield "        work.pressure[chamber, point] = work.gas[point]"
    # for itself on each piston: loops whose results may be one another's are not vectorised
    yield "    push_on(work.push[one], area, work.gas, ambient, n_points)"
    yield "    push_on(work.push[other], beside, work.gas, ambient, n_points)"


def _forces(place: int, one: KindSource, structure: CycleStructure, imports: Imports) -> Iterator[str]:
    """Forces of the mechanisms of one kind, and what they do to the shaft."""
    dynamics, asks = one.kind.dynamics, structure.asks
    yield f"for member in range(k{place}.mechanism.size):"
    yield from indented([*member_lines(place, one, imports), *body_lines(place, one)], 1)
    is_slave = dynamics.on_master is not None
    if one.has_pistons and structure.fluids:
        yield f"    piston = k{place}.piston[member]"
    if one.has_slaves or is_slave:
        yield f"    master = k{place}.{'master' if is_slave else 'mechanism'}[member]"
    joints = [place for place, reaction in enumerate(dynamics.reactions) if reaction.on in dynamics.moving]
    if "joint" in asks:
        for number in joints:
            yield f"    j{number} = k{place}.joint[member, {number}]"
    if one.has_pistons and structure.fluids:
        yield "    push = work.push[piston]"
    if one.has_slaves or is_slave:
        yield "    rod_x, rod_y = work.on_rod[0, master], work.on_rod[1, master]"
        yield "    rod_moment = work.on_rod[2, master]"
    yield "    torque, gross = work.torque[0], work.torque[1]"
    if structure.needs_inertia:
        yield "    applied, inertia = work.running[0], work.running[1]"
    if "joint" in asks:
        for number in joints:
            yield f"    x{number}, y{number} = work.joint_x[j{number}], work.joint_y[j{number}]"
    has_rods = "rod" in asks and one.has_pistons and one.kind.has_rod
    if has_rods:
        yield f"    piston = k{place}.piston[member]"
        yield "    along, across = work.rod[0, piston], work.rod[1, piston]"
        yield "    at_piston, at_crank = work.rod[2, piston], work.rod[3, piston]"
    yield "    for point in range(n_points):"
    yield "        cos, sin = all_cos[point], all_sin[point]"
    yield f"        motion = motion_{place}({CRANK}, size)"
    pushed = "-push[point]" if one.has_pistons and structure.fluids else "0.0"
    yield f"        own = load_{place}(motion, size, {pushed})"
    borne = "own"
    if one.has_slaves:
        yield "        handed = Wrench("
        yield "            own[1].x + rod_x[point], own[1].y + rod_y[point], own[1].moment + rod_moment[point]"
        yield "        )"
        borne = "(own[0], handed, own[2])"
    yield f"        forces = forces_{place}(motion, size, bodies, {borne}, conditions)"
    if is_slave:
        yield f"        on_rod = on_master_{place}(motion, size, forces.joints[{dynamics.joint('knuckle_pin')}])"
        yield "        rod_x[point] += on_rod.x"
        yield "        rod_y[point] += on_rod.y"
        yield "        rod_moment[point] += on_rod.moment"
    else:
        yield "        torque[point] -= forces.driving_torque"
        yield "        gross[point] += abs(forces.driving_torque)"
    if structure.needs_inertia:
        yield f"        carried = reduced(links_{place}(motion, size), bodies, own, gravity)"
        yield "        inertia[point] += carried.inertia.value"
        driving = "" if is_slave else " - forces.driving_torque"
        yield f"        applied[point] += 0.5 * carried.inertia.first * speed * speed{driving}"
    if "joint" in asks:
        for number in joints:
            yield f"        x{number}[point] = forces.joints[{number}].x"
            yield f"        y{number}[point] = forces.joints[{number}].y"
    if has_rods:
        yield from indented(_rod(one), 2)


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
