"""A sweep of whatever one has of a machine: kept in a store where one is named, told in notebooks how far it is."""

import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from cranktrain.errors import problems_as
from cranktrain.io.any_machine import MachineLike, sources_of
from cranktrain.io.notebook_line import said_in_notebooks
from cranktrain.study.sweep import Sweep, swept

if TYPE_CHECKING:
    from distributed import Client


def any_swept(
    machine: MachineLike,
    vary: Mapping[str, object] | Sequence[Mapping[str, object]],
    wanted: Sequence[str] | None,
    values: Mapping[str, object],
    *,
    over_time: bool,
    processes: int,
    store: "str | os.PathLike[str] | None",
    resume: bool,
    scheduler: "str | Client | None",
) -> Sweep:
    """Compute facts of a machine over values of its file, as `sweep` of the package says; `values` are of all designs.

    Raises
    ------
    InputError
    """
    source = sources_of(machine, values, partial=False)[0][0]
    kept = None
    if store is not None:
        from cranktrain.io.store_of_sweep import SweepStore  # only for who asks

        kept = SweepStore(store, resume=resume)
    with problems_as(source.placed), said_in_notebooks():
        return swept(
            source.machine,
            vary,
            wanted,
            over_time=over_time,
            processes=processes,
            settings=tuple(values),
            store=kept,
            scheduler=scheduler,
        )
