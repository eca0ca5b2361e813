"""Designs of a sweep in blocks, one behind the other, each of which is a box of what is varied."""

from functools import cached_property
from math import prod

import numpy as np

from cranktrain.record import record


@record
class Blocks:
    """How designs are cut into blocks.

    A block of a sweep over several numbers is one value of the first of them, or some, and all values of the last, as
    the chunks of an array are: it is a box, and its designs still stand one behind the other.

    Attributes
    ----------
    shape : tuple of int
        How many values there are along each of what is varied.
    chunk : tuple of int
        How many of them a block has; at the ends there may be fewer.
    """

    shape: tuple[int, ...]
    chunk: tuple[int, ...]

    @cached_property
    def grid(self) -> tuple[int, ...]:
        """How many blocks there are along each."""
        return tuple(-(-size // part) for size, part in zip(self.shape, self.chunk, strict=True))

    def __len__(self) -> int:
        return prod(self.grid)

    def place(self, number: int) -> tuple[int, ...]:
        """Where a block stands along each."""
        return tuple(map(int, np.unravel_index(number, self.grid)))

    def box(self, number: int) -> tuple[slice, ...]:
        """Which values of each a block has."""
        each = zip(self.place(number), self.chunk, self.shape, strict=True)
        return tuple(slice(place * part, min((place + 1) * part, size)) for place, part, size in each)

    def span(self, number: int) -> tuple[int, int]:
        """Places of its first design among all, and of the next one's first."""
        box = self.box(number)
        first = int(np.ravel_multi_index([one.start for one in box], self.shape))
        return first, first + prod(one.stop - one.start for one in box)


def blocks_of(shape: tuple[int, ...], most: int) -> Blocks:
    """Cut designs into blocks of about equal size, of `most` designs at most.

    Examples
    --------
    >>> blocks_of((200, 5000), 1500).chunk, blocks_of((200, 3), 64).chunk
    ((1, 1250), (20, 3))
    """
    chunk, room = [1] * len(shape), most
    for place in reversed(range(len(shape))):
        size = shape[place]
        chunk[place] = size if size <= room else -(-size // -(-size // room))
        if size > room:
            break
        room //= size
    return Blocks(shape, tuple(chunk))
