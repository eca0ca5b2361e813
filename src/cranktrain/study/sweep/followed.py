"""Numbers that are followed: one design's number that carries those of all along, so that rules are asked once for all.

A rule is plain Python that looks at one design: `if rod.si <= crank.si`. Asked with a `FollowedNumber` in place of each
that differs, it takes the way of the design that is looked at, and each comparison notes which designs would go another
way. All that are left at the end have gone the same way, number for number, and are right or wrong as that one is.

What makes a plain number of one (`float`, `math`, a function of arrays) goes on with the number that is looked at, and
only designs that have the same one go along. Where there are many such numbers `NotFollowed` is raised, as it is for a
key or an item of an array, which may be kept for longer than the rules: whoever asked has to ask each design by itself
then. Texts are made of the number that is looked at: they are for sentences, on which nothing hangs.
"""

import operator
from collections.abc import Callable, Sequence
from typing import Any, NoReturn, cast

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin
from numpy.typing import NDArray

Column = NDArray[Any]

_MOST_VALUES = 16
"""Of numbers that cannot be followed further."""

_NUMBERS: tuple[type, ...] = (bool, int, float, np.floating, np.integer, np.bool_)


class NotFollowed(BaseException):
    """Raised where a rule makes of a followed number what cannot be followed; no error, as rules may catch these."""


class RuleCourse:
    """The way that rules take for the design that is looked at.

    Parameters
    ----------
    n_designs : int
        How many are followed; the first is looked at.

    Attributes
    ----------
    goes_along : array of bool, shape (design,)
        Which of them went the same way so far.
    """

    def __init__(self, n_designs: int) -> None:
        self.goes_along: NDArray[np.bool_] = np.ones(n_designs, dtype=bool)

    def taken(self, truths: Column) -> bool:
        """Answer for the design that is looked at; whose answer is another, does not go along."""
        answer = bool(truths[0])
        self.goes_along &= truths if answer else ~truths
        return answer

    def fixed(self, column: Column) -> Any:
        """Give the number of the design that is looked at; who has another, does not go along."""
        bits = column.view(np.int64) if column.dtype == np.float64 else column
        if np.unique(bits[self.goes_along]).size > _MOST_VALUES:
            raise NotFollowed
        self.goes_along &= bits == bits[0]
        return column[0]


class FollowedNumber(NDArrayOperatorsMixin):
    """A number of the design that is looked at, with those of all.

    Parameters
    ----------
    course : RuleCourse
    column : array, shape (design,)
        The number in each design; truths, of what was compared.
    is_numpy : bool
        Whether it stands for a number of NumPy, which divides by 0; one of Python does not.
    """

    __slots__ = ("column", "course", "is_numpy")
    shape: tuple[int, ...] = ()
    ndim = 0
    size = 1

    def __init__(self, course: RuleCourse, column: Column, *, is_numpy: bool = False) -> None:
        self.course, self.column, self.is_numpy = course, column, is_numpy

    # What NumPy asks.

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        """Compute elementwise, for each design as NumPy would for it alone."""
        if method != "__call__" or options or not all(isinstance(one, _KNOWN) for one in inputs):
            return getattr(ufunc, method)(*map(_fixed, inputs), **options)
        is_numpy = ufunc not in _OF_PYTHON or any(_is_of_numpy(one) for one in inputs)
        if not is_numpy:
            return _as_python(self.course, ufunc, inputs)
        found = ufunc(*map(_column_of, inputs))
        if isinstance(found, tuple):
            return tuple(FollowedNumber(self.course, one, is_numpy=True) for one in cast("tuple[Column, ...]", found))
        return FollowedNumber(self.course, found, is_numpy=True)

    def __array_function__(self, function: Any, _types: object, given: Any, options: Any) -> Any:
        """Give shapes, and what is elementwise of one number."""
        if function in (np.shape, np.ndim, np.size):
            return {np.shape: (), np.ndim: 0, np.size: 1}[function]
        if function is np.where and len(given) == 3 and all(isinstance(one, _KNOWN) for one in given):
            return FollowedNumber(self.course, cast("Column", np.where(*map(_column_of, given))), is_numpy=True)
        if function in (np.any, np.all) and len(given) == 1 and given[0] is self and not options:
            return FollowedNumber(self.course, self.column.astype(bool), is_numpy=True)
        if function is np.ravel and len(given) == 1 and not options:
            return (self,)
        return function(*map(_fixed, given), **options)

    def __array__(self, *_asked: object, **_named: object) -> NoReturn:
        """Refuse to be an item of an array."""
        raise NotFollowed

    def item(self) -> "FollowedNumber":
        """As a number of Python."""
        return FollowedNumber(self.course, self.column)

    # What Python asks.

    def __bool__(self) -> bool:
        """Go the way of the design that is looked at."""
        return self.course.taken(self.column.astype(bool))

    def __abs__(self) -> "FollowedNumber":
        return FollowedNumber(self.course, np.abs(self.column), is_numpy=self.is_numpy)

    def __pos__(self) -> "FollowedNumber":
        return self

    def __eq__(self, other: object) -> Any:
        """Compare; with what is no number, as Python does."""
        return self._compared(operator.eq, other)

    def __ne__(self, other: object) -> Any:
        """Compare; with what is no number, as Python does."""
        return self._compared(operator.ne, other)

    def _compared(self, compare: Callable[[Any, Any], Any], other: object) -> Any:
        if not isinstance(other, _KNOWN):
            return compare(_fixed(self), other) if isinstance(other, np.ndarray) else NotImplemented
        return FollowedNumber(self.course, compare(self.column, _column_of(other)), is_numpy=self.is_numpy)

    def __pow__(self, other: object) -> "FollowedNumber":
        """As the C library does for one number, which NumPy does not for many."""
        return self._power(self, other)

    def __rpow__(self, other: object) -> "FollowedNumber":
        """As the C library does for one number, which NumPy does not for many."""
        return self._power(other, self)

    def _power(self, base: object, exponent: object) -> "FollowedNumber":
        if not isinstance(base, _KNOWN) or not isinstance(exponent, _KNOWN):
            return _fixed(base) ** _fixed(exponent)
        bases, exponents = (np.broadcast_to(_column_of(one), self.column.shape).tolist() for one in (base, exponent))
        try:
            found = list(map(pow, bases, exponents))
        except ArithmeticError:
            raise NotFollowed from None
        if not {*map(type, found)} <= {float}:
            raise NotFollowed
        is_numpy = self.is_numpy or _is_of_numpy(base) or _is_of_numpy(exponent)
        return FollowedNumber(self.course, np.array(found), is_numpy=is_numpy)

    def __format__(self, form: str) -> str:
        """Say the number that is looked at."""
        return format(self.column[0].item(), form)

    def __str__(self) -> str:
        """Say the number that is looked at."""
        return str(self.column[0].item())

    __repr__ = __str__

    def __float__(self) -> float:
        """Go on with the number that is looked at."""
        return float(self.course.fixed(self.column))

    def __index__(self) -> int:
        """Go on with the number that is looked at."""
        return operator.index(self.course.fixed(self.column))

    def __int__(self) -> int:
        """Go on with the number that is looked at."""
        return int(self.course.fixed(self.column))

    def __round__(self, digits: int | None = None) -> float:
        """Go on with the number that is looked at."""
        return round(float(self), digits)

    def __hash__(self) -> int:
        """Refuse to be a key: what is found by it may be kept, and asked for by others."""
        raise NotFollowed


_OF_PYTHON = {
    np.add, np.subtract, np.multiply, np.divide, np.negative,
    np.less, np.less_equal, np.greater, np.greater_equal,
}  # fmt: skip
"""What operators of Python's own numbers do as NumPy does, but where a divisor is 0."""


def _as_python(course: RuleCourse, ufunc: np.ufunc, inputs: Sequence[Any]) -> FollowedNumber:
    """Compute as an operator of numbers of Python does."""
    columns = [_column_of(one) for one in inputs]
    if ufunc is np.divide and course.taken(np.broadcast_to(columns[1] == 0, course.goes_along.shape)):
        raise ZeroDivisionError
    return FollowedNumber(course, ufunc(*columns))


_KNOWN: tuple[type, ...] = (FollowedNumber, *_NUMBERS)


def _column_of(value: Any) -> Any:
    """Numbers of all designs, or one of all."""
    return value.column if isinstance(value, FollowedNumber) else value


def _fixed(value: Any) -> Any:
    """Go on with the number that is looked at."""
    return value.course.fixed(value.column) if isinstance(value, FollowedNumber) else value


def _is_of_numpy(value: object) -> bool:
    """Whether a number divides as NumPy's do."""
    return value.is_numpy if isinstance(value, FollowedNumber) else isinstance(value, np.generic)
