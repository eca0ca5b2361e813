"""Lines with fewer points, and values with fewer bits: nothing of them is lost that could be seen."""

import numpy as np
import pytest

from cranktrain.web.as_seen import in_bits_seen, outlined

TURN = np.deg2rad(np.linspace(0.0, 360.0, 361))
CIRCLE = np.stack([np.cos(TURN), np.sin(TURN)])


def missed(line, point):
    """How far a point is from the nearest piece of a line."""
    start, along = line[:, :-1], np.diff(line)
    part = np.clip(np.sum((point[:, np.newaxis] - start) * along, axis=0) / np.sum(along**2, axis=0), 0.0, 1.0)
    return np.min(np.hypot(*(point[:, np.newaxis] - start - part * along)))


@pytest.mark.parametrize("far", [1e-2, 1e-3, 2e-4])
def test_no_point_is_farther_from_the_line_than_it_may_be(far):
    spike = CIRCLE * (1.0 + 0.8 * np.exp(-(((np.degrees(TURN) - 137.0) / 2.0) ** 2)))
    for whole, found in zip((CIRCLE, spike), outlined((CIRCLE, spike), far), strict=True):
        assert found.shape[1] < whole.shape[1]
        assert max(missed(found, point) for point in whole.T) <= far
        np.testing.assert_array_equal(found[:, [0, -1]], whole[:, [0, -1]])


def test_a_circle_has_chords_as_long_as_may_be():
    # A chord over an angle t is 1 - cos(t/2) from its arc: 2.4e-3 for 8 degrees, 6.1e-4 for 4 degrees.
    assert [found.shape[1] for far in (2.6e-3, 2.4e-3, 6.2e-4) for found in outlined([CIRCLE], far)] == [46, 91, 91]


def test_a_line_that_stands_still_is_its_ends_and_what_divides_it():
    (found,) = outlined([np.zeros((2, 721))], 0.0)
    assert found.shape == (2, 46)


def test_a_line_of_odd_pieces_and_a_point_are_whole():
    for n in (1, 8):
        (found,) = outlined([CIRCLE[:, :n]], 1.0)
        np.testing.assert_array_equal(found, CIRCLE[:, :n])


@pytest.mark.parametrize("largest", [0.7, 1.0, 1023.0, 1024.0, 3e6])
def test_values_lose_what_no_arrow_shows_and_half_of_their_bytes(largest):
    values = largest * np.sin(np.linspace(0.0, 6.0, 100))
    found = in_bits_seen(values, largest)
    np.testing.assert_allclose(found, values, atol=largest / 4096, rtol=0.0)
    assert not np.any(found.astype("<f4").view(np.uint8).reshape(-1, 4)[:, 0])


def test_what_is_nothing_stays_nothing():
    np.testing.assert_array_equal(in_bits_seen(np.array([0.0, np.nan]), 0.0), [0.0, np.nan])
