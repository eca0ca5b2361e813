"""Least largest and least mean vectors: against closed forms, a brute search, and SciPy on the same problem."""

import numpy as np
import pytest
from scipy.optimize import minimize

from cranktrain.synthesis.least_loads import ALIKE, least_largest, least_mean
from cranktrain.synthesis.plane_loads import Rest, Vectors, mean_square

ENOUGH = 2 * ALIKE
"""What else matters may take `ALIKE` of the value, and the certificate is as sharp."""


def drawn(seed, n_points, n_unknowns):
    """Vectors that lie on one side, as loads of a bearing do, and unknowns that take from them."""
    rng = np.random.default_rng(seed)
    base = rng.normal(size=(n_points, 2)) + np.array([3.0, 0.0])
    return Vectors(1e4 * base, 1e4 * (0.5 * rng.normal(size=(n_points, 2, n_unknowns)) - [[1.0], [0.0]]))


def evenly(vectors):
    return np.full(len(vectors.base), 1 / len(vectors.base))


def nothing(n):
    return Rest(np.zeros(n), np.eye(n))


def moved(points):
    """Points that a vector in the plane moves against itself."""
    return Vectors(np.array(points, dtype=float), np.broadcast_to(-np.eye(2), (len(points), 2, 2)))


def sizes(vectors, unknown):
    return np.hypot(*(vectors.base + vectors.change @ unknown).T)


@pytest.mark.parametrize(
    ("points", "centre", "radius"),
    [
        ([[0.5, 0.0], [-0.5, 0.0], [0.0, 0.1]], [0.0, 0.0], 0.5),  # obtuse: half the longest side
        ([[0.3, 0.0], [-0.3, 0.0], [0.0, 0.4]], [0.0, 0.0875], 0.3125),  # acute: the circle through all three
        ([[0.0, 0.0], [0.6, 0.8]], [0.3, 0.4], 0.5),
    ],
)
def test_the_least_largest_is_the_smallest_circle(points, centre, radius):
    found = least_largest(moved(points), nothing(2), turns=True)
    assert found.unknown == pytest.approx(centre, abs=1e-3)
    assert found.value == pytest.approx(radius, rel=ENOUGH)
    assert radius * (1 - 10 * ENOUGH) <= found.bound <= radius * (1 + 1e-12)


def test_the_least_mean_is_fermats_point():
    """From which all corners of a triangle are seen 120° apart; of a flat triangle it is the flat corner."""
    even = np.exp(2j * np.pi * np.arange(3) / 3)
    triangle = 0.1 + 0.2j + 0.5 * even * [1.0, 0.6, 0.3]
    points = np.stack([triangle.real, triangle.imag], axis=1)
    found = least_mean(moved(points), evenly(moved(points)), nothing(2), turns=True)
    assert found.unknown == pytest.approx([0.1, 0.2], abs=1e-4)
    assert found.value == pytest.approx(0.5 * 1.9 / 3, rel=ENOUGH)
    flat = least_mean(moved([[0.5, 0.0], [-0.5, 0.0], [0.0, 0.1]]), np.ones(3) / 3, nothing(2), turns=True)
    assert flat.unknown == pytest.approx([0.0, 0.1], abs=1e-3)


def test_the_limit_holds():
    """Vectors that more unknown than there may be would still take from."""
    vectors = Vectors(np.array([[5.0, 0.0]]), np.array([[[-1.0, -2.0], [0.0, 0.0]]]))
    for found in (
        least_largest(vectors, nothing(2), turns=False),
        least_mean(vectors, np.ones(1), nothing(2), turns=False),
    ):
        assert np.all(found.unknown <= 1)
        assert found.value == pytest.approx(2.0, rel=1e-5)
    turned = least_largest(vectors, nothing(2), turns=True)
    assert turned.unknown == pytest.approx(np.array([1, 2]) / np.sqrt(5), abs=1e-3)
    assert turned.value == pytest.approx(5 - np.sqrt(5), rel=1e-5)


@pytest.mark.parametrize(("n_points", "n_unknowns", "turns"), [(40, 1, False), (100, 4, False), (60, 6, True)])
@pytest.mark.parametrize("seed", range(3))
def test_largest_as_scipy_finds_it(seed, n_points, n_unknowns, turns):
    vectors = drawn(seed, n_points, n_unknowns)
    found = least_largest(vectors, mean_square(vectors, evenly(vectors)), turns=turns)

    def room(at):
        own = np.sum((vectors.base / 1e4 + vectors.change / 1e4 @ at[:-1]) ** 2, axis=1)
        return at[-1] ** 2 - own

    conditions = [{"type": "ineq", "fun": room}]
    if turns:
        conditions.append({"type": "ineq", "fun": lambda at: 1 - np.sum(at[:-1].reshape(2, -1) ** 2, axis=0)})
    bounds = None if turns else [(0, 1)] * n_unknowns + [(0, None)]
    options = {"maxiter": 1000, "ftol": 1e-14}
    # Rounding decides whether its line search comes to an end, so from several starts.
    others = [
        minimize(
            lambda at: at[-1],
            np.append(np.full(n_unknowns, begin), 10.0),
            method="SLSQP",
            bounds=bounds,
            constraints=conditions,
            options=options,
        )
        for begin in (0.1, 0.2, 0.3, 0.35)
    ]
    least = min(other.fun for other in others if other.success)
    assert found.value == pytest.approx(1e4 * least, rel=ENOUGH)
    assert found.bound <= found.value * (1 + 1e-12)
    assert found.bound == pytest.approx(found.value, rel=1e-5)


@pytest.mark.parametrize(("n_unknowns", "turns"), [(1, False), (4, False), (6, True)])
@pytest.mark.parametrize("seed", range(3))
def test_mean_as_scipy_finds_it(seed, n_unknowns, turns):
    vectors = drawn(seed, 80, n_unknowns)
    weight = np.random.default_rng(seed + 100).uniform(size=80)
    weight[::7] = 0.0
    weight /= np.sum(weight)
    found = least_mean(vectors, weight, mean_square(vectors, weight), turns=turns)

    def mean(at):
        vector = vectors.base + vectors.change @ at
        own = np.hypot(*vector.T)
        slope = np.einsum("kiu,ki->u", vectors.change, (weight / own)[:, np.newaxis] * vector)
        return weight @ own / 1e4, slope / 1e4

    conditions = [{"type": "ineq", "fun": lambda at: 1 - np.sum(at.reshape(2, -1) ** 2, axis=0)}] if turns else []
    other = minimize(
        mean,
        np.full(n_unknowns, 0.1),
        jac=True,
        method="SLSQP",
        bounds=None if turns else [(0, 1)] * n_unknowns,
        constraints=conditions,
        options={"maxiter": 1000, "ftol": 1e-14},
    )
    assert found.value == pytest.approx(1e4 * other.fun, rel=ENOUGH)
    assert found.bound <= found.value * (1 + 1e-12)
    assert found.bound == pytest.approx(found.value, rel=1e-5)


@pytest.mark.parametrize("turns", [False, True])
def test_no_other_unknowns_are_better(turns):
    """Thousands drawn in the room, most of them near what was found."""
    vectors = drawn(7, 30, 2 if turns else 3)
    rng = np.random.default_rng(8)
    found = [
        least_largest(vectors, mean_square(vectors, evenly(vectors)), turns=turns),
        least_mean(vectors, evenly(vectors), mean_square(vectors, evenly(vectors)), turns=turns),
    ]
    for least, value in zip(found, (np.max, np.mean), strict=True):
        for scale in (1.0, 0.1, 0.01):
            for own in least.unknown + scale * rng.normal(size=(500, least.unknown.size)):
                inside = own / max(1.0, np.hypot(*own)) if turns else np.clip(own, 0, 1)
                assert value(sizes(vectors, inside)) >= least.bound * (1 - 1e-12)


def test_of_like_minima_the_rest_decides():
    """The second unknown does nothing for the vectors; what else matters wants it at 0.7, and the first at 0."""
    vectors = Vectors(np.array([[3.0, 1.0]]), np.array([[[-4.0, 0.0], [0.0, 0.0]]]))
    rest = Rest(np.array([0.0, -0.7]), np.eye(2))
    for found in (
        least_largest(vectors, rest, turns=False),
        least_mean(vectors, np.ones(1), rest, turns=False),
    ):
        assert found.unknown == pytest.approx([0.75, 0.7], abs=2e-3)
        assert found.value == pytest.approx(1.0, rel=ENOUGH)


def test_no_loads_at_all():
    vectors = Vectors(np.zeros((3, 2)), np.zeros((3, 2, 1)))
    assert least_largest(vectors, nothing(1), turns=False).value == 0.0
    assert least_mean(vectors, np.ones(3) / 3, nothing(1), turns=False).value == 0.0
