"""Crankshafts as frames of three-dimensional beam elements in over 40 digits: they know no equation of moments.

Wherever a load acts, a bearing stands or the line has a corner is a node; elements are Timoshenko's, exact for loads at
nodes. Eliminated in FLINT's balls, which hold the error.
"""

from collections import defaultdict
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from flint import arb, arb_mat, ctx

DIGITS = 100
"""Of which elimination in balls takes up to 42."""
STIFF = 10**14
"""How much stiffer than the rest what does not give is taken: it errs by the inverse."""

NONE = (arb(0), arb(0), arb(0))


class Beam(NamedTuple):
    """Between two nodes. EI of displacements along its first and its second cross direction; GJ, κGA, EA.

    The second cross direction of what is at right angles to z is z.
    """

    begin: int
    end: int
    first: arb
    second: arb
    torsion: arb
    shear: arb
    axial: arb


class Frame:
    """Nodes, beams between them, forces on them and what holds them: six degrees of freedom to a node."""

    def __init__(self):
        self.nodes, self.beams, self.forces, self.springs, self.held = [], [], [], [], {}

    def node(self, *place):
        self.nodes.append(place)
        return len(self.nodes) - 1

    def push(self, node, force, moment=NONE, arm=NONE):
        """Load a node, by an arm that is fixed to it."""
        turning = [one + other for one, other in zip(moment, cross(arm, force), strict=True)]
        self.forces += [(6 * node + i, value) for i, value in enumerate((*force, *turning))]

    def solved(self):
        """Displacements, and forces of what holds nodes, by degree of freedom."""
        size = 6 * len(self.nodes)
        matrix = [defaultdict(arb) for _row in range(size)]
        right = [arb(0)] * size
        for beam in self.beams:
            for row, column, value in self._stiffness(beam):
                matrix[row][column] += value
        for row, value in self.forces:
            right[row] += value
        for row, column, value, rest in self.springs:
            matrix[row][column] += value
            right[row] += value * rest
        free = [row for row in range(size) if row not in self.held]
        sides = [right[row] - total(matrix[row][one] * at for one, at in self.held.items()) for row in free]
        place = {row: at for at, row in enumerate(free)}
        rows = [{place[column]: value for column, value in matrix[row].items() if column in place} for row in free]
        shift = [self.held.get(row, arb(0)) for row in range(size)]
        for row, found in zip(free, eliminated(rows, sides), strict=True):
            shift[row] = found
        return shift, {
            row: total(value * shift[column] for column, value in matrix[row].items()) - right[row] for row in self.held
        }

    def _stiffness(self, beam):
        """Entries of Timoshenko's element: two springs, and bending in two planes."""
        way = [b - a for a, b in zip(self.nodes[beam.begin], self.nodes[beam.end], strict=True)]
        length = total(w * w for w in way).sqrt()
        along = [w / length for w in way]
        z = (arb(0), arb(0), arb(1))
        first = (arb(1), arb(0), arb(0)) if way[2] != 0 else cross(z, along)
        second = cross(along, first)
        for kind, value in ((0, beam.axial), (3, beam.torsion)):
            spring = [[value / length, -value / length], [-value / length, value / length]]
            yield from entries(spring, [(beam.begin, kind, along), (beam.end, kind, along)])
        for shift, turn, sign, bending in ((first, second, 1, beam.first), (second, first, -1, beam.second)):
            turned = [sign * component for component in turn]
            ends = [(node, kind, one) for node in beam[:2] for kind, one in ((0, shift), (3, turned))]
            yield from entries(bent(bending, beam.shear, length), ends)


def eliminated(rows, sides):
    """Solution of a symmetric positive definite system, by Gauss. Nodes follow the line: rows are short and stay so."""
    for pivot, (row, side) in enumerate(zip(rows, sides, strict=True)):
        behind = {column: value for column, value in row.items() if column > pivot}
        for other in behind:
            below = rows[other]
            factor = below.pop(pivot) / row[pivot]
            for column, value in behind.items():
                below[column] = below.get(column, 0) - factor * value
            sides[other] -= factor * side
    found = [arb(0)] * len(rows)
    for pivot in reversed(range(len(rows))):
        known = total(value * found[column] for column, value in rows[pivot].items() if column > pivot)
        found[pivot] = (sides[pivot] - known) / rows[pivot][pivot]
    return found


def bent(bending, shear, length):
    """Stiffness of a beam in a plane: against displacement and rotation of one end, and of the other."""
    share = 12 * bending / (shear * length**2)
    scale = bending / (length**3 * (1 + share))
    near, far = (4 + share) * length**2, (2 - share) * length**2
    table = [
        [12, 6 * length, -12, 6 * length],
        [6 * length, near, -6 * length, far],
        [-12, -6 * length, 12, -6 * length],
        [6 * length, far, -6 * length, near],
    ]
    return [[scale * value for value in row] for row in table]


def entries(table, ends):
    """A small table, of displacements along directions, by degrees of freedom."""
    for row, (node, kind, direction) in zip(table, ends, strict=True):
        for value, (other, other_kind, other_direction) in zip(row, ends, strict=True):
            for i, a in enumerate(direction):
                for j, b in enumerate(other_direction):
                    if a != 0 and b != 0:
                        yield 6 * node + kind + i, 6 * other + other_kind + j, value * a * b


def total(values):
    return sum(values, arb(0))


def cross(one, other):
    (a, b, c), (x, y, z) = one, other
    return (b * z - c * y, c * x - a * z, a * y - b * x)


def exact(value):
    return arb(float(value))


def frame_loads(shaft, loads, design, angle, *, gives):
    """Bearing loads and displacements of a crankshaft at one angle, each of shape (bearing, 2)."""
    ctx.dps = DIGITS
    return CrankFrame(shaft, loads, design, angle).bearing_loads(gives=gives)


def frame_torques(shaft, loads, design, angle):
    """Torque from X toward Y in the first and the last beam of every piece, on elastic bearings, shape (2, piece)."""
    ctx.dps = DIGITS
    whole = CrankFrame(shaft, loads, design, angle)
    whole.bearing_loads(gives=True)
    return np.array([[float(whole.torque(beams[end])) for beams in whole.of_piece] for end in (0, -1)])


def beam_loads(shaft, loads, design, angle, *, gives):
    """The same of its straight spans; couples and forces act on the axis."""
    ctx.dps = DIGITS
    return _StraightFrame(shaft, loads, design, angle).bearing_loads(gives=gives)


class _OnBearings:
    """What both have in common: bearings, and axes that stand."""

    def __init__(self, shaft, loads, design, angle):
        self.shaft, self.loads, self.design, self.angle = shaft, loads, design, angle
        self.frame, self.bearings, self.of_piece = Frame(), {}, []
        self.turned = exact(loads.turned[design, angle])
        self.build()

    def at(self, values, *member):
        return exact(values[self.design, *member])

    def polar(self, radius, direction):
        direction = direction + self.turned
        return radius * direction.cos(), radius * direction.sin()

    def push(self, load, node, arm=NONE):
        loads, angle = self.loads, self.angle
        force = [self.at(loads.force, load, i, angle) for i in range(2)]
        thrust = arb(0) if loads.thrust is None else self.at(loads.thrust, load, angle)
        moment = [arb(0)] * 3
        if loads.couple is not None:
            x, y = (self.at(loads.couple, load, i, angle) for i in range(2))
            moment = [-y, x, arb(0)]
        if loads.torque is not None:
            moment[2] = self.at(loads.torque, load, angle)
        self.frame.push(node, (*force, thrust), moment, arm)

    def bearing_loads(self, *, gives):
        supports, frame = self.shaft.supports, self.frame
        n = supports.place.shape[1]
        frame.held[6 * self.bearings[supports.thrust % n] + 2] = arb(0)
        frame.held[6 * self.last + 5] = arb(0)
        for bearing, node in self.bearings.items():
            rest = [self.at(supports.settlement, bearing, i) for i in range(2)]
            table = [[self.at(supports.compliance, bearing, i, j) for j in range(2)] for i in range(2)]
            if gives:
                springs = arb_mat(table).inv()
                for i in range(2):
                    for j in range(2):
                        frame.springs.append((6 * node + i, 6 * node + j, springs[i, j], rest[j]))
            else:
                frame.held |= {6 * node + i: rest[i] for i in range(2)}
        self.shift, reaction = frame.solved()
        shift = self.shift
        moved = np.array([[float(shift[6 * self.bearings[b] + i]) for i in range(2)] for b in range(n)])
        borne = np.empty((n, 2))
        for bearing, node in self.bearings.items():
            for i in range(2):
                if gives:
                    own = [one for one in frame.springs if one[0] == 6 * node + i]
                    borne[bearing, i] = float(total(value * (shift[col] - rest) for _row, col, value, rest in own))
                else:
                    borne[bearing, i] = -float(reaction[6 * node + i])
        return borne, moved


class CrankFrame(_OnBearings):
    def build(self):
        for piece in range(self.shaft.pieces.radius.shape[1]):
            begin = self.last if piece else None
            first = self.piece(piece)
            if piece:
                self.web(piece - 1, begin, first)

    def acting(self, piece, *, on_web):
        """Loads on a piece or a web, with their places."""
        loads = self.loads
        for load in np.flatnonzero((loads.piece == piece) & (loads.on_web == on_web)).tolist():
            across = self.polar(self.at(loads.radius, load), self.at(loads.angle, load))
            yield load, (*across, self.at(loads.z, load))

    def piece(self, piece):
        """A piece, of which the first node is given back; the last one is the last so far."""
        pieces, supports = self.shaft.pieces, self.shaft.supports
        begin, end = (self.at(pieces.bounds, one) for one in (piece, piece + 1))
        axis = *self.polar(self.at(pieces.radius, piece), self.at(pieces.angle, piece)), arb(0)
        loads = list(self.acting(piece, on_web=False))
        places = [self.at(supports.place, bearing) for bearing in range(supports.place.shape[1])]
        bearings = [(bearing, z) for bearing, z in enumerate(places) if begin < z and z < end]
        marks = [begin, end, *(place[2] for _load, place in loads), *(z for _bearing, z in bearings)]
        nodes = self.nodes_along(axis, (arb(0), arb(0), arb(1)), marks, {})
        bending, *others = (self.at(values, piece) for values in pieces[3:])
        self.of_piece.append([Beam(*ends, bending, bending, *others) for ends in pairwise(nodes.values())])
        self.frame.beams += self.of_piece[-1]
        for load, place in loads:
            self.push(load, nodes[place[2]], [a - b for a, b in zip(place[:2], axis[:2], strict=True)] + [arb(0)])
        self.bearings |= {bearing: nodes[z] for bearing, z in bearings}
        self.last = nodes[end]
        return nodes[begin]

    def torque(self, beam):
        """What a beam along the shaft hands on: the twist is against what acts before it."""
        length = self.frame.nodes[beam.end][2] - self.frame.nodes[beam.begin][2]
        return (self.shift[6 * beam.begin + 5] - self.shift[6 * beam.end + 5]) * beam.torsion / length

    def web(self, web, begin, end):
        """What joins two pieces: what gives of it, and what does not."""
        webs, first = self.shaft.webs, self.frame.nodes[begin]
        way = [b - a for a, b in zip(first, self.frame.nodes[end], strict=True)]
        length = total(w * w for w in way).sqrt().mid()
        along = [w / length for w in way]
        arms = {
            load: [a - b for a, b in zip(place, first, strict=True)] for load, place in self.acting(web, on_web=True)
        }
        marks = {load: total(a * b for a, b in zip(arm, along, strict=True)).mid() for load, arm in arms.items()}
        marks = {load: arb(0) if at < 0 else length if at > length else at for load, at in marks.items()}
        gives = self.at(webs.rigid, web, 0), (length - self.at(webs.rigid, web, 1)).mid()
        nodes = self.nodes_along(first, along, [*gives, *marks.values()], {arb(0): begin, length: end})
        bending, across, *others = (self.at(values, web) for values in webs[:5])
        for one, other in pairwise(nodes):
            factor = 1 if gives[0] <= one and other <= gives[1] else STIFF
            values = (factor * value for value in (across, bending, *others))
            self.frame.beams.append(Beam(nodes[one], nodes[other], *values))
        for load, at in marks.items():
            self.push(load, nodes[at], [a - at * b for a, b in zip(arms[load], along, strict=True)])

    def nodes_along(self, start, along, places, known):
        """Nodes on a line by their distance from its start, which rises; those at one place are one."""
        found = dict(known)
        for at in places:
            if at not in found:
                found[at] = self.frame.node(*(a + at * b for a, b in zip(start, along, strict=True)))
        return {at: found[at] for at in sorted(found)}


class _StraightFrame(_OnBearings):
    def build(self):
        shaft, loads = self.shaft, self.loads
        places = shaft.supports.place[self.design]
        every = sorted({float(z) for z in (*places, *loads.z[self.design])})
        nodes = {z: self.frame.node(arb(0), arb(0), exact(z)) for z in every}
        self.bearings = {bearing: nodes[float(z)] for bearing, z in enumerate(places)}
        self.last = nodes[every[-1]]
        n = len(places) - 1
        for begin, end in pairwise(every):
            span = min(max(int(np.sum(places <= begin)) - 1, 0), n - 1)
            bending = self.at(shaft.straight.bending, span)
            given = shaft.straight.shear[self.design, span]
            shear = bending * STIFF if np.isinf(given) else exact(given)
            self.frame.beams.append(Beam(nodes[begin], nodes[end], bending, bending, bending, shear, shear))
        for load in range(len(loads.piece)):
            x, y = self.polar(self.at(loads.radius, load), self.at(loads.angle, load))
            self.push(load, nodes[float(loads.z[self.design, load])], (x, y, arb(0)))
