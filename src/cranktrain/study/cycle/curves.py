"""Lines of a written cycle that fill its curves at the points of panels: pistons, chambers, forces."""

from collections.abc import Iterator

from cranktrain.fluids import ChamberState
from cranktrain.linkage.forces import Body, Conditions, Drive, Friction, Gravity, Wrench
from cranktrain.study.cycle.lines import CRANK, Imports, body_lines, indented, member_lines, taken_out
from cranktrain.study.cycle.panels import CutCycle
from cranktrain.study.cycle.structure import CycleStructure, KindSource, Shape


def fill_lines(structure: CycleStructure, imports: Imports) -> Iterator[str]:
    """Curves at all points of the panels: pistons first, then chambers, then forces, slaves' before their masters'."""
    of_forces = (Conditions, Drive, Friction, Wrench) if structure.needs_forces else ()
    for thing in (Body, ChamberState, CutCycle, Gravity, *of_forces):
        imports.name(thing)
    yield "cut = CutCycle(panels, nodes, n_panels, n_points, length, turning.zero[design])"
    yield "angle = panels.angle[:n_points]"
    yield "directions(angle, work.cos, work.sin)"
    yield "all_cos, all_sin = work.cos, work.sin"
    if structure.fluids:
        for place, one in enumerate(structure.kinds):
            if one.has_pistons:
                yield from _pistons(place, one, imports)
        yield "starts, widths = panels.start[:n_panels], panels.width[:n_panels]"
        for place, (_fluid, shape) in enumerate(structure.fluids):
            yield from _chambers(place, shape, structure.asks, imports)
    yield "work.torque[:, :n_points] = 0.0"
    if structure.needs_inertia:
        yield "work.running[:2, :n_points] = 0.0"
    if structure.needs_forces and any(one.has_slaves for one in structure.kinds):
        yield "work.on_rod[:, :, :n_points] = 0.0"
    # what slaves do to their masters' rods is a load there
    for place, one in sorted(enumerate(structure.kinds), key=lambda one: not one[1].is_slave):
        yield from _torques(place, one, structure, imports)


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
    yield "    smallest, largest = room.smallest[design, chamber], room.largest[design, chamber]"
    yield "    start, ambient = room.start[design, chamber], room.ambient[design, chamber]"
    yield "    firing, inmost, outmost = room.firing[design, chamber], least[chamber], greatest[chamber]"
    yield "    one, other = room.partner[chamber, 0], room.partner[chamber, 1]"
    yield "    area, beside = room.area[design, chamber, 0], room.area[design, chamber, 1]"
    yield "    start += area * room.top[design, one] + beside * room.top[design, other]"
    yield f"    own = start, area, beside, smallest, largest, firing, {made}"
    yield "    panel = 0"
    yield "    while panel < n_panels:"
    yield "        begin = panels.first[panel]"
    yield "        sense, turn, panel = branch_from(panel, starts, widths, inmost, outmost, turning.cycle)"
    yield "        end = panels.first[panel] if panel < n_panels else n_points"
    yield "        where = work.slider[one, begin:end], work.slider[other, begin:end], angle[begin:end]"
    yield "        pressure = work.gas[begin:end]"
    # each branch for itself, of which the compiler leaves out what others have
    yield "        if turn > 0.0 and sense > 0.0:"
    yield f"            on_branch_{place}(1.0, 1.0, own, where, pressure)"
    yield "        elif turn > 0.0:"
    yield f"            on_branch_{place}(-1.0, 1.0, own, where, pressure)"
    yield "        elif sense > 0.0:"
    yield f"            on_branch_{place}(1.0, -1.0, own, where, pressure)"
    yield "        else:"
    yield f"            on_branch_{place}(-1.0, -1.0, own, where, pressure)"
    if "pressure" in asks:
        yield "    for point in range(n_points):"
        yield "        work.pressure[chamber, point] = work.gas[point]"
    # for itself on each piston: loops whose results may be one another's are not vectorised
    yield "    push_on(work.push[one], area, work.gas, ambient, n_points)"
    yield "    push_on(work.push[other], beside, work.gas, ambient, n_points)"


def branch_lines(structure: CycleStructure) -> Iterator[str]:
    """Functions that find the pressure in a chamber at points of one branch."""
    for place in range(len(structure.fluids)):
        yield "@part"
        yield f"def on_branch_{place}(sense, turn, own, where, pressure):"
        yield "    start, area, beside, smallest, largest, firing, gas = own"
        yield "    of_one, of_other, angle = where"
        yield "    for point in range(pressure.size):"
        yield "        volume = start - area * of_one[point] - beside * of_other[point]"
        yield "        state = ChamberState(volume, smallest, largest, sense, turn, angle[point] - firing)"
        yield f"        pressure[point] = pressure_{place}(state, gas)"
        yield ""
        yield ""


def _torques(place: int, one: KindSource, structure: CycleStructure, imports: Imports) -> Iterator[str]:
    """What the mechanisms of one kind do to the shaft, and the forces in them where these are asked."""
    yield f"for member in range(k{place}.mechanism.size):"
    yield from indented([*member_lines(place, one, imports), *body_lines(place, one)], 1)
    has_gas = one.has_pistons and bool(structure.fluids)
    if has_gas:
        yield f"    push = work.push[k{place}.piston[member]]"
    yield "    torque, gross = work.torque[0], work.torque[1]"
    if structure.needs_inertia:
        yield "    applied, inertia = work.running[0], work.running[1]"
    if structure.needs_forces:
        yield from indented(_rooms_of_forces(place, one, structure), 1)
    yield "    for point in range(n_points):"
    yield "        cos, sin = all_cos[point], all_sin[point]"
    yield f"        motion = motion_{place}({CRANK}, size)"
    yield f"        own = load_{place}(motion, size, {'-push[point]' if has_gas else '0.0'})"
    if structure.goes_by_work:
        yield f"        carried = reduced(links_{place}(motion, size), bodies, own, gravity)"
    if structure.needs_forces:
        yield from indented(_forces(place, one, structure), 2)
    if not (structure.needs_forces and one.is_slave):
        by_work = "0.5 * carried.inertia.first * speed * speed - carried.load"
        yield f"        driving = {'forces.driving_torque' if structure.needs_forces else by_work}"
        yield "        torque[point] -= driving"
        yield "        gross[point] += abs(driving)"
    if structure.needs_inertia:
        yield "        inertia[point] += carried.inertia.value"
        yield "        applied[point] += carried.load"


def _rooms_of_forces(place: int, one: KindSource, structure: CycleStructure) -> Iterator[str]:
    """Under what the forces of one member are, where they are to stand, and what its slaves do to its rod."""
    frictions = "Friction(0.0, 1.0, 0.0, 0.0), " * len(one.kind.dynamics.sliding)
    yield f"conditions = Conditions(Drive(speed, 0.0), gravity, ({frictions}))"
    if one.has_slaves or one.is_slave:
        yield f"master = k{place}.{'master' if one.is_slave else 'mechanism'}[member]"
        yield "rod_x, rod_y, rod_moment = work.on_rod[0, master], work.on_rod[1, master], work.on_rod[2, master]"
    if "joint" in structure.asks:
        for number in one.joints:
            yield f"j{number} = k{place}.joint[member, {number}]"
            yield f"x{number}, y{number} = work.joint_x[j{number}], work.joint_y[j{number}]"
    if one.has_rods and "rod" in structure.asks:
        yield f"piston = k{place}.piston[member]"
        yield "along, across = work.rod[0, piston], work.rod[1, piston]"
        yield "at_piston, at_crank = work.rod[2, piston], work.rod[3, piston]"


def _forces(place: int, one: KindSource, structure: CycleStructure) -> Iterator[str]:
    """Forces of one member at a point."""
    borne = "own"
    if one.has_slaves:
        yield "handed = Wrench(own[1].x + rod_x[point], own[1].y + rod_y[point], own[1].moment + rod_moment[point])"
        borne = "(own[0], handed, own[2])"
    yield f"forces = forces_{place}(motion, size, bodies, {borne}, conditions)"
    if one.is_slave:
        knuckle = one.kind.dynamics.joint("knuckle_pin")
        yield f"on_rod = on_master_{place}(motion, size, forces.joints[{knuckle}])"
        yield "rod_x[point] += on_rod.x"
        yield "rod_y[point] += on_rod.y"
        yield "rod_moment[point] += on_rod.moment"
    if "joint" in structure.asks:
        for number in one.joints:
            yield f"x{number}[point] = forces.joints[{number}].x"
            yield f"y{number}[point] = forces.joints[{number}].y"
    if one.has_rods and "rod" in structure.asks:
        yield from _rod(one)


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
