"""A run as data frames: its curves over the axis, and its facts one below the other."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, cast

from cranktrain.analysis.curve_columns import by_default, curve_columns
from cranktrain.analysis.dataset import arrays_instead
from cranktrain.errors import InputError, Problem, refuse
from cranktrain.extras import imported
from cranktrain.io.tables import HEADS, fact_rows, headed
from cranktrain.language import said as _
from cranktrain.motion import Array
from cranktrain.quantities import nearest
from cranktrain.saying.run import Run
from cranktrain.saying.scales import in_asked_unit

if TYPE_CHECKING:
    import pandas


class _RunOfDesign:
    """A run of several designs as one of one of them."""

    def __init__(self, run: Run, design: int) -> None:
        self._run, self._design = run, design

    def __getattr__(self, name: str) -> Any:
        """Give what the run has, of its quantities those of the design."""
        found = getattr(self._run, name)
        return found[self._design] if name in self._run.catalogue else found


def curves_frame(
    run: Run, names: Sequence[str], *, design: int = 0, of_each_method: bool = False
) -> "pandas.DataFrame":
    """Give curves as a data frame; parameters as of `Result.curves`.

    Of designs of which none is on an axis a row for each, with all of its facts.
    """
    pandas = imported("pandas", "curves", arrays_instead())
    if run.axis is None and run.design_rows is not None:
        frame = pandas.DataFrame(headed(run, (), None))
        return frame.set_index("case") if "case" in frame else frame
    known = [name for name, entry in run.catalogue.items() if run.is_curve(entry)]
    refuse(_unknown(name, known) for name in names if name not in known)
    wanted = names or by_default(run)
    columns: dict[tuple[str, str], Array] = {}
    units: dict[str, str] = {}
    for column in curve_columns(_of(run, design), wanted, of_each_method=of_each_method):
        entry = column.entry
        whose = column.of if of_each_method else column.member
        units[entry.name], columns[entry.name, whose] = in_asked_unit(entry.unit, column.values, entry.shown)
    heads = pandas.MultiIndex.from_tuples(list(columns), names=["quantity", "of"])
    assert run.axis is not None  # of curves
    index = pandas.Index(run.axis.values, name=run.axis.name)
    frame = pandas.DataFrame(dict(enumerate(columns.values())), index=index).set_axis(heads, axis=1)
    frame.attrs["units"] = {run.axis.name: run.axis.unit, **units}
    return frame


def facts_frame(run: Run, *, design: int = 0) -> "pandas.DataFrame":
    """Give facts as a data frame; parameters as of `Result.facts_table`."""
    pandas = imported("pandas", "facts_table", arrays_instead())
    return pandas.DataFrame(list(fact_rows(_of(run, design), tuple(run.catalogue))), columns=list(HEADS))


def _of(run: Run, design: int) -> Run:
    """The run of one design."""
    if not 0 <= design < (run.n_designs or 1):
        allowed = _("must be from 0 to {last}", last=(run.n_designs or 1) - 1)
        raise InputError([Problem("design", str(design), allowed)])
    return cast(Run, _RunOfDesign(run, design)) if run.n_designs is not None else run


def _unknown(name: str, known: Sequence[str]) -> Problem:
    """Refuse a name that no curve has."""
    meant = nearest(name, known)
    repair = _('write "{text}"', text=meant) if meant else _("`result.catalogue` names all")
    return Problem("curves", name, _("is no curve of this result"), repair)
