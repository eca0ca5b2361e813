"""How a result is written: by the suffix of the file, and what was asked of its numbers."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

from cranktrain.analysis.curve_columns import CurveColumn, by_default, curve_columns
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.extras import lacking_for
from cranktrain.io.tables import csv_text, fact_csv, json_text
from cranktrain.io.workbook import workbook_bytes
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.record import record
from cranktrain.saying.run import Run

SUFFIXES = (".csv", ".json", ".xlsx", ".nc")


@record
class Form:
    """How a result is to be written.

    Attributes
    ----------
    suffix : str
        One of `SUFFIXES`.
    decimal : "point" or "comma"
        In a .csv. With a comma semicolons stand between columns, and a byte-order mark before all: as spreadsheets
        take it where a comma divides decimals.
    facts : bool
        Write into a .csv what holds for the whole cycle, instead of curves.
    """

    suffix: str
    decimal: str = "point"
    facts: bool = False

    def problems(self) -> Iterator[Problem]:
        """Find what the form of the file has no place for, or needs and lacks."""
        if self.suffix not in SUFFIXES:
            return
        yield from lacking_for(self.suffix)
        if self.suffix != ".csv" and self.decimal == "comma":
            said = _("is for a .csv; {suffix} has numbers, which each program shows as its user has them")
            yield Problem("--decimal", self.decimal, said.format(suffix=self.suffix))
        if self.suffix != ".csv" and self.facts:
            allowed = _("is for a .csv; {suffix} has facts and curves", suffix=self.suffix)
            yield Problem("--facts", None, allowed, _("leave --facts out"))


def written(
    form: Form, run: Run, machine: Mapping[str, object], names: Collection[str], *, is_all: bool
) -> Iterator[str | bytes]:
    """Write a result.

    Parameters
    ----------
    form : Form
    run : Run
        Of one design.
    machine : mapping
        The data of its file.
    names : collection of str
        Quantities to write.
    is_all : bool
        Whether these are all that there are, and not chosen: a table then has what is meant of what each method gives.

    Yields
    ------
    str or bytes

    Raises
    ------
    InputError
        If the file has no place for a quantity that was chosen, or needs a package that is not installed.
    """
    refuse(lacking_for(form.suffix))
    comma = form.decimal == "comma"
    if form.suffix == ".json":
        yield from json_text(run, machine, names)
    elif form.suffix == ".nc":
        from cranktrain.io.netcdf import netcdf_bytes  # only for who asks

        yield netcdf_bytes(run, names)
    elif form.suffix == ".csv" and (form.facts or (run.axis is None and run.design_rows is None)):
        refuse(_is_curve(name) for name in names if not is_all and not _is_fact(run, name))
        yield from fact_csv(run, names, comma=comma)
    else:
        curves = by_default(run) if is_all else names
        columns = list(curve_columns(run, curves, of_each_method=not is_all))
        if form.suffix == ".xlsx":
            yield from workbook_bytes(run, columns, names)
            return
        refuse(_is_one_value(name) for name in names if not is_all and _is_fact(run, name))
        yield from csv_text(run, columns, comma=comma)


def written_curves(form: Form, run: Run, columns: Sequence[CurveColumn], angles: Array) -> Iterator[str | bytes]:
    """Write some curves at some crank angles alone; the first parameters as of `written`.

    Parameters
    ----------
    columns : sequence of CurveColumn
    angles : Array, shape (n,)
        [deg]
    """
    refuse(lacking_for(form.suffix))
    if form.suffix in (".json", ".nc") or form.facts:
        allowed = _("has no place among curves at some angles")
        given = Problem("--facts", None, allowed) if form.facts else Problem("-o", form.suffix, allowed)
        raise InputError([replace(given, repair=_("write a .csv or an .xlsx"))])
    if form.suffix == ".xlsx":
        yield from workbook_bytes(run, columns, (), angles)
    else:
        yield from csv_text(run, columns, angles, comma=form.decimal == "comma")


def _is_fact(run: Run, name: str) -> bool:
    """Whether a quantity has no crank angle."""
    return not run.is_curve(run.catalogue[name])


def _is_curve(name: str) -> Problem:
    """Refuse a curve among facts."""
    return Problem("quantities", name, _("is a curve, and --facts writes facts"), _("leave --facts out"))


def _is_one_value(name: str) -> Problem:
    """Refuse a fact among curves."""
    allowed = _("has one value for the whole cycle, and a .csv holds curves")
    return Problem("quantities", name, allowed, _("write a .json or .xlsx, or with --facts a .csv of facts alone"))
