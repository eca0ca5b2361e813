"""Numbers that are followed through rules, against the rules asked of each design by itself."""

import math

import numpy as np
import pytest

from cranktrain.motion import chosen, plain
from cranktrain.study.sweep.followed import FollowedNumber, NotFollowed, RuleCourse

SIZES = np.array([2.0, 1.0, 3.0, 2.0, -1.0, 0.0, 0.5, 2.5, 1e-300, np.nan, np.inf, -0.0])
OTHERS = np.array([1.0, 1.0, 2.0, 5.0, 1.0, 1.0, 0.5, 0.0, 1e-300, 1.0, 1.0, 2.0])


def followed(rule, sizes=SIZES, others=OTHERS):
    """Answers of a rule for all, by following the first one that is left; and how many ways there were."""
    answers, left, ways = np.full(sizes.size, None, dtype=object), np.arange(sizes.size), 0
    while left.size:
        course = RuleCourse(left.size)
        try:
            with np.errstate(all="ignore"):
                answer = rule(FollowedNumber(course, sizes[left]), FollowedNumber(course, others[left]))
        except ZeroDivisionError:
            answer = ZeroDivisionError
        assert course.goes_along[0]
        answers[left[course.goes_along]] = bool(answer) if not isinstance(answer, type) else answer
        left, ways = left[~course.goes_along], ways + 1
    return answers.tolist(), ways


def each(rule, sizes=SIZES, others=OTHERS):
    """Answers of a rule for each by itself."""
    answers = []
    for size, other in zip(sizes.tolist(), others.tolist(), strict=True):
        try:
            with np.errstate(all="ignore"):
                answers.append(bool(rule(size, other)))
        except ZeroDivisionError:
            answers.append(ZeroDivisionError)
    return answers


def _within(size, other):
    return -other <= size <= 2 * other


def _branches(size, other):
    if size > other:
        return size - other > 1
    return abs(other - size) < 0.5 or other == 5


RULES = [
    lambda size, other: size > other,
    lambda size, other: not size >= other,
    lambda size, other: size == other or size != size,
    _within,
    _branches,
    lambda size, other: size / other > 1.5,
    lambda size, other: 1 + 1 / size < 2,
    lambda size, _other: size in (1.0, 2.0, None),
    lambda size, other: max(size, other, 1.5) == size,
    lambda size, other: sum(one > 1 for one in (size, other)) == 1,
    lambda size, other: [10, 20, 30][sum(one > 1 for one in (size, other))] > 15,
    lambda size, other: sorted([size, other, 1.0])[0] < 1,
    lambda size, other: np.isnan(np.sqrt(np.subtract(size, 1.0))) or other > 1,
    lambda size, other: bool(np.where(np.greater(size, other), size, other) > 1.5),
    lambda size, other: np.hypot(size, other) > 2,
    lambda size, other: chosen(size > 0.0, size, other) >= 1,
    lambda size, other: np.sin(size) * np.cos(other) > 0.3,
    lambda size, other: plain(np.ravel(size)[0]) < plain(other),
    lambda size, other: float(size) < float(other),
    math.isclose,
    lambda size, other: abs(-size + 3) > +other,
    lambda size, other: (size > 1) == (other > 1),
    lambda size, other: np.any(np.array([1.0, 2.0]) * size > 3) and other > 0,
]


@pytest.mark.parametrize("rule", RULES)
def test_each_answer_is_that_of_the_design_alone(rule):
    answers, ways = followed(rule)
    assert answers == each(rule)
    assert ways <= SIZES.size


def test_powers_are_those_of_one_number():
    """Of one number the C library makes them, of many NumPy: both to a bit, and rules see which."""
    random = np.random.default_rng(1)
    sizes, others = random.uniform(0.1, 10, (2, 2000))
    wanted = [one**2.5 for one in sizes.tolist()]
    course = RuleCourse(sizes.size)
    assert (FollowedNumber(course, sizes) ** 2.5).column.tolist() == wanted
    assert (2.0 ** FollowedNumber(course, others)).column.tolist() == [2.0**one for one in others.tolist()]
    with pytest.raises(NotFollowed):
        FollowedNumber(course, -sizes) ** 0.5


def test_a_rule_is_followed_once_for_all_that_go_along():
    sizes = np.linspace(0.0, 10.0, 10_000)
    answers, ways = followed(_within, sizes, np.full(sizes.size, 2.0))
    assert ways == 2
    assert answers == each(_within, sizes, np.full(sizes.size, 2.0))


@pytest.mark.parametrize(
    "use",
    [
        float,
        int,
        math.sin,
        round,
        lambda size: np.array([1.0, 2.0]) * size,
        lambda size: np.linspace(0.0, size, 3),
        hash,
        lambda size: {size: 1},
        lambda size: np.array([size, 1.0]),
        np.asarray,
        lambda size: np.array([size], dtype=object),
    ],
)
def test_many_numbers_that_are_made_plain_are_not_followed(use):
    course = RuleCourse(100)
    with pytest.raises(NotFollowed):
        use(FollowedNumber(course, np.linspace(1.0, 2.0, 100)))


@pytest.mark.parametrize("use", [hash, np.asarray, lambda size: np.array([size]), lambda size: {size}])
def test_what_may_be_kept_takes_no_followed_number(use):
    """Not even where all designs have the same: it would be found again by others."""
    with pytest.raises(NotFollowed):
        use(FollowedNumber(RuleCourse(3), np.ones(3)))


def test_no_rule_catches_it_as_an_error():
    assert not issubclass(NotFollowed, Exception)


def test_it_says_the_number_that_is_looked_at():
    size = FollowedNumber(RuleCourse(2), np.array([0.25, 3.0]))
    assert (f"{size:.3f}", str(size), f"{2 * size}") == ("0.250", "0.25", "0.5")
