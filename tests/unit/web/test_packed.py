"""Data for a browser: what a record becomes, and where its numbers stand."""

import json

import numpy as np
import pytest

from cranktrain.language import _
from cranktrain.record import record
from cranktrain.web.packed import packed


@record
class _Bore:
    size: float
    names: tuple[str, ...]
    curve: np.ndarray


def array(found, place):
    size = int(np.prod(place["shape"]))
    return found.numbers[place["at"] : place["at"] + size].reshape(place["shape"])


def test_record_says_what_it_is():
    found = packed(_Bore(0.15, ("1L", "1R"), np.array([[1.0, 2.0], [3.0, np.nan]])))
    assert found.data == {"is": "_Bore", "size": 0.15, "names": ["1L", "1R"], "curve": {"at": 0, "shape": [2, 2]}}
    np.testing.assert_array_equal(array(found, found.data["curve"]), np.float32([[1, 2], [3, np.nan]]))


def test_the_same_numbers_stand_there_once():
    angle = np.linspace(0.0, 720.0, 721)
    found = packed([angle, angle.copy(), 2 * angle])
    assert [one["at"] for one in found.data] == [0, 0, 721]
    assert found.numbers.size == 2 * 721


def test_what_is_no_number_is_null():
    found = packed(
        {"hole": np.nan, "far": np.inf, "size": np.float64(2.5), "n": np.int64(3), "is_filled": np.array([True])}
    )
    assert json.dumps(found.data, allow_nan=False) == (
        '{"hole": null, "far": null, "size": 2.5, "n": 3, "is_filled": [true]}'
    )


def test_words_are_said():
    assert packed(_("{n} rods", n=3)).data == "3 rods"


def test_what_has_no_numbers_has_no_block():
    assert packed("rod").numbers.size == 0


def test_bytes_are_a_length_json_and_first_bytes_before_second_ones():
    content = packed([np.array([1.5, -2.0])]).content
    assert content == b"\x16\x00\x00\x00" + b'[{"at":0,"shape":[2]}]' + bytes.fromhex("0000 0000 c000 3fc0")


def test_what_a_browser_cannot_take_is_refused():
    with pytest.raises(TypeError, match="complex"):
        packed(1j)
