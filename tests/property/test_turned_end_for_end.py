"""A shaft that is turned end for end: its bearings carry the same, counted from the other end, by every method."""

import numpy as np
import pytest

import cranktrain as ct
from cranktrain.questions.crankshaft.methods import BEARING_METHODS

PLAIN = {"kind": "slider_crank", "crank_radius": "50 mm", "rod_length": "200 mm"}
FACTS = ["largest_bearing_load", "mean_bearing_load"]


def mm(values):
    return [f"{value!r} mm" for value in values]


class Drawn:
    """Two to six throws in any directions, one or more between two bearings; every size another one."""

    def __init__(self, seed):
        draw = np.random.default_rng(seed)
        n = int(draw.integers(2, 7))
        inner = [number for number in range(2, n + 1) if draw.random() < 0.7]
        self.bearings = [1, *inner, n + 1]
        self.throws = [float(angle) for angle in draw.integers(0, 360, n)]
        self.spacing = draw.uniform(140, 200, n - 1).tolist()
        self.pin_diameter, self.journal_diameter = (
            draw.uniform(55, 70, n).tolist(),
            draw.uniform(60, 80, n + 1).tolist(),
        )
        self.pin_length = draw.uniform(35, 45, n).tolist()
        self.end = float(draw.uniform(70, 100))
        self.stiffness = draw.uniform(2e5, 2e6, 2).tolist()
        self.clearance = float(draw.uniform(0.02, 0.1))

    def turned(self):
        other = object.__new__(Drawn)
        other.__dict__ = {
            name: value[::-1] if isinstance(value, list) and name not in ("bearings", "stiffness") else value
            for name, value in self.__dict__.items()
        }
        other.bearings = [len(self.throws) + 2 - number for number in reversed(self.bearings)]
        return other

    def machine(self, masses, has_clearance):
        clearance = {"bearing_clearance": f"{self.clearance!r} mm"} if has_clearance else {}
        return ct.Machine(
            shaft={
                "main": {
                    "throws": [f"{angle:g} deg" for angle in self.throws],
                    "speed": "1500 rpm",
                    "spacing": mm(self.spacing),
                }
            },
            bank={"A": {"mechanism": PLAIN}},
            masses=masses,
            crankshaft={
                "journal_diameter": mm(self.journal_diameter),
                "pin_diameter": mm(self.pin_diameter),
                "pin_length": mm(self.pin_length),
                "web_thickness": "20 mm",
                "web_width": "90 mm",
                "bearings": self.bearings,
                "bearing_distance": f"{self.end!r} mm",
                "bearing_stiffness": [f"{value!r} N/mm" for value in self.stiffness],
                **clearance,
            },
        )


CRANKS = {"crank": {"mass": "2 kg", "along": "15 mm", "inertia": "0.01 kg·m²"}}
PISTONS = {
    **CRANKS,
    "piston": {"mass": "1.2 kg"},
    "rod": {"big_end": "1 kg", "small_end": "0.4 kg", "inertia": "0.01 kg·m²"},
}


def of_both(seed, masses, *, has_clearance=False):
    """Results of a shaft and of the same turned."""
    one = Drawn(seed)
    both = (each.machine(masses, has_clearance) for each in (one, one.turned()))
    return (ct.run(each, step_degrees=5, quantities=FACTS) for each in both)


def agree(one, other, methods, facts):
    for name in facts:
        found, turned = (np.asarray(getattr(each, name)) for each in (one, other))
        for row, method in enumerate(one.labels["bearing_method"]):
            if method in methods:
                scale = np.max(found[row])
                np.testing.assert_allclose(turned[row, ::-1], found[row], rtol=0, atol=1e-12 * scale, err_msg=method)


WITH_CLEARANCE = (0, 1, 3, 4, 6, 7, 9, 11, 16, 20, 21, 24)
"""These shafts go through what they have between journals and bearings too, which takes longer than all else."""


@pytest.mark.parametrize("seed", range(30))
def test_cranks_alone(seed):
    has_clearance = seed in WITH_CLEARANCE
    one, other = of_both(seed, CRANKS, has_clearance=has_clearance)
    every = {method.name for method in BEARING_METHODS} - (set() if has_clearance else {"clearance"})
    assert set(one.labels["bearing_method"]) == every
    agree(one, other, every, FACTS)


def test_shafts_with_clearance_are_of_all_sorts():
    drawn = [Drawn(seed) for seed in WITH_CLEARANCE]
    assert {len(one.throws) for one in drawn} == {2, 3, 4, 5, 6}
    between = {len(one.throws) + 1 - len(one.bearings) for one in drawn}
    assert between == {0, 1, 2, 3}


@pytest.mark.parametrize("seed", range(8))
def test_with_pistons(seed):
    """The torque of pistons bends a crank frame on its way to the flywheel, which stands at the other end then.

    Means of loads that come near to nothing are exact to 1e-7 only.
    """
    agree(*of_both(seed, PISTONS), {"split", "three_moment", "five_moment"}, FACTS[:1])
