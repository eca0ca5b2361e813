"""A run as netCDF: its dataset, with units, symbols, sentences, sources and equations."""

from collections.abc import Collection
from typing import Any

from cranktrain.saying.run import Run


def netcdf_bytes(run: Run, names: Collection[str]) -> bytes:
    """Write quantities of a run as netCDF, version 3, which needs xarray and SciPy alone.

    Parameters
    ----------
    run : Run
    names : collection of str
        Quantities to write.
    """
    chosen: Any = run.dataset[[*(name for name in run.catalogue if name in names), *run.marks]]
    texts = {name: value if isinstance(value, str) else "; ".join(value) for name, value in chosen.attrs.items()}
    return bytes(chosen.assign_attrs(texts).to_netcdf(engine="scipy"))
