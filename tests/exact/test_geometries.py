"""Closing margins: a little less of a change and the crank still turns, a little more and it does not."""

import numpy as np
import pytest
from tests.exact.geometries import (
    articulated_rods,
    can_turn,
    crank_rocker_gaps,
    crank_rockers,
    knuckle_distance,
    knuckle_reach,
    slider_crank_margin,
    slider_cranks,
)

N = 300


def scaled(geometry, path: tuple[str, ...], factor):
    name, *rest = path
    field = getattr(geometry, name)
    return geometry._replace(**{name: scaled(field, tuple(rest), factor) if rest else field * factor})


def slider_crank_turns(geometry):
    return slider_crank_margin(geometry) >= 0


def crank_rocker_turns(geometry):
    return np.minimum(*crank_rocker_gaps(geometry)) >= 0


MASTER = [("master", name) for name in ("crank_radius", "rod_length", "offset")]


@pytest.mark.parametrize(
    ("machines", "turns", "lengths", "accuracy"),
    [
        (slider_cranks(N, 5), slider_crank_turns, [("crank_radius",), ("rod_length",), ("offset",)], 1e-9),
        (
            crank_rockers(N, 5),
            crank_rocker_turns,
            [("crank_radius",), ("rod_length",), ("rocker_length",), ("ground_length",)],
            1e-9,
        ),
        (articulated_rods(N, 5), can_turn, [*MASTER, ("knuckle_radius",), ("rod_length",), ("offset",)], 0.02),
    ],
    ids=["slider_crank", "crank_rocker", "articulated_rod"],
)
def test_margin_is_the_smallest_change_that_opens_the_links(machines, turns, lengths, accuracy):
    changes = [(length, sign) for length in lengths for sign in (-1, 1)]

    def turns_after_every_change(share: float):
        return [
            turns(scaled(machines.geometry, length, 1 + sign * share * machines.margin)) for length, sign in changes
        ]

    for share in (0.3, 0.7, 1 - accuracy):
        assert np.all(turns_after_every_change(share))
    assert not np.any(np.all(turns_after_every_change(1 + accuracy), axis=0))


def test_reach_of_the_knuckle_pin_is_the_largest_over_the_turn():
    geometry = articulated_rods(N, 6).geometry
    searched = np.max(knuckle_distance(np.linspace(0, 2 * np.pi, 7200), geometry), axis=-1, keepdims=True)
    np.testing.assert_allclose(knuckle_reach(geometry).distance, searched, rtol=2e-5)
    assert np.all(knuckle_reach(geometry).distance >= searched * (1 - 1e-12))
