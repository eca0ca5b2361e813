"""A machine of every kind with masses, weights and a speed, and the examples with gas and masses."""

import tomllib

import cranktrain as ct
from cranktrain.layout.masses import part_name
from cranktrain.mechanisms import KINDS


def weighed(table):
    """A machine of a kind with bodies beside their lines, weights and a speed."""
    places = ct.Machine(**table).places
    parts = {part_name(part): n for place in places for n, part in enumerate(place.kind.dynamics.moving)}
    masses = {
        part: {"mass": f"{2 + n} kg"}
        if part == "piston"
        else {
            "mass": f"{1 + n} kg",
            "along": f"{30 + 10 * n} mm",
            "across": f"{3 * n} mm",
            "inertia": f"{0.01 + 0.003 * n} kg*m^2",
        }
        for part, n in parts.items()
    }
    return ct.Machine(**{**table, "shaft": {"main": {"speed": "1200 rpm"}}, "masses": masses, "gravity": True})


WEIGHED = {kind.name: weighed(tomllib.loads(kind.example)) for kind in KINDS} | {
    name: ct.load(name) for name in ("3d12", "r_1340", "deltic", "vaz_21213")
}
CLOSED_FORMS = (
    *("slider_crank", "crank_rocker", "articulated_rod", "scotch_yoke"),
    *("oscillating_cylinder", "slotted_lever", "eccentric"),
)
"""Kinds that are no chains of links."""
