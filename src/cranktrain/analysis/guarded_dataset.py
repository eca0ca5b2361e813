"""An xarray dataset that says so before it makes more rows of a data frame than anybody wants."""

from collections.abc import Hashable, Sequence
from math import prod
from typing import Any

import xarray

from cranktrain.errors import InputError, Problem
from cranktrain.language import _

_MOST_ROWS = 10_000_000


class Dataset(xarray.Dataset):
    """A dataset whose `to_dataframe` would combine members of dimensions that no quantity has together."""

    __slots__ = ()

    def to_dataframe(self, dim_order: Sequence[Hashable] | None = None) -> Any:
        """Give a data frame as xarray does, a row for each combination of members of all dimensions.

        Raises
        ------
        InputError
            Where that would be more than ten million.
        """
        n_rows = prod(self.sizes.values())
        if n_rows > _MOST_ROWS:
            allowed = _(
                "would have {n_rows:.0e} rows, one for each combination of {dimensions}",
                n_rows=float(n_rows),
                dimensions=", ".join(map(str, self.sizes)),
            )
            repair = _("take result.curves() and result.facts_table(), or choose quantities: dataset[[…]]")
            raise InputError([Problem("to_dataframe", None, allowed, repair)])
        return super().to_dataframe(dim_order)
