"""A load from a file: its sizes over the crank angle, or over a travel or swing there and back, as a card has them."""

from functools import lru_cache
from typing import ClassVar, NamedTuple

import numpy as np

from cranktrain.errors import Position
from cranktrain.language import N_
from cranktrain.layout.cycle_table import CycleFileSpec, Words, given_curve
from cranktrain.layout.load_heads import SORTS, LoadHeads, Over, Sort, load_heads
from cranktrain.layout.load_ways import round_trip, side_by_side
from cranktrain.motion import Array
from cranktrain.number_table import NumberTable, held_text, read_table
from cranktrain.numerics.ties import first_largest, first_smallest
from cranktrain.quantities import Dimension, Given, read


class LoadCard(NamedTuple):
    """What a file says of a load.

    Attributes
    ----------
    sort : "force" or "torque"
    over : "crank_angles", "travel" or "swing"
    places : tuple of Given
        Rising.
    out : tuple of Given
        Sizes there, of a travel on the way out.
    back : tuple of Given, or None
        Sizes on the way back; None over the crank angle.
    first, last : Position
        Where the file has the least place and the greatest.
    negative : tuple of (str, Position)
        Sizes of less than 0, as the file has them.
    """

    sort: Sort
    over: Over
    places: tuple[Given, ...]
    out: tuple[Given, ...]
    back: tuple[Given, ...] | None
    first: Position
    last: Position
    negative: tuple[tuple[str, Position], ...]


class _ForceCurve(CycleFileSpec, frozen=True):
    """Forces over the crank angle, whose unit stands in the head."""

    words: ClassVar[Words] = Words(N_("a load"), N_("force"), Dimension.FORCE, "file", ("", ""))

    @property
    def unit(self) -> str | None:
        """None: the table of the load names none."""
        return None


class _TorqueCurve(_ForceCurve, frozen=True):
    """Torques over the crank angle, whose unit stands in the head."""

    words: ClassVar[Words] = Words(N_("a load"), N_("torque"), Dimension.TORQUE, "file", ("", ""))


@lru_cache(maxsize=16)
def load_card(file: str, text: str | None, columns: tuple[int, ...] | None) -> LoadCard:
    r"""Read the file of a load.

    Parameters
    ----------
    file : str
        Its name, for messages.
    text : str or None
        What it holds.
    columns : tuple of int or None
        Of place and size, or of place, size on the way out and on the way back, from 1; as the file has them if None.

    Returns
    -------
    LoadCard

    Raises
    ------
    InputError
        With all that is wrong in it, at line and column where it has one; or if nobody has read it.

    Notes
    -----
    Over a travel either the size on the way back has a column of its own, or the rows go there and back: a closed loop,
    which may begin anywhere. Over the crank angle it is a curve as `given_curve` reads it.

    Examples
    --------
    >>> card = load_card("card.csv", "travel [mm];force [N]\n0;10\n80;30\n80;5\n0;5\n0;10", None)
    >>> [size.text for size in card.out], [size.text for size in card.back]
    (['10 N', '30 N'], ['5 N', '5 N'])
    """
    table = read_table(held_text(file, text), file)
    heads = load_heads(table, columns)
    if heads.over == "crank_angles":
        return _over_angle(table, heads, text)
    rows = round_trip(table, heads) if len(heads.levels) == 1 else side_by_side(table, heads)
    travel = table.rows[:, heads.where]
    places = np.union1d(*(travel[branch] for branch in rows))
    levels = (heads.levels[0], heads.levels[-1])
    out, back = (
        np.asarray(np.interp(places, travel[branch], table.rows[branch, level]), dtype=np.float64)
        for branch, level in zip(rows, levels, strict=True)
    )
    dimension = Dimension.LENGTH if heads.over == "travel" else Dimension.ANGLE
    return LoadCard(
        sort=heads.sort,
        over=heads.over,
        places=_given(places, heads.place_unit, dimension),
        out=_given(out, heads.units[0], SORTS[heads.sort]),
        back=_given(back, heads.units[-1], SORTS[heads.sort]),
        first=table.position(first_smallest(travel), heads.where),
        last=table.position(first_largest(travel), heads.where),
        negative=_negative(table, heads),
    )


def _given(numbers: Array, unit: str, dimension: Dimension) -> tuple[Given, ...]:
    """Give numbers of a file as quantities."""
    scale = read(f"1 {unit}", dimension)
    return tuple(Given(scale * number, f"{number:.12g} {unit}") for number in numbers.tolist())


def _negative(table: NumberTable, heads: LoadHeads) -> tuple[tuple[str, Position], ...]:
    """Find sizes of less than 0."""
    found = ((row, level) for level in heads.levels for row in np.flatnonzero(table.rows[:, level] < 0).tolist())
    return tuple((f"{table.rows[row, level]:g}", table.position(row, level)) for row, level in found)


def _over_angle(table: NumberTable, heads: LoadHeads, text: str | None) -> LoadCard:
    """Take sizes over the crank angle as any curve over it."""
    kind = _ForceCurve if heads.sort == "force" else _TorqueCurve
    columns = (heads.where + 1, heads.levels[0] + 1)
    curve = given_curve(kind.model_construct(file=table.name, text=text, columns=columns))
    unit = "N" if heads.sort == "force" else "N*m"
    # With the first point at the end again, it is plain whether they go on over one turn or two.
    angles, values = np.append(curve.angles, curve.angles[0] + curve.period), np.append(curve.values, curve.values[0])
    return LoadCard(
        sort=heads.sort,
        over=heads.over,
        places=_given(np.degrees(angles), "deg", Dimension.ANGLE),
        out=_given(values, unit, SORTS[heads.sort]),
        back=None,
        first=table.position(0, heads.where),
        last=table.position(len(table.lines) - 1, heads.where),
        negative=_negative(table, heads),
    )
