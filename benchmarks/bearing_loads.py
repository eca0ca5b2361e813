"""Time of the bearing loads of a V12 by all methods, beside finite elements on a band by SciPy.

    python benchmarks/bearing_loads.py

A shaft of six throws in seven bearings, 720 angles, five loads to a throw. The peer is a straight beam of Hermite's
elements on elastic bearings: its stiffness is a band that SciPy factors once for both directions and all angles, its
nodes stand where loads and bearings are. Processor time, the two in turn. PyNite, an open program for frames, gets the
same beam at twelve angles, each a load combination of one linear analysis.
"""

from time import process_time

import numpy as np
from Pynite import FEModel3D
from scipy.linalg import cho_solve_banded, cholesky_banded
from timing import interleaved_ratio

from cranktrain.questions.crankshaft.bending.shaft_loads import ShaftLoads
from cranktrain.questions.crankshaft.metal.pieces_of_throws import (
    WEB_RULES,
    ThrowGeometry,
    pieces_of_throws,
    webs_of_throws,
)
from cranktrain.questions.crankshaft.metal.sections import Material, round_section, web_section
from cranktrain.questions.crankshaft.metal.shaft import Crankshaft, StraightSpans, Supports
from cranktrain.questions.crankshaft.methods import BEARING_METHODS

LINEAR = tuple(method for method in BEARING_METHODS if method.bearings.is_linear)
SPAN, RADIUS, STIFFNESS, BENDING = 0.19, 0.09, 8e8, 3e5


def shaft(n_throws, *, is_isotropic=True):
    """A shaft of throws, 120° apart, each between two bearings."""
    one = np.ones((1, 1))
    steel = Material(206e9 * one, 79.2e9 * one)
    begins = SPAN * np.arange(n_throws)
    throws = ThrowGeometry(
        np.array([[-0.05, SPAN * n_throws + 0.1]]),
        (begins[:, np.newaxis] + np.array([0.04, 0.15]))[np.newaxis],
        np.full((1, n_throws), RADIUS),
        np.radians(120.0 * np.arange(n_throws))[np.newaxis],
    )
    journal, pin = np.full((1, n_throws + 1), 0.11), np.full((1, n_throws), 0.095)
    webs = web_section(
        np.full((1, n_throws, 2), 0.15),
        np.full((1, n_throws, 2), 0.035),
        Material(*(modulus[..., np.newaxis] for modulus in steel)),
    )
    give = np.diag([1.0, 1.0 if is_isotropic else 0.6]) / STIFFNESS
    n = n_throws + 1
    return Crankshaft(
        pieces_of_throws(throws, round_section(journal, 0.4 * journal, steel), round_section(pin, 0.4 * pin, steel)),
        webs_of_throws(throws, webs, journal, pin, WEB_RULES[0]),
        Supports(
            SPAN * np.arange(n)[np.newaxis], np.tile(give, (1, n, 1, 1)), np.zeros((1, n, 2)), np.full((1, n), 4e-5)
        ),
        StraightSpans(np.full((1, n_throws), BENDING), np.full((1, n_throws), np.inf)),
    )


def loads(n_throws, n_angles):
    """Two rods, the pin and both webs of every throw."""
    begins = SPAN * np.arange(n_throws)[:, np.newaxis]
    pieces = 2 * np.arange(n_throws)[:, np.newaxis]
    directions = np.radians(120.0 * np.arange(n_throws))[:, np.newaxis]
    force = np.random.default_rng(1).uniform(-1e5, 1e5, (1, 5 * n_throws, 2, n_angles))
    return ShaftLoads(
        np.ravel(pieces + np.array([1, 1, 1, 0, 1])),
        np.tile([False, False, False, True, True], n_throws),
        np.ravel(begins + np.array([0.075, 0.115, 0.095, 0.04, 0.15]))[np.newaxis],
        np.tile(RADIUS * np.array([1, 1, 1, 0.3, 0.3]), n_throws)[np.newaxis],
        np.ravel(directions + np.zeros(5))[np.newaxis],
        -np.linspace(0, 4 * np.pi, n_angles, endpoint=False)[np.newaxis],
        force,
    )


def all_linear(one, acting):
    return [method.loads(one, acting) for method in LINEAR]


def elements(one, acting):
    """Loads of elastic bearings by Hermite's elements on a band."""
    places = np.unique(np.concatenate([one.supports.place[0], acting.z[0]]))
    band = np.zeros((4, 2 * len(places)))
    for node, length in enumerate(np.diff(places)):
        own = (
            BENDING
            / length**3
            * np.array(
                [
                    [12, 6 * length, -12, 6 * length],
                    [6 * length, 4 * length**2, -6 * length, 2 * length**2],
                    [-12, -6 * length, 12, -6 * length],
                    [6 * length, 2 * length**2, -6 * length, 4 * length**2],
                ]
            )
        )
        for i in range(4):
            for j in range(i, 4):
                band[3 + i - j, 2 * node + j] += own[i, j]
    bearings = 2 * np.searchsorted(places, one.supports.place[0])
    band[3, bearings] += STIFFNESS
    right = np.zeros((2 * len(places), 2 * acting.turned.shape[1]))
    np.add.at(right, 2 * np.searchsorted(places, acting.z[0]), acting.force[0].reshape(len(acting.piece), -1))
    found = cho_solve_banded((cholesky_banded(band), False), right)
    return STIFFNESS * found[bearings]


def by_pynite(one, acting):
    """The same by PyNite, shape (bearing, 2, angle)."""
    places = np.unique(np.concatenate([one.supports.place[0], acting.z[0]]))
    model = FEModel3D()
    model.add_material("steel", E=206e9, G=79.2e9, nu=0.3, rho=0.0)
    model.add_section("shaft", A=0.01, Iy=BENDING / 206e9, Iz=BENDING / 206e9, J=1e-5)
    for i, z in enumerate(places.tolist()):
        model.add_node(f"N{i}", z, 0.0, 0.0)
        # In one plane, held along and in twist at its first end.
        model.def_support(f"N{i}", i == 0, False, True, i == 0, True, False)
    for i in range(len(places) - 1):
        model.add_member(f"M{i}", f"N{i}", f"N{i + 1}", "steel", "shaft")
    bearings = [f"N{i}" for i in np.searchsorted(places, one.supports.place[0])]
    for name in bearings:
        model.def_support_spring(name, "DY", STIFFNESS)
    combinations = [[f"{way} {angle}" for angle in range(acting.turned.shape[1])] for way in ("X", "Y")]
    for way, names in enumerate(combinations):
        for angle, name in enumerate(names):
            model.add_load_combo(name, {name: 1.0})
            for load, node in enumerate(np.searchsorted(places, acting.z[0]).tolist()):
                model.add_node_load(f"N{node}", "FY", float(acting.force[0, load, way, angle]), name)
    model.analyze_linear()
    moved = [[[model.nodes[node].DY[name] for name in names] for names in combinations] for node in bearings]
    return STIFFNESS * np.array(moved)


def time_of(work):
    """Least processor time of a call. [s]"""
    times = []
    for _ in range(15):
        start = process_time()
        work()
        times.append(process_time() - start)
    return min(times)


def main():
    one, skew, acting = shaft(6), shaft(6, is_isotropic=False), loads(6, 720)
    five = next(method for method in BEARING_METHODS if method.name == "five_moment")
    ours, theirs = five.loads(one, acting).load[0], elements(one, acting)
    print(f"five moments and finite elements differ by {np.max(np.abs(ours.reshape(theirs.shape) - theirs)):.1e} N\n")
    print(f"{'V12, 7 bearings, 720 angles':<34}{'isotropic':>12}{'not':>12}")
    for method in BEARING_METHODS:
        times = [time_of(lambda own=own, by=method: by.loads(own, acting)) for own in (one, skew)]
        print(f"{method.name:<34}" + "".join(f"{1e3 * time:9.2f} ms" for time in times))
    times = [time_of(lambda own=own: all_linear(own, acting)) for own in (one, skew)]
    print(f"{'all five without clearance':<34}" + "".join(f"{1e3 * time:9.2f} ms" for time in times))
    for name, work in (("five_moment", lambda: five.loads(one, acting)), ("all five", lambda: all_linear(one, acting))):
        ratio = interleaved_ratio(work, lambda: elements(one, acting), n_repetitions=15)
        print(f"{name} / finite elements on a band: {ratio.median:.2f} ({ratio.least:.2f}–{ratio.most:.2f})")
    few = loads(6, 12)
    apart = np.max(np.abs(five.loads(one, few).load[0] - by_pynite(one, few)))
    ratio = interleaved_ratio(lambda: five.loads(one, few), lambda: by_pynite(one, few), n_repetitions=5)
    print(
        f"five_moment / PyNite, 12 angles: {ratio.median:.5f} ({ratio.least:.5f}–{ratio.most:.5f}), apart {apart:.1e} N"
    )
    print("\nall five, time over that of 6 throws and 720 angles")
    base = times[0]
    for n_throws, n_angles in ((6, 1440), (6, 2880), (6, 5760), (12, 720), (24, 720), (48, 720)):
        own, by = shaft(n_throws), loads(n_throws, n_angles)
        share = time_of(lambda own=own, by=by: all_linear(own, by)) / base
        print(f"{n_throws:>3} throws, {n_angles:>5} angles: {share:.2f}")


if __name__ == "__main__":
    main()
