"""A result as an xarray dataset, with units, symbols, sentences, sources and equations as attributes."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from cranktrain.analysis.dimensions import dimension_named
from cranktrain.extras import imported
from cranktrain.language import Words, _
from cranktrain.motion import Array
from cranktrain.saying.catalogue import Entry
from cranktrain.saying.run import Run
from cranktrain.saying.scales import in_asked_unit

if TYPE_CHECKING:
    import xarray


def dataset_of(run: Run) -> "xarray.Dataset":
    """Give a run as a dataset.

    Parameters
    ----------
    run : Run

    Returns
    -------
    xarray.Dataset
        Of the quantities that were asked for, or of all; in SI and degrees unless a table [units], or `ct.units`, asks
        for other units. Members that are numbers are numbers there.

    Raises
    ------
    InputError
        If xarray is not installed.
    """
    imported("xarray", "dataset", arrays_instead())
    from cranktrain.analysis.guarded_dataset import Dataset  # which needs xarray

    design = ("design",) if run.n_designs is not None else ()
    wanted, catalogue = set(run.wanted), run.catalogue
    variables: dict[str, Any] = {
        name: ((*design, *entry.dimensions), *with_attributes(entry, getattr(run, name), catalogue))
        for name, entry in catalogue.items()
        if name in wanted
    }
    variables |= {name: (one.dimensions, one.texts, {"long_name": str(one.about)}) for name, one in run.marks.items()}
    used = {dimension for dimensions, *_rest in variables.values() for dimension in dimensions}
    coordinates: dict[str, Any] = {
        name: coordinate_of(name, words) for name, words in run.labels.items() if name in used
    }
    for name, unit, symbol, places in run.number_axes:
        coordinates[name] = (name, places, {"units": unit, "symbol": symbol})
    for name, unit, _symbol, values in run.case_coordinates:
        coordinates[name] = ("case", values, {"units": unit} if unit else {})
    return Dataset(variables, coordinates, dict(run.attributes()))


def arrays_instead() -> Words:
    """What does without datasets and data frames."""
    return _("take arrays by their names")


def with_attributes(entry: Entry, values: Array, catalogue: Mapping[str, Entry]) -> tuple[Array, dict[str, str]]:
    """Give values in the unit that was asked for, else in the catalogue's, and what that says of them."""
    unit, given = in_asked_unit(entry.unit, values, entry.shown)
    return given, attributes_of(entry, unit, catalogue)


def attributes_of(entry: Entry, unit: str, catalogue: Mapping[str, Entry]) -> dict[str, str]:
    """Say in which unit a quantity's values are, and what its entry says of it."""
    line = entry.in_symbols(catalogue)
    return {
        "units": unit,
        "symbol": entry.symbol,
        "long_name": entry.sentence,
        "source": entry.source,
        "equation": entry.equation,
        **({"line": line} if line else {}),
    }


def coordinate_of(dimension: str, labels: Sequence[str]) -> list[str] | list[int] | list[float]:
    """Give labels as numbers where they are numbers that count; a machine's mechanisms, often `1`, have names."""
    about = dimension_named(dimension)
    counts = about.title and not about.family and all(label.isdecimal() for label in labels)
    if not (about.is_number or counts):
        return list(labels)
    numbers = [float(label) for label in labels]
    return [int(number) for number in numbers] if all(map(float.is_integer, numbers)) else numbers
