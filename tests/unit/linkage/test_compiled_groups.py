"""The groups' kernels compiled give what they give on arrays, number by number."""

import numpy as np
import pytest

from cranktrain.linkage import (
    AHEAD,
    GUIDE,
    ROD,
    Crank,
    Ends,
    Leg,
    LinkPoint,
    OnLine,
    Pose,
    Swivel,
    Trammel,
    Triad,
    TriadDriver,
    TriadEnds,
    Yoke,
    block_along,
    compiled,
    crank,
    fixed,
    fixed_guide,
    point,
    rod_between,
    rod_end,
    swivel,
    swivel_gap,
    trammel,
    triad,
    turned_link,
    yoke,
)

ANGLES = np.linspace(-1.0, 1.0, 7)
STILL = 0.0 * ANGLES
PIN = crank(ANGLES, Crank(0.1))
ENDS = Ends(PIN, fixed(STILL, STILL - 0.3))
GUIDED = Swivel(0.05, AHEAD)
LEVER = swivel(ENDS, GUIDED).guide
LEGS = Triad(
    Leg(LinkPoint(0.0, 0.0), 0.8, ROD), Leg(LinkPoint(0.4, 4.0), 0.0, GUIDE), Leg(LinkPoint(0.3, 0.5), 0.8, ROD)
)
TRIAD_ENDS = TriadEnds(rod_end(PIN), LEVER, rod_end(fixed(STILL + 0.8, STILL + 0.3)))
POSE = Pose(STILL + 0.37, STILL + 0.75, STILL + 2.96)


def flat(value) -> list:
    return [part for field in value for part in flat(field)] if isinstance(value, tuple) else [value]


def number(value, i: int):
    """The i-th number of every array in nested tuples."""
    if isinstance(value, tuple):
        parts = [number(part, i) for part in value]
        return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
    return float(np.broadcast_to(value, ANGLES.shape)[i])


@pytest.mark.parametrize(
    ("kernel", "driver", "geometry"),
    [
        (swivel, ENDS, (GUIDED,)),
        (swivel_gap, ENDS, (GUIDED,)),
        (yoke, PIN, (Yoke(0.1, 1.0),)),
        (trammel, LEVER, (Trammel(0.2, 0.01),)),
        (turned_link, LEVER, (0.3,)),
        (triad, TriadDriver(TRIAD_ENDS, POSE), (LEGS,)),
        (rod_between, PIN, (point(LEVER, LinkPoint(0.2, 0.0)),)),
        (block_along, OnLine(fixed_guide(STILL, STILL, STILL + 0.3), PIN), ()),
    ],
    ids=lambda value: getattr(value, "__name__", ""),
)
def test_compiled_gives_the_same_numbers(kernel, driver, geometry):
    expected = kernel(driver, *geometry)
    assert np.isfinite(np.hstack(flat(expected))).all()
    for i in range(len(ANGLES)):
        found = compiled(kernel)(number(driver, i), *number(geometry, i))
        # The last place of an arc tangent differs between the two libraries.
        np.testing.assert_allclose(flat(found), flat(number(expected, i)), rtol=4e-16, atol=0)
