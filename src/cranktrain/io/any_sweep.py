"""A sweep of whatever one has of a machine: kept in a store where one is named, told in notebooks how far it is."""

import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING, cast

from cranktrain.errors import InputError, Problem, problems_as, refuse
from cranktrain.io.any_machine import MachineLike, sources_of
from cranktrain.io.notebook_line import said_in_notebooks
from cranktrain.language import _
from cranktrain.study.sweep import Sweep, swept
from cranktrain.study.sweep.kept import STORE

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
    refuse(_misfitting(processes, store, resume=resume))
    sources, are_several = sources_of(machine, values, partial=False)
    if are_several:
        allowed = _(
            "must be one; of several, run([…]) gives all results, and a sweep of one takes tables as values, too"
        )
        raise InputError([Problem("machine", None, allowed)])
    source, kept = sources[0], None
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


def _misfitting(processes: object, store: object, *, resume: bool) -> Iterator[Problem]:
    """Find parameters that are none, or say nothing where they stand."""
    if not isinstance(processes, int) or isinstance(processes, bool) or processes < 1:
        yield Problem("processes", repr(processes), _("must be a whole number, at least 1"))
    is_path = isinstance(store, str | os.PathLike)
    if store is not None and not (is_path and PurePath(cast("str", store)).suffix.lower() == STORE):
        yield Problem(
            "store", str(cast("object", store)), _("must be the path of a folder, {example}", example=f'"NAME{STORE}"')
        )
    if resume and store is None:
        yield Problem("resume", None, _("needs a store"), _("write {example}", example=f'store="NAME{STORE}"'))
