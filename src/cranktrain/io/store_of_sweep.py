"""A sweep as a Zarr store: a chunk for each block of designs, from which one can go on after a stop at any moment."""

import json
import os
import secrets
import shutil
import warnings
from collections.abc import Generator, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from contextlib import contextmanager, suppress
from dataclasses import asdict, replace
from itertools import product
from pathlib import Path
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from cranktrain.analysis.dataset import attributes_of, coordinate_of
from cranktrain.errors import InputError, Problem
from cranktrain.extras import imported
from cranktrain.io.files import refusal
from cranktrain.io.output import look_into_folder, not_written
from cranktrain.io.store_identity import differences, identity
from cranktrain.io.stored_facts import StoredFacts, TextsOfDesigns
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.one_line import one_line
from cranktrain.saying.catalogue import Entry
from cranktrain.study.facts_of_rows import FactsOfRows, joined_rows
from cranktrain.study.sweep import Sweep
from cranktrain.study.sweep.blocks import Blocks
from cranktrain.study.sweep.kept import Plan
from cranktrain.version import VERSION

_ABOUT = "cranktrain_sweep"
"""Attribute of a store with what it is of, as JSON."""


class SweepStore:
    """A store of one sweep in a folder; see docs/scale.md.

    What a sweep is of stands in the store, and each fact is an array along what is varied and its own dimensions, in
    SI and degrees. A chunk of each array is a block of designs; that of `status`, which is written last, says that the
    block is done. Every file of it appears whole or not at all, and so a process that is killed leaves a store.

    Parameters
    ----------
    path : str or path-like
    resume : bool
        Go on with what is there; where nothing is, begin.
    force : bool
        Begin anew in place of what is there.

    Raises
    ------
    InputError
        If zarr is not installed.
    """

    def __init__(self, path: "str | os.PathLike[str]", *, resume: bool = False, force: bool = False) -> None:
        self._path, self._resume, self._force = Path(path), resume, force
        self._zarr = imported("zarr", "store")
        self._labels: dict[str, tuple[str, ...]] = {}
        self._entries: dict[str, Entry] = {}
        self._done: set[int] = set()
        self._group: Any = None
        self._blocks = Blocks((), ())
        self._about: dict[str, Any] = {}
        self._is_resumed = False

    @property
    def name(self) -> str:
        """Its name as it is shown."""
        return one_line(str(self._path))

    @property
    def done(self) -> AbstractSet[int]:
        """Numbers of the blocks that are kept."""
        return self._done

    @property
    def is_whole(self) -> bool:
        """Whether all blocks are kept."""
        return len(self._done) == len(self._blocks)

    @property
    def n_done(self) -> int:
        """How many designs are kept."""
        spans = map(self._blocks.span, self._done)
        return sum(after - first for first, after in spans)

    def opened(self, plan: Plan) -> Blocks | None:
        """Open what is there, if it is this sweep; None where it is to begin."""
        self._sweep = Sweep(plan.machine, plan.designs, FactsOfRows({}, {}, {}, (), (), (), ()))
        if not os.path.lexists(self._path):
            look_into_folder(self._path, self.name)
            return None
        about = _about(self._path, self.name)
        if not self._resume:
            if self._force:
                return None
            raise refusal(
                self.name,
                _("is there already"),
                _("--resume (in Python resume=True) goes on with it, --force replaces it"),
            )
        if different := list(differences(about, identity(plan), self.name)):
            raise InputError(different)
        with self._writing():
            _swept_clean(self._path)
            self._about, self._is_resumed = about, True
            self._group = self._zarr.open_group(self._path, mode="r+", zarr_format=3, use_consolidated=False)
            self._labels = {name: tuple(words) for name, words in about["labels"].items()}
            self._entries = {name: _entry(fields) for name, fields in about["entries"].items()}
            self._blocks = Blocks(self._sweep.shape, tuple(about["chunk"]))
            self._have_room()
        numbers = np.arange(len(self._blocks)).reshape(self._blocks.grid)
        if self._sweep.over is not None:
            numbers = np.moveaxis(numbers, self._sweep.over, -1)
        self._done = set(_there(self._path / TextsOfDesigns.STATUS / "c", numbers))
        return self._blocks

    def begin(self, plan: Plan, blocks: Blocks) -> None:
        """Make the store, beside its place and then there."""
        self._blocks = blocks
        self._about = {**identity(plan), "chunk": blocks.chunk, "labels": {}, "entries": {}}
        beside = self._path.with_name(f".cranktrain-{secrets.token_hex(8)}.tmp")
        old = beside.with_suffix(".old")
        with self._writing(is_begun=False):
            try:
                self._group = self._zarr.open_group(beside, mode="w-", zarr_format=3)
                self._begin_arrays()
                if os.path.lexists(self._path):
                    self._path.rename(old)
                beside.rename(self._path)
            finally:
                shutil.rmtree(beside, ignore_errors=True)
                shutil.rmtree(old, ignore_errors=True)
            self._group = self._zarr.open_group(self._path, mode="r+", zarr_format=3, use_consolidated=False)

    def add(self, number: int, found: FactsOfRows, *, is_lost: bool = False) -> None:
        """Keep the facts of a block: that it is done is written behind all else."""
        whole = joined_rows([found], self._labels)
        box = self._blocks.box(number)
        with self._writing():
            if whole.labels != self._labels or not whole.entries.keys() <= self._entries.keys():
                self._labels = dict(whole.labels)
                self._entries = {**self._entries, **whole.entries}
                self._have_room()
            for name, values in whole.values.items():
                self._put(name, values, box)
            for name, texts in TextsOfDesigns.of(found):
                if self._is_resumed or any(texts):
                    self._put(name, np.array(texts, dtype=object), box)
            if not is_lost:
                self._put(TextsOfDesigns.STATUS, TextsOfDesigns.status(found), box)
                self._done.add(number)

    def end(self) -> None:
        """Let readers find all at once; whether it can be written or not, the store is whole."""
        with suppress(OSError):
            self._consolidate()

    def found(self) -> FactsOfRows:
        """Give what is kept, read when it is asked for."""
        return StoredFacts(self._group, self._sweep, self._entries, self._labels).as_facts()

    @contextmanager
    def _writing(self, *, is_begun: bool = True) -> Generator[None]:
        """Say why something cannot be written, and of a store that was begun that nothing is lost."""
        try:
            yield
        except OSError as error:
            problems = not_written(self.name, error).problems
            raise InputError(map(_with_resume, problems) if is_begun else problems) from None

    def _put(self, name: str, values: NDArray[Any], box: tuple[slice, ...]) -> None:
        """Write the values of a block, shape (design, …)."""
        sizes = [one.stop - one.start for one in box]
        apart, over = values.reshape(*sizes, *values.shape[1:]), self._sweep.over
        if over is None:
            region = (*box, *(slice(None),) * (values.ndim - 1))
        else:
            apart = np.moveaxis(apart, over, -1)
            beside = [own for place, own in enumerate(box) if place != over]
            region = (*beside, *(slice(None),) * (values.ndim - 1), box[over])
        self._group[name][region] = apart

    def _begin_arrays(self) -> None:
        """Make what a store has before anything is computed: what it is of, what is varied, what is said of designs."""
        sweep = self._sweep
        names = [one.name for one in sweep.designs.varied] if sweep.designs.is_listed else []
        coordinates = {"coordinates": " ".join(names)} if names else {}
        self._write_about({"name": str(sweep.subject), "cranktrain": VERSION, **coordinates})
        for one in sweep.along:
            if one.numbers is None:
                self._coordinate(one.name, (one.name,), np.array(one.texts, dtype=object), {})
            else:
                self._coordinate(one.name, (one.name,), one.numbers, {"units": one.unit, "symbol": ""})
        for name, unit, _symbol, values in sweep.case_coordinates:
            self._coordinate(name, (sweep.along[0].name,), values, {"units": unit} if unit else {})
        for name, (kind, about) in TextsOfDesigns.arrays().items():
            self._array(name, None, kind, about)
        self._consolidate()

    def _have_room(self) -> None:
        """Have an array for each fact, with room for all members; what is not computed is NaN."""
        self._about |= {"labels": self._labels, "entries": {name: asdict(one) for name, one in self._entries.items()}}
        self._write_about({})
        used = {dimension for entry in self._entries.values() for dimension in entry.dimensions}
        for dimension in sorted(used):
            members = coordinate_of(dimension, self._labels[dimension])
            self._coordinate(
                dimension, (dimension,), np.array(members, dtype=object if _are_texts(members) else None), {}
            )
        for name, entry in self._entries.items():
            self._array(name, entry, "f8", attributes_of(entry, entry.unit, self._entries))
        self._consolidate()

    def _write_about(self, more: Mapping[str, str]) -> None:
        self._group.attrs.update({**more, _ABOUT: json.dumps(self._about, ensure_ascii=False)})

    def _array(self, name: str, entry: Entry | None, kind: str, about: Mapping[str, object]) -> None:
        """Make an array along what is varied and a fact's own dimensions, or make it larger."""
        own = [] if entry is None else [len(self._labels[dimension]) for dimension in entry.dimensions]
        shape, chunks = (self._in_order(sizes, own) for sizes in (self._blocks.shape, self._blocks.chunk))
        if name not in self._group:
            self._group.create_array(
                name,
                shape=shape,
                chunks=[max(size, 1) for size in chunks],
                dtype=str if kind == "str" else kind,
                fill_value={"f8": np.nan, "str": ""}.get(kind, 0),
                dimension_names=self._sweep.dimensions_of(entry),
                attributes=dict(about),
            )
        elif self._group[name].shape != shape:
            self._group[name].resize(shape)

    def _in_order(self, sizes: Sequence[int], own: Sequence[int]) -> tuple[int, ...]:
        """Sizes along what is varied, a fact's own dimensions, and the axis."""
        over = self._sweep.over
        beside = [size for place, size in enumerate(sizes) if place != over]
        return (*beside, *own, *(() if over is None else (sizes[over],)))

    def _coordinate(self, name: str, dimensions: tuple[str, ...], values: Array, about: Mapping[str, str]) -> None:
        """Write a coordinate, or make it longer."""
        if name not in self._group:
            is_text = values.dtype == object
            self._group.create_array(
                name,
                shape=values.shape,
                chunks=(max(len(values), 1),),
                dtype=str if is_text else values.dtype,
                dimension_names=dimensions,
                attributes=dict(about),
            )
        elif self._group[name].shape != values.shape:
            self._group[name].resize(values.shape)
        self._group[name][:] = values

    def _consolidate(self) -> None:
        """Write what all arrays are into one place, where xarray looks for it."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # that other programs may not look there
            self._zarr.consolidate_metadata(self._group.store)


def _with_resume(problem: Problem) -> Problem:
    """Say besides how to go on."""
    more = _("what is in the store is whole: --resume goes on with it")
    return replace(problem, repair=f"{problem.repair}; {more}" if problem.repair else more)


def _about(path: Path, name: str) -> dict[str, Any]:
    """Read what a store is of."""
    try:
        found = json.loads((path / "zarr.json").read_text(encoding="utf-8"))
        return cast("dict[str, Any]", json.loads(found["attributes"][_ABOUT]))
    except (OSError, ValueError, KeyError, TypeError):
        raise refusal(name, _("is there already, and is no store of a sweep"), _("choose another name")) from None


def _entry(fields: Mapping[str, Any]) -> Entry:
    about: dict[str, Any] = {**fields, "dimensions": tuple(fields["dimensions"])}
    return Entry(**about)


def _are_texts(members: Sequence[object]) -> bool:
    return any(isinstance(member, str) for member in members)


def _there(folder: Path, numbers: NDArray[np.intp]) -> Iterator[int]:
    """Numbers of blocks whose chunk is there; their array stands as the chunks do."""
    *above, n_last = numbers.shape
    for places in product(*map(range, above)):
        with suppress(FileNotFoundError), os.scandir(folder.joinpath(*map(str, places))) as entries:
            for entry in entries:
                if entry.name.isdecimal() and int(entry.name) < n_last:
                    yield int(numbers[(*places, int(entry.name))])


def _swept_clean(path: Path) -> None:
    """Take away what a process that was killed had half written."""
    for half in path.rglob("*.partial"):
        half.unlink(missing_ok=True)
